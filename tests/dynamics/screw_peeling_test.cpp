// Screw peeling: transforms of many spellings become plane rotations and shifts, and stay the same
// transforms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/mechanism_file.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/to_string.hpp"

namespace alembert::test {
namespace {

std::string body_off_centre(const std::string& coordinates, const std::string& transform,
                            const std::string& parameters = "") {
  return "alembert: 1\nname: test\n" + parameters + "coordinates: [" + coordinates +
         "]\nbodies:\n  - name: a\n    transform:\n" + transform +
         "    mass: 1\n    com: [0.1, 0.2, 0.3]\n    inertia: {xx: 1, yy: 1.1, zz: 1.2}\n";
}

/// Moving motions as words: `z u` is a rotation, `shift x s` a translation.
std::vector<std::string> moving_motions(const MotionTree& tree) {
  std::vector<std::string> words;
  for (const MotionNode& node : tree.nodes) {
    if (node.partials.empty()) continue;
    const Motion& motion = node.motion;
    switch (motion.kind) {
      case MotionKind::translation: {
        std::string word = "shift";
        for (std::size_t i = 0; i < 3; ++i) {
          if (!motion.offset[i].is_zero())
            word += std::string(" ") + "xyz"[i] + " " + to_string(motion.offset[i]);
        }
        words.push_back(word);
        break;
      }
      case MotionKind::axis_rotation:
        words.push_back(std::string(1, "xyz"[motion.axis]) + " " + to_string(motion.angle));
        break;
      case MotionKind::rotation:
        words.push_back("matrix");
        break;
    }
  }
  return words;
}

struct Spelling {
  const char* name;
  const char* coordinates;
  const char* transform;
  std::vector<std::string> peeled;
  const char* parameters = "";
};
void PrintTo(const Spelling& spelling, std::ostream* out) {
  *out << spelling.name;
}

class Peeled : public testing::TestWithParam<Spelling> {};
TEST_P(Peeled, IsAProductOfPlaneRotationsAndShifts) {
  const Spelling& given = GetParam();
  const auto loaded =
      LoadedMechanism::text(body_off_centre(given.coordinates, given.transform, given.parameters));
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_TRUE(kinematics.peeled);
  EXPECT_EQ(moving_motions(*kinematics.peeled), given.peeled);
}
TEST_P(Peeled, IsTheSameTransform) {
  const Spelling& given = GetParam();
  const auto loaded =
      LoadedMechanism::text(body_off_centre(given.coordinates, given.transform, given.parameters));
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_TRUE(kinematics.peeled);
  const auto pose_entries = [&](const MotionTree& tree) {
    Pose pose = identity_pose(*loaded.graph);
    for (const MotionNode& node : tree.nodes) pose = moved(pose, node.motion);
    for (const Motion& motion : tree.places[0].tail) pose = moved(pose, motion);
    std::vector<Expr> entries(pose.rotation.entries.begin(), pose.rotation.entries.end());
    entries.insert(entries.end(), pose.origin.entries.begin(), pose.origin.entries.end());
    return entries;
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::vector<double> expected = loaded.values(pose_entries(kinematics.tree), seed);
    const std::vector<double> actual = loaded.values(pose_entries(*kinematics.peeled), seed);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-13) << "entry " << i;
  }
}

TEST(Peeling, LeavesFunctionsInPiecesAlone) {
  // Near the initial state, q = 0, the spline is a straight line.
  const auto loaded = LoadedMechanism::text(
      body_off_centre("q", "      - translate: [\"spline(q; [10, 10.5, 11]; [0, 0.1, 0.3])\", 0, 0]\n"));
  EXPECT_FALSE(loaded.kinematics().peeled);
}

INSTANTIATE_TEST_SUITE_P(
    Spellings, Peeled,
    testing::Values(
        Spelling{"torus",
                 "u, v",
                 "      - surface: {point: [(2 + cos(v)/2)*cos(u), (2 + cos(v)/2)*sin(u), sin(v)/2], along: "
                 "[u, v]}\n",
                 {"z u", "y -v"}},
        Spelling{"tori_mated",
                 "u1, v1, u2, v2",
                 "      - mate:\n"
                 "          - surface: {point: [(2 + cos(v1)/2)*cos(u1), (2 + cos(v1)/2)*sin(u1), "
                 "sin(v1)/2], along: [u1, v1]}\n"
                 "          - surface: {point: [(3 + cos(v2)/3)*cos(u2), (3 + cos(v2)/3)*sin(u2), "
                 "sin(v2)/3], along: [u2, v2], flip: true}\n",
                 {"z u1", "y -v1", "y v2", "z u2"}},
        Spelling{"sphere",
                 "u, {name: v, limits: [-1.5, 1.5]}",
                 "      - surface: {point: [2*cos(u)*cos(v), 2*sin(u)*cos(v), 2*sin(v)], along: [u, v]}\n",
                 {"z u", "y -v"}},
        Spelling{"cylinder",
                 "u, v",
                 "      - surface: {point: [2*cos(u), 2*sin(u), v], along: [u, v]}\n",
                 {"z u", "shift x 2 z v"}},
        Spelling{"cone",
                 "u, {name: v, limits: [-3, 3]}",
                 "      - surface: {point: [(2 + 3/5*v)*cos(u), (2 + 3/5*v)*sin(u), 4/5*v], along: [u, v]}\n",
                 {"z u", "shift x 2 + 3/5*v z 4/5*v"}},
        Spelling{"helix",
                 "s",
                 "      - curve: {point: [3*cos(s), 3*sin(s), 4*s], along: s, frame: frenet}\n",
                 {"shift z 4*s", "z s"}},
        Spelling{
            "screw_as_a_matrix",
            "s",
            "      - matrix: [[1, 0, 0, s/10], [0, cos(2*s), -sin(2*s), 1], [0, sin(2*s), cos(2*s), 0]]\n"
            "      - translate: [0, 1, 0]\n",
            {"shift x 1/10*s y 1", "x 2*s"}},
        Spelling{"matrix_of_a_sum",
                 "q1, q2",
                 "      - matrix: [[cos(q1 + q2), -sin(q1 + q2), 0, 0], [sin(q1 + q2), cos(q1 + q2), 0, 0], "
                 "[0, 0, 1, 0]]\n",
                 {"z q2 + q1"}},
        Spelling{"circle_and_turn",
                 "q",
                 "      - translate: [2*cos(q), 2*sin(q), 0]\n      - rotate: {axis: z, angle: q}\n",
                 {"z q"}},
        Spelling{"axis_aslant", "q", "      - rotate: {axis: [1, 2, -2], angle: q}\n", {"z q"}},
        Spelling{"inverse",
                 "u, {name: v, limits: [-1.5, 1.5]}",
                 "      - inverse:\n          - surface: {point: [2*cos(u)*cos(v), 2*sin(u)*cos(v), "
                 "2*sin(v)], along: [u, v]}\n",
                 {"x v", "y -u"}},
        Spelling{"around_a_core",
                 "u, v, w, s",
                 "      - rotate: {axis: [3, 0, 4], angle: w}\n"
                 "      - surface: {point: [2*cos(u)*cos(v), sin(u)*cos(v), 3*sin(v)], along: [u, v]}\n"
                 "      - matrix: [[1, 0, 0, 0], [0, cos(s), -sin(s), 1], [0, sin(s), cos(s), 0]]\n",
                 {"z w", "shift x 2*cos(v)*cos(u) y cos(v)*sin(u) z 3*sin(v)", "matrix", "x s"}}),
    [](const auto& spelling) { return std::string(spelling.param.name); });

/// A torus that touches another one.
LoadedMechanism mated_tori() {
  return LoadedMechanism::text(
      body_off_centre("u1, v1, u2, v2",
                      "      - mate:\n"
                      "          - surface: {point: [(2 + cos(v1)/2)*cos(u1), (2 + "
                      "cos(v1)/2)*sin(u1), sin(v1)/2], along: [u1, v1]}\n"
                      "          - surface: {point: [(3 + cos(v2)/3)*cos(u2), (3 + "
                      "cos(v2)/3)*sin(u2), sin(v2)/3], along: [u2, v2], flip: true}\n"));
}

TEST(ScrewPeeling, ConstantsOfAMateAreExact) {
  const LoadedMechanism loaded = mated_tori();
  const Kinematics kinematics = loaded.kinematics();
  ASSERT_TRUE(kinematics.peeled);
  std::vector<std::string> shifts;
  for (const MotionNode& node : kinematics.peeled->nodes) {
    ASSERT_TRUE(!node.partials.empty() || node.motion.kind == MotionKind::translation) << "a constant turn";
    if (node.motion.kind != MotionKind::translation) continue;
    for (const Expr& e : node.motion.offset.entries) {
      if (!e.is_zero()) shifts.push_back(to_string(e));
    }
  }
  EXPECT_EQ(shifts, (std::vector<std::string>{"2", "5/6", "3"}));
}

// What is flat to rounding over a wide range is no constant.
TEST(ScrewPeeling, StepsAndBumpsFarFromTheInitialStateAreKept) {
  struct Late {
    const char *transform, *coordinate;
    double where;
  };
  for (const Late& late :
       {Late{"[{rotate: {axis: z, angle: q}}, {translate: [0, 0, \"1 + tanh(20*(q - 4.5))\"]}]", "q", 4.5},
        {"[{translate: [cos(q), sin(q), \"exp(-1e6*(q - 2)^2)\"]}, {rotate: {axis: z, angle: q}}]", "q",
         2.0003},
        {"[{translate: [q, 0, 0]}, {rotate: {axis: y, angle: \"q + 0.3*exp(-10*(t - 5)^2)\"}}]", "t", 5.1}}) {
    const auto loaded = LoadedMechanism::text(
        std::string("alembert: 1\nname: late\ngravity: [0.3, 0, -9.81]\ncoordinates: [q]\n") +
        "bodies:\n  - {name: a, transform: " + late.transform + ", mass: 1, com: [0.1, 0.2, 0.3]}\n");
    const Kinematics kinematics = loaded.kinematics();
    const auto expected = equations_of_motion(kinematics, Formulation::factored);
    const auto actual = equations_of_motion(kinematics, Formulation::reduced);
    std::vector<double> state = state_values(*loaded.mechanism, *loaded.graph, 1);
    state[loaded.graph->symbol_index(loaded.graph->symbol(late.coordinate).ref().node())] = late.where;
    EXPECT_NEAR(evaluate(actual.Q, state)[0], evaluate(expected.Q, state)[0],
                1e-10 * std::abs(evaluate(expected.Q, state)[0]))
        << late.transform;
  }
}

// Beyond a pole the frame of a sphere is turned over, and that of a torus where its tube is thicker than its
// ring.
TEST(ScrewPeeling, WhatHoldsOnOneSideOfAPoleOnlyIsNotPeeled) {
  for (const char* point : {"[2*cos(u)*cos(v), 2*sin(u)*cos(v), 2*sin(v)]",
                            "[(R + r*cos(v))*cos(u), (R + r*cos(v))*sin(u), r*sin(v)]"}) {
    const auto loaded = LoadedMechanism::text(body_off_centre(
        "u, v", std::string("      - surface: {point: ") + point + ", along: [u, v]}\n",
        std::string(point).find("R") == std::string::npos
            ? ""
            : "parameters: {R: {value: 2, runtime: true}, r: {value: 0.5, runtime: true}}\n"));
    const Kinematics kinematics = loaded.kinematics();
    if (!kinematics.peeled) continue;
    for (const std::string& word : moving_motions(*kinematics.peeled)) EXPECT_NE(word, "y -v");
  }
}

TEST(ScrewPeeling, AnEllipsoidStaysAsItIs) {
  const auto loaded = LoadedMechanism::text(body_off_centre(
      "u, v", "      - surface: {point: [2*cos(u)*cos(v), sin(u)*cos(v), 3*sin(v)], along: [u, v]}\n"));
  EXPECT_FALSE(loaded.kinematics().peeled);
}

TEST(ScrewPeeling, APlaneIsAShiftAlready) {
  const auto loaded = LoadedMechanism::text(
      body_off_centre("u, v", "      - surface: {point: [u, 3/5*v, 4/5*v], along: [u, v]}\n"));
  const Kinematics kinematics = loaded.kinematics();
  EXPECT_FALSE(kinematics.peeled);
  EXPECT_EQ(moving_motions(kinematics.tree), (std::vector<std::string>{"shift x u y 3/5*v z 4/5*v"}));
}

TEST(ScrewPeeling, JointsStayAsTheyAre) {
  const auto loaded = LoadedMechanism::text(body_off_centre(
      "a, b, c, {name: base, type: quaternion}",
      "      - joint: {type: planar, coordinates: [a, b, c]}\n      - rotate: {quaternion: base}\n"));
  EXPECT_FALSE(loaded.kinematics().peeled);
}

// The axis of b, seen from the left of it, depends on p: there may be values of p at which it has no angles.
TEST(ScrewPeeling, AnAxisThatARuntimeParameterTurnsIsLeftAlone) {
  const auto loaded = LoadedMechanism::text(
      body_off_centre("a, b",
                      "      - rotate: {axis: x, angle: a}\n      - rotate: {axis: x, angle: p}\n"
                      "      - rotate: {axis: [1, 0.3, 0], angle: b}\n",
                      "parameters: {p: {value: 0.7, runtime: true}}\n"));
  EXPECT_NO_THROW(loaded.kinematics());
}

/// Motions that are small beside others: none is taken for rounding, on its own or beside a larger one of
/// another unit.
struct SmallMotion {
  const char* name;
  const char* coordinates;
  const char* body;
};
void PrintTo(const SmallMotion& small, std::ostream* out) {
  *out << small.name;
}

class SmallMotions : public testing::TestWithParam<SmallMotion> {};
TEST_P(SmallMotions, AreKept) {
  const auto loaded =
      LoadedMechanism::text(std::string("alembert: 1\nname: small\ngravity: [0.3, 0, -9.81]\n") +
                            "coordinates: [" + GetParam().coordinates + "]\nbodies:\n" + GetParam().body);
  const Kinematics kinematics = loaded.kinematics();
  const auto expected = equations_of_motion(kinematics, Formulation::factored);
  const auto actual = equations_of_motion(kinematics, Formulation::reduced);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::vector<double> x = loaded.values(actual.Q, seed), y = loaded.values(expected.Q, seed);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(x[i], y[i], 1e-9 * std::abs(y[i])) << "force " << i << ", state " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(
    ScrewPeeling, SmallMotions,
    testing::Values(SmallMotion{"tilt_far_away", "x, a",
                                "  - name: arm\n    transform:\n      - translate: [30000, x, 0]\n"
                                "      - rotate: {axis: z, angle: a}\n"
                                "      - rotate: {axis: [1, -1, 0], angle: 1e-7}\n"
                                "      - rotate: {axis: z, angle: a}\n"
                                "    mass: 1\n    com: [0, 0, 1]\n"},
                    SmallMotion{
                        "tilt_between_axes", "x, a",
                        "  - name: arm\n    transform:\n      - translate: [500000, x, 0]\n"
                        "      - rotate: {axis: z, angle: a}\n      - rotate: {axis: x, angle: 1.2e-7}\n"
                        "      - rotate: {axis: z, angle: 0.3}\n      - rotate: {axis: y, angle: a}\n"
                        "    mass: 1\n    com: [0, 1, 0]\n    inertia: {xx: 1, yy: 1, zz: 1}\n"},
                    SmallMotion{"wobble_of_a_small_rotor", "a",
                                "  - name: rotor\n    transform:\n      - rotate: {axis: z, angle: a}\n"
                                "      - translate: [0, 0, \"1e-12*sin(3*a)\"]\n"
                                "    mass: 1e-9\n    com: [1e-9, 0, 0]\n"},
                    SmallMotion{"wobble_of_a_small_bead", "a",
                                "  - name: bead\n    transform:\n"
                                "      - rotate: {axis: z, angle: a}\n"
                                "      - translate: [1e-9, 0, \"1e-12*sin(3*a)\"]\n"
                                "    mass: 1e-9\n"}),
    [](const auto& small) { return std::string(small.param.name); });

/// The same in other units has the same screws.
TEST(ScrewPeeling, SmallToriArePeeledAsLargeOnesAre) {
  for (const char* L : {"1e-9", "1e-4", "1", "1e6"}) {
    const auto loaded = LoadedMechanism::text(std::string("alembert: 1\nname: test\nparameters: {L: ") + L +
                                              "}\ncoordinates: [u, v]\nbodies:\n  - name: a\n    transform:\n"
                                              "      - surface: {point: [L*(2 + cos(v)/2)*cos(u), L*(2 + "
                                              "cos(v)/2)*sin(u), L*sin(v)/2], along: [u, v]}\n"
                                              "    mass: 1\n    com: [0.1*L, 0.2*L, 0.3*L]\n");
    const Kinematics kinematics = loaded.kinematics();
    ASSERT_TRUE(kinematics.peeled) << L;
    EXPECT_EQ(moving_motions(*kinematics.peeled), (std::vector<std::string>{"z u", "y -v"})) << L;
  }
}

/// What a peeled mechanism is for: an all-revolute chain.
TEST(ScrewPeeling, NeedsFewerOperations) {
  const LoadedMechanism loaded = mated_tori();
  Kinematics kinematics = loaded.kinematics();
  const std::size_t with = count_operations(equations_of_motion(kinematics, Formulation::reduced).Q).total();
  kinematics.peeled.reset();
  const std::size_t without =
      count_operations(equations_of_motion(kinematics, Formulation::reduced).Q).total();
  EXPECT_LT(with, without);
  RecordProperty("with", static_cast<int>(with));
  RecordProperty("without", static_cast<int>(without));
}

}  // namespace
}  // namespace alembert::test

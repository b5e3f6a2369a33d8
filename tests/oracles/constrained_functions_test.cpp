// Forward dynamics under constraints and its derivatives against the Taylor oracle, where the catalogue has none: a
// stance on four legs, and loops with rows that depend on each other.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "oracles/reference.hpp"

namespace alembert::oracles {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> kMotion{"constrained_forward_dynamics"};
const std::set<std::string> kMotionAndDerivatives{"constrained_forward_dynamics",
                                                  "constrained_forward_dynamics_derivatives"};

/// A description in a file that goes with it.
class ConstrainedMechanism {
 public:
  explicit ConstrainedMechanism(const std::string& text)
      : path_((fs::temp_directory_path() / ("alembert_constrained_" + std::to_string(getpid()) + ".yaml"))
                  .string()) {
    std::ofstream(path_) << "alembert: 1\nname: constrained\n" << text;
    description = read_description(path_);
  }
  ~ConstrainedMechanism() { fs::remove(path_); }
  ConstrainedMechanism(const ConstrainedMechanism&) = delete;
  ConstrainedMechanism& operator=(const ConstrainedMechanism&) = delete;

  void expect_right(const std::vector<State>& states,
                    const std::set<std::string>& functions = kMotionAndDerivatives) const {
    for (const Comparison& line :
         compare_functions(ALEMBERT_EXECUTABLE, path_, description, states, functions))
      EXPECT_FALSE(line.verdict == Comparison::Verdict::fail)
          << line.function << ": off by " << line.error << ", allowed are " << line.tolerance << " "
          << line.note;
  }
  Eigen::MatrixXd reactions(const State& state) const {
    const Eigen::VectorXd tau = Eigen::VectorXd::Zero(description.nv);
    return ask_functions(ALEMBERT_EXECUTABLE, path_, {state}, {tau}, {"constrained_forward_dynamics"})
        .front()
        .at("constrained_forward_dynamics")
        .at("lambda");
  }

  Description description;

 private:
  std::string path_;
};

/// A trunk on four legs of which the feet stay where they are: with hips and knees, and hips that swing sideways too.
std::string stance(bool sideways) {
  std::string coordinates =
      "coordinates:\n  - x\n  - y\n  - {name: z, initial: 0.5}\n  - {name: attitude, type: quaternion}\n";
  std::string bodies = R"(bodies:
  - name: trunk
    transform: [{joint: {type: free, coordinates: [x, y, z, attitude]}}]
    mass: 12
    com: [0.02, 0, 0.01]
    inertia: {xx: 0.2, yy: 0.5, zz: 0.6, xz: 0.03}
)";
  std::string frames = "frames:\n", constraints = "constraints:\n";
  for (int leg = 0; leg < 4; ++leg) {
    const std::string n = std::to_string(leg), x = leg < 2 ? "0.3" : "-0.3",
                      y = leg % 2 == 0 ? "0.15" : "-0.15";
    const std::string swing = sideways ? "{rotate: {axis: x, angle: side" + n + "}}, " : "";
    if (sideways) coordinates += "  - {name: side" + n + ", limits: [-0.4, 0.4]}\n";
    coordinates += "  - {name: hip" + n + ", initial: 0.6, limits: [0.3, 0.9]}\n  - {name: knee" + n +
                   ", initial: -1.2, limits: [-1.5, -0.8]}\n";
    bodies +=
        "  - name: thigh" + n + "\n    parent: trunk\n    transform: [{translate: [" + x + ", " + y +
        ", 0]}, " + swing + "{joint: {type: revolute, axis: y, coordinates: [hip" + n + "]}}]" + R"(
    mass: 1.1
    com: [0, 0.01, -0.12]
    inertia: {xx: 0.01, yy: 0.012, zz: 0.002}
  - name: shank)" +
        n + "\n    parent: thigh" + n +
        "\n    transform: [{translate: [0, 0, -0.3]}, {joint: {type: revolute, axis: y, coordinates: [knee" +
        n + "]}}]" + R"(
    mass: 0.4
    com: [0, 0, -0.1]
    inertia: {xx: 0.004, yy: 0.004, zz: 0.0005}
)";
    frames += "  - {name: foot" + n + ", body: shank" + n + ", transform: [{translate: [0, 0, -0.3]}]}\n";
    constraints += "  - {name: stand" + n + ", type: holonomic, equations: [position(foot" + n + ").x - " +
                   x + ", position(foot" + n + ").y - " + y + ", position(foot" + n + ").z]}\n";
  }
  return coordinates + bodies + frames + constraints;
}

TEST(ConstrainedFunctions, AStanceOnFourLegs) {
  const ConstrainedMechanism legs(stance(true));
  legs.expect_right(comparable_states(legs.description, 2, 5));
}

// Each leg without a sideways hip holds the trunk along the trunk's y axis only. Standing upright, two feet at a time are
// on one such line.
TEST(ConstrainedFunctions, AStanceOnFourLegsThatCannotSwingSideways) {
  const ConstrainedMechanism legs(stance(false));
  std::mt19937_64 random(4);
  State state = random_state(legs.description, random);
  state.q = {0, 0, 0.6 * std::cos(0.6), 0, 0, 0, 1, 0.6, -1.2, 0.6, -1.2, 0.6, -1.2, 0.6, -1.2};
  state.speeds.assign(state.speeds.size(), 0);
  legs.expect_right({state}, kMotion);
  const Eigen::MatrixXd lambda = legs.reactions(state);
  EXPECT_EQ((lambda.array() == 0).count(), 2) << lambda.transpose();
  EXPECT_EQ(lambda(4), 0);
  EXPECT_EQ(lambda(10), 0);
}

// A four-bar in a plane, closed in space: the third row is empty. The last one is the first once more.
constexpr const char* kFourBar = R"yaml(
coordinates: [{name: a, initial: 0.4}, {name: b, initial: -0.9}, {name: c, initial: 0.7}]
bodies:
  - name: crank
    transform: [{joint: {type: revolute, axis: z, coordinates: [a]}}]
    mass: 1
    com: [0.1, 0.02, 0]
    inertia: {xx: 0.01, yy: 0.01, zz: 0.02}
  - name: coupler
    parent: crank
    transform: [{translate: [0.3, 0, 0]}, {joint: {type: revolute, axis: z, coordinates: [b]}}]
    mass: 0.7
    com: [0.2, 0, 0.05]
    inertia: {xx: 0.01, yy: 0.02, zz: 0.02}
  - name: rocker
    transform: [{translate: [0.5, 0, 0]}, {joint: {type: revolute, axis: z, coordinates: [c]}}]
    mass: 0.8
    com: [0.15, 0, 0]
    inertia: {xx: 0.01, yy: 0.02, zz: 0.02}
frames:
  - {name: tip, body: coupler, transform: [{translate: [0.4, 0, 0]}]}
  - {name: end, body: rocker, transform: [{translate: [0.35, 0, 0]}]}
constraints:
  - name: closed
    type: holonomic
    equations:
      - position(tip).x - position(end).x
      - position(tip).y - position(end).y
      - position(tip).z - position(end).z + 0*a
  - {name: again, type: holonomic, equations: [3*position(tip).x - 3*position(end).x]}
gravity: [0, -9.81, 0]
)yaml";

TEST(ConstrainedFunctions, RowsThatFollowFromThoseBeforeThemHaveNoReaction) {
  const ConstrainedMechanism linkage(kFourBar);
  std::mt19937_64 random(3);
  std::vector<State> states;
  for (int i = 0; i < 3; ++i) states.push_back(random_state(linkage.description, random));
  linkage.expect_right(states);
  const Eigen::MatrixXd lambda = linkage.reactions(states[0]);
  EXPECT_NE(lambda(0), 0);
  EXPECT_NE(lambda(1), 0);
  EXPECT_EQ(lambda.bottomRows(lambda.rows() - 2).cwiseAbs().maxCoeff(), 0) << lambda.transpose();
}

// A robot of a tenth of a micrometre: a row on its angle is 1e14 times as long, in the metric of M^-1, as one on a square
// of a distance. Both bind.
TEST(ConstrainedFunctions, RowsOfUnitsFarApart) {
  const ConstrainedMechanism robot(R"yaml(
gravity: [0, 0, -9.81]
coordinates:
  - {name: x, limits: [-5e-8, 5e-8]}
  - {name: y, limits: [-5e-8, 5e-8]}
  - {name: turn, limits: [-3, 3]}
  - {name: tilt, limits: [-3, 3]}
  - {name: reach, limits: [-5e-8, 5e-8]}
bodies:
  - name: base
    transform: [{joint: {type: planar, coordinates: [x, y, turn]}}]
    mass: 1.9e-6
    com: [-3.8e-9, -2.8e-8, -2.7e-8]
    inertia: {xx: 2.3e-21, yy: 2.8e-21, zz: 1.6e-21, xy: -3.6e-23, xz: -4.9e-22, yz: 3.8e-23}
  - name: arm
    parent: base
    transform:
      - {joint: {type: revolute, axis: y, coordinates: [tilt]}}
      - {translate: [0, 2.1e-9, -5.9e-8]}
      - {joint: {type: prismatic, axis: y, coordinates: [reach]}}
    mass: 5.3e-7
    com: [2.2e-8, 3.0e-9, 1.7e-9]
frames:
  - {name: hand, body: arm, transform: [{translate: [0, 7.8e-9, 2.2e-8]}]}
  - {name: eye, body: base, transform: [{translate: [1.1e-8, 0, -6.8e-8]}]}
constraints:
  - {name: geared, type: pfaffian, rows: ["1.85*d(tilt) - cos(turn)*d(turn)"]}
  - name: rod
    type: holonomic
    equations: ["(position(hand).x - position(eye).x)^2 + (position(hand).y - position(eye).y)^2 + (position(hand).z - position(eye).z)^2 - 2.8e-15"]
)yaml");
  std::mt19937_64 random(6);
  std::vector<State> states;
  for (int i = 0; i < 5; ++i) states.push_back(random_state(robot.description, random));
  robot.expect_right(states);
  for (const State& state : states) EXPECT_NE(robot.reactions(state)(1), 0);
}

}  // namespace
}  // namespace alembert::oracles

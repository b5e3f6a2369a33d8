// What pages show of forces: equal to what the functions of the mechanism give, at states off the initial one.
#include "simulation/force_readings.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "mechanism/load.hpp"
#include "simulation/motion_recorder.hpp"

namespace alembert::test {
namespace {

/// A compiled description, its readings and its evaluator.
struct Read {
  explicit Read(const std::string& text, const std::vector<InputExpression>& inputs = {})
      : compiled(compile(text, inputs)), evaluator(compiled), readings(compiled) {}

  static CompiledMechanism compile(const std::string& text, const std::vector<InputExpression>& inputs) {
    CompileOptions options;
    options.inputs = inputs;
    options.functions = {FunctionKind("applied_forces"), FunctionKind("outputs"), FunctionKind("frame_poses"),
                         FunctionKind("body_poses"), FunctionKind("energy")};
    options.inapplicable = Inapplicable::leave_out;
    return compile_mechanism(std::make_shared<const SourceText>(SourceText{"test.yaml", text}), options);
  }
  Acting at(const EvaluationState& state) {
    Acting acting = readings.nothing_yet();
    readings.append(state, acting);
    return acting;
  }

  CompiledMechanism compiled;
  DynamicsEvaluator evaluator;
  ForceReadings readings;
};

std::vector<EvaluationState> states_of(const Read& read) {
  std::vector<EvaluationState> states;
  for (int i = 0; i < 6; ++i) {
    EvaluationState state = read.evaluator.initial_state();
    state.t = 0.3 * i;
    for (std::size_t k = 0; k < state.q.size(); ++k)
      state.q[k] += 0.4 * std::sin(1.0 + 3.0 * i + 7.0 * static_cast<double>(k));
    for (std::size_t k = 0; k < state.qd.size(); ++k)
      state.qd[k] = std::cos(2.0 * i + 5.0 * static_cast<double>(k));
    for (double& parameter : state.parameters) parameter *= 1 + 0.1 * i;
    states.push_back(std::move(state));
  }
  return states;
}

std::vector<std::string> names_and_units(const std::vector<Series>& all) {
  std::vector<std::string> out;
  for (const Series& series : all)
    out.push_back(series.name + (series.unit.empty() ? "" : ", " + series.unit));
  return out;
}

/// Paths over points of two bodies and of the world; the world's comes last.
const char* const kRopes = R"(alembert: 1
name: ropes
parameters: {k: {value: 40, runtime: true}}
inputs: [{name: winch, initial: 2, limits: [0, 5]}, drive]
coordinates: [{name: swing, initial: 0.5, damping: 0.1}, {name: slide, initial: 0.2}]
bodies:
  - {name: arm, transform: [{rotate: {axis: y, angle: swing}}, {translate: [0, 0, -0.6]}], mass: 1, inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}
  - {name: cart, transform: [{translate: [slide, 0.3, 0]}], mass: 2}
frames:
  - {name: tip, body: arm, transform: [{translate: [0.1, 0, -0.2]}]}
  - {name: runner, body: arm, transform: [{translate: [0, slide/2, 0.1]}]}
  - {name: hook, body: cart, transform: [{translate: [0, 0, 0.25]}]}
  - {name: wall, body: world, transform: [{translate: [-1, 0, 0.5]}]}
forces:
  - {name: rope, path: [tip, hook, wall], tension: "k*(length - 1.2) + 3*rate + winch"}
  - {name: rubber, between: [runner, hook], tension: "-5*length"}
  - {name: motor, on: slide, value: drive}
  - {name: spring, potential: "1/2*k*swing^2"}
  - {name: wind, at: tip, axes: world, force: [1, "-0.3*velocity(tip).y", 0], torque: [0, 0, 0.1*t]}
outputs:
  - {name: pull, value: "k*(length(rope) - 1.2) + 3*rate(rope) + winch"}
  - {name: slack, value: 'max(1.5 - length(rope), 0)'
}
  - {name: stretch, value: "length(rubber)^2"}
  - {name: turn, value: "d(swing) - 1"}
)";

TEST(ForceReadings, OfPathsAreTensionsAndPlacesOfFrames) {
  Read read(kRopes);
  for (const EvaluationState& state : states_of(read)) {
    const Acting acting = read.at(state);
    const std::vector<double> outputs = read.evaluator(FunctionKind("outputs"), state);
    const std::vector<double> poses = read.evaluator(FunctionKind("frame_poses"), state);
    ASSERT_EQ(acting.lines.size(), 2u);
    EXPECT_EQ(acting.forces.at(acting.lines[0].force).name, "rope");
    EXPECT_EQ(acting.forces.at(acting.lines[1].force).name, "rubber");
    EXPECT_NEAR(acting.forces[acting.lines[0].force].values.at(0), outputs[0],
                1e-12 * (1 + std::abs(outputs[0])));
    EXPECT_NEAR(acting.forces[acting.lines[1].force].values.at(0), -5 * std::sqrt(outputs[2]), 1e-12);
    const std::vector<std::vector<std::size_t>> frames = {{0, 2, 3}, {1, 2}};
    for (std::size_t l = 0; l < 2; ++l) {
      ASSERT_EQ(acting.lines[l].points.size(), frames[l].size());
      for (std::size_t i = 0; i < frames[l].size(); ++i)
        for (std::size_t a = 0; a < 3; ++a)
          EXPECT_NEAR(acting.lines[l].points[i].at(0)[static_cast<Eigen::Index>(a)],
                      poses[12 * frames[l][i] + 4 * a + 3], 1e-14);
    }
    for (std::size_t i = 0; i < outputs.size(); ++i)
      EXPECT_NEAR(acting.outputs.at(i).values.at(0), outputs[i], 1e-12 * (1 + std::abs(outputs[i])));
    EXPECT_DOUBLE_EQ(acting.inputs.at(0).values.at(0), state.parameters[1]);
  }
}

TEST(ForceReadings, HaveNamesUnitsAndLimits) {
  Read read(kRopes);
  const Acting acting = read.readings.nothing_yet();
  EXPECT_THAT(names_and_units(acting.forces),
              testing::ElementsAre("damping of swing, N m", "rope, N", "rubber, N", "motor, N", "spring, J",
                                   "wind.x, N", "wind.y, N", "wind torque, N m"));
  EXPECT_THAT(names_and_units(acting.inputs), testing::ElementsAre("winch", "drive, N"));
  EXPECT_THAT(names_and_units(acting.outputs),
              testing::ElementsAre("pull", "slack, m", "stretch", "turn, rad/s"));
  EXPECT_EQ(acting.inputs[0].limits, std::pair(0.0, 5.0));
}

TEST(ForceReadings, AddUpToTheAppliedForces) {
  // A ball that slides on a plane and beside a sphere, each force along coordinates of its own.
  Read read(R"(alembert: 1
name: ball
gravity: [0, 0, -9.81]
coordinates: [{name: x, initial: 0.05}, {name: y, initial: -0.1}, {name: z, initial: 0.25}]
bodies: [{name: ball, transform: [{translate: [x, y, z]}], mass: 1}]
frames: [{name: center, body: ball}, {name: post, body: world, transform: [{translate: [0.3, 0.2, 0.1]}]}]
forces:
  - {name: floor, contact: {frame: center, radius: 0.5, plane: {point: [0, 0, -0.1], normal: [0, 3, 4]}, stiffness: 900, dissipation: 0.3}}
  - {name: knock, contact: {frame: center, radius: 0.5, sphere: {frame: post, radius: 0.2}, stiffness: 700, dissipation: 0.1}}
)");
  int touching = 0, apart = 0;
  for (const EvaluationState& state : states_of(read)) {
    const Acting acting = read.at(state);
    const Eigen::Map<const Eigen::Vector3d> center(state.q.data());
    const Eigen::Vector3d n(0, 0.6, 0.8), away = center - Eigen::Vector3d(0.3, 0.2, 0.1);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    ASSERT_EQ(acting.contacts.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Eigen::Vector3d normal = i == 0 ? n : away.normalized();
      const SceneContact& contact = acting.contacts[i];
      const double force = acting.forces.at(contact.force).values.at(0);
      EXPECT_LT((contact.points.at(0) - (center - 0.5 * normal)).norm(), 1e-14);
      const double depth = i == 0 ? 0.5 - n.dot(center + Eigen::Vector3d(0, 0, 0.1)) : 0.7 - away.norm();
      EXPECT_EQ(force > 0, depth > 0);
      ++(force > 0 ? touching : apart);
      sum += force * normal;
    }
    const std::vector<double> Q = read.evaluator(FunctionKind("applied_forces"), state);
    for (Eigen::Index k = 0; k < 3; ++k)
      EXPECT_NEAR(Q[static_cast<std::size_t>(k)], sum[k], 1e-11 * (1 + sum.norm()));
  }
  EXPECT_GT(touching, 2);
  EXPECT_GT(apart, 2);
}

TEST(ForceReadings, OfAnInputAreItsLaw) {
  const auto law =
      std::make_shared<const SourceText>(SourceText{"--input", "drive=3*slide + sin(t) - d(swing)"});
  Read read(kRopes, {{"drive", law}});
  for (const EvaluationState& state : states_of(read)) {
    const Acting acting = read.at(state);
    const double value = 3 * state.q[1] + std::sin(state.t) - state.qd[0];
    EXPECT_NEAR(acting.inputs.at(1).values.at(0), value, 1e-14);
    EXPECT_NEAR(acting.forces.at(3).values.at(0), value, 1e-14);
  }
}

TEST(ForceReadings, GoWithTheFramesOfAMotion) {
  Read read(kRopes);
  MotionRecorder recorder(read.compiled);
  TrajectoryPoint point;
  for (int k = 0; k < 3; ++k) {
    point.state = states_of(read)[static_cast<std::size_t>(k)];
    recorder.record(point);
    recorder.record(point);  // no later: left out
  }
  const BakedMotion& motion = recorder.motion();
  ASSERT_EQ(motion.times.size(), 3u);
  for (const Series& series : motion.acting.forces) EXPECT_EQ(series.values.size(), 3u);
  EXPECT_EQ(motion.acting.lines.at(0).points.at(2).size(), 3u);
  EXPECT_EQ(motion.acting.forces.at(1).values[2], read.at(point.state).forces.at(1).values[0]);
}

TEST(ForceReadings, OfNothingAreNone) {
  Read read(R"(alembert: 1
name: free
coordinates: [x]
bodies: [{name: b, transform: [{translate: [x, 0, 0]}], mass: 1}]
)");
  const Acting acting = read.at(read.evaluator.initial_state());
  EXPECT_TRUE(acting.forces.empty() && acting.inputs.empty() && acting.outputs.empty());
}

}  // namespace
}  // namespace alembert::test

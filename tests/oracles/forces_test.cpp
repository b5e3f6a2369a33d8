// Forces of a description against formulas of textbooks, on small mechanisms.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "oracles/taylor/numeric_functions.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {
namespace {

constexpr double kExact = 1e-12;

Eigen::VectorXd forces_at(const Description& description, const State& state) {
  return numeric_functions(description, state, {"applied_forces"}).at("applied_forces").at("Q");
}

TEST(AppliedForces, NoneWhereNothingIsSaid) {
  const Description d = parse_description(
      "{name: n, coordinates: [x], bodies: [{name: b, transform: [{translate: [x, 0, 0]}], mass: 1}]}");
  const State state{{0.3}, {1}, {2}, 0};
  EXPECT_FALSE(d.has_forces());
  EXPECT_EQ(forces_at(d, state)[0], 0);
  EXPECT_EQ(numeric_functions(d, state).count("applied_forces"), 0U);
}

TEST(AppliedForces, MassOnASpringWithDamperAndFriction) {
  const std::string text = R"yaml(
name: cart
parameters: {k: {value: 30, runtime: true}, b: 0.7}
coordinates: [{name: x, damping: b, friction: {force: 0.4, velocity: 0.05}, stiffness: k, rest: b/2 - 0.1, effort: 100, speed: 3}]
bodies: [{name: cart, transform: [{translate: [x, 0, 0]}], mass: 2.5}]
)yaml";
  for (const double k : {30.0, 42.0}) {
    const Description d = parse_description(text, {{"k", k}});
    const double x = 0.9, u = 0.03, a = -1.2, stretch = x - 0.25, grip = std::tanh(u / 0.05);
    const State state{{x}, {u}, {a}, 0};
    const double Q = -k * stretch - 0.7 * u - 0.4 * grip;
    EXPECT_NEAR(forces_at(d, state)[0], Q, kExact);
    const Dynamics dynamics = numeric_lagrangian(d, state);
    EXPECT_NEAR(dynamics.tau[0], 2.5 * a - Q, kExact);
    EXPECT_NEAR(dynamics.bias[0], -Q, kExact);
    EXPECT_NEAR(dynamics.mass_matrix(0, 0), 2.5, kExact);
    const auto functions = numeric_functions(d, state);
    EXPECT_NEAR(functions.at("gravity").at("g")(0), 0, kExact);
    EXPECT_NEAR(functions.at("energy").at("e")(1), 0.5 * k * stretch * stretch, kExact);
    EXPECT_NEAR(functions.at("inverse_dynamics_derivatives").at("tau_q")(0, 0), k, kExact);
    EXPECT_NEAR(functions.at("inverse_dynamics_derivatives").at("tau_qd")(0, 0),
                0.7 + 0.4 / 0.05 * (1 - grip * grip), kExact);
  }
}

// The bob hangs l below the pivot and is tied to a point h above it: L^2 = l^2 + h^2 + 2 l h cos q.
std::string tied_pendulum(const std::string& force) {
  return R"yaml(
name: pendulum
coordinates: [q]
bodies: [{name: bob, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -0.6]}], mass: 1.5}]
frames: [{name: hook, body: world, transform: [{translate: [0, 0, 0.8]}]}, {name: tip, body: bob, transform: []}]
forces: [{name: rubber, )yaml" +
         force + "}]\n";
}

TEST(AppliedForces, PendulumTiedToAPointFollowsTheLawOfCosines) {
  const double l = 0.6, h = 0.8, k = 12, rest = 1, u = 0.9;
  const Description rubber =
      parse_description(tied_pendulum("between: [hook, tip], tension: '12*max(0, length - 1) + 0.3*rate'"));
  const Description elastic =
      parse_description(tied_pendulum("potential: '6*max(0, distance(hook, tip) - 1)^2'"));
  for (const double q : {0.4, -1.1, 2.8}) {
    const State state{{q}, {u}, {0.2}, 0};
    const double L = std::sqrt(l * l + h * h + 2 * l * h * std::cos(q));
    const double lever = -l * h * std::sin(q) / L;  // dL/dq
    const double stretch = std::max(0.0, L - rest);
    EXPECT_NEAR(forces_at(rubber, state)[0], -(k * stretch + 0.3 * lever * u) * lever, kExact);
    EXPECT_NEAR(forces_at(elastic, state)[0], -k * stretch * lever, kExact);
    const auto functions = numeric_functions(elastic, state);
    EXPECT_NEAR(functions.at("energy").at("e")(1), 6 * stretch * stretch - 1.5 * 9.81 * l * std::cos(q),
                kExact);
    const double lever_rate = -(l * h * std::cos(q) + lever * lever) / L;  // from (L^2)''/2 = L'^2 + L L''
    const double bend = L > rest ? k * (lever * lever + stretch * lever_rate) : 0;
    EXPECT_NEAR(functions.at("inverse_dynamics_derivatives").at("tau_q")(0, 0),
                1.5 * 9.81 * l * std::cos(q) + bend, 1e-11);
  }
}

// A cable from a cart over a pulley, in whose tension it can be felt how long it is and how fast it pays out.
TEST(AppliedForces, PathOverAViaPoint) {
  const Description d = parse_description(R"yaml(
name: cable
inputs: [pull, {name: idle, initial: 0.25, limits: [0, 1]}]
coordinates: [x, z]
bodies:
  - {name: cart, transform: [{translate: [x, 0, 0]}], mass: 1}
  - {name: load, transform: [{translate: [0, 0.6, z]}], mass: 2}
frames:
  - {name: eye, body: cart, transform: [{translate: [0, 0, 0]}]}
  - {name: pulley, body: world, transform: [{translate: [0, 0.6, 0]}]}
  - {name: weight, body: load, transform: [{translate: [0, 0, 0]}]}
forces:
  - {name: brake, on: x, value: "0.5*length(cable) - 3*rate(cable)*idle"}
  - {name: cable, path: [eye, pulley, weight], tension: "5*length - 2*rate + pull*t"}
)yaml");
  ASSERT_EQ(d.inputs.size(), 2U);
  EXPECT_EQ(d.inputs[1].limits->second, 1);
  for (const double z : {-0.7, 0.4}) {
    State state{{0.9, z}, {1.1, -0.3}, {0, 0}, 2};
    const double slope = std::hypot(0.9, 0.6), L = slope + std::abs(z), side = z > 0 ? 1 : -1;
    const double rate = 0.9 / slope * 1.1 + side * -0.3;
    const auto expect = [&](double pull, double idle) {
      const double T = 5 * L - 2 * rate + 2 * pull;
      const Eigen::VectorXd Q = forces_at(d, state);
      EXPECT_NEAR(Q[0], -T * 0.9 / slope + 0.5 * L - 3 * rate * idle, kExact);
      EXPECT_NEAR(Q[1], -T * side, kExact);
    };
    expect(0, 0.25);
    state.inputs = {{"pull", 1.7}};
    expect(1.7, 0.25);
    state.inputs["idle"] = 0.6;
    expect(1.7, 0.6);
  }
}

// A nozzle that shifts and turns in its arm while the arm turns, all about y.
TEST(AppliedForces, AtAFrameThatMovesInItsBody) {
  const auto nozzle = [](const std::string& force) {
    return parse_description(R"yaml(
name: arm
inputs: [thrust]
coordinates: [q]
bodies: [{name: arm, transform: [{rotate: {axis: y, angle: q}}], mass: 1, com: [0.1, 0, 0]}]
frames: [{name: nozzle, body: arm, transform: [{translate: ["0.5 + 0.3*sin(q)", 0, 0.2]}, {rotate: {axis: y, angle: 2*q}}]}]
forces: [{name: jet, at: nozzle, )yaml" +
                             force + "}]\n");
  };
  const double q = 0.7, u = -1.3, F = 2.2;
  State state{{q}, {u}, {0}, 0};
  state.inputs = {{"thrust", F}};
  const auto turn = [](double angle) {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
  };
  const Eigen::Vector3d place(0.5 + 0.3 * std::sin(q), 0, 0.2), shift(0.3 * std::cos(q), 0, 0);
  const Eigen::Vector3d along = turn(q) * (Eigen::Vector3d::UnitY().cross(place) + shift);  // dp/dq
  const Eigen::Vector3d push(2 * F, 1, -0.7), origin = turn(q) * place;
  const auto expect = [&](const std::string& force, double Q) {
    EXPECT_NEAR(forces_at(nozzle(force), state)[0], Q, kExact) << force;
  };
  expect("force: [2*thrust, 1, -0.7]", (turn(3 * q) * push).dot(along));
  expect("axes: frame, force: [2*thrust, 1, -0.7], torque: [5, 0.4*d(q), 6]",
         (turn(3 * q) * push).dot(along) + 3 * 0.4 * u);
  expect("axes: world, force: [2*thrust, 1, -0.7]", push.dot(along));
  expect("axes: world, torque: [0, 1.5, 0]", 4.5);
  // What the frame says of itself.
  expect("axes: world, force: [-0.2*velocity(nozzle).x, -0.2*velocity(nozzle).y, -0.2*velocity(nozzle).z]",
         -0.2 * u * along.squaredNorm());
  expect("torque: [0, -0.4*angular_velocity(nozzle).y, 0]", -3 * 0.4 * 3 * u);
  expect("torque: [0, 'rotation(nozzle).xz + 10*rotation(nozzle).zx + 100*rotation(nozzle).yy', 0]",
         3 * (std::sin(3 * q) - 10 * std::sin(3 * q) + 100));
  expect("torque: [0, 'position(nozzle).x + 10*position(nozzle).y + 100*position(nozzle).z', 0]",
         3 * (origin[0] + 100 * origin[2]));
}

// With thrust f and torque n at a place c of a free body: f = R F along its origin's speeds, and c x F + n along its
// angular velocity, in its own axes.
TEST(AppliedForces, ThrusterOfAFreeBody) {
  const std::string text = R"yaml(
name: craft
coordinates: [x, y, z, {name: base, type: quaternion, damping: 0.3, friction: {force: 0.2, velocity: 0.5}}]
bodies: [{name: hull, transform: [{joint: {type: free, coordinates: [x, y, z, base]}}], mass: 3, inertia: {xx: 1, yy: 2, zz: 2.5}}]
frames: [{name: jet, body: hull, transform: [{translate: [0.2, -0.4, 0.3]}, {rotate: {axis: z, angle: pi/2}}]}]
forces:
  - {name: wheel, on: base.y, value: 7*d(base).z}
  - {name: thrust, at: jet, axes: AXES, force: [1, 2, "3 + t"], torque: [-0.5, 0.4, 0.1]}
)yaml";
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  const Eigen::Matrix3d R = turn.toRotationMatrix();
  const Eigen::Vector3d omega(0.4, -1.2, 0.6), c(0.2, -0.4, 0.3);
  const State state{{1, 2, 3, turn.x(), turn.y(), turn.z(), turn.w()},
                    {0.1, 0.2, 0.3, omega[0], omega[1], omega[2]},
                    std::vector<double>(6, 0.0),
                    0.5};
  for (const std::string axes : {"frame", "world"}) {
    std::string here = text;
    here.replace(here.find("AXES"), 4, axes);
    // (x, y, z) of the jet is (-y, x, z) of the hull.
    const Eigen::Vector3d force =
        axes == "frame" ? Eigen::Vector3d(-2, 1, 3.5) : R.transpose() * Eigen::Vector3d(1, 2, 3.5);
    const Eigen::Vector3d torque =
        axes == "frame" ? Eigen::Vector3d(-0.4, -0.5, 0.1) : R.transpose() * Eigen::Vector3d(-0.5, 0.4, 0.1);
    Eigen::VectorXd expected(6);
    expected.head<3>() = R * force;
    expected.tail<3>() = c.cross(force) + torque - 0.3 * omega;
    for (Eigen::Index i = 0; i < 3; ++i) expected[3 + i] -= 0.2 * std::tanh(omega[i] / 0.5);
    expected[4] += 7 * omega[2];
    EXPECT_LE((forces_at(parse_description(here), state) - expected).cwiseAbs().maxCoeff(), kExact) << axes;
  }
}

// Of a free body: minus the gradient along each speed, which turns about the body's own axes.
TEST(AppliedForces, PotentialOfATurn) {
  const Description d = parse_description(R"yaml(
name: compass
coordinates: [{name: base, type: quaternion}]
bodies: [{name: needle, transform: [{joint: {type: spherical, coordinates: [base]}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}]
frames: [{name: north, body: needle, transform: []}]
forces: [{name: field, potential: "-4*rotation(north).xz"}]
)yaml");
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.6, 0.1, -0.7, 0.3).normalized();
  const State state{{turn.x(), turn.y(), turn.z(), turn.w()}, {0, 0, 0}, {0, 0, 0}, 0};
  // A moment 4 along its own z in a field along x: m x B.
  const Eigen::Vector3d field = turn.toRotationMatrix().transpose() * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d expected = 4 * Eigen::Vector3d::UnitZ().cross(field);
  EXPECT_LE((forces_at(d, state) - expected).norm(), kExact);
}

// A stop that is not there yet, and an input that a definition passes on.
TEST(AppliedForces, StopsInputsAndDefinitions) {
  const Description d = parse_description(R"yaml(
name: slide
inputs: [{name: u, initial: 0.5}]
definitions: {gain: "2*u + sin(x)"}
coordinates: [x]
bodies: [{name: b, transform: [{translate: [x, 0, 0]}], mass: 1}]
forces:
  - {name: stop, potential: "select(x - 1, 50*(x - 1)^2, 0)"}
  - {name: motor, on: x, value: "gain*step(t - 1)"}
)yaml");
  const auto Q = [&](double x, double t, const std::map<std::string, double>& inputs) {
    State state{{x}, {0}, {0}, t};
    state.inputs = inputs;
    return forces_at(d, state)[0];
  };
  EXPECT_NEAR(Q(0.9, 0.5, {}), 0, kExact);
  EXPECT_NEAR(Q(1.2, 0.5, {}), -20, kExact);
  EXPECT_NEAR(Q(0.9, 1.5, {}), 1 + std::sin(0.9), kExact);
  EXPECT_NEAR(Q(0.9, 1.5, {{"u", -3}}), -6 + std::sin(0.9), kExact);
}

// Along a function of two coordinates and a path, whose rate damps.
TEST(AppliedForces, AlongAFunction) {
  const Description d = parse_description(R"yaml(
name: linkage
inputs: [u]
coordinates: [q, x]
bodies:
  - {name: arm, transform: [{rotate: {axis: z, angle: q}}], mass: 1}
  - {name: cart, transform: [{translate: [x, 0, 0]}], mass: 1}
frames:
  - {name: eye, body: world, transform: [{translate: [0, 0, 1]}]}
  - {name: hook, body: cart, transform: []}
forces:
  - {name: drive, along: "x*sin(q) + length(wire)^2", value: "3*u - 2*rate + rate(turn)"}
  - {name: turn, along: q^2, value: 0}
  - {name: wire, between: [eye, hook], tension: 0}
)yaml");
  const double q = 0.7, x = -0.4, qd = 1.3, xd = 0.9, u = 0.8;
  State state{{q, x}, {qd, xd}, {0, 0}, 0};
  state.inputs = {{"u", u}};
  const Eigen::Vector2d slope(x * std::cos(q), std::sin(q) + 2 * x);
  const double value = 3 * u - 2 * slope.dot(Eigen::Vector2d(qd, xd)) + 2 * q * qd;
  EXPECT_LE((forces_at(d, state) - value * slope).cwiseAbs().maxCoeff(), kExact);
}

// A cart that a motor moves through its current, and a needle whose turn a state follows.
TEST(States, RatesAndTheirDerivatives) {
  const Description d = parse_description(R"yaml(
name: drive
inputs: [{name: voltage, initial: 6}]
coordinates: [x, {name: base, type: quaternion}]
bodies:
  - {name: cart, transform: [{translate: [x, 0, 0]}], mass: 1}
  - {name: needle, parent: cart, transform: [{rotate: {quaternion: base}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
frames: [{name: tip, body: needle, transform: []}]
states:
  - {name: current, rate: "(voltage - 2*current - 0.3*d(x))/0.05", initial: 0.4}
  - {name: turn, rate: "rotation(tip).xz + stretch*d(base).y", limits: [0, 1]}
definitions: {stretch: "current*turn + x"}
forces: [{name: motor, on: x, value: 0.3*current^2}]
outputs: [{name: power, value: voltage*current}]
)yaml");
  ASSERT_EQ(d.states.size(), 2U);
  EXPECT_EQ(d.states[1].limits->second, 1);
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.6, 0.1, -0.7, 0.3).normalized();
  State state{{0.2, q.x(), q.y(), q.z(), q.w()}, {1.5, 0.1, 0.8, -0.3}, {0, 0, 0, 0}, 0};
  state.states = {{"turn", 0.7}};
  const double i = 0.4, turn = 0.7, stretch = i * turn + 0.2;
  const Eigen::Matrix3d R = q.toRotationMatrix();
  const auto all = numeric_functions(d, state);
  const auto near = [](const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
    ASSERT_EQ(found.rows(), expected.rows());
    ASSERT_EQ(found.cols(), expected.cols());
    EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), kExact) << found;
  };
  near(all.at("state_rates").at("sdot"),
       Eigen::Vector2d((6 - 2 * i - 0.3 * 1.5) / 0.05, R(0, 2) + stretch * 0.8));
  near(all.at("applied_forces").at("Q"), Eigen::Vector4d(0.3 * i * i, 0, 0, 0));
  near(all.at("state_jacobian").at("Q_s"),
       0.6 * i *
           Eigen::MatrixXd::Identity(4, 2).cwiseProduct(Eigen::Vector4d::UnitX() * Eigen::RowVector2d(1, 1)));
  // R e_z changes by R (e_k x e_z) as the needle turns about its axis k.
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(2, 4), by_speeds = Eigen::MatrixXd::Zero(2, 4);
  along.row(1) << 0.8, -R(0, 1), R(0, 0), 0;
  by_speeds(0, 0) = -0.3 / 0.05;
  by_speeds(1, 2) = stretch;
  near(all.at("state_rates_derivatives").at("r_q"), along);
  near(all.at("state_rates_derivatives").at("r_qd"), by_speeds);
  Eigen::Matrix2d by_states;
  by_states << -2 / 0.05, 0, turn * 0.8, i * 0.8;
  near(all.at("state_rates_derivatives").at("r_s"), by_states);
  near(all.at("state_input_jacobian").at("r_inputs"), Eigen::Vector2d(1 / 0.05, 0));
  near(all.at("outputs").at("y"), Eigen::VectorXd::Constant(1, 6 * i));
}

TEST(States, RatesMayUseOutputsAndTensions) {
  const Description d = parse_description(R"yaml(
name: muscle
coordinates: [x]
bodies: [{name: b, transform: [{translate: [x, 0, 0]}], mass: 1}]
frames: [{name: wall, body: world, transform: []}, {name: eye, body: b, transform: []}]
states: [{name: fibre, rate: "load - tension(tendon)*fibre", initial: 0.1}]
forces: [{name: tendon, between: [wall, eye], tension: "40*(length - fibre) + rate"}]
outputs: [{name: load, value: "tension(tendon)/2 + fibre"}]
)yaml");
  const State state{{0.5}, {-0.3}, {0}, 0};
  const auto all = numeric_functions(d, state);
  const double T = 40 * 0.4 - 0.3;
  EXPECT_NEAR(all.at("state_rates").at("sdot")(0), T / 2 + 0.1 - 0.1 * T, kExact);
  EXPECT_NEAR(all.at("state_rates_derivatives").at("r_s")(0), -20 + 1 - T + 4, kExact);
  EXPECT_EQ(all.count("outputs_rate"), 0U) << "the load depends on a speed";
}

// A rope from a hook to a cart, over a knob while the cart is beyond it.
TEST(AppliedForces, PathOverAPointUnderACondition) {
  const auto rope = [](const std::string& path) {
    return parse_description(R"yaml(
name: rope
coordinates: [x]
bodies: [{name: cart, transform: [{translate: [x, 0, 0]}], mass: 1}]
frames:
  - {name: hook, body: world, transform: [{translate: [0, 0, 1]}]}
  - {name: knob, body: world, transform: [{translate: [0.5, 0, 0.2]}]}
  - {name: eye, body: cart, transform: []}
states: [{name: up, rate: 0, initial: 1}]
forces:
  - {name: thread, between: [hook, eye], tension: 0}
  - {name: rope, path: )yaml" +
                             path + ", tension: \"2 + rate\"}\n" +
                             "outputs: [{name: long, value: length(rope)}]\n");
  };
  const auto expect = [&](const std::string& path, double x, double L, double along) {
    const Description d = rope(path);
    const State state{{x}, {0.7}, {0}, 0};
    const auto all = numeric_functions(d, state, {"outputs", "applied_forces", "outputs_jacobian"});
    EXPECT_NEAR(all.at("outputs").at("y")(0), L, kExact) << path << x;
    EXPECT_NEAR(all.at("outputs_jacobian").at("J")(0), along, kExact) << path << x;
    EXPECT_NEAR(all.at("applied_forces").at("Q")(0), -(2 + 0.7 * along) * along, kExact) << path << x;
  };
  const double to_knob = std::hypot(0.5, 0.8);
  const auto straight = [](double x) { return std::hypot(x, 1); };
  const auto from_knob = [](double x) { return std::hypot(x - 0.5, 0.2); };
  for (const std::string when : {"x - 0.5", "min(x - 0.5, 3 - x)", "position(eye).x - 0.5*up",
                                 "length(thread) - sqrt(1.25)", "x*rotation(eye).xx - 0.5"}) {
    const std::string path = "[hook, {frame: knob, when: \"" + when + "\"}, eye]";
    expect(path, 0.3, straight(0.3), 0.3 / straight(0.3));
    expect(path, 0.9, to_knob + from_knob(0.9), 0.4 / from_knob(0.9));
  }
  expect("[hook, {frame: knob, when: \"min(x - 0.5, 3 - x)\"}, eye]", 3.2, straight(3.2),
         3.2 / straight(3.2));
  // From the hook to itself there is no way; to the eye and back there are two.
  const std::string loop = "[hook, {frame: eye, when: x - 0.5}, hook]";
  expect(loop, 0.3, 0, 0);
  expect(loop, 0.9, 2 * straight(0.9), 2 * 0.9 / straight(0.9));
  const std::string two =
      "[knob, {frame: hook, when: x}, {frame: eye, when: x - 0.5}, hook, {frame: eye, when: 0.5 - x}, knob]";
  expect(two, -0.2, to_knob + straight(-0.2) + from_knob(-0.2),
         -0.2 / straight(-0.2) - 0.7 / from_knob(-0.2));
  expect(two, 0.9, 2 * to_knob + 2 * straight(0.9), 2 * 0.9 / straight(0.9));
}

}  // namespace
}  // namespace alembert::oracles

// Small mechanisms on which numbers went wrong once: each function of each against the Taylor oracle in long
// double.
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "oracles/alembert_process.hpp"
#include "oracles/nasty_mechanism.hpp"
#include "oracles/reference.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {
namespace {

namespace fs = std::filesystem;

/// A file that goes with its name.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& text, const std::string& extension)
      : path_(fs::temp_directory_path() /
              ("alembert_numbers_" + std::to_string(getpid()) + "_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + extension)) {
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { fs::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

void expect_right(const std::string& file, const Description& description, const std::vector<State>& states) {
  for (const Comparison& line :
       compare_functions(ALEMBERT_EXECUTABLE, file, description, states, comparable_functions(description))) {
    EXPECT_FALSE(line.verdict == Comparison::Verdict::fail)
        << line.function << ": off by " << line.error << ", allowed are " << line.tolerance << " "
        << line.note;
  }
}

std::vector<State> random_states(const Description& description, int count = 3) {
  std::mt19937_64 random(20);
  std::vector<State> states;
  for (int i = 0; i < count; ++i) states.push_back(random_state(description, random));
  return states;
}

void expect_right(const std::string& text, const std::vector<State>& states) {
  const TemporaryFile file("alembert: 1\nname: small\n" + text, ".yaml");
  expect_right(file.path(), read_description(file.path()), states);
}
/// At random states.
void expect_right(const std::string& text) {
  expect_right(text, random_states(parse_description("name: small\n" + text)));
}

void expect_right_after_import(const std::string& urdf) {
  const TemporaryFile robot(urdf, ".urdf"), file("", ".yaml");
  const Run run = run_alembert(ALEMBERT_EXECUTABLE, {"import", robot.path(), "--out", file.path()}, "");
  ASSERT_EQ(run.status, 0) << run.err;
  const Description description = read_description(file.path());
  expect_right(file.path(), description, random_states(description));
}

// A valve that a cam opens: closed around 0, a full opening later.
constexpr const char* kCam = R"yaml(
coordinates: [{name: turn, limits: [-1, 10]}]
bodies:
  - name: cam
    transform: [{rotate: {axis: y, angle: turn}}]
    inertia: {xx: 0.2, yy: 0.3, zz: 0.2}
    mass: 2
  - name: valve
    transform: [{translate: [0, "0.01*turn", "0.05*(1 + tanh(25*(turn - 3.7)))"]
}]
    mass: 0.4
)yaml";

TEST(WrongNumbers, LiftOfACamFarFromZero) {
  std::vector<State> states;
  for (const double turn : {3.65, 3.7, 3.72, 0.2, 8.0}) states.push_back({{turn}, {1.5}, {-0.7}, 0});
  expect_right(kCam, states);
}

constexpr const char* kShaken = R"yaml(
coordinates: [swing]
bodies:
  - {name: table, transform: [{translate: ["0.2*exp(-12*(t - 6)^2)", 0, 0]
}]
}
  - {name: bob, parent: table, transform: [{rotate: {axis: y, angle: swing}}, {translate: [0, 0, -0.7]}], mass: 1.2}
)yaml";

TEST(WrongNumbers, ShakeLongAfterTheStart) {
  std::vector<State> states;
  for (const double t : {5.7, 5.95, 6.0, 6.3, 0.0}) states.push_back({{0.4}, {0.6}, {1.1}, t});
  expect_right(kShaken, states);
}

TEST(WrongNumbers, NarrowBumpUnderAParameterOfTinyDefault) {
  const std::string text = R"yaml(
parameters: {height: {value: 1.0e-12, runtime: true}}
coordinates: [{name: along, limits: [0, 8]}]
bodies:
  - {name: cart, transform: [{translate: [along, 0, "height*exp(-((along - 4.25)/0.01)^2)"]}], mass: 3
}
)yaml";
  const TemporaryFile file("alembert: 1\nname: small\n" + text, ".yaml");
  std::vector<State> states;
  for (const double along : {4.245, 4.25, 4.258, 1.0})
    states.push_back({{along}, {0.8}, {0.3}, 0, {{"height", 0.02}}});
  expect_right(file.path(), read_description(file.path(), {{"height", 0.02}}), states);
}

// 1/cosh^2 is 1 - tanh^2, which has no digit left where the exponential is large.
TEST(WrongNumbers, WhatGrowsWhereAnotherFunctionFalls) {
  std::vector<State> states;
  for (const double u : {20.0, 18.0, 8.0, 1.0, -2.0}) states.push_back({{u}, {0.5}, {0.7}, 0});
  expect_right(R"yaml(
coordinates: [u]
bodies:
  - {name: bead, transform: [{translate: [tanh(u), "u*cosh(u)^-2*exp(2*u)", 0]}], mass: 1}
)yaml",
               states);
}

// The rate of the turning frame is a polynomial in tanh with coefficients of 2e9 where it is multiplied out.
TEST(WrongNumbers, FrameOnACurveWithAStep) {
  std::vector<State> states;
  for (const double u : {0.3, 2.95, 3.02, 5.0}) states.push_back({{u, 0.2}, {0.8, -0.4}, {0.6, 0.9}, 0});
  expect_right(R"yaml(
coordinates: [u, q]
bodies:
  - name: bead
    transform: [{curve: {point: ["cos(u)", "sin(u)", "0.3*u + tanh(40*(u - 3))"], along: u}}, {rotate: {axis: x, angle: q}}]
    mass: 1
    com: [0.1, 0.2, 0.3]
    inertia: {xx: 0.1, yy: 0.2, zz: 0.25}
)yaml",
               states);
}

// Components of a unit vector are rounded: what is 0 for one of length 1 is nearly that for these.
TEST(WrongNumbers, OneHingeWithAnAxisOfSixDigits) {
  for (const char* gravity : {"[0, 0, -9.81]", "[0, 0, 0]"})
    expect_right("gravity: " + std::string(gravity) + R"yaml(
coordinates: [q]
bodies:
  - name: door
    transform: [{joint: {type: revolute, axis: [0.861128, -0.128735, -0.856040], coordinates: [q]}}]
    mass: 1.4
    com: [0, 0.1, -0.25]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.05}
)yaml");
}

// 2^61 - 1, the prime of the proofs, is no 0.
// Nearly all of its inertia belongs to the hinge before: the difference is left of 15 to 23 digits. In closed form.
TEST(WrongNumbers, PointOnAHingeThatAlmostPointsAtIt) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  using Matrix = Eigen::Matrix<long double, 2, 2>;
  for (const std::string tilt : {"1.0e-07", "1.0e-10", "1.0e-12"}) {
    const TemporaryFile file(R"yaml(alembert: 1
gravity: [0, 0, 0]
name: small
coordinates: [a, b]
bodies:
  - {name: one, transform: [{rotate: {axis: y, angle: a}}], mass: 1, inertia: {xx: 1, yy: 1, zz: 1}}
  - name: two
    parent: one
    mass: 1
    com: [0, 0, 0.5]
    transform: [{joint: {type: revolute, coordinates: [b], axis: [)yaml" +
                                 tilt + ", 0, 1]}}]\n",
                             ".yaml");
    std::vector<State> states = random_states(read_description(file.path()));
    const long double t = std::stold(tilt);
    const Vector axis = Vector(t, 0, 1).normalized(), point(0, 0, 0.5L), y = Vector::UnitY();
    for (State& state : states) {
      state.speeds.assign(2, 0);
      const Eigen::AngleAxis<long double> turn(static_cast<long double>(state.q[1]), axis);
      // axis x (R point) = R (axis x point), of which nothing cancels.
      const Vector by_a = y.cross(turn * point), by_b = turn * Vector(axis.cross(point));
      Matrix M;
      M << 1 + by_a.squaredNorm(), by_a.dot(by_b), by_a.dot(by_b), by_b.squaredNorm();
      const Eigen::Matrix<long double, 2, 1> unit = M.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd tau = M.diagonal().cwiseSqrt().cast<double>();
      const Eigen::VectorXd expected =
          (M.ldlt().solve(tau.cast<long double>())).cwiseQuotient(unit).cast<double>();
      const auto found = ask_functions(ALEMBERT_EXECUTABLE, file.path(), {state}, {tau},
                                       {"mass_matrix", "forward_dynamics", "mass_matrix_inverse"});
      const Matrix mass = found[0].at("mass_matrix").at("M").cast<long double>(),
                   inverse = found[0].at("mass_matrix_inverse").at("Minv").cast<long double>();
      const Matrix scaled = unit.asDiagonal() * M * unit.asDiagonal();
      EXPECT_LT((unit.asDiagonal() * mass * unit.asDiagonal() - scaled).cwiseAbs().maxCoeff(), 1e-14) << tilt;
      const Matrix back = unit.cwiseInverse().asDiagonal() * inverse * unit.cwiseInverse().asDiagonal();
      EXPECT_LT((back * scaled - Matrix::Identity()).cwiseAbs().maxCoeff(), 1e-13) << tilt;
      const Eigen::VectorXd rates =
          found[0].at("forward_dynamics").at("qdd").col(0).cwiseQuotient(unit.cast<double>());
      EXPECT_LT((rates - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff()) << tilt;
    }
  }
}

// m (x^2 + y^2), beside which m z^2 is so large that double loses it in the difference of two moments.
TEST(WrongNumbers, InertiaAboutAnAxisOfAPointFarAlongIt) {
  struct Case {
    std::string x, y, z, mass;
  };
  for (const auto& [x, y, z, mass] : {Case{"52", "0.03791", "575700", "192000"},
                                      Case{"0.012345678", "0.0023456789", "123.456789", "1.2345678"},
                                      Case{"0.0001234567", "0.0002345678", "12345.6789", "1.2345678"},
                                      Case{"1.2345678e-6", "2.345678e-6", "12.3456789", "1.2345678"}}) {
    const TemporaryFile file(
        "alembert: 1\nname: far\ncoordinates: [q]\nbodies:\n  - name: point\n    mass: " + mass +
            "\n    transform: [{rotate: {axis: z, angle: q}}, {translate: [" + x + ", " + y + ", " + z +
            "]}]\n",
        ".yaml");
    const std::vector<State> states = random_states(read_description(file.path()));
    const long double inertia =
        std::stold(mass) * (std::stold(x) * std::stold(x) + std::stold(y) * std::stold(y));
    const std::vector<Eigen::VectorXd> tau(states.size(),
                                           Eigen::VectorXd::Constant(1, static_cast<double>(inertia)));
    const auto found = ask_functions(ALEMBERT_EXECUTABLE, file.path(), states, tau,
                                     {"mass_matrix", "forward_dynamics", "energy"});
    for (std::size_t i = 0; i < states.size(); ++i) {
      const double moved = found[i].at("mass_matrix").at("M")(0, 0),
                   rate = found[i].at("forward_dynamics").at("qdd")(0, 0),
                   kinetic = found[i].at("energy").at("e")(0, 0);
      const long double speed = states[i].speeds[0];
      EXPECT_NEAR(moved, static_cast<double>(inertia), 1e-14 * static_cast<double>(inertia)) << z;
      EXPECT_NEAR(rate, 1, 1e-13) << z;
      EXPECT_NEAR(kinetic, static_cast<double>(inertia * speed * speed / 2), 1e-14 * std::abs(kinetic)) << z;
    }
  }
}

// A carriage without an inertia worth the name, held by a constraint: what is singular is M, not the motion.
TEST(WrongNumbers, ConstrainedCoordinatesOfNextToNoInertia) {
  const std::string head = "alembert: 1\nname: light\ngravity: [0, 0, 0]\ncoordinates: [a, b]\nbodies:\n";
  for (const std::string mass : {"1e-3", "1e-6", "1e-9", "1e-12", "1e-16", "0"}) {
    const std::string apart = head + "  - {name: bead, transform: [{translate: [a, 0, 0]}], mass: " + mass +
                              "}\n  - {name: slide, transform: [{translate: [b, 0, 1]}], mass: 2}\n"
                              "constraints:\n  - {name: drive, type: holonomic, equations: [a - 0.3*b]}\n";
    const std::string carried =
        head + "  - {name: carriage, transform: [{translate: [a, 0, 0]}], mass: " + mass +
        "}\n  - {name: load, parent: carriage, transform: [{translate: [b, 0, 0]}], mass: 1.3}\n"
        "constraints:\n  - {name: gear, type: holonomic, equations: [b - 0.7*a]}\n";
    State state;
    state.q = {0.3, 1};
    state.speeds = {0.1, 0.2};
    state.rates = {0, 0};
    const Eigen::VectorXd tau = Eigen::Vector2d(1.37, -0.41);
    const auto compare = [&](const std::string& text, long double a, long double b, long double lambda) {
      SCOPED_TRACE(text);
      const TemporaryFile file(text, ".yaml");
      const auto found =
          ask_functions(ALEMBERT_EXECUTABLE, file.path(), {state}, {tau}, {"constrained_forward_dynamics"});
      const auto& of = found[0].at("constrained_forward_dynamics");
      EXPECT_NEAR(of.at("qdd")(0, 0), static_cast<double>(a), 1e-9 * std::abs(static_cast<double>(a)));
      EXPECT_NEAR(of.at("qdd")(1, 0), static_cast<double>(b), 1e-9 * std::abs(static_cast<double>(b)));
      EXPECT_NEAR(of.at("lambda")(0, 0), static_cast<double>(lambda), 1e-12);
    };
    const long double m = std::stold(mass), x = tau(0), y = tau(1);
    const long double slide = (y + 0.3L * x) / (2 + 0.09L * m);
    compare(apart, 0.3L * slide, slide, 0.3L * m * slide - x);
    const long double carriage = (x + 0.7L * y) / (m + 1.3L * 1.7L * 1.7L);
    compare(carried, carriage, 0.7L * carriage, 1.3L * 1.7L * carriage - y);
  }
}

// Columns of the regressor are 0, or depend on each other, that are not at other values of the parameters.
TEST(WrongNumbers, RuntimeParametersOfDefaultZero) {
  expect_right(R"yaml(
parameters: {l: {value: 0, runtime: true}, g: {value: 0, runtime: true}}
coordinates: [q, p]
bodies:
  - name: one
    transform: [{rotate: {axis: z, angle: q}}, {translate: [l, l*q, 0]}, {rotate: {axis: x, angle: g}}]
    mass: 1
    com: [0.1, 0.2, 0.05]
    inertia: {xx: 1, yy: 2, zz: 2, xy: 0.1}
  - name: two
    parent: one
    transform: [{translate: [0.3, 0.1, 0]}, {rotate: {axis: [1, 1, 0.3], angle: p}}, {translate: [0, 0.5, 0.2]}]
    mass: 0.7
    inertia: {xx: 0.1, yy: 0.2, zz: 0.2}
)yaml");
}

TEST(WrongNumbers, ADistanceOfDefaultZero) {
  expect_right(R"yaml(
parameters: {l: {value: 0, runtime: true}}
coordinates: [q, p]
bodies:
  - {name: one, transform: [{rotate: {axis: z, angle: q}}], mass: 1, com: [0.1, 0.2, 0.05], inertia: {xx: 1, yy: 2, zz: 2}}
  - name: two
    parent: one
    transform: [{translate: [l, 0, 0]}, {rotate: {axis: z, angle: p}}]
    mass: 0.7
    com: [0.3, 0.1, 0]
    inertia: {xx: 0.1, yy: 0.2, zz: 0.2}
)yaml");
}

TEST(WrongNumbers, PathOverTwoPointsAtOnePlace) {
  expect_right(R"yaml(
coordinates: [q, p]
bodies:
  - {name: one, transform: [{rotate: {axis: z, angle: q}}], mass: 1, com: [0.1, 0.2, 0.05], inertia: {xx: 1, yy: 2, zz: 2}}
  - name: two
    parent: one
    transform: [{translate: [0.4, 0, 0]}, {rotate: {axis: [1, 0, 2], angle: p}}]
    mass: 0.7
    com: [0.3, 0.1, 0]
    inertia: {xx: 0.1, yy: 0.2, zz: 0.2}
frames:
  - {name: wall, body: world, transform: [{translate: [0.1, -0.5, 0.2]}]}
  - {name: before, body: one, transform: [{translate: [0.2, 0.1, 0]}]}
  - {name: behind, body: one, transform: [{translate: [0.2, 0.1, 0]}, {rotate: {axis: x, angle: 0.3}}]}
  - {name: end, body: two, transform: [{translate: [0.5, 0, 0.1]}]}
forces:
  - {name: tendon, path: [wall, before, behind, end], tension: "20*(length - 0.6) + rate"}
)yaml");
}

// To turn sin(9^100000000) by multiples of pi takes as many digits of pi.
TEST(WrongNumbers, PowerBeyondAllNumbers) {
  const std::string text = R"yaml(
coordinates: [q]
bodies:
  - {name: one, transform: [{rotate: {axis: y, angle: q^100000000}}, {translate: [0, 0, 1]}], mass: 1}
)yaml";
  std::vector<State> states = random_states(parse_description("name: small\n" + text), 1);
  states[0].q = {-1};  // elsewhere all is 0, or infinite
  expect_right(text, states);
}

// Parts of them underflow where the whole is 1 or 0: what rounding explains must count that.
TEST(WrongNumbers, StepsWrittenWithExponentials) {
  for (const std::string step :
       {"log(1 + exp(300*b))/300", "b + (exp(100*b) - exp(-100*b))/(exp(100*b) + exp(-100*b))",
        "b + 0.1/(1 + exp(-200*(b - 1)))", "b/(1 + exp(-100*b))"})
    expect_right(R"yaml(
coordinates: [a, b]
bodies:
  - {name: one, transform: [{rotate: {axis: z, angle: a}}], mass: 1, com: [0.1, 0, 0]}
  - name: two
    parent: one
    mass: 1
    transform: [{translate: [0, ")yaml" +
                 step + "\", 0]}]\n");
}

TEST(WrongNumbers, NumberThatIsAMultipleOfThePrime) {
  std::vector<State> states;
  for (const double q : {4.001, 3.99, 1.0}) states.push_back({{q}, {1}, {1}, 0});
  expect_right(R"yaml(
coordinates: [q]
bodies:
  - {name: a, transform: [{translate: [q, "2.305843009213693951*exp(-((q - 4)/1.0e-2)^2)", 0]}], mass: 1}
)yaml",
               states);
}

// A ring on a torus with a dent at u = 6, 1e-5 wide. The square of the slope was multiplied out into powers of u,
// which left five digits of it.
TEST(WrongNumbers, NarrowDentOfASurface) {
  const std::string text = R"yaml(
coordinates: [{name: u, initial: 6.5, limits: [5, 7]}, {name: v, limits: [-1, 1]}]
bodies:
  - name: ring
    transform:
      - surface: {point: ["(1.3 + 2e-6*exp(-((u - 6)/0.00001)^2) + 0.4*cos(v))*cos(u)", "(1.3 + 2e-6*exp(-((u - 6)/0.00001)^2) + 0.4*cos(v))*sin(u)", "0.4*sin(v)"], along: [u, v]}
    mass: 1.2
    com: [0.1, -0.2, 0.3]
    inertia: {xx: 0.2, yy: 0.3, zz: 0.25}
)yaml";
  std::vector<State> states;
  for (const double u : {5.999995, 6.0, 6.0000071, 6.6})
    states.push_back({{u, 0.4}, {1e-5, 0.5}, {2e-6, -0.3}, 0});
  expect_right(text, states);
}

// What is late in each kind of factor.
TEST(WrongNumbers, LateFunctionsInEveryFactor) {
  const std::string step = "(1 + tanh(30*(a - 5)))";
  const std::vector<std::string> factors{
      "{matrix: [[\"cos(S)\", \"-sin(S)\", 0, 0.3], [\"sin(S)\", \"cos(S)\", 0, 0], [0, 0, 1, 0]]}",
      "{inverse: [{rotate: {axis: x, angle: 0.6}}, {translate: [0, 0.1, \"S\"]}]}",
      "{curve: {point: [\"cos(b)\", \"sin(b)\", \"0.2*b + 0.3*S\"], along: b, frame: {reference: [0.02, "
      "0.03, 1]}}}",
      "{surface: {point: [\"(1.5 + 0.2*S + 0.3*cos(b))*cos(c)\", \"(1.5 + 0.2*S + 0.3*cos(b))*sin(c)\", "
      "\"0.3*sin(b)\"], along: [c, b]}}",
      "{rotate: {axis: [1, 2, 2], angle: \"S\"}}"};
  for (const std::string& factor : factors) {
    std::string filled = factor;
    for (std::size_t at; (at = filled.find('S')) != std::string::npos;) filled.replace(at, 1, step);
    const bool b = factor.find("(b)") != std::string::npos, c = factor.find("(c)") != std::string::npos;
    const std::string text = std::string("coordinates: [{name: a, limits: [-1, 9]}") + (b ? ", b" : "") +
                             (c ? ", c" : "") +
                             R"yaml(]
bodies:
  - {name: base, transform: [{rotate: {axis: y, angle: a}}, {translate: [0.3, 0, 0.1]}], mass: 1}
  - {name: tip, parent: base, transform: [)yaml" +
                             filled + R"yaml(], mass: 0.7, com: [0.1, 0.2, 0.3],
     inertia: {xx: 0.02, yy: 0.03, zz: 0.025}}
)yaml";
    SCOPED_TRACE(text);
    std::vector<State> states = random_states(parse_description("name: small\n" + text), 4);
    for (std::size_t i = 0; i < 3; ++i) states[i].q[0] = 4.97 + 0.03 * static_cast<double>(i);
    expect_right(text, states);
  }
}

// The second and third axis are parallel but for what pi/2 was rounded to.
std::string near_parallel(const std::string& tilt) {
  return R"yaml(
coordinates: [a, b, c]
bodies:
  - {name: one, transform: [{rotate: {axis: x, angle: a}}, {translate: [0, 0, 0.8]}], mass: 1.5}
  - {name: two, parent: one, transform: [{rotate: {axis: z, angle: b}}], mass: 0.9, com: [0.1, 0, 0]}
  - name: three
    parent: two
    transform: [{translate: [0.6, 0.2, 0]}, {rotate: {axis: y, angle: )yaml" +
         tilt + R"yaml(}}, {rotate: {axis: z, angle: c}}]
    mass: 0.8
    com: [0.4, 0, 0.3]
)yaml";
}

TEST(WrongNumbers, AxesParallelToSixDigits) {
  expect_right(near_parallel("3.6732e-6"));
}
TEST(WrongNumbers, AxesParallelToTenDigits) {
  expect_right(near_parallel("1.0e-09"));
}
TEST(WrongNumbers, AxesParallelToFourDigits) {
  expect_right(near_parallel("-9.3e-5"));
}

// Axes at right angles that pass each other at a micrometre or two.
TEST(WrongNumbers, AxesThatMissEachOtherByAMicrometre) {
  expect_right(R"yaml(
coordinates: [a, b, c, d]
bodies:
  - name: one
    transform: [{rotate: {axis: z, angle: a}}]
    mass: 1.7
    com: [0.03, -0.02, 0.05]
    inertia: {xx: 0.5, yy: 0.6, zz: 0.3, xy: 0.02, xz: -0.05}
  - name: two
    parent: one
    transform: [{rotate: {axis: z, angle: -0.4}}, {translate: [1.4e-06, 0.25, 0]},
                {rotate: {axis: x, angle: pi/2}}, {rotate: {axis: z, angle: b}}]
    mass: 1.1
    com: [-0.04, 0.06, 0.08]
    inertia: {xx: 0.4, yy: 0.3, zz: 0.2, xy: 0.01, yz: 0.03}
  - name: three
    parent: two
    transform: [{rotate: {axis: z, angle: -1.1}}, {translate: [-2.0e-06, -0.5, 0]},
                {rotate: {axis: x, angle: pi/2}}, {rotate: {axis: z, angle: c}}]
    mass: 0.6
    com: [0.3, -0.05, 0.1]
    inertia: {xx: 0.1, yy: 0.15, zz: 0.12, xz: 0.02}
  - name: four
    parent: three
    transform: [{rotate: {axis: z, angle: 0.7}}, {translate: [1.0e-06, 0.4, 0]},
                {rotate: {axis: x, angle: pi/2}}, {rotate: {axis: z, angle: d}}]
    mass: 0.5
    com: [0.1, 0.15, -0.1]
    inertia: {xx: 0.05, yy: 0.06, zz: 0.04, xy: 0.01}
)yaml");
}

std::string urdf_link(const std::string& name, const std::string& com) {
  return "<link name='" + name + "'><inertial><origin xyz='" + com +
         "'/><mass value='1.6'/><inertia ixx='0.21' iyy='0.17' izz='0.24' ixy='0.012' ixz='-0.02' "
         "iyz='0.015'/></inertial></link>";
}
std::string urdf_joint(const std::string& name, const std::string& parent, const std::string& child,
                       const std::string& origin, const std::string& type = "continuous") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
         child + "'/><origin " + origin + "/><axis xyz='0 0 1'/>" +
         (type == "prismatic" ? "<limit lower='-0.3' upper='0.3' effort='1' velocity='1'/>" : "") +
         "</joint>";
}
std::string urdf_arm(const std::string& second, const std::string& third,
                     const std::string& type = "continuous",
                     const std::string& first = "xyz='0 0 0.2' rpy='1.5708 0 0'") {
  return "<robot name='arm'><link name='base'/>" + urdf_link("one", "0.05 -0.04 0.1") +
         urdf_link("two", "-0.1 0.02 0.07") + urdf_link("three", "0.02 -0.15 -0.1") +
         urdf_joint("a", "base", "one", first) + urdf_joint("b", "one", "two", second) +
         urdf_joint("c", "two", "three", third, type) + "</robot>";
}

// Ordinary joints, but right angles as 1.5708 and -1.5708, whose sum is not the end of it with a turn
// between.
TEST(WrongNumbers, RightAnglesOfAnExporter) {
  expect_right_after_import(
      urdf_arm("xyz='0.1 0.3 0' rpy='-1.5708 0 0.4'", "xyz='0.2 0.35 0.05' rpy='3.1416 0 1.5708'"));
}
// A SCARA: two upright axes and a spindle, each upright to six digits.
TEST(WrongNumbers, ScaraAsExported) {
  expect_right_after_import(
      urdf_arm("xyz='0.325 0 0.02' rpy='0 3.14159 0'", "xyz='0.275 0 0.1' rpy='3.14159 0 0'", "prismatic"));
}
// Offsets of micrometres, as from CAD.
TEST(WrongNumbers, MicrometresOfAnExporter) {
  expect_right_after_import(urdf_arm(
      "xyz='-1.8e-06 0 0.3'", "xyz='-2.3e-06 0 0.45' rpy='-1.5707963267948966 0 0'", "continuous", ""));
}
// -0.927295 is -atan2(0.4, 0.3) to six digits: the third axis passes the second one at 5e-8 m.
TEST(WrongNumbers, AxesThatNearlyMeet) {
  expect_right_after_import(urdf_arm("xyz='0.06 -0.4 0' rpy='0 0 -1.3'",
                                     "xyz='0.4 0.3 0' rpy='-1.5707963267949 0 -0.927295'", "continuous",
                                     "rpy='-1.5707963267949 0 0'"));
}

// A thumb as exported, its axes parallel to thirteen digits, on a stage of 100 kg beside which its forces are
// nothing: the direction of the tilt has three digits only. They were right to four.
TEST(WrongNumbers, AxesParallelToThirteenDigitsOnAStage) {
  const std::string text = R"yaml(
coordinates: [height, first, second]
bodies:
  - name: stage
    transform: [{joint: {type: prismatic, axis: z, coordinates: [height]}}]
    mass: 100
  - name: one
    parent: stage
    transform:
      - translate: [0.0421965979105674, -0.0941606527701362, 0.0317642107824709]
      - joint: {type: revolute, axis: [0.653442120633779, 0.0561747295623823, -0.754889259918448], coordinates: [first]}
    mass: 0.00520499928633448
    com: [0.00595800407210242, -0.0112503464220567, 0.00518269565716167]
    inertia: {xx: 1.460268e-08, yy: 1.670183e-08, zz: 2.887708e-08, xy: 1.440034e-08, xz: -4.335692e-09, yz: 4.031184e-09}
  - name: two
    parent: one
    transform:
      - translate: [0.0111118631544056, -0.0219257069936049, 0.00848109657008508]
      - joint: {type: revolute, axis: [0.653442120633895, 0.0561747295623124, -0.754889259918354], coordinates: [second]}
    mass: 0.00290769681829447
    com: [0.0056392427710277, -0.00819754869289124, 0.00357444528870934]
)yaml";
  const TemporaryFile file("alembert: 1\nname: small\n" + text, ".yaml");
  const Description description = read_description(file.path());
  const std::vector<State> states = random_states(description);
  expect_right(file.path(), description, states);
  const std::vector<Eigen::VectorXd> tau(states.size(), Eigen::VectorXd::Zero(description.nv));
  const auto found = ask_functions(ALEMBERT_EXECUTABLE, file.path(), states, tau, {"bias"});
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto expected = numeric_lagrangian<long double>(description, states[i]).bias;
    for (Eigen::Index k = 0; k < description.nv; ++k) {
      const double given = found[i].at("bias").at("c")(k), wanted = static_cast<double>(expected[k]);
      EXPECT_NEAR(given, wanted, 1e-10 * std::abs(wanted)) << "speed " << k;
    }
  }
}

// Axis vectors of length 1e12 and 1e-9, tilts, an inverse and a pitch of 0.
TEST(WrongNumbers, AxesAndTurnsOfAllSizes) {
  expect_right(R"yaml(
gravity: [0, 0, 0]
coordinates: [a, b, c]
bodies:
  - name: one
    transform: [{translate: [0.3, 0.4, 1.0e-06]}, {rotate: {axis: [0, 0, 1.0e-09], angle: 2*pi}},
                {joint: {type: revolute, axis: [1.0e-06, 0, 1], coordinates: [a]}}]
    mass: 1.9
    inertia: {xx: 0.6, yy: 0.6, zz: 0.6}
  - name: two
    parent: one
    transform: [{translate: [0.3, 0, -1]}, {joint: {type: helical, axis: z, pitch: 0, coordinates: [b]}}]
    mass: 1.5
    com: [0.2, -0.5, -0.8]
    inertia: {xx: 0.9, yy: 0.9, zz: 0.4}
  - name: three
    parent: two
    transform: [{inverse: [{rotate: {axis: y, angle: 1.5708}},
                           {joint: {type: prismatic, axis: [0, 0, 1.0e+12], coordinates: [c]}}]}]
    mass: 0.9
    com: [0.3, 0.6, -0.2]
    inertia: {xx: 4.2, yy: 3.9, zz: 4.5, xy: 1.6, xz: -1.7, yz: 1.5}
)yaml");
}
// Two axes that are parallel to 1e-9, bodies of millimetres.
TEST(WrongNumbers, MillimetresOnAxesParallelToNineDigits) {
  expect_right(R"yaml(
gravity: [1, 2, 3]
coordinates: [a, b]
bodies:
  - {name: one, transform: [{rotate: {axis: [0, 0, 1.0e+12], angle: 1.5708}}, {joint: {type: revolute, coordinates: [a]}}]}
  - name: two
    parent: one
    transform: [{rotate: {axis: x, angle: 1.0e-09}}, {translate: [-0.0009, 0.0012, 1.0e-06]},
                {joint: {type: revolute, coordinates: [b]}}]
    mass: 1.1
    com: [-0.0002, -0.0007, -0.0006]
    inertia: {xx: 7.8e-06, yy: 7.3e-06, zz: 4.6e-06, xy: -1.1e-07, xz: -8.9e-07, yz: 2.2e-06}
)yaml");
}
TEST(WrongNumbers, MirrorOfMicrogramsOnAStage) {
  expect_right(R"yaml(
gravity: [1, 2, -9.81]
coordinates: [a, b]
bodies:
  - {name: stage, transform: [{rotate: {axis: z, angle: a}}], mass: 12, com: [0.1, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}
  - name: mirror
    parent: stage
    transform: [{translate: [0.15, 0.2, 0.25]}, {rotate: {axis: [1, 2, 2], angle: b}}, {rotate: {axis: y, angle: 0.4}}]
    mass: 2.4e-07
    com: [2.5e-05, 2.0e-05, 4.0e-05]
    inertia: {xx: 2.6e-15, yy: 3.4e-15, zz: 4.1e-15, xy: 1.2e-15}
)yaml");
}
// The centre of mass is that of the rotor but for rounding, and the angular momentum about it that of what is light.
TEST(WrongNumbers, AngularMomentumOfAHeavyRotorOnALightStage) {
  expect_right(R"yaml(
coordinates:
  - {name: x, limits: [-0.4, 0.4]}
  - {name: y, limits: [-6.5e-06, 6.5e-06]}
  - {name: turn, limits: [-3, 3]}
  - {name: spin, limits: [-3, 3]}
bodies:
  - name: stage
    transform: [{joint: {type: planar, coordinates: [x, y, turn]}}]
    mass: 3.0e-06
    com: [-0.0025, -0.006, 0.0005]
    inertia: {xx: 1.9e-10, yy: 3.0e-10, zz: 3.6e-10}
  - name: rotor
    parent: stage
    transform:
      - {translate: [0, 0, -0.0015]}
      - {rotate: {axis: x, angle: pi/4}}
      - {joint: {type: revolute, axis: z, coordinates: [spin]}}
    mass: 7.2
    com: [1.4e-05, 0.001, -3.3e-06]
  - name: pointer
    parent: rotor
    transform: [{rotate: {axis: y, angle: 0.48}}]
    mass: 0.00034
    com: [-0.0019, -0.0002, 0.0037]
)yaml");
}
// Two hinges on one line, to rounding. The plain equations of the constrained motion have values, but no right digit; the
// equations that are written have no value.
TEST(WrongNumbers, ConstrainedMotionOfASingularMassMatrix) {
  const NastyMechanism mechanism = nasty_mechanism(100156);
  const TemporaryFile file(mechanism.text, ".yaml");
  const oracles::Run run = run_alembert(
      ALEMBERT_EXECUTABLE, {"evaluate", file.path(), "--functions", "constrained_forward_dynamics"}, "");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("double precision leaves few right digits"), std::string::npos) << run.err;
}
// A row that ties turns, which move 1e16 kg m^2 and more, to a slide, which moves 1e5 kg.
TEST(WrongNumbers, RowOfTurnsAndASlide) {
  const std::string text = R"yaml(
coordinates:
  - {name: swing, limits: [-3, 3]}
  - {name: turn, type: quaternion}
  - {name: slide, limits: [-5.0e+05, 5.0e+05]}
bodies:
  - name: boom
    transform: [{joint: {type: revolute, axis: y, coordinates: [swing]}}, {translate: [0, 44432.4, -422122]}]
    mass: 156238.9
    com: [-281965, -45729.7, 296999]
  - name: ball
    parent: boom
    transform: [{joint: {type: spherical, coordinates: [turn]}}, {translate: [0, -502266, 43286.2]}]
    mass: 94841.1
    com: [-126363, 290677, 249921]
    inertia: {xx: 1.08e+16, yy: 8.45e+15, zz: 7.51e+15, xy: 5.79e+14, xz: -8.96e+13, yz: -2.16e+15}
  - name: carriage
    parent: ball
    transform: [{rotate: {axis: y, angle: 0.0942985}}, {joint: {type: prismatic, axis: z, coordinates: [slide]}}]
    mass: 126701.6
    com: [-54026.1, 119547, -103955]
    inertia: {xx: 1.59e+16, yy: 1.58e+16, zz: 1.62e+16, xy: -3.64e+15, xz: -4.04e+15, yz: -4.74e+15}
constraints:
  - {name: geared, type: pfaffian, rows: ["1.75129*d(turn).y - 0.98733*d(turn).x - cos(swing + pi/4)*d(slide)"]}
)yaml";
  std::vector<State> states = random_states(parse_description("name: small\n" + text));
  for (State& state : states) state.speeds.back() *= 5e5;
  expect_right(text, states);
}
// At the initial state the row of the distance is nothing but rounding.
TEST(WrongNumbers, DistanceAtItsExtremum) {
  expect_right(R"yaml(
coordinates:
  - {name: base, limits: [-3, 3]}
  - {name: slide, limits: [-3, 3]}
  - {name: turn, limits: [-3, 3]}
bodies:
  - name: arm
    transform: [{joint: {type: revolute, axis: [1.79, -1.38, 2], coordinates: [base]}}, {translate: [-0.672556, 0, -0.609213]}]
    mass: 2.2
    com: [-0.23, 0.23, 0.24]
    inertia: {xx: 0.28, yy: 0.34, zz: 0.19, xy: 0.02}
  - name: carriage
    parent: arm
    transform:
      - {rotate: {axis: x, angle: 0.395638}}
      - {joint: {type: helical, axis: [-1, 0, 0], pitch: 0.08, coordinates: [slide]}}
    mass: 2.9
    com: [0.19, -0.05, 0]
    inertia: {xx: 0.28, yy: 0.34, zz: 0.19, xy: 0.02, xz: 0.12}
  - name: flap
    parent: carriage
    transform: [{rotate: {axis: y, angle: -pi/2}}, {joint: {type: revolute, axis: z, coordinates: [turn]}}]
    mass: 2
    com: [-0.28, 0.29, 0.17]
    inertia: {xx: 0.18, yy: 0.17, zz: 0.19}
frames:
  - {name: end, body: flap, transform: [{translate: [-0.646789, 0, 0.623064]}, {rotate: {axis: x, angle: 1.29007}}, {translate: [0.39975, 0, 0]}]}
  - {name: anchor, body: carriage, transform: [{translate: [-0.407796, 0, 0.500134]}, {rotate: {axis: x, angle: pi/2}}, {translate: [0.737225, 0, 0]}]}
  - {name: tip, body: flap, transform: [{translate: [-0.5, 0.5, -0.1]}]}
  - {name: post, body: carriage, transform: [{translate: [0.7, 0.1, 0.3]}]}
constraints:
  - name: rod
    type: holonomic
    equations:
      - "(position(end).x - position(anchor).x)^2 + (position(end).y - position(anchor).y)^2 + (position(end).z - position(anchor).z)^2 - 1"
  - {name: plane, type: holonomic, equations: ["position(tip).x - position(post).x"]}
)yaml");
}
TEST(WrongNumbers, NothingIsSingularThatIsOnlySmall) {
  expect_right(R"yaml(
coordinates: [x, q]
bodies:
  - {name: stage, transform: [{translate: [x, 0, 0]}], mass: 20}
  - {name: mirror, transform: [{rotate: {axis: x, angle: q}}], mass: 3.0e-10, inertia: {xx: 4.0e-20, yy: 4.0e-20, zz: 4.0e-20}}
)yaml");
}
TEST(WrongNumbers, NothingIsSingularThatIsNearlyParallel) {
  expect_right(R"yaml(
parameters: {l: {value: 0.6, runtime: true}, m: {value: 1.4, runtime: true}}
coordinates: [a, b, c]
bodies:
  - {name: one, transform: [{rotate: {axis: y, angle: "a + 0.4*sin(a)"
}
}, {translate: [0, 0, 0.9]}], mass: 1.2
}
  - name: two
    parent: one
    transform: [{joint: {type: revolute, axis: [0, 0, 1.0e-09], coordinates: [b]}}]
    mass: m
    com: [l*0.25, 0.1, -0.3]
  - name: three
    parent: two
    transform: [{translate: [0, 0.8, 0]}, {rotate: {axis: [1.0e-06, 0, 1], angle: 0.5}},
                {rotate: {axis: z, angle: "tanh(c) + atan(c/2)"}}, {translate: [0, 0, "log(3 + c)"]}]
    mass: 0.9
)yaml");
}

}  // namespace
}  // namespace alembert::oracles

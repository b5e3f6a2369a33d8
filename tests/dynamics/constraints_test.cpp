// Rows of constraints against motion: no slip is no velocity of the material point at the contact, P is the
// rate of position, gamma the rate of P u. Rates are taken numerically, along motions through random states.
#include "dynamics/recursions/constraints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "dynamics/function_builders.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "dynamics/sleigh.hpp"
#include "dynamics/tree/symbols.hpp"
#include "mechanism/constraint_rows.hpp"
#include "mechanism/mate.hpp"
#include "program/lower.hpp"
#include "program/optimized.hpp"
#include "program/schedule.hpp"
#include "program/verify/verify.hpp"
#include "symbolic/to_string.hpp"

namespace alembert::test {
namespace {

using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;

constexpr unsigned kConstrainedStates = 6;

/// A mechanism at a state that can be moved along its speeds.
class ConstrainedMechanism {
 public:
  explicit ConstrainedMechanism(LoadedMechanism loaded)
      : loaded_(std::move(loaded)),
        kinematics_(loaded_.kinematics()),
        equations_(constraint_equations(*loaded_.mechanism, kinematics_.tree, kinematics_.derivatives,
                                        *loaded_.graph)),
        N_(kinematics_.derivatives.coordinate_rate_matrix()),
        poses_(body_poses(*loaded_.mechanism, kinematics_.tree, *loaded_.graph)) {
    set_random_state(1);
  }

  const Mechanism& mechanism() const { return *loaded_.mechanism; }
  const ConstraintEquations& equations() const { return equations_; }
  Eigen::Index nv() const { return mechanism().nv; }
  Eigen::Index rows() const { return static_cast<Eigen::Index>(equations_.position.size()); }

  void set_random_state(unsigned seed) {
    state_ = state_values(mechanism(), *loaded_.graph, seed);
    at(mechanism().time) = 0.3 * seed;
  }
  /// The speeds of the state, and their rates.
  VectorXd speeds() {
    return read([](const Coordinate& c) -> auto& { return c.speed_symbols; });
  }
  VectorXd rates() {
    return read([](const Coordinate& c) -> auto& { return c.rate_symbols; });
  }
  void set_speeds(const VectorXd& u) {
    Eigen::Index k = 0;
    for (const Coordinate& c : mechanism().coordinates)
      for (const Expr symbol : c.speed_symbols) at(symbol) = u(k++);
  }

  VectorXd value(std::span<const Expr> expressions) const {
    const std::vector<double> values = evaluate(expressions, state_);
    return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  MatrixXd P() const { return value(equations_.P).reshaped<Eigen::RowMajor>(rows(), nv()); }
  Matrix4d pose(int body) const {
    Matrix4d W = Matrix4d::Identity();
    if (body < 0) return W;
    const VectorXd entries = value(std::span(poses_).subspan(12 * static_cast<std::size_t>(body), 12));
    W.topRows<3>() = entries.reshaped<Eigen::RowMajor>(3, 4);
    return W;
  }

  /// d/dt of a function of the state, by central differences of order 4 along the motion with these speeds
  /// and rates of the speeds, in which time goes on.
  template <class Function>
  auto rate_of(const Function& function) {
    const std::vector<double> here = state_;
    const VectorXd u = speeds(), ud = rates();
    const VectorXd qdot = value(N_).reshaped<Eigen::RowMajor>(mechanism().nq, mechanism().nv) * u;
    const auto at_time = [&](double h) {
      Eigen::Index i = 0;
      for (const Coordinate& c : mechanism().coordinates)
        for (const Expr symbol : c.symbols) at(symbol) = here[index(symbol)] + h * qdot(i++);
      set_speeds(u + h * ud);
      at(mechanism().time) = here[index(mechanism().time)] + h;
      auto result = function().eval();
      state_ = here;
      return result;
    };
    constexpr double h = 1e-3;
    auto near = (at_time(h) - at_time(-h)).eval();
    auto far = (at_time(2 * h) - at_time(-2 * h)).eval();
    return ((8 * near - far) / (12 * h)).eval();
  }

 private:
  std::uint32_t index(Expr symbol) const { return loaded_.graph->symbol_index(symbol.ref().node()); }
  double& at(Expr symbol) { return state_[index(symbol)]; }
  template <class Symbols>
  VectorXd read(const Symbols& symbols) {
    VectorXd out(nv());
    Eigen::Index k = 0;
    for (const Coordinate& c : mechanism().coordinates)
      for (const Expr symbol : symbols(c)) out(k++) = at(symbol);
    return out;
  }

  LoadedMechanism loaded_;
  Kinematics kinematics_;
  ConstraintEquations equations_;
  std::vector<Expr> N_, poses_;
  std::vector<double> state_;
};

Constraint constraint(std::string name, ConstraintType type, std::vector<Expr> equations = {}) {
  Constraint c;
  c.name = std::move(name);
  c.type = type;
  c.equations = std::move(equations);
  return c;
}

/// velocity = P u + (part from time), its rate is P du/dt + gamma.
void expect_rates(ConstrainedMechanism& mechanism) {
  for (unsigned seed = 1; seed <= kConstrainedStates; ++seed) {
    mechanism.set_random_state(seed);
    const ConstraintEquations& equations = mechanism.equations();
    const VectorXd expected = mechanism.P() * mechanism.rates() + mechanism.value(equations.gamma);
    const VectorXd measured = mechanism.rate_of([&] { return mechanism.value(equations.velocity); });
    ASSERT_TRUE(expected.allFinite());
    EXPECT_GT(expected.norm(), 1e-3);
    EXPECT_LT((measured - expected).norm(), 1e-8 * (1 + expected.norm())) << "at state " << seed;
    const std::vector<ConstraintRow> rows = constraint_rows(mechanism.mechanism());
    const VectorXd rate = mechanism.rate_of([&] { return mechanism.value(equations.position); });
    const VectorXd velocity = mechanism.value(equations.velocity);
    for (Eigen::Index i = 0; i < velocity.size(); ++i) {
      const bool holonomic = rows[static_cast<std::size_t>(i)].type == ConstraintType::holonomic;
      EXPECT_NEAR(rate(i), holonomic ? velocity(i) : 0, 1e-8 * (1 + std::abs(velocity(i))));
    }
  }
}

/// An ellipsoid on an ellipsoid with spin; the lower one fixed, or carried about.
std::string ellipsoids(bool carried, const std::string& flip, const std::string& longitude = "u1") {
  const std::string coordinates = carried ? "a, b, {name: turn, type: quaternion}, " : "";
  const std::string carrier = carried ? R"(  - name: ground
    transform: [{translate: [a, 0.3, b]}, {rotate: {quaternion: turn}}, {rotate: {axis: [1, 2, 2], angle: a*b + t}}]
    mass: 2
    inertia: {xx: 1, yy: 1, zz: 1}
)"
                                      : "";
  std::string text =
      "alembert: 1\nname: rolling\ncoordinates: [" + coordinates +
      "{name: u1, initial: 0.3}, {name: v1, initial: 0.4}, {name: u2, initial: -0.5}, {name: v2, initial: "
      "0.2}, {name: s, initial: 0.7}]\nbodies:\n" +
      carrier + "  - name: ball\n    parent: " + (carried ? "ground" : "world") + R"(
    transform:
      - mate:
          - surface: {point: [2*cos(@)*cos(v1), 1.5*sin(@)*cos(v1), sin(v1)], along: [u1, v1]}
          - surface: {point: [0.5*cos(u2)*cos(v2), 0.4*sin(u2)*cos(v2), 0.3*sin(v2)], along: [u2, v2], flip: )" +
      flip + R"(}
        spin: s
    mass: 1
    com: [0.1, 0, 0.2]
    inertia: {xx: 1, yy: 1.2, zz: 1.4}
)";
  for (std::size_t at; (at = text.find('@')) != std::string::npos;) text.replace(at, 1, longitude);
  return text;
}

/// With rolling between the last body and its parent.
ConstrainedMechanism rolling(const std::string& description) {
  LoadedMechanism loaded = LoadedMechanism::text(description);
  Constraint roll = constraint("roll", ConstraintType::rolling);
  roll.body = static_cast<int>(loaded.mechanism->bodies.size()) - 1;
  loaded.mechanism->constraints.push_back(roll);
  return ConstrainedMechanism(std::move(loaded));
}

/// World velocities of the points of both bodies that touch are equal where P u + (part from time) = 0, and
/// differ by as much as the rows say elsewhere.
void expect_no_slip(ConstrainedMechanism& mechanism) {
  const int child = mechanism.mechanism().constraints[0].body;
  const Body& body = mechanism.mechanism().bodies[static_cast<std::size_t>(child)];
  const Mate mate = mate_at(body.transform, 0).value();
  const auto point = [&](const SurfaceFrame& surface) {
    const VectorXd p = mechanism.value(surface.point.entries);
    return Vector4d(p(0), p(1), p(2), 1);
  };
  // Slip in the world: velocity of the point of the child less that of the parent; points are fixed in their
  // bodies.
  const auto slip = [&] {
    const Vector4d first = point(mate.first), second = point(mate.second);
    return Vector4d(mechanism.rate_of(
        [&] { return Vector4d(mechanism.pose(child) * second - mechanism.pose(body.parent) * first); }));
  };
  for (unsigned seed = 1; seed <= kConstrainedStates; ++seed) {
    mechanism.set_random_state(seed);
    const Vector4d first = point(mate.first), second = point(mate.second);
    ASSERT_LT((mechanism.pose(child) * second - mechanism.pose(body.parent) * first).norm(), 1e-12);
    const VectorXd velocity = mechanism.value(mechanism.equations().velocity);
    ASSERT_GT(velocity.norm(), 1e-2);
    EXPECT_NEAR(slip().norm(), velocity.norm(), 1e-9) << "at state " << seed;

    const MatrixXd P = mechanism.P();
    mechanism.set_speeds(mechanism.speeds() - P.completeOrthogonalDecomposition().solve(velocity));
    ASSERT_LT(mechanism.value(mechanism.equations().velocity).norm(), 1e-12);
    EXPECT_GT(mechanism.speeds().norm(), 0.1);
    EXPECT_LT(slip().norm(), 1e-9) << "at state " << seed;
  }
}

class Rolling : public testing::TestWithParam<std::tuple<bool, const char*>> {
 protected:
  ConstrainedMechanism mechanism = rolling(ellipsoids(std::get<0>(GetParam()), std::get<1>(GetParam())));
};

TEST_P(Rolling, ThePointsThatTouchMoveTogether) {
  expect_no_slip(mechanism);
}

TEST_P(Rolling, RowsHaveTheirRates) {
  EXPECT_EQ(mechanism.rows(), 2);
  expect_rates(mechanism);
}

/// Rolling is between the two bodies: what carries both does not enter.
TEST_P(Rolling, OnlyTheMateMatters) {
  const MatrixXd P = mechanism.P();
  EXPECT_EQ(P.leftCols(mechanism.nv() - 5).cwiseAbs().sum(), 0);
  EXPECT_EQ(P.rightCols(1).cwiseAbs().sum(), 0) << "spin about the normal is no slip";
}

INSTANTIATE_TEST_SUITE_P(Ellipsoids, Rolling,
                         testing::Combine(testing::Bool(), testing::Values("false", "true")),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param) ? "OnMovingBody" : "OnWorld") +
                                  (std::string(std::get<1>(test.param)) == "true" ? "Flipped" : "");
                         });

/// A surface written with a further coordinate, so that its metric along u and v does not say it all.
TEST(RollingSurfaces, MayDependOnFurtherCoordinates) {
  for (const char* flip : {"false", "true"}) {
    ConstrainedMechanism mechanism = rolling(ellipsoids(true, flip, "(u1 + a*t/2)"));
    EXPECT_GT(mechanism.P().col(0).norm(), 0.01);
    expect_no_slip(mechanism);
    expect_rates(mechanism);
  }
}

/// Two bodies whose frames are held together, with quaternions, a shared coordinate and time.
TEST(Holonomic, FramesHeldTogether) {
  LoadedMechanism loaded = LoadedMechanism::text(R"(alembert: 1
name: closed
coordinates: [a, b, {name: p, type: quaternion}, {name: r, type: quaternion}]
bodies:
  - name: one
    transform: [{translate: [a, 0, b]}, {rotate: {quaternion: p}}]
    mass: 1
    inertia: {xx: 1, yy: 1, zz: 1}
  - name: two
    transform: [{rotate: {axis: y, angle: a + 0.5*t}}, {rotate: {quaternion: r}}]
    mass: 1
    inertia: {xx: 1, yy: 1, zz: 1}
frames:
  - {name: unused, body: one}
  - {name: tip, body: one, transform: [{translate: [0.3, 0.2, 0.1]}]}
  - {name: end, body: two, transform: [{translate: [0, -0.4, 0.2]}]}
)");
  Mechanism& m = *loaded.mechanism;
  ExprGraph& graph = *loaded.graph;
  for (const int frame : {1, 2}) {
    FrameSymbols position{FrameQuantity::position, frame, {}};
    for (const char axis : {'x', 'y', 'z'})
      position.symbols.push_back(
          graph.symbol("position(" + m.frames[static_cast<std::size_t>(frame)].name + ")." + axis));
    m.frame_symbols.push_back(position);
  }
  const auto vector = [](const std::vector<Expr>& x) -> Vec3 { return {{x[0], x[1], x[2]}}; };
  const Vec3 tip = vector(m.frame_symbols[0].symbols), end = vector(m.frame_symbols[1].symbols);
  const Expr a = m.coordinates[0].symbols[0];
  m.constraints.push_back(
      constraint("joined", ConstraintType::holonomic, {tip[0] - end[0], tip[1] - end[1], tip[2] - end[2]}));
  m.constraints.push_back(constraint("length", ConstraintType::holonomic, {dot(tip, tip) - sin(a) * m.time}));
  ConstrainedMechanism mechanism(std::move(loaded));
  EXPECT_EQ(mechanism.rows(), 4);
  EXPECT_EQ(constraint_rows(mechanism.mechanism())[2].name, "joined[2]");
  EXPECT_EQ(constraint_rows(mechanism.mechanism())[3].name, "length");
  expect_rates(mechanism);
  // position is what the poses say.
  const Vector4d difference =
      mechanism.pose(0) * Vector4d(0.3, 0.2, 0.1, 1) - mechanism.pose(1) * Vector4d(0, -0.4, 0.2, 1);
  EXPECT_LT((mechanism.value(mechanism.equations().position).head(3) - difference.head(3)).norm(), 1e-14);
}

TEST(Pfaffian, KnifeEdgeWithTime) {
  LoadedMechanism loaded = LoadedMechanism::text(kSleigh);
  Mechanism& m = *loaded.mechanism;
  const auto q = [&](std::size_t i) { return m.coordinates[i].symbols[0]; };
  const auto u = [&](std::size_t i) { return m.coordinates[i].speed_symbols[0]; };
  const Expr across = cos(q(2)) * u(1) - sin(q(2)) * u(0);
  m.constraints.push_back(constraint("edge", ConstraintType::pfaffian, {across}));
  m.constraints.push_back(constraint("driven", ConstraintType::pfaffian,
                                     {q(0) * (u(2) + q(1) * u(0)) - sin(q(1)) * m.time * m.time}));
  ConstrainedMechanism mechanism(std::move(loaded));
  const std::vector<Expr>& P = mechanism.equations().P;
  EXPECT_EQ(to_string(P[0]), "-sin(th)");
  EXPECT_EQ(to_string(P[1]), "cos(th)");
  EXPECT_TRUE(P[2].is_zero());
  EXPECT_EQ(to_string(P[5]), "x");
  expect_rates(mechanism);
}

TEST(Pfaffian, RowsThatAreNotLinearAreRefused) {
  for (const int wrong : {0, 1, 2}) {
    LoadedMechanism loaded = LoadedMechanism::text(kSleigh);
    Mechanism& m = *loaded.mechanism;
    const Expr ux = m.coordinates[0].speed_symbols[0], uy = m.coordinates[1].speed_symbols[0];
    const Expr row = wrong == 0 ? ux * uy : wrong == 1 ? ux * ux : sin(uy);
    m.constraints.push_back(constraint("bent", ConstraintType::pfaffian, {row}));
    m.constraints.back().where = m.bodies[0].where;
    const Kinematics kinematics = loaded.kinematics();
    try {
      constraint_equations(m, kinematics.tree, kinematics.derivatives, *loaded.graph);
      FAIL() << "row " << wrong << " is not linear";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("test.yaml:5:"));
      EXPECT_THAT(error.what(), testing::HasSubstr("'bent' is not linear in the speeds"));
    }
  }
}

TEST(Constraints, NoneGiveNoRows) {
  const LoadedMechanism loaded = LoadedMechanism::text(kSleigh);
  const Kinematics kinematics = loaded.kinematics();
  const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
  const std::vector<OutputExpressions> outputs =
      function_outputs(kinematics, equations, FunctionKind("constraints"));
  ASSERT_EQ(outputs.size(), 4u);
  for (const OutputExpressions& output : outputs) EXPECT_TRUE(output.values.empty());
  const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
  const Program program = schedule(lower("constraints", optimized(outputs), bindings));
  EXPECT_EQ(program.outputs.size(), 4u);
  EXPECT_NO_THROW(verify(program, outputs, bindings));
}

}  // namespace
}  // namespace alembert::test

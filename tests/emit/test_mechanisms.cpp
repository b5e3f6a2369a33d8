// The whole way for real descriptions: the library that was generated and compiled for a mechanism, against
// the interpreter running the programs it was written from, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <chain/chain.hpp>
#include <cstdint>
#include <five_bar/five_bar.hpp>
#include <free_body/free_body.hpp>
#include <memory>
#include <puma560/puma560.hpp>
#include <rolling_ellipsoids/rolling_ellipsoids.hpp>
#include <runtime_parameters/runtime_parameters.hpp>
#include <span>
#include <string>
#include <tree_every_joint/tree_every_joint.hpp>
#include <walker/walker.hpp>

#include "alembert/integrate.hpp"
#include "alembert/inverse_dynamics_derivatives.hpp"
#include "alembert/linearize.hpp"
#include "emit/emit.hpp"
#include "emit/interpreted_states.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"
#include "pipeline.hpp"
#include "program/loops/dot_products.hpp"
#include "program/loops/reroll.hpp"

namespace {

using alembert::FunctionKind;
using sample::expect_same_bits;
using sample::interpreted;
using sample::random_state;
using sample::State;

/// Rows of a matrix one after the other, as plain arrays have them.
template <class Matrix>
void append_rows(std::vector<double>& to, const Matrix& matrix) {
  for (Eigen::Index r = 0; r < matrix.rows(); ++r)
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) to.push_back(matrix(r, k));
}

template <class M>
alembert::CompiledMechanism check(const std::string& name, alembert::CompileOptions options = {}) {
  options.functions = {
      FunctionKind("inverse_dynamics"),     FunctionKind("mass_matrix"), FunctionKind("bias"),
      FunctionKind("mass_matrix_and_bias"), FunctionKind("energy"),      FunctionKind("coordinate_rates")};
  constexpr bool kForward = requires(const State<M>& s) {
    M::forward_dynamics(s.q, s.qd, s.qdd, s.in);
  };
  if constexpr (kForward) options.functions.push_back(FunctionKind("forward_dynamics"));
  constexpr bool kJacobians = requires(const State<M>& s) {
    M::body_jacobians(s.q, s.in);
  };
  if constexpr (kJacobians) options.functions.push_back(FunctionKind("body_jacobians"));
  typename M::SpeedMatrix tau_q, tau_qd;
  constexpr bool kDerivatives = requires(const State<M>& s) {
    M::inverse_dynamics_derivatives(s.q, s.qd, s.qdd, s.in, tau_q, tau_qd);
  };
  if constexpr (kDerivatives) options.functions.push_back(FunctionKind("inverse_dynamics_derivatives"));
  if constexpr (M::kNc > 0) {
    options.functions.insert(options.functions.end(),
                             {FunctionKind("constraints"), FunctionKind("body_inertias")});
  }
  const std::string path = std::string(ALEMBERT_SOURCE_DIR) + "/" + name + ".yaml";
  alembert::CompiledMechanism compiled = alembert::compile_mechanism(alembert::read_source(path), options);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const State<M> s = random_state<M>(seed);
    const auto compare = [&](FunctionKind kind, const auto& result) {
      const std::vector<double> expected = interpreted(compiled.function(kind).program, s);
      expect_same_bits({result.data(), static_cast<std::size_t>(result.size())}, expected, to_string(kind));
    };
    compare(FunctionKind("inverse_dynamics"), M::inverse_dynamics(s.q, s.qd, s.qdd, s.in));
    compare(FunctionKind("mass_matrix"), M::mass_matrix(s.q, s.in));
    compare(FunctionKind("bias"), M::bias(s.q, s.qd, s.in));
    compare(FunctionKind("energy"), M::energy(s.q, s.qd, s.in));
    if constexpr (kForward)
      compare(FunctionKind("forward_dynamics"), M::forward_dynamics(s.q, s.qd, s.qdd, s.in));
    compare(FunctionKind("coordinate_rates"), M::coordinate_rates(s.q, s.qd));
    typename M::SpeedMatrix mass;
    typename M::SpeedVector bias;
    M::mass_matrix_and_bias(s.q, s.qd, s.in, mass, bias);
    std::vector<double> both(mass.data(), mass.data() + mass.size());
    both.insert(both.end(), bias.data(), bias.data() + bias.size());
    compare(FunctionKind("mass_matrix_and_bias"), both);
    if constexpr (kJacobians) {
      std::vector<double> jacobians;
      append_rows(jacobians, M::body_jacobians(s.q, s.in));
      compare(FunctionKind("body_jacobians"), jacobians);
    }
    if constexpr (kDerivatives) {
      M::inverse_dynamics_derivatives(s.q, s.qd, s.qdd, s.in, tau_q, tau_qd);
      std::vector<double> derivatives;
      append_rows(derivatives, tau_q);
      append_rows(derivatives, tau_qd);
      compare(FunctionKind("inverse_dynamics_derivatives"), derivatives);
    }
    if constexpr (M::kNc > 0) {
      typename M::ConstraintMatrix P;
      typename M::ConstraintVector gamma, velocity, position;
      M::constraints(s.q, s.qd, s.in, P, gamma, velocity, position);
      std::vector<double> rows, inertias;
      append_rows(rows, P);
      append_rows(rows, gamma);
      append_rows(rows, velocity);
      append_rows(rows, position);
      compare(FunctionKind("constraints"), rows);
      append_rows(inertias, M::body_inertias(s.in));
      compare(FunctionKind("body_inertias"), inertias);
    }
  }
  return compiled;
}

TEST(CompiledMechanism, Puma560) {
  check<bits::puma560::Mechanism<>>("mechanisms/puma560");
}
TEST(CompiledMechanism, TreeWithEveryJoint) {
  check<bits::tree_every_joint::Mechanism<>>("mechanisms/tree_every_joint");
}
TEST(CompiledMechanism, ChainWithLoops) {
  alembert::CompileOptions options;
  options.loop_results = 6;
  options.loop_operations = 300;
  const auto compiled = check<bits::chain::Mechanism<>>("tests/emit/chain", options);
  for (const FunctionKind kind :
       {FunctionKind("mass_matrix"), FunctionKind("mass_matrix_and_bias"), FunctionKind("body_jacobians")})
    EXPECT_GT(alembert::dot_products(compiled.function(kind).program), 60u);
  for (const FunctionKind kind : {FunctionKind("inverse_dynamics"), FunctionKind("forward_dynamics")})
    EXPECT_GT(alembert::operations_in_loops(compiled.function(kind).program), 1000u);
}
TEST(CompiledMechanism, RuntimeParameters) {
  check<bits::runtime_parameters::Mechanism<>>("mechanisms/runtime_parameters");
}
TEST(CompiledMechanism, RollingEllipsoids) {
  using Model = bits::rolling_ellipsoids::Mechanism<>;
  EXPECT_EQ(Model::kNc, 2);
  EXPECT_STREQ(Model::kConstraintNames[1], "no_slip[1]");
  EXPECT_EQ(Model::kHolonomic, (std::array<bool, 2>{false, false}));
  check<Model>("mechanisms/paper/rolling_ellipsoids");
}
TEST(CompiledMechanism, FreeBody) {
  check<bits::free_body::Mechanism<>>("mechanisms/free_body");
}

/// A general chain by modified Denavit-Hartenberg parameters.
std::string revolute_chain(int joints) {
  const auto number = [](int k, int which) {  // 0.20 to 0.99
    return "0." + std::to_string(20 + (k * 37 + which * 23 + k * k * (which + 5)) % 80);
  };
  std::string coordinates, bodies;
  for (int k = 0; k < joints; ++k) {
    const std::string name = std::to_string(k);
    coordinates += "  - q" + name + "\n";
    bodies += "  - name: b" + name + "\n";
    if (k > 0) bodies += "    parent: b" + std::to_string(k - 1) + "\n";
    bodies += "    transform:\n      - rotate: {axis: x, angle: " + number(k, 1) + "}\n";
    bodies += "      - translate: [" + number(k, 2) + ", 0, 0]\n";
    bodies += "      - joint: {type: revolute, axis: z, coordinates: [q" + name + "]}\n";
    bodies += "      - translate: [0, 0, " + number(k, 3) + "]\n";
    bodies +=
        "    mass: 2\n    com: [" + number(k, 4) + ", 0.2, 0.1]\n    inertia: {xx: 0.2, yy: 0.21, zz: 0.22, ";
    bodies += "xy: 0.02, xz: 0.01, yz: 0.01}\n";
  }
  return "alembert: 1\nname: chain\ncoordinates:\n" + coordinates + "bodies:\n" + bodies;
}

/// A loop reads what another has left for the tables of dot products. That it finds it is checked while the
/// code is written.
TEST(CompiledMechanism, LoopsReadTables) {
  alembert::CompileOptions options;
  options.functions = {FunctionKind("inverse_dynamics_derivatives")};
  for (const int joints : {18, 22}) {  // of these the steps are factored alike
    const auto source = std::make_shared<const alembert::SourceText>(
        alembert::SourceText{"chain.yaml", revolute_chain(joints)});
    const alembert::CompiledMechanism compiled = alembert::compile_mechanism(source, options);
    const alembert::Program& program = compiled.functions[0].program;
    EXPECT_GE(program.loops.size(), 2u);
    EXPECT_GT(alembert::dot_products(program), 50u);
    EXPECT_NO_THROW(alembert::emit_mechanism(*compiled.mechanism, {&program, 1}, {}));
  }
}

/// Derivatives of the forward dynamics against its differences, quaternions turned about the body's axes.
template <class M>
void check_linearization() {
  constexpr double kStep = 1e-5;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const State<M> s = random_state<M>(seed);
    alembert::Linearization<M> out;
    ASSERT_EQ(alembert::linearize<M>(s.q, s.qd, s.qdd, s.in, out), alembert::Status::ok);
    const auto expect_difference = [&](const State<M>& up, const State<M>& down, const auto& derivative) {
      typename M::SpeedVector high, low;
      ASSERT_EQ(alembert::forward_dynamics<M>(up.q, up.qd, up.qdd, s.in, high), alembert::Status::ok);
      ASSERT_EQ(alembert::forward_dynamics<M>(down.q, down.qd, down.qdd, s.in, low), alembert::Status::ok);
      const double scale = 1 + derivative.cwiseAbs().maxCoeff() + high.cwiseAbs().maxCoeff();
      EXPECT_LT(((high - low) / (2 * kStep) - derivative).cwiseAbs().maxCoeff(), 1e-7 * scale);
    };
    for (int k = 0; k < M::kNv; ++k) {
      const typename M::SpeedVector step = kStep * M::SpeedVector::Unit(k);
      const typename M::CoordinateVector turn = M::coordinate_rates(s.q, step);
      State<M> up = s, down = s;
      up.q += turn;
      down.q -= turn;
      for (State<M>* moved : {&up, &down})
        ASSERT_EQ(alembert::normalize_quaternions<M>(moved->q), alembert::Status::ok);
      expect_difference(up, down, out.qdd_q.col(k));
      up = down = s;
      up.qd += step;
      down.qd -= step;
      expect_difference(up, down, out.qdd_qd.col(k));
      up = down = s;
      up.qdd += step;  // the state's qdd is the forces here
      down.qdd -= step;
      expect_difference(up, down, out.qdd_tau.col(k));
    }
  }
}
TEST(CompiledMechanism, LinearizationIsThatOfItsForwardDynamics) {
  check_linearization<bits::free_body::Mechanism<>>();
  check_linearization<bits::five_bar::Mechanism<>>();
  check_linearization<bits::rolling_ellipsoids::Mechanism<>>();
  check_linearization<bits::chain::Mechanism<>>();
  check_linearization<bits::walker::Mechanism<>>();
}

/// The same mechanism, of which linearize knows nothing but its functions.
template <class S>
struct PlainWalker : bits::walker::Mechanism<S> {};

template <class S>
void expect_same_linearization(double allowed) {
  using Walker = bits::walker::Mechanism<S>;
  using Plain = PlainWalker<S>;
  static_assert(alembert::detail::kByAxes<Walker>);
  static_assert(!alembert::detail::kByAxes<Plain>);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const State<bits::walker::Mechanism<>> s = random_state<bits::walker::Mechanism<>>(seed);
    typename Walker::CoordinateVector q = s.q.template cast<S>();
    // Far from the origin, and with a leg longer than the description's.
    if (seed % 2 == 0) q(Walker::Coordinate::x) += 1000;
    ASSERT_EQ(alembert::normalize_quaternions<Walker>(q), alembert::Status::ok);
    const typename Walker::SpeedVector qd = s.qd.template cast<S>(), tau = s.qdd.template cast<S>();
    typename Walker::Inputs in;
    in.parameters[Walker::Parameter::shank] = S(0.5);
    alembert::Linearization<Walker> found;
    alembert::Linearization<Plain> wanted;
    ASSERT_EQ(alembert::linearize<Walker>(q, qd, tau, in, found), alembert::Status::ok);
    ASSERT_EQ(alembert::linearize<Plain>(q, qd, tau, in, wanted), alembert::Status::ok);
    const auto expect_near = [&](const auto& x, const auto& y) {
      EXPECT_LT((x - y).cwiseAbs().maxCoeff(), allowed * y.cwiseAbs().maxCoeff()) << "seed " << seed;
    };
    expect_near(found.qdd, wanted.qdd);
    expect_near(found.qdd_q, wanted.qdd_q);
    expect_near(found.qdd_qd, wanted.qdd_qd);
    expect_near(found.qdd_tau, wanted.qdd_tau);
    typename Walker::SpeedVector by_bodies;
    ASSERT_EQ(alembert::detail::rates_by_bodies<Walker>(q, qd, tau, in, by_bodies), alembert::Status::ok);
    expect_near(by_bodies, wanted.qdd);
    typename Walker::SpeedMatrix tau_q, tau_qd, wanted_q, wanted_qd;
    ASSERT_EQ(alembert::inverse_dynamics_derivatives<Walker>(q, qd, tau, in, tau_q, tau_qd),
              alembert::Status::ok);
    Walker::inverse_dynamics_derivatives(q, qd, tau, in, wanted_q, wanted_qd);
    expect_near(tau_q, wanted_q);
    expect_near(tau_qd, wanted_qd);
    ASSERT_EQ(alembert::inverse_dynamics_derivatives<Plain>(q, qd, tau, in, tau_q, tau_qd),
              alembert::Status::ok);
    EXPECT_EQ(tau_q, wanted_q);
    EXPECT_EQ(tau_qd, wanted_qd);
  }
}
TEST(CompiledMechanism, LinearizationByAxesIsThatByGeneratedDerivatives) {
  expect_same_linearization<double>(1e-12);
  expect_same_linearization<float>(1e-4);
}
TEST(CompiledMechanism, FiveBar) {
  using Model = bits::five_bar::Mechanism<>;
  EXPECT_EQ(Model::kHolonomic, (std::array<bool, 2>{true, true}));
  check<Model>("mechanisms/paper/five_bar");
}

}  // namespace

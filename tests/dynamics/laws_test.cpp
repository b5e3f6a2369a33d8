// Laws that every mechanism of the catalogue obeys (the fifth net of tests): on expressions, at random
// states.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "differentiation/jacobian.hpp"
#include "differentiation/reverse.hpp"
#include "dynamics/by_complex_steps.hpp"
#include "dynamics/choice/base_parameters.hpp"
#include "dynamics/choice/regrouping.hpp"
#include "dynamics/function_builders.hpp"
#include "dynamics/mechanism_file.hpp"
#include "dynamics/recursions/armature.hpp"
#include "dynamics/recursions/articulated_bodies.hpp"
#include "dynamics/recursions/frame_values.hpp"
#include "dynamics/recursions/joint_reactions.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/rewrites/rigid_links.hpp"
#include "dynamics/rewrites/scaled_vectors.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/to_string.hpp"

namespace alembert::test {
namespace {

constexpr unsigned kStates = 8;

/// With sanitizers, without the search for fewer operations: it repeats the same code many times.
#ifndef __has_feature
#define __has_feature(x) 0
#endif
constexpr double kEffort = __has_feature(address_sanitizer) ? 0 : 1;
Passes passes() {
  Passes all;
  all.effort = kEffort;
  return all;
}

/// A mechanism and its equations.
struct Derivation {
  explicit Derivation(const std::string& path)
      : loaded(LoadedMechanism::file(path)),
        kinematics(loaded.kinematics()),
        equations(equations_of_motion(kinematics, Formulation::reduced, passes())) {}
  /// The same for all laws of a mechanism: most of their time is to derive it.
  static const Derivation& of(const std::string& path) {
    static std::map<std::string, Derivation> derived;
    return derived.try_emplace(path, path).first->second;
  }

  LoadedMechanism loaded;
  Kinematics kinematics;
  EquationsOfMotion equations;
};

class Laws : public testing::TestWithParam<std::string> {
 protected:
  /// Equal at random states, relative to the larger of 1 and the values. States where a value is not finite
  /// are skipped, but not all.
  void expect_equal(std::span<const Expr> x, std::span<const Expr> y, double tolerance = 1e-10) {
    ASSERT_EQ(x.size(), y.size());
    unsigned finite = 0;
    for (unsigned seed = 0; seed < kStates; ++seed) {
      const std::vector<double> a = loaded.values(x, seed), b = loaded.values(y, seed);
      double scale = 1;
      for (const double v : b) scale = std::max(scale, std::abs(v));
      if (!std::isfinite(scale)) continue;
      ++finite;
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i], b[i], tolerance * scale) << "entry " << i << " at state " << seed << "\n  "
                                                   << to_string(x[i]) << "\n  " << to_string(y[i]);
      }
    }
    EXPECT_GE(finite, kStates / 2);
  }

  /// Whether time moves a body by itself.
  bool moves_with_time() const {
    const std::vector<MotionNode>& nodes = kinematics.tree.nodes;
    return std::any_of(nodes.begin(), nodes.end(), [&](const MotionNode& node) {
      return !node.partials.empty() && node.partials.back().speed == loaded.mechanism->nv;
    });
  }

  const Derivation& derivation = Derivation::of(GetParam());
  const LoadedMechanism& loaded = derivation.loaded;
  const Kinematics& kinematics = derivation.kinematics;
  const EquationsOfMotion& equations = derivation.equations;
  const std::size_t nv = static_cast<std::size_t>(loaded.mechanism->nv);
};

/// Ten of each body, as the regressor's columns.
std::vector<Expr> standard_parameters(const Mechanism& mechanism) {
  std::vector<Expr> theta;
  for (const Body& body : mechanism.bodies) {
    const Expr m = body.mass_properties.mass;
    const Vec3& c = body.mass_properties.com;
    const Mat3& inertia = body.mass_properties.inertia;
    const Expr square = dot(c, c);
    const auto about_origin = [&](std::size_t i, std::size_t j) {
      return inertia(i, j) + m * (i == j ? square - c[i] * c[j] : -(c[i] * c[j]));
    };
    const std::array<Expr, 10> ten{m,
                                   m * c[0],
                                   m * c[1],
                                   m * c[2],
                                   about_origin(0, 0),
                                   about_origin(1, 1),
                                   about_origin(2, 2),
                                   about_origin(0, 1),
                                   about_origin(0, 2),
                                   about_origin(1, 2)};
    theta.insert(theta.end(), ten.begin(), ten.end());
  }
  return theta;
}

/// Names of the mechanisms of which time moves a body by itself.
const std::vector<std::string> kMovedByTime{"moving_base", "rolling_ball", "upper_body"};

bool is_moved_by_time(const std::string& path) {
  return std::ranges::count(kMovedByTime, test_name(path)) > 0;
}

TEST_P(Laws, TimeMovesThoseWhichAreSaidToBeMoved) {
  EXPECT_EQ(moves_with_time(), is_moved_by_time(GetParam()));
}

/// Laws of mechanisms on which nothing but forces does work.
class UnmovedLaws : public Laws {};

TEST_P(Laws, ForceIsMassTimesAccelerationPlusBias) {
  std::vector<Expr> composed = equations.c;
  for (std::size_t i = 0; i < nv; ++i) {
    for (std::size_t j = 0; j < nv; ++j)
      composed[i] += equations.M[i * nv + j] * kinematics.derivatives.rate(static_cast<int>(j));
  }
  expect_equal(equations.Q, composed);
}

TEST_P(Laws, MassMatrixIsTheCoefficientOfTheAccelerations) {
  expect_equal(equations.M, coefficient_mass_matrix(*loaded.mechanism, equations.Q));
}

TEST_P(Laws, CompositeBodiesGiveTheSameMassMatrix) {
  expect_equal(composite_mass_matrix(*loaded.mechanism, kinematics.tree, *loaded.graph), equations.M);
}

TEST_P(Laws, MassMatrixIsSymmetricAndPositiveDefinite) {
  const Eigen::Index n = loaded.mechanism->nv;
  unsigned positive = 0;
  for (unsigned seed = 1; seed <= kStates; ++seed) {
    const std::vector<double> values = loaded.values(equations.M, seed);
    const Eigen::Map<const Eigen::MatrixXd> M(values.data(), n, n);
    if (!M.allFinite()) continue;
    EXPECT_EQ(M, M.transpose());
    const Eigen::VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * M * scale.asDiagonal());
    EXPECT_GT(solver.eigenvalues()(0), -1e-12) << "at state " << seed;
    if (solver.eigenvalues()(0) > 1e-10) ++positive;
  }
  EXPECT_GE(positive, kStates - 2);
}

TEST_P(Laws, ReducedFormIsTheFactoredForm) {
  const EquationsOfMotion factored = equations_of_motion(kinematics, Formulation::factored);
  expect_equal(equations.Q, factored.Q);
  expect_equal(equations.M, factored.M);
  expect_equal(equations.c, factored.c);
}

TEST_P(Laws, BothMomentFormsAgree) {
  const auto by = [&](MomentForm form) {
    WrittenTree tree = kinematics.tree;
    for (MomentForms& forms : tree.moments) forms.fill(form);
    return reduced_inverse_dynamics(*loaded.mechanism, tree, *loaded.graph);
  };
  expect_equal(by(MomentForm::pseudo_inertia), by(MomentForm::inertia));
}

/// Peeling screws, placing frames, regrouping inertias and scaling vectors change how Q and M are written,
/// not what they are.
TEST_P(Laws, PeeledPlacedRegroupedAndScaledLinksGiveTheSameDynamics) {
  const std::vector<Expr> Q = reduced_inverse_dynamics(*loaded.mechanism, kinematics.tree, *loaded.graph);
  const std::vector<Expr> M = composite_mass_matrix(*loaded.mechanism, kinematics.tree, *loaded.graph);
  const auto expect_same = [&](const WrittenTree& tree) {
    expect_equal(reduced_inverse_dynamics(*loaded.mechanism, tree, *loaded.graph), Q, 1e-11);
    expect_equal(composite_mass_matrix(*loaded.mechanism, tree, *loaded.graph), M, 1e-11);
  };
  const auto expect_same_scaled = [&](WrittenTree written) {
    const std::vector<int> turns = scalable_turns(written.tree);
    written.scaling = Scaling(written.tree, turns);
    expect_same(written);
    written.scaling = Scaling(written.tree, turns, turns);
    expect_same(written);
  };
  std::vector<MotionTree> trees{kinematics.tree};
  if (kinematics.peeled) {
    trees.push_back(*kinematics.peeled);
    expect_same(*kinematics.peeled);
  }
  for (const MotionTree& tree : trees) {
    expect_same_scaled(tree);
    const RigidLinks links(*loaded.mechanism, tree, *loaded.graph);
    const std::vector<Regrouping> as_given(links.links().size());
    for (const std::vector<Regrouping>& how :
         {as_given, choose_regroupings(links), minimal_regroupings(links)}) {
      const WrittenTree placed = links.link_tree(how, *loaded.graph);
      expect_same(placed);
      expect_same_scaled(placed);
    }
  }
}

/// M^-1 (Q - c) are the rates. A coordinate that moves several bodies is taken where their branches meet, unless
/// others move bodies on the way.
TEST_P(Laws, ArticulatedBodiesGiveTheRates) {
  std::vector<Expr> right_side, rates;
  for (std::size_t k = 0; k < nv; ++k) {
    right_side.push_back(equations.Q[k] - equations.c[k]);
    rates.push_back(kinematics.derivatives.rate(static_cast<int>(k)));
  }
  std::vector<int> bodies_moved(nv, 0);
  for (const Body& body : loaded.mechanism->bodies) {
    std::vector<char> moves(nv, 0);
    for (const Motion& motion : elementary_motions(body.transform, *loaded.mechanism, *loaded.graph)) {
      for (const SpeedPartial& partial :
           twist_partials(motion, *loaded.mechanism, kinematics.derivatives, *loaded.graph))
        if (partial.speed < loaded.mechanism->nv) moves[static_cast<std::size_t>(partial.speed)] = 1;
    }
    for (std::size_t k = 0; k < nv; ++k) bodies_moved[k] += moves[k];
  }
  const bool shared = std::any_of(bodies_moved.begin(), bodies_moved.end(), [](int n) { return n != 1; });
  const auto solve = [&](const MotionTree& tree) {
    const auto solved = articulated_solve(*loaded.mechanism, tree, right_side, *loaded.graph);
    if (solved) expect_equal(*solved, rates, 1e-9);
    return solved.has_value();
  };
  // One coordinate turns a finger and a thumb there.
  const bool must = !shared || loaded.mechanism->name == "tree_every_joint";
  EXPECT_TRUE(solve(kinematics.tree) || !must);
  if (kinematics.peeled) {
    EXPECT_TRUE(solve(*kinematics.peeled) || !must);
  }
  // Regrouping may leave mass between two motions of one speed.
  solve(*equations.articulated);
}

/// d(T + V)/dt = u . Q where nothing else does work: no prescribed motion. The left side is the chain rule
/// over q and u, qdot = N u.
TEST_P(UnmovedLaws, EnergyChangesByThePowerOfTheForces) {
  const Mechanism& mechanism = *loaded.mechanism;
  const std::vector<Expr> energy = energies(mechanism, kinematics.tree, *loaded.graph);
  const std::vector<Expr> total{energy[0] + energy[1]};
  std::vector<Expr> variables, rates;
  const std::vector<Expr> N = kinematics.derivatives.coordinate_rate_matrix();
  std::size_t row = 0;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    for (const Expr symbol : coordinate.symbols) {
      variables.push_back(symbol);
      Expr sum = loaded.graph->zero();
      for (std::size_t k = 0; k < nv; ++k)
        sum += N[row * nv + k] * kinematics.derivatives.speed(static_cast<int>(k));
      rates.push_back(sum);
      ++row;
    }
  }
  for (const Coordinate& coordinate : mechanism.coordinates) {
    variables.insert(variables.end(), coordinate.speed_symbols.begin(), coordinate.speed_symbols.end());
    rates.insert(rates.end(), coordinate.rate_symbols.begin(), coordinate.rate_symbols.end());
  }
  const Jacobian gradient = jacobian_reverse(total, variables);
  Expr change = loaded.graph->zero();
  for (std::size_t i = 0; i < variables.size(); ++i) change += gradient(0, i) * rates[i];

  std::vector<std::pair<Expr, Expr>> no_wrench;
  for (const auto& [body, wrench] : wrench_symbols(mechanism, *loaded.graph))
    for (std::size_t i = 0; i < 6; ++i) no_wrench.emplace_back(wrench[i], loaded.graph->zero());
  std::vector<Expr> free_force = substitute(equations.Q, no_wrench);
  const std::vector<Expr>& applied = kinematics.applied.Q;
  for (std::size_t k = 0; k < applied.size(); ++k) free_force[k] += applied[k];
  Expr power = loaded.graph->zero();
  for (std::size_t k = 0; k < nv; ++k)
    power += kinematics.derivatives.speed(static_cast<int>(k)) * free_force[k];
  expect_equal(std::vector<Expr>{change}, std::vector<Expr>{power}, 1e-9);
}

/// Gravity forces are the slope of the potential energy along the speeds.
TEST_P(Laws, ReactionsWorkAlongTheJointsAsTheForcesDo) {
  const Mechanism& mechanism = *loaded.mechanism;
  const auto in_a_joint = [](const Force& force) { return force.kind == ForceKind::on_speed; };
  if (!std::ranges::all_of(mechanism.forces, in_a_joint)) GTEST_SKIP() << "forces act on bodies";
  ExprGraph& graph = kinematics.graph;
  std::vector<Expr> expected = equations.Q, found(nv, graph.zero());
  for (std::size_t k = 0; k < nv; ++k) {
    expected[k] -= armature_forces(mechanism)[k];
    if (!kinematics.applied.Q.empty()) expected[k] += kinematics.applied.Q[k];
  }
  const std::vector<Expr> w = joint_reactions(mechanism, kinematics.tree, kinematics.derivatives, graph);
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    Pose pose = identity_pose(graph);
    for (const Motion& motion : elementary_motions(mechanism.bodies[b].transform, mechanism, graph))
      pose = moved(pose, motion);
    std::vector<Expr> rows;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) rows.push_back(pose.rotation(r, c));
      rows.push_back(pose.origin[r]);
    }
    const Expr* of = &w[6 * b];
    const Wrench in_body{{{of[0], of[1], of[2]}}, {{of[3], of[4], of[5]}}};
    const Wrench in_parent{pose.rotation * in_body.moment, pose.rotation * in_body.force};
    for (const FrameTwist& along : frame_twists(kinematics.derivatives, rows))
      if (along.speed != kinematics.derivatives.time_index())
        found[static_cast<std::size_t>(along.speed)] += dot(along.twist, in_parent);
  }
  expect_equal(found, expected);
}

TEST_P(Laws, GravityIsTheSlopeOfThePotentialEnergy) {
  const std::vector<Expr> potential{energies(*loaded.mechanism, kinematics.tree, *loaded.graph)[1]};
  std::vector<Expr> slope(nv, loaded.graph->zero());
  for (const SpeedPartial& partial : kinematics.derivatives.partials(potential)) {
    if (partial.speed != kinematics.derivatives.time_index())
      slope[static_cast<std::size_t>(partial.speed)] = partial.values[0];
  }
  expect_equal(function_outputs(kinematics, equations, FunctionKind("gravity"))[0].values, slope, 1e-11);
}

/// dM/dt = C + C^T; and C u and gravity are the bias forces of the bodies, but for what is affine in the speeds: that
/// comes with time.
TEST_P(Laws, CoriolisMatrixMakesTheRateOfTheMassMatrixAndTheBias) {
  const std::vector<Expr> C =
      function_outputs(kinematics, equations, FunctionKind("coriolis_matrix"))[0].values;
  const SpeedDerivatives& derivatives = kinematics.derivatives;
  std::vector<Expr> both = C;
  for (std::size_t i = 0; i < nv; ++i)
    for (std::size_t j = 0; j < nv; ++j) both[i * nv + j] += C[j * nv + i];
  expect_equal(both, derivatives.first_rate(derivatives.partials(equations.M), nv * nv));

  std::vector<std::pair<Expr, Expr>> no_wrench, backward, at_rest;
  for (const auto& [body, wrench] : wrench_symbols(*loaded.mechanism, *loaded.graph))
    for (std::size_t i = 0; i < 6; ++i) no_wrench.emplace_back(wrench[i], loaded.graph->zero());
  std::vector<Expr> rest = substitute(equations.c, no_wrench);
  const std::vector<Expr> g = gravity_forces(*loaded.mechanism, kinematics.tree, *loaded.graph);
  for (std::size_t i = 0; i < nv; ++i) {
    if (!kinematics.applied.Q.empty()) rest[i] += kinematics.applied.Q[i];
    for (std::size_t j = 0; j < nv; ++j) rest[i] -= C[i * nv + j] * derivatives.speed(static_cast<int>(j));
    rest[i] -= g[i];
  }
  if (!moves_with_time()) return expect_equal(rest, std::vector<Expr>(nv, loaded.graph->zero()), 1e-9);
  for (std::size_t k = 0; k < nv; ++k) {
    const Expr u = derivatives.speed(static_cast<int>(k));
    backward.emplace_back(u, -u);
    at_rest.emplace_back(u, loaded.graph->zero());
  }
  const std::vector<Expr> reversed = substitute(rest, backward), resting = substitute(rest, at_rest);
  std::vector<Expr> twice_resting = resting;
  for (std::size_t i = 0; i < nv; ++i) {
    rest[i] += reversed[i];
    twice_resting[i] += resting[i];
  }
  expect_equal(rest, twice_resting, 1e-9);
}

/// Forces, gravity and energies are linear in masses, first moments and inertias about the bodies' origins.
TEST_P(Laws, RegressorsTimesTheParametersGiveForcesGravityAndEnergies) {
  const Mechanism& mechanism = *loaded.mechanism;
  const std::vector<Expr> theta = standard_parameters(mechanism);

  const auto times_theta = [&](FunctionKind kind) {
    const std::vector<Expr> Y = function_outputs(kinematics, equations, kind)[0].values;
    std::vector<Expr> product(Y.size() / theta.size(), loaded.graph->zero());
    for (std::size_t i = 0; i < Y.size(); ++i) product[i / theta.size()] += Y[i] * theta[i % theta.size()];
    return product;
  };
  std::vector<std::pair<Expr, Expr>> no_wrench;
  for (const auto& [body, wrench] : wrench_symbols(mechanism, *loaded.graph))
    for (std::size_t i = 0; i < 6; ++i) no_wrench.emplace_back(wrench[i], loaded.graph->zero());
  std::vector<Expr> forces = substitute(equations.Q, no_wrench);
  const std::vector<Expr>& applied = kinematics.applied.Q;
  for (std::size_t k = 0; k < applied.size(); ++k) forces[k] += applied[k];
  const std::vector<Expr> rotors = armature_forces(mechanism), inertias = armatures(mechanism);
  std::vector<Expr> energy = energies(mechanism, kinematics.tree, *loaded.graph);
  for (std::size_t k = 0; k < nv; ++k) {
    forces[k] -= rotors[k];
    const Expr u = kinematics.derivatives.speed(static_cast<int>(k));
    energy[0] -= loaded.graph->rational(Rational(1, 2)) * (inertias[k] * (u * u));
  }
  expect_equal(times_theta(FunctionKind("regressor")), forces);
  expect_equal(times_theta(FunctionKind("static_regressor")),
               gravity_forces(mechanism, kinematics.tree, *loaded.graph), 1e-11);
  expect_equal(times_theta(FunctionKind("energy_regressor")), energy, 1e-11);
}

/// With base parameters the columns of these alone give the same forces; and these columns are independent.
TEST_P(Laws, BaseParametersGiveTheForces) {
  const std::vector<Expr> Y = function_outputs(kinematics, equations, FunctionKind("regressor"))[0].values;
  const Mechanism& mechanism = *loaded.mechanism;
  const BaseParameters found = base_parameters(kinematics);
  const Eigen::Index n = mechanism.nv, all = static_cast<Eigen::Index>(Y.size()) / n,
                     count = static_cast<Eigen::Index>(found.base.size());
  Eigen::MatrixXd rest(0, all), base(0, count);
  for (unsigned seed = 1; base.rows() < 40 * n + 4 * count && seed < 2000; ++seed) {
    std::vector<double> state = state_values(mechanism, *loaded.graph, seed);
    state[loaded.graph->symbol_index(mechanism.time.ref().node())] = 0.3 * seed;
    const std::vector<double> values = evaluate(Y, state);
    if (!std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) continue;
    rest.conservativeResize(rest.rows() + n, Eigen::NoChange);
    rest.bottomRows(n) =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            values.data(), n, all);
    base.conservativeResize(rest.rows(), Eigen::NoChange);
  }
  ASSERT_GE(base.rows(), count);
  const Eigen::VectorXd sizes = rest.colwise().norm();
  // What is left of the columns once multiples of the base parameters' are taken off.
  for (std::size_t k = 0; k < found.base.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(found.base[k].parameter);
    base.col(static_cast<Eigen::Index>(k)) = rest.col(column);
    rest.col(column).setZero();
  }
  for (std::size_t k = 0; k < found.base.size(); ++k)
    for (const auto& [other, coefficient] : found.base[k].joined)
      rest.col(static_cast<Eigen::Index>(other)) -= coefficient * base.col(static_cast<Eigen::Index>(k));
  EXPECT_LE(rest.colwise().norm().maxCoeff(), 1e-9 * sizes.maxCoeff());
  for (const std::size_t parameter : found.without_effect)
    EXPECT_LE(sizes[static_cast<Eigen::Index>(parameter)], 1e-12 * sizes.maxCoeff());
  for (Eigen::Index k = 0; k < count; ++k) base.col(k).normalize();
  // The product bounds the largest singular value over the smallest from above.
  const Eigen::MatrixXd R =
      base.colPivHouseholderQr().matrixR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::MatrixXd inverse =
      R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(count, count));
  EXPECT_LT(R.norm() * inverse.norm(), 1e9) << count << " base parameters";
}

/// Kinetic energy of the bodies by their Jacobians and inertias: T = 1/2 sum m |v|^2 + om . R I R^T om.
TEST_P(UnmovedLaws, BodyJacobiansAndInertiasGiveTheKineticEnergy) {
  const Mechanism& mechanism = *loaded.mechanism;
  const std::vector<Expr> kinetic{energies(mechanism, kinematics.tree, *loaded.graph)[0]};
  const std::vector<Expr> J =
      function_outputs(kinematics, equations, FunctionKind("body_jacobians"))[0].values;
  const std::vector<Expr> inertias =
      function_outputs(kinematics, equations, FunctionKind("body_inertias"))[0].values;
  const std::vector<Expr> poses = body_poses(mechanism, kinematics.tree, *loaded.graph);
  ASSERT_EQ(J.size(), 6 * nv * mechanism.bodies.size());
  ASSERT_EQ(inertias.size(), 10 * mechanism.bodies.size());
  unsigned finite = 0;
  for (unsigned seed = 1; seed <= kStates; ++seed) {
    std::vector<Expr> speeds;
    for (std::size_t k = 0; k < nv; ++k) speeds.push_back(kinematics.derivatives.speed(static_cast<int>(k)));
    const std::vector<double> u = loaded.values(speeds, seed), Jv = loaded.values(J, seed),
                              Iv = loaded.values(inertias, seed), Wv = loaded.values(poses, seed);
    const double expected = loaded.values(kinetic, seed)[0];
    if (!std::isfinite(expected)) continue;
    ++finite;
    const std::vector<double> rotors = loaded.values(armatures(mechanism), seed);
    double sum = 0;
    for (std::size_t k = 0; k < nv; ++k) sum += rotors[k] * u[k] * u[k] / 2;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
      const auto n = static_cast<Eigen::Index>(nv);
      const Eigen::Matrix<double, 6, 1> twist =
          Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>>(&Jv[6 * nv * b], 6, n) *
          Eigen::Map<const Eigen::VectorXd>(u.data(), n);
      const Eigen::Matrix3d R =
          Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(&Wv[12 * b]).leftCols<3>();
      const double* i = &Iv[10 * b];
      Eigen::Matrix3d inertia;
      inertia << i[4], i[7], i[8], i[7], i[5], i[9], i[8], i[9], i[6];
      const Eigen::Vector3d om = R.transpose() * twist.head<3>();
      sum += 0.5 * i[0] * twist.tail<3>().squaredNorm() + 0.5 * om.dot(inertia * om);
    }
    EXPECT_NEAR(sum, expected, 1e-11 * (1 + std::abs(expected))) << "at state " << seed;
  }
  EXPECT_GE(finite, kStates / 2);
}

TEST_P(Laws, DerivativesOfTheForcesAreThoseByComplexSteps) {
  const std::vector<OutputExpressions> outputs =
      function_outputs(kinematics, equations, FunctionKind("inverse_dynamics_derivatives"));
  ASSERT_EQ(outputs.size(), 2U);
  std::vector<Expr> both = outputs[0].values;
  both.insert(both.end(), outputs[1].values.begin(), outputs[1].values.end());
  constexpr unsigned kFewStates = 3;
  EXPECT_GE(expect_force_derivatives(loaded, kinematics.derivatives, equations.Q, both, kFewStates), 2U);
}

/// Second derivatives are those of the first ones, summed with the same weights.
TEST_P(Laws, SecondDerivativesAreThoseOfTheFirstByComplexSteps) {
  constexpr std::size_t kMost = 7;
  if (nv > kMost) GTEST_SKIP() << "more than 7 speeds";
  ExprGraph& graph = *loaded.graph;
  const std::vector<OutputExpressions> first =
      function_outputs(kinematics, equations, FunctionKind("inverse_dynamics_derivatives"));
  const std::vector<OutputExpressions> second =
      function_outputs(kinematics, equations, FunctionKind("inverse_dynamics_second_derivatives"));
  ASSERT_EQ(second.size(), 4U);
  const auto summed = [&](const std::vector<Expr>& rows) {
    std::vector<Expr> sums(nv, graph.zero());
    for (std::size_t i = 0; i < nv; ++i)
      for (std::size_t k = 0; k < nv; ++k)
        sums[k] += mu_symbol(*loaded.mechanism, static_cast<int>(i), graph) * rows[i * nv + k];
    return sums;
  };
  std::vector<Expr> transposed;
  for (std::size_t k = 0; k < nv; ++k)
    for (std::size_t l = 0; l < nv; ++l) transposed.push_back(second[1].values[l * nv + k]);
  constexpr unsigned kFewStates = 2;
  const auto expect = [&](const std::vector<Expr>& of, const std::vector<Expr>& along,
                          const std::vector<Expr>& by_speeds) {
    std::vector<Expr> both = along;
    both.insert(both.end(), by_speeds.begin(), by_speeds.end());
    EXPECT_GE(expect_force_derivatives(loaded, kinematics.derivatives, of, both, kFewStates), 1U);
  };
  expect(summed(first[0].values), second[0].values, second[1].values);
  expect(summed(first[1].values), transposed, second[2].values);
  expect(
      summed(equations.M),
      [&] {
        std::vector<Expr> columns;
        for (std::size_t k = 0; k < nv; ++k)
          for (std::size_t l = 0; l < nv; ++l) columns.push_back(second[3].values[l * nv + k]);
        return columns;
      }(),
      std::vector<Expr>(nv * nv, graph.zero()));
}

/// Solving for the accelerations by the straight-line factorisation gives back the forces.
TEST_P(Laws, ForwardDynamicsInvertsInverseDynamics) {
  const std::vector<OutputExpressions> outputs =
      function_outputs(kinematics, equations, FunctionKind("forward_dynamics"));
  const std::vector<SymbolBinding> bindings = symbol_bindings(*loaded.mechanism, *loaded.graph);
  unsigned finite = 0;
  for (unsigned seed = 1; seed <= kStates; ++seed) {
    std::vector<double> state = state_values(*loaded.mechanism, *loaded.graph, seed);
    const auto value = [&](ArgumentKind kind, std::size_t index) -> double& {
      for (const SymbolBinding& binding : bindings) {
        if (binding.slot.kind == kind && binding.slot.index == index)
          return state[loaded.graph->symbol_index(binding.symbol.ref().node())];
      }
      throw std::logic_error("no such slot");
    };
    const std::vector<double> tau = evaluate(equations.Q, state);
    for (std::size_t k = 0; k < nv; ++k) value(ArgumentKind::tau, k) = tau[k];
    const std::vector<double> qdd = evaluate(outputs[0].values, state);
    const std::vector<double> M = evaluate(equations.M, state);
    if (!std::all_of(qdd.begin(), qdd.end(), [](double v) { return std::isfinite(v); })) continue;
    const Eigen::Map<const Eigen::MatrixXd> matrix(M.data(), static_cast<Eigen::Index>(nv),
                                                   static_cast<Eigen::Index>(nv));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const double condition = solver.eigenvalues().tail(1)(0) / solver.eigenvalues()(0);
    if (!(condition > 0 && condition < 1e8)) continue;
    ++finite;
    for (std::size_t k = 0; k < nv; ++k)
      EXPECT_NEAR(qdd[k], value(ArgumentKind::qdd, k), 1e-13 * condition * 100) << "at state " << seed;
  }
  EXPECT_GE(finite, 1u);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Laws, testing::ValuesIn(catalogue()),
                         [](const auto& test) { return test_name(test.param); });
INSTANTIATE_TEST_SUITE_P(Catalogue, UnmovedLaws,
                         testing::ValuesIn(catalogue_where(std::not_fn(is_moved_by_time))),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace alembert::test

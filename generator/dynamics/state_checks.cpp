// Checks that need numbers (see the header).
#include "dynamics/state_checks.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "dynamics/equations.hpp"
#include "dynamics/motion_tree.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Uniform in [-1, 1), the same on every platform (std::uniform_real_distribution is not).
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0;
}

}  // namespace

std::vector<double> state_values(const Mechanism& mechanism, ExprGraph& graph, unsigned seed) {
  std::mt19937_64 random(seed);
  const double spread = seed == 0 ? 0.0 : 1.0;
  std::vector<double> values(graph.symbol_count(), 0.0);
  for (double& value : values) value = spread * uniform(random);
  const auto set = [&](Expr symbol, double value) {
    values[graph.symbol_index(symbol.ref().node())] = value;
  };
  for (const Coordinate& coordinate : mechanism.coordinates) {
    double norm = 0;
    std::vector<double> q = coordinate.initial;
    for (double& x : q) {
      x += spread * uniform(random);
      if (coordinate.limits) x = std::clamp(x, coordinate.limits->first, coordinate.limits->second);
      norm += x * x;
    }
    for (std::size_t a = 0; a < q.size(); ++a) {
      set(coordinate.symbols[a],
          coordinate.type == CoordinateType::quaternion && norm > 0 ? q[a] / std::sqrt(norm) : q[a]);
    }
  }
  set(mechanism.time, 0.0);
  for (const Parameter& parameter : mechanism.parameters) {
    if (parameter.runtime) set(graph.symbol(parameter.name), parameter.value);
  }
  return values;
}

void check_transforms(const Mechanism& mechanism, ExprGraph& graph) {
  const auto check = [&](const Transform& transform, const std::string& owner) {
    for (const Factor& factor : transform.factors) {
      Pose pose = identity_pose(graph);
      for (const Motion& motion : elementary_motions(Transform{{factor}}, mechanism, graph))
        pose = moved(std::move(pose), motion);
      std::vector<Expr> entries(pose.rotation.entries.begin(), pose.rotation.entries.end());
      entries.insert(entries.end(), pose.origin.entries.begin(), pose.origin.entries.end());
      const std::vector<double> values = evaluate(entries, state_values(mechanism, graph, 0));
      if (all_finite(values)) continue;
      const CurveFrame* curve = std::get_if<CurveFrame>(&factor.value);
      if (curve != nullptr && !curve->reference) {
        throw InputError(factor.where, "the Frenet frame of the curve of " + owner +
                                           " is undefined at the initial value of '" +
                                           to_string(curve->along) +
                                           "' (an inflection or a straight part); use `frame: {reference: "
                                           "[x, y, z]}`, or another initial value");
      }
      throw InputError(factor.where,
                       "the transform of " + owner +
                           " has no value at the initial state (a frame that is singular there, "
                           "or a division by zero); choose another initial value");
    }
  };
  for (const Body& body : mechanism.bodies) check(body.transform, "body '" + body.name + "'");
  for (const Frame& frame : mechanism.frames) check(frame.transform, "frame '" + frame.name + "'");
}

const Coordinate* coordinate_without_inertia(const Mechanism& mechanism, std::span<const double> values) {
  constexpr double kSingular = 1e-13;  // smallest eigenvalue of M scaled to a unit diagonal
  const Eigen::Index n = mechanism.nv;
  const Eigen::Map<const Eigen::MatrixXd> M(values.data(), n, n);
  const double largest = M.diagonal().cwiseAbs().maxCoeff();
  const Eigen::VectorXd diagonal = M.diagonal();
  Eigen::Index culprit = 0;
  if (diagonal.minCoeff(&culprit) > 1e-15 * largest) {
    const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * M * scale.asDiagonal());
    if (solver.eigenvalues()(0) > kSingular) return nullptr;
    solver.eigenvectors().col(0).cwiseAbs().maxCoeff(&culprit);
  }
  return &*std::find_if(mechanism.coordinates.begin(), mechanism.coordinates.end(),
                        [&](const Coordinate& c) { return culprit < c.first_speed + c.nv(); });
}

void check_mass_matrix(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  const Mechanism& mechanism = kinematics.mechanism;
  const Coordinate* culprit = nullptr;
  for (const unsigned seed : {0u, 1u, 2u, 3u, 4u}) {
    const std::vector<double> values = evaluate(equations.M, state_values(mechanism, kinematics.graph, seed));
    if (!all_finite(values)) continue;
    culprit = coordinate_without_inertia(mechanism, values);
    if (culprit == nullptr) return;
  }
  if (culprit == nullptr) {
    throw InputError(mechanism.where, "the mass matrix has no finite value at the initial state nor near it");
  }
  throw SingularMassMatrix(
      culprit->where,
      "the mass matrix is singular: nothing with mass or inertia moves with coordinate '" + culprit->name +
          "' alone; give a mass or an inertia to what it moves",
      "or give '" + culprit->name +
          "' an `armature` (a rotor's inertia), put a constant in its place, or leave it out with what "
          "it moves; `alembert import --massless` does each of these");
}

}  // namespace alembert

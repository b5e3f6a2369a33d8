// Checks that need numbers (see the header).
#include "dynamics/checks/state_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "dynamics/checks/plain_equations.hpp"
#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "dynamics/tree/frame_checks.hpp"
#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/state_values.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

std::vector<double> state_in_range(const Kinematics& kinematics, unsigned k) {
  std::mt19937_64 random(1000 + k);
  static constexpr double kSpreads[] = {1, 3, 1e-3, 30, 1}, kSpeeds[] = {1, 5, 1, 1, 0};
  const double spread = kSpreads[k % 5], speed = kSpeeds[k % 5];
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  std::vector<double> values(graph.symbol_count(), 0.0);
  const auto set = [&](Expr symbol, double value) {
    values[graph.symbol_index(symbol.ref().node())] = value;
  };
  for (const Coordinate& coordinate : mechanism.coordinates) {
    std::vector<double> q = coordinate.initial;
    double norm = 0;
    for (double& x : q) {
      const double r = uniform(random);
      x += spread * r;
      if (coordinate.limits) {
        const auto [lower, upper] = *coordinate.limits;
        // Over all of the range, where it is one.
        if (spread >= 1 && std::isfinite(lower) && std::isfinite(upper))
          x = lower + (upper - lower) * (0.5 + 0.5 * r);
        x = std::clamp(x, lower, upper);
      }
      norm += x * x;
    }
    for (std::size_t a = 0; a < q.size(); ++a)
      set(coordinate.symbols[a],
          coordinate.type == CoordinateType::quaternion ? q[a] / std::sqrt(norm) : q[a]);
  }
  for (int i = 0; i < mechanism.nv; ++i) {
    set(kinematics.derivatives.speed(i), speed * uniform(random));
    set(kinematics.derivatives.rate(i), uniform(random));
    set(tau_symbol(mechanism, i, graph), uniform(random));
  }
  for (const auto& [body, wrench] : wrench_symbols(mechanism, graph)) {
    for (const Expr e : wrench.force.entries) set(e, uniform(random));
    for (const Expr e : wrench.moment.entries) set(e, uniform(random));
  }
  set(mechanism.time, k % 5 == 2 ? 0.0 : 5 + 5 * uniform(random));
  for (const Parameter& parameter : mechanism.parameters) {
    if (!parameter.runtime) continue;
    const double r = uniform(random);
    set(graph.symbol(parameter.name), parameter.value == 0 ? 0.1 * r : parameter.value * (1 + 0.3 * r));
  }
  for (int i = 0; i < mechanism.nv; ++i) set(mu_symbol(mechanism, i, graph), uniform(random));
  return values;
}

namespace {

/// Cholesky factors of M scaled to a unit diagonal, the largest pivot first: where what is left is no more
/// than `least`, M is singular. Scaled, so that a mirror of milligrams may ride on a stage of tonnes.
template <class Matrix>
std::optional<WithoutInertia> smallest_pivot(const Mechanism& mechanism, Matrix M, double least) {
  using Real = typename Matrix::Scalar;
  using std::sqrt;
  const Eigen::Index n = M.rows();
  const auto found = [&](Eigen::Index k, double fraction) {
    const auto coordinate = std::find_if(mechanism.coordinates.begin(), mechanism.coordinates.end(),
                                         [&](const Coordinate& c) { return k < c.first_speed + c.nv(); });
    return WithoutInertia{&*coordinate, fraction};
  };
  Eigen::Matrix<Real, Eigen::Dynamic, 1> scale(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!(M(k, k) > 0)) return found(k, 0);
    scale[k] = 1 / sqrt(M(k, k));
  }
  for (Eigen::Index r = 0; r < n; ++r) {
    for (Eigen::Index c = 0; c < n; ++c) M(r, c) *= scale[r] * scale[c];
  }
  std::vector<Eigen::Index> left;
  for (Eigen::Index k = 0; k < n; ++k) left.push_back(k);
  while (!left.empty()) {
    const auto pivot = std::max_element(left.begin(), left.end(),
                                        [&](Eigen::Index x, Eigen::Index y) { return M(x, x) < M(y, y); });
    const Eigen::Index k = *pivot;
    if (!(M(k, k) > least)) return found(k, std::max(0.0, static_cast<double>(M(k, k))));
    left.erase(pivot);
    for (const Eigen::Index r : left) {
      const Real factor = M(r, k) / M(k, k);
      for (const Eigen::Index c : left) M(r, c) -= factor * M(k, c);
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<WithoutInertia> coordinate_without_inertia(const Mechanism& mechanism,
                                                         std::span<const double> values) {
  const Eigen::Index n = mechanism.nv;
  const double least = static_cast<double>(n) * 0x1p-52;
  return smallest_pivot(mechanism, Eigen::MatrixXd(Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n)),
                        least);
}

std::optional<WithoutInertia> light_coordinate(const Kinematics& kinematics, const PlainEquations& plain,
                                               double least) {
  const Mechanism& mechanism = kinematics.mechanism;
  std::optional<WithoutInertia> lightest;
  // Where nothing is near the initial state there may be something elsewhere.
  std::vector<std::vector<double>> states;
  for (unsigned k = 0; k < 5; ++k) states.push_back(state_values(mechanism, kinematics.graph, k));
  for (unsigned k = 0; k < 10; ++k) states.push_back(state_in_range(kinematics, k));
  for (const std::vector<double>& state : states) {
    const MatrixXe M = plain.mass_matrix(plain.state(state));
    if (!std::all_of(M.reshaped().begin(), M.reshaped().end(), [](const Extended& x) { return isfinite(x); }))
      continue;
    lightest = smallest_pivot(mechanism, M, least);
    if (!lightest) return {};
  }
  if (!lightest) {
    throw InputError(mechanism.where, "the mass matrix has no finite value at the initial state nor near it");
  }
  return lightest;
}

void check_mass_matrix(const Kinematics& kinematics, const PlainEquations& plain, double least) {
  const std::optional<WithoutInertia> culprit = light_coordinate(kinematics, plain, least);
  if (!culprit) return;
  const std::string& name = culprit->coordinate->name;
  throw SingularMassMatrix(
      culprit->coordinate->where,
      "the mass matrix is singular: nothing with mass or inertia moves with coordinate '" + name + "' alone" +
          (culprit->fraction > 0
               ? fmt::format(" (what is left of its inertia while the others move is {:.1g} of it)",
                             culprit->fraction)
               : std::string()) +
          "; give a mass or an inertia to what it moves",
      "or give '" + name +
          "' an `armature` (a rotor's inertia), put a constant in its place, or leave it out with what "
          "it moves; `alembert import --massless` does each of these");
}

}  // namespace alembert

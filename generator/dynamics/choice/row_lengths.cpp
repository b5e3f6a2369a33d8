// Lengths of rows (see the header).
#include "dynamics/choice/row_lengths.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "dynamics/tree/state_values.hpp"
#include "support/inverse_diagonal.hpp"
#include "symbolic/error_bound.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

constexpr unsigned kStates = 4;
// No power of two, which rows often are apart, lies where rounding changes.
constexpr double kOffCentre = 0.137;

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The diagonal of M's inverse; empty where M has none. M = D C D with D the square roots of M's diagonal, so that
/// speeds of all units are alike.
Eigen::VectorXd scaled_inverse_diagonal(std::span<const double> values, Eigen::Index nv) {
  const Eigen::Map<const RowMajorMatrix> M(values.data(), nv, nv);
  const Eigen::VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
  const std::optional<Eigen::VectorXd> of_scaled =
      inverse_diagonal(scale.asDiagonal() * M * scale.asDiagonal());
  if (!of_scaled) return {};
  return of_scaled->cwiseProduct(scale.cwiseAbs2());
}

/// Their logarithms to base 2 at a state; -infinity for rows of zeros. Empty where M is singular.
Eigen::VectorXd logarithms(const ConstraintEquations& rows, const std::vector<Expr>& M,
                           std::span<const double> state, Eigen::Index nv) {
  const Eigen::VectorXd weights = scaled_inverse_diagonal(evaluate(M, state), nv);
  if (weights.size() == 0) return {};
  const std::vector<Approximate> entries = evaluate_bounded(rows.P, state);
  Eigen::VectorXd out(static_cast<Eigen::Index>(rows.position.size()));
  for (Eigen::Index r = 0; r < out.size(); ++r) {
    double squares = 0;
    for (Eigen::Index k = 0; k < nv; ++k) {
      const double terms = terms_of(entries[static_cast<std::size_t>(r * nv + k)]);
      squares += terms * terms * weights(k);
    }
    out(r) = 0.5 * std::log2(squares);
  }
  return out;
}

/// 2 to the median of exponents, rounded; 1 of none. The median, not the mean: at a state where a row is only rounding, as
/// the row of a distance is where the distance is largest or least, a fit says nothing.
double median_power(std::vector<double> exponents) {
  if (exponents.empty()) return 1;
  std::ranges::sort(exponents);
  const std::size_t middle = exponents.size() / 2;
  const double median =
      exponents.size() % 2 == 1 ? exponents[middle] : 0.5 * (exponents[middle - 1] + exponents[middle]);
  return std::exp2(std::round(median + kOffCentre));
}

}  // namespace

std::vector<double> row_weights(const Kinematics& kinematics, const ConstraintEquations& rows,
                                const std::vector<Expr>& M) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv), count = rows.position.size();
  std::vector<std::vector<double>> exponents(count);  // of each row, at the states
  for (unsigned seed = 0; seed < kStates; ++seed) {
    const std::vector<double> state = state_values(kinematics.mechanism, kinematics.graph, seed);
    const std::vector<double> inertia = evaluate(M, state), P = evaluate(rows.P, state);
    for (std::size_t r = 0; r < count; ++r) {
      double fit = 0, fourth = 0;
      for (std::size_t k = 0; k < nv; ++k) {
        const double square = P[r * nv + k] * P[r * nv + k];
        fit += inertia[k * nv + k] * square;
        fourth += square * square;
      }
      const double exponent = std::log2(fit / fourth);
      if (std::isfinite(exponent)) exponents[r].push_back(exponent);
    }
  }
  std::vector<double> weights;
  for (const std::vector<double>& of : exponents) weights.push_back(median_power(of));
  return weights;
}

std::vector<double> typical_inertias(const Kinematics& kinematics, const ConstraintEquations& rows,
                                     const std::vector<Expr>& M, std::span<const double> weights) {
  const double least = std::exp2(-40);
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  std::vector<std::vector<double>> exponents(nv);  // of each speed, at the states
  for (unsigned seed = 0; seed < kStates; ++seed) {
    const std::vector<double> state = state_values(kinematics.mechanism, kinematics.graph, seed);
    const std::vector<double> inertia = evaluate(M, state), P = evaluate(rows.P, state);
    for (std::size_t k = 0; k < nv; ++k) {
      double of_rows = 0;
      for (std::size_t r = 0; r < weights.size(); ++r) of_rows += weights[r] * P[r * nv + k] * P[r * nv + k];
      const double exponent = std::log2(std::max(inertia[k * nv + k], least * of_rows));
      if (std::isfinite(exponent)) exponents[k].push_back(exponent);
    }
  }
  std::vector<double> out;
  for (const std::vector<double>& of : exponents) out.push_back(median_power(of));
  return out;
}

std::vector<double> row_lengths(const Kinematics& kinematics, const ConstraintEquations& rows,
                                const std::vector<Expr>& M) {
  // Exponents of two.
  constexpr double kAlike = -12.7;
  constexpr double kLeast = -60;  // single precision holds its square and that square's inverse
  const Eigen::Index count = static_cast<Eigen::Index>(rows.position.size());
  std::vector<double> lengths(rows.position.size(), 1.0);
  if (count < 2) return lengths;
  constexpr double kMinusInfinity = -std::numeric_limits<double>::infinity();
  Eigen::VectorXd largest = Eigen::VectorXd::Constant(count, kMinusInfinity);
  for (unsigned seed = 0; seed < kStates; ++seed) {
    const Eigen::VectorXd here = logarithms(
        rows, M, state_values(kinematics.mechanism, kinematics.graph, seed), kinematics.mechanism.nv);
    for (Eigen::Index r = 0; r < here.size(); ++r)
      if (std::isfinite(here(r))) largest(r) = std::max(largest(r), here(r));
  }
  const double longest = largest.maxCoeff();
  for (Eigen::Index r = 0; r < count; ++r) {
    if (!std::isfinite(largest(r))) continue;
    const double exponent = largest(r) - longest;
    if (exponent < kAlike)
      lengths[static_cast<std::size_t>(r)] =
          std::ldexp(1.0, static_cast<int>(std::max(std::round(exponent + kOffCentre), kLeast)));
  }
  return lengths;
}

}  // namespace alembert

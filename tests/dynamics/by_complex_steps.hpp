// Derivatives of forces by complex steps, which share nothing with those under test but the forces.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "differentiation/complex_evaluation.hpp"
#include "dynamics/mechanism_file.hpp"

namespace alembert::test {

/// D_l Q_k, then dQ_k/du_l (nv x nv each, row major), at a state.
inline std::vector<double> force_derivatives_by_complex_steps(const Mechanism& mechanism,
                                                              const SpeedDerivatives& derivatives,
                                                              std::span<const Expr> Q,
                                                              std::span<const double> state) {
  std::vector<Expr> coordinates, speeds;
  for (const Coordinate& coordinate : mechanism.coordinates)
    coordinates.insert(coordinates.end(), coordinate.symbols.begin(), coordinate.symbols.end());
  for (int k = 0; k < mechanism.nv; ++k) speeds.push_back(derivatives.speed(k));
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const std::vector<double> by_q = complex_step(Q, coordinates, state);
  const std::vector<double> N = evaluate(derivatives.coordinate_rate_matrix(), state);
  const Matrix along = Eigen::Map<const Matrix>(by_q.data(), mechanism.nv, mechanism.nq) *
                       Eigen::Map<const Matrix>(N.data(), mechanism.nq, mechanism.nv);
  std::vector<double> both(along.data(), along.data() + along.size());
  const std::vector<double> by_speeds = complex_step(Q, speeds, state);
  both.insert(both.end(), by_speeds.begin(), by_speeds.end());
  return both;
}

/// `found` (2 nv x nv) at random states. Returns in how many of them all was finite.
inline unsigned expect_force_derivatives(const LoadedMechanism& loaded, const SpeedDerivatives& derivatives,
                                         std::span<const Expr> Q, std::span<const Expr> found,
                                         unsigned states) {
  unsigned finite = 0;
  for (unsigned seed = 0; seed < states; ++seed) {
    const std::vector<double> state = state_values(*loaded.mechanism, *loaded.graph, seed);
    const std::vector<double> expected =
        force_derivatives_by_complex_steps(*loaded.mechanism, derivatives, Q, state);
    const std::vector<double> values = evaluate(found, state);
    EXPECT_EQ(values.size(), expected.size());
    double scale = 1;
    for (const double v : expected) scale = std::max(scale, std::abs(v));
    if (values.size() != expected.size() || !std::isfinite(scale)) continue;
    ++finite;
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(values[i], expected[i], 1e-10 * scale) << "entry " << i << " at state " << seed;
  }
  return finite;
}

}  // namespace alembert::test

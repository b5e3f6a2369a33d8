// By an orthonormal basis of the rows in the metric of M^-1 (see the header).
#include "oracles/taylor/constrained_functions.hpp"

#include <Eigen/Dense>
#include <limits>

#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

/// M x = f + P^T y, P x = g over the rows that do not follow from those before them, and are not rounding: a row that is
/// far shorter than the others is one only if double precision knows it.
template <class R>
class BorderedSystem {
 public:
  BorderedSystem(const MatrixOf<R>& M, const MatrixOf<R>& P, const MatrixOf<R>& rounding) : root_(M), P_(P) {
    // M = L L^T; the columns of B = L^-1 P^T are orthonormalised one after another, twice each.
    const MatrixOf<R> B = root_.matrixL().solve(MatrixOf<R>(P.transpose()));
    const MatrixOf<R> unknown = root_.matrixL().solve(MatrixOf<R>(rounding.transpose()));
    const double bound =
        16 * static_cast<double>(std::max(P.rows(), P.cols())) * std::numeric_limits<double>::epsilon();
    Q_.resize(B.rows(), 0);
    for (Eigen::Index r = 0; r < B.cols(); ++r) {
      VectorOf<R> left = B.col(r);
      for (int pass = 0; pass < 2; ++pass) left -= Q_ * (Q_.transpose() * left);
      if (!(left.squaredNorm() > R(bound) * B.col(r).squaredNorm())) continue;
      const R square = B.col(r).squaredNorm();
      const bool known = unknown.col(r).squaredNorm() < R(1e-12) * square;
      if (!known && !(square > R(16 * bound * bound) * B.squaredNorm())) continue;
      Q_.conservativeResize(Eigen::NoChange, Q_.cols() + 1);
      Q_.col(Q_.cols() - 1) = left.normalized();
      kept_.push_back(r);
    }
    T_ = Q_.transpose() * B(Eigen::all, kept_);  // upper triangular: B = Q T
  }

  /// x below y.
  std::pair<VectorOf<R>, VectorOf<R>> solve(const VectorOf<R>& f, const VectorOf<R>& g) const {
    const VectorOf<R> free = root_.matrixL().solve(f);
    const auto triangle = T_.template triangularView<Eigen::Upper>();
    const VectorOf<R> wanted = g(kept_);
    const VectorOf<R> along = triangle.transpose().solve(wanted);
    const VectorOf<R> lack = along - Q_.transpose() * free;
    VectorOf<R> y = VectorOf<R>::Zero(P_.rows());
    const VectorOf<R> of_kept = triangle.solve(lack);
    y(kept_) = of_kept;
    return {root_.matrixU().solve(VectorOf<R>(free + Q_ * lack)), y};
  }

 private:
  Eigen::LLT<MatrixOf<R>> root_;
  MatrixOf<R> P_, Q_, T_;
  std::vector<Eigen::Index> kept_;
};

template <class R>
struct Solution {
  BorderedSystem<R> system;
  VectorOf<R> rates, multipliers;
};

template <class R>
Solution<R> solution(const Description& description, const State& state, const DynamicsOf<R>& dynamics) {
  const ConstraintRowsOf<R> rows = numeric_constraints<R>(description, state);
  const auto exact = numeric_constraints<long double>(description, state).P;
  const auto rounded = numeric_constraints<double>(description, state).P;
  const MatrixOf<long double> rounding = exact - rounded.cast<long double>();
  BorderedSystem<R> system(dynamics.mass_matrix, rows.P, rounding.cast<R>());
  // The forces as they are given: in double precision.
  const VectorOf<R> tau = dynamics.tau.template cast<double>().template cast<R>();
  auto [rates, multipliers] = system.solve(tau - dynamics.bias, -rows.gamma);
  return {std::move(system), std::move(rates), std::move(multipliers)};
}

}  // namespace

template <class R>
Arrays constrained_functions(const Description& description, const State& state,
                             const DynamicsOf<R>& dynamics) {
  const Solution<R> found = solution(description, state, dynamics);
  return {{"qdd", found.rates.template cast<double>()},
          {"lambda", found.multipliers.template cast<double>()}};
}

template <class R>
Arrays constrained_derivatives(const Description& description, const State& state,
                               const DynamicsOf<R>& dynamics) {
  using T = Jet<R>;
  const Solution<R> found = solution(description, state, dynamics);
  const Eigen::Index n = found.rates.size(), m = found.multipliers.size();
  StateOf<T> fixed = lifted<T>(state);
  for (Eigen::Index k = 0; k < n; ++k)
    fixed.rates[static_cast<std::size_t>(k)] = T(found.rates[k], R(0.0), R(0.0));
  std::vector<T> multipliers;
  for (const R& value : found.multipliers) multipliers.emplace_back(value, R(0.0), R(0.0));

  Arrays all;
  for (const char* by : {"q", "qd", "tau"}) {
    const std::string name = by;
    Eigen::MatrixXd qdd(n, n), lambda(m, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      VectorOf<R> f = VectorOf<R>::Unit(n, k), g = VectorOf<R>::Zero(m);
      if (name != "tau") {
        StateOf<T> moved = fixed;
        if (name == "q")
          moved.q = unit_motion(description, lifted<R>(state), static_cast<int>(k));
        else
          moved.speeds[static_cast<std::size_t>(k)].first = R(1.0);
        const std::vector<T> forces = numeric_forces(description, moved, state.wrenches);
        const ConstraintActions<T> actions = constraint_actions(description, moved, multipliers);
        for (Eigen::Index i = 0; i < n; ++i) {
          const auto at = static_cast<std::size_t>(i);
          f[i] = actions.forces[at].first - forces[at].first;
        }
        for (Eigen::Index i = 0; i < m; ++i) g[i] = -actions.accelerations[static_cast<std::size_t>(i)].first;
      }
      const auto [x, y] = found.system.solve(f, g);
      qdd.col(k) = x.template cast<double>();
      lambda.col(k) = y.template cast<double>();
    }
    all["qdd_" + name] = qdd;
    all["lambda_" + name] = lambda;
  }
  return all;
}

template Arrays constrained_functions(const Description&, const State&, const DynamicsOf<double>&);
template Arrays constrained_functions(const Description&, const State&, const DynamicsOf<long double>&);
template Arrays constrained_derivatives(const Description&, const State&, const DynamicsOf<double>&);
template Arrays constrained_derivatives(const Description&, const State&, const DynamicsOf<long double>&);

}  // namespace alembert::oracles

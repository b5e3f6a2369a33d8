// Forward dynamics under constraints by the Schur complement of M (see the header):
//
//   X = M^-1 P^T,  S = P X = G E G^T,  v = M^-1 (tau - c),  S lambda = -gamma - P v,  du/dt = v + X lambda
//
// Rows are eliminated in their order. The pivot E_r is the square of the length, in the metric of M^-1, of what the rows
// before it leave of row r: S_rr less what cancels. It is made of N_r = S_rr + sum_a G_ra^2 N_a. Where it is rounding of
// that, the row follows from those before it: it is left out by a choice, without a branch, and has no reaction. (The
// runtime's constraint_factorization.hpp compares with S_rr alone, and takes rows that are nearly dependent last.)
#include "dynamics/choice/constrained_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "differentiation/jacobian.hpp"
#include "dynamics/choice/force_derivatives.hpp"
#include "dynamics/choice/forward_dynamics.hpp"
#include "dynamics/recursions/constraints.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

using Columns = std::vector<std::vector<Expr>>;

/// The factors of S.
class SchurComplement {
 public:
  SchurComplement(std::vector<Expr> S, std::size_t rows, std::size_t speeds, ExprGraph& graph)
      : G_(std::move(S)), rows_(rows), inverse_pivots_(rows) {
    const double dependent =
        16 * static_cast<double>(std::max(rows, speeds)) * std::numeric_limits<double>::epsilon();
    std::vector<Expr> made_of;  // N
    Expr sum = graph.zero();
    for (std::size_t r = 0; r < rows; ++r) {
      made_of.push_back(entry(r, r));
      sum += entry(r, r);
    }
    const Expr nothing = graph.real(16 * dependent * dependent) * sum;  // a row of zeros, but for rounding
    for (std::size_t a = 0; a < rows; ++a) {
      const Expr pivot = entry(a, a), clear = pivot - (graph.real(dependent) * made_of[a] + nothing);
      const Expr divisor = if_positive(clear, pivot) + unless_positive(clear, graph.one());
      inverse_pivots_[a] = if_positive(clear, graph.one() / divisor);
      std::vector<Expr> factors(rows);
      for (std::size_t r = a + 1; r < rows; ++r) {
        factors[r] = entry(r, a) * inverse_pivots_[a];
        for (std::size_t s = a + 1; s <= r; ++s) entry(r, s) -= factors[r] * entry(s, a);
        made_of[r] += factors[r] * factors[r] * made_of[a];
      }
      for (std::size_t r = a + 1; r < rows; ++r) entry(r, a) = factors[r];
    }
  }

  /// S x = right over the rows that are independent; 0 in the others.
  std::vector<Expr> solve(std::vector<Expr> x) const {
    for (std::size_t a = 0; a < rows_; ++a)
      for (std::size_t r = a + 1; r < rows_; ++r) x[r] -= G_[r * rows_ + a] * x[a];
    for (std::size_t a = 0; a < rows_; ++a) x[a] = x[a] * inverse_pivots_[a];
    for (std::size_t a = rows_; a-- > 0;)
      for (std::size_t r = a + 1; r < rows_; ++r) x[a] -= G_[r * rows_ + a] * x[r];
    return x;
  }

 private:
  Expr& entry(std::size_t r, std::size_t s) { return G_[r * rows_ + s]; }

  std::vector<Expr> G_;  ///< below its diagonal
  std::size_t rows_;
  std::vector<Expr> inverse_pivots_;
};

/// The constraints with M's inverse put to their rows.
class ConstrainedSystem {
 public:
  ConstrainedSystem(const Kinematics& kinematics, const EquationsOfMotion& equations)
      : kinematics_(kinematics),
        rows_(constraint_equations(kinematics.mechanism, kinematics.tree, kinematics.derivatives,
                                   kinematics.graph)),
        count_(rows_.gamma.size()),
        speeds_(static_cast<std::size_t>(kinematics.mechanism.nv)) {
    Columns right{driving_forces(kinematics, equations)};
    for (std::size_t r = 0; r < count_; ++r) {
      const auto first = rows_.P.begin() + static_cast<std::ptrdiff_t>(r * speeds_);
      right.emplace_back(first, first + static_cast<std::ptrdiff_t>(speeds_));
    }
    X_ = solved_for_columns(kinematics, equations, right);
    free_ = std::move(X_.front());
    X_.erase(X_.begin());
  }

  const ConstraintEquations& rows() const { return rows_; }
  std::size_t count() const { return count_; }
  const Columns& X() const { return X_; }

  SchurComplement schur_complement() const {
    std::vector<Expr> S(count_ * count_, kinematics_.graph.zero());
    for (std::size_t r = 0; r < count_; ++r)
      for (std::size_t s = 0; s <= r; ++s) S[r * count_ + s] = along(r, X_[s]);
    return {std::move(S), count_, speeds_, kinematics_.graph};
  }

  /// M x = f + P^T y, P x = g for v = M^-1 f.
  std::pair<std::vector<Expr>, std::vector<Expr>> solved(const SchurComplement& S, std::vector<Expr> v,
                                                         std::vector<Expr> g) const {
    for (std::size_t r = 0; r < count_; ++r) g[r] -= along(r, v);
    std::vector<Expr> y = S.solve(std::move(g));
    for (std::size_t k = 0; k < speeds_; ++k)
      for (std::size_t r = 0; r < count_; ++r) v[k] += X_[r][k] * y[r];
    return {std::move(v), std::move(y)};
  }

  ConstrainedMotion motion(const SchurComplement& S) const {
    std::vector<Expr> g;
    for (const Expr& gamma : rows_.gamma) g.push_back(-gamma);
    auto [rates, lambdas] = solved(S, free_, std::move(g));
    return {std::move(rates), std::move(lambdas)};
  }

 private:
  /// Row r of P times v.
  Expr along(std::size_t r, const std::vector<Expr>& v) const {
    Expr sum = kinematics_.graph.zero();
    for (std::size_t k = 0; k < speeds_; ++k) sum += rows_.P[r * speeds_ + k] * v[k];
    return sum;
  }

  const Kinematics& kinematics_;
  ConstraintEquations rows_;
  std::size_t count_, speeds_;
  Columns X_;               ///< M^-1 P^T: a column for each row
  std::vector<Expr> free_;  ///< M^-1 (tau - c)
};

/// What the changes of P^T lambda (forces) and of P du/dt + gamma (rows) are at constant du/dt and lambda, for which
/// symbols stand.
struct RowChanges {
  Columns forces, rows;  ///< a column for each speed: along it, then by it
};

RowChanges row_changes(const Kinematics& kinematics, const ConstraintEquations& rows,
                       const std::vector<Expr>& lambdas) {
  const SpeedDerivatives& derivatives = kinematics.derivatives;
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv), count = lambdas.size();
  std::vector<Expr> values(nv, kinematics.graph.zero());
  for (std::size_t r = 0; r < count; ++r) {
    Expr rate = rows.gamma[r];
    for (std::size_t k = 0; k < nv; ++k) {
      values[k] += rows.P[r * nv + k] * lambdas[r];
      rate += rows.P[r * nv + k] * derivatives.rate(static_cast<int>(k));
    }
    values.push_back(rate);
  }
  RowChanges out{Columns(2 * nv, std::vector<Expr>(nv, kinematics.graph.zero())),
                 Columns(2 * nv, std::vector<Expr>(count, kinematics.graph.zero()))};
  for (const SpeedPartial& partial : derivatives.partials(values)) {
    if (partial.speed == derivatives.time_index()) continue;
    const std::size_t k = static_cast<std::size_t>(partial.speed);
    std::copy_n(partial.values.begin(), nv, out.forces[k].begin());
    std::copy_n(partial.values.begin() + static_cast<std::ptrdiff_t>(nv), count, out.rows[k].begin());
  }
  if (count == 0) return out;
  std::vector<Expr> speeds;
  for (std::size_t k = 0; k < nv; ++k) speeds.push_back(derivatives.speed(static_cast<int>(k)));
  const Jacobian by_speeds = jacobian(rows.gamma, speeds);
  for (std::size_t r = 0; r < count; ++r)
    for (std::size_t k = 0; k < nv; ++k) out.rows[nv + k][r] = by_speeds(r, k);
  return out;
}

}  // namespace

ConstrainedMotion constrained_forward_dynamics(const Kinematics& kinematics,
                                               const EquationsOfMotion& equations) {
  const ConstrainedSystem system(kinematics, equations);
  ConstrainedMotion motion = system.motion(system.schur_complement());
  value_number_all({&motion.rates, &motion.lambdas});
  return motion;
}

ConstrainedDerivatives constrained_forward_dynamics_derivatives(const Kinematics& kinematics,
                                                                const EquationsOfMotion& equations) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  const ConstrainedSystem system(kinematics, equations);
  const SchurComplement S = system.schur_complement();
  const ConstrainedMotion motion = system.motion(S);

  // At these rates and reactions, -(change of what M du/dt + c - P^T lambda and P du/dt + gamma are).
  std::vector<std::pair<Expr, Expr>> there;
  std::vector<Expr> lambdas;
  for (std::size_t k = 0; k < nv; ++k)
    there.emplace_back(kinematics.derivatives.rate(static_cast<int>(k)), motion.rates[k]);
  for (std::size_t r = 0; r < system.count(); ++r) {
    lambdas.push_back(kinematics.graph.symbol(fmt::format("lambda[{}]", r)));
    there.emplace_back(lambdas.back(), motion.lambdas[r]);
  }
  const std::vector<Expr> tau = force_derivatives(kinematics, equations);
  RowChanges changes = row_changes(kinematics, system.rows(), lambdas);
  std::vector<Expr> flat;
  for (std::size_t k = 0; k < 2 * nv; ++k) {
    for (std::size_t i = 0; i < nv; ++i)
      flat.push_back(changes.forces[k][i] - tau[((k / nv) * nv + i) * nv + k % nv]);
    for (const Expr& change : changes.rows[k]) flat.push_back(-change);
  }
  flat = substitute(flat, there);
  auto next = flat.begin();
  for (std::size_t k = 0; k < 2 * nv; ++k) {
    for (Expr& force : changes.forces[k]) force = *next++;
    for (Expr& row : changes.rows[k]) row = *next++;
  }

  Columns free = solved_for_columns(kinematics, equations, changes.forces);
  Columns rates, reactions;
  const auto add = [&](std::vector<Expr> v, std::vector<Expr> g) {
    auto [x, y] = system.solved(S, std::move(v), std::move(g));
    rates.push_back(std::move(x));
    reactions.push_back(std::move(y));
  };
  for (std::size_t k = 0; k < 2 * nv; ++k) add(std::move(free[k]), std::move(changes.rows[k]));
  // By the forces: P M^-1 is X^T. The rates' are symmetric.
  const std::vector<Expr> inverse = inverse_mass_matrix(kinematics, equations);
  for (std::size_t k = 0; k < nv; ++k) {
    std::vector<Expr> g, x;
    for (std::size_t r = 0; r < system.count(); ++r) g.push_back(-system.X()[r][k]);
    std::vector<Expr> y = S.solve(std::move(g));
    for (std::size_t i = 0; i < k; ++i) x.push_back(rates[2 * nv + i][k]);
    for (std::size_t i = k; i < nv; ++i) {
      x.push_back(inverse[i * nv + k]);
      for (std::size_t r = 0; r < y.size(); ++r) x[i] += system.X()[r][i] * y[r];
    }
    rates.push_back(std::move(x));
    reactions.push_back(std::move(y));
  }

  ConstrainedDerivatives out{by_rows(rates, 0, nv),      by_rows(rates, nv, nv),
                             by_rows(rates, 2 * nv, nv), by_rows(reactions, 0, nv),
                             by_rows(reactions, nv, nv), by_rows(reactions, 2 * nv, nv)};
  value_number_all({&out.rates_along, &out.rates_by_speeds, &out.rates_by_forces, &out.lambdas_along,
                    &out.lambdas_by_speeds, &out.lambdas_by_forces});
  return out;
}

}  // namespace alembert

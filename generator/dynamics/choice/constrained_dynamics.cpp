// Forward dynamics under constraints (see the header) by rows that are independent in the metric of M^-1:
//
//   X = M^-1 P^T,  S = P X = G E G^T,  P = G R,  Y = M^-1 R^T,  v = M^-1 (tau - c)
//   G s = -gamma - P v,  E y = s,  G^T lambda = y,  du/dt = v + X lambda = v + Y y
//
// Rows are eliminated in their order. The pivot E_r is the square of the length of what the rows before it leave of row r:
// S_rr less what cancels. It is made of N_r = S_rr + sum_a G_ra^2 N_a. Where it is rounding of that, the row follows from
// those before it: it is left out by a choice, without a branch, and has no reaction. So is a row that is nothing but
// rounding, over its length (row_lengths.hpp) next to all rows over theirs. (The runtime's constraint_factorization.hpp
// compares with S_rr alone, and takes rows that are nearly dependent last.)
//
// Where a coordinate has next to no inertia of its own, or M is singular and the constraints leave no motion without
// inertia, M^-1 (tau - c) is large and what the constraints leave of it is small. Then the rows are added to M, which
// changes no solution: with M + P^T W P for M and tau - c - P^T W gamma for tau - c, X, S and v are of one size. W, a
// weight for each row, makes the diagonal of P^T W P about that of M. (The augmented Lagrangian of Bayo and others, 1988.)
// The reactions are then what cancels in G s, up to the weights. Where a row ties what is heavy to what is light they may be
// as small as the forces on what is light: they are found from the rates, by the rows in the metric of D^-1, D about M's
// diagonal:
//
//   P D^-1 P^T lambda = P D^-1 (M du/dt - (tau - c))
//
// Either R and Y are made, by modified Gram-Schmidt, or S is eliminated. What rounding leaves grows with the condition of
// the rows, or with its square (Bjoerck, BIT 7, 1967). Elimination keeps rows short that concern few speeds, as those of
// the legs of a platform: it is taken where it is much shorter.
#include "dynamics/choice/constrained_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "differentiation/jacobian.hpp"
#include "dynamics/choice/force_derivatives.hpp"
#include "dynamics/choice/forward_dynamics.hpp"
#include "dynamics/choice/row_lengths.hpp"
#include "dynamics/recursions/constraints.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

using Columns = std::vector<std::vector<Expr>>;

Expr product(const std::vector<Expr>& a, const std::vector<Expr>& b) {
  Expr sum = a.front().graph().zero();
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// a -= factor b
void subtract(std::vector<Expr>& a, Expr factor, const std::vector<Expr>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= factor * b[k];
}

enum class RowMethod { gram_schmidt, elimination };

class IndependentRows {
 public:
  /// Rows of P and columns of X.
  IndependentRows(Columns P, Columns X, const std::vector<double>& lengths, RowMethod method)
      : method_(method), R_(std::move(P)), Y_(std::move(X)), G_(R_.size()) {
    if (R_.empty()) return;
    ExprGraph& graph = R_.front().front().graph();
    const std::size_t count = R_.size();
    const bool gram_schmidt = method == RowMethod::gram_schmidt;
    Columns S(count);  // its lower triangle; of Gram-Schmidt the diagonal alone
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t s = 0; s <= r; ++s)
        S[r].push_back(gram_schmidt && s < r ? graph.zero() : product(R_[r], Y_[s]));
    const double dependent = 16 * static_cast<double>(std::max(count, R_.front().size()));  // epsilons
    std::vector<Expr> made_of;                                                              // N
    Expr sum = graph.zero();
    for (std::size_t r = 0; r < count; ++r) {
      made_of.push_back(S[r][r]);
      sum += graph.real(1 / (lengths[r] * lengths[r])) * S[r][r];
    }
    for (std::size_t a = 0; a < count; ++a) {
      const double shortest = 4 * dependent * lengths[a];
      const Expr nothing = graph.real(shortest * shortest) * rounding(rounding(sum));
      const Expr pivot = gram_schmidt ? product(R_[a], Y_[a]) : S[a][a];
      const Expr clear = pivot - (graph.real(dependent) * rounding(made_of[a]) + nothing);
      const Expr divisor = if_positive(clear, pivot) + unless_positive(clear, graph.one());
      inverse_pivots_.push_back(if_positive(clear, graph.one() / divisor));
      for (std::size_t r = a + 1; r < count; ++r) {
        const Expr factor = (gram_schmidt ? product(R_[r], Y_[a]) : S[r][a]) * inverse_pivots_[a];
        G_[r].push_back(factor);
        made_of[r] += factor * factor * made_of[a];
        if (gram_schmidt) {
          subtract(R_[r], factor, R_[a]);
          subtract(Y_[r], factor, Y_[a]);
        } else {
          for (std::size_t s = a + 1; s <= r; ++s) S[r][s] -= factor * S[s][a];
        }
      }
    }
  }

  /// x and y of M x = f + P^T y, P x = g, for v = M^-1 f. Rows that are left out have y = 0.
  std::pair<std::vector<Expr>, std::vector<Expr>> solved(std::vector<Expr> v, std::vector<Expr> g) const {
    std::vector<Expr> y = std::move(g);
    if (method_ == RowMethod::elimination)
      for (std::size_t r = 0; r < y.size(); ++r) y[r] -= product(R_[r], v);
    for (std::size_t a = 0; a < y.size(); ++a)
      for (std::size_t r = a + 1; r < y.size(); ++r) y[r] -= G_[r][a] * y[a];
    for (std::size_t r = 0; r < y.size(); ++r) {
      if (method_ == RowMethod::gram_schmidt) y[r] -= product(R_[r], v);
      y[r] = y[r] * inverse_pivots_[r];
      if (method_ == RowMethod::gram_schmidt) subtract(v, -y[r], Y_[r]);
    }
    return with_reactions(std::move(v), std::move(y));
  }

  /// The same for g = 0 and v column k of M^-1, which P takes to column k of X^T, and R to that of Y^T.
  std::pair<std::vector<Expr>, std::vector<Expr>> solved_for_force(std::size_t k, std::vector<Expr> v) const {
    std::vector<Expr> y;
    for (const std::vector<Expr>& column : Y_) y.push_back(-column[k]);
    for (std::size_t a = 0; method_ == RowMethod::elimination && a < y.size(); ++a)
      for (std::size_t r = a + 1; r < y.size(); ++r) y[r] -= G_[r][a] * y[a];
    for (std::size_t r = 0; r < y.size(); ++r) {
      y[r] = y[r] * inverse_pivots_[r];
      if (method_ == RowMethod::gram_schmidt) subtract(v, -y[r], Y_[r]);
    }
    return with_reactions(std::move(v), std::move(y));
  }

 private:
  /// G^T lambda = y; and v += X lambda where Y is not there.
  std::pair<std::vector<Expr>, std::vector<Expr>> with_reactions(std::vector<Expr> v,
                                                                 std::vector<Expr> y) const {
    for (std::size_t a = y.size(); a-- > 0;)
      for (std::size_t r = a + 1; r < y.size(); ++r) y[a] -= G_[r][a] * y[r];
    if (method_ == RowMethod::elimination)
      for (std::size_t r = 0; r < y.size(); ++r) subtract(v, -y[r], Y_[r]);
    return {std::move(v), std::move(y)};
  }

  RowMethod method_;
  Columns R_, Y_;  ///< of elimination P and X
  Columns G_;      ///< rows, below its diagonal
  std::vector<Expr> inverse_pivots_;
};

/// The constraints with M's inverse put to their rows.
class ConstrainedSystem {
 public:
  ConstrainedSystem(const Kinematics& kinematics, const EquationsOfMotion& equations)
      : kinematics_(kinematics),
        equations_(equations),
        rows_(constraint_equations(kinematics.mechanism, kinematics.tree, kinematics.derivatives,
                                   kinematics.graph)) {
    const auto nv = static_cast<std::ptrdiff_t>(kinematics.mechanism.nv);
    for (auto row = rows_.P.begin(); row != rows_.P.end(); row += nv) P_.emplace_back(row, row + nv);
    if (equations.augmented) augment();
    for (const Expr& gamma : rows_.gamma) g_.push_back(-gamma);
    driving_ = driving_forces(kinematics, equations);
    Columns right{driving_};
    add_rows(right.front(), g_);
    right.insert(right.end(), P_.begin(), P_.end());
    Columns X = inverse_times(right);
    free_ = std::move(X.front());
    X.erase(X.begin());
    const std::vector<double> lengths =
        row_lengths(kinematics, rows_, augmented_.empty() ? equations.M : augmented_);
    independent_.emplace(P_, X, lengths, RowMethod::gram_schmidt);
    IndependentRows eliminated(P_, std::move(X), lengths, RowMethod::elimination);
    if (2 * operations(motion(eliminated)) < operations(motion())) independent_ = std::move(eliminated);
  }

  const ConstraintEquations& rows() const { return rows_; }
  ConstrainedMotion motion() const {
    ConstrainedMotion out = motion(*independent_);
    if (reactions_) out.lambdas = reactions(out.rates, driving_);
    return out;
  }
  /// x and y of M x = f + P^T y, P x = g, for each column of f and g.
  std::vector<std::pair<std::vector<Expr>, std::vector<Expr>>> solved(const Columns& f, Columns g) const {
    Columns right = f;
    for (std::size_t k = 0; k < f.size(); ++k) add_rows(right[k], g[k]);
    Columns free = inverse_times(right);
    std::vector<std::pair<std::vector<Expr>, std::vector<Expr>>> out;
    for (std::size_t k = 0; k < f.size(); ++k) {
      out.push_back(independent_->solved(std::move(free[k]), std::move(g[k])));
      if (reactions_) out.back().second = reactions(out.back().first, f[k]);
    }
    return out;
  }
  /// The same for g = 0 and f each column of the identity.
  std::vector<std::pair<std::vector<Expr>, std::vector<Expr>>> solved_for_forces() const {
    const std::size_t nv = static_cast<std::size_t>(kinematics_.mechanism.nv);
    Columns inverse;
    Columns unit(nv, std::vector<Expr>(nv, kinematics_.graph.zero()));
    for (std::size_t k = 0; k < nv; ++k) unit[k][k] = kinematics_.graph.one();
    if (augmented_.empty()) {
      const std::vector<Expr> entries = inverse_mass_matrix(kinematics_, equations_);
      for (auto column = entries.begin(); column != entries.end(); column += static_cast<std::ptrdiff_t>(nv))
        inverse.emplace_back(column, column + static_cast<std::ptrdiff_t>(nv));
    } else {
      inverse = inverse_times(unit);
    }
    std::vector<std::pair<std::vector<Expr>, std::vector<Expr>>> out;
    for (std::size_t k = 0; k < nv; ++k) {
      out.push_back(independent_->solved_for_force(k, std::move(inverse[k])));
      if (reactions_) out.back().second = reactions(out.back().first, unit[k]);
    }
    return out;
  }

 private:
  void augment() {
    const std::size_t nv = static_cast<std::size_t>(kinematics_.mechanism.nv);
    augmented_ = equations_.M;
    const std::vector<double> weights = row_weights(kinematics_, rows_, equations_.M);
    for (const double weight : weights) weights_.push_back(kinematics_.graph.real(weight));
    std::vector<Expr> inertias(nv * nv, kinematics_.graph.zero());
    const std::vector<double> typical = typical_inertias(kinematics_, rows_, equations_.M, weights);
    for (std::size_t k = 0; k < nv; ++k) {
      inertias[k * nv + k] = kinematics_.graph.real(typical[k]);
      inverse_inertias_.push_back(kinematics_.graph.real(1 / typical[k]));
    }
    Columns X = P_;
    for (std::vector<Expr>& column : X)
      for (std::size_t k = 0; k < nv; ++k) column[k] *= inverse_inertias_[k];
    reactions_.emplace(P_, std::move(X), row_lengths(kinematics_, rows_, inertias), RowMethod::gram_schmidt);
    for (std::size_t r = 0; r < P_.size(); ++r)
      for (std::size_t i = 0; i < nv; ++i)
        for (std::size_t j = 0; j <= i; ++j) augmented_[i * nv + j] += weights_[r] * (P_[r][i] * P_[r][j]);
    for (std::size_t i = 0; i < nv; ++i)
      for (std::size_t j = 0; j < i; ++j) augmented_[j * nv + i] = augmented_[i * nv + j];
  }
  /// f += P^T W g, where the rows are in M.
  void add_rows(std::vector<Expr>& f, const std::vector<Expr>& g) const {
    for (std::size_t r = 0; r < weights_.size(); ++r) {
      const Expr weighted = weights_[r] * g[r];
      for (std::size_t k = 0; k < f.size(); ++k) f[k] += P_[r][k] * weighted;
    }
  }
  /// y of M x = f + P^T y for x, where the rows are in M.
  std::vector<Expr> reactions(const std::vector<Expr>& x, const std::vector<Expr>& f) const {
    std::vector<Expr> lack;
    for (std::size_t k = 0; k < f.size(); ++k) {
      Expr sum = f[k];
      for (std::size_t j = 0; j < f.size(); ++j) sum -= equations_.M[k * f.size() + j] * x[j];
      lack.push_back(inverse_inertias_[k] * sum);
    }
    return reactions_->solved(std::move(lack), std::vector<Expr>(P_.size(), kinematics_.graph.zero())).second;
  }
  /// Columns of M^-1 times these.
  Columns inverse_times(const Columns& columns) const {
    if (augmented_.empty()) return solved_for_columns(kinematics_, equations_, columns);
    Columns out;
    for (const std::vector<Expr>& column : columns) out.push_back(straight_line_solve(augmented_, column));
    return out;
  }
  ConstrainedMotion motion(const IndependentRows& independent) const {
    auto [rates, lambdas] = independent.solved(free_, g_);
    return {std::move(rates), std::move(lambdas)};
  }
  static std::size_t operations(const ConstrainedMotion& motion) {
    std::vector<Expr> all = motion.rates;
    all.insert(all.end(), motion.lambdas.begin(), motion.lambdas.end());
    return count_operations(all).total();
  }

  const Kinematics& kinematics_;
  const EquationsOfMotion& equations_;
  ConstraintEquations rows_;
  Columns P_;                              ///< rows
  std::vector<Expr> augmented_, weights_;  ///< M + P^T W P and W, or nothing
  std::vector<Expr> inverse_inertias_;     ///< of D, where the rows are in M
  std::optional<IndependentRows> independent_;
  std::optional<IndependentRows> reactions_;  ///< in the metric of D^-1, where the rows are in M
  std::vector<Expr> driving_, free_, g_;      ///< tau - c, M^-1 (tau - c), -gamma
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
  ConstrainedMotion motion = system.motion();
  value_number_all({&motion.rates, &motion.lambdas});
  return motion;
}

ConstrainedDerivatives constrained_forward_dynamics_derivatives(const Kinematics& kinematics,
                                                                const EquationsOfMotion& equations) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  const ConstrainedSystem system(kinematics, equations);
  const ConstrainedMotion motion = system.motion();

  // At these rates and reactions, -(change of what M du/dt + c - P^T lambda and P du/dt + gamma are).
  std::vector<std::pair<Expr, Expr>> there;
  std::vector<Expr> lambdas;
  for (std::size_t k = 0; k < nv; ++k)
    there.emplace_back(kinematics.derivatives.rate(static_cast<int>(k)), motion.rates[k]);
  for (std::size_t r = 0; r < motion.lambdas.size(); ++r) {
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

  Columns rates, reactions;
  for (auto& [x, y] : system.solved(changes.forces, std::move(changes.rows))) {
    rates.push_back(std::move(x));
    reactions.push_back(std::move(y));
  }
  // By the forces. The rates' are symmetric.
  for (auto& [x, y] : system.solved_for_forces()) {
    const std::size_t k = rates.size() - 2 * nv;
    rates.push_back(std::move(x));
    reactions.push_back(std::move(y));
    for (std::size_t i = 0; i < k; ++i) rates.back()[i] = rates[2 * nv + i][k];
  }

  ConstrainedDerivatives out{by_rows(rates, 0, nv),      by_rows(rates, nv, nv),
                             by_rows(rates, 2 * nv, nv), by_rows(reactions, 0, nv),
                             by_rows(reactions, nv, nv), by_rows(reactions, 2 * nv, nv)};
  value_number_all({&out.rates_along, &out.rates_by_speeds, &out.rates_by_forces, &out.lambdas_along,
                    &out.lambdas_by_speeds, &out.lambdas_by_forces});
  return out;
}

}  // namespace alembert

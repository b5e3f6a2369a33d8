// Rounding errors of candidates for equations. In: the plain equations (nothing placed, regrouped, scaled or
// peeled) and a list of equal values. Out: whether the list loses many more digits than they do.
#pragma once

#include <span>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "support/operation.hpp"

namespace alembert {

class Conditioning {
 public:
  /// `plain` are values of the mechanism by the plain equations. The kinematics must outlive it.
  Conditioning(const Kinematics& kinematics, std::span<const Expr> plain);

  /// Whether the running error bound of every entry, and its difference from the plain equations' value, is at
  /// most 16 times their bound: the largest over a few states each. An entry of a matrix beside the diagonal may
  /// have that of the diagonal, m_ij < sqrt(m_ii m_jj). Not by operations alone are equations chosen: terms that
  /// are large and cancel can be few.
  bool is_good(std::span<const Expr> values) const;
  /// The same of the differences alone: bounds of long sums can be far above their errors.
  bool has_values(std::span<const Expr> values) const;

 private:
  bool is_within(std::span<const Expr> values, bool with_bounds) const;
  /// For each entry; `values` and `plain_` are for each state.
  std::vector<double> errors(const std::vector<std::vector<Approximate>>& values, bool with_bounds) const;

  std::vector<std::vector<double>> states_;
  std::vector<std::vector<Approximate>> plain_;
  std::vector<double> most_;  ///< for each entry
};

}  // namespace alembert

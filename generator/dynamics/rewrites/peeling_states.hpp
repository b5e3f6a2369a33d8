// What screw peeling has to know of expressions: in a mechanism and its motions; out: which values are zero,
// short numbers or the same in all states, by proof, and which have a value at all, at random states.
#pragma once

#include <span>
#include <vector>

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "symbolic/modular.hpp"

namespace alembert {

class PeelingStates {
 public:
  PeelingStates(const Mechanism& mechanism, const std::vector<Motion>& motions, ExprGraph& graph);

  /// Values of all symbols in the field with p^2 elements, quaternions of unit length: random coordinates and
  /// times, the same runtime parameters. What is equal at all of them is equal in all states.
  const std::vector<std::vector<Modular>>& points() const { return points_; }
  /// The longest constant shift.
  double length() const { return length_; }
  /// Whether values are finite at the states.
  bool finite_everywhere(std::span<const Expr> values) const;
  /// What is zero is the number 0, numbers that are short fractions are these. `sizes`: what values without
  /// symbols are sums of, one for each.
  std::vector<Expr> recognised(std::vector<Expr> values, std::span<const double> sizes) const;
  /// Whether two products of motions agree at all states at which the first has a value: a net under the
  /// proofs.
  bool agree(const std::vector<Motion>& given, const std::vector<Motion>& other) const;

 private:
  ExprGraph& graph_;
  double length_ = 0;
  std::vector<std::vector<double>> states_;
  std::vector<std::vector<Modular>> points_;
};

}  // namespace alembert

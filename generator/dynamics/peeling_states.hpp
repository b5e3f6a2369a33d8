// States at which screw peeling tests with numbers. In: a mechanism. Out: what is finite, zero, a short
// number or the same at random states of it.
#pragma once

#include <span>
#include <vector>

#include "dynamics/motion_tree.hpp"
#include "dynamics/units.hpp"

namespace alembert {

/// Random states in groups that share the runtime parameters: what holds in all states of a group holds for
/// these parameters.
class PeelingStates {
 public:
  using States = std::vector<std::vector<double>>;  ///< values of all symbols of the graph

  PeelingStates(const Mechanism& mechanism, const Units& units, ExprGraph& graph);

  const std::vector<States>& groups() const { return groups_; }
  /// Shifts of this size are long.
  double length() const { return length_; }
  /// Whether values are finite for every draw of the parameters.
  bool finite_everywhere(std::span<const Expr> values) const;
  /// What is zero for every draw of the parameters up to rounding is zero; numbers that are short fractions
  /// are these. Rounding is relative to `sizes`, one for each value.
  std::vector<Expr> recognised(std::vector<Expr> values, std::span<const double> sizes) const;
  /// Whether two products of motions agree at all states at which the first has a value.
  bool agree(const std::vector<Motion>& given, const std::vector<Motion>& other) const;

 private:
  ExprGraph& graph_;
  double length_;
  std::vector<States> groups_;
};

}  // namespace alembert

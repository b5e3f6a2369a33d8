// What every node of a graph depends on, found in one pass, so that checks of many expressions that share
// parts stay linear. In: a graph and the mechanism whose symbols count. Out: for each node, coordinates and
// kinds of symbols.
#pragma once

#include <cstdint>
#include <vector>

#include "mechanism/model.hpp"
#include "mechanism/scope.hpp"

namespace alembert {

class SymbolsBelow {
 public:
  /// Nodes and frame positions made later are not known.
  SymbolsBelow(const ExprGraph& graph, const Mechanism& mechanism);

  /// Indices of the coordinates below a node, sorted; sets stop growing at kMost, which ones is then open.
  static constexpr std::size_t kMost = 7;
  const std::vector<int>& coordinates(const Expr& x) const { return sets_[x.ref().node()]; }
  /// Which of coordinate (also by way of a frame's position), time and speed are below it.
  Dependence kinds(const Expr& x) const { return kinds_[x.ref().node()]; }

  static void merge(std::vector<int>& into, const std::vector<int>& from);

 private:
  std::vector<std::vector<int>> sets_;
  std::vector<Dependence> kinds_;
};

}  // namespace alembert

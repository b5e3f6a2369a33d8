// Order of evaluation. In: roots. Out: the nodes they need, operands first, and where each stands.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symbolic/expr.hpp"
#include "symbolic/node_index.hpp"

namespace alembert {

/// Node ids reachable from `roots`, children before parents, in depth-first order of the roots (so it is the
/// same in every build, whatever the ids are).
std::vector<std::uint32_t> postorder(std::span<const Expr> roots);

/// A node seen from inside a Postorder: positions in it instead of ids, shifted left by one, plus 1 if
/// negated.
struct LocalOperands {
  std::uint32_t a = 0, b = 0;
};

/// What most passes ask of a node; it stands beside the position, the node anywhere in memory.
struct NodeKind {
  Operation op;
  bool constant;
  constexpr int arity() const { return operand_count(op); }
};

/// Nodes reachable from roots, operands first, and the position of each.
struct Postorder {
  std::vector<std::uint32_t> ids;
  std::vector<NodeKind> kinds;
  std::vector<LocalOperands> operands;  ///< as many of them are meant as the operation has
  NodeIndex index;
  std::uint32_t at(std::uint32_t id) const { return index.find(id); }
  static std::uint32_t local(std::uint32_t position, Ref x) {
    return position << 1 | (x.negative() ? 1u : 0u);
  }
  std::uint32_t local(Ref x) const { return local(at(x.node()), x); }
};
/// With `ranks`, of two operands the one of lower rank is visited first; constants, and operands of which none
/// has a rank, stay as they are.
Postorder indexed_postorder(std::span<const Expr> roots, const NodeIndex* ranks = nullptr);

/// The graph of some roots; throws std::logic_error if they belong to several or to none.
ExprGraph* graph_of(std::span<const Expr> roots);

}  // namespace alembert

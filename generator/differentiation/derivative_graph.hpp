// The linearised graph that every method of differentiation works on. In: roots and variables. Out: the nodes
// that lie above a variable, and for each operand of each of them an edge that holds the local partial
// derivative. d root / d variable is the sum, over all paths from the root down to the variable, of the
// products of the edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "differentiation/jacobian.hpp"
#include "support/no_index.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// One operand of one node: `value` = d top / d bottom. Parallel edges are legal (x*x).
struct DerivativeEdge {
  std::uint32_t top, bottom;  ///< vertices, top > bottom
  Ref value;
};

struct DerivativeGraph {
  ExprGraph* graph = nullptr;
  /// Node ids of the vertices that depend on a variable, children before parents, in the depth-first order of
  /// the roots: vertex numbers, unlike node ids, do not depend on the order in which the nodes were made.
  std::vector<std::uint32_t> nodes;
  std::vector<DerivativeEdge> edges;     ///< ascending by top, then by operand slot; none of them is zero
  std::vector<std::uint32_t> roots;      ///< vertex of each root, kNoIndex if its derivatives are all zero
  std::vector<bool> negative;            ///< the root is the negative of its vertex
  std::vector<std::uint32_t> variables;  ///< vertex of each variable, kNoIndex if no root depends on it

  Expr expr(Ref ref) const { return {*graph, ref}; }
  /// The derivative of root i, given that of its vertex.
  Expr signed_as_root(std::size_t i, Expr x) const { return negative[i] ? -x : x; }
};

/// Throws std::invalid_argument if a variable is no symbol, or is repeated, or if handles belong to different
/// graphs or to none.
DerivativeGraph derivative_graph(std::span<const Expr> roots, std::span<const Expr> variables);

/// A Jacobian of the right shape, all entries zero.
Jacobian zero_jacobian(std::span<const Expr> roots, std::span<const Expr> variables, DerivativeMethod method);

}  // namespace alembert

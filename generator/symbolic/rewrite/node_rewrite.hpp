// What the rewrites of `optimize` share. In: roots, and what becomes of each of the nodes that they need. Out:
// the roots' images.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

/// Roots, the nodes that they need in order, and how often each of these is used, by nodes and by roots. Nodes
/// are told by their position in the order, operands by position and sign as in Postorder: both are the same
/// in every build.
struct LiveNodes {
  explicit LiveNodes(std::vector<Expr> values, const NodeIndex* ranks = nullptr)
      : roots(std::move(values)), order(indexed_postorder(roots, ranks)), uses(order.ids.size(), 0) {
    for (std::size_t i = 0; i < order.ids.size(); ++i) {
      const int arity = order.kinds[i].arity();
      if (arity > 0) ++uses[order.operands[i].a >> 1];
      if (arity > 1) ++uses[order.operands[i].b >> 1];
    }
    for (const Expr& root : roots) ++uses[order.at(root.ref().node())];
  }
  std::vector<Expr> roots;  ///< at least one
  Postorder order;
  std::vector<std::uint32_t> uses;
};

/// Base of a rewrite: reads live nodes in order, each after its operands, and makes their images in the same
/// graph. Constants are leaves.
class NodeRewrite {
 protected:
  explicit NodeRewrite(const LiveNodes& from)
      : from_(from), graph_(from.roots.front().graph()), uses_(from.uses), image_(from.order.ids.size()) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(image_.size()); }
  const Node& node(std::uint32_t position) const { return graph_.node(from_.order.ids[position]); }
  Operation op(std::uint32_t position) const { return from_.order.kinds[position].op; }
  bool is_constant(std::uint32_t position) const { return from_.order.kinds[position].constant; }
  int arity(std::uint32_t position) const {
    return is_constant(position) ? 0 : from_.order.kinds[position].arity();
  }
  LocalOperands operands(std::uint32_t position) const { return from_.order.operands[position]; }
  /// Those of a sum or a product, the one that comes up first in front.
  LocalOperands in_order(std::uint32_t position) const {
    const LocalOperands n = operands(position);
    return n.b >> 1 < n.a >> 1 ? LocalOperands{n.b, n.a} : n;
  }
  /// Value of a number; of another constant NaN.
  double number_of(std::uint32_t position) const { return number_of(Ref(from_.order.ids[position], false)); }
  double number_of(Ref x) const {
    const Operation kind = graph_.node(x.node()).op;
    const double value = kind == Operation::rational ? graph_.rational_value(x.node()).to_double()
                         : kind == Operation::real   ? graph_.real_value(x.node())
                                                     : std::numeric_limits<double>::quiet_NaN();
    return x.negative() ? -value : value;
  }

  /// Sets the image of every live node to `rewrite(position)`.
  template <class Rewrite>
  void rewrite_nodes(Rewrite&& rewrite) {
    const auto kept = graph_.keep_brackets();
    for (std::uint32_t i = 0; i < size(); ++i) made_.push_back((image_[i] = rewrite(i)).node());
  }
  /// The image of a node that keeps its operation.
  Ref copied(std::uint32_t position) {
    const Ref as_it_is(from_.order.ids[position], false);
    if (arity(position) == 0) return as_it_is;
    const Node n = node(position);
    const Ref a = image(operands(position).a), b = n.arity() == 2 ? image(operands(position).b) : Ref();
    return a == n.a && b == n.b ? as_it_is : make(n.op, a, b);
  }
  /// Makes an image or a part of one.
  Ref make(Operation op, Ref a, Ref b) {
    const Ref result = graph_.make(op, a, b);
    made_.push_back(result.node());
    return result;
  }
  /// Images of the roots. Operands are visited in the order in which they came up and were made here: by
  /// content, sums of the same form would have their terms in an arbitrary order in every round, and where
  /// several factors gain as much, one sum would take this and the next sum that.
  LiveNodes finished() const {
    std::vector<Expr> out;
    out.reserve(from_.roots.size());
    for (const Expr& root : from_.roots) out.emplace_back(graph_, image(from_.order.local(root.ref())));
    NodeIndex ranks(graph_.size());
    std::uint32_t rank = 0;
    for (const std::uint32_t id : made_) ranks.add(id, rank++);
    return LiveNodes(std::move(out), &ranks);
  }
  Ref image(std::uint32_t local) const {
    const Ref x = image_[local >> 1];
    return (local & 1) != 0 ? -x : x;
  }

  const LiveNodes& from_;
  ExprGraph& graph_;
  std::span<const std::uint32_t> uses_;
  std::vector<Ref> image_;           ///< by position
  std::vector<std::uint32_t> made_;  ///< ids of images and parts of them, with repetitions
};

}  // namespace alembert

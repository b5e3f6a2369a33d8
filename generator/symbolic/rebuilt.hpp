// Roots over other nodes. In: roots and what becomes of each node that they need. Out: the images of the roots.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "symbolic/postorder.hpp"

namespace alembert {

/// The roots in the graph they are of, each node replaced by `make(id, a, b)`, operands first: a and b are the images of
/// its operands, those that it has.
template <class Make>
std::vector<Expr> rebuilt(std::span<const Expr> roots, Make&& make) {
  std::vector<Expr> out(roots.begin(), roots.end());
  ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return out;
  const Postorder order = indexed_postorder(roots);
  std::vector<Ref> image(order.ids.size());
  const auto of = [&](std::uint32_t local) {
    const Ref x = image[local >> 1];
    return (local & 1) != 0 ? -x : x;
  };
  for (std::size_t i = 0; i < image.size(); ++i) {
    const std::uint32_t id = order.ids[i];
    const int arity = graph->node(id).arity();
    image[i] =
        make(id, arity > 0 ? of(order.operands[i].a) : Ref(), arity > 1 ? of(order.operands[i].b) : Ref());
  }
  for (Expr& root : out) root = Expr(*graph, of(order.local(root.ref())));
  return out;
}

}  // namespace alembert

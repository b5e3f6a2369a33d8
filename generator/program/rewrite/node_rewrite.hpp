// What the rewrites of stage `optimise` share. In: a value program and what becomes of each of its nodes.
// Out: the program of their images.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "program/value_graph.hpp"

namespace alembert {

/// Base of a rewrite: reads live nodes in order, each after its operands.
class NodeRewrite {
 protected:
  explicit NodeRewrite(const LiveProgram& from)
      : from_(from.values), order_(from.order), uses_(from.uses), image_(from_.graph.size()) {}

  /// Sets the image of every live node to `rewrite(id)`, which makes it in `to_.graph`.
  template <class Rewrite>
  void rewrite_nodes(Rewrite&& rewrite) {
    to_.graph.reserve(order_.size());
    for (const std::uint32_t id : order_) image_[id] = rewrite(id);
  }
  /// The rewritten program, with the images of the outputs.
  ValueProgram finished() {
    to_.function = from_.function;
    to_.formulation = from_.formulation;
    to_.inputs = from_.inputs;
    to_.outputs = from_.outputs;
    for (auto& output : to_.outputs)
      for (Value& v : output.values) v = image(v);
    return std::move(to_);
  }
  Value image(Value v) const { return image_[v.node()].negated_if(v.negative()); }

  const ValueProgram& from_;
  std::span<const std::uint32_t> order_, uses_;
  std::vector<Value> image_;
  ValueProgram to_;
};

}  // namespace alembert

#include "mechanism/symbols_below.hpp"

#include <algorithm>
#include <iterator>

namespace alembert {

SymbolsBelow::SymbolsBelow(const ExprGraph& graph, const Mechanism& mechanism)
    : sets_(graph.size()), kinds_(graph.size(), Dependence::none) {
  std::vector<int> coordinate_of(graph.symbol_count(), -1);
  std::vector<Dependence> kind_of(graph.symbol_count(), Dependence::none);
  const auto index = [&](const Expr& symbol) { return graph.symbol_index(symbol.ref().node()); };
  kind_of[index(mechanism.time)] = Dependence::time;
  for (std::size_t i = 0; i < mechanism.coordinates.size(); ++i) {
    for (const Expr& symbol : mechanism.coordinates[i].symbols) {
      coordinate_of[index(symbol)] = static_cast<int>(i);
      kind_of[index(symbol)] = Dependence::coordinate;
    }
    for (const Expr& symbol : mechanism.coordinates[i].speed_symbols)
      kind_of[index(symbol)] = Dependence::speed;
  }
  for (const FrameSymbols& of_frame : mechanism.frame_symbols)
    for (const Expr& symbol : of_frame.symbols) kind_of[index(symbol)] = Dependence::coordinate;

  for (std::uint32_t id = 0; id < graph.size(); ++id) {
    const Node& node = graph.node(id);
    if (node.op == Operation::symbol) {
      kinds_[id] = kind_of[graph.symbol_index(id)];
      if (const int c = coordinate_of[graph.symbol_index(id)]; c >= 0) sets_[id].push_back(c);
      continue;
    }
    const auto add = [&](Ref operand) {
      merge(sets_[id], sets_[operand.node()]);
      kinds_[id] = kinds_[id] | kinds_[operand.node()];
    };
    if (node.arity() >= 1) add(node.a);
    if (node.arity() >= 2) add(node.b);
  }
}

void SymbolsBelow::merge(std::vector<int>& into, const std::vector<int>& from) {
  if (from.empty()) return;
  std::vector<int> both;
  std::set_union(into.begin(), into.end(), from.begin(), from.end(), std::back_inserter(both));
  if (both.size() > kMost) both.resize(kMost);
  into = std::move(both);
}

}  // namespace alembert

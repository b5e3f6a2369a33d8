// Constants that agree to rounding are made one. See close_constants.hpp.
#include "symbolic/close_constants.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "support/no_index.hpp"
#include "symbolic/node_index.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/rebuilt.hpp"

namespace alembert {
namespace {

constexpr std::uint64_t kCloseUnits = 4;  // in the last place

// Of positive normal numbers.
bool are_close(double x, double y) {
  const auto a = std::bit_cast<std::uint64_t>(x), b = std::bit_cast<std::uint64_t>(y);
  return (a > b ? a - b : b - a) <= kCloseUnits;
}

struct Number {
  double magnitude;
  std::uint32_t id;
  bool computed;
};

// In order of first occurrence.
std::vector<Number> numbers_of(const ExprGraph& graph, const Postorder& order) {
  std::vector<Number> out;
  for (const std::uint32_t id : order.ids) {
    const Operation op = graph.node(id).op;
    if (op != Operation::real && op != Operation::rational) continue;
    const double value = op == Operation::real ? graph.real_value(id) : graph.rational_value(id).to_double();
    if (std::isnormal(value)) out.push_back({std::abs(value), id, op == Operation::real});
  }
  return out;
}

bool any_close(std::vector<Number> numbers) {
  std::sort(numbers.begin(), numbers.end(), [](const Number& x, const Number& y) {
    return x.magnitude != y.magnitude ? x.magnitude < y.magnitude : x.computed < y.computed;
  });
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const Number &low = numbers[i - 1], &high = numbers[i];
    if ((low.computed || high.computed) && are_close(low.magnitude, high.magnitude)) return true;
  }
  return false;
}

// Computed constant -> the one that stands for it.
NodeIndex replacements(const std::vector<Number>& numbers) {
  std::map<double, std::uint32_t> kept;
  const auto closest = [&kept](double x) -> std::optional<std::uint32_t> {
    const auto above = kept.lower_bound(x);
    const bool high = above != kept.end() && are_close(above->first, x);
    const bool low = above != kept.begin() && are_close(std::prev(above)->first, x);
    if (!high && !low) return std::nullopt;
    if (!low || (high && above->first - x < x - std::prev(above)->first)) return above->second;
    return std::prev(above)->second;
  };
  NodeIndex out;
  for (const Number& number : numbers) {
    if (!number.computed) kept.emplace(number.magnitude, number.id);
  }
  for (const Number& number : numbers) {
    if (!number.computed) continue;
    if (const auto other = closest(number.magnitude))
      out.add(number.id, *other);
    else
      kept.emplace(number.magnitude, number.id);
  }
  return out;
}

}  // namespace

std::vector<Expr> merge_close_constants(std::span<const Expr> roots) {
  std::vector<Expr> out(roots.begin(), roots.end());
  ExprGraph* graph = graph_of(roots);
  if (graph == nullptr) return out;
  const Postorder order = indexed_postorder(roots);
  const std::vector<Number> numbers = numbers_of(*graph, order);
  if (!any_close(numbers)) return out;
  const NodeIndex replaced = replacements(numbers);
  return rebuilt(roots, [&](std::uint32_t id, Ref a, Ref b) {
    if (const std::uint32_t other = replaced.find(id); other != kNoIndex) return Ref(other, false);
    return graph->node(id).constant ? Ref(id, false) : graph->remade(id, a, b);
  });
}

}  // namespace alembert

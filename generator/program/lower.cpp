// Stage `lower`: expressions in, straight-line program out. Constant subexpressions are folded to one double
// each; everything else keeps its shape, each node becoming one value.
//
// Besides `verify` the only stage of this room that knows expressions. The order of everything follows
// `postorder`, which is structural, so that the program does not depend on the order in which the expressions
// were built.
#include "program/lower.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "program/sign_placement.hpp"
#include "program/value_graph.hpp"
#include "support/error.hpp"
#include "support/operation.hpp"
#include "symbolic/extended.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {
namespace {

// A sum of constants that cancels to less of its terms has no longer the digits of a double.
constexpr long double kLostDigits = 0x1p-11L;
// A sum with constants that were rounded to doubles is zero where it cancels to this fraction of its terms.
constexpr long double kCancellation = 0x1p-58L;

bool has_rounded(const Expr& constant) {
  const ExprGraph& graph = constant.graph();
  const std::vector<std::uint32_t> nodes = postorder({&constant, 1});
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](std::uint32_t id) { return graph.node(id).op == Operation::real; });
}

// What is left of the sum where its terms, of which `term` is one, cancel to `left`. With 50 digits it is told
// whether that is zero or a small number, as it is for axes that are parallel to 1e-19.
long double remainder_of(const Expr& sum, long double term, long double left) {
  if (has_rounded(sum)) return std::abs(left) < kCancellation * std::abs(term) ? 0 : left;
  const Extended value = extended_value_of(sum);
  return abs(value) < kExtendedRounding * std::abs(term) ? 0 : value.convert_to<long double>();
}

// Extended precision leaves one rounding, to double, that matters.
long double fold(ExprGraph& graph, std::uint32_t id, const std::vector<long double>& folded) {
  const Node& n = graph.node(id);
  const auto value = [&folded](Ref r) { return r.negative() ? -folded[r.node()] : folded[r.node()]; };
  if (n.op == Operation::rational) {
    const Rational r = graph.rational_value(id);
    return static_cast<long double>(r.numerator) / static_cast<long double>(r.denominator);
  }
  if (n.op == Operation::pi_multiple) {
    const Rational r = graph.rational_value(id);
    return std::numbers::pi_v<long double> * static_cast<long double>(r.numerator) /
           static_cast<long double>(r.denominator);
  }
  if (n.op == Operation::real) return graph.real_value(id);
  if (n.op == Operation::add) {
    const long double a = value(n.a), b = value(n.b), sum = a + b;
    return std::abs(sum) < kLostDigits * std::abs(a) ? remainder_of(Expr(graph, Ref(id, false)), a, sum)
                                                     : sum;
  }
  return apply(n.op, value(n.a), n.arity() == 2 ? value(n.b) : 0.0L);
}

double to_double(ExprGraph& graph, std::uint32_t id, long double folded) {
  const Operation op = graph.node(id).op;
  const double value =
      op == Operation::rational ? graph.rational_value(id).to_double() : static_cast<double>(folded);
  if (!std::isfinite(value))
    throw InternalError("lower: the constant " + to_string(Expr(graph, Ref(id, false))) +
                        " has no finite value");
  return value;
}

}  // namespace

Program lower(std::string function, std::span<const OutputExpressions> outputs,
              std::span<const SymbolBinding> bindings) {
  ValueProgram program;
  program.function = std::move(function);
  for (const SymbolBinding& binding : bindings) program.inputs.push_back(binding.slot);

  std::vector<Expr> roots;
  for (const OutputExpressions& output : outputs) {
    program.outputs.push_back({output.name, output.rows, output.columns, {}});
    if (output.values.size() != std::size_t{output.rows} * output.columns)
      throw InternalError("lower: output " + output.name + " of " + program.function + " has " +
                          std::to_string(output.values.size()) + " elements, not rows x columns");
    roots.insert(roots.end(), output.values.begin(), output.values.end());
  }
  if (!roots.empty()) {
    ExprGraph& graph = roots.front().graph();
    std::vector<std::uint32_t> slot_of(graph.symbol_count(), kNone);
    for (std::uint32_t i = 0; i < bindings.size(); ++i)
      slot_of[graph.symbol_index(bindings[i].symbol.ref().node())] = i;

    const std::vector<std::uint32_t> order = postorder(roots);
    program.graph.reserve(order.size());
    std::vector<Value> values(graph.size());
    std::vector<long double> folded(graph.size(), 0);
    const auto value_of = [&](Ref r) {
      if (graph.node(r.node()).constant) {
        const double c = to_double(graph, r.node(), folded[r.node()]);
        return program.graph.constant(r.negative() ? -c : c);
      }
      return values[r.node()].negated_if(r.negative());
    };
    for (const std::uint32_t id : order) {
      const Node& n = graph.node(id);
      if (n.constant) {
        folded[id] = fold(graph, id, folded);
      } else if (n.op == Operation::symbol) {
        const std::uint32_t index = graph.symbol_index(id);
        if (slot_of[index] == kNone)
          throw InternalError("lower: " + program.function + " depends on the symbol '" +
                              graph.symbol_name(index) + "', which no argument stands for");
        values[id] = program.graph.input(slot_of[index]);
      } else if (n.op == Operation::div && graph.node(n.b.node()).constant) {
        // The reciprocal in extended precision, so that only its rounding to double is seen.
        const long double divisor = folded[n.b.node()];
        const double reciprocal = static_cast<double>(1 / divisor);
        const Value a = value_of(n.a);
        if (std::isnormal(reciprocal))
          values[id] = program.graph.make(
              Operation::mul, program.graph.constant(n.b.negative() ? -reciprocal : reciprocal), a);
        else
          values[id] = program.graph.make(Operation::div, a, value_of(n.b));
      } else {
        const Value a = value_of(n.a);
        const Value b = n.arity() == 2 ? value_of(n.b) : Value();
        values[id] = program.graph.make(n.op, a, b);
      }
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      for (const Expr& e : outputs[i].values) program.outputs[i].values.push_back(value_of(e.ref()));
    }
  }
  return place_signs(program);
}

}  // namespace alembert

// Stage `optimise`: program in, equal program out that never costs more.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/operation.hpp"
#include "program/passes.hpp"
#include "program/rewrites.hpp"
#include "program/to_expressions.hpp"
#include "program/value_graph.hpp"
#include "support/error.hpp"
#include "symbolic/passes.hpp"

namespace alembert {
namespace {

// Rounds of all rewrites; the first that gains nothing ends the work, in practice the third to fifth.
constexpr int kRounds = 8;

// Operations weighted by their time: a division counts as four, a negation only between equals.
struct Cost {
  std::size_t operations = 0, negations = 0;
  friend bool operator<(const Cost& x, const Cost& y) {
    return x.operations != y.operations ? x.operations < y.operations : x.negations < y.negations;
  }
};

Cost cost(const Program& program) {
  const OperationCount n = count(program);
  Cost out{n.mul + n.add + kDivisionWeight * n.div + n.trig + n.other, 0};
  for (const Instruction& c : program.code) out.negations += c.op == Operation::neg;
  return out;
}

// The program with equal values merged, as probabilistic value numbering of its expressions finds them:
// rewriting brings forth values that are there already in another form.
std::optional<ValueProgram> merge_equal_values(const Program& program) {
  ExprGraph graph;
  const std::optional<std::vector<Expr>> given = to_expressions(program, graph);
  if (!given) return std::nullopt;
  const std::vector<Expr> numbered = value_number(*given);
  std::vector<SymbolBinding> bindings;
  const std::vector<Expr> symbols = input_symbols(program, graph);
  for (std::size_t i = 0; i < symbols.size(); ++i) bindings.push_back({symbols[i], program.inputs[i]});
  std::vector<OutputExpressions> outputs;
  auto next = numbered.begin();
  for (const OutputArray& output : program.outputs) {
    const auto size = static_cast<std::ptrdiff_t>(output.values.size());
    outputs.push_back({output.name, output.rows, output.columns, {next, next + size}});
    next += size;
  }
  Program merged = lower(program.function, outputs, bindings);
  merged.formulation = program.formulation;
  return to_values(merged);
}

/// A program and what it costs.
struct Candidate {
  Program program;
  Cost cost;
};

// The local rewrites, each kept if it gains, until none does.
Candidate rewrite(ValueProgram values, CommonPairs pairs) {
  Candidate best;
  best.program = place_signs(values);
  best.cost = cost(best.program);
  const auto accept = [&](const std::optional<ValueProgram>& rewritten) {
    if (!rewritten) return false;
    Candidate next{place_signs(*rewritten), {}};
    next.cost = cost(next.program);
    if (!(next.cost < best.cost)) return false;
    best = std::move(next);
    values = to_values(best.program);
    return true;
  };
  for (int round = 0; round < kRounds; ++round) {
    const bool factored = accept(factor_sums(values, pairs));
    const bool divided = accept(share_divisions(values));
    const bool bracketed = accept(share_products(values));
    if (!factored && !divided && !bracketed) break;
  }
  return best;
}

// Rewriting and value numbering in turn, for as long as that gains.
Candidate rewrite_and_merge(const Program& program, CommonPairs pairs) {
  Candidate best = rewrite(to_values(program), pairs);
  for (int round = 0; round < kRounds; ++round) {
    const std::optional<ValueProgram> merged = merge_equal_values(best.program);
    if (!merged) break;
    Candidate next = rewrite(*merged, pairs);
    if (!(next.cost < best.cost)) break;
    best = std::move(next);
  }
  return best;
}

}  // namespace

Program optimize(Program program) {
  const Cost given = cost(program);
  Candidate best = rewrite_and_merge(program, CommonPairs::taken_apart);
  Candidate other = rewrite_and_merge(program, CommonPairs::spared);
  if (other.cost < best.cost) best = std::move(other);
  if (given < best.cost) best = {std::move(program), given};
  if (given < cost(best.program))
    throw InternalError("optimise: " + best.program.function + " costs more than before");
  return std::move(best.program);
}

}  // namespace alembert

// Stage `optimise`: program in, equal program out that never costs more.
#include "program/rewrite/optimize.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/count.hpp"
#include "program/lower.hpp"
#include "program/rewrite/factor_sums.hpp"
#include "program/rewrite/share_divisions.hpp"
#include "program/rewrite/share_products.hpp"
#include "program/sign_placement.hpp"
#include "program/to_expressions.hpp"
#include "program/value_graph.hpp"
#include "support/error.hpp"
#include "support/operation.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

// Rounds of all rewrites at most; all of them in a row without a gain end the work, in practice in the third
// to fifth.
constexpr int kRounds = 8;

// The weight of all operations; a negation counts only between equals.
struct Cost {
  std::size_t weight = 0, negations = 0;
  friend bool operator<(const Cost& x, const Cost& y) {
    return x.weight != y.weight ? x.weight < y.weight : x.negations < y.negations;
  }
};

Cost cost(const Program& program) {
  Cost out{count(program).weight, 0};
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

Candidate candidate(Program program) {
  const Cost its = cost(program);
  return {std::move(program), its};
}

class Rewriting {
 public:
  explicit Rewriting(CommonPairs pairs) : pairs_(pairs) {}
  Candidate run(const Program& program);
  bool any_spared() const { return any_spared_; }

 private:
  Candidate rewrite(ValueProgram program);

  CommonPairs pairs_;
  bool any_spared_ = false;
};

// The local rewrites, each kept if it gains, until none does. The first, which is nearly certain to gain, is
// not compared: callers compare what comes out.
Candidate Rewriting::rewrite(ValueProgram program) {
  LiveProgram values(std::move(program));
  std::optional<Candidate> best;
  const auto rewritten = [&](int which) {
    if (which == 0) return factor_sums(values, pairs_, any_spared_);
    return which == 1 ? share_divisions(values) : share_products(values);
  };
  constexpr int kRewrites = 3;
  int failed = 0;  // since the last gain
  for (int i = 0; i < kRounds * kRewrites && failed < kRewrites; ++i) {
    ++failed;
    const std::optional<ValueProgram> other = rewritten(i % kRewrites);
    if (!other) continue;
    Candidate next = candidate(place_signs(*other));
    if (best && !(next.cost < best->cost)) continue;
    best = std::move(next);
    values = LiveProgram(to_values(best->program));
    failed = 0;
  }
  return best ? *std::move(best) : candidate(place_signs(values.values));
}

// Rewriting and value numbering in turn, for as long as that gains.
Candidate Rewriting::run(const Program& program) {
  Candidate best = rewrite(to_values(program));
  for (int round = 0; round < kRounds; ++round) {
    const std::optional<ValueProgram> merged = merge_equal_values(best.program);
    if (!merged) break;
    Candidate next = rewrite(*merged);
    if (!(next.cost < best.cost)) break;
    best = std::move(next);
  }
  return best;
}

}  // namespace

Program without_unused_inputs(Program program) {
  std::vector<std::uint32_t> place(program.inputs.size(), 0);
  for (const Instruction& i : program.code) {
    if (i.op == Operation::input) place[i.a] = 1;
  }
  std::vector<InputSlot> used;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(used.size());
    used.push_back(program.inputs[i]);
  }
  for (Instruction& i : program.code) {
    if (i.op == Operation::input) i.a = place[i.a];
  }
  program.inputs = std::move(used);
  return program;
}

Program optimize(Program program) {
  const Cost given = cost(program);
  Rewriting sparing(CommonPairs::spared);
  Candidate best = sparing.run(program);
  if (sparing.any_spared()) {
    Candidate other = Rewriting(CommonPairs::taken_apart).run(program);
    if (!(best.cost < other.cost)) best = std::move(other);
  }
  if (given < best.cost) best = {std::move(program), given};
  if (given < cost(best.program))
    throw InternalError("optimise: " + best.program.function + " costs more than before");
  return std::move(best.program);
}

}  // namespace alembert

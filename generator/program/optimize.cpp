// Stage `optimise`: program in, equal program out that never costs more.
#include <optional>
#include <string>
#include <utility>

#include "program/operation.hpp"
#include "program/passes.hpp"
#include "program/rewrites.hpp"
#include "program/value_graph.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

// Rounds of all rewrites; each round that gains nothing ends the work, which in practice the third does.
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

}  // namespace

Program optimize(Program program) {
  const Cost given = cost(program);
  ValueProgram values = to_values(program);
  Program best = place_signs(values);
  Cost least = cost(best);
  if (given < least) {
    best = std::move(program);
    least = given;
  }
  const auto accept = [&](const std::optional<ValueProgram>& candidate) {
    if (!candidate) return false;
    Program placed = place_signs(*candidate);
    const Cost reached = cost(placed);
    if (!(reached < least)) return false;
    best = std::move(placed);
    least = reached;
    values = to_values(best);
    return true;
  };
  for (int round = 0; round < kRounds; ++round) {
    const bool factored = accept(factor_sums(values));
    const bool divided = accept(share_divisions(values));
    if (!factored && !divided) break;
  }
  if (given < cost(best)) throw InternalError("optimise: " + best.function + " costs more than before");
  return best;
}

}  // namespace alembert

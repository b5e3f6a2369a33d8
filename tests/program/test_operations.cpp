// Every row of the table of operations works everywhere: as an expression, modulo a prime, differentiated,
// printed, counted, lowered and read back. Nothing here names an operation.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "differentiation/partials.hpp"
#include "program/count.hpp"
#include "program/dump.hpp"
#include "program/interpret.hpp"
#include "program/lower.hpp"
#include "program/optimized.hpp"
#include "program/verify/verify.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {
namespace {

constexpr double kA = 0.4, kB = 0.7;

class EveryOperation : public testing::TestWithParam<Operation> {
 protected:
  EveryOperation() : x(graph.symbol("x")), y(graph.symbol("y")), value(apply(GetParam(), x, y)) {}
  std::string name() const { return std::string(operation_name(GetParam())); }

  ExprGraph graph;
  Expr x, y, value;
  std::vector<double> at{kA, kB};
};

TEST_P(EveryOperation, HasItsValueAsAnExpressionAndAsAProgram) {
  const double expected = apply(GetParam(), kA, kB);
  EXPECT_DOUBLE_EQ(evaluate({&value, 1}, at)[0], expected);
  const std::vector<Expr> simplified = simplify({&value, 1});
  EXPECT_DOUBLE_EQ(evaluate(simplified, at)[0], expected);

  const std::vector<OutputExpressions> outputs{{"out", 1, 1, {value}}};
  const std::vector<SymbolBinding> bindings{{x, {ArgumentKind::q, 0, "x"}}, {y, {ArgumentKind::q, 1, "y"}}};
  const Program program = lower("f", outputs, bindings);
  std::vector<double> out(1), scratch;
  interpret(program, at, out, scratch);
  EXPECT_DOUBLE_EQ(out[0], expected);
  verify(program, outputs, bindings);
  const OperationCount n = count(program);
  EXPECT_EQ(n.arithmetic() + n.div + n.trig + n.other, facts(GetParam()).counted == Counted::free ? 0u : 1u);
  EXPECT_NE(dump(program).find(name()), std::string::npos) << dump(program);
  if (is_call(GetParam())) {
    EXPECT_NE(to_string(value).find(name() + "("), std::string::npos) << to_string(value);
  }

  ExprGraph other;
  const std::vector<OutputExpressions> back =
      expressions_of(program, {other.symbol("x"), other.symbol("y")}, other);
  EXPECT_DOUBLE_EQ(evaluate(back[0].values, at)[0], expected);
}

TEST_P(EveryOperation, HasItsDerivative) {
  constexpr double kStep = 1e-6;
  const Ref ref = value.ref();
  for (int slot = 0; slot < graph.node(ref.node()).arity(); ++slot) {
    const double da = slot == 0 ? kStep : 0, db = slot == 1 ? kStep : 0;
    const double slope =
        (apply(GetParam(), kA + da, kB + db) - apply(GetParam(), kA - da, kB - db)) / (2 * kStep);
    if (is_leaf(graph.node(ref.node()).op)) continue;  // a sign only
    // The node may hold its operands the other way round, and the second with a sign.
    const Expr derivative(graph, local_partial(graph, ref.node(), slot));
    const Node node = graph.node(ref.node());
    const bool swapped = Expr(graph, Ref(node.a.node(), false)) == y && node.arity() == 2;
    const double other_slope =
        (apply(GetParam(), kA + db, kB + da) - apply(GetParam(), kA - db, kB - da)) / (2 * kStep);
    EXPECT_NEAR(evaluate({&derivative, 1}, at)[0] * (ref.negative() ? -1 : 1), swapped ? other_slope : slope,
                1e-8)
        << name() << " " << slot;
  }
}

TEST_P(EveryOperation, KeepsItsParityModuloAPrime) {
  const std::vector<Expr> both{value, apply(GetParam(), -x, y)};
  const std::vector<Modular> values = evaluate_modular(both, random_modular_point(2, 1));
  EXPECT_NE(values[0], Modular{});
  if (parity(GetParam()) == Parity::even) {
    EXPECT_EQ(values[0], values[1]);
  }
  if (parity(GetParam()) == Parity::odd) {
    EXPECT_EQ(values[0], modular::negate(values[1]));
  }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryOperation, [] {
  std::vector<Operation> all;
  for (const OperationFacts& row : kOperationFacts)
    if (!is_leaf(row.operation)) all.push_back(row.operation);
  return testing::ValuesIn(all);
}());

}  // namespace
}  // namespace alembert

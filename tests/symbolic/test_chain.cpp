// Depth: every pass works on a chain of a million nodes, so none recurses on it.
#include <cmath>

#include "symbolic/coefficient.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

constexpr std::size_t kDepth = 1000000;

TEST(Chain, OfAMillionNodesThroughEveryPass) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
  Expr linear = x;
  for (std::size_t i = 0; i < kDepth / 2; ++i) linear = linear * y + z;
  const std::vector<Expr> roots{linear};
  const std::vector<std::uint32_t> order = postorder(roots);
  EXPECT_EQ(order.size(), kDepth + 3);

  const std::vector<std::pair<Expr, Expr>> swap{{y, z}, {z, y}};
  const std::vector<Expr> swapped = substitute(roots, swap);
  EXPECT_EQ(postorder(swapped).size(), order.size());
  EXPECT_EQ(evaluate(swapped, std::vector<double>{0.5, 0.75, 0.25}),
            evaluate(roots, std::vector<double>{0.5, 0.25, 0.75}));
  EXPECT_TRUE(coefficient(roots, x)[0].valid());

  const std::vector<Modular> point = random_modular_point(g.symbol_count(), 1);
  const std::vector<Modular> exact = evaluate_modular(roots, point);
  EXPECT_EQ(to_string(linear, 100).size(), 103u);
  EXPECT_EQ(count_operations(roots).total(), kDepth);
  EXPECT_EQ(g.bounds(linear.ref()).lower, -HUGE_VAL);
  EXPECT_EQ(evaluate_modular(value_number(roots), point), exact);
  EXPECT_EQ(evaluate_modular(simplify(roots), point), exact);
}

TEST(Chain, WithQuotientsAndSines) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
  Expr chain = x;
  while (g.size() < kDepth / 5) chain = y / (sin(chain * z + y) - z);
  const std::vector<Expr> roots{chain};
  const std::vector<Modular> point = random_modular_point(g.symbol_count(), 1);
  EXPECT_EQ(evaluate_modular(simplify(roots), point), evaluate_modular(roots, point));
  EXPECT_THROW(coefficient(roots, x), NotLinear);
  EXPECT_EQ(to_string(chain, 100).size(), 103u);
}

TEST(Chain, OfEveryFunction) {
  for (const Operation op :
       {Operation::sqrt, Operation::sin, Operation::cos, Operation::tan, Operation::atan, Operation::exp,
        Operation::abs, Operation::sinh, Operation::cosh, Operation::tanh}) {
    ExprGraph graph;
    const Expr a = graph.symbol("a"), b = graph.symbol("b");
    Expr e = a;
    for (std::size_t i = 0; i < kDepth / 40; ++i) {
      e = Expr(graph, graph.make(op, e.ref()));
      e = e - b;
    }
    EXPECT_EQ(postorder(std::vector<Expr>{e}).size(), 2 * (kDepth / 40) + 2);
    EXPECT_EQ(simplify(std::vector<Expr>{e}).size(), 1u);
  }
}

TEST(Chain, OfCancellingSums) {
  ExprGraph graph;
  const Expr a = graph.symbol("a");
  Expr p = a, q = -a;
  for (std::size_t i = 0; i < kDepth / 40; ++i) {
    const Expr term = graph.symbol(numbered('t', i % 100)) * graph.integer(static_cast<std::int64_t>(i) + 2);
    p = p + term;
    q = q - term;
  }
  EXPECT_TRUE(same(value_number(std::vector<Expr>{p + q})[0], graph.zero()));
}

}  // namespace
}  // namespace alembert

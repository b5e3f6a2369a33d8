// Depth: every pass works on two chains of a million nodes together, so none recurses on it.
#include "symbolic/same.hpp"

namespace alembert {
namespace {

constexpr std::size_t kDepth = 1000000;

class Chain : public testing::Test {
 protected:
  Chain() {
    chain = x;
    for (std::size_t i = 0; g.size() < kDepth / 2; ++i) {
      switch (i % 4) {
        case 0:
          chain = chain + y;
          break;
        case 1:
          chain = chain * z;
          break;
        case 2:
          chain = sin(chain);
          break;
        default:
          chain = y / (chain - z);
          break;
      }
    }
    linear = x;
    for (std::size_t i = 0; i < kDepth / 4; ++i) linear = linear * y + z;
  }
  static ExprGraph g;
  Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
  Expr chain, linear;
  std::vector<double> at{0.5, 0.25, 0.75};
};
ExprGraph Chain::g;

TEST_F(Chain, EveryPass) {
  const std::vector<Expr> roots{chain, linear};
  const std::vector<std::uint32_t> order = postorder(roots);
  EXPECT_GE(order.size(), kDepth - 4);

  const std::vector<std::pair<Expr, Expr>> swap{{y, z}, {z, y}};
  const std::vector<Expr> swapped = substitute(roots, swap);
  EXPECT_EQ(postorder(swapped).size(), order.size());
  EXPECT_EQ(evaluate(swapped, std::vector<double>{0.5, 0.75, 0.25}), evaluate(roots, at));

  EXPECT_TRUE(coefficient(std::vector<Expr>{linear}, x)[0].valid());
  EXPECT_THROW(coefficient(std::vector<Expr>{chain}, x), NotLinear);

  const std::vector<Modular> point = random_modular_point(g.symbol_count(), 1);
  const std::vector<Modular> exact = evaluate_modular(roots, point);
  EXPECT_EQ(to_string(linear, 100).size(), 103u);
  EXPECT_EQ(to_string(chain, 100).size(), 103u);
  EXPECT_GE(count_operations(roots).total(), kDepth * 8 / 10);
  EXPECT_LE(g.bounds(abs(chain).ref()).lower, 0.0);
  EXPECT_EQ(evaluate_modular(value_number(roots), point), exact);
  EXPECT_EQ(evaluate_modular(simplify(roots), point), exact);
}

TEST_F(Chain, OfEveryFunction) {
  for (const Op op :
       {Op::sqrt, Op::sin, Op::cos, Op::tan, Op::atan, Op::exp, Op::abs, Op::sinh, Op::cosh, Op::tanh}) {
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

TEST_F(Chain, OfCancellingSums) {
  ExprGraph graph;
  const Expr a = graph.symbol("a");
  Expr p = a, q = -a;
  for (std::size_t i = 0; i < kDepth / 40; ++i) {
    const Expr term =
        graph.symbol("t" + std::to_string(i % 100)) * graph.integer(static_cast<std::int64_t>(i) + 2);
    p = p + term;
    q = q - term;
  }
  EXPECT_TRUE(same(value_number(std::vector<Expr>{p + q})[0], graph.zero()));
}

}  // namespace
}  // namespace alembert

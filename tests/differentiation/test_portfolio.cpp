// How the methods compare in operations, over a fixed set of random functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "differentiation/d_star.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/random_functions.hpp"
#include "differentiation/reverse.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/to_string.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

std::size_t operations(const std::vector<Expr>& roots, const Jacobian& jacobian) {
  std::vector<Expr> all = roots;
  all.insert(all.end(), jacobian.entries.begin(), jacobian.entries.end());
  const OperationCount count = count_operations(value_number(all));
  return count.total() + count.trig;
}

TEST(Portfolio, TotalsOver400RandomFunctions) {
  std::size_t forward_total = 0, reverse_total = 0, d_star_total = 0, portfolio_total = 0;
  std::size_t d_star_alone = 0, reverse_alone = 0, forward_alone = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    ExprGraph graph;
    test::RandomFunctions make(graph, 7000 + seed);
    const test::RandomFunction f = make({.nodes = 16 + static_cast<int>(seed % 25),
                                         .variables = 2 + static_cast<int>(seed % 5),
                                         .roots = 1 + static_cast<int>(seed % 6)});
    const std::size_t forward = operations(f.roots, jacobian_forward(f.roots, f.variables));
    const std::size_t reverse = operations(f.roots, jacobian_reverse(f.roots, f.variables));
    const std::size_t d_star = operations(f.roots, jacobian_d_star(f.roots, f.variables));
    const std::size_t portfolio = operations(f.roots, jacobian(f.roots, f.variables));
    EXPECT_EQ(portfolio, std::min({forward, reverse, d_star})) << "seed " << seed;
    forward_total += forward;
    reverse_total += reverse;
    d_star_total += d_star;
    portfolio_total += portfolio;
    d_star_alone += d_star < std::min(forward, reverse) ? 1 : 0;
    reverse_alone += reverse < std::min(forward, d_star) ? 1 : 0;
    forward_alone += forward < std::min(reverse, d_star) ? 1 : 0;
  }
  std::printf(
      "operations of 400 functions and their derivatives: forward %zu, reverse %zu, D* %zu, cheapest of each "
      "%zu\n",
      forward_total, reverse_total, d_star_total, portfolio_total);
  std::printf("alone the cheapest: forward %zu times, reverse %zu, D* %zu\n", forward_alone, reverse_alone,
              d_star_alone);
  // What was reached. More is a loss; where it becomes less, so do these numbers.
  EXPECT_LE(forward_total, 10204u);
  EXPECT_LE(reverse_total, 10296u);
  EXPECT_LE(d_star_total, 9523u);
  EXPECT_LE(portfolio_total, 9307u);
  EXPECT_GE(d_star_alone, 60u);
}

TEST(Portfolio, PrefersForwardThenReverseWhereTheyAreEqual) {
  ExprGraph graph;
  const Expr x = graph.symbol("x");
  const std::vector<Expr> roots = {sin(x) * x}, variables = {x};
  EXPECT_EQ(jacobian(roots, variables).method, DerivativeMethod::forward);
}

TEST(Portfolio, DoesNotDependOnTheOrderInWhichNodesWereMade) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto text = [&](bool disturbed) {
      ExprGraph graph;
      if (disturbed) {
        // The same nodes and others, made beforehand in another order.
        for (int i = 6; i-- > 0;) {
          const Expr x = test::numbered_symbol(graph, "x", i);
          static_cast<void>(sin(x) * cos(x) + graph.symbol("parameter") * x);
        }
        test::RandomFunctions other(graph, seed + 999);
        static_cast<void>(other({.nodes = 40, .variables = 5, .roots = 3}));
      }
      test::RandomFunctions make(graph, seed);
      const test::RandomFunction f = make({.nodes = 30, .variables = 4, .roots = 4});
      std::string result;
      for (const Jacobian& jacobian :
           {jacobian_forward(f.roots, f.variables), jacobian_reverse(f.roots, f.variables),
            jacobian_d_star(f.roots, f.variables), alembert::jacobian(f.roots, f.variables)})
        for (const Expr& entry : jacobian.entries) result += to_string(entry, 4000) + "\n";
      return result;
    };
    EXPECT_EQ(text(false), text(true)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace alembert

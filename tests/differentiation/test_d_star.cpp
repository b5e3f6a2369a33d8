// D*: known factorings, cases that need care, limits, and products.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "differentiation/d_star.hpp"
#include "differentiation/derivative_graph.hpp"
#include "differentiation/factoring.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/labelled_graph.hpp"
#include "differentiation/products.hpp"
#include "differentiation/random_functions.hpp"
#include "differentiation/reverse.hpp"
#include "processor_time.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/modular.hpp"

namespace alembert {
namespace {

using Method = Jacobian (*)(std::span<const Expr>, std::span<const Expr>);

Jacobian checked_d_star(std::span<const Expr> roots, std::span<const Expr> variables) {
  return jacobian_d_star(roots, variables, {.check = true});
}

constexpr std::array<Method, 4> kMethods = {jacobian_forward, jacobian_reverse, checked_d_star, jacobian};

class Cases : public testing::Test {
 protected:
  ExprGraph graph;
  Expr x = graph.symbol("x"), y = graph.symbol("y"), z = graph.symbol("z");
  std::vector<Expr> variables = {x, y, z};
};

TEST_F(Cases, RootsThatAreVariables) {
  const std::vector<Expr> roots = {x, -y, x};
  for (const Method method : kMethods) {
    const Jacobian d = method(roots, variables);
    const Expr one = graph.one(), zero = graph.zero();
    EXPECT_EQ(d.entries, (std::vector<Expr>{one, zero, zero, zero, -one, zero, one, zero, zero}));
  }
}

TEST_F(Cases, RootsThatAreConstants) {
  const std::vector<Expr> roots = {graph.integer(3), graph.zero(), graph.symbol("parameter"),
                                   sin(graph.symbol("p"))};
  for (const Method method : kMethods) {
    const Jacobian d = method(roots, variables);
    EXPECT_EQ(d.rows, 4u);
    EXPECT_EQ(d.columns, 3u);
    for (const Expr& entry : d.entries) EXPECT_TRUE(entry.is_zero());
  }
}

TEST_F(Cases, RepeatedRootsHaveTheSameDerivatives) {
  const Expr f = sin(x * y) * z;
  const std::vector<Expr> roots = {f, -f, f};
  for (const Method method : kMethods) {
    const Jacobian d = method(roots, variables);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_EQ(d(2, j), d(0, j));
      EXPECT_EQ(d(1, j), -d(0, j));
    }
    EXPECT_EQ(d(0, 2), sin(x * y));
  }
}

TEST_F(Cases, RootsInsideOtherRoots) {
  const Expr inner = x * y;
  const Expr middle = sin(inner);
  const std::vector<Expr> roots = {middle * z, inner, middle};
  for (const Method method : kMethods) {
    const Jacobian d = method(roots, variables);
    EXPECT_EQ(d(1, 0), y);
    EXPECT_EQ(d(1, 1), x);
    EXPECT_TRUE(d(1, 2).is_zero());
    EXPECT_EQ(d(2, 0), cos(inner) * y);
    EXPECT_EQ(d(0, 2), middle);
  }
}

TEST_F(Cases, SquaresHaveParallelEdges) {
  const std::vector<Expr> roots = {x * x, sin(y) * sin(y)};
  for (const Method method : kMethods) {
    const Jacobian d = method(roots, variables);
    EXPECT_EQ(d(0, 0), graph.integer(2) * x);
    EXPECT_TRUE(d(0, 1).is_zero());
    const std::vector<Expr> difference = {d(1, 1) - graph.integer(2) * sin(y) * cos(y)};
    const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 5);
    EXPECT_EQ(evaluate_modular(difference, point).front(), Modular{});
  }
}

TEST_F(Cases, DerivativesThatCancel) {
  // The paths to x cancel at the first vertex that they meet in, those to y only as a whole.
  const Expr left = (x + y) * z;
  const Expr right = x * z + y * z;
  const std::vector<Expr> roots = {left - right, sin(left) - sin(left)};
  const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 6);
  for (const Method method : kMethods)
    for (const Modular& value : evaluate_modular(method(roots, variables).entries, point))
      EXPECT_EQ(value, Modular{});
}

TEST_F(Cases, PartialsThatAreZero) {
  const std::vector<Expr> roots = {sign(x * y), sign(x) * z};
  for (const Method method : kMethods) {
    const Jacobian d = method(roots, variables);
    EXPECT_TRUE(d(0, 0).is_zero());
    EXPECT_TRUE(d(0, 1).is_zero());
    EXPECT_TRUE(d(1, 0).is_zero());
    EXPECT_EQ(d(1, 2), sign(x));
  }
}

TEST_F(Cases, NothingToDo) {
  const std::vector<Expr> roots = {x * y};
  for (const Method method : kMethods) {
    EXPECT_EQ(method({}, variables).rows, 0u);
    EXPECT_EQ(method({}, variables).columns, 3u);
    EXPECT_TRUE(method({}, variables).entries.empty());
    EXPECT_TRUE(method(roots, {}).entries.empty());
    EXPECT_TRUE(method({}, {}).entries.empty());
  }
}

TEST_F(Cases, WhatIsNoVariable) {
  ExprGraph other;
  const std::vector<Expr> roots = {x * y};
  for (const Method method : kMethods) {
    EXPECT_THROW(method(roots, std::vector<Expr>{x * y}), std::invalid_argument);
    EXPECT_THROW(method(roots, std::vector<Expr>{-x}), std::invalid_argument);
    EXPECT_THROW(method(roots, std::vector<Expr>{x, y, x}), std::invalid_argument);
    EXPECT_THROW(method(roots, std::vector<Expr>{other.symbol("x")}), std::invalid_argument);
    EXPECT_THROW(method(roots, std::vector<Expr>{Expr()}), std::invalid_argument);
  }
}

/// Operations beyond those of the roots.
std::size_t extra(const std::vector<Expr>& roots, const Jacobian& d) {
  std::vector<Expr> all = roots;
  all.insert(all.end(), d.entries.begin(), d.entries.end());
  return count_operations(all).total() - count_operations(roots).total();
}

TEST(DStar, FactorsWhatManyDerivativesHaveInCommon) {
  // Several roots above a narrow waist above several variables. Forward mode multiplies each variable's way
  // below the waist with each root's way above it; so does reverse mode; factored, the waist is one edge.
  ExprGraph graph;
  std::vector<Expr> variables, roots;
  Expr waist = graph.one();
  for (int i = 0; i < 5; ++i) {
    variables.push_back(test::numbered_symbol(graph, "x", i));
    waist = i == 0 ? variables.back() : waist * sin(variables.back());
  }
  const Expr top = waist * waist * waist + cos(waist);
  for (int i = 0; i < 5; ++i)
    roots.push_back(test::numbered_symbol(graph, "c", i) * exp(top + graph.integer(i)));
  const Jacobian forward = jacobian_forward(roots, variables);
  const Jacobian reverse = jacobian_reverse(roots, variables);
  const Jacobian d_star = jacobian_d_star(roots, variables, {.check = true});
  EXPECT_EQ(d_star.method, DerivativeMethod::d_star);
  EXPECT_LT(extra(roots, d_star), extra(roots, forward));
  EXPECT_LT(extra(roots, d_star), extra(roots, reverse));
}

TEST(DStar, LabelsAreOfPairsNotOfRootsAndVariables) {
  ExprGraph graph;
  const Expr x = graph.symbol("x"), y = graph.symbol("y");
  const Expr f = sin(x), g = f * y;
  const std::vector<Expr> roots = {g, f}, variables = {x, y};
  const DerivativeGraph derivatives = derivative_graph(roots, variables);
  const std::optional<LabelledGraph> labelled = label_edges(derivatives, 1000);
  ASSERT_TRUE(labelled.has_value());
  // (g, x), (g, y), (f, x); d f / d y has no path.
  EXPECT_EQ(labelled->pairs.size(), 3u);
  EXPECT_EQ(labelled->pair_of[3], kNoIndex);
  std::size_t labels = 0;
  for (const PairSet& label : labelled->labels) label.for_each([&](std::size_t) { ++labels; });
  EXPECT_EQ(labels, 4u);  // g-f-x for the first, g-y for the second, f-x for the third
  check_labels(*labelled);
}

TEST(DStar, BrokenInvariantsAreNoticed) {
  ExprGraph graph;
  const Expr x = graph.symbol("x"), y = graph.symbol("y");
  const std::vector<Expr> roots = {sin(x * y) * x * y}, variables = {x, y};
  const DerivativeGraph derivatives = derivative_graph(roots, variables);
  const LabelledGraph good = *label_edges(derivatives, 1000);
  EXPECT_NO_THROW(check_labels(good));
  EXPECT_THROW(check_single_path(good, 0), InternalError);
  LabelledGraph bad = good;
  bad.labels.front().erase(0);
  EXPECT_THROW(check_labels(bad), InternalError);
  bad = good;
  bad.pairs[0].arcs.erase(bad.pairs[0].arcs.begin(), bad.pairs[0].arcs.begin() + 2);
  EXPECT_THROW(check_labels(bad), InternalError);

  // An edge whose value is changed behind its back is found by the path sums of the next step.
  LabelledGraph changed = good;
  Factoring factoring(graph, changed, derivatives.nodes.size(), {100, 100000}, true);
  for (DerivativeEdge& edge : changed.edges)
    if (edge.top == derivatives.nodes.size() - 1) edge.value = graph.integer(7).ref();
  EXPECT_THROW(factoring.run(), InternalError);
}

TEST(DStar, GivesUpAtTheStepCap) {
  ExprGraph graph;
  test::RandomFunctions make(graph, 3);
  const test::RandomFunction f = make({.nodes = 60, .variables = 5, .roots = 5});
  const Jacobian whole = jacobian_d_star(f.roots, f.variables);
  EXPECT_FALSE(whole.d_star_gave_up);
  EXPECT_EQ(whole.method, DerivativeMethod::d_star);
  for (const DStarOptions& options :
       {DStarOptions{.max_steps = 0}, DStarOptions{.max_steps = 3}, DStarOptions{.max_work = 10}}) {
    const Jacobian cut = jacobian_d_star(f.roots, f.variables, options);
    EXPECT_TRUE(cut.d_star_gave_up);
    EXPECT_EQ(cut.method, DerivativeMethod::reverse);
    EXPECT_EQ(cut.entries, jacobian_reverse(f.roots, f.variables).entries);
  }
}

TEST(DStar, StoppingAnywhereLeavesTheDerivativesRight) {
  ExprGraph graph;
  test::RandomFunctions make(graph, 8);
  const test::RandomFunction f = make({.nodes = 120, .variables = 4, .roots = 5});
  const DerivativeGraph derivatives = derivative_graph(f.roots, f.variables);
  const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 9);
  const std::vector<Modular> expected =
      evaluate_modular(jacobian_forward(f.roots, f.variables).entries, point);
  std::uint64_t steps = 0;
  for (std::uint64_t cap = 0;; ++cap) {
    LabelledGraph labelled = *label_edges(derivatives, 1'000'000);
    Factoring factoring(graph, labelled, derivatives.nodes.size(), {cap, 1'000'000}, false);
    const bool finished = factoring.run();
    check_labels(labelled);
    std::vector<Expr> edges;
    for (const DerivativeEdge& edge : labelled.edges) edges.push_back(derivatives.expr(edge.value));
    const std::vector<Modular> values = evaluate_modular(edges, point);
    for (std::size_t k = 0; k < labelled.pair_of.size(); ++k) {
      if (labelled.pair_of[k] == kNoIndex) continue;
      Modular sum = path_sum(labelled, labelled.pair_of[k], values);
      const Expr root = f.roots[k / f.variables.size()];
      if (root.ref().negative()) {
        constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;
        sum = {(kPrime - sum.re) % kPrime, (kPrime - sum.im) % kPrime};
      }
      EXPECT_EQ(sum, expected[k]) << "after " << cap << " steps";
    }
    steps = factoring.steps();
    if (finished) break;
  }
  EXPECT_GT(steps, 10u);
}

TEST(LongChains, OfFunctions) {
  ExprGraph graph;
  const Expr x = graph.symbol("x");
  Expr chain = x;
  for (int i = 0; i < 1'000'000; ++i) chain = i % 2 == 0 ? sin(chain) : exp(chain);
  const std::vector<Expr> roots = {chain}, variables = {x};
  const test::ProcessorTime time;
  const Jacobian forward = jacobian_forward(roots, variables);
  const Jacobian reverse = jacobian_reverse(roots, variables);
  const Jacobian d_star = jacobian_d_star(roots, variables);
  EXPECT_FALSE(d_star.d_star_gave_up);  // there is but one path
  const std::vector<Expr> all = {forward(0, 0), reverse(0, 0), d_star(0, 0)};
  const std::vector<Modular> values = evaluate_modular(all, random_modular_point(1, 12));
  EXPECT_EQ(values[1], values[0]);
  EXPECT_EQ(values[2], values[0]);
  EXPECT_LT(time.seconds(), 120);  // it takes a few; a quadratic method takes hours
}

TEST(LongChains, OfBranches) {
  // 2^500000 paths.
  ExprGraph graph;
  const Expr x = graph.symbol("x");
  Expr chain = x;
  for (int i = 0; i < 500'000; ++i) chain = chain * sin(chain);
  const std::vector<Expr> roots = {chain}, variables = {x};
  const test::ProcessorTime time;
  const Jacobian forward = jacobian_forward(roots, variables);
  const Jacobian reverse = jacobian_reverse(roots, variables);
  const Jacobian d_star = jacobian_d_star(roots, variables);
  EXPECT_TRUE(d_star.d_star_gave_up);
  const std::vector<Expr> all = {forward(0, 0), reverse(0, 0)};
  const std::vector<Modular> values = evaluate_modular(all, random_modular_point(1, 13));
  EXPECT_EQ(values[1], values[0]);
  EXPECT_LT(time.seconds(), 120);
}

TEST(Products, ShareTheMostFrequentNeighbours) {
  ExprGraph graph;
  std::vector<Ref> f;
  for (int i = 0; i < 5; ++i) f.push_back(test::numbered_symbol(graph, "f", i).ref());
  const Expr f0(graph, f[0]), f1(graph, f[1]), f2(graph, f[2]), f3(graph, f[3]), f4(graph, f[4]);
  const std::vector<std::vector<Ref>> paths = {{f[0], f[1], f[2]}, {f[3], f[1], f[2]}, {f[4], f[1], f[2]},
                                               {f[0], f[1]},       {f[0], f[1], f[2]}, {},
                                               {-f[2], -f[4]}};
  const std::vector<Expr> products = shared_products(graph, paths, 1000);
  ASSERT_EQ(products.size(), paths.size());
  // f1 f2 is in three different paths, f0 f1 in two.
  EXPECT_EQ(products[0], f0 * (f1 * f2));
  EXPECT_EQ(products[1], f3 * (f1 * f2));
  EXPECT_EQ(products[2], f4 * (f1 * f2));
  EXPECT_EQ(products[3], f0 * f1);
  EXPECT_EQ(products[4], products[0]);
  EXPECT_TRUE(products[5].is_one());
  EXPECT_EQ(products[6], f2 * f4);
  EXPECT_EQ(count_operations(products).mul, 6u);
}

TEST(Products, RunsOfEqualFactorsAndSigns) {
  ExprGraph graph;
  const Ref x = graph.symbol("x").ref();
  const Ref root = sqrt(graph.symbol("y") - graph.symbol("z")).ref();
  const std::vector<std::vector<Ref>> paths = {{x, x, x, x, x}, {x, -x, x}, {root, root}, {-x}};
  const std::vector<Expr> products = shared_products(graph, paths, 1000);
  const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 4);
  std::vector<Expr> expected;
  for (const std::vector<Ref>& path : paths) {
    Expr product = graph.one();
    for (const Ref factor : path) product *= Expr(graph, factor);
    expected.push_back(product);
  }
  EXPECT_EQ(evaluate_modular(products, point), evaluate_modular(expected, point));
}

TEST(Products, WithoutWorkThereIsNoSharing) {
  ExprGraph graph;
  std::vector<std::vector<Ref>> paths(2);
  for (int i = 0; i < 4; ++i) {
    paths[0].push_back(test::numbered_symbol(graph, "a", i).ref());
    paths[1].push_back(i == 0 ? graph.symbol("b").ref() : paths[0].back());
  }
  const std::vector<Expr> shared = shared_products(graph, paths, 1000);
  const std::vector<Expr> plain = shared_products(graph, paths, 0);
  EXPECT_EQ(count_operations(shared).mul, 4u);
  EXPECT_EQ(count_operations(plain).mul, 6u);
  const std::vector<Modular> point = random_modular_point(graph.symbol_count(), 4);
  EXPECT_EQ(evaluate_modular(shared, point), evaluate_modular(plain, point));
}

}  // namespace
}  // namespace alembert

// The three methods against each other, exactly modulo a prime, and against complex steps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "differentiation/complex_evaluation.hpp"
#include "differentiation/d_star.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/random_functions.hpp"
#include "differentiation/reverse.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/guarded.hpp"
#include "symbolic/modular.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {
namespace {

/// How many of the situations that need care the random functions contain.
struct Seen {
  std::size_t repeated = 0, negated = 0, variable = 0, constant = 0, interior = 0, squares = 0, unused = 0,
              cancelled = 0, d_star = 0;
};

void look(const test::RandomFunction& f, const Jacobian& d_star, Seen& seen) {
  const ExprGraph& graph = f.variables.front().graph();
  std::vector<std::uint32_t> used(graph.size(), 0);
  for (const std::uint32_t id : postorder(f.roots)) {
    const Node& node = graph.node(id);
    used[id] += 1;
    if (node.op == Operation::mul && node.a == node.b) ++seen.squares;
    if (node.arity() >= 1) used[node.a.node()] += 1;
    if (node.arity() >= 2) used[node.b.node()] += 1;
  }
  for (std::size_t i = 0; i < f.roots.size(); ++i) {
    const Expr root = f.roots[i];
    if (root.is_constant()) ++seen.constant;
    if (root.ref().negative()) ++seen.negated;
    if (graph.node(root.ref().node()).op == Operation::symbol) ++seen.variable;
    if (graph.node(root.ref().node()).arity() > 0 && used[root.ref().node()] > 1) ++seen.interior;
    for (std::size_t k = 0; k < i; ++k) seen.repeated += f.roots[k].ref().node() == root.ref().node() ? 1 : 0;
  }
  for (const Expr& variable : f.variables) seen.unused += used[variable.ref().node()] == 0 ? 1 : 0;
  for (std::size_t i = 0; i < d_star.rows; ++i) {
    const std::array<Expr, 1> root = {f.roots[i]};
    std::vector<bool> below(graph.size(), false);
    for (const std::uint32_t id : postorder(root)) below[id] = true;
    for (std::size_t j = 0; j < d_star.columns; ++j)
      if (below[f.variables[j].ref().node()] && d_star(i, j).is_zero()) ++seen.cancelled;
  }
  if (d_star.method == DerivativeMethod::d_star) ++seen.d_star;
}

/// Constants that do not fit exact fractions are rounded, and then sums depend on the order of their terms.
bool has_rounded_constant(const std::vector<Expr>& roots) {
  for (const std::uint32_t id : postorder(roots))
    if (roots.front().graph().node(id).op == Operation::real) return true;
  return false;
}

TEST(Agreement, ModuloAPrimeOnRandomFunctions) {
  Seen seen;
  std::size_t rounded = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    ExprGraph graph;
    test::RandomFunctions make(graph, seed);
    const int size = 4 + static_cast<int>(seed % 60);
    const test::RandomFunction f = make({.nodes = size,
                                         .variables = 1 + static_cast<int>(seed % 7),
                                         .roots = 1 + static_cast<int>(seed % 5)});
    const Jacobian forward = jacobian_forward(f.roots, f.variables);
    const Jacobian reverse = jacobian_reverse(f.roots, f.variables);
    // Every fifth with all invariants checked after every step.
    const Jacobian d_star = jacobian_d_star(f.roots, f.variables, {.check = seed % 5 == 0});
    if (has_rounded_constant(f.roots) || has_rounded_constant(forward.entries) ||
        has_rounded_constant(reverse.entries) || has_rounded_constant(d_star.entries)) {
      ++rounded;
      continue;
    }
    const std::vector<Modular> point = random_modular_point(graph.symbol_count(), seed);
    const std::vector<Modular> expected = evaluate_modular(forward.entries, point);
    ASSERT_EQ(evaluate_modular(reverse.entries, point), expected) << "reverse, seed " << seed;
    ASSERT_EQ(evaluate_modular(d_star.entries, point), expected) << "D*, seed " << seed;
    look(f, d_star, seen);
  }
  EXPECT_GT(seen.repeated, 100u);
  EXPECT_GT(seen.negated, 100u);
  EXPECT_GT(seen.variable, 100u);
  EXPECT_GT(seen.constant, 100u);
  EXPECT_GT(seen.interior, 100u);
  EXPECT_GT(seen.squares, 100u);
  EXPECT_GT(seen.unused, 100u);
  EXPECT_GT(seen.cancelled, 100u);
  EXPECT_EQ(seen.d_star, 3000 - rounded);
  EXPECT_LT(rounded, 60u);
}

TEST(Agreement, InDoubleOnFunctionsWithCorners) {
  // abs, sign and roots of roots, which have no exact values modulo a prime.
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    ExprGraph graph;
    test::RandomFunctions make(graph, seed);
    const test::RandomFunction f = make({.nodes = 14, .variables = 3, .roots = 3, .corners = true});
    const Jacobian d_star = jacobian_d_star(f.roots, f.variables);
    std::vector<double> point;
    for (std::uint32_t s = 0; s < graph.symbol_count(); ++s) point.push_back(0.37 + 0.11 * s);
    const std::vector<double> forward = evaluate(jacobian_forward(f.roots, f.variables).entries, point);
    const std::vector<double> reverse = evaluate(jacobian_reverse(f.roots, f.variables).entries, point);
    const std::vector<double> factored = evaluate(d_star.entries, point);
    for (std::size_t k = 0; k < forward.size(); ++k) {
      // Values of such functions may be beyond all bounds.
      if (!std::isfinite(forward[k]) || std::abs(forward[k]) > 1e6) continue;
      const double tolerance = 1e-9 * (1 + std::abs(forward[k]));
      ASSERT_NEAR(reverse[k], forward[k], tolerance) << "seed " << seed << ", entry " << k;
      ASSERT_NEAR(factored[k], forward[k], tolerance) << "seed " << seed << ", entry " << k;
      compared += forward[k] != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 800u);
}

TEST(Agreement, ComplexStepOnSmoothFunctions) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    ExprGraph graph;
    test::RandomFunctions make(graph, seed);
    const test::RandomFunction f = make({.nodes = 25, .variables = 4, .roots = 3, .smooth = true});
    std::mt19937_64 random(seed);
    std::vector<double> point;
    for (std::uint32_t s = 0; s < graph.symbol_count(); ++s)
      point.push_back(0.1 + 0.8 * static_cast<double>(random() >> 11) * 0x1p-53);
    const std::vector<double> expected = test::complex_step(f.roots, f.variables, point);
    for (const Jacobian& jacobian :
         {jacobian_forward(f.roots, f.variables), jacobian_reverse(f.roots, f.variables),
          jacobian_d_star(f.roots, f.variables), alembert::jacobian(f.roots, f.variables)}) {
      const std::vector<double> actual = evaluate(jacobian.entries, point);
      for (std::size_t k = 0; k < expected.size(); ++k)
        ASSERT_NEAR(actual[k], expected[k], 1e-12 * (1 + std::abs(expected[k])))
            << "seed " << seed << ", method " << static_cast<int>(jacobian.method) << ", entry " << k;
    }
  }
}

/// Derivatives of what a condition does not choose are 0, though those of the functions below have no value there.
TEST(Choices, HaveDerivativesWhereNothingIsChosen) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = g.symbol("y"), z = g.symbol("z");
  const Expr depth = sin(x) * y + z;
  const auto chosen = [&](const Expr& e) {
    return if_positive(depth, guarded(Operation::if_positive, depth, e));
  };
  const std::vector<Expr> functions{tanh(y * chosen(sqrt(depth))), chosen(log(depth) * sin(x)) * z,
                                    sqrt(g.integer(1) + chosen(pow(depth, g.rational({1, 3})) / (x - z)))};
  const std::vector<Expr> variables{x, y, z};
  const std::vector<Expr> first = jacobian(functions, variables).entries;
  const std::vector<Expr> second = jacobian(first, variables).entries;
  for (const std::vector<double>& at : {std::vector<double>{0.3, 0.7, -0.5}, {0, 0.7, 0}, {-0.4, -0.4, -0.4}})
    for (const std::vector<Expr>* derivatives : {&first, &second})
      for (const double value : evaluate(*derivatives, at)) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace alembert

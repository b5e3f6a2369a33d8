// Random expressions: construction and every simplifying pass preserve values, and nothing depends on the
// order of construction.
#include <algorithm>
#include <cmath>
#include <limits>

#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/modular.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

using modular::is_zero;

std::vector<double> random_point(std::size_t count, std::uint64_t seed) {
  TestRandom random(seed);
  std::vector<double> at(count);
  for (double& x : at) x = random.uniform(-2, 2);
  return at;
}

RandomDagOptions everything() {
  RandomDagOptions options;
  options.square_roots = options.functions = options.absolute = true;
  return options;
}

// Each step, redone on the values of its operands.
TEST(RandomDags, ConstructionIsExact) {
  std::size_t checked = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    ExprGraph g;
    RandomDagOptions options = everything();
    options.absolute = false;  // an opaque value in the field
    options.small_angles = seed % 2 == 0;
    const RandomDag dag = random_dag(g, seed, options);
    // Roots of squares can come about all the same.
    const std::vector<std::uint32_t> order = postorder(dag.values);
    if (std::any_of(order.begin(), order.end(),
                    [&](std::uint32_t id) { return g.node(id).op == Operation::abs; }))
      continue;
    const std::vector<Modular> v = evaluate_modular(dag.values, random_modular_point(g.symbol_count(), seed));
    for (std::size_t i = 0; i < dag.steps.size(); ++i) {
      const RandomDag::Step& step = dag.steps[i];
      Modular b = v[step.b];
      if (step.negative) b = modular::negate(b);
      const Modular a = v[step.a];
      if (step.op == Operation::add) {
        EXPECT_EQ(v[i], modular::add(a, b)) << to_string(dag.values[step.a]) << "\n"
                                            << to_string(dag.values[step.b]);
      } else if (step.op == Operation::mul) {
        EXPECT_EQ(v[i], modular::multiply(a, b)) << to_string(dag.values[step.a]) << "\n"
                                                 << to_string(dag.values[step.b]);
      } else if (step.op == Operation::div && !is_zero(b)) {
        EXPECT_EQ(modular::multiply(v[i], b), a) << to_string(dag.values[step.a]) << "\n"
                                                 << to_string(dag.values[step.b]);
      } else {
        continue;
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 60000u);
}

double apply(Operation op, double a, double b) {
  switch (op) {
    case Operation::add:
      return a + b;
    case Operation::mul:
      return a * b;
    case Operation::div:
      return a / b;
    case Operation::sqrt:
      return std::sqrt(a);
    case Operation::sin:
      return std::sin(a);
    case Operation::cos:
      return std::cos(a);
    case Operation::tan:
      return std::tan(a);
    case Operation::asin:
      return std::asin(a);
    case Operation::acos:
      return std::acos(a);
    case Operation::atan:
      return std::atan(a);
    case Operation::atan2:
      return std::atan2(a, b);
    case Operation::exp:
      return std::exp(a);
    case Operation::log:
      return std::log(a);
    case Operation::abs:
      return std::abs(a);
    case Operation::sign:
      return a > 0 ? 1 : a < 0 ? -1 : 0;
    case Operation::sinh:
      return std::sinh(a);
    case Operation::cosh:
      return std::cosh(a);
    case Operation::tanh:
      return std::tanh(a);
    case Operation::if_positive:
      return a > 0 ? b : 0;
    case Operation::unless_positive:
      return a > 0 ? 0 : b;
    case Operation::rounding:
      return a * std::numeric_limits<double>::epsilon();
    case Operation::pow:
      return std::pow(a, b);
    case Operation::rational:
    case Operation::pi_multiple:
    case Operation::real:
    case Operation::symbol:
    case Operation::sub:
    case Operation::neg:
      break;
  }
  return a;
}

TEST(RandomDags, ConstructionKeepsDoubles) {
  std::size_t checked = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    ExprGraph g;
    const RandomDag dag = random_dag(g, seed, everything());
    const std::vector<double> v = evaluate(dag.values, random_point(g.symbol_count(), seed));
    double scale = 1;
    for (const double x : v) scale = std::isfinite(x) ? std::max(scale, std::abs(x)) : HUGE_VAL;
    if (scale > 1e4) continue;  // where rounding is magnified the exact test must do
    for (std::size_t i = 0; i < dag.steps.size(); ++i) {
      const RandomDag::Step& step = dag.steps[i];
      if (step.op == Operation::symbol || step.op == Operation::rational) continue;
      const double expected = apply(step.op, v[step.a], step.negative ? -v[step.b] : v[step.b]);
      if (!std::isfinite(expected)) continue;
      EXPECT_NEAR(v[i], expected, 1e-9 * scale) << to_string(dag.values[i]);
      ++checked;
    }
  }
  EXPECT_GT(checked, 20000u);
}

using Pass = std::vector<Expr> (*)(std::span<const Expr>);

// Exact where no sign of a root is involved, in double where it is.
void expect_preserves(Pass pass, std::uint64_t first, std::uint64_t last, RandomDagOptions options) {
  std::size_t changed = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    ExprGraph g;
    options.small_angles = seed % 2 == 0;
    options.identities = true;
    const RandomDag dag = random_dag(g, seed, options);
    std::vector<Expr> out;
    try {
      out = pass(dag.roots);
    } catch (const std::domain_error&) {
      // Only of a divisor that is zero without looking like it: its value then is no number in double either.
      const std::vector<double> v = evaluate(dag.roots, random_point(g.symbol_count(), seed));
      EXPECT_TRUE(std::any_of(v.begin(), v.end(), [](double x) {
        return !std::isfinite(x) || std::abs(x) > 1e10;
      })) << seed;
      continue;
    }
    ASSERT_EQ(out.size(), dag.roots.size());
    changed += out != dag.roots ? 1 : 0;
    if (!options.square_roots) {
      for (std::uint64_t point = 0; point < 2; ++point) {
        const std::vector<Modular> at = random_modular_point(g.symbol_count(), seed * 2 + point);
        const std::vector<Modular> before = evaluate_modular(dag.roots, at),
                                   after = evaluate_modular(out, at);
        for (std::size_t i = 0; i < out.size(); ++i) {
          EXPECT_EQ(before[i], after[i]) << seed << ":\n"
                                         << to_string(dag.roots[i]) << "\n"
                                         << to_string(out[i]);
        }
      }
    }
    for (std::uint64_t point = 0; point < 3; ++point) {
      const std::vector<double> at = random_point(g.symbol_count(), seed * 3 + point);
      const std::vector<double> all = evaluate(dag.values, at);
      double scale = 1;
      for (const double x : all) scale = std::isfinite(x) ? std::max(scale, std::abs(x)) : HUGE_VAL;
      if (scale > 1e4) continue;
      const std::vector<double> before = evaluate(dag.roots, at), after = evaluate(out, at);
      for (std::size_t i = 0; i < out.size(); ++i) {
        EXPECT_NEAR(before[i], after[i], 1e-8 * scale) << seed << ":\n"
                                                       << to_string(dag.roots[i]) << "\n"
                                                       << to_string(out[i]);
      }
    }
  }
  EXPECT_GT(changed, (last - first) / 4);  // a pass that does nothing would pass as well
}

TEST(RandomDags, ValueNumberingPreservesExactly) {
  RandomDagOptions options;
  options.functions = true;
  expect_preserves(value_number, 0, 2000, options);
}

TEST(RandomDags, ValueNumberingPreservesRoots) {
  expect_preserves(value_number, 2000, 4000, everything());
}

TEST(RandomDags, SimplificationPreservesExactly) {
  RandomDagOptions options;
  options.steps = 16;
  expect_preserves(simplify, 0, 1500, options);
}

TEST(RandomDags, SimplificationPreservesRoots) {
  RandomDagOptions options = everything();
  options.steps = 16;
  expect_preserves(simplify, 2000, 3500, options);
}

TEST(RandomDags, OrderOfConstructionDoesNotShow) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    ExprGraph g, h;
    // Other nodes in between give other ids.
    Expr noise = h.symbol("noise");
    for (int i = 0; i < 10; ++i) noise = sin(noise) * h.symbol("s2") + h.integer(i);
    RandomDagOptions options = everything();
    options.steps = 16;
    const RandomDag plain = random_dag(g, seed, options), mirrored = random_dag(h, seed, options, true);
    ASSERT_EQ(plain.values.size(), mirrored.values.size());
    for (std::size_t i = 0; i < plain.values.size(); ++i) {
      ASSERT_EQ(to_string(plain.values[i], 10000), to_string(mirrored.values[i], 10000)) << seed;
    }
    if (seed % 4 != 0) continue;
    std::vector<Expr> x, y;
    try {
      x = simplify(plain.roots);
    } catch (const std::domain_error&) {
      EXPECT_THROW(simplify(mirrored.roots), std::domain_error);
      continue;
    }
    y = simplify(mirrored.roots);
    for (std::size_t i = 0; i < x.size(); ++i)
      ASSERT_EQ(to_string(x[i], 10000), to_string(y[i], 10000)) << seed;
  }
}

}  // namespace
}  // namespace alembert

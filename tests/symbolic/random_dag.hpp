// Random expressions for tests. In: a graph, a seed and what may occur. Out: expressions together with the
// steps that made them, so that a test can redo each step in another arithmetic. The same seed gives the same
// steps everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// splitmix64: the same numbers on every platform.
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double uniform(double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(next() >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// A name such as s3.
inline std::string numbered(char letter, std::size_t i) {
  std::string name(1, letter);
  name += std::to_string(i);
  return name;
}

struct RandomDagOptions {
  std::size_t symbols = 4;
  std::size_t steps = 24;
  std::size_t roots = 3;
  bool division = true;
  bool trigonometric = true;  ///< sin, cos
  bool square_roots = false;  ///< of 1 + x^2
  bool absolute = false;      ///< abs, and roots of plain squares
  bool functions = false;     ///< the others, on arguments inside their domains
  bool identities =
      false;  ///< values that are equal though they look different, and one more root that uses two
  bool small_angles = false;  ///< sines and cosines of symbols only, so that many identities hold
};

struct RandomDag {
  struct Step {
    Operation op;      ///< symbol and rational: no operands
    std::size_t a, b;  ///< earlier steps
    bool negative;     ///< b of a sum is subtracted
  };
  std::vector<Expr> symbols;
  std::vector<Step> steps;
  std::vector<Expr> values;  ///< of each step
  std::vector<Expr> roots;   ///< some of the values, sometimes repeated, sometimes a symbol or a number
};

/// With `mirrored`, sums and products are built with their operands exchanged and the symbols are introduced
/// in the opposite order: the result must be the same.
inline RandomDag random_dag(ExprGraph& graph, std::uint64_t seed, RandomDagOptions options = {},
                            bool mirrored = false) {
  TestRandom random(seed);
  RandomDag out;
  out.symbols.resize(options.symbols);
  for (std::size_t k = 0; k < options.symbols; ++k) {
    const std::size_t i = mirrored ? options.symbols - 1 - k : k;
    out.symbols[i] = graph.symbol(numbered('s', i));
  }
  const auto push = [&](Operation op, std::size_t a, std::size_t b, bool negative, Expr value) {
    out.steps.push_back({op, a, b, negative});
    out.values.push_back(value);
    return out.values.size() - 1;
  };
  const auto add = [&](std::size_t a, std::size_t b, bool negative) {
    const Expr x = out.values[a], y = negative ? -out.values[b] : out.values[b];
    return push(Operation::add, a, b, negative, mirrored ? y + x : x + y);
  };
  const auto mul = [&](std::size_t a, std::size_t b) {
    const Expr x = out.values[a], y = out.values[b];
    return push(Operation::mul, a, b, false, mirrored ? y * x : x * y);
  };
  const auto unary = [&](Operation op, std::size_t a) {
    return push(op, a, 0, false, Expr(graph, graph.make(op, out.values[a].ref())));
  };
  const auto choice = [&](Operation op, std::size_t a, std::size_t b) {
    return push(op, a, b, false, Expr(graph, graph.make(op, out.values[a].ref(), out.values[b].ref())));
  };
  for (const Expr& symbol : out.symbols) push(Operation::symbol, 0, 0, false, symbol);
  for (std::int64_t n : {1, 2, -3}) push(Operation::rational, 0, 0, false, graph.integer(n));
  const std::size_t half = push(Operation::rational, 0, 0, false, graph.rational({1, 2}));
  const std::size_t one = options.symbols;
  const auto any = [&] {
    // Recent values more often, so that depth grows; leaves often enough that factors repeat.
    return random.one_in(3) ? random.below(options.symbols) : random.below(out.values.size());
  };
  const auto bounded = [&](std::size_t a) { return unary(Operation::sin, a); };
  const std::size_t last = out.values.size() + options.steps;
  while (out.values.size() < last) {
    const std::size_t kind = random.below(12);
    const std::size_t a = any(), b = any();
    if (kind < 4) {
      add(a, b, random.one_in(2));
    } else if (kind < 8) {
      mul(a, b);
    } else if (kind == 8 && options.division) {
      if (!out.values[b].is_zero()) push(Operation::div, a, b, false, out.values[a] / out.values[b]);
    } else if (kind < 11 && options.trigonometric) {
      const std::size_t angle = options.small_angles ? random.below(options.symbols) : a;
      const std::size_t s = unary(random.one_in(2) ? Operation::sin : Operation::cos, angle);
      if (random.one_in(2)) mul(s, s);
    } else if (kind == 11 && options.square_roots && random.one_in(2)) {
      const std::size_t square = mul(a, a);
      unary(Operation::sqrt, options.absolute && random.one_in(3) ? square : add(square, one, false));
    } else if (kind == 11 && options.functions) {
      const std::size_t s = bounded(a), small = mul(half, s);
      switch (random.below(11)) {
        case 9:
          choice(Operation::if_positive, b, a);
          break;
        case 10:
          choice(Operation::unless_positive, b, a);
          break;
        case 0:
          unary(Operation::asin, small);
          break;
        case 1:
          unary(Operation::acos, small);
          break;
        case 2:
          unary(Operation::atan, a);
          break;
        case 3:
          unary(Operation::exp, s);
          break;
        case 4:
          unary(Operation::log, add(one, small, false));
          break;
        case 5:
          unary(Operation::abs, a);
          break;
        case 6:
          unary(Operation::sinh, s);
          break;
        case 7:
          unary(Operation::cosh, s);
          break;
        default:
          unary(Operation::tanh, a);
          break;
      }
    }
  }
  if (options.identities) {
    // a (b + c) = a b + a c, one of the factors a sine squared; and what is left of a circle.
    const std::size_t a = any(), b = any(), c = any(), angle = random.below(options.symbols);
    const std::size_t s = unary(Operation::sin, angle), k = unary(Operation::cos, angle), square = mul(s, s);
    const std::size_t inner = add(b, c, random.one_in(2));
    const std::size_t whole = mul(random.one_in(2) ? square : a, inner);
    const RandomDag::Step sum = out.steps[inner], product = out.steps[whole];
    const std::size_t left = mul(product.a, sum.a), right = mul(product.a, sum.b);
    const std::size_t split = add(left, right, sum.negative);
    const std::size_t circle = add(mul(mul(s, a), s), mul(k, mul(a, k)), false);
    const std::size_t first = add(mul(whole, c), circle, random.one_in(2)), second = mul(split, b);
    add(first, second, random.one_in(2));
    out.roots.push_back(out.values.back());
  }
  for (std::size_t k = 0; k < options.roots; ++k) {
    const std::size_t reach = random.one_in(4) ? out.values.size() : out.values.size() / 3 + 1;
    out.roots.push_back(out.values[out.values.size() - 1 - random.below(reach)]);
  }
  return out;
}

}  // namespace alembert

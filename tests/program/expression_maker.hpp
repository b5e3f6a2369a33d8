// Expressions for tests of `lower` and `verify`. In: a seed. Out: random expressions over bound symbols.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "program/lower.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Symbols q0, q1, ... bound to the coordinates.
inline std::vector<SymbolBinding> coordinates(ExprGraph& graph, std::uint32_t n) {
  std::vector<SymbolBinding> bindings;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Expr symbol = graph.symbol(fmt::format("q{}", i));
    bindings.push_back({symbol, {ArgumentKind::q, i, fmt::format("q{}", i)}});
  }
  return bindings;
}

/// One output array `out`.
inline std::vector<OutputExpressions> outputs_of(std::vector<Expr> values) {
  OutputExpressions out{"out", static_cast<std::uint32_t>(values.size()), 1, {}};
  out.values = std::move(values);
  return {out};
}

/// Which operations random expressions hold.
enum class Kinds {
  rational,   ///< + - * / with binary fractions, sin, cos and sqrt: what can be checked exactly
  functions,  ///< everything
};

/// `outputs` random expressions of about `size` operations in all, of moderate values for arguments in [-4,
/// 4].
inline std::vector<Expr> random_expressions(ExprGraph& graph, std::span<const SymbolBinding> bindings,
                                            int size, int outputs, Kinds kinds, std::mt19937_64& random) {
  std::vector<Expr> pool;
  for (const SymbolBinding& b : bindings) pool.push_back(b.symbol);
  pool.push_back(graph.rational(Rational(3, 4)));
  pool.push_back(graph.integer(-2));
  if (kinds == Kinds::functions) pool.push_back(graph.rational(Rational(1, 3)));
  if (kinds == Kinds::functions) pool.push_back(graph.pi(Rational(1, 7)));
  const Expr one = graph.one();
  while (size-- > 0) {
    const auto pick = [&] {
      const std::size_t n = pool.size(), recent = std::min<std::size_t>(n, 8);
      return random() % 3 == 0 ? pool[random() % n] : pool[n - 1 - random() % recent];
    };
    const Expr a = pick();
    const Expr b = pick();
    const Expr square = b * b;
    const Expr positive = one + square;
    const Expr small = sin(a);
    switch (random() % (kinds == Kinds::rational ? 10 : 22)) {
      case 0:
      case 1:
        pool.push_back(a + b);
        break;
      case 2:
        pool.push_back(a - b);
        break;
      case 3:
      case 4:
        pool.push_back(small * b);
        break;
      case 5:
        pool.push_back(a / positive);
        break;
      case 6:
        pool.push_back(small);
        break;
      case 7:
        pool.push_back(cos(a));
        break;
      case 8:
        pool.push_back(sqrt(positive));
        break;
      case 9:
        pool.push_back(-(a * cos(b)));
        break;
      case 10:
        pool.push_back(exp(small));
        break;
      case 11:
        pool.push_back(log(positive));
        break;
      case 12:
        pool.push_back(atan2(a, b));
        break;
      case 13:
        pool.push_back(atan(a));
        break;
      case 14:
        pool.push_back(asin(small * graph.rational(Rational(1, 2))));
        break;
      case 15:
        pool.push_back(acos(small * graph.rational(Rational(1, 3))));
        break;
      case 16:
        pool.push_back(abs(a));
        break;
      case 17:
        pool.push_back(tanh(a));
        break;
      case 18:
        pool.push_back(sinh(small) - cosh(small));
        break;
      case 19:
        pool.push_back(pow(positive, graph.rational(Rational(1, 3))));
        break;
      case 20:
        pool.push_back(tan(small));
        break;
      case 21:
        pool.push_back(sign(a) * b);
        break;
    }
  }
  std::vector<Expr> roots;
  for (int k = 0; k < outputs; ++k) roots.push_back(pool[pool.size() - 1 - random() % (pool.size() / 2)]);
  return roots;
}

}  // namespace alembert

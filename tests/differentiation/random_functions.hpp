// Random vector functions to differentiate. In: a seed and what kinds of trouble to make. Out: roots and
// variables, the same for the same seed in every build.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "symbolic/expr.hpp"
#include "symbolic/postorder.hpp"

namespace alembert::test {

/// The symbol x0, x1, ...
inline Expr numbered_symbol(ExprGraph& graph, std::string name, int number) {
  name += std::to_string(number);
  return graph.symbol(name);
}

struct RandomFunction {
  std::vector<Expr> roots, variables;
};

struct RandomFunctionOptions {
  int nodes = 30;
  int variables = 4;
  int roots = 4;
  bool smooth = false;   ///< only analytic functions, with values and derivatives of moderate size
  bool corners = false;  ///< also abs, sign and roots of roots, which have no exact values modulo a prime
};

class RandomFunctions {
 public:
  RandomFunctions(ExprGraph& graph, std::uint64_t seed) : graph_(graph), random_(seed) {}

  RandomFunction operator()(const RandomFunctionOptions& options) {
    RandomFunction result;
    pool_.clear();
    corners_ = options.corners;
    for (int i = 0; i < options.variables; ++i) {
      result.variables.push_back(numbered_symbol(graph_, "x", i));
      // About one variable in eight does not occur.
      if (below(8) != 0) pool_.push_back(result.variables.back());
    }
    pool_.push_back(graph_.symbol("parameter"));
    pool_.push_back(graph_.integer(static_cast<std::int64_t>(below(5)) - 2));
    pool_.push_back(graph_.rational(Rational(2, 3)));
    leaves_ = pool_.size();
    for (int i = 0; i < options.nodes; ++i) {
      const Expr node = options.smooth ? smooth_node() : any_node();
      // Numbers made of numbers would soon need more than 64 bits.
      pool_.push_back(is_number(node) ? pool_[below(leaves_)] : node);
    }
    for (int i = 0; i < options.roots; ++i) result.roots.push_back(root(result.roots));
    return result;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  bool is_number(Expr x) const {
    const Operation op = graph_.node(x.ref().node()).op;
    return op == Operation::rational || op == Operation::real || op == Operation::pi_multiple;
  }

  /// Mostly recent nodes, so that the graph is deep, with links far back, so that it is no tree.
  Expr operand() {
    const std::size_t reach = below(3) == 0 ? pool_.size() : std::min<std::size_t>(pool_.size(), 8);
    const Expr x = pool_[pool_.size() - 1 - below(reach)];
    return below(6) == 0 ? -x : x;
  }

  Expr root(const std::vector<Expr>& before) {
    switch (below(10)) {
      case 0:  // repeated, or the negative of another
        if (!before.empty()) {
          const Expr again = before[below(before.size())];
          return below(2) == 0 ? again : -again;
        }
        return pool_.back();
      case 1:  // a variable or a constant
        return pool_[below(leaves_)];
      case 2:
      case 3:  // inside other roots, most likely
        return pool_[below(pool_.size())];
      default:
        return operand();
    }
  }

  Expr any_node() {
    const Expr a = operand();
    const Expr b = operand();
    switch (below(18)) {
      case 0:
      case 1:
      case 2:
        return a + b;
      case 3:
      case 4:
        return a - b;
      case 5:
      case 6:
      case 7:
      case 8:
        return a * b;
      case 9:
        return a * a;
      case 10:
        return sin(a);
      case 11:
        return cos(a);
      case 12: {
        const Expr square = b * b;
        return a / (square + graph_.integer(3));
      }
      case 13: {
        if (a.is_constant() || has_root(a)) return a * b;
        const Expr square = a * a;
        return sqrt(square + graph_.integer(2));
      }
      case 14: {  // cancels, but not by the rules of construction
        const Expr x = operand();
        const Expr left = (a + b) * x;
        const Expr right = a * x + b * x;
        return left - right;
      }
      case 15: {  // cancels in part
        const Expr sum = a + b;
        return sum * sum - a * a;
      }
      case 16:
        return pow(a, 3);
      default:
        return other_function(a, b);
    }
  }

  /// Whether there is a square root in x, or in its derivative, and it matters.
  bool has_root(Expr x) const {
    if (corners_) return false;
    const std::array<Expr, 1> root = {x};
    for (const std::uint32_t id : postorder(root)) {
      const Operation op = graph_.node(id).op;
      if (op == Operation::sqrt || op == Operation::asin || op == Operation::acos) return true;
    }
    return false;
  }

  Expr other_function(Expr a, Expr b) {
    const std::size_t choice = below(14);
    if (!corners_ && (choice == 5 || choice == 6)) return a * b;
    if ((choice == 1 || choice == 2) && (a.is_constant() || has_root(a))) return a * b;
    switch (choice) {
      case 0:
        return tan(a);
      case 1:
        return asin(graph_.rational(Rational(1, 2)) * sin(a));
      case 2:
        return acos(graph_.rational(Rational(1, 2)) * cos(a));
      case 3:
        return atan(a);
      case 4:
        return exp(a);
      case 5:
        return abs(a);
      case 6:
        return sign(a);
      case 7:
        return sinh(a);
      case 8:
        return cosh(a);
      case 9:
        return tanh(a);
      case 10:
        return a.is_constant() ? a : atan2(a, b);
      case 11: {
        const Expr square = a * a;
        return log(square + graph_.integer(1));
      }
      case 12: {
        const Expr square = a * a;
        return pow(square + graph_.integer(1), b);
      }
      default: {
        const Expr square = a * a;
        return pow(square + graph_.integer(1), graph_.rational(Rational(5, 3)));
      }
    }
  }
  Expr smooth_node() {
    const Expr a = operand();
    const Expr b = operand();
    const Expr half = graph_.rational(Rational(1, 2));
    const Expr one = graph_.one();
    switch (below(16)) {
      case 0:
      case 1:
        return half * (a + b);
      case 2:
        return half * (a - b);
      case 3:
      case 4:
      case 5:
        return half * a * b;
      case 6:
        return half * a * a;
      case 7:
        return sin(a);
      case 8:
        return cos(a + b);
      case 9:
        return tanh(a);
      case 10:
        return a / (graph_.integer(2) + b * b);
      case 11:
        return half * sqrt(one + a * a);
      case 12:
        return half * (sinh(half * a) - cosh(half * b));
      case 13:
        return half * exp(-(a * a)) + half * log(graph_.integer(2) + b * b) * half;
      case 14: {
        const Expr angle = atan(a) - atan2(b, graph_.integer(3) + a * a);
        return half * angle + graph_.rational(Rational(1, 8)) * tan(half * sin(b));
      }
      default: {
        const Expr base = pow(one + a * a, half * b);
        return graph_.rational(Rational(1, 4)) * (asin(half * sin(a)) - acos(half * cos(b))) +
               graph_.rational(Rational(1, 4)) * base;
      }
    }
  }

  ExprGraph& graph_;
  std::mt19937_64 random_;
  std::vector<Expr> pool_;
  std::size_t leaves_ = 0;
  bool corners_ = false;
};

}  // namespace alembert::test

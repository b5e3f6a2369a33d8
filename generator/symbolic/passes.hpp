// Passes over expressions: free functions, each in a file of its own, each one loop over ids.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Node ids reachable from `roots`, children before parents, in depth-first order of the roots (so it is the
/// same in every build, whatever the ids are).
std::vector<std::uint32_t> postorder(std::span<const Expr> roots);

/// Replaces symbols by expressions, all at once (x -> y, y -> x swaps).
std::vector<Expr> substitute(std::span<const Expr> roots,
                             std::span<const std::pair<Expr, Expr>> replacements);

/// Thrown by `coefficient` where an expression is not linear in the variable.
class NotLinear : public std::domain_error {
 public:
  NotLinear(const std::string& message, Expr where) : std::domain_error(message), where_(where) {}
  Expr where() const { return where_; }  ///< the offending subexpression

 private:
  Expr where_;
};
/// Coefficient of the symbol `x` in each root (Algorithm 1 of the paper, corrected): root = coefficient*x +
/// rest. Throws NotLinear with the offending subexpression where x enters other than linearly.
std::vector<Expr> coefficient(std::span<const Expr> roots, Expr x);

/// Values of the roots in double precision; `symbols[i]` is the value of the symbol with index i.
std::vector<double> evaluate(std::span<const Expr> roots, std::span<const double> symbols);
/// Value of an expression without symbols.
double value_of(Expr constant);

/// An element re + im*i of the field with p^2 elements, p = 2^61 - 1, i^2 = -1.
struct Modular {
  std::uint64_t re = 0, im = 0;
  friend bool operator==(const Modular&, const Modular&) = default;
};
/// Values of the roots in that field, exact in + - * / sqrt; sin and cos by the rational parametrisation of
/// the circle, so that s^2 + c^2 = 1 holds exactly (likewise sinh, cosh); other functions are replaced by a
/// hash of their operands, which preserves identities of operands only. Sound for telling expressions apart:
/// equal expressions have equal values.
std::vector<Modular> evaluate_modular(std::span<const Expr> roots, std::span<const Modular> symbols);
/// A reproducible random point for evaluate_modular.
std::vector<Modular> random_modular_point(std::uint32_t symbol_count, std::uint64_t seed);

/// Infix text, for people and messages. Long expressions are cut after `limit` characters with `...`.
std::string to_string(Expr x, std::size_t limit = 400);

/// Equal roots, smaller: sin^2+cos^2 with common factors, common factors of sums, like terms, sqrt of squares
/// under proven sign, cancellation of quotients. The set never needs more operations than it was given.
/// Throws std::domain_error if a divisor turns out to be zero everywhere.
std::vector<Expr> simplify(std::span<const Expr> roots);

/// Merges nodes that have equal values (up to sign, or to a constant factor 0) at two random points of the
/// modular field, confirmed at two fresh points: probabilistic value numbering. Throws std::domain_error as
/// `simplify` does.
std::vector<Expr> value_number(std::span<const Expr> roots);

/// Operations of a set of roots, each node counted once: adds, muls, divs, trig, other; signs and 2x as in
/// `program/count`.
struct ExprCount {
  std::size_t add = 0, mul = 0, div = 0, trig = 0, other = 0;
  std::size_t total() const { return add + mul + div + other; }
};
ExprCount count_operations(std::span<const Expr> roots);

}  // namespace alembert

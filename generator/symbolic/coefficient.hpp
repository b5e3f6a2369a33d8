// Coefficients of a symbol. In: roots that are linear in it. Out: what it is multiplied with.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

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

}  // namespace alembert

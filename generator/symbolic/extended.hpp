// Arithmetic with 50 decimal digits, rounded correctly and the same on every machine: where what double
// precision would round away decides. In: roots and the values of all symbols. Out: the values of the roots.
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

using Extended = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// What is left of terms that cancel, relative to the largest of them, is rounding of Extended if it is
/// smaller. Data have 17 digits, so what is larger is theirs, and to drop what is smaller changes nothing
/// that they say.
inline const Extended kExtendedRounding = 1e-40;

/// A turn by less is none: the entries of a rotation, which are about 1, have no digit for it.
inline const Extended kAngleRounding = 0x1p-52;

/// Values of the roots; `symbols[i]` is the value of the symbol with index i. Decimals of the description are
/// exact, as pi is to all digits.
std::vector<Extended> evaluate_extended(std::span<const Expr> roots, std::span<const double> symbols);
std::vector<Extended> evaluate_extended(std::span<const Expr> roots, std::span<const Extended> symbols);
/// The same roots at many points: their nodes are looked up once.
class ExtendedFunction {
 public:
  explicit ExtendedFunction(std::span<const Expr> roots);
  ~ExtendedFunction();
  ExtendedFunction(ExtendedFunction&&) noexcept;
  std::vector<Extended> operator()(std::span<const Extended> symbols) const;
  std::size_t nodes() const;
  const std::vector<Expr>& roots() const { return roots_; }

 private:
  struct Order;
  std::vector<Expr> roots_;
  std::unique_ptr<const Order> order_;
};
/// Value of an expression without symbols.
Extended extended_value_of(Expr constant);

}  // namespace alembert

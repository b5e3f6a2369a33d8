// Constants as numbers of double precision. In: roots. Out: the doubles that their constant parts are, or the
// roots over these.
#pragma once

#include <vector>

#include "symbolic/postorder.hpp"

namespace alembert {

/// Values of the constant nodes of an order. They are folded in extended precision, so that one rounding, to
/// double, is left of each.
class ConstantValues {
 public:
  ConstantValues(ExprGraph& graph, const Postorder& order);
  /// By position and sign in the order (Postorder::local). Throws InternalError if the constant has no finite
  /// value.
  double rounded(std::uint32_t local) const;
  long double extended(std::uint32_t local) const {
    return (local & 1) != 0 ? -folded_[local >> 1] : folded_[local >> 1];
  }

 private:
  ExprGraph& graph_;
  const Postorder& order_;
  std::vector<long double> folded_;
};

/// The roots with each constant part as one number, which `lower` writes as it is; the same roots where one of
/// them divides by a constant that rounds to 0. Throws InternalError if a constant has no finite value.
std::vector<Expr> round_constants(std::span<const Expr> roots);

}  // namespace alembert

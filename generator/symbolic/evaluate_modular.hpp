// Evaluation in a finite field. In: roots and the values of all symbols. Out: the values of the roots.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symbolic/modular.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

/// Values of the roots in that field, exact in + - * / sqrt; sin and cos by the rational parametrisation of
/// the circle, so that s^2 + c^2 = 1 holds exactly (likewise sinh, cosh); other functions are replaced by a
/// hash of their operands, which preserves identities of operands only. Sound for telling expressions apart:
/// equal expressions have equal values.
std::vector<Modular> evaluate_modular(std::span<const Expr> roots, std::span<const Modular> symbols);
namespace modular {
/// Value of an operation that is no leaf; b is for those of two operands.
Modular apply(Operation op, Modular a, Modular b);
/// Values of all nodes of an order at each of some points; of a point, entry i belongs to the symbol with index i.
std::vector<std::vector<Modular>> values(const ExprGraph& graph, const Postorder& order,
                                         std::span<const std::vector<Modular>> points);
}  // namespace modular

/// A reproducible random point for evaluate_modular.
std::vector<Modular> random_modular_point(std::uint32_t symbol_count, std::uint64_t seed);

}  // namespace alembert

// The rewrites of stage `optimise`: a value program in, an equal one out, or nothing where there is nothing
// to rewrite. Each lowers the weighted count of the places it touches; nodes that become unused stay behind,
// unreachable.
#pragma once

#include <cstddef>
#include <optional>

#include "program/value_graph.hpp"

namespace alembert {

/// A division takes about as long as four multiplies. So two divisions by one value (8) are worth a
/// reciprocal and two multiplies (6).
inline constexpr std::size_t kDivisionWeight = 4;

/// Whether a factor is left in a sum where it comes cheaper as part of products that many places share.
enum class CommonPairs { taken_apart, spared };

/// a*b + x + a*c -> a*(b + c) + x inside sums whose parts are used once, also with quotients, constants and
/// equal terms; constants of a sum and of a product are collected; constant offsets of angles come last.
/// `any_spared` becomes true if a pair was spared: as long as it is not, both ways are one.
std::optional<ValueProgram> factor_sums(const ValueProgram& program, CommonPairs common_pairs,
                                        bool& any_spared);

/// x/d, y/d -> r = 1/d, x*r, y*r; (a/b)/c -> a/(b*c); a/(b/c) -> a*c/b; (a/b)*(c/d) -> (a*c)/(b*d); x*(c/y)
/// -> (c*x)/y.
std::optional<ValueProgram> share_divisions(const ValueProgram& program);

/// a*(b*c), b*(a*d) -> p = a*b, p*c, p*d: products of several factors share pairs of them.
std::optional<ValueProgram> share_products(const ValueProgram& program);

}  // namespace alembert

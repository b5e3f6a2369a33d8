// Common factors of sums: live nodes in; equal roots out, or nothing where there is nothing to factor.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/rewrite/node_rewrite.hpp"

namespace alembert {

/// Whether a factor is left in a sum where it comes cheaper as part of products that many places share.
enum class CommonPairs { taken_apart, spared };

/// a*b + x + a*c -> a*(b + c) + x inside sums whose parts are used once, also with quotients, constants and
/// equal terms; constants of a sum and of a product are collected; constant offsets of angles come last.
/// `any_spared` becomes true if a pair was spared: as long as it is not, both ways are one.
std::optional<std::vector<Expr>> factor_sums(const LiveNodes& nodes, CommonPairs common_pairs,
                                             bool& any_spared);

}  // namespace alembert

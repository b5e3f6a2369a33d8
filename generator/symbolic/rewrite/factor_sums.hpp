// Common factors of sums: live nodes in; equal roots out, or nothing where there is nothing to factor.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/rewrite/node_rewrite.hpp"

namespace alembert {

/// Which common factors stay in a sum: those that come cheaper as part of products that many places share, and
/// 2, which costs no multiplication there.
struct FactorsLeft {
  bool in_common_pairs, twos;
};

/// a*b + x + a*c -> a*(b + c) + x inside sums whose parts are used once, also with quotients, constants and
/// equal terms; constants of a sum and of a product are collected; constant offsets of angles come last.
/// `met` tells of which kinds there were any: without them both ways are one.
std::optional<LiveNodes> factor_sums(const LiveNodes& nodes, FactorsLeft left, FactorsLeft& met);

}  // namespace alembert

// Products with common pairs: live nodes in; equal roots out, or nothing where there is nothing to share.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/rewrite/node_rewrite.hpp"

namespace alembert {

/// a*(b*c), b*(a*d) -> p = a*b, p*c, p*d: products of several factors share pairs of them.
std::optional<LiveNodes> share_products(const LiveNodes& nodes);

}  // namespace alembert

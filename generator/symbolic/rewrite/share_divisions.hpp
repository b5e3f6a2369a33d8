// Divisions by one value: live nodes in; equal roots out, or nothing where there is nothing to share.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/rewrite/node_rewrite.hpp"

namespace alembert {

/// x/d, y/d -> r = 1/d, x*r, y*r; (a/b)/c -> a/(b*c); a/(b/c) -> a*c/b; (a/b)*(c/d) -> (a*c)/(b*d); x*(c/y)
/// -> (c*x)/y.
std::optional<LiveNodes> share_divisions(const LiveNodes& nodes);

}  // namespace alembert

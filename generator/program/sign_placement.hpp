// Signs of values. In: roots and the order of what they need. Out: which nodes are computed with their sign
// reversed, so that few negations remain.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symbolic/postorder.hpp"

namespace alembert {

/// By position, whether the negative of a node is computed rather than the node: -(a - b) becomes b - a,
/// -(2.5*x) becomes -2.5*x, and products pass a sign to the factor that can take it. Roots are not empty.
std::vector<std::uint8_t> place_signs(std::span<const Expr> roots, const Postorder& order);

}  // namespace alembert

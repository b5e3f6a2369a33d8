// Divisions by one value: a value program in; an equal one out, or nothing where there is nothing to share.
#pragma once

#include <optional>

#include "program/value_graph.hpp"

namespace alembert {

/// x/d, y/d -> r = 1/d, x*r, y*r; (a/b)/c -> a/(b*c); a/(b/c) -> a*c/b; (a/b)*(c/d) -> (a*c)/(b*d); x*(c/y)
/// -> (c*x)/y.
std::optional<ValueProgram> share_divisions(const LiveProgram& program);

}  // namespace alembert

// Products with common pairs: a value program in; an equal one out, or nothing where there is nothing to
// share.
#pragma once

#include <optional>

#include "program/value_graph.hpp"

namespace alembert {

/// a*(b*c), b*(a*d) -> p = a*b, p*c, p*d: products of several factors share pairs of them.
std::optional<ValueProgram> share_products(const LiveProgram& program);

}  // namespace alembert

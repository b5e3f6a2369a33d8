// Expressions as text.
#pragma once

#include <cstddef>
#include <string>

#include "symbolic/expr.hpp"

namespace alembert {

/// Infix text, for people and messages. Long expressions are cut after `limit` characters with `...`.
std::string to_string(Expr x, std::size_t limit = 400);

}  // namespace alembert

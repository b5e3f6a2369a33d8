// Stage `verify`: a program and the expressions that it came from in; an error out if they differ.
#pragma once

#include <span>

#include "program/lower.hpp"
#include "program/program.hpp"

namespace alembert {

/// Stage `verify`: throws InternalError, with function, output, element and both values, unless the program
/// is well formed and agrees with the expressions it came from: at eight or more random points inside the
/// symbols' ranges and about as large as their units, within running error bounds, and modulo a large prime
/// where both sides are exact. An element whose expression has no finite value at any point tried is not
/// compared.
void verify(const Program& program, std::span<const OutputExpressions> outputs,
            std::span<const SymbolBinding> bindings);

}  // namespace alembert

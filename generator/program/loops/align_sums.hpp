// Sums of steps alike: a program in, the same with sums added in one order out.
#pragma once

#include <span>

#include "program/loops/similar_values.hpp"

namespace alembert {

/// The same program, but that sums, and products, of corresponding operands are put together in the same
/// order: rounding differs.
Program align_sums(const Program& program, Shift shift, std::span<const int> depths);

}  // namespace alembert

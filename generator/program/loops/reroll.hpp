// Stage `reroll`: a program in; the same out, with steps that do the same listed as loops.
#pragma once

#include <cstddef>

#include "program/program.hpp"

namespace alembert {

/// Stage `reroll`, after `schedule` and gathering: steps that repeat on other values, as those of a
/// recursion along a chain, become iterations of loops; the rest stays straight code around them. Same
/// operations; sums and products of three or more may be rounded in another order, signs are placed anew, and
/// negations may be more. Without such steps the program stays as it is.
Program reroll(const Program& program);

/// How many additions and multiplications a program has in loops over steps.
std::size_t operations_in_loops(const Program& program);

}  // namespace alembert

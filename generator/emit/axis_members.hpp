// What linearize of the runtime needs of a tree of axes. In: its numbers and programs. Out: functions, and a struct of
// the mechanism's type.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/emit.hpp"
#include "functions/axis_table.hpp"

namespace alembert {

/// axis_frames, and axis_forces where there are any.
std::vector<ExtraFunction> axis_functions(const AxisPrograms& axes);

/// `struct Axes` with the numbers and the calls of these functions.
std::string axis_members(const AxisPrograms& axes, std::string_view name_space);

}  // namespace alembert

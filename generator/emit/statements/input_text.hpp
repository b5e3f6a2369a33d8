// What inputs of a program are called in the code. In: an input. Out: its local variable, and the element of an
// argument that it is read from.
#pragma once

#include <string>

#include "emit/statements/syntax.hpp"
#include "program/program.hpp"

namespace alembert {

std::string input_local(const InputSlot& slot);
std::string input_source(const InputSlot& slot, const Syntax& syntax);

}  // namespace alembert

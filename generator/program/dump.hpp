// Programs as text, for people.
#pragma once

#include <string>

#include "program/program.hpp"

namespace alembert {

/// One instruction a line, then results and loops, for --dump.
std::string dump(const Program& program);

}  // namespace alembert

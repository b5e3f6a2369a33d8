// Stage `count`: a program in, its operations out.
#pragma once

#include "program/program.hpp"
#include "support/operation_count.hpp"

namespace alembert {

/// Stage `count`: operations by the convention at `OperationCount`.
OperationCount count(const Program& program);

}  // namespace alembert

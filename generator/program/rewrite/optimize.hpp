// Stage `optimise`: a program in, one of equal value and no more operations out.
#pragma once

#include "program/program.hpp"

namespace alembert {

/// Stage `optimise`: value numbering, constant folding and sign placement, a*b + a*c -> a*(b + c) with
/// single-use products, shared reciprocals and merged quotients; each kept only if it lowers the weight of all
/// operations (OperationCount), so that the result never costs more. Values change by rounding only, except
/// that 0*x and x - x are 0 whatever x is.
Program optimize(Program program);

/// Programs are lowered with every argument that there is; what a function does not use is no argument of it.
Program without_unused_inputs(Program program);

}  // namespace alembert

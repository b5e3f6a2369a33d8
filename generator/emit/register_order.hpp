// The order of statements in functions over packs of states. In: scheduled program. Out: the same
// instructions in an order for machines where loading and storing what registers do not hold costs more than
// waiting for results.
#pragma once

#include "program/program.hpp"

namespace alembert {

/// A list scheduler on statements as they will be written. Of those whose operands are known, the one is next
/// that frees most registers and needs fewest values that have left them, where a set of registers that gives
/// up the least recently used value first stands for what a compiler will do. Sines and cosines of the call
/// for all angles stay first. Same values, bit for bit.
Program order_for_registers(const Program& program);

}  // namespace alembert

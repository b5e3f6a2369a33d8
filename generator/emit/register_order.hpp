// The order of statements. In: scheduled program. Out: the same instructions in an order for machines where
// loading and storing what registers do not hold costs much, and waiting for results too.
#pragma once

#include "program/program.hpp"

namespace alembert {

/// How many states a function is called for at once. Those of one state wait for their results; those over
/// packs of states have others to compute meanwhile.
enum class States { one, many };

/// A list scheduler on statements as they will be written. Of those whose operands are known, the one is next
/// that frees most registers and needs fewest values that have left them, where a set of registers that gives
/// up the least recently used value first stands for what a compiler will do; for one state, what most
/// operations hang on comes sooner. Sines and cosines of the call for all angles stay first, dot products in
/// loops last. Same values, bit for bit.
Program order_for_registers(const Program& program, States states);

}  // namespace alembert

// The order of statements. In: scheduled program. Out: the same instructions in an order for machines where
// loading and storing what registers do not hold costs much, and waiting for results too.
#pragma once

#include "program/program.hpp"

namespace alembert {

/// How many states a function is called for at once. Those of one state wait for their results; those over
/// packs of states have others to compute meanwhile.
enum class States { one, many };

/// For one state, a list schedule (list_schedule.hpp) in which what most operations hang on comes sooner. For
/// many, the best of several, made better by search (order_search.hpp), for a plan of what registers hold
/// (register_plan.hpp). Sines and cosines of the call for all angles stay first, dot products in loops last.
/// Same values, bit for bit.
Program order_for_registers(const Program& program, States states);

/// What was verified is what is written: the same values, bit for bit, in the last order too. Throws InternalError.
void expect_same_values(const Program& verified, const Program& written);

}  // namespace alembert

// Expressions of the output functions: an entry for each row of the function table. In: kinematics and
// equations of motion. Out: the results of a function as expressions over the bound symbols
// (symbol_bindings).
#pragma once

#include <vector>

#include "dynamics/equations.hpp"
#include "functions/function_table.hpp"
#include "program/lower.hpp"

namespace alembert {

/// Whether the function is made of the equations of motion, so that each formulation gives expressions of its
/// own.
bool is_of_equations(FunctionKind kind);

/// The results of one function in the order of its row. The equations of motion are those of the tree:
/// constraints act through M ud + c = tau + P^T lambda.
std::vector<OutputExpressions> function_outputs(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations, FunctionKind kind);

/// The same from the tree of motions as it is given, without looking for fewer operations.
std::vector<OutputExpressions> plain_function_outputs(const Kinematics& kinematics, FunctionKind kind);

}  // namespace alembert

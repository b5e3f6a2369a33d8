// Argument lists of output functions in C++ and C. In: a row of the function table. Out: text.
#pragma once

#include <string>
#include <string_view>

#include "functions/function_table.hpp"
#include "mechanism/model.hpp"
#include "program/program.hpp"

namespace alembert {

/// Name of the array argument: q, qd, qdd, tau. InternalError for what is no array of its own.
std::string_view array_name(ArgumentKind kind);

/// `const S* q, ..., const Inputs<S>& in, S* tau`; with `unused_allowed`, arguments that may be unused are
/// marked.
std::string cpp_parameters(const OutputFunction& signature, bool unused_allowed);

/// `q, qd, in, c`
std::string cpp_arguments(const OutputFunction& signature);

/// `const double*, ..., const Inputs<double>&, double*`: types only, for the scalar given.
std::string cpp_parameter_types(const OutputFunction& signature, std::string_view scalar);

/// `const double* q, ..., double t, const double* parameters, const double* wrenches, double* tau`; after the
/// `*` stands `qualifier`.
std::string c_parameters(const OutputFunction& signature, std::string_view number = "double",
                         std::string_view qualifier = "");

/// What a C function passes on: `q, qd, make_inputs(t, parameters, wrenches), c`.
std::string c_arguments(const OutputFunction& signature);

/// `q == nullptr || tau == nullptr`
std::string c_null_check(const OutputFunction& signature, std::string_view null = "nullptr");

/// InternalError unless results and inputs of the program fit the function and the mechanism.
void check_program(const Program& program, const OutputFunction& signature, const Mechanism& mechanism);

}  // namespace alembert

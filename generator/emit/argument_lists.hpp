// Argument lists of output functions in C++ and C. In: a row of the function table. Out: text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "functions/function_table.hpp"
#include "mechanism/model.hpp"
#include "program/program.hpp"

namespace alembert {

/// `q`, `qd`, ...: the arrays that a function takes, and those that it fills.
std::vector<std::string_view> argument_names(const OutputFunction& function);
std::vector<std::string_view> result_names(const OutputFunction& function);

/// Arguments, `inputs` unless that is empty, and results, in this order; `argument` and `result` say what is
/// written of a name, such as `const S* {}`.
std::string argument_list(const OutputFunction& function, std::string_view argument, std::string_view inputs,
                          std::string_view result, std::string_view separator = ", ");

/// `const S* q, ..., const Inputs<S>& in, S* tau`; with `unused_allowed`, arguments that may be unused are
/// marked.
std::string cpp_parameters(const OutputFunction& function, bool unused_allowed);

/// `q, qd, in, c`
std::string cpp_arguments(const OutputFunction& function);

/// `const double*, ..., const Inputs<double>&, double*`: types only, for the scalar given.
std::string cpp_parameter_types(const OutputFunction& function, std::string_view scalar);

/// `const double* q, ..., double t, const double* parameters, const double* wrenches, double* tau`; after the
/// `*` stands `qualifier`.
std::string c_parameters(const OutputFunction& function, std::string_view number = "double",
                         std::string_view qualifier = "");

/// What a C function passes on: `q, qd, make_inputs(t, parameters, wrenches), c`.
std::string c_arguments(const OutputFunction& function);

/// `q == nullptr || tau == nullptr`
std::string c_null_check(const OutputFunction& function, std::string_view null = "nullptr");

/// InternalError unless results and inputs of the program fit the function and the mechanism.
void check_program(const Program& program, const OutputFunction& function, const Mechanism& mechanism);

}  // namespace alembert

// The functions that can be emitted: names, arguments and results. A program's name picks its row.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanism/model.hpp"
#include "program/program.hpp"

namespace alembert {

/// Size of an array in terms of the mechanism.
enum class ArraySize {
  coordinates,
  speeds,
  speeds_squared,
  two,
  bodies_times_12,
  frames_times_12,
  frames_times_6_speeds,
  constraints,
  constraints_times_speeds,
  bodies_times_6_speeds,
  bodies_times_10
};

struct ResultArray {
  std::string_view name;
  ArraySize size;
};

/// A function takes the arrays of `arguments` in this order, then the inputs (time, parameters, wrenches) if
/// `takes_inputs`, then its results, whether a given mechanism uses them or not.
struct FunctionSignature {
  std::string_view name;
  std::vector<ArgumentKind> arguments;
  bool takes_inputs;
  std::vector<ResultArray> results;
};

/// All of them, in the order in which they are emitted.
std::span<const FunctionSignature> function_signatures();

/// Null if there is no function of this name.
const FunctionSignature* find_signature(std::string_view function);

std::size_t array_size(ArraySize size, const Mechanism& mechanism);

/// Columns of an array that holds matrices row by row (poses and inertias: one row a body); 0 for a vector.
std::size_t array_columns(ArraySize size, const Mechanism& mechanism);

/// Name of the array argument: q, qd, qdd, tau. InternalError for what is no array of its own.
std::string_view array_name(ArgumentKind kind);

/// `const S* q, ..., const Inputs<S>& in, S* tau`; with `unused_allowed`, arguments that may be unused are
/// marked.
std::string cpp_parameters(const FunctionSignature& signature, bool unused_allowed);

/// `q, qd, in, c`
std::string cpp_arguments(const FunctionSignature& signature);

/// `const double*, ..., const Inputs<double>&, double*`: types only, for the scalar given.
std::string cpp_parameter_types(const FunctionSignature& signature, std::string_view scalar);

/// `const double* q, ..., double t, const double* parameters, const double* wrenches, double* tau`; after the
/// `*` stands `qualifier`.
std::string c_parameters(const FunctionSignature& signature, std::string_view number = "double",
                         std::string_view qualifier = "");

/// What a C function passes on: `q, qd, make_inputs(t, parameters, wrenches), c`.
std::string c_arguments(const FunctionSignature& signature);

/// `q == nullptr || tau == nullptr`
std::string c_null_check(const FunctionSignature& signature, std::string_view null = "nullptr");

/// InternalError unless results and inputs of the program fit the function and the mechanism.
void check_program(const Program& program, const FunctionSignature& signature, const Mechanism& mechanism);

}  // namespace alembert

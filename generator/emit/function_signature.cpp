// Table of the functions that can be emitted, and their argument lists in C++ and C.
#include "emit/function_signature.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mechanism/constraint_rows.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

const std::vector<FunctionSignature>& table() {
  using enum ArgumentKind;
  static const std::vector<FunctionSignature> rows = {
      {"inverse_dynamics", {q, qd, qdd}, true, {{"tau", ArraySize::speeds}}},
      {"mass_matrix", {q}, true, {{"M", ArraySize::speeds_squared}}},
      {"bias", {q, qd}, true, {{"c", ArraySize::speeds}}},
      {"mass_matrix_and_bias", {q, qd}, true, {{"M", ArraySize::speeds_squared}, {"c", ArraySize::speeds}}},
      {"forward_dynamics", {q, qd, tau}, true, {{"qdd", ArraySize::speeds}}},
      {"coordinate_rates", {q, qd}, false, {{"qdot", ArraySize::coordinates}}},
      {"energy", {q, qd}, true, {{"e", ArraySize::two}}},
      {"body_poses", {q}, true, {{"W", ArraySize::bodies_times_12}}},
      {"frame_poses", {q}, true, {{"F", ArraySize::frames_times_12}}},
      {"frame_jacobians", {q}, true, {{"J", ArraySize::frames_times_6_speeds}}},
      {"constraints",
       {q, qd},
       true,
       {{"P", ArraySize::constraints_times_speeds},
        {"gamma", ArraySize::constraints},
        {"velocity", ArraySize::constraints},
        {"position", ArraySize::constraints}}},
      {"body_jacobians", {q}, true, {{"J", ArraySize::bodies_times_6_speeds}}},
      {"body_inertias", {}, true, {{"inertias", ArraySize::bodies_times_10}}},
      {"inverse_dynamics_derivatives",
       {q, qd, qdd},
       true,
       {{"tau_q", ArraySize::speeds_squared}, {"tau_qd", ArraySize::speeds_squared}}},
  };
  return rows;
}

std::size_t input_size(ArgumentKind kind, const Mechanism& mechanism) {
  switch (kind) {
    case ArgumentKind::q:
      return static_cast<std::size_t>(mechanism.nq);
    case ArgumentKind::qd:
    case ArgumentKind::qdd:
    case ArgumentKind::tau:
      return static_cast<std::size_t>(mechanism.nv);
    case ArgumentKind::time:
      return 1;
    case ArgumentKind::parameter:
      return static_cast<std::size_t>(std::ranges::count_if(mechanism.parameters, &Parameter::runtime));
    case ArgumentKind::wrench:
      return 6 * static_cast<std::size_t>(std::ranges::count_if(mechanism.bodies, &Body::external_wrench));
  }
  throw InternalError("emit: argument of unknown kind");
}

bool is_input(ArgumentKind kind, const FunctionSignature& signature) {
  switch (kind) {
    case ArgumentKind::time:
    case ArgumentKind::parameter:
    case ArgumentKind::wrench:
      return signature.takes_inputs;
    case ArgumentKind::q:
    case ArgumentKind::qd:
    case ArgumentKind::qdd:
    case ArgumentKind::tau:
      return std::ranges::find(signature.arguments, kind) != signature.arguments.end();
  }
  throw InternalError("emit: argument of unknown kind");
}

}  // namespace

std::span<const FunctionSignature> function_signatures() {
  return table();
}

const FunctionSignature* find_signature(std::string_view function) {
  const auto row = std::ranges::find(table(), function, &FunctionSignature::name);
  return row == table().end() ? nullptr : &*row;
}

std::size_t array_size(ArraySize size, const Mechanism& mechanism) {
  const auto nq = static_cast<std::size_t>(mechanism.nq), nv = static_cast<std::size_t>(mechanism.nv);
  switch (size) {
    case ArraySize::coordinates:
      return nq;
    case ArraySize::speeds:
      return nv;
    case ArraySize::speeds_squared:
      return nv * nv;
    case ArraySize::two:
      return 2;
    case ArraySize::bodies_times_12:
      return 12 * mechanism.bodies.size();
    case ArraySize::frames_times_12:
      return 12 * mechanism.frames.size();
    case ArraySize::frames_times_6_speeds:
      return 6 * nv * mechanism.frames.size();
    case ArraySize::constraints:
      return constraint_rows(mechanism).size();
    case ArraySize::constraints_times_speeds:
      return constraint_rows(mechanism).size() * nv;
    case ArraySize::bodies_times_6_speeds:
      return 6 * nv * mechanism.bodies.size();
    case ArraySize::bodies_times_10:
      return 10 * mechanism.bodies.size();
  }
  throw InternalError("emit: array of unknown size");
}

std::size_t array_columns(ArraySize size, const Mechanism& mechanism) {
  switch (size) {
    case ArraySize::coordinates:
    case ArraySize::speeds:
    case ArraySize::two:
    case ArraySize::constraints:
      return 0;
    case ArraySize::bodies_times_12:
    case ArraySize::frames_times_12:
      return 12;
    case ArraySize::bodies_times_10:
      return 10;
    case ArraySize::speeds_squared:
    case ArraySize::frames_times_6_speeds:
    case ArraySize::constraints_times_speeds:
    case ArraySize::bodies_times_6_speeds:
      return static_cast<std::size_t>(mechanism.nv);
  }
  throw InternalError("emit: array of unknown size");
}

std::string_view array_name(ArgumentKind kind) {
  switch (kind) {
    case ArgumentKind::q:
      return "q";
    case ArgumentKind::qd:
      return "qd";
    case ArgumentKind::qdd:
      return "qdd";
    case ArgumentKind::tau:
      return "tau";
    case ArgumentKind::time:
    case ArgumentKind::parameter:
    case ArgumentKind::wrench:
      break;
  }
  throw InternalError("emit: not an array argument");
}

std::string cpp_parameters(const FunctionSignature& signature, bool unused_allowed) {
  const std::string_view mark = unused_allowed ? "[[maybe_unused]] " : "";
  std::string out;
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("{}const S* {}, ", mark, array_name(kind));
  if (signature.takes_inputs) out += fmt::format("{}const Inputs<S>& in, ", mark);
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}S* {}{}", mark, result.name, &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string cpp_arguments(const FunctionSignature& signature) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments) out += fmt::format("{}, ", array_name(kind));
  if (signature.takes_inputs) out += "in, ";
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}{}", result.name, &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string cpp_parameter_types(const FunctionSignature& signature, std::string_view scalar) {
  std::string out;
  for (std::size_t i = 0; i < signature.arguments.size(); ++i) out += fmt::format("const {}*, ", scalar);
  if (signature.takes_inputs) out += fmt::format("const Inputs<{}>&, ", scalar);
  for (std::size_t i = 0; i < signature.results.size(); ++i)
    out += fmt::format("{}{}*", i == 0 ? "" : ", ", scalar);
  return out;
}

std::string c_parameters(const FunctionSignature& signature, std::string_view number,
                         std::string_view qualifier) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("const {}*{} {}, ", number, qualifier, array_name(kind));
  if (signature.takes_inputs)
    out += fmt::format("{0} t, const {0}*{1} parameters, const {0}*{1} wrenches, ", number, qualifier);
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}*{} {}{}", number, qualifier, result.name,
                       &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string c_arguments(const FunctionSignature& signature) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments) out += fmt::format("{}, ", array_name(kind));
  if (signature.takes_inputs) out += "make_inputs(t, parameters, wrenches), ";
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}{}", result.name, &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string c_null_check(const FunctionSignature& signature, std::string_view null) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("{} == {} || ", array_name(kind), null);
  for (const ResultArray& result : signature.results)
    out += fmt::format("{} == {}{}", result.name, null, &result == &signature.results.back() ? "" : " || ");
  return out;
}

void check_program(const Program& program, const FunctionSignature& signature, const Mechanism& mechanism) {
  if (program.outputs.size() != signature.results.size())
    throw InternalError(fmt::format("emit: {} has {} results, not {}", signature.name, program.outputs.size(),
                                    signature.results.size()));
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const std::size_t expected = array_size(signature.results[i].size, mechanism);
    if (program.outputs[i].values.size() != expected)
      throw InternalError(fmt::format("emit: result {} of {} has {} entries, not {}",
                                      signature.results[i].name, signature.name,
                                      program.outputs[i].values.size(), expected));
    for (const std::uint32_t value : program.outputs[i].values)
      if (value >= program.code.size())
        throw InternalError(fmt::format("emit: a result of {} is no value of its program", signature.name));
  }
  for (const InputSlot& slot : program.inputs)
    if (!is_input(slot.kind, signature) || slot.index >= input_size(slot.kind, mechanism))
      throw InternalError(
          fmt::format("emit: input {} is no argument of {}", printable(slot.name), signature.name));
}

}  // namespace alembert

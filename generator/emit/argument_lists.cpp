// Argument lists (see the header).
#include "emit/argument_lists.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "functions/array_shape.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

bool is_input(ArgumentKind kind, const OutputFunction& signature) {
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

std::string cpp_parameters(const OutputFunction& signature, bool unused_allowed) {
  const std::string_view mark = unused_allowed ? "[[maybe_unused]] " : "";
  std::string out;
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("{}const S* {}, ", mark, array_name(kind));
  if (signature.takes_inputs) out += fmt::format("{}const Inputs<S>& in, ", mark);
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}S* {}{}", mark, result.name, &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string cpp_arguments(const OutputFunction& signature) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments) out += fmt::format("{}, ", array_name(kind));
  if (signature.takes_inputs) out += "in, ";
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}{}", result.name, &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string cpp_parameter_types(const OutputFunction& signature, std::string_view scalar) {
  std::string out;
  for (std::size_t i = 0; i < signature.arguments.size(); ++i) out += fmt::format("const {}*, ", scalar);
  if (signature.takes_inputs) out += fmt::format("const Inputs<{}>&, ", scalar);
  for (std::size_t i = 0; i < signature.results.size(); ++i)
    out += fmt::format("{}{}*", i == 0 ? "" : ", ", scalar);
  return out;
}

std::string c_parameters(const OutputFunction& signature, std::string_view number,
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

std::string c_arguments(const OutputFunction& signature) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments) out += fmt::format("{}, ", array_name(kind));
  if (signature.takes_inputs) out += "make_inputs(t, parameters, wrenches), ";
  for (const ResultArray& result : signature.results)
    out += fmt::format("{}{}", result.name, &result == &signature.results.back() ? "" : ", ");
  return out;
}

std::string c_null_check(const OutputFunction& signature, std::string_view null) {
  std::string out;
  for (const ArgumentKind kind : signature.arguments)
    out += fmt::format("{} == {} || ", array_name(kind), null);
  for (const ResultArray& result : signature.results)
    out += fmt::format("{} == {}{}", result.name, null, &result == &signature.results.back() ? "" : " || ");
  return out;
}

void check_program(const Program& program, const OutputFunction& signature, const Mechanism& mechanism) {
  if (program.outputs.size() != signature.results.size())
    throw InternalError(fmt::format("emit: {} has {} results, not {}", signature.name, program.outputs.size(),
                                    signature.results.size()));
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const std::size_t expected = array_shape(signature.results[i], mechanism).size();
    if (program.outputs[i].values.size() != expected)
      throw InternalError(fmt::format("emit: result {} of {} has {} entries, not {}",
                                      signature.results[i].name, signature.name,
                                      program.outputs[i].values.size(), expected));
    for (const std::uint32_t value : program.outputs[i].values)
      if (value >= program.code.size())
        throw InternalError(fmt::format("emit: a result of {} is no value of its program", signature.name));
  }
  for (const InputSlot& slot : program.inputs)
    if (!is_input(slot.kind, signature) || slot.index >= argument_size(slot.kind, mechanism))
      throw InternalError(
          fmt::format("emit: input {} is no argument of {}", printable(slot.name), signature.name));
}

}  // namespace alembert

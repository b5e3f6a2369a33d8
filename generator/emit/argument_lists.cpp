// Argument lists (see the header).
#include "emit/argument_lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
    case ArgumentKind::mu:
      return std::ranges::find(signature.arguments, kind) != signature.arguments.end();
  }
  throw InternalError("emit: argument of unknown kind");
}

}  // namespace

std::vector<std::string_view> argument_names(const OutputFunction& function) {
  std::vector<std::string_view> names;
  for (const ArgumentKind kind : function.arguments) names.push_back(argument_name(kind));
  return names;
}

std::vector<std::string_view> result_names(const OutputFunction& function) {
  std::vector<std::string_view> names;
  for (const ResultArray& result : function.results) names.push_back(result.name);
  return names;
}

std::string argument_list(const OutputFunction& function, std::string_view argument, std::string_view inputs,
                          std::string_view result, std::string_view separator) {
  std::vector<std::string> items;
  for (const std::string_view name : argument_names(function))
    items.push_back(fmt::format(fmt::runtime(argument), name));
  if (!inputs.empty()) items.emplace_back(inputs);
  for (const std::string_view name : result_names(function))
    items.push_back(fmt::format(fmt::runtime(result), name));
  return fmt::format("{}", fmt::join(items, separator));
}

std::string cpp_parameters(const OutputFunction& function, bool unused_allowed) {
  const std::string mark = unused_allowed ? "[[maybe_unused]] " : "";
  return argument_list(function, mark + "const S* {}",
                       function.takes_inputs ? mark + "const Inputs<S>& in" : "", mark + "S* {}");
}

std::string cpp_arguments(const OutputFunction& function) {
  return argument_list(function, "{}", function.takes_inputs ? "in" : "", "{}");
}

std::string cpp_parameter_types(const OutputFunction& function, std::string_view scalar) {
  return argument_list(function, fmt::format("const {}*", scalar),
                       function.takes_inputs ? fmt::format("const Inputs<{}>&", scalar) : "",
                       fmt::format("{}*", scalar));
}

std::string c_parameters(const OutputFunction& function, std::string_view number,
                         std::string_view qualifier) {
  const std::string array = fmt::format("{}*{} ", number, qualifier);
  return argument_list(function, "const " + array + "{}",
                       function.takes_inputs
                           ? fmt::format("{0} t, const {1}parameters, const {1}wrenches", number, array)
                           : "",
                       array + "{}");
}

std::string c_arguments(const OutputFunction& function) {
  return argument_list(function, "{}", function.takes_inputs ? "make_inputs(t, parameters, wrenches)" : "",
                       "{}");
}

std::string c_null_check(const OutputFunction& function, std::string_view null) {
  const std::string check = fmt::format("{{}} == {}", null);
  return argument_list(function, check, "", check, " || ");
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

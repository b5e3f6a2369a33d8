// Writes names and constants of a mechanism.
#include "emit/common_slots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "emit/statements/literals.hpp"
#include "emit/statements/syntax.hpp"
#include "functions/function_table.hpp"
#include "mechanism/constraint_rows.hpp"
#include "mechanism/force_names.hpp"
#include "mechanism/names.hpp"
#include "mechanism/parameter_places.hpp"

namespace alembert {
namespace {

constexpr std::size_t kWidth = 110;
constexpr const char* kCppInfinity = "::std::numeric_limits<double>::infinity()";

struct Names {
  std::vector<std::string> coordinates, speeds, bodies, frames, parameters, wrench_bodies, constraints,
      outputs, forces;
};

Names names_of(const Mechanism& mechanism) {
  Names names;
  for (const Coordinate& c : mechanism.coordinates) switch (c.type) {
      case CoordinateType::real:
        names.coordinates.push_back(c.name);
        names.speeds.push_back("d(" + c.name + ")");
        break;
      case CoordinateType::quaternion:
        for (const char* axis : {".x", ".y", ".z", ".w"}) names.coordinates.push_back(c.name + axis);
        for (const char* axis : {".x", ".y", ".z"}) names.speeds.push_back("d(" + c.name + ")" + axis);
        break;
    }
  for (const Body& body : mechanism.bodies) {
    names.bodies.push_back(body.name);
    if (body.external_wrench) names.wrench_bodies.push_back(body.name);
  }
  for (const Frame& frame : mechanism.frames) names.frames.push_back(frame.name);
  for (const Output& output : mechanism.outputs) names.outputs.push_back(output.name);
  names.forces = force_names(mechanism);
  for (const Parameter& parameter : mechanism.parameters)
    if (parameter.runtime) names.parameters.push_back(parameter.name);
  for (const ConstraintRow& row : constraint_rows(mechanism)) names.constraints.push_back(row.name);
  return names;
}

std::vector<std::string> names_of(const Mechanism& mechanism, ParameterRole role) {
  std::vector<std::string> names;
  for (const PlacedParameter& placed : placed_parameters(mechanism, role))
    names.push_back(placed.parameter.name);
  return names;
}

std::string wrapped(const std::vector<std::string>& items) {
  const std::string list = fmt::format("{}", fmt::join(items, ", "));
  return list.size() < 60 ? list : "\n    " + wrap_list(list, 4, 4, kWidth);
}

std::string c_array(std::vector<std::string> items, const std::string& last) {
  if (!last.empty()) items.push_back(last);
  return fmt::format("{{{}}}", wrapped(items));
}

std::vector<std::string> literals(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  for (const std::string& name : names) out.push_back(string_literal(name));
  return out;
}

std::vector<std::string> initial_coordinates(const Mechanism& mechanism, std::string_view number) {
  std::vector<std::string> out;
  for (const Coordinate& c : mechanism.coordinates)
    for (const double value : c.initial) out.push_back(c_literal(value, number));
  return out;
}

std::vector<std::string> initial_speeds(const Mechanism& mechanism, std::string_view number) {
  std::vector<std::string> out;
  for (const Coordinate& c : mechanism.coordinates)
    for (const double value : c.initial_speed) out.push_back(c_literal(value, number));
  return out;
}

std::vector<std::string> limits(const Mechanism& mechanism, bool lower, const std::string& infinity) {
  std::vector<std::string> out;
  const auto text = [&](double value) {
    if (value == std::numeric_limits<double>::infinity() || value == -std::numeric_limits<double>::infinity())
      return (lower ? "-" : "") + infinity;
    return number_literal(value);
  };
  for (const Coordinate& c : mechanism.coordinates)
    for (int i = 0; i < c.nq(); ++i) {
      const double none = (lower ? -1 : 1) * std::numeric_limits<double>::infinity();
      out.push_back(text(!c.limits ? none : lower ? c.limits->first : c.limits->second));
    }
  return out;
}

/// Of the drives, a value for each speed.
std::vector<std::string> drive_limits(const Mechanism& mechanism, std::optional<double> Coordinate::*limit,
                                      const std::string& infinity) {
  std::vector<std::string> out;
  for (const Coordinate& c : mechanism.coordinates)
    for (int i = 0; i < c.nv(); ++i) out.push_back(c.*limit ? number_literal(*(c.*limit)) : infinity);
  return out;
}

std::vector<std::string> holonomic(const Mechanism& mechanism, std::string_view yes, std::string_view no) {
  std::vector<std::string> out;
  for (const ConstraintRow& row : constraint_rows(mechanism))
    out.emplace_back(row.type == ConstraintType::holonomic ? yes : no);
  return out;
}

std::vector<std::string> row_lengths(const Mechanism& mechanism) {
  std::vector<double> lengths = mechanism.row_lengths;
  lengths.resize(constraint_rows(mechanism).size(), 1.0);
  std::vector<std::string> out;
  for (const double length : lengths) out.push_back(number_literal(length));
  return out;
}

/// Where quaternions begin in q.
std::vector<std::string> quaternion_offsets(const Mechanism& mechanism) {
  std::vector<std::string> out;
  for (const Coordinate& c : mechanism.coordinates)
    if (c.type == CoordinateType::quaternion) out.push_back(std::to_string(c.first_q));
  return out;
}

std::vector<std::string> parameter_defaults(const Mechanism& mechanism, const std::string& format,
                                            std::string_view number) {
  std::vector<std::string> out;
  for (const Parameter& parameter : mechanism.parameters)
    if (parameter.runtime)
      out.push_back(fmt::format(fmt::runtime(format), c_literal(parameter.value, number)));
  return out;
}

/// What stands in the array of parameters, in SI units.
std::string parameters_text(const Mechanism& mechanism) {
  const auto count = [&](ParameterRole role) { return placed_parameters(mechanism, role).size(); };
  const std::size_t parameters = count(ParameterRole::parameter), inputs = count(ParameterRole::input),
                    states = count(ParameterRole::state);
  if (states > 0) {
    std::vector<std::string> parts;
    for (const auto& [of, one] :
         {std::pair(parameters, "runtime parameter"), {inputs, "input"}, {states, "state"}})
      if (of > 0) parts.push_back(fmt::format("{} {}{}", of, one, of == 1 ? "" : "s"));
    return fmt::format("{}, in SI units", fmt::join(parts, ", then "));
  }
  if (parameters == 0) return inputs == 0 ? "" : "inputs in SI units";
  const std::string last =
      inputs == 1 ? "the last of them an input" : fmt::format("the last {} of them inputs", inputs);
  return "runtime parameters in SI units" + (inputs == 0 ? "" : ", " + last);
}

/// What the functions take besides the state, in the comment of the C interface.
std::string c_inputs(const Mechanism& mechanism, std::size_t parameters, std::size_t wrenches) {
  const std::string first = parameters == 0
                                ? "parameters  NULL: there are no runtime parameters"
                                : fmt::format("parameters  [{}] {}; NULL for the values of the description",
                                              parameters, parameters_text(mechanism));
  const std::string second = wrenches == 0 ? "wrenches    NULL: no body takes an external wrench"
                                           : fmt::format(
                                                 "wrenches    [{} x 6] per body of {}_wrench_body_names the "
                                                 "force x y z at its centre of mass, N, and the torque\n"
                                                 "            x y z, N m, both in world axes; NULL for none",
                                                 wrenches, mechanism.name);
  return first + "\n" + second;
}

/// The same as members of Inputs in C++; where there are none, arrays of no elements.
std::string cpp_inputs(const Mechanism& mechanism, std::size_t wrenches) {
  const std::vector<std::string> defaults = parameter_defaults(mechanism, "S({})", "double");
  std::string text = parameters_text(mechanism);
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  const std::string first =
      defaults.empty() ? "::std::array<S, 0> parameters = {};  ///< there are no runtime parameters"
                       : fmt::format(
                             "/// {}, in the order of kParameterNames; the values of the description unless "
                             "changed.\n::std::array<S, kParameterCount> parameters = {};",
                             text, cpp_array(defaults));
  const std::string second = wrenches == 0
                                 ? "::std::array<S, 0> wrenches = {};  ///< no body takes an external wrench"
                                 : "/// Six per body of kWrenchBodyNames: force x y z at its centre of mass, "
                                   "N, and torque x y z, N m, both in world axes.\n"
                                   "::std::array<S, 6 * kWrenchCount> wrenches = {};";
  return first + "\n" + second;
}

/// A named index, such as that of a frame in kFrameNames.
struct Index {
  std::string name;
  int value;
};

/// Named indices of one kind; `type` is that of the generated code.
struct Indices {
  std::string type;
  std::vector<Index> items;
};

/// By the names of the description, where these are identifiers: others get no constant.
std::vector<Indices> described_indices(const Mechanism& mechanism) {
  std::vector<Indices> out;
  const auto add = [&out](std::string_view type, const std::string& name, int value) {
    if (name.empty() || is_digit(name[0]) || !std::ranges::all_of(name, is_word_character)) return;
    auto of_type = std::ranges::find(out, type, &Indices::type);
    if (of_type == out.end()) of_type = out.insert(out.end(), {std::string(type), {}});
    of_type->items.push_back({name, value});
  };
  for (const Coordinate& c : mechanism.coordinates) add("Coordinate", c.name, c.first_q);
  for (const Coordinate& c : mechanism.coordinates) add("Speed", c.name, c.first_speed);
  int next = 0;
  for (const Body& b : mechanism.bodies) add("Body", b.name, next++);
  next = 0;
  for (const Frame& f : mechanism.frames) add("Frame", f.name, next++);
  for (const auto& [role, type] : {std::pair(ParameterRole::parameter, "Parameter"),
                                   {ParameterRole::input, "Input"},
                                   {ParameterRole::state, "State"}})
    for (const PlacedParameter& placed : placed_parameters(mechanism, role))
      add(type, placed.parameter.name, static_cast<int>(placed.place));
  next = 0;
  for (const Body& b : mechanism.bodies)
    if (b.external_wrench) add("Wrench", b.name, next++);
  next = 0;
  for (const std::string& name : force_names(mechanism)) add("Force", name, next++);
  next = 0;
  for (const Output& o : mechanism.outputs) add("Output", o.name, next++);
  return out;
}

/// The same with names as they may stand in code: those that `objects` gets an underscore, and each is the only one.
template <class Objects>
std::vector<Indices> named_indices(const Mechanism& mechanism, const Objects& objects) {
  std::vector<Indices> out = described_indices(mechanism);
  for (Indices& indices : out) {
    for (auto item = indices.items.begin(); item != indices.items.end(); ++item) {
      if (objects(indices.type, item->name)) item->name += "_";
      while (std::find_if(indices.items.begin(), item,
                          [&](const Index& i) { return i.name == item->name; }) != item)
        item->name += "2";
    }
  }
  return out;
}

/// A macro would be replaced, and a class has no member of its own name.
bool objects_in_cpp(std::string_view type, std::string_view name) {
  return !objection_to_mechanism_name(name).empty() || name == type;
}

std::vector<Indices> indices_of(const Mechanism& mechanism) {
  return named_indices(mechanism, objects_in_cpp);
}

/// `wrench_`: what stands before names of this type in C, behind that of the mechanism.
std::string c_kind(std::string_view type) {
  std::string kind(type);
  kind[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(kind[0])));
  return kind + "_";
}

/// Other names of the C interface are the same: those of lists and sizes, of functions and of what is made of these.
bool objects_in_c(std::string_view type, std::string_view name) {
  const std::string whole = c_kind(type) + std::string(name);
  return name == "count" || name == "names" || whole == "wrench_body_names" ||
         std::ranges::any_of(kOutputFunctions, [&](const OutputFunction& function) {
           if (!whole.starts_with(function.name)) return false;
           const std::string_view rest = std::string_view(whole).substr(function.name.size());
           return rest.empty() || rest == "_batch" || rest == "_states" || rest.starts_with("_block");
         });
}

/// What constants for indices are for. `wrench` stands before the names of wrenches, if there are any; `other` is what
/// the names that `objects` finds are besides.
template <class Objects>
std::string index_text(const Mechanism& mechanism, const std::vector<std::string>& uses,
                       const std::string& wrench, const Objects& objects, std::string_view other) {
  std::string text = fmt::format("Names for indices: {}.", fmt::join(uses, ", "));
  if (!quaternion_offsets(mechanism).empty()) text += " Of a quaternion that of its first entry.";
  if (!wrench.empty()) text += fmt::format(" Wrenches begin at 6 * {}NAME.", wrench);
  const bool renamed = std::ranges::any_of(described_indices(mechanism), [&](const Indices& of) {
    return std::ranges::any_of(of.items, [&](const Index& i) { return objects(of.type, i.name); });
  });
  if (renamed) text += fmt::format(" A name that is {} has an underscore behind it.", other);
  return text;
}

/// `enum { arm_frame_tool = 0 };` and so on, behind a comment on their use.
std::string c_indices(const Mechanism& mechanism) {
  const std::vector<Indices> all = named_indices(mechanism, objects_in_c);
  std::vector<std::string> uses;
  std::string enums;
  bool wrenches = false;
  for (const Indices& indices : all) {
    const std::string start = fmt::format("{}_{}", mechanism.name, c_kind(indices.type));
    std::vector<std::string> items;
    for (const Index& index : indices.items)
      items.push_back(fmt::format("{}{} = {}", start, index.name, index.value));
    const std::string list = wrapped(items);
    enums += list.starts_with('\n') ? fmt::format("\nenum {{{}\n}};", list)
                                    : fmt::format("\nenum {{ {} }};", list);
    for (const auto& [type, array] : {std::pair("Coordinate", "q"),
                                      {"Speed", "qd"},
                                      {"Parameter", "parameters"},
                                      {"Input", "parameters"},
                                      {"State", "parameters"}})
      if (indices.type == type) uses.push_back(fmt::format("{}[{}NAME]", array, start));
    wrenches |= indices.type == "Wrench";
  }
  if (enums.empty()) return "";
  const std::string text = index_text(mechanism, uses, wrenches ? mechanism.name + "_wrench_" : "",
                                      objects_in_c, "another's here");
  return fmt::format("/* {} */{}", wrap_words(text, 3, 3, kWidth), enums);
}

/// `struct Frame { enum : int { tool = 0 }; };` and so on, a line each.
std::string index_structs(const Mechanism& mechanism) {
  std::string out;
  for (const Indices& indices : indices_of(mechanism)) {
    std::vector<std::string> items;
    for (const Index& index : indices.items) items.push_back(fmt::format("{} = {}", index.name, index.value));
    const std::string list = wrapped(items);
    out += fmt::format("{}struct {} {{ enum : int {{{}{} }}; }};", out.empty() ? "" : "\n", indices.type,
                       list.starts_with('\n') ? "" : " ", list);
  }
  return out;
}

/// The same as members of a class: `using Frame = ::NAMESPACE::Frame;`.
std::string index_aliases(const Mechanism& mechanism, const std::string& full_namespace) {
  std::string out;
  for (const Indices& indices : indices_of(mechanism))
    out += fmt::format("{0}using {1} = ::{2}::{1};", out.empty() ? "" : "\n", indices.type, full_namespace);
  return out;
}

struct ScriptWords {
  std::string_view yes, no;
  std::string infinity;
};

/// Of languages with lists: `tuple` writes those of names and places, those of numbers stand in brackets.
Slots scripted_slots(const Mechanism& mechanism,
                     const std::function<std::string(const std::vector<std::string>&)>& tuple,
                     std::string (*quote)(std::string_view), const ScriptWords& words) {
  const Names names = names_of(mechanism);
  const auto quoted = [&](const std::vector<std::string>& items) {
    std::vector<std::string> out;
    for (const std::string& item : items) out.push_back(quote(item));
    return tuple(out);
  };
  const auto list = [](const std::vector<std::string>& items) { return fmt::format("[{}]", wrapped(items)); };
  return {
      {"coordinate_names", quoted(names.coordinates)},
      {"speed_names", quoted(names.speeds)},
      {"body_names", quoted(names.bodies)},
      {"frame_names", quoted(names.frames)},
      {"output_names", quoted(names.outputs)},
      {"force_names", quoted(names.forces)},
      {"parameter_names", quoted(names.parameters)},
      {"input_names", quoted(names_of(mechanism, ParameterRole::input))},
      {"state_names", quoted(names_of(mechanism, ParameterRole::state))},
      {"wrench_names", quoted(names.wrench_bodies)},
      {"constraint_names", quoted(names.constraints)},
      {"holonomic", tuple(holonomic(mechanism, words.yes, words.no))},
      {"quaternion_offsets", tuple(quaternion_offsets(mechanism))},
      {"initial", list(initial_coordinates(mechanism, "double"))},
      {"initial_speeds", list(initial_speeds(mechanism, "double"))},
      {"lower_limits", list(limits(mechanism, true, words.infinity))},
      {"upper_limits", list(limits(mechanism, false, words.infinity))},
      {"effort_limits", list(drive_limits(mechanism, &Coordinate::effort_limit, words.infinity))},
      {"speed_limits", list(drive_limits(mechanism, &Coordinate::speed_limit, words.infinity))},
      {"parameter_defaults", list(parameter_defaults(mechanism, "{}", "double"))},
  };
}

}  // namespace

std::string cpp_array(const std::vector<std::string>& items) {
  return items.empty() ? "{}" : fmt::format("{{{{{}}}}}", wrapped(items));
}

Slots common_slots(const Mechanism& mechanism, const std::string& full_namespace) {
  const Names names = names_of(mechanism);
  return {
      {"name", mechanism.name},
      {"namespace", full_namespace},
      {"nq", std::to_string(mechanism.nq)},
      {"nv", std::to_string(mechanism.nv)},
      {"base_count", std::to_string(mechanism.base_columns.size())},
      {"body_count", std::to_string(names.bodies.size())},
      {"frame_count", std::to_string(names.frames.size())},
      {"output_count", std::to_string(names.outputs.size())},
      {"force_count", std::to_string(names.forces.size())},
      {"input_count", std::to_string(placed_parameters(mechanism, ParameterRole::input).size())},
      {"state_count", std::to_string(placed_parameters(mechanism, ParameterRole::state).size())},
      {"parameter_count", std::to_string(names.parameters.size())},
      {"parameters_text", names.parameters.empty() ? "runtime parameters" : parameters_text(mechanism)},
      {"wrench_count", std::to_string(names.wrench_bodies.size())},
      {"quaternion_count", std::to_string(quaternion_offsets(mechanism).size())},
      {"constraint_count", std::to_string(names.constraints.size())},
      {"coordinate_list", name_list(names.coordinates)},
      {"speed_list", name_list(names.speeds)},
      {"c_inputs", c_inputs(mechanism, names.parameters.size(), names.wrench_bodies.size())},
      {"index_aliases", index_aliases(mechanism, full_namespace)},
      {"indices", c_indices(mechanism)},
  };
}

std::string index_doc(const Mechanism& mechanism, bool frame_poses) {
  const std::vector<Indices> described = described_indices(mechanism);
  if (described.empty()) return "";
  const auto has = [&](std::string_view type) {
    return std::ranges::find(described, type, &Indices::type) != described.end();
  };
  std::vector<std::string> uses;
  for (const auto& [type, use] : {std::pair("Coordinate", "q(Coordinate::NAME)"),
                                  {"Speed", "qd(Speed::NAME)"},
                                  {"Frame", "frame_poses(q)[Frame::NAME]"},
                                  {"Parameter", "in.parameters[Parameter::NAME]"},
                                  {"Input", "in.parameters[Input::NAME]"},
                                  {"State", "in.parameters[State::NAME]"}})
    if (has(type) && (frame_poses || type != std::string_view("Frame"))) uses.emplace_back(use);
  const std::string text =
      index_text(mechanism, uses, has("Wrench") ? "Wrench::" : "", objects_in_cpp, "a macro");
  return wrap_words(text, 0, 0, kWidth);
}

Slots cpp_constant_slots(const Mechanism& mechanism) {
  const Names names = names_of(mechanism);
  return {
      {"name_literal", string_literal(mechanism.name)},
      {"coordinate_names", cpp_array(literals(names.coordinates))},
      {"speed_names", cpp_array(literals(names.speeds))},
      {"body_names", cpp_array(literals(names.bodies))},
      {"frame_names", cpp_array(literals(names.frames))},
      {"output_names", cpp_array(literals(names.outputs))},
      {"force_names", cpp_array(literals(names.forces))},
      {"parameter_names", cpp_array(literals(names.parameters))},
      {"wrench_names", cpp_array(literals(names.wrench_bodies))},
      {"initial", cpp_array(initial_coordinates(mechanism, "double"))},
      {"initial_speeds", cpp_array(initial_speeds(mechanism, "double"))},
      {"lower_limits", cpp_array(limits(mechanism, true, kCppInfinity))},
      {"upper_limits", cpp_array(limits(mechanism, false, kCppInfinity))},
      {"effort_limits", cpp_array(drive_limits(mechanism, &Coordinate::effort_limit, kCppInfinity))},
      {"speed_limits", cpp_array(drive_limits(mechanism, &Coordinate::speed_limit, kCppInfinity))},
      {"quaternion_offsets", cpp_array(quaternion_offsets(mechanism))},
      {"index_structs", index_structs(mechanism)},
      {"constraint_names", cpp_array(literals(names.constraints))},
      {"holonomic", cpp_array(holonomic(mechanism, "true", "false"))},
      {"row_lengths", cpp_array(row_lengths(mechanism))},
      {"cpp_inputs", cpp_inputs(mechanism, names.wrench_bodies.size())},
  };
}

Slots c_constant_slots(const Mechanism& mechanism, std::string_view number, const std::string& null) {
  const Names names = names_of(mechanism);
  return {
      {"coordinate_names", c_array(literals(names.coordinates), null)},
      {"speed_names", c_array(literals(names.speeds), null)},
      {"body_names", c_array(literals(names.bodies), null)},
      {"frame_names", c_array(literals(names.frames), null)},
      {"output_names", c_array(literals(names.outputs), null)},
      {"force_names", c_array(literals(names.forces), null)},
      {"parameter_names", c_array(literals(names.parameters), null)},
      {"wrench_names", c_array(literals(names.wrench_bodies), null)},
      {"constraint_names", c_array(literals(names.constraints), null)},
      {"holonomic", c_array(holonomic(mechanism, "1", "0"), "0")},
      {"initial", c_array(initial_coordinates(mechanism, number), "")},
      {"initial_speeds", c_array(initial_speeds(mechanism, number), "")},
      {"parameter_defaults", c_array(parameter_defaults(mechanism, "{}", number), c_literal(0, number))},
  };
}

Slots python_constant_slots(const Mechanism& mechanism) {
  const auto tuple = [](const std::vector<std::string>& items) {
    return fmt::format("({}{})", wrapped(items), items.size() == 1 ? "," : "");
  };
  return scripted_slots(mechanism, tuple, string_literal, {"True", "False", "numpy.inf"});
}

Slots javascript_constant_slots(const Mechanism& mechanism) {
  const auto array = [](const std::vector<std::string>& items) {
    return fmt::format("[{}]", wrapped(items));
  };
  return scripted_slots(mechanism, array, javascript_string, {"true", "false", "Infinity"});
}

}  // namespace alembert

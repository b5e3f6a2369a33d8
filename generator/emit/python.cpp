// Writes the Python module of a mechanism (see the header).
#include "emit/python.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "emit/argument_lists.hpp"
#include "emit/common_slots.hpp"
#include "emit/function_docs.hpp"
#include "emit/statements/literals.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/names.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

constexpr std::array<std::string_view, 35> kPythonKeywords = {
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};
/// Modules that the written one imports, or that cannot be without.
constexpr std::array<std::string_view, 12> kModulesInUse = {"collections", "ctypes", "difflib",   "numpy",
                                                            "os",          "sys",    "threading", "torch",
                                                            "typing",      "types",  "site",      "alembert"};

bool one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// Runtime parameters that can be keyword arguments of a function: the others are given in a dict.
std::vector<std::string_view> keyword_parameters(const OutputFunction& function, const Mechanism& mechanism) {
  static constexpr std::array<std::string_view, 9> kTaken = {"q",          "qd",       "qdd", "tau",    "t",
                                                             "parameters", "wrenches", "out", "threads"};
  std::vector<std::string_view> names;
  for (const Parameter& parameter : mechanism.parameters)
    if (parameter.runtime && !parameter.name.starts_with('_') && !one_of(parameter.name, kTaken) &&
        !one_of(parameter.name, argument_names(function)) && !one_of(parameter.name, kPythonKeywords))
      names.push_back(parameter.name);
  return names;
}

/// Names for the comment of the module.
std::string listed(const std::vector<std::string>& names) {
  return name_list(names, names.size());
}

/// What the comment of the module says of the argument `parameters`, and which of them can be keywords.
std::string parameters_doc(std::span<const WrittenFunction> functions, const Mechanism& mechanism,
                           const Slots& common) {
  std::vector<std::string> never, sometimes;
  bool always = false;
  for (const Parameter& parameter : mechanism.parameters) {
    if (!parameter.runtime) continue;
    std::size_t takers = 0, functions_with_inputs = 0;
    for (const WrittenFunction& function : functions) {
      if (!function.signature->takes_inputs) continue;
      ++functions_with_inputs;
      if (one_of(parameter.name, keyword_parameters(*function.signature, mechanism))) ++takers;
    }
    if (takers == functions_with_inputs)
      always = true;
    else if (takers == 0)
      never.push_back(parameter.name);
    else
      sometimes.push_back(parameter.name);
  }
  if (common.at("parameter_count") == "0") return "(0,): there are no runtime parameters";
  std::string text =
      fmt::format("({},) {}, or a dict by name", common.at("parameter_count"), common.at("parameters_text"));
  if (!always && sometimes.empty())
    text += "; no keywords, because Python or the functions use these names";
  else if (never.empty())
    text += "; each can also be given as a keyword";
  else
    text +=
        fmt::format("; each can also be given as a keyword but {}, which only the dict takes", listed(never));
  if (!sometimes.empty())
    text += fmt::format("; {} only where the function has no argument of that name", listed(sometimes));
  return text;
}

/// `(6, 3)`, `(6,)`, `()`
template <class T>
std::string tuple_of(const std::vector<T>& items) {
  return fmt::format("({}{})", fmt::join(items, ", "), items.size() == 1 ? "," : "");
}

/// `MassMatrixAndBias` for a function of several results.
std::string result_type(const OutputFunction& function) {
  std::string out;
  bool begins = true;
  for (const char c : function.name) {
    if (c != '_') out += begins && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    begins = c == '_';
  }
  return out;
}

/// Text inside a docstring.
std::string docstring(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '"') out += '\\';
    out += c;
  }
  while (out.ends_with('\n')) out.pop_back();
  return out;
}

/// Below its first item, however far right that is.
std::string wrapped_in_python(std::string_view start, const std::string& list) {
  return wrap_behind(start, list, start.size());
}

/// The arguments of a function; `hinted` with types.
std::string signature_of(const OutputFunction& function, const Mechanism& mechanism, bool hinted) {
  const auto optional = [hinted](std::string_view name, std::string_view type, std::string_view value) {
    return hinted ? fmt::format("{}: {} = ...", name, type) : fmt::format("{}={}", name, value);
  };
  std::vector<std::string> items;
  for (const ArgumentKind kind : function.arguments)
    items.push_back(fmt::format("{}{}", argument_name(kind), hinted ? ": ArrayLike" : ""));
  if (function.takes_inputs) items.push_back(optional("t", "ArrayLike", "0.0"));
  items.emplace_back("*");
  if (function.takes_inputs) {
    for (const std::string_view name : {"parameters", "wrenches"})
      items.push_back(optional(name, "Inputs", "None"));
    for (const std::string_view name : keyword_parameters(function, mechanism))
      items.push_back(optional(name, "Optional[ArrayLike]", "None"));
  }
  const bool several = function.results.size() > 1;
  items.push_back(optional("out", several ? "Optional[Sequence[Array]]" : "Optional[Array]", "None"));
  items.push_back(optional("threads", "int", "0"));
  return wrapped_in_python(fmt::format("def {}(", function.name), fmt::format("{}", fmt::join(items, ", ")));
}

std::string python_function(const WrittenFunction& written, const Mechanism& mechanism) {
  const OutputFunction& function = *written.signature;
  std::vector<std::string> keywords;
  for (const std::string_view name : keyword_parameters(function, mechanism))
    keywords.push_back(fmt::format("\"{0}\": {0}", name));
  const std::string inputs = function.takes_inputs
                                 ? fmt::format("(t, parameters, wrenches, {{{}}})", fmt::join(keywords, ", "))
                                 : "None";
  const std::string doc =
      prefix_lines(docstring(function_doc(function, mechanism, written.counts, "")), "    ").substr(4);
  return fill_template("python_function.py", {{"function", std::string(function.name)},
                                              {"signature", signature_of(function, mechanism, false)},
                                              {"doc", doc},
                                              {"arguments", tuple_of(argument_names(function))},
                                              {"inputs", wrap_list(inputs, 30, 17)}});
}

/// The row of a function in the module's own table.
std::string table_row(const OutputFunction& function, const Mechanism& mechanism) {
  std::vector<std::string> arguments, results;
  for (const ArgumentKind kind : function.arguments)
    arguments.push_back(fmt::format("(\"{}\", ({},))", argument_name(kind), argument_size(kind, mechanism)));
  for (const ResultArray& result : function.results)
    results.push_back(fmt::format("(\"{}\", {})", result.name, tuple_of(natural_shape(result, mechanism))));
  const std::string start = fmt::format("_{} = _Function(", function.name);
  const std::string items = fmt::format("\"{}\", {}, {}, {}, {}", function.name, tuple_of(arguments),
                                        function.takes_inputs ? "True" : "False", tuple_of(results),
                                        function.results.size() > 1 ? result_type(function) : "None");
  return start + wrapped_in_python(start, items) + ")\n";
}

/// A function of C over many states.
std::string states_function(const OutputFunction& function, const Mechanism& mechanism,
                            const std::string& number, const Slots& common) {
  std::vector<std::string> items;
  std::size_t k = 0;
  for (; k < function.arguments.size(); ++k)
    items.push_back(fmt::format("arguments[{0}] + i * steps[{0}]", k));
  if (function.takes_inputs) {
    items.push_back(fmt::format("arguments[{0}][i * steps[{0}]]", k));
    for (const std::size_t array : {k + 1, k + 2})
      items.push_back(fmt::format("arguments[{0}] + i * steps[{0}]", array));
  }
  for (std::size_t r = 0; r < function.results.size(); ++r)
    items.push_back(
        fmt::format("results[{}] + i * {}", r, array_shape(function.results[r], mechanism).size()));
  const std::string start = fmt::format("int {}_{}_states(", common.at("name"), function.name);
  const std::string list =
      fmt::format("size_t n, const {0}* const* arguments, const size_t* steps, {0}* const* results", number);
  const std::string call = fmt::format("    const int status = {}_{}(", common.at("name"), function.name);
  return fill_template("states_function.c",
                       {{"function", std::string(function.name)},
                        {"head", start + wrap_list(list, start.size() + 16, 4) + ")"},
                        {"call", wrap_list(fmt::format("{}", fmt::join(items, ", ")), call.size(), 8)}},
                       common);
}

/// Tells texts apart: FNV-1a.
std::string key_of(std::span<const EmittedFile> files, std::string_view more) {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  };
  for (const EmittedFile& file : files) add(file.text);
  add(more);
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::vector<EmittedFile> python_files(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                                      std::span<const EmittedFile> c_files, const std::string& number,
                                      const Slots& common) {
  const bool keyword = one_of(mechanism.name, kPythonKeywords);
  if (keyword || one_of(mechanism.name, kModulesInUse))
    throw InputError(mechanism.where,
                     fmt::format("'{}' cannot name a Python module: it is {}", printable(mechanism.name),
                                 keyword ? "a keyword of Python" : "the name of another module in use"));
  std::string states, tuples, stub_tuples, table, definitions, stubs;
  std::vector<std::string> names;
  for (const WrittenFunction& written : functions) {
    const OutputFunction& function = *written.signature;
    const bool several = function.results.size() > 1;
    const std::string type = several ? result_type(function) : "Array";
    names.push_back(fmt::format("\"{}\"", function.name));
    states += (states.empty() ? "" : "\n") + states_function(function, mechanism, number, common);
    table += table_row(function, mechanism);
    definitions += (definitions.empty() ? "" : "\n\n") + python_function(written, mechanism);
    stubs += fill_template("python_stub.pyi", {{"function", std::string(function.name)},
                                               {"signature", signature_of(function, mechanism, true)},
                                               {"result", type}});
    if (!several) continue;
    std::vector<std::string> fields;
    stub_tuples += fmt::format("class {}(NamedTuple):\n", type);
    for (const ResultArray& result : function.results) {
      const std::string field =
          fmt::format("{}{}", result.name, one_of(result.name, kPythonKeywords) ? "_" : "");
      fields.push_back(fmt::format("\"{}\"", field));
      stub_tuples += fmt::format("    {}: Array\n", field);
    }
    tuples += fmt::format("{0} = collections.namedtuple(\"{0}\", [{1}])\n", type, fmt::join(fields, ", "));
  }
  const std::string banner = prefix_lines(common.at("banner"), "# ");
  const std::string dtype = number == "float" ? "float32" : "float64";
  const std::string key = key_of(c_files, states);
  const std::string title = mechanism.description.empty()
                                ? fmt::format("Equations of motion of {}.", mechanism.name)
                                : docstring(wrap_words(comment_text(mechanism.description), 3, 0, 110));
  Slots words = common;
  words["coordinate_list"] = docstring(words["coordinate_list"]);
  words["speed_list"] = docstring(words["speed_list"]);
  Slots module = python_constant_slots(mechanism);
  module.merge(Slots{
      {"banner", banner},
      {"title", title},
      {"version", std::string(generator_version())},
      {"dtype", dtype},
      {"key", key},
      {"state_arguments", state_arguments(functions, words, 12, "({},)")},
      {"parameters_doc",
       "parameters  " + wrap_words(docstring(parameters_doc(functions, mechanism, common)), 14, 12, 110)},
      {"function_names", wrap_list(tuple_of(names), 17, 18)},
      {"tuples", tuples},
      {"table", table},
      {"functions", definitions}});
  return {
      {fmt::format("src/{}_states.c", mechanism.name),
       fill_template("mechanism_states.c", {{"key", key}, {"definitions", states}}, common)},
      {fmt::format("python/{}.py", mechanism.name), fill_template("mechanism.py", module, words)},
      {fmt::format("python/{}.pyi", mechanism.name),
       fill_template("mechanism.pyi",
                     {{"banner", banner}, {"dtype", dtype}, {"tuples", stub_tuples}, {"functions", stubs}})}};
}

}  // namespace alembert

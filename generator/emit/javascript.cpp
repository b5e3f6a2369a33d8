// Writes the JavaScript module of a mechanism (see the header).
#include "emit/javascript.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "emit/argument_lists.hpp"
#include "emit/common_slots.hpp"
#include "emit/function_docs.hpp"
#include "emit/statements/literals.hpp"
#include "functions/array_shape.hpp"

namespace alembert {
namespace {

std::string_view meaning(ArgumentKind kind) {
  return kind == ArgumentKind::q     ? "coordinates"
         : kind == ArgumentKind::qd  ? "speeds"
         : kind == ArgumentKind::qdd ? "rates of the speeds"
         : kind == ArgumentKind::mu  ? "weights of the generalized forces"
                                     : "generalized forces";
}

/// Types and shapes of arguments and results, for editors.
std::string typed_doc(const OutputFunction& function, const Mechanism& mechanism) {
  std::string out;
  for (const ArgumentKind kind : function.arguments)
    out += fmt::format("@param {{ArrayLike<number>}} {} [{}] {}\n", argument_name(kind),
                       argument_size(kind, mechanism), meaning(kind));
  if (function.takes_inputs) out += "@param {Inputs} [inputs]\n";
  std::vector<std::string> shapes, members;
  for (const ResultArray& result : function.results) {
    shapes.push_back(result_with_shape(result, mechanism));
    members.push_back(fmt::format("{}: Float64Array", result.name));
  }
  const std::string type =
      members.size() == 1 ? "Float64Array" : fmt::format("{{{}}}", fmt::join(members, ", "));
  return out +
         fmt::format("@param {{{0}}} [out] takes the results, in place of new arrays\n@returns {{{0}}} {1}\n",
                     type, fmt::join(shapes, "; "));
}

std::vector<std::string> parameters_of(const OutputFunction& function, std::string_view inputs) {
  std::vector<std::string> names;
  for (const std::string_view name : argument_names(function)) names.emplace_back(name);
  if (function.takes_inputs) names.emplace_back(inputs);
  return names;
}

/// The checks of arguments, and the arrays of the results.
std::string opening(const OutputFunction& function, const Mechanism& mechanism) {
  std::string out;
  for (const ArgumentKind kind : function.arguments)
    out += fmt::format("check_numbers(\"{0}\", {0}, {1});\n", argument_name(kind),
                       argument_size(kind, mechanism));
  if (function.takes_inputs) out += "const given = given_inputs(inputs);\n";
  for (const ResultArray& result : function.results) {
    const std::string member = function.results.size() == 1 ? "" : fmt::format("?.{}", result.name);
    out += fmt::format("const {0} = array_for(\"{0}\", out{1}, {2});\n", result.name, member,
                       array_shape(result, mechanism).size());
  }
  return out;
}

std::string function_text(const WrittenFunction& written, const Mechanism& mechanism) {
  const OutputFunction& function = *written.signature;
  const std::vector<CodeBlock>& blocks = written.body.blocks;
  std::string before, statements = blocks[0].statement_lines;
  if (blocks.size() > 1) {
    std::vector<std::string> handed = parameters_of(function, "given");
    for (const std::string_view name : result_names(function)) handed.emplace_back(name);
    const std::string list = fmt::format("{}", fmt::join(handed, ", "));
    statements.clear();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::string call = fmt::format("{}_block{}({})", function.name, i + 1, list);
      statements += call + ";\n";
      before +=
          fmt::format("function {} {{\n{}}}\n\n", call, prefix_lines(blocks[i].statement_lines, "  ") + "\n");
    }
  }
  std::vector<std::string> parameters = parameters_of(function, "inputs");
  parameters.emplace_back("out");
  const std::vector<std::string_view> results = result_names(function);
  return before +
         fill_template("javascript_function.mjs",
                       {{"doc", prefix_lines(function_doc(function, mechanism, written.counts, "") + "\n" +
                                                 typed_doc(function, mechanism),
                                             " * ")},
                        {"function", std::string(function.name)},
                        {"parameters", fmt::format("{}", fmt::join(parameters, ", "))},
                        {"opening", opening(function, mechanism)},
                        {"statements", statements},
                        {"result", results.size() == 1 ? std::string(results[0])
                                                       : fmt::format("{{ {} }}", fmt::join(results, ", "))}});
}

}  // namespace

std::string javascript_module(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                              const Slots& common) {
  std::string definitions, helpers;
  std::vector<std::string> names;
  std::set<std::string> called;
  std::size_t crossing = 0;
  for (const WrittenFunction& written : functions) {
    definitions += (definitions.empty() ? "" : "\n") + function_text(written, mechanism);
    names.emplace_back(written.signature->name);
    crossing = std::max(crossing, written.body.crossing);
    for (const CodeBlock& block : written.body.blocks)
      called.insert(block.helpers.begin(), block.helpers.end());
  }
  for (const std::string_view helper : kHelpers)
    if (called.contains(std::string(helper)))
      helpers += fill_template(fmt::format("javascript_{}.mjs", helper), {}) + "\n";
  if (crossing > 0)
    helpers =
        fmt::format("// What functions keep while they compute.\nconst kept = new Float64Array({});\n\n",
                    crossing) +
        helpers;
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(fmt::format("\"{}\"", name));
  Slots slots = javascript_constant_slots(mechanism);
  slots["banner"] = prefix_lines(common.at("banner"), "// ");
  slots["title"] = mechanism.description.empty()
                       ? fmt::format(" * Equations of motion of {}.", mechanism.name)
                       : prefix_lines(wrap_words(comment_text(mechanism.description), 3, 0, 110), " * ");
  slots["function_names"] = wrap_list(fmt::format("{}", fmt::join(quoted, ", ")), 2, 2);
  slots["functions"] = wrap_list(fmt::format("{}", fmt::join(names, ", ")), 2, 2);
  slots["state_arguments"] = prefix_lines(state_arguments(functions, common, 5, "[{}]"), " *   ");
  slots["at"] = "@";
  slots["helpers"] = helpers;
  slots["definitions"] = definitions;
  return fill_template("mechanism.mjs", slots, common);
}

}  // namespace alembert

// Writes the source file of C99 from templates, see the header.
#include "emit/c99.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/common_slots.hpp"
#include "emit/statements/literals.hpp"
#include "mechanism/names.hpp"

namespace alembert {
namespace {

/// Whether a word stands in code, comments to the ends of lines apart.
bool has_word(std::string_view code, std::string_view word) {
  while (!code.empty()) {
    const std::string_view line = code.substr(0, code.find('\n'));
    const std::string_view text = line.substr(0, line.find("//"));
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const bool begins = at == 0 || !is_word_character(text[at - 1]);
      const std::size_t end = at + word.size();
      if (begins && (end == text.size() || !is_word_character(text[end]))) return true;
    }
    code.remove_prefix(std::min(line.size() + 1, code.size()));
  }
  return false;
}

/// Names of all arguments in order.
std::vector<std::string_view> all_names(const OutputFunction& signature) {
  std::vector<std::string_view> names = argument_names(signature);
  if (signature.takes_inputs) names.insert(names.end(), {"t", "parameters", "wrenches"});
  std::ranges::copy(result_names(signature), std::back_inserter(names));
  return names;
}

/// `(void)q;` for arguments that `code` does not use, which compilers would warn of.
std::string unused(const std::vector<std::string_view>& names, std::string_view code) {
  std::string out;
  for (const std::string_view name : names)
    if (!has_word(code, name)) out += fmt::format("(void){};\n", name);
  return out;
}

/// The blocks of a long function, each a function of its own.
std::string block_functions(const WrittenFunction& function, const std::string& name,
                            const std::string& number, const Slots& common) {
  const std::string parameters = c_parameters(*function.signature, number, " restrict");
  std::vector<std::string_view> arguments = all_names(*function.signature);
  arguments.push_back("kept");
  std::string out;
  for (std::size_t i = 0; i < function.body.blocks.size(); ++i) {
    const std::string& statements = function.body.blocks[i].statement_lines;
    const std::string start = fmt::format("static ALEMBERT_NOINLINE void {}_block{}(", name, i + 1);
    out += fill_template(
               "c99_block.c",
               {{"start", start},
                {"arguments", wrap_behind(start, fmt::format("{}, {}* restrict kept", parameters, number))},
                {"unused", unused(arguments, statements)},
                {"statements", statements}},
               common) +
           "\n";
  }
  return out;
}

std::string definition(const WrittenFunction& function, const std::string& number, const Slots& common) {
  const OutputFunction& signature = *function.signature;
  const std::string name = fmt::format("{}_{}", common.at("name"), signature.name);
  const std::vector<CodeBlock>& blocks = function.body.blocks;
  const bool cut = blocks.size() > 1;
  const std::vector<std::string_view> arguments = all_names(signature);
  const auto reads = [&](std::string_view word) {
    return std::ranges::any_of(blocks, [&](const CodeBlock& b) { return has_word(b.statement_lines, word); });
  };
  std::string statements = blocks[0].statement_lines;
  if (cut) {
    statements = fmt::format("{} kept[{}];\n", number, std::max<std::size_t>(function.body.crossing, 1));
    for (std::size_t i = 0; i < blocks.size(); ++i)
      statements += fmt::format("{}_block{}({}, kept);\n", name, i + 1, fmt::join(arguments, ", "));
  }
  const std::string checks = c_null_check(signature, "0");
  std::string defaults;
  if (reads("parameters"))
    defaults += fmt::format("if (parameters == 0) parameters = {}_default_parameters;\n", common.at("name"));
  if (reads("wrenches"))
    defaults += fmt::format("if (wrenches == 0) wrenches = {}_no_wrenches;\n", common.at("name"));
  const std::string start = fmt::format("int {}(", name);
  return (cut ? block_functions(function, name, number, common) : "") +
         fill_template("c99_function.c",
                       {{"start", start},
                        {"arguments", wrap_behind(start, c_parameters(signature, number, " restrict"))},
                        {"counts", function.counts},
                        {"null_check", checks},
                        {"unused", unused(arguments, checks + "\n" + statements)},
                        {"defaults", defaults},
                        {"statements", statements}},
                       common);
}

}  // namespace

std::string c99_source(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                       const std::string& number, const Slots& common) {
  const Syntax syntax = c_syntax(number, common.at("name") + "_");
  Slots words = common;
  words.insert({{"number", number},
                {"zero", c_literal(0, number)},
                {"sin", syntax.function("sin")},
                {"cos", syntax.function("cos")}});
  std::string definitions, helpers;
  std::set<std::string> called;
  bool cut = false;
  for (const WrittenFunction& function : functions) {
    definitions += (definitions.empty() ? "" : "\n") + definition(function, number, common);
    cut |= function.body.blocks.size() > 1;
    for (const CodeBlock& block : function.body.blocks)
      called.insert(block.helpers.begin(), block.helpers.end());
  }
  const auto add = [&](bool wanted, std::string_view name) {
    if (wanted) helpers += (helpers.empty() ? "" : "\n") + fill_template(name, {}, words);
  };
  add(cut, "noinline.hpp");
  add(has_word(definitions, common.at("name") + "_no_wrenches"), "c99_no_wrenches.c");
  for (const std::string_view helper : kHelpers)
    add(called.contains(std::string(helper)), fmt::format("c99_{}.c", helper));
  Slots slots = c_constant_slots(mechanism, number, "0");
  slots["number"] = number;
  slots["helpers"] = helpers;
  slots["definitions"] = definitions;
  return fill_template("mechanism.c", slots, common);
}

}  // namespace alembert

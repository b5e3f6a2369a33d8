// Documentation from rows of the function table (see the header).
#include "emit/function_docs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "emit/statements/literals.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/names.hpp"

namespace alembert {
namespace {

constexpr std::size_t kDocWidth = 112;

std::string paragraph(std::string_view text, std::size_t indent = 0) {
  return wrap_words(text, 0, indent, kDocWidth) + "\n";
}

std::string formula_line(const OutputFunction& function) {
  return function.formula.empty() ? "" : fmt::format("  {}\n", function.formula);
}

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}

/// A text of the table with the constants that it names, `kBodyNames`, called as the language calls them:
/// PREFIXbody_names. Without a prefix they keep the names of C++.
std::string with_constants(std::string_view text, const std::optional<std::string>& prefix) {
  if (!prefix) return std::string(text);
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool constant = text[i] == 'k' && (i == 0 || !is_word_character(text[i - 1])) &&
                          i + 1 < text.size() && is_capital(text[i + 1]);
    if (!constant) {
      out += text[i];
      continue;
    }
    out += *prefix;
    for (bool first = true; i + 1 < text.size() && is_word_character(text[i + 1]); ++i, first = false) {
      const char c = text[i + 1];
      if (is_capital(c) && !first) out += '_';
      out += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return out;
}

}  // namespace

std::string result_with_shape(const ResultArray& result, const Mechanism& mechanism) {
  const std::vector<std::size_t> sizes = natural_shape(result, mechanism);
  return fmt::format("{} [{}]{}", result.name, fmt::join(sizes, " x "),
                     sizes.size() > 1 ? ", row by row" : "");
}

std::string function_summary(const OutputFunction& function) {
  return paragraph(function.summary) + formula_line(function);
}

std::string function_doc(const OutputFunction& function, const Mechanism& mechanism,
                         const std::string& operations, const std::optional<std::string>& prefix) {
  std::string text = paragraph(with_constants(function.summary, prefix)) + formula_line(function);
  for (const ResultArray& result : function.results)
    text += paragraph(
        fmt::format("{}: {}.", result_with_shape(result, mechanism), with_constants(result.meaning, prefix)),
        2);
  if (!function.remark.empty()) text += paragraph(with_constants(function.remark, prefix));
  if (!function.source.empty()) text += paragraph(fmt::format("Source: {}.", function.source), 2);
  return text + fmt::format("Operations: {}.\n", operations);
}

std::string state_arguments(std::span<const WrittenFunction> functions, const Slots& common,
                            std::size_t width, std::string_view brackets) {
  struct Line {
    ArgumentKind kind;
    std::string_view size;
    std::string meaning;
  };
  const Line lines[] = {
      {ArgumentKind::q, "nq", "coordinates: " + common.at("coordinate_list")},
      {ArgumentKind::qd, "nv", "speeds: " + common.at("speed_list")},
      {ArgumentKind::qdd, "nv", "rates of the speeds"},
      {ArgumentKind::tau, "nv", "generalized forces: N m for a speed in rad/s, N for one in m/s"},
      {ArgumentKind::mu, "nv",
       "weights of generalized forces: second derivatives are those of their weighted sum"}};
  std::string out;
  for (const Line& line : lines) {
    const std::string_view name = argument_name(line.kind);
    const auto has_it = [&](const WrittenFunction& function) {
      return std::ranges::find(function.signature->arguments, line.kind) !=
                 function.signature->arguments.end() ||
             std::ranges::find(function.signature->results, name, &ResultArray::name) !=
                 function.signature->results.end();
    };
    if (std::ranges::any_of(functions, has_it))
      out += fmt::format("{:<{}}{} {}\n", name, width,
                         fmt::format(fmt::runtime(brackets), common.find(line.size)->second), line.meaning);
  }
  return out;
}

}  // namespace alembert

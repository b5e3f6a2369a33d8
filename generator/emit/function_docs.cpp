// Documentation from rows of the function table (see the header).
#include "emit/function_docs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "emit/statements/literals.hpp"
#include "functions/array_shape.hpp"

namespace alembert {
namespace {

constexpr std::size_t kDocWidth = 112;

std::string paragraph(std::string_view text, std::size_t indent = 0) {
  return wrap_words(text, 0, indent, kDocWidth) + "\n";
}

std::string formula_line(const OutputFunction& function) {
  return function.formula.empty() ? "" : fmt::format("  {}\n", function.formula);
}

/// A text of the table with names as C has them.
std::string with_names_of_c(std::string_view text, const std::string& prefix) {
  std::string out(text);
  if (prefix.empty()) return out;
  for (const auto& [cpp, c] : {std::pair("kBodyNames", "_body_names"),
                               {"kFrameNames", "_frame_names"},
                               {"kConstraintNames", "_constraint_names"},
                               {"kHolonomic", "_holonomic"}})
    if (const std::size_t at = out.find(cpp); at != std::string::npos)
      out.replace(at, std::string_view(cpp).size(), prefix + c);
  return out;
}

}  // namespace

std::string result_with_shape(const ResultArray& result, const Mechanism& mechanism) {
  const ArrayShape shape = array_shape(result, mechanism);
  std::vector<std::size_t> sizes;
  const bool several = result.per != Per::mechanism;
  if (several) sizes.push_back(shape.blocks);
  if (!several || result.rows != Extent(1)) sizes.push_back(shape.rows);
  if (result.columns != Extent(1)) sizes.push_back(shape.columns);
  return fmt::format("{} [{}]{}", result.name, fmt::join(sizes, " x "),
                     sizes.size() > 1 ? ", row by row" : "");
}

std::string function_summary(const OutputFunction& function) {
  return paragraph(function.summary) + formula_line(function);
}

std::string function_doc(const OutputFunction& function, const Mechanism& mechanism,
                         const std::string& operations, const std::string& c_prefix) {
  std::string text = paragraph(with_names_of_c(function.summary, c_prefix)) + formula_line(function);
  for (const ResultArray& result : function.results)
    text += paragraph(fmt::format("{}: {}.", result_with_shape(result, mechanism),
                                  with_names_of_c(result.meaning, c_prefix)),
                      2);
  if (!function.remark.empty()) text += paragraph(function.remark);
  if (!function.source.empty()) text += paragraph(fmt::format("Source: {}.", function.source), 2);
  return text + fmt::format("Operations: {}.\n", operations);
}

}  // namespace alembert

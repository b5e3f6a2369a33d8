// Documentation from rows of the function table (see the header).
#include "emit/function_docs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "emit/statements/literals.hpp"
#include "functions/array_shape.hpp"

namespace alembert {
namespace {

constexpr std::size_t kDocWidth = 112;

std::string paragraph(std::string_view text, std::size_t indent = 0) {
  return wrap_words(text, 0, indent, kDocWidth) + "\n";
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
  std::string text = paragraph(function.summary);
  if (!function.formula.empty()) text += "  " + std::string(function.formula) + "\n";
  return text;
}

std::string function_doc(const OutputFunction& function, const Mechanism& mechanism,
                         const std::string& operations) {
  std::string text = function_summary(function);
  for (const ResultArray& result : function.results)
    text += paragraph(fmt::format("{}: {}.", result_with_shape(result, mechanism), result.meaning), 2);
  if (!function.remark.empty()) text += paragraph(function.remark);
  if (!function.source.empty()) text += paragraph(fmt::format("Source: {}.", function.source), 2);
  return text + fmt::format("Operations: {}.\n", operations);
}

}  // namespace alembert

#include "urdf/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mechanism/expression_grammar.hpp"
#include "mechanism/names.hpp"

namespace alembert {

std::string fit_name(const std::string& name, const std::string& noun) {
  std::string out;
  for (const char c : name) {
    if (is_word_character(c) && c != '_') {
      out += c;
    } else if (!out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  while (out.ends_with('_')) out.pop_back();
  if (out.empty()) return noun;
  if (is_digit(out[0])) out = noun + "_" + out;
  const bool reserved = std::ranges::find(reserved_names(), out) != reserved_names().end();
  if (reserved || out == "world" || (out.size() <= kMaximumName && !objection_to_name(out).empty()))
    out += "_" + noun;
  return out;
}

std::string FitNames::add(const std::string& name, const SourceLocation& where, const std::string& suffix) {
  const std::string fit = fit_name(name, noun_) + suffix;
  const auto [entry, inserted] = taken_.try_emplace(fit, name, where.line);
  if (!inserted)
    throw InputError(where,
                     fmt::format("{0} '{1}' would be called '{2}', as '{3}' (line {4}) is", noun_,
                                 printable(name), fit, printable(entry->second.first), entry->second.second),
                     "names keep their letters, digits and underscores");
  return fit;
}

}  // namespace alembert

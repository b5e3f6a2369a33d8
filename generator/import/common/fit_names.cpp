#include "import/common/fit_names.hpp"

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

std::string fit_mechanism_name(const std::string& name) {
  const std::string fit = fit_name(name, "robot").substr(0, kMaximumName);
  return objection_to_mechanism_name(fit).empty() ? fit : fit + "_robot";
}

void FitNames::reserve(const std::string& name) {
  if (fit_name(name, noun_) == name) reserved_.insert(name);
}

std::string FitNames::add(const std::string& name, const SourceLocation& where, const std::string& suffix) {
  const auto with = [&](const std::string& end) {
    std::string start = fit_name(name, noun_).substr(0, kMaximumName - end.size());
    while (start.ends_with('_')) start.pop_back();
    return start + end;
  };
  const std::string first = with(suffix);
  const auto is_free = [&](const std::string& fit) {
    return !taken_.contains(fit) && (fit == name + suffix || !reserved_.contains(fit));
  };
  std::string fit = first;
  while (!is_free(fit)) fit = with("_" + std::to_string(std::max(++last_[first], 2)) + suffix);
  if (fit != first || first.size() < fit_name(name, noun_).size() + suffix.size()) {
    const auto other = taken_.find(first);
    const std::string why = fit == first ? fmt::format("a name has at most {} characters", kMaximumName)
                            : other == taken_.end()
                                ? fmt::format("another has the name '{}'", first)
                                : fmt::format("'{}' is '{}' (line {})", first, printable(other->second.first),
                                              other->second.second);
    warnings_.push_back({where,
                         fmt::format("{} '{}' is called '{}': {}", noun_, printable(name), fit, why),
                         {},
                         "renamed " + noun_});
  }
  taken_.try_emplace(fit, name, where.line);
  return fit;
}

}  // namespace alembert

#include "mechanism/scope.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mechanism/expression_grammar.hpp"
#include "mechanism/names.hpp"

namespace alembert {

std::string_view noun(NameKind kind) {
  switch (kind) {
    case NameKind::parameter:
      return "parameter";
    case NameKind::runtime_parameter:
      return "runtime parameter";
    case NameKind::input:
      return "input";
    case NameKind::state:
      return "state";
    case NameKind::coordinate:
      return "coordinate";
    case NameKind::quaternion:
      return "quaternion coordinate";
    case NameKind::definition:
      return "definition";
  }
  return {};
}

std::string a_noun(NameKind kind) {
  return fmt::format("{} {}", kind == NameKind::input ? "an" : "a", noun(kind));
}

NameEntry& Scope::declare(const Document& document, const YamlNode& name, NameKind kind) {
  const std::string& text = expect_name(document, name, a_noun(kind));
  const SourceLocation where = document.where(name);
  const std::vector<std::string>& reserved = reserved_names();
  if (std::find(reserved.begin(), reserved.end(), text) != reserved.end()) {
    const char* meaning = text == "t" ? "the time" : text == "pi" ? "the number pi" : "a function";
    throw InputError(where, fmt::format("'{}' is reserved: it is {}", text, meaning));
  }
  const auto [entry, inserted] = entries_.try_emplace(text, NameEntry{kind, where, {}, false, false, -1});
  if (!inserted)
    throw InputError(where, fmt::format("'{}' is already {} (line {})", text, a_noun(entry->second.kind),
                                        entry->second.where.line));
  in_order_.push_back(&*entry);
  return entry->second;
}

NameEntry* Scope::find(std::string_view name) {
  const auto entry = entries_.find(name);
  return entry == entries_.end() ? nullptr : &entry->second;
}

std::vector<std::string> Scope::names() const {
  std::vector<std::string> out;
  for (const auto& [name, entry] : entries_) out.push_back(name);
  return out;
}

std::vector<std::string> Scope::coordinate_names() const {
  std::vector<std::string> out;
  for (const auto& [name, entry] : entries_)
    if (entry.index >= 0) out.push_back(name);
  return out;
}

void Scope::check_used(Warnings& warnings) const {
  for (const auto* named : in_order_) {
    const auto& [name, entry] = *named;
    if (entry.used || entry.kind == NameKind::coordinate || entry.kind == NameKind::quaternion ||
        entry.kind == NameKind::state)
      continue;
    warnings.push_back({entry.where, fmt::format("{} '{}' is not used", noun(entry.kind), name)});
  }
}

}  // namespace alembert

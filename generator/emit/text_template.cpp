// Fills templates.
#include "emit/text_template.hpp"

#include <fmt/format.h>

#include <set>

#include "support/error.hpp"

namespace alembert {
namespace {

bool is_slot_character(char c) {
  return (c >= 'a' && c <= 'z') || c == '_';
}

/// Name of the slot that starts at `at`, where an `@` is.
std::string_view slot_at(std::string_view name, std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && is_slot_character(text[end])) ++end;
  if (end >= text.size() || text[end] != '@' || end == at + 1)
    throw InternalError(fmt::format("template {}: an @ that is no slot at byte {}", name, at));
  return text.substr(at + 1, end - at - 1);
}

void append_indented(std::string& out, std::string_view value, std::string_view indent) {
  for (std::size_t start = 0; start < value.size();) {
    const std::size_t end = std::min(value.find('\n', start), value.size());
    if (end > start) out.append(indent).append(value.substr(start, end - start));
    out += '\n';
    start = end + 1;
  }
}

}  // namespace

std::string fill_text(std::string_view name, std::string_view text, const Slots& slots, const Slots& common) {
  std::string out;
  std::set<std::string_view> seen;
  const auto value_of = [&](std::string_view slot) -> const std::string& {
    seen.insert(slot);
    if (const auto found = slots.find(slot); found != slots.end()) return found->second;
    if (const auto found = common.find(slot); found != common.end()) return found->second;
    throw InternalError(fmt::format("template {}: nothing given for slot {}", name, slot));
  };

  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = text.substr(start, end - start);
    start = end + 1;

    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string_view::npos && line[first] == '@') {
      const std::string_view slot = slot_at(name, line, first);
      if (first + slot.size() + 2 == line.size()) {
        const std::string& value = value_of(slot);
        if (value.empty() && out.ends_with("\n\n")) out.pop_back();
        append_indented(out, value, line.substr(0, first));
        continue;
      }
    }
    std::size_t copied = 0;
    for (std::size_t at = line.find('@'); at != std::string_view::npos; at = line.find('@', copied)) {
      const std::string_view slot = slot_at(name, line, at);
      out.append(line.substr(copied, at - copied)).append(value_of(slot));
      copied = at + slot.size() + 2;
    }
    out.append(line.substr(copied)) += '\n';
  }
  for (const auto& [slot, value] : slots)
    if (!seen.contains(slot)) throw InternalError(fmt::format("template {} has no slot {}", name, slot));
  return out;
}

std::string fill_template(std::string_view name, const Slots& slots, const Slots& common) {
  return fill_text(name, template_text(name), slots, common);
}

}  // namespace alembert

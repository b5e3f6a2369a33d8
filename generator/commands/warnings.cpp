// Warnings in, diagnostics on standard error out.
#include "commands/warnings.hpp"

#include <span>
#include <string>

namespace alembert {

void report_warnings(const Warnings& warnings, bool strict) {
  const Warnings shown = one_of_each_kind(warnings);
  const auto tell_line = [](const std::string& text) { tell(text + "\n"); };
  if (!strict) {
    for (const Warning& warning : shown)
      tell_line(warning_text(warning.where, warning.message, warning.note));
    return;
  }
  if (shown.empty()) return;
  for (const Warning& warning : std::span(shown).first(shown.size() - 1))
    tell_line(InputError(warning.where, warning.message, warning.note).what());
  throw InputError(shown.back().where, shown.back().message, shown.back().note);
}

}  // namespace alembert

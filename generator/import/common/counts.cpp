// Counts as text (see the header).
#include "import/common/counts.hpp"

#include <fmt/format.h>

namespace alembert {

std::string counts_text(const Counts& counts) {
  std::string out;
  for (const auto& [what, count] : counts)
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
  return out;
}

std::string left_text(const Counts& approximated, const Counts& left_out) {
  std::string out;
  if (!approximated.empty()) out = "approximated: " + counts_text(approximated);
  if (!left_out.empty()) out += (out.empty() ? "" : "; ") + ("left out: " + counts_text(left_out));
  return out;
}

}  // namespace alembert

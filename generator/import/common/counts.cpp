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

}  // namespace alembert

// How often each thing occurs in a file, and that as text.
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace alembert {

using Counts = std::map<std::string, std::size_t>;

/// `3 collision, 1 sensor`.
std::string counts_text(const Counts& counts);

/// `approximated: 1 BushingForce; left out: 3 collision`; of both what there is.
std::string left_text(const Counts& approximated, const Counts& left_out);

}  // namespace alembert

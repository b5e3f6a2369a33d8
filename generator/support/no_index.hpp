// One number for an index of nothing.
#pragma once

#include <cstdint>
#include <limits>

namespace alembert {

/// The index of no node, value, instruction or place.
inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

}  // namespace alembert

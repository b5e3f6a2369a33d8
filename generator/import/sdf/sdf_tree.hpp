// Links and joints in, a tree out: which joint moves each link, and which joints close chains.
#pragma once

#include "import/sdf/sdf_model.hpp"

namespace alembert {

inline constexpr std::size_t kNoSdfJoint = static_cast<std::size_t>(-1);

/// How a link moves.
struct SdfPlace {
  std::size_t joint = kNoSdfJoint;  ///< none: the link is fixed to the world, or free
  bool reversed = false;            ///< the joint leads from its child to its parent
  bool free = false;
};

struct SdfTree {
  std::vector<SdfPlace> places;   ///< by link
  std::vector<std::size_t> cuts;  ///< joints that close chains, in their order
};

/// Screws, joints with springs and joints that follow or are followed are in the tree where that can be, then those that
/// resist; joints that the file asks to
/// cut are not.
SdfTree span_tree(const SdfModel& model);

}  // namespace alembert

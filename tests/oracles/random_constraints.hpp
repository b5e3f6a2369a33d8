// Constraints of a description that is being written.
#pragma once

#include <string>
#include <vector>

#include "oracles/random_expressions.hpp"

namespace alembert::oracles {

/// A body whose transform moves with one mate only, and the coordinates of its surfaces.
struct RollingBody {
  std::string name, parent;
  std::string u1, v1, u2, v2;  ///< on the parent and on the body
};

/// The sections `frames` and `constraints`: fewer rows than speeds, of all three types.
std::string random_constraints(RandomExpressions& draw, int bodies, const std::vector<RollingBody>& rolling);

}  // namespace alembert::oracles

// Units in which the numbers of a mechanism are about 1. In: a mechanism and its tree of motions. Out: a
// length and a mass, so that what counts as zero does not depend on the size of the mechanism.
#pragma once

#include "dynamics/motion_tree.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// What numbers of lengths and masses are multiples of: powers of two, 1 for mechanisms of the usual sizes.
/// In these units numbers are about 1, and what is small is rounding.
struct Units {
  double length = 1, mass = 1;
  double moment() const { return mass * length; }
  double inertia() const { return mass * length * length; }
};

/// 1 for sizes within a factor of 1000 of it, where numbers stay as they are written; else the power of two
/// below.
double unit_of(double size);

/// From the longest shift that is constant, arm or radius of gyration (where there is none, the longest shift
/// that moves, at a random state), and the largest mass; runtime parameters have their defaults.
Units units_of(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);

}  // namespace alembert

// Constants between motions: runs of constant motions in, one shift and as few plane rotations as there can
// be out.
#pragma once

#include <vector>

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"

namespace alembert {

/// An expression without symbols as a short decimal fraction where it is one; itself otherwise.
Expr short_number(Expr constant);

/// Plane rotations, left to right, that turn the z axis into the constant unit vector `axis`.
std::vector<Motion> turned_to_z(const Vec3& axis, ExprGraph& graph);

/// The product with every run of motions that do not move gathered: its shifts in one, before its rotations,
/// and these as rotations about z, x, z where they are numbers. A run that is short already stays. Shifts are
/// sums of lengths of about this size.
std::vector<Motion> gathered_constants(const std::vector<Motion>& motions,
                                       const SpeedDerivatives& derivatives, double length, ExprGraph& graph);

}  // namespace alembert

// A tree of motions with the choices by which its equations are written.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "dynamics/rewrites/scaled_vectors.hpp"
#include "dynamics/tree/motion_tree.hpp"

namespace alembert {

/// How a component of the moment of a body's inertia is written: both are equal, which is shorter depends on
/// the mechanism.
enum class MomentForm {
  pseudo_inertia,  ///< antisymmetric part of U K with K = tr(J)/2 - J: shares U = skew(al) + skew(om)^2 with
                   ///< everything else
  inertia,         ///< diagonal part as J_xx al_x + (J_zz - J_yy) om_y om_z
};
using MomentForms = std::array<MomentForm, 3>;  ///< x y z

struct WrittenTree {
  /// As it is given: no vectors are scaled, all moments are by pseudo-inertias.
  WrittenTree(MotionTree given) : tree(std::move(given)), moments(tree.nodes.size()) {}

  MotionTree tree;
  std::vector<MomentForms> moments;  ///< of the mass of each node
  Scaling scaling;
  friend bool operator==(const WrittenTree&, const WrittenTree&) = default;
};

}  // namespace alembert

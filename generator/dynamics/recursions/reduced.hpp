// Inverse dynamics by the reduced form (README.md, 2).
#pragma once

#include <vector>

#include "dynamics/recursions/body_forces.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Motions with gravity in them, as if the world were accelerated by -g: of the world, and of each node.
FrameMotion motion_of_world(const Mechanism& mechanism, ExprGraph& graph);
std::vector<FrameMotion> frame_motions(const Mechanism& mechanism, const WrittenTree& written,
                                       ExprGraph& graph);

/// Q by the reduced form: outward twists and accelerations, inward forces (README.md, 2).
std::vector<Expr> reduced_inverse_dynamics(const Mechanism& mechanism, const WrittenTree& written,
                                           ExprGraph& graph);

/// The part of Q that gravity makes: the same recursion over a tree at rest, without wrenches.
std::vector<Expr> gravity_forces(const Mechanism& mechanism, const WrittenTree& written, ExprGraph& graph);

}  // namespace alembert

// Forward dynamics in O(n) by articulated bodies.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// The same by articulated bodies over a tree of the mechanism's motions, O(n); nothing where a speed moves
/// several bodies and another a body on the way to them (articulated_bodies.cpp). M is not positive: division by
/// zero.
std::optional<std::vector<Expr>> articulated_solve(const Mechanism& mechanism, const MotionTree& tree,
                                                   std::span<const Expr> right_side, ExprGraph& graph);

}  // namespace alembert

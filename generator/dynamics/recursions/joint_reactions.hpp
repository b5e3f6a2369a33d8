// What joints carry. In: a tree of motions, with masses as the description has them. Out: for each body the wrench
// that its parent exerts on it.
#pragma once

#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Of each body: moment about the origin of its frame and force, in its axes, 6 entries. Forces along speeds act in
/// joints and are part of these wrenches; armatures are no bodies and are not.
std::vector<Expr> joint_reactions(const Mechanism& mechanism, const MotionTree& tree,
                                  const SpeedDerivatives& derivatives, ExprGraph& graph);

}  // namespace alembert

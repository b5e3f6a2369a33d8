// Derivatives of the forces by recursions along the tree of motions (README.md, 7).
#pragma once

#include <vector>

#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// D_l Q_k, then dQ_k/du_l (nv x nv each, row major), by recursions over a tree of the mechanism's motions.
std::vector<Expr> recursive_force_derivatives(const Mechanism& mechanism, const MotionTree& tree,
                                              const SpeedDerivatives& derivatives, ExprGraph& graph,
                                              FarPairs far);

}  // namespace alembert

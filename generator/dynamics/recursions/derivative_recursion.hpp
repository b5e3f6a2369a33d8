// Derivatives of the forces by recursions along the tree of motions (README.md, 7).
#pragma once

#include <vector>

#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// D_l Q_k, then dQ_k/du_l (nv x nv each, row major), by recursions over a tree of the mechanism's motions. Vectors
/// are not scaled.
std::vector<Expr> recursive_force_derivatives(const Mechanism& mechanism, const WrittenTree& written,
                                              const SpeedDerivatives& derivatives, ExprGraph& graph,
                                              FarPairs far);

}  // namespace alembert

// The Coriolis matrix by a recursion along the tree of motions (README.md, 9).
#pragma once

#include <vector>

#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// C_ij = sum over particles m D_i r . d(D_j r)/dt, nv x nv, row major, over a tree of the mechanism's motions.
/// Vectors are not scaled.
std::vector<Expr> recursive_coriolis_matrix(const Mechanism& mechanism, const WrittenTree& written,
                                            const SpeedDerivatives& derivatives, ExprGraph& graph,
                                            FarPairs far);

}  // namespace alembert

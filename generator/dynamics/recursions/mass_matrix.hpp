// M and c: by composite bodies over the tree of motions, and by `coefficient` and `substitute`; and the solve
// for the speeds' rates.
#pragma once

#include <span>
#include <vector>

#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// M (nv x nv, row major, symmetric) by composite bodies over the tree, contracted where speeds are shared.
std::vector<Expr> composite_mass_matrix(const Mechanism& mechanism, const WrittenTree& written,
                                        ExprGraph& graph, FarPairs far = FarPairs::carry);

/// M by `coefficient` (lower triangle of Q, mirrored).
std::vector<Expr> coefficient_mass_matrix(const Mechanism& mechanism, std::span<const Expr> Q);

/// c by `substitute`: Q with the rates of the speeds zero.
std::vector<Expr> bias_by_substitution(const Mechanism& mechanism, std::span<const Expr> Q, ExprGraph& graph);

/// ud = M^-1 (tau - c) by L^T D L from the last speed to the first, which keeps the zeros of a tree; straight
/// line.
std::vector<Expr> straight_line_solve(std::vector<Expr> M, std::vector<Expr> right_side);

}  // namespace alembert

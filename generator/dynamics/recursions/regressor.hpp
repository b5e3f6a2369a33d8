// Regressors: what forces and energies are of the standard parameters of the bodies, in which they are linear. Ten of a
// body: m, m c x y z, and its inertia about the origin of its frame xx yy zz xy xz yz, in its axes. Bodies without mass
// have none, a point mass in its origin has the first four.
#pragma once

#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

inline constexpr std::size_t kStandardParameters = 10;
/// Which of a body's parameters count, the first so many: 0, 4 or all.
std::size_t parameters_of(const Body& body);

/// nv x 10 nb, row major: the forces that give the bodies the speeds' rates, under gravity.
std::vector<Expr> force_regressor(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);
/// The same at rest.
std::vector<Expr> gravity_regressor(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);
/// 2 x 10 nb: kinetic and potential energy.
std::vector<Expr> energy_regressor(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);

}  // namespace alembert

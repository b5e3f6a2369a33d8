// Constraints on the speeds. In: the constraints of a mechanism, its tree of motions and derivatives along
// the speeds. Out: their rows, linear in the speeds, and what they need to be solved with the equations of
// motion (README.md, 6).
#pragma once

#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// Rows in file order; n_c of them. velocity = P u + (part from time) = 0, its rate is P du/dt + gamma.
struct ConstraintEquations {
  std::vector<Expr> P;         ///< n_c x nv, row major
  std::vector<Expr> gamma;     ///< n_c
  std::vector<Expr> velocity;  ///< n_c
  std::vector<Expr> position;  ///< n_c: phi(q, t) of holonomic rows, 0 of the others
};

/// Throws InputError at a constraint that is not linear in the speeds, or has no value at the initial state.
ConstraintEquations constraint_equations(const Mechanism& mechanism, const MotionTree& tree,
                                         const SpeedDerivatives& derivatives, ExprGraph& graph);

}  // namespace alembert

// Lengths of the rows of constraints. In: their equations and M. Out: for each row a power of two, by which those that
// choose independent rows know what is rounding of a row whose units differ from the others'; and weights and inertias for
// rows that are added to M.
#pragma once

#include <span>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/recursions/constraints.hpp"

namespace alembert {

/// About how long the terms are that each row of P is made of, in the metric of M^-1, over those of the longest row:
/// sqrt(sum_k B_k^2 (M^-1)_kk), B_k the running error of P_k in epsilons. That a row's terms cancel does not make it
/// shorter. A scale, no bound: the largest at the initial state and three random ones, as a power of two; 1 for rows that
/// are longer than 1/6000 of the longest, and where M is singular.
std::vector<double> row_lengths(const Kinematics& kinematics, const ConstraintEquations& rows,
                                const std::vector<Expr>& M);

/// A weight W_r for each row, with which the diagonal of P^T W P is about that of M where the row has entries: the fit of
/// W_r P_rk^2 to M_kk by least squares, the median at the same states, as a power of two. 1 for a row of zeros.
std::vector<double> row_weights(const Kinematics& kinematics, const ConstraintEquations& rows,
                                const std::vector<Expr>& M);

/// About M_kk, for each speed, the median at the same states, as a power of two: at least 2^-40 of the diagonal of
/// P^T W P, for speeds of no inertia; 1 where that is 0 too.
std::vector<double> typical_inertias(const Kinematics& kinematics, const ConstraintEquations& rows,
                                     const std::vector<Expr>& M, std::span<const double> weights);

}  // namespace alembert

// Forward dynamics, the inverse of M and the derivatives of both: equations of motion in, the shortest of what
// several methods give out.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// tau - c, nv.
std::vector<Expr> driving_forces(const Kinematics& kinematics, const EquationsOfMotion& equations);

/// M^-1 (tau - c), nv.
std::vector<Expr> forward_dynamics(const Kinematics& kinematics, const EquationsOfMotion& equations);

/// M^-1 of several right sides at once: what belongs to M is shared. By articulated bodies, which is O(n) for each of
/// them, or by factors of M, which keep the zeros of a tree.
std::vector<std::vector<Expr>> solved_for_columns(const Kinematics& kinematics,
                                                  const EquationsOfMotion& equations,
                                                  const std::vector<std::vector<Expr>>& columns);

/// By rows: `count` columns from `first` on.
std::vector<Expr> by_rows(const std::vector<std::vector<Expr>>& columns, std::size_t first,
                          std::size_t count);

/// M^-1, nv x nv, symmetric.
std::vector<Expr> inverse_mass_matrix(const Kinematics& kinematics, const EquationsOfMotion& equations);

/// Derivatives of the speeds' rates, nv x nv each, row major: along the speeds, that is by the coordinates, by the
/// speeds, and by the forces.
struct ForwardDerivatives {
  std::vector<Expr> along_speeds, by_speeds, by_forces;
};
ForwardDerivatives forward_dynamics_derivatives(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations);

}  // namespace alembert

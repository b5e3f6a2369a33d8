// What stages `kinematics` and `equations` give.
//
// Letters: q coordinates, u speeds (qd), ud their rates (qdd), qdot = N(q) u; M(q) ud + c(q, u, t) = Q.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/choice/program_lengths.hpp"
#include "dynamics/recursions/applied_forces.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// factored: eq. (13) of the paper, literally. reduced: the same equations by twists and wrenches (README.md,
/// 2).
enum class Formulation { factored, reduced };

/// Stage `kinematics`: the tree of elementary motions of a mechanism, with twists and their rates, and the
/// same with screws peeled off where there are some. Holds references: mechanism and graph must outlive it.
struct Kinematics {
  const Mechanism& mechanism;
  ExprGraph& graph;
  SpeedDerivatives derivatives;
  MotionTree tree;
  std::optional<MotionTree> peeled;  ///< the same motion by other factors (screw_peeling.hpp)
  AppliedForces applied;             ///< of the mechanism's forces
  mutable ProgramLengths lengths;    ///< of candidates for equations
};

/// Passes that look for fewer operations; what one finds is used only where it gains some.
struct Passes {
  bool peeling = true;       ///< screws peeled off transforms (screw_peeling.hpp)
  bool placement = true;     ///< frames placed along the axes (rigid_links.hpp)
  bool regrouping = true;    ///< parts of inertias handed from link to link (regrouping.cpp); needs placement
  bool scaling = true;       ///< components scaled by constant turns (scaled_vectors.hpp)
  bool articulation = true;  ///< forward dynamics by articulated bodies (articulated_bodies.cpp)
  bool augmentation = false;  ///< rows of constraints added to M (constrained_dynamics.cpp)
  double effort = 1;          ///< work spent on trying further choices of these, one after another; 0: none
};

/// None of them: the equations as they are.
constexpr Passes plain_passes() {
  return {false, false, false, false, true, false, 0};
}

/// Equations of motion by one formulation.
struct EquationsOfMotion {
  Formulation formulation;
  std::vector<Expr> Q;  ///< nv: generalized forces for given q, u, ud
  std::vector<Expr> M;  ///< nv x nv, row major, symmetric
  std::vector<Expr> c;  ///< nv
  /// Motions and masses that M is of, if forward dynamics may be by articulated bodies.
  std::optional<MotionTree> articulated = {};
  /// Motions and masses that Q is of, in the reduced form.
  std::optional<WrittenTree> tree = {};
  bool augmented = false;  ///< Passes::augmentation
};

}  // namespace alembert

// Equations of motion and the functions made of them (see the header).
#include "dynamics/equations.hpp"

#include <algorithm>

#include "dynamics/choice/reduced_equations.hpp"
#include "dynamics/recursions/factored.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/rewrites/screw_peeling.hpp"
#include "dynamics/tree/frame_checks.hpp"
#include "dynamics/tree/frame_normals.hpp"
#include "dynamics/tree/symbols.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/to_string.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

std::string_view to_string(Formulation formulation) {
  switch (formulation) {
    case Formulation::factored:
      return "factored";
    case Formulation::reduced:
      return "reduced";
  }
  return "";
}

namespace {

/// Limits of the coordinates of curves and surfaces say on which side of a pole they are: roots in the frames
/// there have a sign by them. Other limits say nothing about what is beyond.
void assume_limits_of_frames(const Mechanism& mechanism, ExprGraph& graph) {
  for (const FrameNormal& normal : frame_normals(mechanism)) {
    for (const Coordinate& coordinate : mechanism.coordinates) {
      if (!coordinate.limits ||
          std::ranges::find(normal.coordinates, coordinate.name) == normal.coordinates.end())
        continue;
      graph.assume(coordinate.symbols[0], {coordinate.limits->first, coordinate.limits->second});
    }
  }
}

}  // namespace

Kinematics symbolic_kinematics(const Mechanism& mechanism, ExprGraph& graph) {
  assume_limits_of_frames(mechanism, graph);
  check_transforms(mechanism, graph);
  SpeedDerivatives derivatives(mechanism, graph);
  std::vector<std::vector<Motion>> motions;
  for (const Body& body : mechanism.bodies)
    motions.push_back(elementary_motions(body.transform, mechanism, graph));
  MotionTree tree = motion_tree(mechanism, motions, derivatives, graph);
  std::optional<MotionTree> peeled;
  bool any = false;
  for (std::vector<Motion>& given : motions) {
    auto other = peeled_motions(given, mechanism, derivatives, graph);
    if (!other) continue;
    given = std::move(*other);
    any = true;
  }
  if (any) peeled = motion_tree(mechanism, motions, derivatives, graph);
  AppliedForces applied = applied_forces(mechanism, tree, derivatives, graph);
  // Points have a value for each symbol, so all arguments have theirs from here on.
  symbol_bindings(mechanism, graph);
  return {mechanism,          graph, std::move(derivatives), std::move(tree), std::move(peeled),
          std::move(applied), {}};
}

Kinematics plain_kinematics(const Mechanism& mechanism, ExprGraph& graph) {
  SpeedDerivatives derivatives(mechanism, graph);
  MotionTree tree = motion_tree(mechanism, derivatives, graph);
  AppliedForces applied = applied_forces(mechanism, tree, derivatives, graph);
  symbol_bindings(mechanism, graph);  // as above
  return {mechanism, graph, std::move(derivatives), std::move(tree), std::nullopt, std::move(applied), {}};
}

namespace {

/// The equations of what is inert, heavy or pushed by external wrenches.
EquationsOfMotion equations_without_forces(const Kinematics& kinematics, Formulation formulation,
                                           Passes passes) {
  switch (formulation) {
    case Formulation::factored: {
      const Mechanism& mechanism = kinematics.mechanism;
      EquationsOfMotion equations;
      equations.formulation = formulation;
      equations.Q =
          value_number(factored_inverse_dynamics(mechanism, kinematics.derivatives, kinematics.graph));
      equations.M = coefficient_mass_matrix(mechanism, equations.Q);
      equations.c = value_number(bias_by_substitution(mechanism, equations.Q, kinematics.graph));
      return equations;
    }
    case Formulation::reduced:
      return reduced_equations(kinematics, passes);
  }
  throw InternalError("there is no such formulation");
}

}  // namespace

EquationsOfMotion equations_of_motion(const Kinematics& kinematics, Formulation formulation, Passes passes) {
  EquationsOfMotion equations = equations_without_forces(kinematics, formulation, passes);
  equations.augmented = passes.augmentation;
  if (kinematics.applied.Q.empty()) return equations;
  equations.Q = value_number(less_applied(std::move(equations.Q), kinematics.applied));
  equations.c = value_number(less_applied(std::move(equations.c), kinematics.applied));
  return equations;
}

}  // namespace alembert

// Equations of motion and the functions made of them (see the header).
#include "dynamics/equations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/checks/state_checks.hpp"
#include "dynamics/choice/reduced_equations.hpp"
#include "dynamics/recursions/formulations.hpp"
#include "dynamics/rewrites/screw_peeling.hpp"
#include "dynamics/tree/frame_normals.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

Expr tau_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph) {
  for (const Coordinate& coordinate : mechanism.coordinates) {
    const int k = speed - coordinate.first_speed;
    if (k < 0 || k >= coordinate.nv()) continue;
    std::string name = "tau(" + coordinate.name + ")";
    if (coordinate.type == CoordinateType::quaternion)
      name += std::array{".x", ".y", ".z"}[static_cast<std::size_t>(k)];
    return graph.symbol(name);
  }
  throw InternalError("there is no speed of that index");
}

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
  return {mechanism,
          graph,
          std::move(derivatives),
          std::move(tree),
          std::move(peeled),
          ProgramLengths(mechanism, graph)};
}

EquationsOfMotion equations_of_motion(const Kinematics& kinematics, Formulation formulation, Passes passes) {
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

std::vector<WrenchSymbols> wrench_symbols(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<WrenchSymbols> result;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    if (!mechanism.bodies[b].external_wrench) continue;
    const std::string prefix = "wrench(" + mechanism.bodies[b].name + ").";
    WrenchSymbols symbols{static_cast<int>(b), {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const char axis = "xyz"[i];
      symbols.force[i] = graph.symbol(prefix + "f" + axis);
      symbols.torque[i] = graph.symbol(prefix + "t" + axis);
    }
    result.push_back(symbols);
  }
  return result;
}

std::vector<SymbolBinding> symbol_bindings(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<SymbolBinding> bindings;
  const auto bind = [&](Expr symbol, ArgumentKind kind, std::size_t index, double unit = 1) {
    bindings.push_back({symbol,
                        {kind, static_cast<std::uint32_t>(index),
                         graph.symbol_name(graph.symbol_index(symbol.ref().node()))},
                        unit});
  };
  std::size_t q = 0, speed = 0;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    for (const Expr symbol : coordinate.symbols) bind(symbol, ArgumentKind::q, q++);
    for (std::size_t k = 0; k < coordinate.speed_symbols.size(); ++k, ++speed) {
      bind(coordinate.speed_symbols[k], ArgumentKind::qd, speed);
      bind(coordinate.rate_symbols[k], ArgumentKind::qdd, speed);
      bind(tau_symbol(mechanism, static_cast<int>(speed), graph), ArgumentKind::tau, speed);
    }
  }
  bind(mechanism.time, ArgumentKind::time, 0);
  std::size_t parameter = 0;
  for (const Parameter& p : mechanism.parameters) {
    if (p.runtime)
      bind(graph.symbol(p.name), ArgumentKind::parameter, parameter++, p.value == 0 ? 1 : std::abs(p.value));
  }
  std::size_t wrench = 0;
  for (const WrenchSymbols& symbols : wrench_symbols(mechanism, graph)) {
    for (std::size_t i = 0; i < 3; ++i) bind(symbols.force[i], ArgumentKind::wrench, wrench + i);
    for (std::size_t i = 0; i < 3; ++i) bind(symbols.torque[i], ArgumentKind::wrench, wrench + 3 + i);
    wrench += 6;
  }
  return bindings;
}

}  // namespace alembert

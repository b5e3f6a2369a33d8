// Equations of motion and the functions made of them (see the header).
#include "dynamics/equations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/checks/state_checks.hpp"
#include "dynamics/choice/force_derivatives.hpp"
#include "dynamics/choice/reduced_equations.hpp"
#include "dynamics/recursions/constraints.hpp"
#include "dynamics/recursions/formulations.hpp"
#include "dynamics/rewrites/screw_peeling.hpp"
#include "dynamics/tree/frame_normals.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

std::vector<OutputExpressions> constraint_outputs(const Kinematics& kinematics) {
  const ConstraintEquations equations =
      constraint_equations(kinematics.mechanism, kinematics.tree, kinematics.derivatives, kinematics.graph);
  const std::uint32_t rows = static_cast<std::uint32_t>(equations.position.size());
  std::vector<OutputExpressions> outputs{
      {"P", rows, static_cast<std::uint32_t>(kinematics.mechanism.nv), equations.P},
      {"gamma", rows, 1, equations.gamma},
      {"velocity", rows, 1, equations.velocity},
      {"position", rows, 1, equations.position}};
  // All at once, so that what they share is found.
  std::vector<Expr> flat;
  for (const OutputExpressions& output : outputs)
    flat.insert(flat.end(), output.values.begin(), output.values.end());
  flat = value_number(flat);
  auto next = flat.begin();
  for (OutputExpressions& output : outputs) {
    for (Expr& value : output.values) value = *next++;
  }
  return outputs;
}

}  // namespace

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

std::string_view to_string(FunctionKind kind) {
  switch (kind) {
    case FunctionKind::inverse_dynamics:
      return "inverse_dynamics";
    case FunctionKind::mass_matrix:
      return "mass_matrix";
    case FunctionKind::bias:
      return "bias";
    case FunctionKind::mass_matrix_and_bias:
      return "mass_matrix_and_bias";
    case FunctionKind::forward_dynamics:
      return "forward_dynamics";
    case FunctionKind::coordinate_rates:
      return "coordinate_rates";
    case FunctionKind::energy:
      return "energy";
    case FunctionKind::body_poses:
      return "body_poses";
    case FunctionKind::frame_poses:
      return "frame_poses";
    case FunctionKind::frame_jacobians:
      return "frame_jacobians";
    case FunctionKind::constraints:
      return "constraints";
    case FunctionKind::body_jacobians:
      return "body_jacobians";
    case FunctionKind::body_inertias:
      return "body_inertias";
    case FunctionKind::inverse_dynamics_derivatives:
      return "inverse_dynamics_derivatives";
  }
  return "";
}

std::span<const FunctionKind> all_function_kinds() {
  static constexpr std::array kKinds{FunctionKind::inverse_dynamics,
                                     FunctionKind::mass_matrix,
                                     FunctionKind::bias,
                                     FunctionKind::mass_matrix_and_bias,
                                     FunctionKind::forward_dynamics,
                                     FunctionKind::coordinate_rates,
                                     FunctionKind::energy,
                                     FunctionKind::body_poses,
                                     FunctionKind::frame_poses,
                                     FunctionKind::frame_jacobians,
                                     FunctionKind::constraints,
                                     FunctionKind::body_jacobians,
                                     FunctionKind::body_inertias,
                                     FunctionKind::inverse_dynamics_derivatives};
  return kKinds;
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

namespace {

/// What `make` gives for a tree of motions: for the one of the two that takes fewer operations.
template <class Make>
std::vector<Expr> for_either_tree(const Kinematics& kinematics, Make make) {
  std::vector<Expr> values = value_number(make(kinematics.mechanism, kinematics.tree, kinematics.graph));
  if (!kinematics.peeled) return values;
  std::vector<Expr> others = value_number(make(kinematics.mechanism, *kinematics.peeled, kinematics.graph));
  return count_operations(others).total() < count_operations(values).total() ? others : values;
}

/// M^-1 of the right side, by the way that takes fewer operations.
std::vector<Expr> solved_for_rates(const Kinematics& kinematics, const EquationsOfMotion& equations,
                                   std::vector<Expr> right_side) {
  std::optional<std::vector<Expr>> articulated;
  if (equations.articulated) {
    const auto solve = [&](const MotionTree& tree) {
      return articulated_solve(kinematics.mechanism, tree, right_side, kinematics.graph);
    };
    articulated = solve(*equations.articulated);
    // Regrouping may have left mass between two motions of one speed.
    if (!articulated) articulated = solve(kinematics.tree);
  }
  if (!articulated) return straight_line_solve(equations.M, std::move(right_side));
  *articulated = value_number(*articulated);
  const std::size_t length = count_operations(*articulated).total();
  // M and c alone are a part of the other way, which is O(n^3): it is not made in vain.
  std::vector<Expr> part = equations.M;
  part.insert(part.end(), right_side.begin(), right_side.end());
  if (5 * count_operations(part).total() > 6 * length) return *articulated;
  const std::vector<Expr> other = straight_line_solve(equations.M, std::move(right_side));
  // Where it is close, the optimised programs decide.
  const std::size_t other_length = count_operations(value_number(other)).total();
  const bool close = 5 * std::max(length, other_length) < 6 * std::min(length, other_length);
  const auto weigh = [&](std::size_t operations, const std::vector<Expr>& values) {
    return close ? kinematics.lengths.of(values).first : operations;
  };
  return weigh(other_length, other) > weigh(length, *articulated) ? *articulated : other;
}

}  // namespace

std::vector<OutputExpressions> function_outputs(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations, FunctionKind kind) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const std::uint32_t nv = static_cast<std::uint32_t>(mechanism.nv);
  const std::uint32_t bodies = static_cast<std::uint32_t>(mechanism.bodies.size());
  const std::uint32_t frames = static_cast<std::uint32_t>(mechanism.frames.size());
  const OutputExpressions mass{"M", nv, nv, equations.M};
  const OutputExpressions bias{"c", nv, 1, equations.c};
  switch (kind) {
    case FunctionKind::inverse_dynamics:
      return {{"tau", nv, 1, equations.Q}};
    case FunctionKind::mass_matrix:
      return {mass};
    case FunctionKind::bias:
      return {bias};
    case FunctionKind::mass_matrix_and_bias:
      return {mass, bias};
    case FunctionKind::forward_dynamics: {
      std::vector<Expr> right_side;
      for (int k = 0; k < mechanism.nv; ++k) {
        right_side.push_back(tau_symbol(mechanism, k, graph) - equations.c[static_cast<std::size_t>(k)]);
      }
      return {{"qdd", nv, 1, solved_for_rates(kinematics, equations, std::move(right_side))}};
    }
    case FunctionKind::coordinate_rates: {
      const std::vector<Expr> N = kinematics.derivatives.coordinate_rate_matrix();
      std::vector<Expr> rates;
      for (int i = 0; i < mechanism.nq; ++i) {
        Expr sum = graph.zero();
        for (int k = 0; k < mechanism.nv; ++k)
          sum += N[static_cast<std::size_t>(i * mechanism.nv + k)] * kinematics.derivatives.speed(k);
        rates.push_back(sum);
      }
      return {{"qdot", static_cast<std::uint32_t>(mechanism.nq), 1, std::move(rates)}};
    }
    case FunctionKind::energy:
      return {{"energy", 2, 1, for_either_tree(kinematics, energies)}};
    case FunctionKind::body_poses:
      return {{"poses", bodies, 12, for_either_tree(kinematics, body_poses)}};
    case FunctionKind::frame_poses:
      return {{"frames", frames, 12, for_either_tree(kinematics, frame_poses)}};
    case FunctionKind::frame_jacobians: {
      const std::vector<Expr> poses = frame_poses(mechanism, kinematics.tree, graph);
      return {{"J", 6 * frames, nv,
               value_number(frame_jacobians(mechanism, kinematics.derivatives, poses, graph))}};
    }
    case FunctionKind::constraints:
      return constraint_outputs(kinematics);
    case FunctionKind::body_jacobians:
      return {{"J", 6 * bodies, nv, for_either_tree(kinematics, body_jacobians)}};
    case FunctionKind::body_inertias:
      return {{"inertias", bodies, 10, body_inertias(mechanism)}};
    case FunctionKind::inverse_dynamics_derivatives: {
      const std::vector<Expr> both = force_derivatives(kinematics, equations);
      const auto middle = both.begin() + static_cast<std::ptrdiff_t>(nv * nv);
      return {{"tau_q", nv, nv, {both.begin(), middle}}, {"tau_qd", nv, nv, {middle, both.end()}}};
    }
  }
  return {};
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

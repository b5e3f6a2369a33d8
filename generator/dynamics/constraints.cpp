// Constraints on the speeds (see the header).
#include "dynamics/constraints.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/contact_frames.hpp"
#include "dynamics/formulations.hpp"
#include "dynamics/state_checks.hpp"
#include "mechanism/constraint_rows.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

/// Rows sum_k a_k(q, t) u_k, time counting as a speed that is 1; and phi of those that have one.
struct SpeedRows {
  std::vector<SpeedPartial> coefficients;  ///< a_k, in ascending order of the speeds
  std::vector<Expr> position;
};

/// phi(q, t) = 0: its rate.
SpeedRows holonomic_rows(std::vector<Expr> equations, const SpeedDerivatives& derivatives) {
  SpeedRows rows;
  rows.coefficients = derivatives.partials(equations);
  rows.position = std::move(equations);
  return rows;
}

[[noreturn]] void not_linear(const Constraint& constraint, const std::string& why) {
  throw InputError(constraint.where,
                   "constraint '" + constraint.name + "' is not linear in the speeds: " + why);
}

/// Rows that are written down as such.
SpeedRows pfaffian_rows(const Constraint& constraint, std::span<const Expr> equations,
                        const Mechanism& mechanism, const SpeedDerivatives& derivatives, ExprGraph& graph) {
  SpeedRows rows;
  std::vector<std::pair<Expr, Expr>> at_rest;
  for (int k = 0; k < mechanism.nv; ++k) at_rest.emplace_back(derivatives.speed(k), graph.zero());
  const auto append = [&](int speed, std::vector<Expr> values) {
    const bool any = std::any_of(values.begin(), values.end(), [](Expr e) { return !e.is_zero(); });
    if (any) rows.coefficients.push_back({speed, std::move(values)});
  };
  for (int k = 0; k < mechanism.nv; ++k) {
    std::vector<Expr> values;
    try {
      values = coefficient(equations, derivatives.speed(k));
    } catch (const NotLinear& error) {
      not_linear(constraint, error.what());
    }
    if (substitute(values, at_rest) != values)
      not_linear(constraint, to_string(derivatives.speed(k)) + " is multiplied by another speed");
    append(k, std::move(values));
  }
  append(derivatives.time_index(), substitute(equations, at_rest));
  rows.position.assign(equations.size(), graph.zero());
  return rows;
}

/// Velocity, in the tangent plane, of the point of the second body at the contact relative to the first:
/// Rz(spin)^T R1^T dt1/dt - R2^T dt2/dt, rows x and y.
SpeedRows rolling_rows(const Mate& mate, const SourceLocation& where, const SpeedDerivatives& derivatives,
                       ExprGraph& graph) {
  const Mat3 R1 = surface_rotation(mate.first, where, graph);
  const Mat3 R2 = surface_rotation(mate.second, where, graph);
  const Expr cosine = cos(mate.spin), sine = sin(mate.spin);
  const auto along = [](const Mat3& R, std::size_t column, const Vec3& v) {
    return dot({{R(0, column), R(1, column), R(2, column)}}, v);
  };
  std::vector<Expr> points(mate.first.point.entries.begin(), mate.first.point.entries.end());
  points.insert(points.end(), mate.second.point.entries.begin(), mate.second.point.entries.end());

  SpeedRows rows;
  std::vector<Expr> flat;
  for (const SpeedPartial& partial : derivatives.partials(points)) {
    const std::vector<Expr>& d = partial.values;
    const Vec3 first{{d[0], d[1], d[2]}}, second{{d[3], d[4], d[5]}};
    const Expr x = along(R1, 0, first), y = along(R1, 1, first);
    const Expr slip_x = cosine * x + sine * y, slip_y = cosine * y - sine * x;
    flat.push_back(slip_x - along(R2, 0, second));
    flat.push_back(slip_y - along(R2, 1, second));
    rows.coefficients.push_back({partial.speed, {}});
  }
  flat = simplify(flat);
  for (std::size_t i = 0; i < rows.coefficients.size(); ++i)
    rows.coefficients[i].values = {flat[2 * i], flat[2 * i + 1]};
  rows.position.assign(2, graph.zero());
  return rows;
}

/// What the symbols of frames' positions stand for.
std::vector<std::pair<Expr, Expr>> frame_positions(const Mechanism& mechanism, const MotionTree& tree,
                                                   ExprGraph& graph) {
  std::vector<std::pair<Expr, Expr>> positions;
  if (mechanism.frame_positions.empty()) return positions;
  const std::vector<Expr> poses = frame_poses(mechanism, tree, graph);
  for (const FramePosition& position : mechanism.frame_positions) {
    const std::size_t first = 12 * static_cast<std::size_t>(position.frame);
    for (std::size_t i = 0; i < 3; ++i) positions.emplace_back(position.symbols[i], poses[first + 4 * i + 3]);
  }
  return positions;
}

void check_values(const Mechanism& mechanism, const ConstraintEquations& equations, ExprGraph& graph) {
  const std::vector<double> state = state_values(mechanism, graph, 0);
  const std::vector<ConstraintRow> rows = constraint_rows(mechanism);
  const auto finite = [](double x) { return std::isfinite(x); };
  const auto check = [&](std::span<const Expr> expressions, std::string_view what) {
    if (rows.empty()) return;
    const std::vector<double> values = evaluate(expressions, state);
    const auto bad = std::find_if_not(values.begin(), values.end(), finite);
    if (bad == values.end()) return;
    const std::size_t columns = values.size() / rows.size();
    const ConstraintRow& row = rows[static_cast<std::size_t>(bad - values.begin()) / columns];
    throw InputError(
        mechanism.constraints[row.constraint].where,
        std::string(what) + " of constraint '" + row.name +
            "' has no value at the initial state (the square root of 0, or a frame that is "
            "singular there); write the constraint another way, or choose another initial value");
  };
  check(equations.position, "the equation");
  check(equations.P, "the derivative");
  check(equations.velocity, "the rate");
  check(equations.gamma, "the second derivative");
}

}  // namespace

ConstraintEquations constraint_equations(const Mechanism& mechanism, const MotionTree& tree,
                                         const SpeedDerivatives& derivatives, ExprGraph& graph) {
  const std::vector<std::pair<Expr, Expr>> positions = frame_positions(mechanism, tree, graph);
  const auto rows_of = [&](const Constraint& constraint) {
    std::vector<Expr> equations = substitute(constraint.equations, positions);
    switch (constraint.type) {
      case ConstraintType::holonomic:
        return holonomic_rows(std::move(equations), derivatives);
      case ConstraintType::pfaffian:
        return pfaffian_rows(constraint, equations, mechanism, derivatives, graph);
      case ConstraintType::rolling: {
        const Body& body = mechanism.bodies[static_cast<std::size_t>(constraint.body)];
        const Factor& factor = body.transform.factors[constraint.factor];
        return rolling_rows(std::get<Mate>(factor.value), factor.where, derivatives, graph);
      }
    }
    return SpeedRows{};
  };

  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  ConstraintEquations all;
  for (const Constraint& constraint : mechanism.constraints) {
    const SpeedRows rows = rows_of(constraint);
    const std::size_t count = rows.position.size(), first = all.position.size();
    all.P.resize((first + count) * nv, graph.zero());
    for (const SpeedPartial& partial : rows.coefficients) {
      if (partial.speed == derivatives.time_index()) continue;
      for (std::size_t i = 0; i < count; ++i)
        all.P[(first + i) * nv + static_cast<std::size_t>(partial.speed)] = partial.values[i];
    }
    const auto append = [](std::vector<Expr>& to, const std::vector<Expr>& values) {
      to.insert(to.end(), values.begin(), values.end());
    };
    append(all.velocity, derivatives.first_rate(rows.coefficients, count));
    append(all.gamma, derivatives.quadratic_rate(rows.coefficients, count));
    append(all.position, rows.position);
  }
  check_values(mechanism, all, graph);
  return all;
}

}  // namespace alembert

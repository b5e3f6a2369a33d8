// Constraints on the speeds (see the header).
#include "dynamics/recursions/constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "dynamics/recursions/frame_values.hpp"
#include "dynamics/tree/contact_frames.hpp"
#include "dynamics/tree/state_values.hpp"
#include "mechanism/constraint_rows.hpp"
#include "mechanism/mate.hpp"
#include "symbolic/coefficient.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/to_string.hpp"

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

/// Rate of a surface's point along one speed, on the tangents p0 and p1 of its frame.
struct TangentRate {
  int speed;
  Expr x, y;
};

/// Where the point depends on its coordinates u and v alone, the metric says it all and no frame is needed:
/// p0 . f_u = |f_u|, p1 . f_u = 0, p0 . f_v = f_u . f_v / |f_u|, p1 . f_v = n . (f_u x f_v) / |f_u|.
std::vector<TangentRate> tangent_rates(const SurfaceFrame& surface, const SourceLocation& where,
                                       const Mechanism& mechanism, const SpeedDerivatives& derivatives,
                                       ExprGraph& graph) {
  const auto speed_of = [&](Expr symbol) {
    const auto found = std::find_if(mechanism.coordinates.begin(), mechanism.coordinates.end(),
                                    [&](const Coordinate& c) { return c.symbols[0] == symbol; });
    return found == mechanism.coordinates.end() ? -1 : found->first_speed;
  };
  const int u = speed_of(surface.u), v = speed_of(surface.v);
  const std::vector<SpeedPartial> partials = derivatives.partials(surface.point.entries);
  const auto vector = [](const SpeedPartial& p) -> Vec3 { return {{p.values[0], p.values[1], p.values[2]}}; };
  const bool own = partials.size() == 2 && std::all_of(partials.begin(), partials.end(), [&](const auto& p) {
                     return p.speed == u || p.speed == v;
                   });
  std::vector<TangentRate> rates;
  if (own) {
    const bool in_order = partials[0].speed == u;
    const Vec3 fu = vector(partials[in_order ? 0 : 1]), fv = vector(partials[in_order ? 1 : 0]);
    const Vec3 across = cross(fu, fv);
    std::vector<Expr> metric{dot(fu, fu), dot(across, across), dot(fu, fv)};
    metric = simplify(metric);
    std::vector<Expr> lengths{sqrt(metric[0]), sqrt(metric[1])};
    lengths = simplify(lengths);
    const Expr height = lengths[1] / lengths[0];
    rates = {{u, lengths[0], graph.zero()}, {v, metric[2] / lengths[0], surface.flip ? -height : height}};
    return rates;
  }
  const Mat3 R = surface_rotation(surface, where, graph);
  const auto along = [&](std::size_t column, const Vec3& rate) {
    return dot({{R(0, column), R(1, column), R(2, column)}}, rate);
  };
  for (const SpeedPartial& partial : partials) {
    const Vec3 rate = vector(partial);
    const Expr x = along(0, rate), y = along(1, rate);
    rates.push_back({partial.speed, x, y});
  }
  return rates;
}

/// Velocity, in the tangent plane, of the point of the second body at the contact relative to the first:
/// Rz(spin)^T R1^T dt1/dt - R2^T dt2/dt, rows x and y.
SpeedRows rolling_rows(const Mate& mate, const SourceLocation& where, const Mechanism& mechanism,
                       const SpeedDerivatives& derivatives, ExprGraph& graph) {
  const Expr cosine = cos(mate.spin), sine = sin(mate.spin);
  std::map<int, std::array<Expr, 2>> slip;
  const auto add = [&](int speed, Expr x, Expr y) {
    std::array<Expr, 2>& sum = slip.try_emplace(speed, std::array{graph.zero(), graph.zero()}).first->second;
    sum[0] += x;
    sum[1] += y;
  };
  for (const TangentRate& rate : tangent_rates(mate.first, where, mechanism, derivatives, graph)) {
    const Expr x = cosine * rate.x + sine * rate.y, y = cosine * rate.y - sine * rate.x;
    add(rate.speed, x, y);
  }
  for (const TangentRate& rate : tangent_rates(mate.second, where, mechanism, derivatives, graph))
    add(rate.speed, -rate.x, -rate.y);

  std::vector<Expr> flat;
  for (const auto& [speed, sum] : slip) flat.insert(flat.end(), sum.begin(), sum.end());
  flat = simplify(flat);
  SpeedRows rows;
  for (const auto& [speed, sum] : slip) {
    const std::size_t first = 2 * rows.coefficients.size();
    rows.coefficients.push_back({speed, {flat[first], flat[first + 1]}});
  }
  rows.position.assign(2, graph.zero());
  return rows;
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
  const std::vector<std::pair<Expr, Expr>> positions = frame_values(mechanism, tree, derivatives, graph);
  const auto rows_of = [&](const Constraint& constraint) {
    std::vector<Expr> equations = substitute(constraint.equations, positions);
    switch (constraint.type) {
      case ConstraintType::holonomic:
        return holonomic_rows(std::move(equations), derivatives);
      case ConstraintType::pfaffian:
        return pfaffian_rows(constraint, equations, mechanism, derivatives, graph);
      case ConstraintType::rolling: {
        const Body& body = mechanism.bodies[static_cast<std::size_t>(constraint.body)];
        return rolling_rows(*mate_at(body.transform, constraint.factor),
                            body.transform.factors[constraint.factor].where, mechanism, derivatives, graph);
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

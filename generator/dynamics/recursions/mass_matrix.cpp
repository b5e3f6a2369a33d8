// M and c: by composite bodies over the tree of motions, and by the paper's route, `coefficient` and
// `substitute`.
#include "dynamics/recursions/mass_matrix.hpp"

#include <algorithm>

#include "dynamics/recursions/armature.hpp"
#include "dynamics/recursions/composite.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/rewrites/scaled_vectors.hpp"
#include "symbolic/coefficient.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {

namespace {

std::vector<UnitMotion> unit_motions(const MotionNode& node, int nv, ExprGraph& g) {
  std::vector<UnitMotion> result;
  const bool about_axis = node.motion.kind == MotionKind::axis_rotation;
  for (const TwistPartial& partial : node.partials) {
    if (partial.speed == nv) continue;
    if (about_axis) {
      const std::size_t axis = static_cast<std::size_t>(node.motion.axis);
      if (result.empty()) {
        UnitMotion unit{zeros<3, 1>(g), {}};
        unit.direction[axis] = g.one();
        result.push_back(std::move(unit));
      }
      result[0].weights.emplace_back(partial.speed, partial.direction[axis]);
    } else {
      result.push_back({partial.direction, {{partial.speed, g.one()}}});
    }
  }
  return result;
}

}  // namespace

std::vector<Expr> composite_mass_matrix(const Mechanism& mechanism, const WrittenTree& written,
                                        ExprGraph& graph, FarPairs far) {
  const auto& [tree, moments, scaling] = written;
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  const std::size_t count = tree.nodes.size();
  std::vector<Composite> composites(count, {graph.zero(), zeros<3, 1>(graph), zeros<3, 3>(graph)});
  UnitMotions units;
  for (const MotionNode& node : tree.nodes) units.push_back(unit_motions(node, mechanism.nv, graph));
  const MeetingFrames meetings(tree, units, plan_meetings(tree, units, far, scaling), graph);
  for (std::size_t i = 0; i < count; ++i) {
    composites[i] = composite(tree.masses[i], graph);
  }

  std::vector<Expr> M(nv * nv, graph.zero());
  const auto add = [&](const UnitMotion& x, const UnitMotion& y, bool same, Expr value) {
    for (const auto& [k, wk] : x.weights) {
      for (const auto& [l, wl] : y.weights) {
        if (same && l > k) continue;  // one half of a symmetric pair
        const std::size_t row = static_cast<std::size_t>(std::max(k, l)),
                          column = static_cast<std::size_t>(std::min(k, l));
        const Expr weight = wk * wl;
        const Expr part = weight * value;
        M[row * nv + column] += !same && k == l ? part + part : part;
      }
    }
  };

  for (std::size_t i = count; i-- > 0;) {
    const MotionNode& node = tree.nodes[i];
    const bool linear = node.motion.kind == MotionKind::translation;
    const Composite& body = composites[i];
    for (std::size_t a = 0; a < units[i].size(); ++a) {
      const Vec3& d = units[i][a].direction;
      Wrench momentum = linear ? Wrench{cross(body.h, d), body.mass * d}
                               : Wrench{times_inertia(body.K, d), cross(d, body.h)};
      Scale scale = kUnscaled;  // the momentum is stored as scale times what it is
      for (std::size_t b = 0; b <= a; ++b) {
        add(units[i][a], units[i][b], a == b, power_along(node.motion, units[i][b].direction, momentum));
      }
      // The first step is the one that the composite's own first moment makes: unscaled, it is shared.
      bool begun = false;
      for (std::size_t j = i; tree.nodes[j].parent >= 0;) {
        const MotionNode& at = tree.nodes[j];
        if (meetings.is_posed(j)) {
          const Scale back = inverse(scale);
          const Wrench met =
              meetings.at_meeting(j, {scaled_by(back, momentum.moment), scaled_by(back, momentum.force)});
          for (int k = at.parent; k >= 0; k = tree.nodes[static_cast<std::size_t>(k)].parent) {
            const std::size_t to = static_cast<std::size_t>(k);
            for (std::size_t b = 0; b < units[to].size(); ++b)
              add(units[i][a], units[to][b], false, meetings.along(j, to, b, met));
          }
          break;
        }
        begun = begun || (j != i && !at.partials.empty());
        const bool scaled = scaling.is_scaled(j);
        j = static_cast<std::size_t>(at.parent);
        const Scale next = carried_inward(at, scaled, scale, scaling.of_vectors(j), begun);
        momentum = ScaledTurn(at.motion, scaled && begun, next, scale).inward(momentum);
        scale = next;
        for (const UnitMotion& unit : units[j]) {
          const Vec3 direction = scaled_by(inverse(scale), unit.direction);
          add(units[i][a], unit, false, power_along(tree.nodes[j].motion, direction, momentum));
        }
      }
    }
    if (node.parent < 0) continue;
    const Composite moved = linear ? shifted(body, node.motion.offset, graph) : turned(body, node.motion);
    Composite& up = composites[static_cast<std::size_t>(node.parent)];
    up = plus(up, moved);
  }
  const std::vector<Expr> armature = armatures(mechanism);
  for (std::size_t i = 0; i < nv; ++i) {
    M[i * nv + i] += armature[i];
    for (std::size_t j = 0; j < i; ++j) M[j * nv + i] = M[i * nv + j];
  }
  return M;
}

std::vector<Expr> coefficient_mass_matrix(const Mechanism& mechanism, std::span<const Expr> Q) {
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  std::vector<Expr> M(nv * nv);
  for (const Coordinate& coordinate : mechanism.coordinates) {
    for (std::size_t a = 0; a < coordinate.rate_symbols.size(); ++a) {
      const std::size_t j = static_cast<std::size_t>(coordinate.first_speed) + a;
      const std::vector<Expr> column = coefficient(Q.subspan(j), coordinate.rate_symbols[a]);
      for (std::size_t i = j; i < nv; ++i) M[i * nv + j] = M[j * nv + i] = column[i - j];
    }
  }
  return M;
}

std::vector<Expr> bias_by_substitution(const Mechanism& mechanism, std::span<const Expr> Q,
                                       ExprGraph& graph) {
  std::vector<std::pair<Expr, Expr>> replacements;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    for (const Expr rate : coordinate.rate_symbols) replacements.emplace_back(rate, graph.zero());
  }
  return substitute(Q, replacements);
}

std::vector<Expr> straight_line_solve(std::vector<Expr> M, std::vector<Expr> x) {
  const std::size_t n = x.size();
  if (n == 0) return x;
  const Expr one = x[0].graph().one();
  std::vector<Expr> inverse_pivot(n);
  // M = L^T D L from the last row up; row k of L overwrites row k of M below the diagonal.
  for (std::size_t k = n; k-- > 0;) {
    inverse_pivot[k] = one / M[k * n + k];
    std::vector<Expr> row(k);
    for (std::size_t i = 0; i < k; ++i) row[i] = M[k * n + i] * inverse_pivot[k];
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j <= i; ++j) M[i * n + j] -= M[k * n + i] * row[j];
    }
    for (std::size_t i = 0; i < k; ++i) M[k * n + i] = row[i];
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = 0; i < k; ++i) x[i] -= M[k * n + i] * x[k];
  }
  for (std::size_t k = 0; k < n; ++k) x[k] = x[k] * inverse_pivot[k];
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < k; ++i) x[k] -= M[k * n + i] * x[i];
  }
  return x;
}

}  // namespace alembert

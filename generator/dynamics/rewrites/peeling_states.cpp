// Proofs and states for screw peeling (see the header).
#include "dynamics/rewrites/peeling_states.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/tree/constant_motions.hpp"
#include "dynamics/tree/state_values.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/extended.hpp"
#include "symbolic/identity.hpp"
#include "symbolic/modular.hpp"

namespace alembert {

namespace {

constexpr double kSameProduct = 1e-15;  ///< products of motions at a state, relative
constexpr unsigned kPeelingStates = 8;
constexpr unsigned kPeelingPoints = kIdentityPoints;

/// p^2/|p|^2 of the element p of four symbols, which is of unit length.
void make_unit(std::vector<Modular>& point, const std::array<std::uint32_t, 4>& symbols) {
  using namespace modular;
  const Modular x = point[symbols[0]], y = point[symbols[1]], z = point[symbols[2]], w = point[symbols[3]];
  const Modular v = add(add(multiply(x, x), multiply(y, y)), multiply(z, z)), ww = multiply(w, w);
  const Modular scale = inverse(add(v, ww)), twice = multiply(add(w, w), scale);
  point[symbols[0]] = multiply(twice, x);
  point[symbols[1]] = multiply(twice, y);
  point[symbols[2]] = multiply(twice, z);
  point[symbols[3]] = multiply(add(ww, negate(v)), scale);
}

}  // namespace

PeelingStates::PeelingStates(const Mechanism& mechanism, const std::vector<Motion>& motions, ExprGraph& graph)
    : graph_(graph) {
  const auto index = [&](Expr symbol) { return graph.symbol_index(symbol.ref().node()); };
  for (unsigned k = 0; k < kPeelingStates; ++k) {
    std::vector<double> state = state_values(mechanism, graph, 101 + k);
    state[index(mechanism.time)] = 0.3 + 0.21 * k;
    states_.push_back(std::move(state));
  }
  for (unsigned k = 0; k < kPeelingPoints; ++k) {
    std::vector<Modular> point = random_modular_point(graph.symbol_count(), 0x7065656c + k);
    for (const Coordinate& coordinate : mechanism.coordinates) {
      if (coordinate.type != CoordinateType::quaternion) continue;
      std::array<std::uint32_t, 4> symbols{};
      for (std::size_t a = 0; a < 4; ++a) symbols[a] = index(coordinate.symbols[a]);
      make_unit(point, symbols);
    }
    for (const Parameter& parameter : mechanism.parameters) {
      if (!parameter.runtime || k == 0) continue;
      const std::uint32_t p = index(graph.symbol(parameter.name));
      point[p] = points_[0][p];
    }
    points_.push_back(std::move(point));
  }
  for (const Motion& motion : motions) {
    if (motion.kind != MotionKind::translation) continue;
    for (const double x : evaluate(motion.offset.entries, states_[0])) {
      if (std::isfinite(x)) length_ = std::max(length_, std::abs(x));
    }
  }
}

bool PeelingStates::finite_everywhere(std::span<const Expr> values) const {
  return std::all_of(states_.begin(), states_.end(), [&](const std::vector<double>& state) {
    const std::vector<double> here = evaluate(values, state);
    return std::all_of(here.begin(), here.end(), [](double x) { return std::isfinite(x); });
  });
}

std::vector<Expr> PeelingStates::recognised(std::vector<Expr> values, std::span<const double> sizes) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (vanishes(values[i], sizes[i])) {
      values[i] = graph_.zero();
    } else if (values[i].is_constant()) {
      values[i] = short_number(values[i]);
    }
  }
  return values;
}

bool PeelingStates::agree(const std::vector<Motion>& given, const std::vector<Motion>& other) const {
  const auto product = [&](const std::vector<Motion>& motions, std::vector<Expr>& out) {
    Pose pose = identity_pose(graph_);
    for (const Motion& motion : motions) pose = moved(std::move(pose), motion);
    out.insert(out.end(), pose.rotation.entries.begin(), pose.rotation.entries.end());
    out.insert(out.end(), pose.origin.entries.begin(), pose.origin.entries.end());
  };
  std::vector<Expr> entries;
  product(given, entries);
  product(other, entries);
  constexpr std::size_t kRotation = 9;  // entries before those of the position
  const std::size_t half = entries.size() / 2;
  for (const std::vector<double>& state : states_) {
    const std::vector<Extended> x = evaluate_extended(entries, state);
    Extended distance = length_;
    bool finite = true;
    for (std::size_t i = 0; i < half; ++i) {
      finite = finite && isfinite(x[i]);
      if (i >= kRotation) distance = std::max(distance, Extended(abs(x[i])));
    }
    if (!finite) continue;
    for (std::size_t i = 0; i < half; ++i) {
      const Extended size = i < kRotation ? Extended(1) : distance;
      if (!(abs(x[i] - x[half + i]) <= kSameProduct * size)) return false;
    }
  }
  return true;
}

}  // namespace alembert

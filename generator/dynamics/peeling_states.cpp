// Random states of a mechanism, and comparisons there (see the header).
#include "dynamics/peeling_states.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/constant_motions.hpp"
#include "dynamics/state_checks.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

constexpr double kSameProduct = 1e-11;  ///< products of motions at a state, relative
constexpr unsigned kGroups = 3;         ///< draws of the runtime parameters
constexpr unsigned kDraws = 4;          ///< states a draw of them
std::vector<PeelingStates::States> random_states(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<PeelingStates::States> groups;
  for (unsigned group = 0; group < kGroups; ++group) {
    PeelingStates::States states;
    std::vector<double> draw;  // in [-1, 1), one for each symbol
    for (unsigned k = 0; k < kDraws; ++k) {
      std::vector<double> state = state_values(mechanism, graph, 101 + 17 * group + k);
      if (k == 0) draw = state_values(mechanism, graph, 501 + group);
      const auto time = graph.symbol_index(mechanism.time.ref().node());
      state[time] = 0.3 + 0.21 * (4 * group + k);
      std::size_t p = 0;
      for (const Parameter& parameter : mechanism.parameters) {
        if (!parameter.runtime) continue;
        const Coordinate& any = mechanism.coordinates[p++ % mechanism.coordinates.size()];
        const double x =
            std::sin(draw[graph.symbol_index(any.symbols[0].ref().node())] + static_cast<double>(p));
        const auto index = graph.symbol_index(graph.symbol(parameter.name).ref().node());
        state[index] = parameter.value * (1 + 0.1 * x);
        if (parameter.value == 0) state[index] = 0.1 * x;
      }
      states.push_back(std::move(state));
    }
    groups.push_back(std::move(states));
  }
  return groups;
}

}  // namespace

// A long mechanism has short parts too, of which nothing may be lost.
PeelingStates::PeelingStates(const Mechanism& mechanism, const Units& units, ExprGraph& graph)
    : graph_(graph), length_(std::min(units.length, 1.0)), groups_(random_states(mechanism, graph)) {}

bool PeelingStates::finite_everywhere(std::span<const Expr> values) const {
  return std::all_of(groups_.begin(), groups_.end(), [&](const auto& group) {
    const std::vector<double> here = evaluate(values, group[0]);
    return std::all_of(here.begin(), here.end(), [](double x) { return std::isfinite(x); });
  });
}

std::vector<Expr> PeelingStates::recognised(std::vector<Expr> values, std::span<const double> sizes) const {
  std::vector<double> largest(values.size(), 0);
  for (const auto& group : groups_) {
    const std::vector<double> here = evaluate(values, group[0]);
    for (std::size_t i = 0; i < values.size(); ++i) largest[i] = std::max(largest[i], std::abs(here[i]));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (largest[i] < 1e-14 * sizes[i])
      values[i] = graph_.zero();
    else if (values[i].is_constant())
      values[i] = short_number(values[i]);
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
  for (const auto& group : groups_) {
    for (const std::vector<double>& state : group) {
      const std::vector<double> x = evaluate(entries, state);
      double distance = length_;
      bool finite = true;
      for (std::size_t i = 0; i < half; ++i) {
        finite = finite && std::isfinite(x[i]);
        if (i >= kRotation) distance = std::max(distance, std::abs(x[i]));
      }
      if (!finite) continue;
      for (std::size_t i = 0; i < half; ++i) {
        const double size = i < kRotation ? 1 : distance;
        if (!(std::abs(x[i] - x[half + i]) <= kSameProduct * size)) return false;
      }
    }
  }
  return true;
}

}  // namespace alembert

// Units of a mechanism (see the header).
#include "dynamics/units.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/state_checks.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

double unit_of(double size) {
  constexpr double kUsual = 1e3;
  const bool usual = size > 1 / kUsual && size < kUsual;
  return usual || !std::isnormal(size) ? 1 : std::exp2(std::floor(std::log2(size)));
}

Units units_of(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph) {
  const std::vector<double> state = state_values(mechanism, graph, 0);
  double length = 0, mass = 0, inertia = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const MotionNode& node = tree.nodes[i];
    if (node.partials.empty() && node.motion.kind == MotionKind::translation) {
      for (const double x : evaluate(node.motion.offset.entries, state))
        length = std::max(length, std::abs(x));
    }
    const double m = evaluate({&tree.masses[i].mass, 1}, state)[0];
    double moment = 0, moved = 0;
    for (const double x : evaluate(tree.masses[i].moment.entries, state))
      moment = std::max(moment, std::abs(x));
    for (const double x : evaluate(tree.masses[i].inertia.entries, state))
      moved = std::max(moved, std::abs(x));
    mass = std::max(mass, m);
    inertia = std::max(inertia, moved);
    if (m > 0) length = std::max({length, moment / m, std::sqrt(moved / m)});
  }
  if (length == 0) {  // a bead on a wire
    const std::vector<double> elsewhere = state_values(mechanism, graph, 1);
    for (const MotionNode& node : tree.nodes) {
      if (node.motion.kind != MotionKind::translation) continue;
      for (const double x : evaluate(node.motion.offset.entries, elsewhere))
        length = std::max(length, std::abs(x));
    }
  }
  Units units;
  units.length = unit_of(length);
  units.mass = unit_of(mass > 0 ? mass : inertia / (units.length * units.length));
  return units;
}

}  // namespace alembert

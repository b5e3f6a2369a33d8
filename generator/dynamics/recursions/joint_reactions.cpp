// Newton-Euler body by body: what a body and all that hangs on it take, less what acts on them, comes through its
// joint (see the header).
#include "dynamics/recursions/joint_reactions.hpp"

#include "dynamics/recursions/applied_forces.hpp"
#include "dynamics/recursions/body_forces.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

Wrench less(const Wrench& x, const Wrench& y) {
  return {x.moment - y.moment, x.force - y.force};
}

/// What each body takes by itself, about its node.
std::vector<Wrench> own_loads(const Mechanism& mechanism, const MotionTree& tree,
                              const SpeedDerivatives& derivatives, ExprGraph& graph) {
  const std::vector<FrameMotion> motions = frame_motions(mechanism, tree, graph);
  const FrameMotion world = motion_of_world(mechanism, graph);
  std::vector<Wrench> loads;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const BodyPlace& place = tree.places[b];
    const NodeMass mass = mass_at_node(mechanism.bodies[b], place, graph);
    const FrameMotion& motion = place.node < 0 ? world : motions[static_cast<std::size_t>(place.node)];
    loads.push_back(mass.is_zero() ? zero_wrench(graph) : inertia_forces(motion, mass, MomentForms{}, graph));
  }
  for (const auto& [body, point, wrench] : external_wrenches_by_body(mechanism, tree, graph))
    loads[body] = less(loads[body], at_offset(wrench, point));
  const std::vector<Wrench> applied = applied_wrenches(mechanism, tree, derivatives, graph);
  for (std::size_t b = 0; b < applied.size(); ++b) loads[b] = less(loads[b], applied[b]);
  return loads;
}

}  // namespace

std::vector<Expr> joint_reactions(const Mechanism& mechanism, const MotionTree& tree,
                                  const SpeedDerivatives& derivatives, ExprGraph& graph) {
  std::vector<Wrench> loads = own_loads(mechanism, tree, derivatives, graph);
  for (std::size_t b = loads.size(); b-- > 0;) {
    const int parent = mechanism.bodies[b].parent;
    if (parent < 0) continue;
    const std::size_t p = static_cast<std::size_t>(parent);
    Wrench load = loads[b];
    for (int node = tree.places[b].node; node != tree.places[p].node;) {
      if (node < 0) throw InternalError("a body's node does not hang on that of its parent");
      const MotionNode& at = tree.nodes[static_cast<std::size_t>(node)];
      load = inward(at.motion, load);
      node = at.parent;
    }
    loads[p] = loads[p] + load;
  }
  std::vector<Expr> out;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    Wrench load = loads[b];
    for (const Motion& motion : tree.places[b].tail) load = inward(motion.inverse(), load);
    for (std::size_t i = 0; i < 6; ++i) out.push_back(load[i]);
  }
  return out;
}

}  // namespace alembert

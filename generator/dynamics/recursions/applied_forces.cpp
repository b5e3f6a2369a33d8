// Generalized forces by virtual work: Mechanism::forces in; by speed k, with D_k the derivative along it,
//
//   along a speed    value, to that speed
//   potential V      -D_k V
//   tension T        -T D_k L for a path of length L
//   wrench (f, n)    f . D_k p + n . om_k for a frame at p, om_k being its angular velocity for that speed
//
// out, and the potential energy.
#include "dynamics/recursions/applied_forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/recursions/frame_values.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "dynamics/tree/state_values.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/substitute.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

class AppliedForcesBuilder {
 public:
  AppliedForcesBuilder(const Mechanism& mechanism, const MotionTree& tree,
                       const SpeedDerivatives& derivatives, ExprGraph& graph)
      : mechanism_(mechanism),
        derivatives_(derivatives),
        graph_(graph),
        poses_(frame_poses(mechanism, tree, graph)),
        replacements_(frame_values(mechanism, tree, derivatives, graph)),
        Q_(static_cast<std::size_t>(mechanism.nv), graph.zero()),
        potential_(graph.zero()) {}

  AppliedForces build() {
    for (const Force& force : mechanism_.forces) {
      add(force);
      check_values(force);
    }
    return {value_number(Q_), potential_};
  }

 private:
  std::vector<Expr> inserted(std::vector<Expr> values) const {
    return replacements_.empty() ? values : substitute(values, replacements_);
  }

  void add(int speed, const Expr& value) {
    if (speed != derivatives_.time_index()) Q_[static_cast<std::size_t>(speed)] += value;
  }

  void add(const Force& force) {
    switch (force.kind) {
      case ForceKind::on_speed:
        add(force.speed, inserted({force.value}).front());
        break;
      case ForceKind::potential: {
        const Expr energy = inserted({force.value}).front();
        potential_ += energy;
        for (const SpeedPartial& partial : derivatives_.partials(std::span(&energy, 1)))
          add(partial.speed, -partial.values.front());
        break;
      }
      case ForceKind::path: {
        const Expr length = inserted({force.length}).front();
        const std::vector<SpeedPartial> levers = derivatives_.partials(std::span(&length, 1));
        replacements_.emplace_back(force.rate, derivatives_.first_rate(levers, 1).front());
        const Expr tension = inserted({force.value}).front();
        for (const SpeedPartial& lever : levers) add(lever.speed, -(tension * lever.values.front()));
        break;
      }
      case ForceKind::wrench:
        add_wrench(force);
        break;
    }
  }

  void add_wrench(const Force& force) {
    const std::span<const Expr> pose =
        std::span(poses_).subspan(12 * static_cast<std::size_t>(force.frame), 12);
    const auto in_world = [&](const Vec3& given) -> Vec3 {
      const std::vector<Expr> x = inserted({given[0], given[1], given[2]});
      const Vec3 vector{{x[0], x[1], x[2]}};
      if (!force.frame_axes) return vector;
      return Mat3{{pose[0], pose[1], pose[2], pose[4], pose[5], pose[6], pose[8], pose[9], pose[10]}} *
             vector;
    };
    const Vec3 f = in_world(force.force), n = in_world(force.torque);
    for (const FrameTwist& twist : frame_twists(derivatives_, pose)) {
      const Expr power = dot(f, twist.linear);
      add(twist.speed, power + dot(n, twist.angular));
    }
  }

  void check_values(const Force& force) const {
    const std::vector<double> values = evaluate(Q_, state_values(mechanism_, graph_, 0));
    if (std::ranges::all_of(values, [](double x) { return std::isfinite(x); })) return;
    throw InputError(
        force.where,
        "force '" + force.name +
            "' has no value at the initial state (a path between two points that coincide, the square "
            "root of 0, a division by 0); write it another way, or choose another initial value");
  }

  const Mechanism& mechanism_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  std::vector<Expr> poses_;
  std::vector<std::pair<Expr, Expr>> replacements_;
  std::vector<Expr> Q_;
  Expr potential_;
};

}  // namespace

std::vector<Expr> less_applied(std::vector<Expr> forces, const AppliedForces& applied) {
  for (std::size_t k = 0; k < applied.Q.size(); ++k) forces[k] -= applied.Q[k];
  return forces;
}

AppliedForces applied_forces(const Mechanism& mechanism, const MotionTree& tree,
                             const SpeedDerivatives& derivatives, ExprGraph& graph) {
  if (mechanism.forces.empty()) return {{}, graph.zero()};
  return AppliedForcesBuilder(mechanism, tree, derivatives, graph).build();
}

}  // namespace alembert

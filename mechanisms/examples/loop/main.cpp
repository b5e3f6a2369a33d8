// A closed loop: a five-bar linkage with a motor at its left shoulder. The description closes the loop with
// two constraint equations; the runtime finds a state that keeps them, keeps them in every step, and gives
// the reactions.
#include <alembert/consistent_state.hpp>
#include <alembert/energy.hpp>
#include <alembert/integrate.hpp>
#include <cmath>
#include <cstdio>
#include <five_bar/five_bar.hpp>

using Linkage = alembert::mechanisms::five_bar::Mechanism<>;

/// How far the two tips are apart, m.
double gap(const Linkage::CoordinateVector& q) {
  const auto tips = Linkage::frame_poses(q);
  return (tips[0].col(3) - tips[1].col(3)).norm();
}

int main() {
  Linkage::CoordinateVector q = Linkage::initial_coordinates();  // a guess: the loop is open
  Linkage::SpeedVector qd = Linkage::SpeedVector::Zero();
  Linkage::Inputs in;
  alembert::ConstraintReport<Linkage::kNc> report;
  std::printf("guess: tips %.3f m apart\n", gap(q));
  if (alembert::consistent_state<Linkage>(q, qd, in, report) != alembert::Status::ok) return 1;
  std::printf("found: tips %.1e m apart, %d independent rows\n\n", gap(q), report.rank);

  const auto motor = [](double t, const auto&, const Linkage::SpeedVector& u) -> Linkage::SpeedVector {
    Linkage::SpeedVector tau = -0.05 * u;  // friction in the joints
    tau(0) += 1.5 * std::sin(4 * t);       // N m
    return tau;
  };
  std::printf("time  left shoulder  reactions at the tips [N]   gap [m]\n");
  double largest = 0;
  for (int k = 0; k <= 2000; ++k) {
    if (k % 400 == 0) {
      alembert::ConstrainedMotionOf<Linkage> motion;
      if (alembert::constrained_forward_dynamics<Linkage>(q, qd, motor(in.t, q, qd), in, motion) !=
          alembert::Status::ok)
        return 1;
      std::printf("%4.2f  %13.4f  %10.3f %10.3f  %12.1e\n", in.t, q(0), motion.lambda(0), motion.lambda(1),
                  gap(q));
    }
    largest = std::fmax(largest, gap(q));
    if (alembert::rk4_step<Linkage>(q, qd, in, 1e-3, motor) != alembert::Status::ok) return 1;
  }
  return largest < 1e-9 ? 0 : 1;
}

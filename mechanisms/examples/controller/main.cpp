// A computed-torque controller: each millisecond it asks the inverse dynamics which torques give the
// acceleration that it wants, and the simulated arm moves under them until the next millisecond.
#include <alembert/integrate.hpp>
#include <arm/arm.hpp>
#include <cstdio>

using Arm = alembert::mechanisms::arm::Mechanism<>;

Arm::SpeedVector control(const Arm::CoordinateVector& q, const Arm::SpeedVector& qd,
                         const Arm::CoordinateVector& goal) {
  const Arm::SpeedVector wanted = 100 * (goal - q) - 20 * qd;  // rad/s^2, critically damped
  return Arm::inverse_dynamics(q, qd, wanted);                 // N m
}

int main() {
  Arm::CoordinateVector q = Arm::initial_coordinates();  // turn, lift, elbow, as in the URDF
  Arm::SpeedVector qd = Arm::initial_speeds();
  const Arm::CoordinateVector goal(1.2, 0.9, -0.6);
  Arm::Inputs in;
  std::printf("time    turn    lift   elbow  gripper x       y       z\n");
  for (int k = 0; k <= 1000; ++k) {
    if (k % 250 == 0) {
      const Arm::Pose gripper = Arm::frame_poses(q)[Arm::Frame::gripper];  // [R p] in world axes
      std::printf("%4.2f %7.4f %7.4f %7.4f    %7.4f %7.4f %7.4f\n", in.t, q(0), q(1), q(2), gripper(0, 3),
                  gripper(1, 3), gripper(2, 3));
    }
    const Arm::SpeedVector tau = control(q, qd, goal);
    const auto held = [&](double, const auto&, const auto&) -> Arm::SpeedVector { return tau; };
    if (alembert::rk4_step<Arm>(q, qd, in, 1e-3, held) != alembert::Status::ok) return 1;
  }
  return (q - goal).norm() < 1e-3 ? 0 : 1;
}

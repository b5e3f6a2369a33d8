// Forward dynamics after inverse dynamics gives the acceleration back; a step in time changes the state.
#include <alembert/forward_dynamics.hpp>
#include <alembert/integrate.hpp>
#include <arm/arm.hpp>
#include <cmath>
#include <cstdio>

int main() {
  using Arm = alembert::mechanisms::arm::Mechanism<>;
  Arm::CoordinateVector q(0.3, -0.7);
  Arm::SpeedVector qd(0.5, 0.2), qdd(1.0, -2.0), back;
  Arm::Inputs in;
  const Arm::SpeedVector tau = Arm::inverse_dynamics(q, qd, qdd, in);
  if (alembert::forward_dynamics<Arm>(q, qd, tau, in, back) != alembert::Status::ok) return 1;
  if ((back - qdd).norm() > 1e-12) return 1;
  const auto free = [](double, const Arm::CoordinateVector&, const Arm::SpeedVector&) {
    return Arm::SpeedVector(0.0, 0.0);
  };
  if (alembert::rk4_step<Arm>(q, qd, in, 0.01, free) != alembert::Status::ok) return 1;
  std::printf("torque %.6f %.6f\n", tau(0), tau(1));
  return 0;
}

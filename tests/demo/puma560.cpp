// The generated dynamics of the PUMA 560 at one state: M, c, the torque for an acceleration, and that
// acceleration back from the torque.
#include <alembert/forward_dynamics.hpp>
#include <iostream>
#include <puma560/puma560.hpp>

int main() {
  using Puma = alembert::mechanisms::puma560::Mechanism<double>;
  Puma::CoordinateVector q;
  Puma::SpeedVector qd, qdd;
  q << 0.3, -0.8, 0.5, 0.2, 0.9, -0.4;
  qd << 0.5, -0.2, 0.4, 1.0, -0.7, 0.3;
  qdd << 1.0, 0.5, -0.5, 2.0, 1.0, -1.0;

  Puma::SpeedMatrix M;
  Puma::SpeedVector c;
  Puma::mass_matrix_and_bias(q, qd, {}, M, c);
  const Puma::SpeedVector tau = Puma::inverse_dynamics(q, qd, qdd);
  Puma::SpeedVector back;
  const alembert::Status status = alembert::forward_dynamics<Puma>(q, qd, tau, {}, back);

  std::cout << "PUMA 560 at q = " << q.transpose() << " rad\n\nM [kg m^2] =\n"
            << M << "\n\nc [N m] = " << c.transpose() << "\n\ntorque for qdd = " << qdd.transpose()
            << " rad/s^2:\ntau [N m] = " << tau.transpose() << "\n\nacceleration for that torque ("
            << alembert::to_string(status) << "):\nqdd [rad/s^2] = " << back.transpose() << "\n\n";
  const double error = (back - qdd).cwiseAbs().maxCoeff();
  const bool good = status == alembert::Status::ok && error < 1e-9;
  std::cout << (good ? "success" : "FAILURE") << ": the acceleration comes back to " << error << '\n';
  return good ? 0 : 1;
}

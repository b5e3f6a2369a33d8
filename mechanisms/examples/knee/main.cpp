// A seated leg kicks. Muscles are forces along lines between frames: the generated Jacobians turn them into the generalized
// force of the linkage's one coordinate. The work of the muscles must become the energy of the leg.
#include <alembert/integrate.hpp>
#include <cmath>
#include <cstdio>
#include <knee/knee.hpp>

using Knee = alembert::mechanisms::knee::Mechanism<>;
using Frame = Knee::Frame;  // names of the description's frames, as indices

struct Muscle {
  unsigned origin, insertion;
  double strongest;  // N
  double rest;       // m, the length at which it is strongest
};
constexpr Muscle kQuadriceps{Frame::patella, Frame::tibia_front, 2500, 0.13},
    kHamstrings{Frame::ischium, Frame::tibia_back, 1500, 0.42};

struct Pull {
  double length, rate, force, tau;  // m, m/s, N, generalized force
};

Pull pull(const Muscle& muscle, double activation, const Knee::CoordinateVector& q,
          const Knee::SpeedVector& qd) {
  const auto F = Knee::frame_poses(q);
  const auto J = Knee::frame_jacobians(q);  // rows 0-2 angular, rows 3-5 the origin's velocity, world axes
  const Eigen::Vector3d line = F[muscle.insertion].col(3) - F[muscle.origin].col(3);
  const Eigen::Matrix<double, 3, Knee::kNv> moves =
      J[muscle.insertion].bottomRows<3>() - J[muscle.origin].bottomRows<3>();
  Pull out;
  out.length = line.norm();
  const Eigen::Matrix<double, 1, Knee::kNv> arm = line.transpose() * moves / out.length;  // d length / dq
  out.rate = arm.dot(qd);
  const double stretch = (out.length - muscle.rest) / (0.5 * muscle.rest);
  out.force = activation * muscle.strongest * std::exp(-stretch * stretch) / (1 + std::exp(-4 * out.rate));
  out.tau = -out.force * arm(0);
  return out;
}

double quadriceps_activation(double t) {
  return 0.5 * std::exp(-std::pow((t - 0.25) / 0.1, 2));
}
double hamstrings_activation(double t) {
  return 0.3 * std::exp(-std::pow((t - 0.4) / 0.1, 2));
}

int main() {
  Knee::CoordinateVector q(1.66);  // the shank hangs
  Knee::SpeedVector qd(0.0);
  Knee::Inputs in;
  const auto muscles = [](double t, const Knee::CoordinateVector& at,
                          const Knee::SpeedVector& rate) -> Knee::SpeedVector {
    return Knee::SpeedVector(pull(kQuadriceps, quadriceps_activation(t), at, rate).tau +
                             pull(kHamstrings, hamstrings_activation(t), at, rate).tau);
  };
  const double start = Knee::energy(q, qd).sum();
  double work = 0;
  std::printf("time   shank [deg]  quadriceps [N]  hamstrings [N]  energy [J]  work [J]\n");
  for (int k = 0; k <= 1000; ++k) {
    if (k % 100 == 0) {
      const auto shank = Knee::body_poses(q)[Knee::Body::shank];
      std::printf("%4.2f %12.1f %15.1f %15.1f %11.4f %9.4f\n", in.t,
                  std::atan2(-shank(2, 0), shank(0, 0)) * 57.29578,
                  pull(kQuadriceps, quadriceps_activation(in.t), q, qd).force,
                  pull(kHamstrings, hamstrings_activation(in.t), q, qd).force,
                  Knee::energy(q, qd).sum() - start, work);
    }
    const double before = muscles(in.t, q, qd).dot(qd);
    if (alembert::rk4_step<Knee>(q, qd, in, 1e-3, muscles) != alembert::Status::ok) return 1;
    work += 0.5e-3 * (before + muscles(in.t, q, qd).dot(qd));
  }
  return std::abs(Knee::energy(q, qd).sum() - start - work) < 1e-3 ? 0 : 1;
}

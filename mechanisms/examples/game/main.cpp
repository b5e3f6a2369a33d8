// A crane in a game: `float`, 60 frames a second, four substeps a frame. The player holds "right" for two
// seconds, then brakes and lowers the load; a gust blows. A frame takes less than a microsecond.
#include <alembert/integrate.hpp>
#include <chrono>
#include <cmath>
#include <crane/crane.hpp>
#include <cstdio>

using Crane = alembert::mechanisms::crane::Mechanism<float>;

struct Player {
  float wanted_speed = 0;  // m/s, of the trolley
  float wanted_rope = 6;   // m
};

Player keys(int frame) {
  if (frame < 120) return {3.0F, 6.0F};
  return {0.0F, 9.0F};
}

int main() {
  Crane::CoordinateVector q = Crane::initial_coordinates();
  Crane::SpeedVector qd = Crane::initial_speeds();
  Crane::Inputs in;
  in.parameters[Crane::Parameter::length] = 6.0F;  // length of the rope
  std::printf("second  trolley  load: x      y      z\n");
  const auto begin = std::chrono::steady_clock::now();
  for (int frame = 0; frame < 600; ++frame) {
    const Player player = keys(frame);
    in.parameters[Crane::Parameter::length] +=
        0.02F * (player.wanted_rope - in.parameters[Crane::Parameter::length]);
    in.wrenches[6 * Crane::Wrench::load + 1] =
        frame / 60 == 4 ? 600.0F : 0.0F;  // wind along y for a second, N: force, then torque
    const auto forces = [&](float, const Crane::CoordinateVector&,
                            const Crane::SpeedVector& u) -> Crane::SpeedVector {
      return {4000.0F * (player.wanted_speed - u(0)), -300.0F * u(1),
              -300.0F * u(2)};  // motor, and damped ropes
    };
    for (int k = 0; k < 4; ++k)
      if (alembert::semi_implicit_euler_step<Crane>(q, qd, in, 1.0F / 240, forces) != alembert::Status::ok)
        return 1;
    if (frame % 60 == 59) {  // where to draw the load
      const Crane::Pose load = Crane::body_poses(q, in)[Crane::Body::load];
      std::printf("%6d %8.2f %8.2f %6.2f %6.2f\n", (frame + 1) / 60,
                  static_cast<double>(q(Crane::Coordinate::trolley)), static_cast<double>(load(0, 3)),
                  static_cast<double>(load(1, 3)), static_cast<double>(load(2, 3)));
    }
  }
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
  std::printf("%.2f us a frame\n", time.count() / 600);
  return std::abs(qd(0)) < 0.5F && q.allFinite() ? 0 : 1;
}

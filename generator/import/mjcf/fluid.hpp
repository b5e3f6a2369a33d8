// What a fluid exerts on a body, by MuJoCo's two models: force and torque in the axes of a frame, as expressions of
// the velocity of its origin relative to the fluid and its angular velocity, both in those axes.
#pragma once

#include <array>
#include <string>

#include "import/mjcf/mjcf_model.hpp"

namespace alembert {

struct FluidLoads {
  std::array<std::string, 3> force, torque;
};

/// What moves in the fluid: factors.
struct FluidMotion {
  std::array<std::string, 3> velocity, angular_velocity;
};

/// On a box of these edges (m), about its centre.
FluidLoads fluid_on_box(const MjcfModel& fluid, const std::array<double, 3>& edges,
                        const FluidMotion& motion);

/// On an ellipsoid, about its centre: drag, the lift of its circulation (Kutta) and of its turning (Magnus), and what the
/// fluid that moves with it takes; without that fluid's inertia.
FluidLoads fluid_on_ellipsoid(const MjcfModel& fluid, const MjcfFluidShape& shape, const FluidMotion& motion);

}  // namespace alembert

// Joints that move no mass, and what can be done about them.
#pragma once

#include <vector>

#include "import/urdf/robot.hpp"

namespace alembert {

bool has_mass(const UrdfLink& link);

/// By joint: itself, or that which it mimics in the end.
std::vector<std::size_t> drivers(const UrdfRobot& robot);

/// By joint: whether it is independent, moves, and moves neither mass nor a rotor, nor do those that mimic it.
std::vector<bool> massless_joints(const UrdfRobot& robot);

/// The robot with its massless joints fixed.
UrdfRobot with_massless_frozen(UrdfRobot robot);

/// The robot without its massless joints and all that they move. One that moves a joint which others mimic is
/// fixed instead.
UrdfRobot without_massless(UrdfRobot robot);

}  // namespace alembert

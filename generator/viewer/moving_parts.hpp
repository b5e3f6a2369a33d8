// Forces as meshes that move and grow, for scenes that know nothing else. In: lines and contacts of a mechanism. Out: tubes
// and balls with their places and sizes over time.
#pragma once

#include "viewer/scene.hpp"

namespace alembert {

/// A mesh in the mechanism's world; all vectors have one entry a frame.
struct MovingPart {
  std::string name;
  std::size_t mesh = 0;  ///< index into Scene::meshes
  Color color{0.5, 0.5, 0.5};
  std::vector<Eigen::Vector3d> origins;
  std::vector<Eigen::Quaterniond> rotations;
  std::vector<Eigen::Vector3d> scales;
};

/// A tube for each piece of a line, thicker with tension, and a ball for each contact, larger with force, which is too
/// small to be seen where nothing touches.
std::vector<MovingPart> moving_parts(Scene& scene, const SceneMechanism& mechanism);

}  // namespace alembert

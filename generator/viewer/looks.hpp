// What bodies look like. In: a mechanism and the poses of its bodies over a motion. Out: parts for each body
// and for the world. Shapes of the description where there are any; otherwise the mass as an ellipsoid of the
// same inertia, links between joints, which are found in the motion itself, and the curves and surfaces that
// bodies slide on.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "viewer/scene.hpp"

namespace alembert {

/// Poses of all bodies in the world, at one frame.
using BodyPoses = std::vector<Eigen::Isometry3d>;

/// Parts of each body, and last those of the world.
struct Looks {
  std::vector<std::vector<ScenePart>> bodies;
  std::vector<ScenePart> world;
  std::vector<bool> has_shapes;  ///< by body: shapes of the description are drawn
};

/// A mesh whose file cannot be read is a warning, and not drawn.
Looks mechanism_looks(Scene& scene, const Mechanism& mechanism, ExprGraph& graph, const BakedMotion& motion,
                      std::span<const BodyPoses> frames, Warnings& warnings);

/// Colour of body i, from a palette that can be told apart on light and on dark.
Color body_color(std::size_t i);
inline constexpr Color kSceneryColor{0.62, 0.64, 0.67};
inline constexpr Color kJointColor{0.27, 0.29, 0.33};

/// Semi-axes of the homogeneous ellipsoid of a mass and principal moments A, B, C: a^2 = 5/(2m) (B + C - A)
/// and so on, none below `least` times the largest.
Eigen::Vector3d equivalent_ellipsoid(double mass, const Eigen::Vector3d& moments, double least = 0.12);

}  // namespace alembert

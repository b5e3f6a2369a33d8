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

/// Values of expressions at the mechanism's initial state and the runtime parameters' defaults, some symbols
/// changed.
class InitialValues {
 public:
  InitialValues(const Mechanism& mechanism, ExprGraph& graph);
  void set(Expr symbol, double value);
  Eigen::Vector3d operator()(const Vec3& expressions) const;
  /// Pose that a transform leads to. Throws as elementary_motions (dynamics) does.
  Eigen::Isometry3d pose(const Transform& transform) const;
  const Mechanism& mechanism() const { return mechanism_; }

 private:
  const Mechanism& mechanism_;
  ExprGraph& graph_;
  std::vector<double> symbols_;
};

/// Mesh of a shape, in its own axes. Throws InputError where it is not finite or has no extent.
Mesh shape_mesh(const Shape& shape, const InitialValues& values);

/// Where a body is held by its parent, as its motion shows it: the points that stay together.
struct FoundJoint {
  enum class Kind {
    none,   ///< no point of the body rests in the parent
    fixed,  ///< all do
    axis,   ///< those of a line
    point,  ///< one
    slide,  ///< none, but the body moves along a line without turning
  };
  Kind kind = Kind::none;
  Eigen::Vector3d in_body = Eigen::Vector3d::Zero();  ///< the point next to the body's origin, body frame
  Eigen::Vector3d in_parent =
      Eigen::Vector3d::Zero();                      ///< the same point in the parent's frame; slide: one end
  Eigen::Vector3d end = Eigen::Vector3d::Zero();    ///< slide: the other end, parent's frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< axis: unit vector, body frame
};

/// Least squares over frames k: x in the body and y in the parent with R_k x + p_k = y. `size` is a length of
/// the mechanism, against which errors are judged.
FoundJoint find_joint(std::span<const Eigen::Isometry3d> relative_poses, double size);

/// Parts of each body, and last those of the world.
struct Looks {
  std::vector<std::vector<ScenePart>> bodies;
  std::vector<ScenePart> world;
};

Looks mechanism_looks(Scene& scene, const Mechanism& mechanism, ExprGraph& graph, const BakedMotion& motion,
                      std::span<const BodyPoses> frames);

/// The curves and surfaces that bodies move on, drawn on what they are fixed to, unless that has shapes of
/// its own.
void add_contacts(Scene& scene, Looks& looks, const Mechanism& mechanism, ExprGraph& graph,
                  const BakedMotion& motion);

/// Colour of body i, from a palette that can be told apart on light and on dark.
Color body_color(std::size_t i);
inline constexpr Color kSceneryColor{0.62, 0.64, 0.67};
inline constexpr Color kJointColor{0.27, 0.29, 0.33};

/// Semi-axes of the homogeneous ellipsoid of a mass and principal moments A, B, C: a^2 = 5/(2m) (B + C - A)
/// and so on, none below `least` times the largest.
Eigen::Vector3d equivalent_ellipsoid(double mass, const Eigen::Vector3d& moments, double least = 0.12);

}  // namespace alembert

// Forces of rigid bodies in moving frames: the part of the reduced form that belongs to one frame alone. In: the
// motion and masses of a frame, external wrenches. Out: the wrenches in the frame.
//
// Letters, here and in the other recursions: om, al angular velocity and its rate, acc acceleration of a frame's
// origin, f, n force and moment, all in the axes of the frame they belong to; U = skew(al) + skew(om)^2; h = m c first
// moment; J inertia about the frame's origin.
#pragma once

#include "dynamics/rewrites/scaled_vectors.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

/// Motion of a frame and the products of its angular velocity, made once.
struct FrameMotion {
  Vec3 om, al;
  Vec3 acc;                     ///< as stored: the acceleration is scale * acc
  Scale scale;                  ///< D (scaled_vectors.hpp)
  Expr xx, yy, zz, xy, xz, yz;  ///< om om^T
  Mat3 U;                       ///< skew(al) + skew(om)^2

  FrameMotion(const Vec3& angular, const Vec3& angular_rate, const Vec3& linear,
              const Scale& scale = kUnscaled);
  /// Acceleration of a point fixed to the frame, as stored: acc + D^-1 U t.
  Vec3 at(const Vec3& t) const;
};

/// From a frame to the next, unscaled.
FrameMotion outward(const FrameMotion& from, const MotionNode& to, ExprGraph& graph);

/// f = m acc + U h;  n = J al + om x J om + h x acc, about the frame's origin; as stored: D f, D n.
Wrench inertia_forces(const FrameMotion& motion, const NodeMass& mass, const MomentForms& forms,
                      ExprGraph& graph);

/// An external wrench on a body, in the axes of the body's node or of the world: about the centre of mass at `point`.
struct BodyWrench {
  std::size_t body;
  Vec3 point;
  Wrench wrench;
};
std::vector<BodyWrench> external_wrenches_by_body(const Mechanism& mechanism, const MotionTree& tree,
                                                  ExprGraph& graph);

/// The same of the bodies that are fixed to nodes.
struct NodeWrench {
  std::size_t node;
  Vec3 point;
  Wrench wrench;
};
std::vector<NodeWrench> external_wrenches(const Mechanism& mechanism, const MotionTree& tree,
                                          ExprGraph& graph);

}  // namespace alembert

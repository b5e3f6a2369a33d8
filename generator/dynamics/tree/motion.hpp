// Elementary motions: translations, plane rotations about a coordinate axis, and rotations by a full matrix,
// each any function of the coordinates and time. In: the factors of a transform. Out: the motions they are.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"
#include "symbolic/matrix.hpp"

namespace alembert {

enum class MotionKind { translation, axis_rotation, rotation };

/// One elementary motion, from a frame to the next.
struct Motion {
  MotionKind kind = MotionKind::translation;
  Vec3 offset;                     ///< translation: t, in the axes of both frames
  int axis = 0;                    ///< axis_rotation: 0, 1, 2
  Expr angle, cosine, sine;        ///< axis_rotation
  Mat3 matrix;                     ///< rotation: E, child to parent
  int quaternion = -1;             ///< rotation: index of the quaternion coordinate it is made of, or -1
  std::optional<Vec3> fixed_axis;  ///< rotation: the constant axis it turns about by `angle`, if there is one

  Vec3 to_parent(const Vec3& v) const;  ///< E v: axes of the next frame to axes of the previous one
  Vec3 to_child(const Vec3& v) const;   ///< E^T v
  Motion inverse() const;
  friend bool operator==(const Motion&, const Motion&) = default;
};

/// Whether an axis rotation is by a multiple of a right angle in all states.
bool is_quarter_turn(const Motion& motion);
/// E K E^T of a symmetric K; for a plane rotation with z = s (K_ii - K_jj) + 2 c K_ij: K'_ii = K_ii - s z,
/// K'_jj = K_jj + s z, K'_ij = c z - K_ij.
Mat3 turned_symmetric(const Mat3& K, const Motion& motion);
/// E A E^T of any A; for a plane rotation with z = s (A_ii - A_jj) + c (A_ij + A_ji): A'_ii = A_ii - s z,
/// A'_jj = A_jj + s z, A'_ij = c z - A_ji, A'_ji = c z - A_ij.
Mat3 turned(const Mat3& A, const Motion& motion);

Motion translation_motion(const Vec3& offset);
Motion axis_rotation_motion(int axis, Expr angle);

/// Appends a motion, merging it with the last one where both are translations or rotations about one axis;
/// drops identities.
void append_motion(std::vector<Motion>& motions, Motion motion, ExprGraph& graph);

/// The elementary motions of a transform, left to right, merged where neighbours are of one kind, identities
/// dropped. Throws InputError at the factor where a frame is undefined (a Frenet frame of a straight line, a
/// surface without normal).
std::vector<Motion> elementary_motions(const Transform& transform, const Mechanism& mechanism,
                                       ExprGraph& graph);

/// Rotation (columns are child axes) and origin of a product of motions.
struct Pose {
  Mat3 rotation;
  Vec3 origin;
};
Pose identity_pose(ExprGraph& graph);
Pose moved(Pose pose, const Motion& motion);

}  // namespace alembert

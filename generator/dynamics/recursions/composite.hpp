// Mass properties of all that moves with a frame: composite bodies, for M and for derivatives of forces.
#pragma once

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"

namespace alembert {

/// Mass, first moment h and pseudo-inertia K (integral of r r^T dm) of everything that moves with a frame,
/// about its origin.
struct Composite {
  Expr mass;
  Vec3 h;
  Mat3 K;  ///< symmetric; all nine entries are kept equal in pairs
};

Composite composite(const NodeMass& mass, ExprGraph& graph);
Composite plus(Composite x, const Composite& y);
/// From the axes of the next frame into those before a rotation.
Composite turned(const Composite& x, const Motion& rotation);
/// Moves the point of reference: h' = h + m t; with k = h + m t/2, K' = K + k t^T + t k^T.
Composite shifted(const Composite& x, const Vec3& t, ExprGraph& graph);

/// J d = tr(K) d - K d.
Vec3 times_inertia(const Mat3& K, const Vec3& d);
/// Symmetric matrices: x + y, and x + a b^T + b a^T.
Mat3 plus_symmetric(Mat3 x, const Mat3& y);
Mat3 plus_products(Mat3 x, const Vec3& a, const Vec3& b);

/// What moves with a frame, and how it moves in it: dr/dt is of a particle at r as seen from the frame.
struct InnerMotion {
  Composite body;
  Vec3 p;  ///< integral of dr/dt dm
  Mat3 P;  ///< integral of r (dr/dt)^T dm
};
InnerMotion still(const Composite& body, ExprGraph& graph);
InnerMotion plus(const InnerMotion& x, const InnerMotion& y);
/// From the axes of the next frame, which turns at `turning` (in its axes), into those before the rotation.
InnerMotion turned(const InnerMotion& x, const Motion& rotation, const Vec3& turning);
/// From the frame at t, which moves at `velocity`.
InnerMotion shifted(const InnerMotion& x, const Vec3& t, const Vec3& velocity, ExprGraph& graph);

}  // namespace alembert

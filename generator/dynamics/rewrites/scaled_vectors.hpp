// Scaled components: the tree of motions in, for each of its frames the factors by which components of
// vectors in its axes are scaled out.
//
// A constant turn by alpha takes four multiplications a vector, x' = c x + s y, y' = c y - s x. Where the
// components that come out stand for c x' and c y', two are enough: x' = x + (s/c) y, y' = y - (s/c) x. The
// factors c are constants; they are absorbed in the constants that follow and, at the next moving rotation,
// in its sine and cosine, once for all vectors that pass. Accelerations carry a = D a_stored; forces and
// moments, which go the other way, f = D^-1 f_stored.
//
// Angular velocities are wanted as they are, for their squares. There three are enough, if the moving
// rotation before gives c x in place of x, which costs nothing where its sine and cosine come in these
// multiples for other vectors: x' = (c x) + s y, y' = c y - (s/c) (c x). Then it must give all vectors so.
#pragma once

#include <array>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

using Scale = std::array<double, 3>;
inline constexpr Scale kUnscaled{1, 1, 1};

/// D of each node, in its axes. Only nodes marked `scaled` begin one; a rotation that is neither marked nor
/// about one axis ends it.
std::vector<Scale> node_scales(const MotionTree& tree);
/// The same of angular velocities and their rates, whose squares and products are wanted: only the rotations
/// that scale for a turn ahead begin one, and the turn ends it.
std::vector<Scale> angular_scales(const MotionTree& tree);

/// Constant turns of a tree that may be scaled: by numbers that are no multiples of a right angle and whose
/// cosines are not small.
std::vector<int> scalable_turns(const MotionTree& tree);
/// Marks these nodes and no others as `scaled`, leaving out those whose factors would become too small for a
/// float. Before those that are in `ahead` too, a moving rotation scales for them.
void mark_scaled(MotionTree& tree, const std::vector<int>& turns, const std::vector<int>& ahead = {});

/// Vectors through one motion: from the parent's axes to the node's (outward: accelerations) and back
/// (inward: forces, moments), scaled by D of the parent and of the node.
class ScaledTurn {
 public:
  /// `begun`: whether a node that is marked as scaled is to be taken as such.
  ScaledTurn(const MotionNode& node, const Scale& parent, const Scale& own, bool begun = true)
      : node_(node), parent_(parent), own_(own), scaled_(node.scaled && begun) {}
  Vec3 outward(const Vec3& v) const;
  Vec3 inward(const Vec3& v) const;
  /// The same wrench about the parent's origin.
  Wrench inward(const Wrench& x) const;

 private:
  Expr cosine(std::size_t k) const;

  const MotionNode& node_;
  Scale parent_, own_;
  bool scaled_;
};

Expr times(double factor, Expr x);
/// factor v, component by component.
Vec3 scaled_by(const Scale& factor, const Vec3& v);
Scale inverse(const Scale& scale);

/// The scale of a force that is carried inward through a node from `scale`, where it need not be that of the
/// accelerations: what it makes of a moving rotation's sine and cosine is what D of the parent asks for, if
/// scaling has begun.
Scale carried_inward(const MotionNode& node, const Scale& scale, const Scale& parent, bool begun);

}  // namespace alembert

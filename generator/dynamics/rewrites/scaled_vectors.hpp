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
#include <cstddef>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

using Scale = std::array<double, 3>;
inline constexpr Scale kUnscaled{1, 1, 1};

/// Constant turns of a tree that may be scaled: by numbers that are no multiples of a right angle and whose
/// cosines are not small.
std::vector<int> scalable_turns(const MotionTree& tree);

/// The scales of one tree.
class Scaling {
 public:
  /// Nothing is scaled.
  Scaling() = default;
  /// These turns are, but for those whose factors would become too small for a float. Before those that are in
  /// `ahead` too, a moving rotation scales for them.
  Scaling(const MotionTree& tree, const std::vector<int>& turns, const std::vector<int>& ahead = {});

  bool is_scaled(std::size_t node) const { return of(node).scaled; }
  /// Whether a node is a rotation that scales for a turn that follows it.
  bool scales_ahead(std::size_t node) const { return of(node).ahead >= 0; }
  /// D of a node, in its axes. Scaled turns begin one; another rotation that is not about one axis ends it.
  const Scale& of_vectors(std::size_t node) const { return of(node).vectors; }
  /// The same of angular velocities and their rates, whose squares and products are wanted: only the rotations
  /// that scale for a turn ahead begin one, and the turn ends it.
  const Scale& of_angular(std::size_t node) const { return of(node).angular; }
  friend bool operator==(const Scaling&, const Scaling&) = default;

 private:
  struct Node {
    bool scaled = false;
    int ahead = -1;  ///< the scaled turn that this rotation scales for
    Scale vectors = kUnscaled, angular = kUnscaled;
    friend bool operator==(const Node&, const Node&) = default;
  };
  const Node& of(std::size_t node) const {
    static constexpr Node kNotScaled;
    return nodes_.empty() ? kNotScaled : nodes_[node];
  }
  Scale scale_after(const MotionTree& tree, std::size_t k) const;
  void scale_ahead(const MotionTree& tree, std::size_t k, Scale& own) const;

  std::vector<Node> nodes_;
};

/// Vectors through one motion: from the parent's axes to the node's (outward: accelerations) and back
/// (inward: forces, moments), scaled by D of the parent and of the node.
class ScaledTurn {
 public:
  /// `scaled`: whether the node is a turn that is taken as scaled.
  ScaledTurn(const Motion& motion, bool scaled, const Scale& parent, const Scale& own)
      : motion_(motion), scaled_(scaled), parent_(parent), own_(own) {}
  Vec3 outward(const Vec3& v) const;
  Vec3 inward(const Vec3& v) const;
  /// The same wrench about the parent's origin.
  Wrench inward(const Wrench& x) const;

 private:
  Expr cosine(std::size_t k) const;

  const Motion& motion_;
  bool scaled_;
  Scale parent_, own_;
};

Expr times(double factor, Expr x);
/// factor v, component by component.
Vec3 scaled_by(const Scale& factor, const Vec3& v);
Scale inverse(const Scale& scale);

/// The scale of a force that is carried inward through a node from `scale`, where it need not be that of the
/// accelerations: what it makes of a moving rotation's sine and cosine is what D of the parent asks for, if
/// scaling has begun.
Scale carried_inward(const MotionNode& node, bool scaled, const Scale& scale, const Scale& parent,
                     bool begun);

}  // namespace alembert

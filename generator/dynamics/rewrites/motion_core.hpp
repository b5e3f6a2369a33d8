// What screw peeling has not peeled yet. In: motions, each with its derivatives along the speeds (time among
// them). Out: along which speeds the twist of their product is the same in all states, what it is there, and
// the motions with a coordinate held.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dynamics/rewrites/peeling_states.hpp"
#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

/// From where a twist is seen: (D_k A) A^-1 or A^-1 (D_k A).
enum class Side { left, right };

/// A product of motions A. Holds references: all that it is made of must outlive it.
class MotionCore {
 public:
  /// One motion with the derivatives along the speeds.
  struct Part {
    Motion motion;
    std::vector<SpeedPartial> partials;
  };

  MotionCore(const std::vector<Motion>& motions, const Mechanism& mechanism,
             const SpeedDerivatives& derivatives, ExprGraph& graph, const PeelingStates& states);

  const std::vector<Part>& parts() const { return parts_; }
  /// Speeds along which a motion moves, ascending.
  std::vector<int> moving_speeds() const;
  /// Entries of the poses of all motions.
  std::vector<Expr> poses() const { return poses(parts_); }

  /// Which of `speeds` are proved to have one twist in all states, whatever the runtime parameters are.
  std::vector<char> constant_twists(std::span<const int> speeds, Side side) const;
  /// The constant twist along a speed, in the axes and about the origin of its side, from the expressions with every coordinate held. Nothing where they
  /// have no value, or the axis moves with a runtime parameter.
  std::optional<Twist> constant_twist(int speed, Side side) const;

  /// Values at which a coordinate may be held: those that keep constants exact first.
  std::vector<Expr> reference_values() const;
  /// Holds a coordinate, or time, at a value. False, and all is as before, where a motion has no value then.
  bool hold(Expr variable, Expr reference);

 private:
  std::vector<Expr> poses(std::span<const Part> parts) const;
  std::optional<std::vector<Part>> held(std::span<const std::pair<Expr, Expr>> replacements,
                                        bool partials) const;

  const Mechanism& mechanism_;
  const SpeedDerivatives& derivatives_;
  ExprGraph& graph_;
  const PeelingStates& states_;
  std::vector<Part> parts_;
};

}  // namespace alembert

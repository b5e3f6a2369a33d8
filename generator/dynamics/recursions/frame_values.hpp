// What symbols of frames stand for. In: the mechanism's FrameSymbols and its motions. Out: their expressions.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/spatial_vectors.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Where a frame is fixed: a node, or -1 for the world, and the motions from there to the frame, which may
/// depend on coordinates.
struct FramePlace {
  int node = -1;
  std::vector<Motion> motions;
};
FramePlace frame_place(int frame, const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);

/// The twist of a frame in world axes, about its origin, for a speed that is 1 (or for time).
struct FrameTwist {
  int speed;  ///< index of the speed, or Mechanism::nv for time
  Twist twist;
};
/// Of a pose, 12 expressions: rows of [R | p]. In ascending order of the speeds.
std::vector<FrameTwist> frame_twists(const SpeedDerivatives& derivatives, std::span<const Expr> pose);

/// What each symbol of Mechanism::frame_symbols and Mechanism::distances stands for.
std::vector<std::pair<Expr, Expr>> frame_values(const Mechanism& mechanism, const MotionTree& tree,
                                                const SpeedDerivatives& derivatives, ExprGraph& graph);

/// And the rates of paths: all that stands for something in forces and outputs.
std::vector<std::pair<Expr, Expr>> moving_values(const Mechanism& mechanism, const MotionTree& tree,
                                                 const SpeedDerivatives& derivatives, ExprGraph& graph);

/// What inputs with a law stand for; `moving` as moving_values gives it.
std::vector<std::pair<Expr, Expr>> input_laws(const Mechanism& mechanism,
                                              std::span<const std::pair<Expr, Expr>> moving,
                                              ExprGraph& graph);

/// Expressions as of forces and outputs, with all that is known put in: laws of inputs too.
std::vector<Expr> with_moving_values(std::span<const Expr> given, const Mechanism& mechanism,
                                     const MotionTree& tree, const SpeedDerivatives& derivatives,
                                     ExprGraph& graph);

}  // namespace alembert

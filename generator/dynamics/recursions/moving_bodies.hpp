// How bodies and frames move in the world. In: a tree of motions. Out: velocities and accelerations in world axes,
// and the momentum of all.
#pragma once

#include <vector>

#include "dynamics/tree/motion_tree.hpp"
#include "dynamics/tree/speed_derivatives.hpp"
#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Whether accelerations contain the speeds' rates, or are what is left without them.
enum class SpeedRates { included, left_out };

/// Of each named frame: angular velocity and velocity of the origin, 6 entries.
std::vector<Expr> frame_velocities(const Mechanism& mechanism, const MotionTree& tree,
                                   const SpeedDerivatives& derivatives, ExprGraph& graph);
/// Of each named frame: angular acceleration and acceleration of the origin, 6 entries.
std::vector<Expr> frame_accelerations(const Mechanism& mechanism, const MotionTree& tree,
                                      const SpeedDerivatives& derivatives, ExprGraph& graph,
                                      SpeedRates rates);
/// The same of each body and its centre of mass.
std::vector<Expr> body_velocities(const Mechanism& mechanism, const MotionTree& tree,
                                  const SpeedDerivatives& derivatives, ExprGraph& graph);
std::vector<Expr> body_accelerations(const Mechanism& mechanism, const MotionTree& tree,
                                     const SpeedDerivatives& derivatives, ExprGraph& graph, SpeedRates rates);

/// Momentum about the centre of mass of all, angular before linear, world axes.
struct CentroidalMomentum {
  std::vector<Expr> h;     ///< 6
  std::vector<Expr> A;     ///< 6 x nv: h = A u and what motion prescribed in time adds
  std::vector<Expr> bias;  ///< 6: dh/dt = A du/dt + bias
  std::vector<Expr> com;   ///< 3: the centre of mass
};
/// Which velocity (and acceleration) is subtracted from those of all bodies in moments about the centre of mass, sum m r x v.
/// Since sum m r = 0, any one will do. The arm r of a body much heavier than the others is only rounding; with that body's
/// velocity subtracted, this rounding is multiplied by zero.
enum class MomentumFrom { world, heaviest_body };
CentroidalMomentum centroidal_momentum(const Mechanism& mechanism, const MotionTree& tree,
                                       const SpeedDerivatives& derivatives, ExprGraph& graph,
                                       MomentumFrom from);

}  // namespace alembert

// The plain equations: those of the description as it is written, with nothing simplified, placed, regrouped, scaled
// or peeled, in 50 digits. In: a mechanism's kinematics and a state. Out: what its functions are there. All that
// is written is measured against these (certificate.hpp).
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "functions/function_table.hpp"
#include "symbolic/extended.hpp"

namespace alembert {

using VectorXe = Eigen::Matrix<Extended, Eigen::Dynamic, 1>;
using MatrixXe = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

/// What central differences leave of the digits, relative to what is differentiated.
inline const Extended kDifferenceNoise = 1e-20;

class PlainEquations {
 public:
  /// Values of all symbols of the graph.
  using State = std::vector<Extended>;

  /// Mechanism and graph of the kinematics must outlive it.
  explicit PlainEquations(const Kinematics& kinematics);

  /// These values, quaternions of unit length to all digits.
  State state(std::span<const double> values) const;

  /// Q, nv.
  VectorXe forces(const State& state) const;
  /// M v: what the forces gain by rates v of the speeds.
  VectorXe mass_times(State state, const VectorXe& v) const;
  /// c: the forces without rates.
  VectorXe bias(State state) const;
  /// M by composite bodies over the given tree, which is cheaper than by columns.
  MatrixXe mass_matrix(const State& state) const;
  /// M^-1 (tau - c).
  VectorXe accelerations(const State& state) const;
  /// Of f = mu . Q: its derivatives along each speed, by the speeds and by their rates, 3 nv.
  VectorXe weighted_gradient(const State& state) const;

  /// One of those above.
  using Function = VectorXe (PlainEquations::*)(const State& state) const;
  /// A function's derivative along speeds in the ratio v, at constant speeds and rates; and by the speeds.
  VectorXe along_speeds(Function of, const State& state, const VectorXe& v) const;
  VectorXe by_speeds(Function of, const State& state, const VectorXe& v) const;
  /// Those of the accelerations, from the forces that hold them: -M^-1 times the forces' derivatives at constant
  /// accelerations, and M^-1 times forces.
  struct Accelerations {
    VectorXe values, along_speeds, by_speeds, by_forces;
  };
  Accelerations accelerations_along(const State& state, const VectorXe& v, const VectorXe& forces) const;
  /// Roots of M's diagonal over the largest of them: what moves much when a speed is 1. 1 where nothing moves that
  /// double can tell, or M has no value.
  VectorXe inertia(const State& state) const;
  /// The same where others move as the constraints want: the root of what a force along a coordinate moves.
  VectorXe constrained_inertia(const State& state) const;
  /// A function as its builder makes it of the plain equations.
  const std::vector<OutputExpressions>& expressions(FunctionKind kind) const;
  /// Its results, all arrays one after another.
  std::vector<Extended> outputs(FunctionKind kind, const State& state) const;

  /// Nodes that `forces` evaluates: what the others take is a multiple of it.
  std::size_t nodes() const { return forces_.nodes(); }

 private:
  VectorXe tau(const State& state) const;
  void set_rates(State& state, const VectorXe* rates) const;

  Kinematics kinematics_;  ///< without simplification
  ExtendedFunction forces_;
  ExtendedFunction coordinate_rates_;  ///< N, nq x nv
  mutable std::optional<ExtendedFunction> mass_matrix_, weighted_gradient_, rows_;
  mutable std::map<FunctionKind, std::vector<OutputExpressions>> expressions_;
  mutable std::map<FunctionKind, ExtendedFunction> others_;
};

}  // namespace alembert

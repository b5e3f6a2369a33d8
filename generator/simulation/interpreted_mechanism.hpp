// A compiled mechanism as the runtime library sees one (alembert/bound_mechanism.hpp), by the interpreter: so
// the commands integrate and solve by the same algorithms as users of generated code.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "alembert/consistent_state.hpp"
#include "alembert/constrained_dynamics.hpp"
#include "alembert/status.hpp"
#include "mechanism/constraint_rows.hpp"
#include "simulation/dynamics_evaluator.hpp"
#include "simulation/input_table.hpp"

namespace alembert {

/// A System whose sizes are known at run time.
class InterpretedMechanism {
 public:
  using Scalar = double;
  static constexpr int kNq = Eigen::Dynamic, kNv = Eigen::Dynamic, kNc = Eigen::Dynamic, kNs = Eigen::Dynamic;

  /// \param inputs  time, parameters and wrenches; its q and qd are not used
  /// \param table   what inputs are over time, in place of those
  InterpretedMechanism(const CompiledMechanism& compiled, EvaluationState inputs, InputTable table = {});

  int nq() const { return mechanism_.nq; }
  int nv() const { return mechanism_.nv; }
  int nc() const { return static_cast<int>(rows_.size()); }
  double time() const { return state_.t; }
  void set_time(double t) { state_.t = t; }
  /// As in the constructor.
  void set_inputs(const EvaluationState& inputs) { state_ = inputs; }
  /// By M, so that simulation reports what that says of a singular state.
  [[nodiscard]] Status forward_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                                        const Eigen::VectorXd& tau, Eigen::VectorXd& rates) const;
  void mass_matrix_and_bias(const Eigen::VectorXd& q, const Eigen::VectorXd& u, Eigen::MatrixXd& mass,
                            Eigen::VectorXd& c) const;
  /// A row of P that has no value has no gamma, velocity and position either, so that no algorithm mistakes
  /// it for one that depends on others.
  void constraints(const Eigen::VectorXd& q, const Eigen::VectorXd& u, Eigen::MatrixXd& P,
                   Eigen::VectorXd& gamma, Eigen::VectorXd& velocity, Eigen::VectorXd& position) const;
  /// Only where it was compiled.
  void inverse_dynamics_derivatives(const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                                    const Eigen::VectorXd& rates, Eigen::MatrixXd& tau_q,
                                    Eigen::MatrixXd& tau_qd) const;
  Eigen::VectorXd coordinate_rates(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const;
  Eigen::VectorXd states() const;
  void set_states(const Eigen::VectorXd& states);
  Eigen::MatrixXd state_rate_derivatives(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const;
  Eigen::VectorXd state_rates(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const;
  const std::vector<int>& quaternion_offsets() const { return quaternion_offsets_; }
  bool holonomic(int row) const {
    return rows_[static_cast<std::size_t>(row)].type == ConstraintType::holonomic;
  }

  double row_length(int row) const { return mechanism_.row_lengths[static_cast<std::size_t>(row)]; }

  /// Name and constraint of each row.
  const std::vector<ConstraintRow>& rows() const { return rows_; }
  /// time, parameters and wrenches with these q and speeds.
  EvaluationState state(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const;

 private:
  const EvaluationState& at(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const;

  const Mechanism& mechanism_;
  Eigen::Index state_count_;
  std::vector<ConstraintRow> rows_;
  std::vector<int> quaternion_offsets_;
  InputTable table_;
  mutable EvaluationState state_;
  mutable DynamicsEvaluator evaluator_;  // its scratch memory changes
};

/// Functions that must have been compiled for an InterpretedMechanism.
std::vector<FunctionKind> interpreted_functions();

/// Largest violation of the constraints, positions and velocities, and its row; NaN at the first row that has
/// no value.
struct Violation {
  double size = 0;
  int row = -1;
};
Violation worst_violation(const InterpretedMechanism& system, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& u);

}  // namespace alembert

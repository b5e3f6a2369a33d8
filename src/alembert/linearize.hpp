// Forward dynamics to first order. In: a state, forces and a mechanism's derivatives of inverse dynamics.
// Out: the accelerations and what they become as state and forces change. No heap where matrices fit the
// stack (matrix.hpp), no exceptions.
#pragma once

#include "alembert/articulated_solver.hpp"
#include "alembert/axis_state.hpp"
#include "alembert/branch_solver.hpp"
#include "alembert/forward_dynamics.hpp"

namespace alembert {

/// Rates of the speeds and their partial derivatives, n_v x n_v each: along the speeds, that is by the
/// coordinates (by turns about the body's axes for a quaternion, column k as q changes by N(q) e_k), by the
/// speeds, and by the forces.
template <class M>
struct Linearization {
  SpeedVector<M> qdd;
  SpeedMatrix<M> qdd_q, qdd_qd, qdd_tau;
};

namespace detail {

/// Measured: of more speeds, M::forward_dynamics_derivatives is longer and takes longer than solving with M for
/// all columns at once.
inline constexpr int kMostWrittenOut = 4;
template <class M>
inline constexpr bool kLinearizesByWriting = HasForwardDerivatives<M>::value &&
                                             (M::kNv <= kMostWrittenOut || !HasDerivatives<M>::value);

/// Derivatives of inverse dynamics, which stand in the matrices row by row.
template <class M>
void derivatives_by_rows(const CoordinateVector<M>& q, const SpeedVector<M>& qd, const SpeedVector<M>& qdd,
                         const typename M::Inputs& in, SpeedMatrix<M>& tau_q, SpeedMatrix<M>& tau_qd) {
  if constexpr (HasDerivativesByRows<M>::value) {
    M::inverse_dynamics_derivatives(q, qd, qdd, in, tau_q.data(), tau_qd.data());
  } else {
    M::inverse_dynamics_derivatives(q, qd, qdd, in, tau_q, tau_qd);
    tau_q.transposeInPlace();
    tau_qd.transposeInPlace();
  }
}

/// linearize of a tree of axes.
template <class M>
[[nodiscard]] Status linearize_by_axes(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                       const SpeedVector<M>& tau, const typename M::Inputs& in,
                                       Linearization<M>& out) {
  using S = typename M::Scalar;
  using State = AxisState<M>;
  constexpr int N = M::kNv;
  State state(q, qd, in);
  typename State::Square tau_q, tau_qd;
  std::conditional_t<kSolvesByBodies<M>, ArticulatedSolver<M>, BranchSolver<S, typename M::Axes>> solver;
  Status status;
  if constexpr (kSolvesByBodies<M>) {
    status = solver.factor(state.tree());
  } else {
    state.mass_matrix(tau_q);
    status = solver.factor(Eigen::Map<const Eigen::Matrix<S, N, N>>(tau_q.data()));
  }
  if (status != Status::ok) return status;
  SpeedVector<M> qdd;
  status = rates_by_axes<M>(state, solver, tau, qdd);
  if (status != Status::ok) return status;
  state.derivatives(qdd.data(), tau_q, tau_qd);
  status = solver.solve({{tau_q.data(), out.qdd_q.data()}, {tau_qd.data(), out.qdd_qd.data()}},
                        out.qdd_tau.data());
  if (status != Status::ok) return status;
  for (int row = 0; row < N; ++row) out.qdd(State::speed(row)) = qdd(row);
  return Status::ok;
}

}  // namespace detail

/// Linearizes forward dynamics, as if there were no constraints: with qdd = M^-1 (tau - c),
/// d qdd = M^-1 (d tau - tau_q d q - tau_qd d qd), where tau_q and tau_qd are the derivatives of inverse
/// dynamics at this qdd. From 8 speeds on by M::Axes where M has it (axis_tree.hpp), of up to 4 by the generated
/// M::forward_dynamics_derivatives where M has that, otherwise by M::inverse_dynamics_derivatives, for all
/// right-hand sides at once.
///
/// \param q    coordinates, n_q x 1
/// \param qd   speeds, n_v x 1
/// \param tau  generalized forces, n_v x 1
/// \param in   time, runtime parameters, external wrenches
/// \param out  result; left as it was unless the status is ok
/// \return     ok, or why there is no result, as of forward_dynamics
template <class M>
[[nodiscard]] Status linearize(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                               const SpeedVector<M>& tau, const typename M::Inputs& in,
                               Linearization<M>& out) {
  static_assert(is_mechanism_v<M>,
                "generate M with mass_matrix_and_bias and coordinate_rates (alembert/mechanism.hpp)");
  static_assert(detail::kByAxes<M> || has_derivatives_v<M> || detail::HasForwardDerivatives<M>::value,
                "generate M with inverse_dynamics_derivatives or forward_dynamics_derivatives");
  if constexpr (detail::kByAxes<M>) {
    if (!detail::is_finite_state(in.t, q, qd)) return Status::not_finite;
    return detail::linearize_by_axes<M>(q, qd, tau, in, out);
  } else if constexpr (detail::kLinearizesByWriting<M>) {
    Linearization<M> result;
    if (const Status status = forward_dynamics<M>(q, qd, tau, in, result.qdd); status != Status::ok)
      return status;
    M::forward_dynamics_derivatives(q, qd, tau, in, result.qdd_q, result.qdd_qd, result.qdd_tau);
    for (const SpeedMatrix<M>* X : {&result.qdd_q, &result.qdd_qd, &result.qdd_tau})
      if (!detail::all_finite(*X)) return Status::not_finite;
    out = result;
  } else {
    if (!detail::is_finite_state(in.t, q, qd)) return Status::not_finite;
    SpeedMatrix<M> tau_q, tau_qd;
    SpeedMatrix<M>& mass = tau_q;
    SpeedVector<M> qdd;
    M::mass_matrix_and_bias(q, qd, in, mass, qdd);
    detail::BranchSolver<typename M::Scalar, detail::SpeedTree<M>> solver;
    if (const Status status = solver.factor(mass); status != Status::ok) return status;
    qdd = tau - qdd;
    solver.solve(qdd);
    if (!detail::all_finite(qdd)) return Status::not_finite;
    detail::derivatives_by_rows<M>(q, qd, qdd, in, tau_q, tau_qd);
    if (const Status status = solver.solve(
            {{tau_q.data(), out.qdd_q.data()}, {tau_qd.data(), out.qdd_qd.data()}}, out.qdd_tau.data());
        status != Status::ok)
      return status;
    out.qdd = qdd;
  }
  return Status::ok;
}

}  // namespace alembert

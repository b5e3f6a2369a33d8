// Derivatives of inverse dynamics the fastest way that a mechanism has. In: a state and accelerations. Out: matrices and
// a status. No heap where matrices fit the stack (matrix.hpp), no exceptions.
#pragma once

#include "alembert/axis_state.hpp"
#include "alembert/column_solver.hpp"
#include "alembert/floating_point.hpp"
#include "alembert/mechanism.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {

template <class M>
[[nodiscard]] Status derivatives_by_axes(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                         const SpeedVector<M>& qdd, const typename M::Inputs& in,
                                         SpeedMatrix<M>& tau_q, SpeedMatrix<M>& tau_qd) {
  using State = AxisState<M>;
  State state(q, qd, in);
  typename State::Rows rates;
  for (int row = 0; row < M::kNv; ++row) rates(row) = qdd(State::speed(row));
  typename State::Square along, by_speed;
  state.derivatives(rates.data(), along, by_speed);
  constexpr auto kEntries = static_cast<std::size_t>(M::kNv) * M::kNv;
  for (const auto* rows : {&along, &by_speed})
    if (!all_finite(kEntries, rows->data())) return Status::not_finite;
  store_by_speeds<typename M::Axes>(along.data(), tau_q.data());
  store_by_speeds<typename M::Axes>(by_speed.data(), tau_qd.data());
  return Status::ok;
}

}  // namespace detail

/// Partial derivatives of inverse dynamics, along the speeds and by the speeds, at constant rates qdd: by M::Axes where
/// M has it and 8 speeds or more (axis_tree.hpp), otherwise by the generated M::inverse_dynamics_derivatives.
///
/// \param q, qd, qdd    coordinates, n_q x 1; speeds and their rates, n_v x 1
/// \param in            time, runtime parameters, external wrenches
/// \param tau_q, tau_qd n_v x n_v: column k is the derivative by coordinate k (of a quaternion, by a turn about an axis
///                      of its body), or by speed k; left as they were unless the status is ok
/// \return              ok; not_finite
template <class M>
[[nodiscard]] Status inverse_dynamics_derivatives(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                                  const SpeedVector<M>& qdd, const typename M::Inputs& in,
                                                  SpeedMatrix<M>& tau_q, SpeedMatrix<M>& tau_qd) {
  static_assert(is_mechanism_v<M>,
                "generate M with mass_matrix_and_bias and coordinate_rates (alembert/mechanism.hpp)");
  static_assert(detail::kByAxes<M> || has_derivatives_v<M>, "generate M with inverse_dynamics_derivatives");
  if (!detail::is_finite_state(in.t, q, qd) || !detail::all_finite(qdd)) return Status::not_finite;
  if constexpr (detail::kByAxes<M>) {
    return detail::derivatives_by_axes<M>(q, qd, qdd, in, tau_q, tau_qd);
  } else {
    SpeedMatrix<M> along, by_speed;
    M::inverse_dynamics_derivatives(q, qd, qdd, in, along, by_speed);
    if (!detail::all_finite(along) || !detail::all_finite(by_speed)) return Status::not_finite;
    tau_q = along;
    tau_qd = by_speed;
    return Status::ok;
  }
}

}  // namespace alembert

// Dynamics of a frame as a force at it feels them (operational space). In: a mechanism, a frame and a state. Out: the
// inertia of the frame, the dynamically consistent inverse of its Jacobian and what its acceleration takes without a
// force, or a status that says why there are none. No heap where matrices fit the stack (matrix.hpp), no exceptions.
//
// With a = J du/dt + (frame_bias_accelerations) the acceleration of the frame and tau = J^T F,
//
//   Lambda a + mu = F,   Lambda^-1 = J M^-1 J^T,   Jbar = M^-1 J^T Lambda,   mu = Jbar^T c - Lambda (frame_bias_accelerations)
//
// O. Khatib, A unified approach for motion and force control of robot manipulators, IEEE Journal of Robotics and
// Automation 3 (1987).
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "alembert/forward_dynamics.hpp"

namespace alembert {

/// Which motions of a frame are meant: all six, angular first, or three of them; world axes.
enum class Task { pose, rotation, position };

/// What operational_space finds; R is the number of motions, 6 or 3.
template <class S, int Nv, int R>
struct OperationalSpaceOf {
  Eigen::Matrix<S, R, Nv> J;               ///< Jacobian: rows of frame_jacobians
  Eigen::Matrix<S, R, R> inverse_inertia;  ///< Lambda^-1: the acceleration that a force gives
  Eigen::Matrix<S, R, R> inertia;          ///< Lambda
  /// Speeds that give the frame a velocity with the least kinetic energy; J Jbar = 1. Forces (1 - J^T Jbar^T) tau do not
  /// accelerate the frame.
  Eigen::Matrix<S, Nv, R> Jbar;
  Eigen::Matrix<S, R, 1> bias;  ///< mu: the force that the frame takes to be without acceleration
};
template <class M, Task task = Task::pose>
using OperationalSpace = OperationalSpaceOf<typename M::Scalar, M::kNv, task == Task::pose ? 6 : 3>;

namespace detail {

template <class M, class = void>
struct HasFrameAccelerations : std::false_type {};

template <class M>
struct HasFrameAccelerations<
    M, std::void_t<decltype(M::frame_jacobians(std::declval<const CoordinateVector<M>&>(),
                                               std::declval<const typename M::Inputs&>())[0]),
                   decltype(M::frame_bias_accelerations(
                       std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
                       std::declval<const typename M::Inputs&>()))>> : std::true_type {};

template <class M, class = void>
struct HasMassMatrixInverse : std::false_type {};

template <class M>
struct HasMassMatrixInverse<
    M, std::void_t<decltype(SpeedMatrix<M>(M::mass_matrix_inverse(
           std::declval<const CoordinateVector<M>&>(), std::declval<const typename M::Inputs&>())))>>
    : std::true_type {};

/// X = M^-1 X, given c beside it: by the generated inverse of M where there is one. Spoils `mass`.
template <class M, class Columns>
[[nodiscard]] Status solve_for_columns(const CoordinateVector<M>& q, const typename M::Inputs& in,
                                       SpeedMatrix<M>& mass, Columns& X) {
  if (!all_finite(mass)) return Status::not_finite;
  if constexpr (HasMassMatrixInverse<M>::value) {
    mass = M::mass_matrix_inverse(q, in);
    if (!all_finite(mass)) return Status::not_positive_definite;
    X = (mass * X).eval();
  } else {
    if (const Status status = factor_ldlt(mass); status != Status::ok) return status;
    for (int k = 0; k < static_cast<int>(X.cols()); ++k) {
      SpeedVector<M> x = X.col(k);
      solve_ldlt(mass, x);
      X.col(k) = x;
    }
  }
  return all_finite(X) ? Status::ok : Status::not_finite;
}

}  // namespace detail

/// True if M also has frame_jacobians and frame_bias_accelerations: generate it with these functions.
template <class M>
inline constexpr bool has_frame_accelerations_v = is_mechanism_v<M>&& detail::HasFrameAccelerations<M>::value;

/// Inertia, consistent inverse and bias of a frame, as if there were no constraints. Takes the generated
/// mass_matrix_inverse where M has it.
///
/// \tparam task  the motions that are meant: with fewer speeds than motions, or where the frame cannot move in all of
///               these ways, Lambda does not exist
/// \param frame  index of the frame, say M::Frame::gripper
/// \param q      coordinates, n_q x 1
/// \param qd     speeds, n_v x 1
/// \param in     time, runtime parameters, external wrenches (which are in the bias, as gravity is)
/// \param out    result; left as it was unless the status is ok
/// \return       ok; not_finite; not_positive_definite: M is singular, or Lambda^-1 is at this state
template <class M, Task task = Task::pose>
[[nodiscard]] Status operational_space(int frame, const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                       const typename M::Inputs& in, OperationalSpace<M, task>& out) {
  static_assert(has_frame_accelerations_v<M>, "generate M with frame_jacobians and frame_bias_accelerations");
  using Result = OperationalSpace<M, task>;
  constexpr int rows = task == Task::pose ? 6 : 3, first = task == Task::position ? 3 : 0;
  if (!detail::is_finite_state(in.t, q, qd)) return Status::not_finite;
  SpeedMatrix<M> mass;
  SpeedVector<M> c;
  M::mass_matrix_and_bias(q, qd, in, mass, c);
  Result result;
  result.J = M::frame_jacobians(q, in)[static_cast<std::size_t>(frame)].template middleRows<rows>(first);
  result.Jbar = result.J.transpose();
  if (const Status status = detail::solve_for_columns<M>(q, in, mass, result.Jbar); status != Status::ok)
    return status;
  result.inverse_inertia = result.J * result.Jbar;
  Eigen::Matrix<typename M::Scalar, rows, rows> factor = result.inverse_inertia;
  if (const Status status = factor_ldlt(factor); status != Status::ok) return status;
  for (int k = 0; k < rows; ++k) {
    Eigen::Matrix<typename M::Scalar, rows, 1> x = Eigen::Matrix<typename M::Scalar, rows, 1>::Unit(k);
    solve_ldlt(factor, x);
    result.inertia.col(k) = x;
  }
  result.Jbar = (result.Jbar * result.inertia).eval();
  const auto accelerations = M::frame_bias_accelerations(q, qd, in);
  result.bias =
      result.Jbar.transpose() * c - result.inertia * accelerations.template segment<rows>(6 * frame + first);
  if (!detail::all_finite(result.inertia) || !detail::all_finite(result.Jbar) ||
      !detail::all_finite(result.bias))
    return Status::not_finite;
  out = result;
  return Status::ok;
}

}  // namespace alembert

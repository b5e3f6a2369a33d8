// What the runtime library asks of a mechanism. In: a stateless type, as the generator writes one. Out: a
// trait (C++17) and a concept (C++20) that say whether the type will do, and short names for its vectors.
//
// A mechanism M with n_q coordinates q and n_v speeds u has
//   M::Scalar, M::Inputs                     scalar type; time `t`, runtime parameters and external wrenches
//   M::kNq, M::kNv                           sizes of q and u
//   M::kQuaternionOffsets                    std::array<int, k>: where in q unit quaternions (x y z w) start
//   M::mass_matrix_and_bias(q, u, in, M, c)  M(q) and c(q, u) of  tau = M(q) du/dt + c(q, u)
//   M::coordinate_rates(q, u)                dq/dt = N(q) u
// and, optionally,
//   M::kSpeedParents                         std::array<int, n_v>: of each speed the last one before it to which
//                                            M(q) or its factor L, M(q) = L^T D L, ties it, or -1: entries
//                                            between branches are not read. Without it all are.
//   M::SpeedParentsOf                        M itself. A type that derives from it inherits another's name, and
//                                            with that not its branches: it may add to M(q).
//   M::Axes                                  where each speed turns or slides one frame about or along an axis
//                                            fixed in it: axis_tree.hpp; M::Axes::Of is M itself
//   M::energy(q, u, in)                      kinetic and potential energy
//   M::forward_dynamics(q, u, tau, in)       du/dt without checks
//   M::forward_dynamics_derivatives(q, u, tau, in, qdd_q, qdd_qd, qdd_tau)
//                                            derivatives of du/dt along the speeds, by the speeds and by tau
// and, with n_s states besides q and u (those under `states` in its description),
//   M::kNstates, M::state_rates(q, u, in)    n_s; ds/dt, s being the last n_s entries of in.parameters
//   M::state_rates_derivatives(q, u, in, r_q, r_qd, r_s)
//                                            for implicit steps: along and by the speeds, and by the states
//   M::inverse_dynamics_derivatives(q, u, du/dt, in, tau_q, tau_qd)
//                                            derivatives of tau along the speeds and by the speeds, n_v x n_v
// and, with n_c rows of constraints on its motion,
//   M::kNc, M::kHolonomic                    n_c; std::array<bool, n_c>: rows that bind the coordinates
//   M::ConstraintMatrix, M::ConstraintVector n_c x n_v and n_c x 1
//   M::constraints(q, u, in, P, gamma, velocity, position)
//                                            velocity = P u + (part from time) and position must be zero; the
//                                            rate of velocity is P du/dt + gamma
//   M::kRowLengths                           optional, std::array<double, n_c>: constraint_factorization.hpp
// and then tau + P^T lambda = M du/dt + c, with lambda the reactions.
//
// Matrices are SizedMatrix of matrix.hpp: those of Eigen with fixed sizes, unless they are too large for the
// stack.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "alembert/matrix.hpp"

namespace alembert {

/// Coordinates of M: n_q x 1.
template <class M>
using CoordinateVector = Eigen::Matrix<typename M::Scalar, M::kNq, 1>;

/// Speeds of M, their rates, or generalized forces: n_v x 1.
template <class M>
using SpeedVector = Eigen::Matrix<typename M::Scalar, M::kNv, 1>;

/// Mass matrix of M: n_v x n_v.
template <class M>
using SpeedMatrix = SizedMatrix<typename M::Scalar, M::kNv, M::kNv>;

namespace detail {

template <class M, class = void>
struct IsMechanism : std::false_type {};

template <class M>
struct IsMechanism<
    M, std::void_t<typename M::Scalar, typename M::Inputs, decltype(std::declval<typename M::Inputs&>().t),
                   decltype(M::kQuaternionOffsets.size()),
                   decltype(M::mass_matrix_and_bias(
                       std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
                       std::declval<const typename M::Inputs&>(), std::declval<SpeedMatrix<M>&>(),
                       std::declval<SpeedVector<M>&>())),
                   decltype(CoordinateVector<M>(M::coordinate_rates(
                       std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>())))>>
    : std::bool_constant<(M::kNv > 0 && M::kNq >= M::kNv)> {};

template <class M, class = void>
struct HasEnergy : std::false_type {};

template <class M>
struct HasEnergy<M, std::void_t<decltype(M::energy(
                        std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
                        std::declval<const typename M::Inputs&>())[1])>> : std::true_type {};

template <class M, class = void>
struct StateCount : std::integral_constant<int, 0> {};

template <class M>
struct StateCount<M, std::void_t<decltype(M::kNstates)>> : std::integral_constant<int, M::kNstates> {};

template <class M, class = void>
struct HasStateRates : std::false_type {};

template <class M>
struct HasStateRates<M, std::void_t<decltype(M::state_rates(
                            std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
                            std::declval<const typename M::Inputs&>()))>> : std::true_type {};

template <class M, class = void>
struct HasStateRatesDerivatives : std::false_type {};

template <class M>
struct HasStateRatesDerivatives<
    M, std::void_t<decltype(M::state_rates_derivatives(
           std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
           std::declval<const typename M::Inputs&>(),
           std::declval<Eigen::Matrix<typename M::Scalar, M::kNstates, M::kNv>&>(),
           std::declval<Eigen::Matrix<typename M::Scalar, M::kNstates, M::kNv>&>(),
           std::declval<Eigen::Matrix<typename M::Scalar, M::kNstates, M::kNstates>&>()))>> : std::true_type {
};

template <class M, class = void>
struct HasDerivatives : std::false_type {};

template <class M>
struct HasDerivatives<M,
                      std::void_t<decltype(M::inverse_dynamics_derivatives(
                          std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
                          std::declval<const SpeedVector<M>&>(), std::declval<const typename M::Inputs&>(),
                          std::declval<SpeedMatrix<M>&>(), std::declval<SpeedMatrix<M>&>()))>>
    : std::true_type {};

/// What instructions take several of.
template <class S>
inline constexpr bool is_machine_number_v = std::is_same_v<S, double> || std::is_same_v<S, float>;

/// Whether M has a struct Axes of its own, which names it; a type that derives from M may add to its forces.
template <class M, class = void>
struct HasAxes : std::false_type {};

template <class M>
struct HasAxes<M, std::enable_if_t<std::is_same_v<typename M::Axes::Of, M>>>
    : std::bool_constant<is_machine_number_v<typename M::Scalar>> {};

/// Measured: of fewer speeds, generated M, c and derivatives take as long.
inline constexpr int kFewestByAxes = 8;
template <class M>
inline constexpr bool kByAxes = HasAxes<M>::value&& M::kNv >= kFewestByAxes;

/// Which speed carries which: of a mechanism that does not say, each the next.
template <class M, class = void>
struct SpeedTree {
  static constexpr std::array<int, static_cast<std::size_t>(M::kNv)> chain() {
    std::array<int, static_cast<std::size_t>(M::kNv)> out{};
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = static_cast<int>(k) - 1;
    return out;
  }
  static constexpr auto kParents = chain();
};
template <class M>
struct SpeedTree<M, std::enable_if_t<std::is_same_v<typename M::SpeedParentsOf, M>>> {
  static constexpr auto kParents = M::kSpeedParents;
};

template <class M, class = void>
struct HasDerivativesByRows : std::false_type {};

template <class M>
struct HasDerivativesByRows<
    M, std::void_t<decltype(M::inverse_dynamics_derivatives(
           std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
           std::declval<const SpeedVector<M>&>(), std::declval<const typename M::Inputs&>(),
           std::declval<typename M::Scalar*>(), std::declval<typename M::Scalar*>()))>> : std::true_type {};

template <class M, class = void>
struct HasForwardDynamics : std::false_type {};

template <class M>
struct HasForwardDynamics<
    M, std::void_t<decltype(SpeedVector<M>(M::forward_dynamics(
           std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
           std::declval<const SpeedVector<M>&>(), std::declval<const typename M::Inputs&>())))>>
    : std::true_type {};

template <class M, class = void>
struct HasForwardDerivatives : std::false_type {};

template <class M>
struct HasForwardDerivatives<
    M,
    std::void_t<decltype(M::forward_dynamics_derivatives(
        std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
        std::declval<const SpeedVector<M>&>(), std::declval<const typename M::Inputs&>(),
        std::declval<SpeedMatrix<M>&>(), std::declval<SpeedMatrix<M>&>(), std::declval<SpeedMatrix<M>&>()))>>
    : std::true_type {};

/// Runtime parameters, inputs and states.
template <class Inputs, class = void>
struct ParameterCount : std::integral_constant<std::size_t, 0> {};

template <class Inputs>
struct ParameterCount<Inputs, std::void_t<decltype(std::declval<Inputs&>().parameters)>>
    : std::tuple_size<decltype(Inputs::parameters)> {};

/// Runtime parameters alone, on which masses may depend: no inputs, no states.
template <class M, class = void>
struct RuntimeParameterCount : ParameterCount<typename M::Inputs> {};

template <class M>
struct RuntimeParameterCount<M, std::void_t<decltype(M::kNparameters)>>
    : std::integral_constant<std::size_t, static_cast<std::size_t>(M::kNparameters)> {};

template <class M, class = void>
struct ConstraintCount : std::integral_constant<int, 0> {};

template <class M>
struct ConstraintCount<M, std::void_t<decltype(M::kNc)>> : std::integral_constant<int, M::kNc> {};

template <class M, class = void>
struct HasConstraints : std::false_type {};

template <class M>
struct HasConstraints<
    M, std::void_t<
           typename M::ConstraintMatrix, typename M::ConstraintVector, decltype(M::kHolonomic[0]),
           decltype(M::constraints(
               std::declval<const CoordinateVector<M>&>(), std::declval<const SpeedVector<M>&>(),
               std::declval<const typename M::Inputs&>(), std::declval<typename M::ConstraintMatrix&>(),
               std::declval<typename M::ConstraintVector&>(), std::declval<typename M::ConstraintVector&>(),
               std::declval<typename M::ConstraintVector&>()))>> : std::bool_constant<(M::kNc > 0)> {};

template <class M, class = void>
struct HasRowLengths : std::false_type {};

template <class M>
struct HasRowLengths<M, std::void_t<decltype(M::kRowLengths[0])>> : std::true_type {};

/// A vector of zeros, or an empty one where the size is Eigen::Dynamic.
template <class Vector>
Vector cleared() {
  if constexpr (Vector::SizeAtCompileTime == Eigen::Dynamic)
    return Vector();
  else
    return Vector::Zero();
}

}  // namespace detail

/// Rows of constraints of M: n_c x 1, and n_c x n_v.
template <class M>
using ConstraintVector = Eigen::Matrix<typename M::Scalar, detail::ConstraintCount<M>::value, 1>;
template <class M>
using ConstraintMatrix = SizedMatrix<typename M::Scalar, detail::ConstraintCount<M>::value, M::kNv>;

/// True if M has all that is listed at the top of this file.
template <class M>
inline constexpr bool is_mechanism_v = detail::IsMechanism<M>::value;

/// True if M also has `energy`.
template <class M>
inline constexpr bool has_energy_v = is_mechanism_v<M>&& detail::HasEnergy<M>::value;

/// True if M also has inverse_dynamics_derivatives: generate it with this function.
template <class M>
inline constexpr bool has_derivatives_v = is_mechanism_v<M>&& detail::HasDerivatives<M>::value;

/// True if M also has `constraints` and all that goes with them.
template <class M>
inline constexpr bool has_constraints_v = is_mechanism_v<M>&& detail::HasConstraints<M>::value;

#if defined(__cpp_concepts) && __cpp_concepts >= 201907L
/// The same as is_mechanism_v, for constraining templates.
template <class M>
concept MechanismType = is_mechanism_v<M>;
#endif

}  // namespace alembert

// A mechanism together with its inputs, as the algorithms of the runtime see it. In: a mechanism's type and
// time, runtime parameters and wrenches. Out: one interface for M, c, the rates of the coordinates and the
// constraints, whether the sizes are known when compiling or not.
//
// The algorithms take any `System` with
//   System::Scalar, kNq, kNv, kNc, kNs scalar type and sizes; Eigen::Dynamic where not known when compiling
//   nq(), nv(), nc()                   the sizes
//   time(), set_time(t)                s
//   mass_matrix_and_bias(q, u, M, c)   as in mechanism.hpp
//   forward_dynamics(q, u, tau, rates) du/dt without constraints, or a status (forward_dynamics.hpp)
//   constraints(q, u, P, gamma, velocity, position)   likewise; called only where nc() > 0
//   coordinate_rates(q, u)             N(q) u
//   states(), set_states(s)            the states besides q and u, kNs x 1
//   state_rates(q, u)                  ds/dt
//   state_rate_derivatives(q, u)       of these by the states; called only by implicit steps
//   inverse_dynamics_derivatives(q, u, rates, tau_q, tau_qd)   as in mechanism.hpp; called only by implicit steps
//   quaternion_offsets()               a range of indices into q: where the unit quaternions start
//   holonomic(row)                     whether a row of the constraints binds the coordinates
//   row_length(row)                    its length (constraint_factorization.hpp)
#pragma once

#include <type_traits>

#include "alembert/forward_dynamics.hpp"
#include "alembert/mechanism.hpp"

namespace alembert {

/// A generated mechanism M and its inputs: the System of that mechanism.
template <class M>
class BoundMechanism {
 public:
  static_assert(is_mechanism_v<M>,
                "generate M with mass_matrix_and_bias and coordinate_rates (alembert/mechanism.hpp)");
  using Scalar = typename M::Scalar;
  static constexpr int kNq = M::kNq, kNv = M::kNv;
  static constexpr int kNc = has_constraints_v<M> ? detail::ConstraintCount<M>::value : 0;
  static constexpr int kNs = detail::StateCount<M>::value;
  using StateVector = Eigen::Matrix<Scalar, kNs, 1>;

  /// \param in  kept by reference; set_time and set_states change it
  explicit BoundMechanism(typename M::Inputs& in) : in_(in) {}

  static constexpr int nq() { return kNq; }
  static constexpr int nv() { return kNv; }
  static constexpr int nc() { return kNc; }
  Scalar time() const { return in_.t; }
  void set_time(Scalar t) { in_.t = t; }
  void mass_matrix_and_bias(const CoordinateVector<M>& q, const SpeedVector<M>& u, SpeedMatrix<M>& mass,
                            SpeedVector<M>& c) const {
    M::mass_matrix_and_bias(q, u, in_, mass, c);
  }
  [[nodiscard]] Status forward_dynamics(const CoordinateVector<M>& q, const SpeedVector<M>& u,
                                        const SpeedVector<M>& tau, SpeedVector<M>& rates) const {
    return alembert::forward_dynamics<M>(q, u, tau, in_, rates);
  }
  CoordinateVector<M> coordinate_rates(const CoordinateVector<M>& q, const SpeedVector<M>& u) const {
    return M::coordinate_rates(q, u);
  }
  StateVector states() const {
    StateVector s;
    if constexpr (kNs > 0)
      for (int i = 0; i < kNs; ++i) s(i) = in_.parameters[first_state() + static_cast<unsigned>(i)];
    return s;
  }
  void set_states([[maybe_unused]] const StateVector& s) {
    if constexpr (kNs > 0)
      for (int i = 0; i < kNs; ++i) in_.parameters[first_state() + static_cast<unsigned>(i)] = s(i);
  }
  StateVector state_rates([[maybe_unused]] const CoordinateVector<M>& q,
                          [[maybe_unused]] const SpeedVector<M>& u) const {
    if constexpr (kNs > 0) {
      static_assert(detail::HasStateRates<M>::value, "M has states: generate it with state_rates");
      return M::state_rates(q, u, in_);
    } else {
      return {};
    }
  }
  Eigen::Matrix<Scalar, kNs, kNs> state_rate_derivatives([[maybe_unused]] const CoordinateVector<M>& q,
                                                         [[maybe_unused]] const SpeedVector<M>& u) const {
    Eigen::Matrix<Scalar, kNs, kNs> by_states;
    if constexpr (kNs > 0) {
      static_assert(detail::HasStateRatesDerivatives<M>::value,
                    "M has states: generate it with state_rates_derivatives");
      Eigen::Matrix<Scalar, kNs, kNv> along, by_speeds;
      M::state_rates_derivatives(q, u, in_, along, by_speeds, by_states);
    }
    return by_states;
  }
  template <class Matrix>
  void inverse_dynamics_derivatives(const CoordinateVector<M>& q, const SpeedVector<M>& u,
                                    const SpeedVector<M>& rates, Matrix& tau_q, Matrix& tau_qd) const {
    M::inverse_dynamics_derivatives(q, u, rates, in_, tau_q, tau_qd);
  }
  template <class Matrix, class Vector>
  void constraints(const CoordinateVector<M>& q, const SpeedVector<M>& u, Matrix& P, Vector& gamma,
                   Vector& velocity, Vector& position) const {
    if constexpr (std::is_same_v<Matrix, typename M::ConstraintMatrix>) {
      M::constraints(q, u, in_, P, gamma, velocity, position);
    } else {
      typename M::ConstraintMatrix rows;
      M::constraints(q, u, in_, rows, gamma, velocity, position);
      P = rows;
    }
  }
  static constexpr auto quaternion_offsets() { return M::kQuaternionOffsets; }
  static constexpr bool holonomic(int row) { return M::kHolonomic[static_cast<std::size_t>(row)]; }
  static constexpr Scalar row_length([[maybe_unused]] int row) {
    if constexpr (detail::HasRowLengths<M>::value)
      return Scalar(M::kRowLengths[static_cast<std::size_t>(row)]);
    else
      return Scalar(1);
  }

 private:
  auto first_state() const { return in_.parameters.size() - static_cast<unsigned>(kNs); }

  typename M::Inputs& in_;
};

namespace detail {

/// row_length of all rows.
template <class System>
Eigen::Matrix<typename System::Scalar, System::kNc, 1> row_lengths(const System& system) {
  Eigen::Matrix<typename System::Scalar, System::kNc, 1> lengths(system.nc());
  for (int row = 0; row < system.nc(); ++row) lengths(row) = system.row_length(row);
  return lengths;
}

}  // namespace detail

}  // namespace alembert

// Energy of a mechanism. In: a state. Out: kinetic and potential energy in joules, and if asked for a status.
#pragma once

#include "alembert/mechanism.hpp"
#include "alembert/status.hpp"

namespace alembert {

/// Kinetic and potential energy, J. Potential energy is that of gravity, zero where the centres of mass are
/// at the world's origin.
template <class S>
struct Energy {
  S kinetic;
  S potential;
  constexpr S total() const { return kinetic + potential; }
};

/// Energy at a state: kinetic 1/2 sum m |v|^2 + w^T J w over the bodies, potential -sum m g^T r.
///
/// \param q   coordinates, n_q x 1
/// \param qd  speeds, n_v x 1
/// \param in  time, runtime parameters (external wrenches have no energy)
/// \return    not finite where an argument is not or a product overflows; the function with a status tells
template <class M>
Energy<typename M::Scalar> energy(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                  const typename M::Inputs& in) {
  static_assert(has_energy_v<M>, "M has no function energy: generate it with the mechanism");
  const auto e = M::energy(q, qd, in);
  return {e[0], e[1]};
}

/// The same with a status: ok, or not_finite, and then `out` is left as it was.
template <class M>
[[nodiscard]] Status energy(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                            const typename M::Inputs& in, Energy<typename M::Scalar>& out) {
  if (!detail::is_finite_state(in.t, q, qd)) return Status::not_finite;
  const Energy<typename M::Scalar> e = energy<M>(q, qd, in);
  if (!detail::is_finite(e.kinetic) || !detail::is_finite(e.potential)) return Status::not_finite;
  out = e;
  return Status::ok;
}

/// Kinetic energy by the mass matrix, 1/2 u^T M(q) u: the whole of it where no motion is prescribed in time.
/// Not finite where an argument is not or a product overflows.
template <class M>
typename M::Scalar kinetic_energy(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                  const typename M::Inputs& in) {
  using S = typename M::Scalar;
  static_assert(is_mechanism_v<M>,
                "generate M with mass_matrix_and_bias and coordinate_rates (alembert/mechanism.hpp)");
  SpeedMatrix<M> mass;
  SpeedVector<M> c;
  M::mass_matrix_and_bias(q, qd, in, mass, c);
  S sum(0);
  for (int i = 0; i < M::kNv; ++i)
    for (int j = 0; j < M::kNv; ++j) sum += qd(i) * mass(i, j) * qd(j);
  return S(0.5) * sum;
}

/// The same with a status: ok, or not_finite, and then `out` is left as it was.
template <class M>
[[nodiscard]] Status kinetic_energy(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                    const typename M::Inputs& in, typename M::Scalar& out) {
  if (!detail::is_finite_state(in.t, q, qd)) return Status::not_finite;
  const typename M::Scalar e = kinetic_energy<M>(q, qd, in);
  if (!detail::is_finite(e)) return Status::not_finite;
  out = e;
  return Status::ok;
}

}  // namespace alembert

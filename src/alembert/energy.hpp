// Energy of a mechanism. In: a state. Out: kinetic and potential energy in joules.
#pragma once

#include "alembert/mechanism.hpp"

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
template <class M>
Energy<typename M::Scalar> energy(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                  const typename M::Inputs& in) {
  static_assert(has_energy_v<M>, "M has no function energy: generate it with the mechanism");
  const auto e = M::energy(q, qd, in);
  return {e[0], e[1]};
}

/// Kinetic energy by the mass matrix, 1/2 u^T M(q) u: the whole of it where no motion is prescribed in time.
template <class M>
typename M::Scalar kinetic_energy(const CoordinateVector<M>& q, const SpeedVector<M>& qd,
                                  const typename M::Inputs& in) {
  using S = typename M::Scalar;
  static_assert(is_mechanism_v<M>, "M lacks something that alembert/mechanism.hpp asks for");
  SpeedMatrix<M> mass;
  SpeedVector<M> c;
  M::mass_matrix_and_bias(q, qd, in, mass, c);
  S sum(0);
  for (int i = 0; i < M::kNv; ++i)
    for (int j = 0; j < M::kNv; ++j) sum += qd(i) * mass(i, j) * qd(j);
  return S(0.5) * sum;
}

}  // namespace alembert

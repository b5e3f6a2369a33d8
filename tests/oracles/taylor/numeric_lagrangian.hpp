// A mechanism and a state in; tau, M and c out, by d'Alembert's principle on numbers. Transforms are
// evaluated as they are written, on jets along the motion; no joint, twist, recursion or formula of the
// generator is shared.
#pragma once

#include "oracles/state.hpp"

namespace alembert::oracles {

/// tau_k = sum over bodies of  (m (a - g) - f) . dv/du_k + (I al + om x I om - R^T tau_ext) . dom/du_k;
/// M_kl = sum of  m dv/du_k . dv/du_l + dom/du_k . I dom/du_l;  c = tau at zero rates.
Dynamics numeric_lagrangian(const Description& description, const State& state);

/// Kinetic and potential energy (potential zero at the world's origin).
std::pair<double, double> energy(const Description& description, const State& state);

}  // namespace alembert::oracles

// Forward dynamics under constraints on numbers, and its derivatives by jets.
#pragma once

#include "oracles/taylor/numeric_functions.hpp"

namespace alembert::oracles {

/// qdd and lambda. A row that, to rounding in double precision, follows from those before it has lambda = 0.
template <class R>
Arrays constrained_functions(const Description& description, const State& state,
                             const DynamicsOf<R>& dynamics);

/// qdd_q, qdd_qd, qdd_tau, lambda_q, lambda_qd, lambda_tau: of the rows that have a lambda.
template <class R>
Arrays constrained_derivatives(const Description& description, const State& state,
                               const DynamicsOf<R>& dynamics);

}  // namespace alembert::oracles

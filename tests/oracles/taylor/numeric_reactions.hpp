// What joints carry, on numbers: Newton's and Euler's equations of each body in world axes, and sums over all bodies
// that hang on a joint.
#pragma once

#include "oracles/state.hpp"

namespace alembert::oracles {

/// By body, what its parent exerts on it with the state's rates: moment about the origin of its frame and force, in
/// its axes, 6 a row.
template <class R>
MatrixOf<R> numeric_reactions(const Description& description, const State& state);

}  // namespace alembert::oracles

// Derivatives of the forces of inverse dynamics beyond the first: second ones, summed with weights, and those by
// runtime parameters.
#pragma once

#include <map>
#include <string>

#include "oracles/state.hpp"

namespace alembert::oracles {

/// What the generalized force of each speed counts in sums.
std::vector<double> force_weights(int nv);

/// Of f = sum of weights and forces: twice along the speeds (a row for the first), along a speed and by one, by two, and
/// along a speed and by a rate. By second derivatives of jets along one speed and along two at once.
template <class R>
std::map<std::string, Eigen::MatrixXd> second_derivatives_of_forces(const Description& description,
                                                                    const State& state);

/// A column for each runtime parameter, by differences of mechanisms with other values in long double, extrapolated to none.
Eigen::MatrixXd parameter_derivatives_of_forces(const Description& description, const State& state);

}  // namespace alembert::oracles

// Where runtime parameters, inputs and states stand in the array of parameters. In: a mechanism and a role. Out: those of
// the role, in order.
#pragma once

#include <cstddef>
#include <vector>

#include "mechanism/model.hpp"

namespace alembert {

struct PlacedParameter {
  const Parameter& parameter;
  std::size_t place;  ///< in the array of parameters
};

inline std::vector<PlacedParameter> placed_parameters(const Mechanism& mechanism, ParameterRole role) {
  std::vector<PlacedParameter> found;
  std::size_t place = 0;
  for (const Parameter& parameter : mechanism.parameters) {
    if (!parameter.runtime) continue;
    if (parameter.role == role) found.push_back({parameter, place});
    ++place;
  }
  return found;
}

}  // namespace alembert

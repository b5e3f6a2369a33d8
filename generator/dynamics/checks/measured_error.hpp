// What a certificate says of a function (certificate.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace alembert {

/// What was measured of one function.
struct MeasuredError {
  double relative = 0;  ///< the largest of all arrays and states
  std::string array;    ///< where it is
  int states = 0;       ///< at which there were values to compare; 0: nothing is known
  std::vector<std::size_t> without_value =
      {};  ///< states at which the plain equations have values, the program none
};

}  // namespace alembert

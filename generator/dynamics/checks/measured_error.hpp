// What a certificate says of a function (certificate.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace alembert {

/// Entries of one array that are compared with the largest of them.
struct MeasuredPart {
  std::size_t array, first, count;
};

/// A difference from the plain equations that is no small part of its entries, at one state.
struct Excess {
  std::size_t state;
  MeasuredPart part;
  std::size_t terms;  ///< entries that were summed before they were compared
  double difference;
  bool of_zeros;  ///< the array is 0 at each state
};

/// What was measured of one function.
struct MeasuredError {
  double relative = 0;  ///< the largest of all states and of all arrays but those that are 0 at each
  std::string array;    ///< where it is
  std::vector<Excess> excesses = {};
  int states = 0;  ///< at which there were values to compare; 0: nothing is known
  std::vector<std::size_t> without_value =
      {};  ///< states at which the plain equations have values, the program none
};

}  // namespace alembert

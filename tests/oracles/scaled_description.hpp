// A description in other units: lengths times 2^k, masses times 2^m, time as it is. Its numbers must then
// change by exact powers of two.
#pragma once

#include <map>
#include <set>
#include <string>

#include "oracles/state.hpp"
#include "oracles/taylor/numeric_functions.hpp"

namespace alembert::oracles {

struct Scale {
  int length = 0, mass = 0;  ///< exponents of 2
};

struct ScaledDescription {
  std::string text;               ///< of the whole description, without constraints and shapes
  std::set<std::string> lengths;  ///< coordinates that are lengths
};

/// The text with every decimal rounded to eight bits, as a fraction of a power of two: products and sums of
/// such numbers are exact, be they kept as fractions or as doubles, and the last bit of a result does not
/// depend on which of them a generator takes.
std::string with_short_numbers(const std::string& yaml);

/// Expressions are wrapped (1024*(0.4318)), so that no decimal is rounded anew. A coordinate is a length if a
/// joint shifts by it or if it stands alone in a translation. Throws std::runtime_error if there are runtime
/// parameters, whose dimensions nothing tells.
ScaledDescription scaled_description(const std::string& yaml, const Scale& scale);

/// By speed, the exponent of the unit of its coordinate.
std::vector<int> speed_exponents(const Description& description, const std::set<std::string>& lengths,
                                 const Scale& scale);

State scaled_state(const Description& description, const std::set<std::string>& lengths, const Scale& scale,
                   const State& state);

/// What an array of a function becomes.
Eigen::MatrixXd scaled_array(const std::string& function, const std::string& name,
                             const Eigen::MatrixXd& values, const std::vector<int>& speeds,
                             const Scale& scale);

}  // namespace alembert::oracles

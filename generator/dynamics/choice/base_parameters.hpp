// Base parameters: of the standard parameters of the bodies (regressor.hpp), the combinations that forces depend on.
// In: the motions of a mechanism. Out: which they are, and which have no effect.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"

namespace alembert {

/// One of them: a standard parameter and multiples of others that forces do not tell apart from it. Column
/// `parameter` of the regressor is its column.
struct BaseParameter {
  std::size_t parameter;                               ///< index of a column of the regressor
  std::vector<std::pair<std::size_t, double>> joined;  ///< others, each after `parameter`, with coefficients
};

struct BaseParameters {
  std::vector<BaseParameter> base;  ///< in ascending order
  std::vector<std::size_t> without_effect;
};

/// Columns of the regressor that depend on none before them, by its rank in the field with p^2 elements (modular.hpp);
/// the coefficients by elimination in 50 digits at random states, runtime parameters at their defaults. Defaults that
/// are special, a length of 0 say, leave other columns dependent than most values do: then these are independent for
/// all values, and the coefficients hold for all. Throws InternalError if other states contradict them.
BaseParameters base_parameters(const Kinematics& kinematics);

}  // namespace alembert

// `check`: the laws that a mechanism's equations must obey.
#pragma once

#include "commands/common_options.hpp"

namespace alembert {

struct CheckOptions {
  int states = 0;  ///< at which every function is measured against the plain equations; 0: not at all
};
int run_check(const CommonOptions& common, const CheckOptions& options);

}  // namespace alembert

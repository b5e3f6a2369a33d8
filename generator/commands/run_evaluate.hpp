// `evaluate`: states in, numbers out.
#pragma once

#include <string>
#include <vector>

#include "commands/common_options.hpp"

namespace alembert {

struct EvaluateOptions {
  std::vector<std::string> functions;  ///< none: tau, M, c, qdd and what else a state gives
  bool json = false;
};
int run_evaluate(const CommonOptions& common, const EvaluateOptions& options);

}  // namespace alembert

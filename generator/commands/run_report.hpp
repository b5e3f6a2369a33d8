// `report`: operations of each function.
#pragma once

#include <string>
#include <vector>

#include "commands/common_options.hpp"

namespace alembert {

struct ReportOptions {
  std::vector<std::string> functions;  ///< none: all whose operations are worth counting
  bool json = false;
};
int run_report(const CommonOptions& common, const ReportOptions& options);

}  // namespace alembert

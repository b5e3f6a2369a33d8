// `report`: operations of each function.
#pragma once

#include <string>
#include <vector>

#include "commands/common_options.hpp"

namespace alembert {

struct ReportOptions {
  std::vector<std::string> functions;  ///< none: all whose operations are worth counting
  bool json = false;
  std::string memory;               ///< double or float: also what C99 takes on a machine; empty: not
  std::string compiler = "cc -O2";  ///< for that
};
int run_report(const CommonOptions& common, const ReportOptions& options);

}  // namespace alembert

// `import`: a robot in another format in, a description out.
#pragma once

#include <string>

#include "commands/common_options.hpp"
#include "import/common/described.hpp"

namespace alembert {

struct ImportOptions {
  std::string out = "-";  ///< file to be written; `-` is standard output
  DescribeOptions describe;
};
int run_import(const CommonOptions& common, const ImportOptions& options);

}  // namespace alembert

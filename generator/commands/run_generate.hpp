// `generate`: the files of one mechanism.
#pragma once

#include <string>
#include <vector>

#include "commands/common_options.hpp"

namespace alembert {

struct GenerateOptions {
  std::string out_dir;
  std::string language = "c++";  ///< a name of kLanguages
  std::string depfile, stamp;
  std::string name_space;
  std::vector<std::string> functions;
  std::vector<std::string> scalars;
  std::vector<std::string> batch;               ///< functions over many states; `default`: the usual ones
  std::vector<std::string> batch_instructions;  ///< empty: the usual ones
  std::string expected_name;                    ///< the mechanism must have this name
  int parts = 0;                                ///< files over which definitions are spread; 0: by size
  bool print_outputs = false, dry_run = false, check = false;
};
int run_generate(const CommonOptions& common, const GenerateOptions& options);

}  // namespace alembert

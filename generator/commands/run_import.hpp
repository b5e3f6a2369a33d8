// `import`: a robot in another format in, a description out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "commands/common_options.hpp"

namespace alembert {

/// The text of a description, or that which is imported from a robot's file in another format.
/// \param files  gets what was read besides that file, if given
std::shared_ptr<const SourceText> description_of(const CommonOptions& common,
                                                 std::vector<std::string>* files = nullptr);

/// \param out  file to be written; `-` is standard output
int run_import(const CommonOptions& common, const std::string& out);

}  // namespace alembert

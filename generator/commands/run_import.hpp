// `import`: a robot in another format in, a description out.
#pragma once

#include <memory>
#include <string>

#include "commands/common_options.hpp"
#include "import/common/described.hpp"

namespace alembert {

struct ImportOptions {
  std::string out = "-";  ///< file to be written; `-` is standard output
  DescribeOptions describe;
};

/// The description, as text, of a robot in another format; checked as any other. Tells warnings.
std::string imported_text(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                          bool strict, std::string* summary = nullptr);

/// The text of a description, or that which is imported from a robot's file in another format.
std::shared_ptr<const SourceText> description_of(const CommonOptions& common);

int run_import(const CommonOptions& common, const ImportOptions& options);

}  // namespace alembert

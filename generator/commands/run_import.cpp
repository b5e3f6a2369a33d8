// `import`: a robot in another format in, a description in the language of mechanisms out, checked as any
// other.
#include "commands/run_import.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "commands/common_options.hpp"
#include "commands/expand_xacro.hpp"
#include "commands/warnings.hpp"
#include "emit/files/write_files.hpp"
#include "import/common/yaml.hpp"
#include "import/importers.hpp"
#include "mechanism/load.hpp"

namespace alembert {

namespace {

/// What was doubtful may be why the rest cannot be read.
DescribedRobot describe(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                        Warnings& warnings) {
  try {
    return describe_source(source, options, warnings);
  } catch (const InputError&) {
    report_warnings(warnings, false);
    throw;
  }
}

}  // namespace

std::string imported_text(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                          bool strict, std::string* summary) {
  Warnings warnings;
  const DescribedRobot described = describe(source, options, warnings);
  // What the language refuses is shown where it stands in the file.
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(described.document, graph);
  warnings.insert(warnings.end(), described.warnings.begin(), described.warnings.end());
  warnings.insert(warnings.end(), mechanism.warnings.begin(), mechanism.warnings.end());
  report_warnings(warnings, strict);
  if (summary != nullptr) *summary = described.summary;
  return yaml_text(described.document.root());
}

std::shared_ptr<const SourceText> description_of(const CommonOptions& common) {
  std::shared_ptr<const SourceText> source = read_expanded(common.file);
  if (importer_unless_description(*source) == nullptr) return source;
  DescribeOptions options;
  options.include_folders = common.include_folders;
  return std::make_shared<const SourceText>(
      SourceText{source->name + ", imported", imported_text(source, options, common.strict)});
}

int run_import(const CommonOptions& common, const ImportOptions& options) {
  std::string summary;
  DescribeOptions describe_options = options.describe;
  describe_options.include_folders = common.include_folders;
  const std::string text =
      imported_text(read_expanded(common.file), describe_options, common.strict, &summary);
  if (!summary.empty()) tell(fmt::format("{}: note: {}\n", common.file, summary));
  if (options.out == "-") {
    fmt::print("{}", text);
  } else {
    write_file(options.out, text);
  }
  return 0;
}

}  // namespace alembert

// `import`: a robot in another format in, a description in the language of mechanisms out, checked as any
// other.
#include "commands/run_import.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>

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

/// Checks a description as any other, and tells all warnings.
void check(const DescribedRobot& described, Warnings warnings, bool strict) {
  // What the language refuses is shown where it stands in the file.
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(described.document, graph);
  warnings.insert(warnings.end(), described.warnings.begin(), described.warnings.end());
  warnings.insert(warnings.end(), mechanism.warnings.begin(), mechanism.warnings.end());
  report_warnings(warnings, strict);
}

}  // namespace

std::shared_ptr<const SourceText> description_of(const CommonOptions& common,
                                                 std::vector<std::string>* files) {
  std::shared_ptr<const SourceText> source = read_expanded(common.file);
  if (importer_unless_description(*source) == nullptr) {
    Warnings unused;
    warn_of_unused(source, "a description", 0, common.describe, unused);
    report_warnings(unused, common.strict);
    return source;
  }
  Warnings warnings;
  const DescribedRobot described = describe(source, common.describe, warnings);
  check(described, std::move(warnings), common.strict);
  if (files != nullptr) *files = described.files;
  return std::make_shared<const SourceText>(
      SourceText{source->name + ", imported", yaml_text(described.document.root())});
}

int run_import(const CommonOptions& common, const std::string& out) {
  DescribeOptions options = common.describe;
  // What goes to standard output is likely to become a file here.
  options.folder = out == "-" ? std::filesystem::current_path().string()
                              : std::filesystem::absolute(out).parent_path().string();
  Warnings warnings;
  const DescribedRobot described = describe(read_expanded(common.file), options, warnings);
  check(described, std::move(warnings), common.strict);
  tell(fmt::format("{}: note: {}\n", common.file, summary(described)));
  const std::string text = yaml_text(described.document.root());
  if (out == "-") {
    fmt::print("{}", text);
  } else {
    write_file(out, text);
  }
  return 0;
}

}  // namespace alembert

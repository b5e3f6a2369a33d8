// `import`: a URDF file in, a description in the language of mechanisms out, checked as any other.
#include <fmt/format.h>

#include <cstdio>

#include "commands/commands.hpp"
#include "emit/write_files.hpp"
#include "mechanism/load.hpp"
#include "urdf/robot.hpp"
#include "urdf/yaml.hpp"

namespace alembert {

namespace {

/// What was doubtful may be why the rest cannot be read.
UrdfRobot read_robot(const std::shared_ptr<const SourceText>& source, Warnings& warnings) {
  try {
    return read_urdf(source, warnings);
  } catch (const InputError&) {
    report_warnings(warnings, false);
    throw;
  }
}

}  // namespace

int run_import(const CommonOptions& common, const ImportOptions& options) {
  const std::shared_ptr<const SourceText> source = read_source(common.file);
  Warnings warnings;
  const DescribedRobot described = describe_robot(read_robot(source, warnings), source, options.describe);
  // What the language refuses is shown where it stands in the URDF.
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(described.document, graph);
  warnings.insert(warnings.end(), described.warnings.begin(), described.warnings.end());
  warnings.insert(warnings.end(), mechanism.warnings.begin(), mechanism.warnings.end());
  report_warnings(warnings, common.strict);
  const std::string text = yaml_text(described.document.root());
  if (options.out == "-") {
    fmt::print("{}", text);
  } else {
    write_file(options.out, text);
  }
  return 0;
}

}  // namespace alembert

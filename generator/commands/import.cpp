// `import`: a URDF file in, a description in the language of mechanisms out, checked as any other.
#include <fmt/format.h>

#include <cstdio>

#include "commands/commands.hpp"
#include "emit/write_files.hpp"
#include "mechanism/load.hpp"
#include "urdf/robot.hpp"
#include "urdf/yaml.hpp"

namespace alembert {

int run_import(const CommonOptions& common, const ImportOptions& options) {
  const std::shared_ptr<const SourceText> source = read_source(common.file);
  const DescribedRobot described = describe_robot(read_urdf(source), source, options.describe);
  // What the language refuses is shown where it stands in the URDF.
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(described.document, graph);
  Warnings warnings = described.warnings;
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

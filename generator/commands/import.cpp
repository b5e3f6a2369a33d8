// `import`: a URDF file in, a description in the language of mechanisms out, checked as any other.
#include <fmt/format.h>

#include <cstdio>

#include "commands/commands.hpp"
#include "emit/write_files.hpp"
#include "mechanism/load.hpp"
#include "urdf/robot.hpp"
#include "urdf/yaml.hpp"

namespace alembert {

int run_import(const ImportOptions& options) {
  const std::shared_ptr<const SourceText> source = read_source(options.file);
  const DescribedRobot described = describe_robot(read_urdf(source), source, options.describe);
  // What the language refuses is shown where it stands in the URDF.
  ExprGraph graph;
  load_mechanism(described.document, graph);
  const std::string text = yaml_text(described.document.root());
  for (const std::string& warning : described.warnings) tell(warning + "\n");
  if (options.out == "-") {
    fmt::print("{}", text);
  } else {
    write_file(options.out, text);
  }
  return 0;
}

}  // namespace alembert

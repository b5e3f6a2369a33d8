// libFuzzer target: any bytes in; the loader, or an importer if they begin as XML does, must give a mechanism or an
// InputError with a place inside the text, and never crash, hang, leak or throw anything else.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "import/common/yaml.hpp"
#include "import/importers.hpp"
#include "mechanism/load.hpp"

namespace {

alembert::Mechanism load(const std::shared_ptr<const alembert::SourceText>& source,
                         alembert::ExprGraph& graph) {
  if (alembert::importer_unless_description(*source) == nullptr)
    return alembert::load_mechanism(source, graph);
  // All options, by the length of the text.
  const std::size_t length = source->text.size();
  alembert::DescribeOptions options;
  options.floating = length % 2 == 0;
  options.massless = static_cast<alembert::Massless>(length / 2 % 4);
  options.resistance = length / 8 % 2 == 0;
  alembert::Warnings warnings;
  const alembert::DescribedRobot described = alembert::describe_source(source, options, warnings);
  alembert::Mechanism mechanism = alembert::load_mechanism(described.document, graph);
  // What was understood once is understood from its text.
  alembert::ExprGraph again;
  alembert::load_mechanism(std::make_shared<const alembert::SourceText>(
                               alembert::SourceText{"again", alembert::yaml_text(described.document.root())}),
                           again);
  return mechanism;
}

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "the loader broke its contract: %s\n", what);
  std::abort();
}

void check_mechanism(const alembert::Mechanism& mechanism) {
  require(!mechanism.name.empty() && !mechanism.coordinates.empty() && !mechanism.bodies.empty(),
          "an empty mechanism");
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
    require(mechanism.bodies[i].parent < static_cast<int>(i), "a parent after its child");
  for (const alembert::Coordinate& coordinate : mechanism.coordinates)
    require(coordinate.initial.size() == coordinate.symbols.size(), "a coordinate without its values");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto source = std::make_shared<alembert::SourceText>();
  source->name = "<stdin>";  // which has no folder
  source->text.assign(reinterpret_cast<const char*>(data), size);
  const std::ptrdiff_t lines = std::count(source->text.begin(), source->text.end(), '\n') + 1;
  alembert::ExprGraph graph;
  try {
    check_mechanism(load(source, graph));
  } catch (const alembert::InputError& error) {
    require(error.where().line >= 1 && error.where().line <= lines, "a line outside the text");
    require(error.where().column >= 1, "a column before the line");
    require(std::string(error.what()).starts_with("<stdin>:"), "a diagnostic without its place");
  }
  return 0;
}

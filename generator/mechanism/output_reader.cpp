// Section `outputs`: list of names and expressions in, outputs out. Each may use those before it, and rates of states
// all of them.
#include "mechanism/output_reader.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "mechanism/coordinates.hpp"
#include "mechanism/names.hpp"
#include "mechanism/section.hpp"

namespace alembert {
namespace {

void check_name(Loading& loading, const YamlNode& node) {
  const std::string& name = expect_name(loading.document, node, "an output");
  const SourceLocation where = loading.document.where(node);
  for (const Output& other : loading.mechanism.outputs)
    if (other.name == name)
      throw InputError(where, fmt::format("'{}' is already an output (line {})", name, other.where.line));
  if (const NameEntry* entry = loading.scope.find(name))
    throw InputError(
        where, fmt::format("'{}' is already {} (line {})", name, a_noun(entry->kind), entry->where.line));
}

}  // namespace

std::vector<ExpressionReader::LocalName> read_outputs(Loading& loading, const YamlNode& list) {
  std::vector<ExpressionReader::LocalName> before;
  for (const YamlNode* item : expect_list(loading.document, list, "the outputs")) {
    const Section section(loading.document, *item, "an output", {"name", "value", "limits"});
    const YamlNode& name = section.require("name");
    check_name(loading, name);
    const Quantity value = loading.reader.read_with(section.require("value"), before, Allowed::force,
                                                    fmt::format("output '{}'", name.text));
    loading.mechanism.outputs.push_back(
        {name.text, value.expr, includes(value.dependence, Dependence::speed), loading.document.where(name)});
    if (const YamlNode* limits = section.find("limits"))
      loading.mechanism.outputs.back().limits =
          read_limits(loading, *limits, fmt::format("output '{}'", name.text));
    before.push_back({name.text, value.expr, value.dependence});
  }
  return before;
}

}  // namespace alembert

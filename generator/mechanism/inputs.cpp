#include "mechanism/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "mechanism/coordinates.hpp"
#include "mechanism/section.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {
namespace {

Section input_section(const Document& document, const YamlNode& item) {
  return Section(document, item, "an input", {"name", "initial", "limits"});
}

const YamlNode& input_name(const Document& document, const YamlNode& item) {
  if (item.kind == YamlNode::Kind::mapping) return input_section(document, item).require("name");
  if (item.kind != YamlNode::Kind::scalar) fail_expected(document, item, "a name or a mapping as an input");
  return item;
}

}  // namespace

void declare_inputs(Loading& loading, const YamlNode& list) {
  for (const YamlNode* item : expect_list(loading.document, list, "the inputs"))
    loading.scope.declare(loading.document, input_name(loading.document, *item), NameKind::input);
}

void read_inputs(Loading& loading, const YamlNode& list) {
  const Document& document = loading.document;
  for (const YamlNode* item : list.items) {
    const YamlNode& name = input_name(document, *item);
    Parameter input{name.text, 0, true, document.where(name)};
    input.input = true;
    if (item->kind == YamlNode::Kind::mapping) {
      const Section section = input_section(document, *item);
      if (const YamlNode* initial = section.find("initial"))
        input.value = loading.reader
                          .read(*initial, Allowed::constants,
                                fmt::format("the initial value of input '{}'", input.name))
                          .initial;
      if (const YamlNode* limits = section.find("limits"))
        input.limits = read_limits(loading, *limits, fmt::format("input '{}'", input.name), input.value,
                                   section.find("initial"));
    }
    NameEntry& entry = *loading.scope.find(input.name);
    entry.value = {loading.graph.symbol(input.name), input.value,
                   Dependence::runtime_parameter | Dependence::input, nullptr};
    entry.ready = true;
    loading.initial_state.emplace_back(entry.value.expr, input.value);
    loading.mechanism.parameters.push_back(std::move(input));
  }
}

void replace_input(Loading& loading, const std::string& name, std::shared_ptr<const SourceText> source) {
  NameEntry* entry = loading.scope.find(name);
  if (entry == nullptr || entry->kind != NameKind::input) {
    std::vector<std::string> names;
    for (const Parameter& parameter : loading.mechanism.parameters)
      if (parameter.input) names.push_back(parameter.name);
    throw InputError({source, 1, 1},
                     fmt::format("there is no input '{}'{}", printable(name), did_you_mean(name, names)));
  }
  check_characters(source);
  const std::size_t begin = name.size() + 1;
  std::deque<YamlNode> nodes(1);
  YamlNode& node = nodes.front();
  node.kind = YamlNode::Kind::scalar;
  node.plain = true;
  node.column = static_cast<int>(begin) + 1;
  node.text = source->text.substr(begin);
  const Document document(std::move(source), std::move(nodes), node);
  ExpressionReader reader(document, loading.graph, loading.scope, loading.mechanism);
  const Quantity value = reader.read(document.root(), Allowed::force, fmt::format("input '{}'", name));
  entry->value.initial = value.initial;
  std::vector<std::pair<Expr, Expr>> laws;
  for (const Parameter& parameter : loading.mechanism.parameters)
    if (parameter.law) laws.emplace_back(loading.graph.symbol(parameter.name), *parameter.law);
  std::ranges::find(loading.mechanism.parameters, name, &Parameter::name)->law =
      substitute(std::span(&value.expr, 1), laws).front();
}

}  // namespace alembert

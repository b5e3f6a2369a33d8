#include "mechanism/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "mechanism/coordinates.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transform_checks.hpp"
#include "symbolic/substitute.hpp"

namespace alembert {
namespace {

Section section_of(const Document& document, const YamlNode& item, NameKind kind) {
  std::string what = a_noun(kind);
  for (std::size_t i = 0; i + 1 < item.items.size(); i += 2)
    if (item.items[i]->text == "name")
      what = fmt::format("{} '{}'", noun(kind), printable(item.items[i + 1]->text));
  if (kind == NameKind::state) return {document, item, what, {"name", "initial", "limits", "rate"}};
  return {document, item, what, {"name", "initial", "limits"}};
}

const YamlNode& name_of(const Document& document, const YamlNode& item, NameKind kind) {
  if (item.kind == YamlNode::Kind::mapping) return section_of(document, item, kind).require("name");
  if (kind == NameKind::state) fail_expected(document, item, "{name, rate} as a state");
  if (item.kind != YamlNode::Kind::scalar) fail_expected(document, item, "a name or a mapping as an input");
  return item;
}

void declare(Loading& loading, const YamlNode& list, NameKind kind) {
  for (const YamlNode* item : expect_list(loading.document, list, fmt::format("the {}s", noun(kind))))
    loading.scope.declare(loading.document, name_of(loading.document, *item, kind), kind);
}

void read_values(Loading& loading, const YamlNode& list, NameKind kind) {
  const Document& document = loading.document;
  const bool state = kind == NameKind::state;
  for (const YamlNode* item : list.items) {
    const YamlNode& name = name_of(document, *item, kind);
    Parameter argument{name.text, 0, true, document.where(name)};
    argument.role = state ? ParameterRole::state : ParameterRole::input;
    if (item->kind == YamlNode::Kind::mapping) {
      const Section section = section_of(document, *item, kind);
      if (state) section.require("rate");
      const std::string what = fmt::format("{} '{}'", noun(kind), argument.name);
      if (const YamlNode* initial = section.find("initial"))
        argument.value =
            loading.reader.read(*initial, Allowed::constants, "the initial value of " + what).initial;
      if (const YamlNode* limits = section.find("limits"))
        argument.limits = read_limits(loading, *limits, what, argument.value, section.find("initial"));
    }
    NameEntry& entry = *loading.scope.find(argument.name);
    entry.value = {loading.graph.symbol(argument.name), argument.value,
                   Dependence::runtime_parameter | (state ? Dependence::state : Dependence::input), nullptr};
    entry.ready = true;
    loading.initial_state.emplace_back(entry.value.expr, argument.value);
    loading.mechanism.parameters.push_back(std::move(argument));
  }
}

Expr read_law(Loading& loading, const InputExpression& input,
              const std::vector<ExpressionReader::LocalName>& outputs) {
  const auto& [name, source] = input;
  const NameEntry* entry = loading.scope.find(name);
  if (entry == nullptr || entry->kind != NameKind::input) {
    std::vector<std::string> names;
    for (const Parameter& parameter : loading.mechanism.parameters)
      if (parameter.is_input()) names.push_back(parameter.name);
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
  const Document document(source, std::move(nodes), node);
  return ExpressionReader(loading.reader, document)
      .read_with(document.root(), outputs, Allowed::force, fmt::format("input '{}'", name))
      .expr;
}

}  // namespace

void declare_inputs(Loading& loading, const YamlNode& list) {
  declare(loading, list, NameKind::input);
}

void declare_states(Loading& loading, const YamlNode& list) {
  declare(loading, list, NameKind::state);
}

void read_inputs(Loading& loading, const YamlNode& list) {
  read_values(loading, list, NameKind::input);
}

void read_states(Loading& loading, const YamlNode& list) {
  read_values(loading, list, NameKind::state);
}

void read_state_rates(Loading& loading, const YamlNode& list,
                      const std::vector<ExpressionReader::LocalName>& outputs) {
  auto state = std::ranges::find(loading.mechanism.parameters, true, &Parameter::is_state);
  for (const YamlNode* item : list.items) {
    const Section section = section_of(loading.document, *item, NameKind::state);
    state->rate = loading.reader
                      .read_with(section.require("rate"), outputs, Allowed::force,
                                 fmt::format("the rate of state '{}'", state->name))
                      .expr;
    ++state;
  }
}

void read_input_laws(Loading& loading, const std::vector<InputExpression>& given,
                     const std::vector<ExpressionReader::LocalName>& outputs) {
  std::vector<std::pair<Expr, Expr>> laws;
  for (const InputExpression& input : given) {
    const Expr symbol = loading.graph.symbol(input.name);
    if (std::ranges::find(laws, symbol, &std::pair<Expr, Expr>::first) != laws.end())
      throw InputError({input.source, 1, 1}, fmt::format("a second expression of input '{}'", input.name));
    laws.emplace_back(symbol, read_law(loading, input, outputs));
  }
  // As often as there are laws: then each is of no other, unless it is of itself.
  for (std::size_t round = 0; round < given.size(); ++round)
    for (auto& [symbol, law] : laws) law = substitute(std::span(&law, 1), laws).front();
  for (std::size_t i = 0; i < given.size(); ++i) {
    const InputExpression& input = given[i];
    if (depends_on({&laws[i].second, 1}, laws[i].first))
      throw InputError({input.source, 1, 1}, fmt::format("input '{}' is given by itself", input.name));
    std::ranges::find(loading.mechanism.parameters, input.name, &Parameter::name)->law = laws[i].second;
  }
}

}  // namespace alembert

// Stage `load`: the sections of a description, in the order in which they may refer to each other.
#include "mechanism/load.hpp"

#include <fmt/format.h>

#include "mechanism/bodies.hpp"
#include "mechanism/constraint_reader.hpp"
#include "mechanism/coordinate_forces.hpp"
#include "mechanism/coordinates.hpp"
#include "mechanism/document.hpp"
#include "mechanism/force_reader.hpp"
#include "mechanism/inertia_checks.hpp"
#include "mechanism/inputs.hpp"
#include "mechanism/loading.hpp"
#include "mechanism/names.hpp"
#include "mechanism/output_reader.hpp"
#include "mechanism/section.hpp"
#include "mechanism/transform_checks.hpp"

namespace alembert {
namespace {

constexpr std::size_t kMaximumDescription = 4096;

void check_version(const Document& document, const YamlNode& root) {
  if (root.kind != YamlNode::Kind::mapping)
    fail_expected(document, root, "a mapping that begins with 'alembert: 1'");
  for (std::size_t i = 0; i + 1 < root.items.size(); i += 2) {
    if (root.items[i]->text != "alembert") continue;
    const YamlNode& version = *root.items[i + 1];
    if (version.kind != YamlNode::Kind::scalar || version.text != "1")
      fail_expected(document, version, "1 as the version of the description language");
    return;
  }
}

/// Makes the names of a mapping's keys known, in order.
void declare_keys(Loading& loading, const YamlNode& section, std::string_view what, NameKind kind) {
  if (section.kind != YamlNode::Kind::mapping)
    fail_expected(loading.document, section, fmt::format("a mapping as {}", what));
  for (std::size_t i = 0; i < section.items.size(); i += 2)
    loading.scope.declare(loading.document, *section.items[i], kind);
}

void read_parameters(Loading& loading, const YamlNode& section) {
  const Document& document = loading.document;
  for (std::size_t i = 0; i < section.items.size(); i += 2) {
    const YamlNode& key = *section.items[i];
    const YamlNode* value = section.items[i + 1];
    const std::string what = fmt::format("parameter '{}'", key.text);
    Parameter parameter{key.text, 0, false, document.where(key)};
    if (value->kind == YamlNode::Kind::mapping) {
      const Section form(document, *value, what, {"value", "runtime"});
      if (const YamlNode* runtime = form.find("runtime"))
        parameter.runtime = expect_boolean(document, *runtime, "'runtime'");
      value = &form.require("value");
    }
    NameEntry& entry = *loading.scope.find(key.text);
    entry.value =
        loading.reader.read(*value, parameter.runtime ? Allowed::constants : Allowed::parameters, what);
    parameter.value = entry.value.initial;
    if (parameter.runtime) {
      entry.kind = NameKind::runtime_parameter;
      entry.value = {loading.graph.symbol(key.text), parameter.value, Dependence::runtime_parameter, nullptr};
      loading.initial_state.emplace_back(entry.value.expr, parameter.value);
    }
    entry.ready = true;
    loading.mechanism.parameters.push_back(std::move(parameter));
  }
}

void read_definitions(Loading& loading, const YamlNode& section) {
  for (std::size_t i = 0; i < section.items.size(); i += 2) {
    const std::string& name = section.items[i]->text;
    NameEntry& entry = *loading.scope.find(name);
    entry.value =
        loading.reader.read(*section.items[i + 1], Allowed::motion, fmt::format("definition '{}'", name));
    entry.ready = true;
  }
}

Vec3 read_gravity(Loading& loading, const YamlNode* node) {
  if (node != nullptr) return loading.reader.read_vector(*node, Allowed::parameters, "gravity");
  Vec3 gravity = zeros<3, 1>(loading.graph);
  gravity[2] = loading.graph.rational(Rational(-981, 100));
  return gravity;
}

}  // namespace

Mechanism load_mechanism(std::shared_ptr<const SourceText> source, ExprGraph& graph,
                         const std::vector<InputExpression>& inputs) {
  return load_mechanism(Document(std::move(source)), graph, {}, inputs);
}

Mechanism load_mechanism(const Document& document, ExprGraph& graph, std::span<const double> start,
                         const std::vector<InputExpression>& input_expressions) {
  check_version(document, document.root());
  const Section root(
      document, document.root(), "the description",
      {"alembert", "name", "description", "gravity", "parameters", "coordinates", "definitions", "bodies",
       "frames", "constraints", "inputs", "states", "forces", "outputs"});
  root.require("alembert");

  Loading loading(document, graph);
  Mechanism& mechanism = loading.mechanism;
  mechanism.where = document.where(document.root());
  mechanism.time = graph.symbol("t");
  const YamlNode& name = root.require("name");
  mechanism.name = expect_mechanism_name(document, name);
  mechanism.where = document.where(name);
  if (const YamlNode* description = root.find("description")) {
    mechanism.description = expect_text(document, *description, "text as the description");
    if (mechanism.description.size() > kMaximumDescription)
      throw InputError(document.where(*description),
                       fmt::format("description of {} characters; the limit is {}",
                                   mechanism.description.size(), kMaximumDescription));
  }
  const YamlNode* parameters = root.find("parameters");
  const YamlNode* definitions = root.find("definitions");
  const YamlNode& coordinates = root.require("coordinates");
  const YamlNode& bodies = root.require("bodies");

  // All names first, so that a name used too early is told from an unknown one.
  if (parameters != nullptr) declare_keys(loading, *parameters, "the parameters", NameKind::parameter);
  const YamlNode* inputs = root.find("inputs");
  if (inputs != nullptr) declare_inputs(loading, *inputs);
  declare_coordinates(loading, coordinates);
  const YamlNode* states = root.find("states");
  if (states != nullptr) declare_states(loading, *states);
  if (definitions != nullptr) declare_keys(loading, *definitions, "the definitions", NameKind::definition);

  if (parameters != nullptr) read_parameters(loading, *parameters);
  if (inputs != nullptr) read_inputs(loading, *inputs);
  if (states != nullptr) read_states(loading, *states);
  read_coordinate_values(loading, coordinates, start);
  mechanism.gravity = read_gravity(loading, root.find("gravity"));
  if (definitions != nullptr) read_definitions(loading, *definitions);
  read_bodies(loading, bodies);
  if (const YamlNode* frames = root.find("frames")) read_frames(loading, *frames);
  if (const YamlNode* constraints = root.find("constraints")) read_constraints(loading, *constraints);
  read_coordinate_forces(loading, coordinates);
  if (const YamlNode* forces = root.find("forces")) read_forces(loading, *forces);
  std::vector<ExpressionReader::LocalName> named;
  if (const YamlNode* outputs = root.find("outputs")) named = read_outputs(loading, *outputs);
  if (states != nullptr) read_state_rates(loading, *states, named);
  read_input_laws(loading, input_expressions, named);
  check_matrices(loading);
  check_inertias(loading);
  loading.scope.check_used(mechanism.warnings);
  return std::move(loading.mechanism);
}

}  // namespace alembert

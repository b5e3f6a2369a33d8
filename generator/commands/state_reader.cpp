// One line, one state (see the header).
#include "commands/state_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "mechanism/parameter_places.hpp"

namespace alembert {

namespace {

/// An error at a value; parse_json's at the offset that they bear.
[[noreturn]] void fail(const JsonValue& value, const std::string& message) {
  throw JsonError(value.at, message);
}

double number(const JsonValue& value, const std::string& what) {
  if (value.kind != JsonValue::Kind::number) fail(value, "'" + what + "' must be a finite number");
  return value.number;
}

void numbers(const JsonValue& value, const std::string& what, std::span<double> out) {
  if (value.kind != JsonValue::Kind::array || value.items.size() != out.size())
    fail(value, fmt::format("'{}' must be an array of {} numbers", what, out.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = number(value.items[i], what);
}

/// Gives each member of an object to `take` with the index of its name among `names`. Of what kind things of
/// these names are is said of others.
template <class Take>
void members(const JsonValue& object, const std::vector<std::string>& names, const std::string& kind,
             const Take& take) {
  for (std::size_t i = 0; i < object.items.size(); ++i) {
    const JsonValue::Key& key = object.keys[i];
    const auto found = std::ranges::find(names, key.name);
    if (found == names.end())
      throw JsonError(key.at, kind + " '" + printable(key.name) + "'" + did_you_mean(key.name, names));
    take(static_cast<std::size_t>(found - names.begin()), object.items[i]);
  }
}

/// Runtime parameters of one role.
struct ParameterKey {
  std::string_view key, one, many;
  ParameterRole role;
};
constexpr ParameterKey kParameterKeys[] = {
    {"parameters", "runtime parameter", "runtime parameters", ParameterRole::parameter},
    {"inputs", "input", "inputs", ParameterRole::input},
    {"states", "state", "states", ParameterRole::state}};

void parameters(const Mechanism& mechanism, const ParameterKey& of, const JsonValue& values,
                EvaluationState& state) {
  if (values.kind != JsonValue::Kind::object)
    fail(values, fmt::format("'{}' must be an object of {} by name", of.key, of.many));
  const std::vector<PlacedParameter> placed = placed_parameters(mechanism, of.role);
  std::vector<std::string> names;
  for (const PlacedParameter& one : placed) names.push_back(one.parameter.name);
  members(values, names, fmt::format("there is no {}", of.one), [&](std::size_t i, const JsonValue& value) {
    state.parameters[placed[i].place] = number(value, names[i]);
  });
}

void wrenches(const Mechanism& mechanism, const JsonValue& values, EvaluationState& state) {
  if (values.kind != JsonValue::Kind::object)
    fail(values, "'wrenches' must be an object of [fx, fy, fz, tx, ty, tz] by body");
  std::vector<std::string> names;
  for (const Body& body : mechanism.bodies) {
    if (body.external_wrench) names.push_back(body.name);
  }
  members(values, names, "there is no body with external_wrench called",
          [&](std::size_t i, const JsonValue& value) {
            numbers(value, names[i], std::span(state.wrenches).subspan(6 * i, 6));
          });
}

/// The q that was given, with quaternions of unit length.
void coordinates(const Mechanism& mechanism, const JsonValue& value, EvaluationState& state) {
  numbers(value, "q", state.q);
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (coordinate.type != CoordinateType::quaternion) continue;
    const std::size_t first = static_cast<std::size_t>(coordinate.first_q);
    const Eigen::Map<const Eigen::Vector4d> parts(&state.q[first]);
    if (!(std::abs(parts.stableNorm() - 1) <= 1e-6))
      fail(value.items[first], "quaternion '" + coordinate.name + "' is not of unit length");
  }
  normalise_quaternions(mechanism, state.q);
}

EvaluationState state_of(const JsonValue& object, const Mechanism& mechanism,
                         const EvaluationState& defaults) {
  if (object.kind != JsonValue::Kind::object)
    fail(object, "expected a JSON object with q, qd, qdd, t, tau, mu, parameters, inputs, states, wrenches");
  static const std::vector<std::string> kKeys{"q",  "qd",         "qdd",    "t",      "tau",
                                              "mu", "parameters", "inputs", "states", "wrenches"};
  EvaluationState state = defaults;
  members(object, kKeys, "unknown key", [&](std::size_t i, const JsonValue& value) {
    const std::string& key = kKeys[i];
    if (key == "q") coordinates(mechanism, value, state);
    if (key == "qd") numbers(value, key, state.qd);
    if (key == "qdd") numbers(value, key, state.qdd);
    if (key == "t") state.t = number(value, key);
    for (const auto& [name, array] : {std::pair{"tau", &state.tau}, std::pair{"mu", &state.mu}}) {
      if (key != name) continue;
      array->resize(state.qd.size());
      numbers(value, key, *array);
    }
    for (const ParameterKey& of : kParameterKeys)
      if (key == of.key) parameters(mechanism, of, value, state);
    if (key == "wrenches") wrenches(mechanism, value, state);
  });
  return state;
}

}  // namespace

EvaluationState StateReader::read(const std::string& text, int line) const {
  try {
    return state_of(parse_json(text), mechanism_, defaults_);
  } catch (const JsonError& error) {
    // Only an error needs the lines before: the text that it shows has none of theirs.
    std::string shown(static_cast<std::size_t>(line - 1), '\n');
    throw InputError({std::make_shared<const SourceText>(SourceText{"<stdin>", shown + text}), line,
                      static_cast<int>(std::min(error.at(), text.size())) + 1},
                     error.what());
  }
}

}  // namespace alembert

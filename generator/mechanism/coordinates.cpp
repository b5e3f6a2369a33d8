// Section `coordinates`: list of names or mappings in, coordinates with indices, symbols and initial values
// out.
#include "mechanism/coordinates.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mechanism/loading.hpp"
#include "mechanism/section.hpp"

namespace alembert {

Section coordinate_section(const Document& document, const YamlNode& item) {
  return Section(document, item, "a coordinate",
                 {"name", "type", "initial", "initial_speed", "limits", "armature", "damping", "friction",
                  "stiffness", "rest", "effort", "speed"});
}

namespace {

constexpr double kUnitTolerance = 1e-6;

const YamlNode& name_node(const Document& document, const YamlNode& item) {
  if (item.kind == YamlNode::Kind::mapping) return coordinate_section(document, item).require("name");
  if (item.kind != YamlNode::Kind::scalar)
    fail_expected(document, item, "a name or a mapping as a coordinate");
  return item;
}

CoordinateType read_coordinate_type(const Document& document, const YamlNode& item) {
  if (item.kind != YamlNode::Kind::mapping) return CoordinateType::real;
  const Section section = coordinate_section(document, item);
  const YamlNode* node = section.find("type");
  if (node == nullptr) return CoordinateType::real;
  const std::string& type = expect_text(document, *node, "'real' or 'quaternion' as a coordinate's type");
  if (type == "real") return CoordinateType::real;
  if (type == "quaternion") return CoordinateType::quaternion;
  const std::vector<std::string> known = {"real", "quaternion"};
  throw InputError(document.where(*node),
                   fmt::format("unknown coordinate type '{}'{}; expected 'real' or 'quaternion'",
                               printable(type), did_you_mean(type, known)));
}

void make_symbols(ExprGraph& graph, Coordinate& coordinate) {
  const std::string& name = coordinate.name;
  const std::string speed = fmt::format("d({})", name), rate = fmt::format("dd({})", name);
  switch (coordinate.type) {
    case CoordinateType::real:
      coordinate.symbols = {graph.symbol(name)};
      coordinate.speed_symbols = {graph.symbol(speed)};
      coordinate.rate_symbols = {graph.symbol(rate)};
      break;
    case CoordinateType::quaternion:
      for (const char* part : {".x", ".y", ".z", ".w"})
        coordinate.symbols.push_back(graph.symbol(name + part));
      for (const char* part : {".x", ".y", ".z"})
        coordinate.speed_symbols.push_back(graph.symbol(speed + part));
      for (const char* part : {".x", ".y", ".z"})
        coordinate.rate_symbols.push_back(graph.symbol(rate + part));
      break;
  }
}

void read_real(Loading& loading, Coordinate& coordinate, const YamlNode* initial, const YamlNode* limits) {
  const std::string what = fmt::format("the initial value of coordinate '{}'", coordinate.name);
  const double start =
      initial != nullptr ? loading.reader.read(*initial, Allowed::constants, what).initial : 0.0;
  coordinate.initial = {start};
  if (limits != nullptr)
    coordinate.limits =
        read_limits(loading, *limits, fmt::format("coordinate '{}'", coordinate.name), start, initial);
}

void read_quaternion(Loading& loading, Coordinate& coordinate, const YamlNode* initial,
                     const YamlNode* limits) {
  const Document& document = loading.document;
  if (limits != nullptr)
    throw InputError(document.where(*limits),
                     fmt::format("quaternion coordinate '{}' takes no limits", coordinate.name));
  coordinate.initial = {0, 0, 0, 1};
  if (initial == nullptr) return;
  const std::string what = fmt::format("the initial value of quaternion '{}' (x, y, z, w)", coordinate.name);
  const auto& items = expect_list(document, *initial, what, 4);
  double squares = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    coordinate.initial[i] = loading.reader.read(*items[i], Allowed::constants, what).initial;
    squares += coordinate.initial[i] * coordinate.initial[i];
  }
  const double norm = std::sqrt(squares);
  if (!(std::abs(norm - 1) <= kUnitTolerance))
    throw InputError(
        document.where(*initial),
        fmt::format("quaternion '{}' has norm {:.9g}; expected a unit quaternion", coordinate.name, norm));
  for (double& x : coordinate.initial) x /= norm;
}

void read_initial_speed(Loading& loading, Coordinate& coordinate, const YamlNode* speed) {
  coordinate.initial_speed.assign(static_cast<std::size_t>(coordinate.nv()), 0.0);
  if (speed == nullptr) return;
  const std::string what = fmt::format("the initial speed of coordinate '{}'", coordinate.name);
  if (coordinate.type == CoordinateType::real) {
    coordinate.initial_speed[0] = loading.reader.read(*speed, Allowed::constants, what).initial;
    return;
  }
  const auto& items = expect_list(loading.document, *speed, what, coordinate.nv());
  for (std::size_t i = 0; i < items.size(); ++i)
    coordinate.initial_speed[i] = loading.reader.read(*items[i], Allowed::constants, what).initial;
}

void read_armature(Loading& loading, Coordinate& coordinate, const YamlNode* armature) {
  if (armature == nullptr) return;
  const Quantity value = loading.reader.read(*armature, Allowed::parameters,
                                             fmt::format("the armature of coordinate '{}'", coordinate.name));
  if (value.initial < 0)
    throw InputError(
        loading.document.where(*armature),
        fmt::format("the armature of coordinate '{}' is negative: {:.6g}", coordinate.name, value.initial));
  coordinate.armature = value.expr;
}

std::optional<double> read_magnitude(Loading& loading, const Coordinate& coordinate, const Section& section,
                                     std::string_view key) {
  const YamlNode* node = section.find(key);
  if (node == nullptr) return std::nullopt;
  const std::string what = fmt::format("the largest {} of coordinate '{}'", key, coordinate.name);
  const double value = loading.reader.read(*node, Allowed::constants, what).initial;
  if (value < 0)
    throw InputError(loading.document.where(*node), fmt::format("{} is negative: {:.6g}", what, value));
  return value;
}

}  // namespace

std::pair<double, double> read_limits(Loading& loading, const YamlNode& node, const std::string& of,
                                      double start, const YamlNode* initial) {
  const Document& document = loading.document;
  const std::string what = "the limits of " + of;
  const auto& items = expect_list(document, node, what, 2);
  const double lower = loading.reader.read(*items[0], Allowed::constants, what).initial;
  const double upper = loading.reader.read(*items[1], Allowed::constants, what).initial;
  if (!(lower < upper))
    throw InputError(document.where(node),
                     fmt::format("expected a lower and a larger upper limit for {}, found {:.6g} and {:.6g}",
                                 of, lower, upper));
  if (start < lower || start > upper)
    throw InputError(document.where(initial != nullptr ? *initial : node),
                     fmt::format("the initial value {:.6g} of {} is outside its limits [{:.6g}, {:.6g}]",
                                 start, of, lower, upper),
                     initial != nullptr ? "" : "initial is 0 unless given");
  return {lower, upper};
}

void declare_coordinates(Loading& loading, const YamlNode& list) {
  const Document& document = loading.document;
  Mechanism& mechanism = loading.mechanism;
  const auto& items = expect_list(document, list, "the coordinates");
  if (items.empty())
    throw InputError(document.where(list), "no coordinates; a mechanism moves by at least one");
  for (const YamlNode* item : items) {
    const YamlNode& name = name_node(document, *item);
    Coordinate coordinate;
    coordinate.type = read_coordinate_type(document, *item);
    const NameKind kind =
        coordinate.type == CoordinateType::real ? NameKind::coordinate : NameKind::quaternion;
    NameEntry& entry = loading.scope.declare(document, name, kind);
    entry.index = static_cast<int>(mechanism.coordinates.size());
    coordinate.name = name.text;
    coordinate.where = document.where(name);
    coordinate.first_q = mechanism.nq;
    coordinate.first_speed = mechanism.nv;
    coordinate.armature = loading.graph.zero();
    make_symbols(loading.graph, coordinate);
    mechanism.nq += coordinate.nq();
    mechanism.nv += coordinate.nv();
    mechanism.coordinates.push_back(std::move(coordinate));
  }
  loading.quaternion_use.resize(items.size());
}

void read_coordinate_values(Loading& loading, const YamlNode& list, std::span<const double> start) {
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlNode& item = *list.items[i];
    Coordinate& coordinate = loading.mechanism.coordinates[i];
    const YamlNode *initial = nullptr, *speed = nullptr, *limits = nullptr, *armature = nullptr;
    if (item.kind == YamlNode::Kind::mapping) {
      const Section section = coordinate_section(loading.document, item);
      initial = section.find("initial");
      speed = section.find("initial_speed");
      limits = section.find("limits");
      armature = section.find("armature");
      coordinate.effort_limit = read_magnitude(loading, coordinate, section, "effort");
      coordinate.speed_limit = read_magnitude(loading, coordinate, section, "speed");
    }
    switch (coordinate.type) {
      case CoordinateType::real:
        read_real(loading, coordinate, initial, limits);
        break;
      case CoordinateType::quaternion:
        read_quaternion(loading, coordinate, initial, limits);
        break;
    }
    for (std::size_t k = 0; k < coordinate.initial.size() && !start.empty(); ++k)
      coordinate.initial[k] = start[static_cast<std::size_t>(coordinate.first_q) + k];
    read_initial_speed(loading, coordinate, speed);
    read_armature(loading, coordinate, armature);
    for (std::size_t k = 0; k < coordinate.symbols.size(); ++k)
      loading.initial_state.emplace_back(coordinate.symbols[k], coordinate.initial[k]);
    NameEntry& entry = *loading.scope.find(coordinate.name);
    entry.ready = true;
    if (coordinate.type == CoordinateType::real)
      entry.value = {coordinate.symbols[0], coordinate.initial[0], Dependence::coordinate, nullptr};
  }
}

int expect_coordinate(Loading& loading, const YamlNode& node, CoordinateType type, std::string_view what) {
  const std::string& name =
      expect_text(loading.document, node, fmt::format("the name of a coordinate as {}", what));
  const SourceLocation where = loading.document.where(node);
  NameEntry* entry = loading.scope.find(name);
  if (entry == nullptr || entry->index < 0) {
    const std::string found = entry != nullptr
                                  ? fmt::format("'{}' is {}, not a coordinate", name, a_noun(entry->kind))
                                  : fmt::format("unknown coordinate '{}'{}", printable(name),
                                                did_you_mean(name, loading.scope.coordinate_names()));
    throw InputError(where, fmt::format("{} (as {})", found, what));
  }
  const Coordinate& coordinate = loading.mechanism.coordinates[static_cast<std::size_t>(entry->index)];
  if (coordinate.type != type)
    throw InputError(where, fmt::format("expected a {} coordinate as {}; '{}' is a {} one",
                                        type == CoordinateType::real ? "real" : "quaternion", what, name,
                                        type == CoordinateType::real ? "quaternion" : "real"));
  entry->used = true;
  return entry->index;
}

}  // namespace alembert

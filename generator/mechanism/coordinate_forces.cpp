// Forces that coordinates have by their own keys: `damping`, `friction`, `stiffness` in, forces out.
#include "mechanism/coordinate_forces.hpp"

#include <fmt/format.h>

#include "mechanism/coordinates.hpp"
#include "mechanism/section.hpp"

namespace alembert {
namespace {

/// The forces that a coordinate has by its own keys, once all names have values.
class CoordinateForces {
 public:
  CoordinateForces(Loading& loading, const Section& section, const Coordinate& coordinate)
      : loading_(loading), section_(section), coordinate_(coordinate) {}

  void read() {
    if (const YamlNode* node = section_.find("damping")) {
      const Expr b = not_negative(*node, "the damping");
      along_speeds("damping", *node, [&](const Expr& u) { return -(b * u); });
    }
    if (const YamlNode* node = section_.find("friction")) read_friction(*node);
    const YamlNode* rest = section_.find("rest");
    if (const YamlNode* node = section_.find("stiffness"))
      read_stiffness(*node, rest);
    else if (rest != nullptr)
      throw InputError(section_.where_key("rest"),
                       fmt::format("coordinate '{}' has a rest, but no stiffness", coordinate_.name));
  }

 private:
  std::string of(std::string_view what) const {
    return fmt::format("{} of coordinate '{}'", what, coordinate_.name);
  }
  Quantity quantity(const YamlNode& node, std::string_view what) {
    return loading_.reader.read(node, Allowed::parameters, of(what));
  }
  /// Used as it stands, with a warning, where it drives what it should brake.
  Expr not_negative(const YamlNode& node, std::string_view what) {
    const Quantity value = quantity(node, what);
    if (value.initial < 0)
      loading_.mechanism.warnings.push_back(
          {loading_.document.where(node), fmt::format("{} is negative: {:.6g}", of(what), value.initial)});
    return value.expr;
  }
  template <class Value>
  void along_speeds(std::string_view what, const YamlNode& node, const Value& value) {
    for (std::size_t k = 0; k < coordinate_.speed_symbols.size(); ++k) {
      Force force;
      force.name = fmt::format("{} of {}", what, coordinate_.name);
      force.kind = ForceKind::on_speed;
      force.speed = coordinate_.first_speed + static_cast<int>(k);
      force.value = value(coordinate_.speed_symbols[k]);
      force.passive = true;
      force.where = loading_.document.where(node);
      loading_.mechanism.forces.push_back(std::move(force));
    }
  }
  void read_friction(const YamlNode& node) {
    const Section friction(loading_.document, node, of("the friction"), {"force", "velocity"});
    const Expr force = not_negative(friction.require("force"), "the friction's force");
    const YamlNode& width = friction.require("velocity");
    const Quantity velocity = quantity(width, "the friction's velocity");
    if (!(velocity.initial > 0))
      throw InputError(loading_.document.where(width),
                       fmt::format("{} is {:.6g}; expected a positive one", of("the friction's velocity"),
                                   velocity.initial),
                       "the force is tanh(speed/velocity) of its largest");
    along_speeds("friction", node, [&](const Expr& u) {
      const Expr ratio = u / velocity.expr;
      return -(force * tanh(ratio));
    });
  }
  void read_stiffness(const YamlNode& node, const YamlNode* rest) {
    if (coordinate_.type != CoordinateType::real)
      throw InputError(section_.where_key("stiffness"),
                       fmt::format("quaternion coordinate '{}' takes no stiffness", coordinate_.name),
                       "a force 'potential' can be any function of the rotation of a frame");
    const Expr stiffness = quantity(node, "the stiffness").expr;
    Expr stretch = coordinate_.symbols[0];
    if (rest != nullptr) stretch -= quantity(*rest, "the rest").expr;
    const Expr square = stretch * stretch;
    Force force;
    force.name = fmt::format("stiffness of {}", coordinate_.name);
    force.kind = ForceKind::potential;
    force.value = loading_.graph.rational(Rational(1, 2)) * (stiffness * square);
    force.where = loading_.document.where(node);
    loading_.mechanism.forces.push_back(std::move(force));
  }

  Loading& loading_;
  const Section& section_;
  const Coordinate& coordinate_;
};

}  // namespace

void read_coordinate_forces(Loading& loading, const YamlNode& list) {
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    if (list.items[i]->kind != YamlNode::Kind::mapping) continue;
    const Section section = coordinate_section(loading.document, *list.items[i]);
    CoordinateForces(loading, section, loading.mechanism.coordinates[i]).read();
  }
}

}  // namespace alembert

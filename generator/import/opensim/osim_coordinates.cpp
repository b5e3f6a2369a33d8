#include "import/opensim/osim_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

constexpr const char* kCoupler = "CoordinateCouplerConstraint";

struct Coupler {
  pugi::xml_node element;
  std::vector<std::size_t> of;
};

class CoordinateRoles {
 public:
  explicit CoordinateRoles(OsimDescription& out) : out_(out), couplers_(out.model.coordinates.size()) {}

  void add() {
    read_couplers();
    const auto& all = out_.model.coordinates;
    out_.coordinate_names.resize(all.size());
    out_.independent.assign(all.size(), false);
    out_.driven.assign(all.size(), false);
    for (std::size_t i = 0; i < all.size(); ++i)
      out_.coordinate_names[i] = out_.names.add(all[i].name, all[i].where);
    marks_.assign(all.size(), Mark::unseen);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!couplers_[i].element) add(i);
    for (std::size_t i = 0; i < all.size(); ++i) add(i);
    if (out_.sections["coordinates"]->items.empty())
      throw InputError(out_.model.where, "no coordinate of the model moves");
  }

 private:
  enum class Mark { unseen, open, done };

  void read_couplers() {
    for (const pugi::xml_node element : osim_constraints(out_)) {
      if (std::string_view(element.name()) != kCoupler || !osim_is_enforced(out_.xml, element)) continue;
      const std::string what = OsimXml::title(element);
      Coupler coupler{element, {}};
      for (const std::string& name : OsimXml::words(element, "independent_coordinate_names"))
        coupler.of.push_back(resolve_osim_coordinate(out_.model, name, out_.xml.where(element), what));
      const std::size_t dependent = resolve_osim_coordinate(
          out_.model, OsimXml::text(element, "dependent_coordinate_name"), out_.xml.where(element), what);
      if (coupler.of.empty())
        throw InputError(out_.xml.where(element), what + " has no independent coordinate");
      const OsimCoordinate& coordinate = out_.model.coordinates[dependent];
      if (coordinate.locked || coordinate.prescribed || couplers_[dependent].element) {
        throw InputError(out_.xml.where(element),
                         fmt::format("'{}' follows others, but is {} already", printable(coordinate.name),
                                     coordinate.locked       ? "locked"
                                     : coordinate.prescribed ? "prescribed"
                                                             : "coupled"));
      }
      couplers_[dependent] = coupler;
    }
  }

  /// With what it follows before it; not by recursion, since a file may have a chain longer than the stack.
  void add(std::size_t i) {
    std::vector<std::size_t> open{i};
    while (!open.empty()) {
      const std::size_t at = open.back();
      const std::vector<std::size_t>& of = couplers_[at].of;
      const auto next =
          std::ranges::find_if(of, [&](std::size_t each) { return marks_[each] != Mark::done; });
      if (marks_[at] == Mark::done || next == of.end()) {
        if (marks_[at] != Mark::done) describe(at);
        open.pop_back();
        continue;
      }
      marks_[at] = Mark::open;
      if (const OsimCoordinate& leader = out_.model.coordinates[*next]; marks_[*next] == Mark::open)
        throw InputError(leader.where, fmt::format("coordinate '{}' follows itself by way of others",
                                                   printable(leader.name)));
      open.push_back(*next);
    }
  }

  void describe(std::size_t i) {
    const OsimCoordinate& coordinate = out_.model.coordinates[i];
    const std::string& name = out_.coordinate_names[i];
    if (const Coupler& coupler = couplers_[i]; coupler.element) {
      std::vector<std::string> arguments;
      for (const std::size_t of : coupler.of) arguments.push_back(out_.coordinate_names[of]);
      const pugi::xml_node element = find_osim_function(coupler.element, "coupled_coordinates_function");
      if (!element)
        throw InputError(out_.xml.where(coupler.element),
                         "no <coupled_coordinates_function> in a " + std::string(kCoupler));
      const OsimFunction function = read_osim_function(out_.xml, element, arguments);
      if (!function.smooth)
        throw InputError(out_.xml.where(element),
                         "a coordinate follows by a function that is not twice differentiable");
      const double scale = out_.xml.number(coupler.element, "scale_factor", 1);
      out_.driven[i] = !function.constant &&
                       std::ranges::any_of(coupler.of, [&](std::size_t of) { return out_.driven[of]; });
      if (function.linear) out_.follows[i] = {coupler.of[0], scale * (*function.linear)[0]};
      out_.definitions.push_back({name, scaled_text(scale, function), out_.xml.where(coupler.element)});
      out_.took(kCoupler);
    } else if (coordinate.locked) {
      out_.parameters.push_back({name, number_text(coordinate.value), coordinate.where});
      out_.took("locked coordinates");
    } else if (coordinate.prescribed) {
      const OsimFunction function = read_osim_function(out_.xml, coordinate.prescribed, {"t"});
      if (!function.smooth)
        throw InputError(coordinate.where,
                         "a coordinate is prescribed by a function that is not twice differentiable");
      out_.definitions.push_back({name, function.text, coordinate.where});
      out_.took("prescribed coordinates");
    } else {
      add_independent(i);
    }
    marks_[i] = Mark::done;
  }

  void add_independent(std::size_t i) {
    const OsimCoordinate& coordinate = out_.model.coordinates[i];
    out_.independent[i] = out_.driven[i] = true;
    const SourceLocation& at = coordinate.where;
    YamlNode& node = out_.nodes.add_named(*out_.sections["coordinates"], out_.coordinate_names[i], at);
    if (coordinate.value != 0) out_.put(node, "initial", number_text(coordinate.value), at);
    if (coordinate.speed != 0) out_.put(node, "initial_speed", number_text(coordinate.speed), at);
    if (coordinate.range) {
      const auto [low, high] = *coordinate.range;
      if (low <= coordinate.value && coordinate.value <= high && low < high)
        out_.nodes.put(node, "limits", out_.nodes.list({number_text(low), number_text(high)}, at));
      else
        out_.warnings.push_back(
            {at,
             fmt::format("coordinate '{}' starts at {}, outside of its range: it has no limits",
                         printable(coordinate.name), number_text(coordinate.value)),
             {},
             "outside range"});
    }
    out_.took("coordinates");
  }

  OsimDescription& out_;
  std::vector<Coupler> couplers_;  // by dependent coordinate
  std::vector<Mark> marks_;
};

}  // namespace

void add_osim_coordinates(OsimDescription& out) {
  CoordinateRoles(out).add();
}

std::vector<pugi::xml_node> osim_constraints(const OsimDescription& of) {
  std::vector<pugi::xml_node> out = of.xml.objects(of.model.element, "ConstraintSet");
  for (const pugi::xml_node element : of.xml.components(of.model.element))
    if (std::string_view(element.name()).ends_with("Constraint")) out.push_back(element);
  return out;
}

bool osim_is_enforced(const OsimXml& xml, pugi::xml_node constraint) {
  return xml.flag(constraint, "isEnforced", true) && !xml.flag(constraint, "isDisabled", false);
}

}  // namespace alembert

// <link>: its inertia, which makes the equations, and what is drawn of it, which does not.
#include "import/urdf/link_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace alembert {
namespace {

std::optional<Colour> read_colour(const XmlText& xml, pugi::xml_node material) {
  std::optional<Colour> colour;
  const pugi::xml_attribute rgba = material.child("color").attribute("rgba");
  if (!rgba) return colour;
  xml.tolerate("it is left out", [&] {
    const std::array<double, 4> values = xml.numbers<4>(rgba, "a color");
    colour.emplace();
    for (std::size_t i = 0; i < 3; ++i) (*colour)[i] = std::clamp(values[i], 0.0, 1.0);
    for (const double value : values)
      if (value < 0 || value > 1)
        throw InputError(xml.where(rgba), fmt::format("a color has components from 0 to 1, found {}", value));
  });
  return colour;
}

double read_entry(const XmlText& xml, pugi::xml_node inertia, const char* name, const std::string& what) {
  const bool diagonal = name[1] == name[2];
  const std::string of = "the inertia in " + what;
  if (diagonal || inertia.attribute(name))
    return xml.number(xml.require_attribute(inertia, name, of), fmt::format("{} of {}", name, what));
  xml.warn(
      {xml.where(inertia), fmt::format("no attribute '{}' of {}; it is 0", name, of), {}, "inertia entry"});
  return 0;
}

UrdfInertial read_inertial(const XmlText& xml, pugi::xml_node element, const std::string& what) {
  xml.check_spelling(element, what, {"origin", "mass", "inertia"}, {});
  UrdfInertial out;
  out.origin = read_origin(xml, element, what);
  out.mass_where = out.inertia_where = xml.where(element);
  if (const pugi::xml_node mass = xml.find(element, "mass", what)) {
    xml.check_spelling(mass, "the mass in " + what, {}, {"value"});
    const pugi::xml_attribute value = xml.require_attribute(mass, "value", "the mass in " + what);
    out.mass = xml.number(value, "the mass in " + what);
    out.mass_where = xml.where(value);
  } else {
    xml.warn({xml.where(element), fmt::format("no <mass> in {}; it is 0", what), {}, "no mass"});
  }
  const pugi::xml_node inertia = xml.find(element, "inertia", what);
  if (!inertia) {
    xml.warn(
        {xml.where(element), fmt::format("no <inertia> in {}; its mass is a point", what), {}, "no inertia"});
    return out;
  }
  out.inertia_where = xml.where(inertia);
  // Some write the lower half as well.
  xml.check_spelling(inertia, "the inertia in " + what, {},
                     {"ixx", "iyy", "izz", "ixy", "ixz", "iyz", "iyx", "izx", "izy"});
  constexpr const char* kEntries[] = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
  for (std::size_t i = 0; i < 6; ++i) out.inertia[i] = read_entry(xml, inertia, kEntries[i], what);
  return out;
}

/// A size that is drawn.
void check_positive(const XmlText& xml, pugi::xml_attribute attribute, double size, const std::string& what) {
  if (!(size > 0))
    throw InputError(xml.where(attribute),
                     fmt::format("expected a positive number as {}, found {}", what, size));
}

/// Nothing if the shape is one that is unknown.
std::optional<UrdfShape> read_shape(const XmlText& xml, pugi::xml_node visual, const std::string& what,
                                    const Colours& colours) {
  xml.check_spelling(visual, what, {"origin", "geometry", "material"}, {"name", "group"});
  const pugi::xml_node geometry = xml.require(visual, "geometry", what);
  xml.check_spelling(geometry, "the geometry of " + what, {"box", "sphere", "cylinder", "capsule", "mesh"},
                     {"name"});
  UrdfShape shape;
  shape.where = xml.where(geometry);
  const auto sizes = [&](pugi::xml_node element, SolidKind kind, std::initializer_list<const char*> names) {
    shape.kind = kind;
    std::size_t i = 0;
    for (const char* name : names) {
      const std::string of = fmt::format("the {} of {}", name, what);
      const pugi::xml_attribute attribute =
          xml.require_attribute(element, name, fmt::format("the {} of {}", element.name(), what));
      shape.sizes[i] = xml.number(attribute, of);
      check_positive(xml, attribute, shape.sizes[i++], of);
    }
  };
  if (const pugi::xml_node box = geometry.child("box")) {
    const std::string of = "the box of " + what;
    const pugi::xml_attribute size = xml.require_attribute(box, "size", of);
    shape.kind = SolidKind::box;
    shape.sizes = xml.numbers<3>(size, "the size of " + of);
    for (const double edge : shape.sizes) check_positive(xml, size, edge, "an edge of " + of);
  } else if (const pugi::xml_node sphere = geometry.child("sphere")) {
    sizes(sphere, SolidKind::sphere, {"radius"});
  } else if (const pugi::xml_node cylinder = geometry.child("cylinder")) {
    sizes(cylinder, SolidKind::cylinder, {"radius", "length"});
  } else if (const pugi::xml_node capsule = geometry.child("capsule")) {
    sizes(capsule, SolidKind::capsule, {"radius", "length"});
  } else if (const pugi::xml_node mesh = geometry.child("mesh")) {
    const std::string of = "the mesh of " + what;
    shape.kind = SolidKind::mesh;
    shape.file = xml.require_attribute(mesh, "filename", of).value();
    const pugi::xml_attribute scale = mesh.attribute("scale");
    shape.sizes = scale ? xml.numbers<3>(scale, "the scale of " + of) : std::array<double, 3>{1, 1, 1};
    for (const double each : shape.sizes)
      if (each == 0) throw InputError(xml.where(scale), fmt::format("the scale of {} is 0", of));
  } else {
    return std::nullopt;
  }
  shape.origin = read_origin(xml, visual, what);
  if (const pugi::xml_node material = visual.child("material")) {
    const auto known = colours.find(material.attribute("name").value());
    shape.colour = read_colour(xml, material);
    if (!shape.colour && known != colours.end()) shape.colour = known->second;
  }
  return shape;
}

}  // namespace

UrdfPose read_origin(const XmlText& xml, pugi::xml_node element, const std::string& what) {
  UrdfPose pose;
  const pugi::xml_node origin = xml.find(element, "origin", what);
  pose.where = xml.where(origin ? origin : element);
  if (!origin) return pose;
  const std::string of = "the origin of " + what;
  xml.check_spelling(origin, of, {}, {"xyz", "rpy"});
  if (const pugi::xml_attribute xyz = origin.attribute("xyz"))
    pose.xyz = xml.numbers<3>(xyz, "the shift of " + of);
  if (const pugi::xml_attribute rpy = origin.attribute("rpy"))
    pose.rpy = xml.numbers<3>(rpy, "roll, pitch and yaw of " + of);
  return pose;
}

void read_material(const XmlText& xml, pugi::xml_node material, Colours& colours) {
  const pugi::xml_attribute name = material.attribute("name");
  const std::optional<Colour> colour = read_colour(xml, material);
  if (!colour) return;
  const auto [entry, inserted] = colours.emplace(name.value(), *colour);
  if (!inserted && entry->second != *colour)
    xml.warn({xml.where(material),
              fmt::format("a second material '{}'; the first one is used", printable(name.value())),
              {},
              "material twice"});
}

UrdfLink read_link(const XmlText& xml, pugi::xml_node element, const Colours& colours) {
  UrdfLink link;
  const pugi::xml_attribute name = xml.require_attribute(element, "name", "a link");
  link.name = name.value();
  link.where = xml.where(name);
  const std::string what = fmt::format("link '{}'", printable(link.name));
  xml.check_spelling(element, what, {"inertial", "visual", "collision", "contact", "sensor"},
                     {"name", "type"});
  if (const pugi::xml_node inertial = xml.find(element, "inertial", what))
    link.inertial = read_inertial(xml, inertial, "the inertial of " + what);
  for (const pugi::xml_node visual : element.children("visual")) {
    xml.tolerate("the shape is left out", [&] {
      if (auto shape = read_shape(xml, visual, "a visual of " + what, colours))
        link.shapes.push_back(std::move(*shape));
    });
  }
  return link;
}

}  // namespace alembert

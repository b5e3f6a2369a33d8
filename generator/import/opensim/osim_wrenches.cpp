#include "import/opensim/osim_wrenches.hpp"

#include <fmt/format.h>

#include <cmath>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_forces.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

/// Components of size times a direction, which is divided by its length.
std::array<std::string, 3> along_direction(const OsimXml& xml, pugi::xml_node element, const char* property,
                                           const std::array<double, 3>& otherwise, const std::string& of) {
  const std::array<double, 3> v = xml.vector<3>(element, property, otherwise);
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length == 0)
    throw InputError(xml.where(element), fmt::format("<{}> of {} is 0", property, OsimXml::title(element)));
  const double size = xml.number(element, "optimal_force", 1) / length;
  std::array<std::string, 3> out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = v[i] == 0 ? "0" : fmt::format("{}*{}", number_text(size * v[i]), of);
  return out;
}

std::size_t body_of(OsimDescription& out, pugi::xml_node element, const char* property) {
  return resolve_osim_frame(out.model, OsimXml::text(element, property), "/forceset", out.xml.where(element),
                            OsimXml::title(element));
}

void put_wrench(OsimDescription& out, const std::string& name, const std::string& frame, bool world,
                const char* what, const std::array<std::string, 3>& value, const SourceLocation& at) {
  YamlNode& force = out.add_force(name, at);
  out.put(force, "at", frame, at);
  out.put(force, "axes", world ? "world" : "frame", at);
  out.nodes.put(force, what, out.nodes.list({value[0], value[1], value[2]}, at));
}

std::string control_of(OsimDescription& out, pugi::xml_node element) {
  return out.add_input(OsimXml::name_of(element), 0, osim_control_limits(out.xml, element),
                       out.xml.where(element));
}

}  // namespace

bool add_torque_actuator(OsimDescription& out, pugi::xml_node element) {
  if (OsimXml::text(element, "bodyA").empty()) return false;
  const SourceLocation at = out.xml.where(element);
  const std::string name = OsimXml::name_of(element);
  const std::size_t a = body_of(out, element, "bodyA");
  const std::size_t b = OsimXml::text(element, "bodyB").empty() ? 0 : body_of(out, element, "bodyB");
  const bool world = out.xml.flag(element, "torque_is_global", true);
  std::array<std::string, 3> torque =
      along_direction(out.xml, element, "axis", {0, 0, 1}, control_of(out, element));
  if (!world) {
    const std::string frame = out.add_frame(name + "_a", a, {"0", "0", "0"}, at);
    std::array<std::string, 3> turned;
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<std::string> terms;
      for (std::size_t k = 0; k < 3; ++k)
        if (torque[k] != "0")
          terms.push_back(fmt::format("{}*rotation({}).{}{}", torque[k], frame, "xyz"[i], "xyz"[k]));
      turned[i] = sum_text(terms);
    }
    torque = turned;
  }
  // Nothing turns the ground.
  if (out.model.frames[a].body != 0)
    put_wrench(out, name, out.add_frame(name + "_a", a, {"0", "0", "0"}, at), true, "torque", torque, at);
  if (out.model.frames[b].body == 0) return true;
  for (std::string& component : torque)
    if (component != "0") component = "-(" + component + ")";
  put_wrench(out, name + "_reaction", out.add_frame(name + "_b", b, {"0", "0", "0"}, at), true, "torque",
             torque, at);
  return true;
}

bool add_point_actuator(OsimDescription& out, pugi::xml_node element) {
  if (OsimXml::text(element, "body").empty() || out.xml.flag(element, "point_is_global", false)) return false;
  const SourceLocation at = out.xml.where(element);
  const std::string name = OsimXml::name_of(element);
  const std::size_t body = body_of(out, element, "body");
  const auto [x, y, z] = out.xml.vector<3>(element, "point", {});
  const std::string frame =
      out.add_frame(name + "_point", body, {number_text(x), number_text(y), number_text(z)}, at);
  put_wrench(out, name, frame, out.xml.flag(element, "force_is_global", false), "force",
             along_direction(out.xml, element, "direction", {1, 0, 0}, control_of(out, element)), at);
  return true;
}

}  // namespace alembert

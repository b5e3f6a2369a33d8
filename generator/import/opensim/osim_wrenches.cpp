#include "import/opensim/osim_wrenches.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_forces.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

using Text3 = std::array<std::string, 3>;

/// Components of size times a direction, which is divided by its length.
Text3 along_direction(const OsimXml& xml, pugi::xml_node element, const char* property,
                      const std::array<double, 3>& otherwise, const std::string& of) {
  const std::array<double, 3> v = xml.vector<3>(element, property, otherwise);
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length == 0)
    throw InputError(xml.where(element), fmt::format("<{}> of {} is 0", property, OsimXml::title(element)));
  const double size = xml.number(element, "optimal_force", 1) / length;
  Text3 out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = v[i] == 0 ? "0" : fmt::format("{}*{}", number_text(size * v[i]), of);
  return out;
}

std::size_t body_of(OsimDescription& out, pugi::xml_node element, const char* property) {
  return resolve_osim_frame(out.model, OsimXml::text(element, property), "/forceset", out.xml.where(element),
                            OsimXml::title(element));
}

YamlNode& begin_wrench(OsimDescription& out, const std::string& name, const std::string& frame, bool world,
                       const SourceLocation& at) {
  YamlNode& force = out.add_force(name, at);
  out.put(force, "at", frame, at);
  out.put(force, "axes", world ? "world" : "frame", at);
  return force;
}

void put_vector(OsimDescription& out, YamlNode& force, const char* what, const Text3& value,
                const SourceLocation& at) {
  out.nodes.put(force, what, out.nodes.list({value[0], value[1], value[2]}, at));
}

void put_wrench(OsimDescription& out, const std::string& name, const std::string& frame, bool world,
                const char* what, const Text3& value, const SourceLocation& at) {
  put_vector(out, begin_wrench(out, name, frame, world, at), what, value, at);
}

Text3 cross_text(const Text3& a, const Text3& b) {
  const auto term = [&](std::size_t i, std::size_t k) {
    return a[i] == "0" || b[k] == "0" ? std::string() : fmt::format("{}*{}", a[i], b[k]);
  };
  Text3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    std::vector<std::string> terms;
    if (const std::string first = term(j, k); !first.empty()) terms.push_back(first);
    if (const std::string second = term(k, j); !second.empty()) terms.push_back("-" + second);
    out[i] = terms.empty() ? "0" : "(" + sum_text(terms) + ")";
  }
  return out;
}

/// A vector in the axes of a frame as one in the world's, or the other way.
Text3 turned_text(const std::string& frame, const Text3& of, bool to_world) {
  Text3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<std::string> terms;
    for (std::size_t k = 0; k < 3; ++k)
      if (of[k] != "0")
        terms.push_back(fmt::format("{}*rotation({}).{}{}", of[k], frame, "xyz"[to_world ? i : k],
                                    "xyz"[to_world ? k : i]));
    out[i] = sum_text(terms);
  }
  return out;
}

/// Three functions of time; none if the set is empty.
std::optional<Text3> functions_of_time(const OsimXml& xml, pugi::xml_node element, const char* set) {
  pugi::xml_node found = element.child(set);
  if (!found) found = element.find_child_by_attribute("FunctionSet", "name", set);
  const std::vector<pugi::xml_node> functions = OsimXml::elements(found.child("objects"));
  if (functions.empty()) return {};
  if (functions.size() != 3)
    throw InputError(xml.where(found), fmt::format("expected three functions as {} of {}, found {}", set,
                                                   OsimXml::title(element), functions.size()));
  Text3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const OsimFunction function = read_osim_function(xml, functions[i], {"t"});
    out[i] = function.constant ? number_text(*function.constant) : "(" + function.text + ")";
  }
  return out;
}

}  // namespace

bool add_torque_actuator(OsimDescription& out, pugi::xml_node element) {
  if (OsimXml::text(element, "bodyA").empty()) return false;
  const SourceLocation at = out.xml.where(element);
  const std::string name = OsimXml::name_of(element);
  const std::size_t a = body_of(out, element, "bodyA");
  const std::size_t b = OsimXml::text(element, "bodyB").empty() ? 0 : body_of(out, element, "bodyB");
  const bool world = out.xml.flag(element, "torque_is_global", true);
  Text3 torque = along_direction(out.xml, element, "axis", {0, 0, 1}, osim_control(out, element));
  if (!world) {
    const std::string frame = out.add_frame(name + "_a", a, {"0", "0", "0"}, at);
    torque = turned_text(frame, torque, true);
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
             along_direction(out.xml, element, "direction", {1, 0, 0}, osim_control(out, element)), at);
  return true;
}

bool add_prescribed_force(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const std::string body = OsimXml::text(element, {"socket_frame", "body"});
  const std::size_t on = resolve_osim_frame(out.model, body, "/forceset", at, OsimXml::title(element));
  const std::optional<Text3> force = functions_of_time(out.xml, element, "forceFunctions"),
                             point = functions_of_time(out.xml, element, "pointFunctions"),
                             torque = functions_of_time(out.xml, element, "torqueFunctions");
  if (out.model.frames[on].body == 0) return true;  // nothing moves the ground
  const std::string name = OsimXml::name_of(element),
                    frame = out.add_frame(name + "_frame", on, {"0", "0", "0"}, at);
  const bool world = out.xml.flag(element, "forceIsGlobal", true);
  Text3 sum = torque.value_or(Text3{"0", "0", "0"});
  if (force && point) {
    Text3 arm = *point;
    const bool from_world = out.xml.flag(element, "pointIsGlobal", false);
    if (from_world)
      for (std::size_t i = 0; i < 3; ++i)
        arm[i] = fmt::format("({})", sum_text({arm[i], fmt::format("-position({}).{}", frame, "xyz"[i])}));
    if (from_world != world) {
      arm = turned_text(frame, arm, world);
      for (std::string& entry : arm)
        if (entry != "0") entry = "(" + entry + ")";
    }
    const Text3 turn = cross_text(arm, *force);
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] = sum[i] == "0" ? turn[i] : (turn[i] == "0" ? sum[i] : sum_text({sum[i], turn[i]}));
  }
  const auto acts = [](const Text3& of) { return of != Text3{"0", "0", "0"}; };
  YamlNode& node = begin_wrench(out, name, frame, world, at);
  const Text3 pushes = force.value_or(Text3{"0", "0", "0"});
  if (acts(pushes) || !acts(sum)) put_vector(out, node, "force", pushes, at);
  if (acts(sum)) put_vector(out, node, "torque", sum, at);
  return true;
}

}  // namespace alembert

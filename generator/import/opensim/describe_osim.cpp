// Bodies with their transforms, frames and markers; forces and constraints come from their own files.
#include "import/opensim/describe_osim.hpp"

#include <algorithm>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_constraints.hpp"
#include "import/opensim/osim_coordinates.hpp"
#include "import/opensim/osim_forces.hpp"
#include "import/opensim/osim_sockets.hpp"
#include "import/opensim/osim_spelling.hpp"

namespace alembert {
namespace {

constexpr std::string_view kVitalOsim[] = {"mass",
                                           "mass_center",
                                           "inertia",
                                           "inertia_xx",
                                           "inertia_yy",
                                           "inertia_zz",
                                           "inertia_xy",
                                           "inertia_xz",
                                           "inertia_yz",
                                           "location",
                                           "orientation",
                                           "translation",
                                           "coordinates",
                                           "axis",
                                           "coefficients",
                                           "default_value",
                                           "parent_body",
                                           "Body",
                                           "Coordinate",
                                           "SpatialTransform",
                                           "gravity",
                                           "stiffness",
                                           "viscosity",
                                           "rest_length",
                                           "optimal_force",
                                           "max_isometric_force",
                                           "optimal_fiber_length",
                                           "tendon_slack_length"};
constexpr XmlFormat kOsim{"OpenSimDocument", kVitalOsim, kOlderSocketEnd, true};

void add_body(OsimDescription& out, std::size_t index) {
  const OsimBody& body = out.model.bodies[index];
  const OsimJoint& joint = out.model.joints[out.model.joint_of[index]];
  const SourceLocation &at = body.where, &joint_at = joint.where;
  const OsimFrame &parent = out.model.frames[joint.parent], &child = out.model.frames[joint.child];
  YamlNode& node = out.nodes.add_named(*out.sections["bodies"], out.bodies[index], at);
  const std::string& carrier = out.bodies[joint.reversed ? child.body : parent.body];
  if (carrier != "world") out.put(node, "parent", carrier, joint_at);
  std::vector<std::string> q, coordinate_names;
  for (const std::size_t coordinate : joint.coordinates) {
    q.push_back(out.text_of(coordinate));
    coordinate_names.push_back(out.model.coordinates[coordinate].name);
  }
  YamlNode& transform = out.nodes.sequence(joint_at);
  if (joint.reversed) {
    out.factors.add_offsets(transform, child, joint_at);
    YamlNode& motion = out.nodes.sequence(joint_at);
    out.factors.add_motion(motion, joint, q, coordinate_names);
    if (!motion.items.empty()) transform.items.push_back(&out.nodes.single("inverse", motion));
    out.factors.add_inverse(transform, parent, joint_at);
  } else {
    out.factors.add_offsets(transform, parent, joint_at);
    out.factors.add_motion(transform, joint, q, coordinate_names);
    out.factors.add_inverse(transform, child, joint_at);
  }
  if (!transform.items.empty()) out.nodes.put(node, "transform", transform);
  if (body.mass != 0) {
    out.put(node, "mass", number_text(body.mass), at);
    if (body.mass_center != std::array<double, 3>{})
      out.nodes.put(node, "com", out.nodes.numbers(body.mass_center, at));
  }
  if (std::ranges::any_of(body.inertia, [](double entry) { return entry != 0; })) {
    YamlNode& inertia = out.nodes.mapping(at);
    constexpr const char* kKeys[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
    for (std::size_t i = 0; i < 6; ++i)
      if (i < 3 || body.inertia[i] != 0) out.put(inertia, kKeys[i], number_text(body.inertia[i]), at);
    out.nodes.put(node, "inertia", inertia);
  }
  out.took(joint.type);
}

void add_marker(OsimDescription& out, pugi::xml_node marker) {
  const SourceLocation at = out.xml.where(marker);
  const std::string on = OsimXml::text(marker, {"socket_parent_frame", "body", "socket_reference_frame"});
  const std::size_t frame = resolve_osim_frame(out.model, on, "/markerset", at, OsimXml::title(marker));
  const auto [x, y, z] = out.xml.vector<3>(marker, "location", {});
  out.add_frame(OsimXml::name_of(marker), frame, {number_text(x), number_text(y), number_text(z)}, at);
  out.took("markers");
}

}  // namespace

DescribedRobot describe_osim(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                             Warnings& warnings) {
  const XmlText text(source, warnings, kOsim);
  const OsimXml xml(text);
  const OsimModel model = read_osim_model(xml, text.root());
  OsimDescription out(model, xml, options);
  check_osim_spelling(text, model, osim_known_forces(out));
  add_osim_coordinates(out);
  for (std::size_t body = 1; body < model.bodies.size(); ++body) add_body(out, body);
  for (std::size_t frame = 0; frame < model.frames.size(); ++frame)
    if (model.frames[frame].own) out.frame_of(frame, model.frames[frame].where);
  for (const pugi::xml_node marker : OsimXml::elements(model.element.child("MarkerSet").child("objects")))
    add_marker(out, marker);
  add_osim_forces(out);
  add_osim_constraints(out);
  YamlNode& root = out.finish();
  return {Document(source, out.nodes.take(), root), std::move(out.warnings),
          left_text(out.nearly, out.left_out)};
}

}  // namespace alembert

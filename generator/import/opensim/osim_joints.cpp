#include "import/opensim/osim_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

/// A letter for each coordinate: r in radians, t in metres; * is said by the joint.
struct JointType {
  std::string_view name, coordinates;
};
constexpr JointType kOsimJointTypes[] = {{"PinJoint", "r"},         {"SliderJoint", "t"},
                                         {"WeldJoint", ""},         {"UniversalJoint", "rr"},
                                         {"BallJoint", "rrr"},      {"GimbalJoint", "rrr"},
                                         {"FreeJoint", "rrrttt"},   {"PlanarJoint", "rtt"},
                                         {"EllipsoidJoint", "rrr"}, {"ScapulothoracicJoint", "rrrr"},
                                         {"CustomJoint", "*"}};

constexpr const char* kSpatialAxes[] = {"rotation1",    "rotation2",    "rotation3",
                                        "translation1", "translation2", "translation3"};

std::array<pugi::xml_node, 6> transform_axes(const OsimXml& xml, pugi::xml_node joint) {
  std::array<pugi::xml_node, 6> out;
  if (const pugi::xml_node old = joint.child("TransformAxisSet"))
    throw InputError(xml.where(old), "a <TransformAxisSet> is of OpenSim before 2.0, which is not read",
                     "a later OpenSim saves the model with a <SpatialTransform>");
  for (const pugi::xml_node axis : joint.child("SpatialTransform").children("TransformAxis")) {
    const std::string name = OsimXml::name_of(axis);
    const auto which = std::ranges::find(kSpatialAxes, name);
    if (which == std::end(kSpatialAxes)) {
      const std::vector<std::string> known(std::begin(kSpatialAxes), std::end(kSpatialAxes));
      throw InputError(xml.where(axis), fmt::format("a TransformAxis of unknown name '{}'{}", printable(name),
                                                    did_you_mean(name, known)));
    }
    pugi::xml_node& place = out[static_cast<std::size_t>(which - std::begin(kSpatialAxes))];
    if (place) throw InputError(xml.where(axis), fmt::format("a second TransformAxis '{}'", name));
    place = axis;
  }
  return out;
}

/// Without a function it is the coordinate itself, or 0.
OsimFunction axis_function(const OsimXml& xml, pugi::xml_node axis,
                           const std::vector<std::string>& arguments) {
  if (const pugi::xml_node function = find_osim_function(axis, "function"))
    return read_osim_function(xml, function, arguments);
  OsimFunction out;
  out.text = arguments.empty() ? "0" : arguments[0];
  if (arguments.empty())
    out.constant = 0;
  else
    out.linear = {1, 0};
  return out;
}

/// Whether OpenSim counts it among angles: where it is one about an axis, or its negative, without a curve between.
bool turns(const OsimXml& xml, pugi::xml_node joint, const std::string& coordinate) {
  const std::array<pugi::xml_node, 6> axes = transform_axes(xml, joint);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<std::string> names = OsimXml::words(axes[i], "coordinates");
    if (std::ranges::find(names, coordinate) == names.end()) continue;
    const pugi::xml_node function = find_osim_function(axes[i], "function");
    if (function && std::string_view(function.name()) != "LinearFunction") continue;
    const OsimFunction of = axis_function(xml, axes[i], names);
    if (of.linear && std::abs((*of.linear)[0]) == 1) return true;
  }
  return false;
}

std::array<double, 3> unit(const OsimXml& xml, pugi::xml_node axis, const std::array<double, 3>& otherwise) {
  if (axis && !axis.child("axis")) throw InputError(xml.where(axis), "no <axis> in a TransformAxis");
  std::array<double, 3> out = xml.vector<3>(axis, "axis", otherwise);
  const double length = std::sqrt(std::inner_product(out.begin(), out.end(), out.begin(), 0.0));
  if (length == 0) throw InputError(xml.where(axis.child("axis")), "an axis of length 0");
  if (std::ranges::count(out, 0.0) == 2 || std::abs(length - 1) > 1e-15)
    for (double& entry : out) entry /= length;
  return out;
}

constexpr std::array<double, 3> kAxis[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

std::string negated(const std::string& angle) {
  return angle[0] == '-' ? angle.substr(1) : "-" + angle;
}

}  // namespace

void read_osim_coordinates(const OsimXml& xml, OsimJoint& joint, std::size_t index,
                           std::vector<OsimCoordinate>& all) {
  const auto type = std::ranges::find(kOsimJointTypes, std::string_view(joint.type), &JointType::name);
  if (type == std::end(kOsimJointTypes)) {
    std::vector<std::string> names;
    for (const JointType& known : kOsimJointTypes) names.emplace_back(known.name);
    throw InputError(joint.where, fmt::format("a joint of unknown type <{}>{}", printable(joint.type),
                                              did_you_mean(joint.type, names)));
  }
  std::vector<pugi::xml_node> elements = xml.objects(joint.element, "CoordinateSet");
  for (const pugi::xml_node element : joint.element.child("coordinates").children("Coordinate"))
    elements.push_back(element);
  const bool custom = type->coordinates == "*";
  if (!custom && elements.size() > type->coordinates.size())
    throw InputError(xml.where(elements.back()),
                     fmt::format("{} has {} coordinates, and {} are given", OsimXml::title(joint.element),
                                 type->coordinates.size(), elements.size()));
  // What is not given is named by its number.
  if (!custom) elements.resize(type->coordinates.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const pugi::xml_node element = elements[i];
    OsimCoordinate out;
    out.joint = index;
    out.name = element ? OsimXml::name_of(element) : fmt::format("{}_coord_{}", joint.name, i);
    out.where = element ? xml.where(element) : joint.where;
    out.value = xml.number(element, "default_value", 0);
    out.speed = xml.number(element, "default_speed_value", 0);
    if (element.child("range")) out.range = xml.range(element, "range");
    out.locked = xml.flag(element, "locked", false);
    if (xml.flag(element, "prescribed", false))
      out.prescribed = find_osim_function(element, "prescribed_function");
    out.rotational = custom ? turns(xml, joint.element, out.name) : type->coordinates[i] == 'r';
    joint.coordinates.push_back(all.size());
    all.push_back(out);
  }
}

void OsimFactors::add_turn(YamlNode& out, const std::string& axis, const std::string& angle,
                           const SourceLocation& where) const {
  if (angle == "0") return;
  YamlNode& turn = nodes_.mapping(where);
  nodes_.put(turn, "axis", nodes_.text(axis, where));
  nodes_.put(turn, "angle", nodes_.text(angle, where));
  out.items.push_back(&nodes_.single("rotate", turn));
}

void OsimFactors::add_turn(YamlNode& out, const std::array<double, 3>& axis, const std::string& angle,
                           const SourceLocation& where) const {
  if (angle == "0") return;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name(1, static_cast<char>('x' + i));
    std::array<double, 3> minus = kAxis[i];
    minus[i] = -1;
    if (axis == kAxis[i]) return add_turn(out, name, angle, where);
    const bool word = angle.find_first_of(" +*/") == std::string::npos;
    if (axis == minus) return add_turn(out, name, word ? negated(angle) : "-(" + angle + ")", where);
  }
  YamlNode& turn = nodes_.mapping(where);
  nodes_.put(turn, "axis", nodes_.numbers(axis, where));
  nodes_.put(turn, "angle", nodes_.text(angle, where));
  out.items.push_back(&nodes_.single("rotate", turn));
}

void OsimFactors::add_shift(YamlNode& out, const std::array<std::string, 3>& by,
                            const SourceLocation& where) const {
  if (std::ranges::all_of(by, [](const std::string& text) { return text == "0"; })) return;
  out.items.push_back(&nodes_.single("translate", nodes_.list({by[0], by[1], by[2]}, where)));
}

void OsimFactors::add_turns(YamlNode& out, const std::vector<std::string>& angles,
                            const SourceLocation& where) const {
  for (std::size_t i = 0; i < 3; ++i) add_turn(out, kAxis[i], angles[i], where);
}

void OsimFactors::add_offset(YamlNode& out, const OsimOffset& offset, const SourceLocation& where) const {
  const auto& [x, y, z] = offset.translation;
  add_shift(out, {number_text(x), number_text(y), number_text(z)}, where);
  for (std::size_t i = 0; i < 3; ++i)
    add_turn(out, kAxis[i], SnappedAngle(offset.orientation[i], snap_angles_).text(), where);
}

void OsimFactors::add_offsets(YamlNode& out, const OsimFrame& frame, const SourceLocation& where) const {
  for (const OsimOffset& offset : frame.offsets) add_offset(out, offset, where);
}

void OsimFactors::add_inverse(YamlNode& out, const OsimFrame& frame, const SourceLocation& where) const {
  for (std::size_t k = frame.offsets.size(); k-- > 0;) {
    const OsimOffset& offset = frame.offsets[k];
    for (std::size_t i = 3; i-- > 0;)
      add_turn(out, kAxis[i], SnappedAngle(-offset.orientation[i], snap_angles_).text(), where);
    const auto& [x, y, z] = offset.translation;
    add_shift(out, {number_text(-x), number_text(-y), number_text(-z)}, where);
  }
}

void OsimFactors::add_motion(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q,
                             const std::vector<std::string>& coordinate_names) const {
  const std::string_view type = joint.type;
  const SourceLocation& where = joint.where;
  if (type == "PinJoint") {
    add_turn(out, kAxis[2], q[0], where);
  } else if (type == "SliderJoint") {
    add_shift(out, {q[0], "0", "0"}, where);
  } else if (type == "UniversalJoint") {
    add_turn(out, kAxis[0], q[0], where);
    add_turn(out, kAxis[1], q[1], where);
  } else if (type == "BallJoint" || type == "GimbalJoint") {
    add_turns(out, q, where);
  } else if (type == "FreeJoint") {
    add_shift(out, {q[3], q[4], q[5]}, where);
    add_turns(out, q, where);
  } else if (type == "PlanarJoint") {
    add_shift(out, {q[1], q[2], "0"}, where);
    add_turn(out, kAxis[2], q[0], where);
  } else if (type == "EllipsoidJoint") {
    add_ellipsoid(out, joint, q, xml_.vector<3>(joint.element, "radii_x_y_z", {1, 1, 1}));
  } else if (type == "ScapulothoracicJoint") {
    add_scapula(out, joint, q);
  } else if (type == "CustomJoint") {
    add_spatial(out, joint, q, coordinate_names);
  }
}

/// Turns about three axes in turn, after shifts along three axes of the parent.
void OsimFactors::add_spatial(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q,
                              const std::vector<std::string>& coordinate_names) const {
  const std::array<pugi::xml_node, 6> axes = transform_axes(xml_, joint.element);
  std::array<OsimFunction, 6> functions;
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<std::string> arguments;
    for (const std::string& name : OsimXml::words(axes[i], "coordinates")) {
      const auto found = std::ranges::find(coordinate_names, name);
      if (found == coordinate_names.end())
        throw InputError(xml_.where(axes[i]),
                         fmt::format("'{}' is no coordinate of {}{}", printable(name),
                                     OsimXml::title(joint.element), did_you_mean(name, coordinate_names)));
      arguments.push_back(q[static_cast<std::size_t>(found - coordinate_names.begin())]);
    }
    functions[i] = axis_function(xml_, axes[i], arguments);
    if (!arguments.empty() && !find_osim_function(axes[i], "function"))
      xml_.warn(
          {xml_.where(axes[i]),
           fmt::format("axis '{}' of {} has coordinates, and no function: it is the coordinate itself, which "
                       "OpenSim 4 does not take it to be",
                       kSpatialAxes[i], OsimXml::title(joint.element)),
           "write the function into the file", "no function"});
    if (!functions[i].smooth)
      throw InputError(xml_.where(axes[i]), "a joint moves by a function that is not twice differentiable");
    if (functions[i].simple()) continue;
    functions[i].text =
        define_(fmt::format("{}_{}", joint.name, kSpatialAxes[i]), functions[i].text, xml_.where(axes[i]));
    functions[i].linear = {1, 0};
  }
  std::array<std::vector<std::string>, 3> terms;
  for (std::size_t i = 3; i < 6; ++i) {
    if (functions[i].constant == 0.0) continue;
    const std::array<double, 3> axis = unit(xml_, axes[i], kAxis[i - 3]);
    for (std::size_t k = 0; k < 3; ++k)
      if (axis[k] != 0)
        terms[k].push_back(functions[i].constant ? number_text(axis[k] * *functions[i].constant)
                                                 : scaled_text(axis[k], functions[i]));
  }
  add_shift(out, {sum_text(terms[0]), sum_text(terms[1]), sum_text(terms[2])}, joint.where);
  for (std::size_t i = 0; i < 3; ++i) {
    const SourceLocation where = axes[i] ? xml_.where(axes[i]) : joint.where;
    const std::string angle =
        functions[i].constant ? SnappedAngle(*functions[i].constant, snap_angles_).text() : functions[i].text;
    add_turn(out, unit(xml_, axes[i], kAxis[i]), angle, where);
  }
}

/// The origin is where the z axis is normal to the ellipsoid.
void OsimFactors::add_ellipsoid(YamlNode& out, const OsimJoint& joint, const std::vector<std::string>& q,
                                const std::array<double, 3>& radii) const {
  add_shift(out,
            {fmt::format("{}*sin({})", number_text(radii[0]), q[1]),
             fmt::format("-{}*sin({})*cos({})", number_text(radii[1]), q[0], q[1]),
             fmt::format("{}*cos({})*cos({})", number_text(radii[2]), q[0], q[1])},
            joint.where);
  add_turns(out, q, joint.where);
}

/// An ellipsoid's axes, turned by a quarter so that abduction and elevation are positive, and the winging axis
/// in the plane of the scapula.
void OsimFactors::add_scapula(YamlNode& out, const OsimJoint& joint,
                              const std::vector<std::string>& q) const {
  const std::array<double, 3> radii =
      xml_.vector<3>(joint.element, "thoracic_ellipsoid_radii_x_y_z", {1, 1, 1});
  const std::array<double, 2> origin = xml_.vector<2>(joint.element, "scapula_winging_axis_origin", {0, 0});
  const double direction = xml_.number(joint.element, "scapula_winging_axis_direction", 0);
  add_turn(out, kAxis[2], "pi/2", joint.where);
  add_ellipsoid(out, joint, q, {radii[1], radii[0], radii[2]});
  add_turn(out, kAxis[2], "-pi/2", joint.where);
  add_shift(out, {number_text(origin[0]), number_text(origin[1]), "0"}, joint.where);
  add_turn(out, std::array<double, 3>{-std::sin(direction), std::cos(direction), 0}, q[3], joint.where);
  add_shift(out, {number_text(-origin[0]), number_text(-origin[1]), "0"}, joint.where);
}

}  // namespace alembert

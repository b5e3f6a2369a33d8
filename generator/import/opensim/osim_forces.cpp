#include "import/opensim/osim_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_contacts.hpp"
#include "import/opensim/osim_muscles.hpp"
#include "import/opensim/osim_path_forces.hpp"
#include "import/opensim/osim_sockets.hpp"
#include "import/opensim/osim_wrenches.hpp"

namespace alembert {
namespace {

/// Joints whose first three speeds are an angular velocity, and no rates of their angles.
constexpr std::string_view kTurningTogether[] = {"BallJoint", "FreeJoint", "EllipsoidJoint",
                                                 "ScapulothoracicJoint"};

/// The coordinate that a force acts along, with what moves it; none, with a warning, if nothing does.
struct Along {
  std::string position, speed;  ///< as expressions
  std::string on;               ///< the coordinate that moves it in proportion; none if it follows a curve
  double factor = 1;
};
std::optional<Along> along(OsimDescription& out, pugi::xml_node force) {
  const std::size_t coordinate =
      resolve_osim_coordinate(out.model, OsimXml::text(force, {"coordinate", "socket_coordinate"}),
                              out.xml.where(force), OsimXml::title(force));
  const std::string& name = out.text_of(coordinate);
  const OsimJoint& joint = out.model.joints[out.model.coordinates[coordinate].joint];
  const auto place = std::ranges::find(joint.coordinates, coordinate) - joint.coordinates.begin();
  if (place < 3 && std::ranges::find(kTurningTogether, joint.type) != std::end(kTurningTogether)) {
    out.left(force,
             fmt::format("OpenSim applies it to an angular velocity, of which '{}' is no integral", name));
    return {};
  }
  const auto driver = out.driver(coordinate);
  if (!driver && out.driven[coordinate]) return Along{name, "rate", "", 1};
  if (!driver) {
    out.left(force, fmt::format("'{}' is locked or prescribed, or follows what is", name));
    return {};
  }
  const std::string& on = out.text_of(driver->first);
  return Along{name, times_text(driver->second, fmt::format("d({})", on)), on, driver->second};
}

void put_along(OsimDescription& out, pugi::xml_node element, const Along& where, const std::string& value) {
  const SourceLocation at = out.xml.where(element);
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  out.put(force, where.on.empty() ? "along" : "on", where.on.empty() ? where.position : where.on, at);
  out.put(force, "value",
          where.factor == 1 ? value : fmt::format("{}*({})", number_text(where.factor), value), at);
}

bool add_coordinate_actuator(OsimDescription& out, pugi::xml_node element) {
  const std::optional<Along> where = along(out, element);
  if (!where) return false;
  put_along(out, element, *where,
            times_text(out.xml.number(element, "optimal_force", 1), osim_control(out, element)));
  return true;
}

bool add_generalized_spring(OsimDescription& out, pugi::xml_node element) {
  const std::optional<Along> where = along(out, element);
  if (!where) return false;
  const double stiffness = out.xml.number(element, "stiffness", 0),
               viscosity = out.xml.number(element, "viscosity", 0);
  const double rest = out.xml.number(element, "rest_length", 0);
  const std::string stretch = sum_text({where->position, number_text(-rest)});
  put_along(
      out, element, *where,
      fmt::format("{}*({}) - {}*{}", number_text(-stiffness), stretch, number_text(viscosity), where->speed));
  return true;
}

/// Beyond a limit the stiffness grows from 0 over `transition` by 10 s^3 - 15 s^4 + 6 s^5; damping likewise. Limits
/// and stiffness of angles are in degrees.
bool add_coordinate_limit(OsimDescription& out, pugi::xml_node element) {
  const std::optional<Along> where = along(out, element);
  if (!where) return false;
  const OsimXml& xml = out.xml;
  const std::size_t coordinate = resolve_osim_coordinate(
      out.model, OsimXml::text(element, {"coordinate", "socket_coordinate"}), xml.where(element), "");
  const double unit = out.model.coordinates[coordinate].rotational ? std::numbers::pi / 180 : 1;
  const double transition = xml.number(element, "transition", 0.1) * unit;
  if (!(transition > 0))
    throw InputError(xml.where(element.child("transition")),
                     fmt::format("expected a positive <transition> of {}: its stiffness grows from 0 over it",
                                 OsimXml::title(element)));
  const double damping = xml.number(element, "damping", 0.001) / unit;
  const std::string& q = where->position;
  std::vector<std::string> terms;
  for (const bool upper : {true, false}) {
    const double limit = xml.number(element, upper ? "upper_limit" : "lower_limit", 0) * unit;
    const double stiffness = xml.number(element, upper ? "upper_stiffness" : "lower_stiffness", 1) / unit;
    if (stiffness == 0) continue;
    const std::string beyond =
        upper ? sum_text({q, number_text(-limit)}) : sum_text({number_text(limit), "-" + q});
    const std::string s =
        out.define(fmt::format("{}_{}", OsimXml::name_of(element), upper ? "above" : "below"),
                   fmt::format("clamp(({})/{}, 0, 1)", beyond, number_text(transition)), xml.where(element));
    terms.push_back(fmt::format("{0}^3*(10 - 15*{0} + 6*{0}^2)*({1}*({2}) - {3}*{4})", s,
                                number_text(upper ? -stiffness : stiffness), beyond, number_text(damping),
                                where->speed));
  }
  put_along(out, element, *where, sum_text(terms));
  return true;
}

std::string point_frame(OsimDescription& out, pugi::xml_node element, std::initializer_list<const char*> body,
                        const char* point, const std::string& name) {
  const SourceLocation at = out.xml.where(element);
  const std::size_t on =
      resolve_osim_frame(out.model, OsimXml::text(element, body), "/forceset/" + OsimXml::name_of(element),
                         at, OsimXml::title(element));
  const auto [x, y, z] = out.xml.vector<3>(element, point, {});
  return out.add_frame(OsimXml::name_of(element) + name, on, {number_text(x), number_text(y), number_text(z)},
                       at);
}

/// A force on the line between two points of bodies, without its tension.
YamlNode& add_between_points(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const std::string first = point_frame(out, element, {"socket_body1", "body1"}, "point1", "_1"),
                    second = point_frame(out, element, {"socket_body2", "body2"}, "point2", "_2");
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  out.nodes.put(force, "between", out.nodes.list({first, second}, at));
  return force;
}

bool add_point_spring(OsimDescription& out, pugi::xml_node element) {
  YamlNode& force = add_between_points(out, element);
  const double stiffness = out.xml.number(element, "stiffness", 1),
               rest = out.xml.number(element, "rest_length", 0);
  out.put(force, "tension",
          fmt::format("{}*({})", number_text(stiffness), sum_text({"length", number_text(-rest)})),
          out.xml.where(element));
  return true;
}

/// Three angles, of the second frame of a bushing in the first, and three shifts of its origin along the first's axes.
std::array<std::string, 6> deflections_of(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const std::string owner = "/forceset/" + OsimXml::name_of(element);
  const auto places = out.model.places.find(element);
  const auto frame = [&](std::size_t i, std::initializer_list<const char*> socket) {
    if (places != out.model.places.end())
      return out.add_frame(fmt::format("{}_{}", OsimXml::name_of(element), i + 1), places->second[i],
                           {"0", "0", "0"}, at);
    const std::size_t found =
        resolve_osim_frame(out.model, OsimXml::text(element, socket), owner, at, OsimXml::title(element));
    const OsimFrame& of = out.model.frames[found];
    return out.add_frame(
        of.own || of.name.empty() ? of.name : fmt::format("{}_{}", OsimXml::name_of(element), of.name), found,
        {"0", "0", "0"}, at);
  };
  const std::string a = frame(0, {"socket_frame1", "socket_frame1_frame", "body_1"}),
                    b = frame(1, {"socket_frame2", "socket_frame2_frame", "body_2"});
  const auto entry = [&](char row, char column) {
    std::vector<std::string> terms;
    for (const char k : {'x', 'y', 'z'})
      terms.push_back(fmt::format("rotation({}).{}{}*rotation({}).{}{}", a, k, row, b, k, column));
    return "(" + sum_text(terms) + ")";
  };
  const auto shift_along = [&](char axis) {
    std::vector<std::string> sum;
    for (const char k : {'x', 'y', 'z'})
      sum.push_back(
          fmt::format("rotation({0}).{1}{2}*(position({3}).{1} - position({0}).{1})", a, k, axis, b));
    return sum_text(sum);
  };
  return {fmt::format("atan2(-{}, {})", entry('y', 'z'), entry('z', 'z')),
          fmt::format("asin({})", entry('x', 'z')),
          fmt::format("atan2(-{}, {})", entry('x', 'y'), entry('x', 'x')),
          shift_along('x'),
          shift_along('y'),
          shift_along('z')};
}

/// Of a bushing for each of its deflections, of which `turning` and `shifting` are properties.
std::array<double, 6> of_deflections(const OsimXml& xml, pugi::xml_node element, const char* turning,
                                     const char* shifting) {
  const std::array<double, 3> turn = xml.vector<3>(element, turning, {}),
                              shift = xml.vector<3>(element, shifting, {});
  return {turn[0], turn[1], turn[2], shift[0], shift[1], shift[2]};
}

std::string deflection_name(pugi::xml_node element, std::size_t i) {
  return fmt::format("{}_{}_{}", OsimXml::name_of(element), i < 3 ? "turn" : "shift", "xyz"[i % 3]);
}

/// The energy of the deflections; damping acts along each of them.
bool add_bushing(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const std::array<std::string, 6> deflections = deflections_of(out, element);
  const std::array<double, 6> stiffness = of_deflections(out.xml, element, "rotational_stiffness",
                                                         "translational_stiffness"),
                              damping = of_deflections(out.xml, element, "rotational_damping",
                                                       "translational_damping");
  std::vector<std::string> terms;
  for (std::size_t i = 0; i < 6; ++i)
    if (stiffness[i] != 0)
      terms.push_back(
          times_text(stiffness[i] / 2, i < 3 ? deflections[i] + "^2" : "(" + deflections[i] + ")^2"));
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  out.put(force, "potential", sum_text(terms), at);
  for (std::size_t i = 0; i < 6; ++i) {
    if (damping[i] == 0) continue;
    YamlNode& damper = out.add_force(deflection_name(element, i), at);
    out.put(damper, "along", deflections[i], at);
    out.put(damper, "value", times_text(-damping[i], "rate"), at);
  }
  return true;
}

/// A force along each deflection, which is an expression of all of them; damping.
bool add_expression_bushing(OsimDescription& out, pugi::xml_node element) {
  constexpr const char* kProperties[] = {"Mx_expression", "My_expression", "Mz_expression",
                                         "Fx_expression", "Fy_expression", "Fz_expression"};
  constexpr const char* kVariables[] = {"theta_x", "theta_y", "theta_z", "delta_x", "delta_y", "delta_z"};
  const SourceLocation at = out.xml.where(element);
  const std::array<std::string, 6> deflections = deflections_of(out, element);
  const std::array<double, 6> damping =
      of_deflections(out.xml, element, "rotational_damping", "translational_damping");
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<OsimVariable> variables;
    for (std::size_t k = 0; k < 6; ++k) variables.push_back({kVariables[k], "(" + deflections[k] + ")"});
    YamlNode& force = out.add_force(deflection_name(element, i), at);
    variables[i].text = fmt::format("length({})", OsimDescription::name_of(force));
    const std::string strength = read_osim_expression(out.xml, element, kProperties[i], variables);
    std::vector<std::string> terms;
    if (strength != "0") terms.push_back(fmt::format("-({})", strength));
    if (damping[i] != 0) terms.push_back(times_text(-damping[i], "rate"));
    if (terms.empty()) {
      out.sections["forces"]->items.pop_back();
      continue;
    }
    out.put(force, "along", deflections[i], at);
    out.put(force, "value", sum_text(terms), at);
  }
  return true;
}

/// Of `q` and `qdot`.
bool add_expression_coordinate(OsimDescription& out, pugi::xml_node element) {
  const std::optional<Along> where = along(out, element);
  if (!where) return false;
  const auto factor = [](const std::string& of) {
    return of.find_first_of("*+- ") == std::string::npos ? of : "(" + of + ")";
  };
  put_along(out, element, *where,
            read_osim_expression(out.xml, element, "expression",
                                 {{"q", factor(where->position)}, {"qdot", factor(where->speed)}}));
  return true;
}

/// Of the distance `d` of two points and its rate `ddot`; it pulls them together.
bool add_expression_between(OsimDescription& out, pugi::xml_node element) {
  YamlNode& force = add_between_points(out, element);
  out.put(force, "tension",
          read_osim_expression(out.xml, element, "expression", {{"d", "length"}, {"ddot", "rate"}}),
          out.xml.where(element));
  return true;
}

/// Its activation follows the control.
bool add_activation_actuator(OsimDescription& out, pugi::xml_node element) {
  const std::optional<Along> where = along(out, element);
  if (!where) return false;
  const SourceLocation at = out.xml.where(element);
  const std::string control = osim_control(out, element);
  const std::string activation = out.names.add(OsimXml::name_of(element) + "_activation", at);
  out.add_state(activation, out.xml.number(element, "default_activation", 0.5),
                osim_control_limits(out.xml, element),
                fmt::format("({} - {})/{}", control, activation,
                            number_text(out.xml.positive_number(element, "activation_time_constant", 0.01))),
                at);
  put_along(out, element, *where, times_text(out.xml.number(element, "optimal_force", 1), activation));
  return true;
}

struct ForceType {
  std::string_view name;
  bool (*add)(OsimDescription&, pugi::xml_node);
};
constexpr ForceType kForceTypes[] = {{"CoordinateActuator", add_coordinate_actuator},
                                     {"ActivationCoordinateActuator", add_activation_actuator},
                                     {"ExpressionBasedCoordinateForce", add_expression_coordinate},
                                     {"ExpressionBasedPointToPointForce", add_expression_between},
                                     {"ExpressionBasedBushingForce", add_expression_bushing},
                                     {"PrescribedForce", add_prescribed_force},
                                     {"SpringGeneralizedForce", add_generalized_spring},
                                     {"CoordinateLimitForce", add_coordinate_limit},
                                     {"PointToPointSpring", add_point_spring},
                                     {"BushingForce", add_bushing},
                                     {"PathActuator", add_path_actuator},
                                     {"PointActuator", add_point_actuator},
                                     {"TorqueActuator", add_torque_actuator},
                                     {"PathSpring", add_path_spring},
                                     {"Ligament", add_ligament},
                                     {"Blankevoort1991Ligament", add_blankevoort_ligament},
                                     {"Thelen2003Muscle", add_thelen_muscle},
                                     {"Millard2012EquilibriumMuscle", add_millard_muscle},
                                     {"DeGrooteFregly2016Muscle", add_degroote_muscle},
                                     {"Schutte1993Muscle", add_schutte_muscle},
                                     {"Schutte1993Muscle_Deprecated", add_schutte_muscle},
                                     {"HuntCrossleyForce", add_hunt_crossley},
                                     {"SmoothSphereHalfSpaceForce", add_smooth_contact}};

const ForceType* force_type(pugi::xml_node element) {
  const auto type = std::ranges::find(kForceTypes, std::string_view(element.name()), &ForceType::name);
  return type == std::end(kForceTypes) ? nullptr : type;
}

/// Whether a component of a model is none of the forces: bodies, joints, constraints, frames and what only looks.
bool is_no_force(pugi::xml_node component) {
  const std::string_view name = component.name();
  for (const char* known : {"Body", "Marker", "Station", "ControlSet"})
    if (name == known) return true;
  if (name.starts_with("Contact")) return true;
  for (const char* end :
       {"Joint", "Constraint", "Frame", "Reporter", "Geometry", "Mesh", "Controller", "Probe", "WrapObject"})
    if (name.ends_with(end)) return true;
  return false;
}

/// Of the ForceSet, and of the components of the model, its bodies and joints all that may be forces.
std::vector<pugi::xml_node> acting_elements(const OsimDescription& of) {
  std::vector<pugi::xml_node> all = of.xml.objects(of.model.element, "ForceSet"), out;
  const auto add = [&](const std::vector<pugi::xml_node>& components) {
    for (const pugi::xml_node element : components)
      if (!is_no_force(element)) all.push_back(element);
  };
  add(of.xml.components(of.model.element));
  for (const OsimBody& body : of.model.bodies) add(OsimXml::elements(body.element.child("components")));
  for (const OsimJoint& joint : of.model.joints) add(OsimXml::elements(joint.element.child("components")));
  for (const pugi::xml_node force : all)
    if (of.xml.flag(force, "appliesForce", true) && !of.xml.flag(force, "isDisabled", false))
      out.push_back(force);
  return out;
}

/// Sets of what is no part of the equations here.
constexpr std::pair<const char*, const char*> kLeftSets[] = {
    {"ControllerSet", "inputs are set by whoever calls"}, {"ProbeSet", "what is measured is not taken"}};

}  // namespace

std::array<double, 2> osim_control_limits(const OsimXml& xml, pugi::xml_node actuator) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {xml.number_or_infinite(actuator, "min_control", -kInfinity),
          xml.number_or_infinite(actuator, "max_control", kInfinity)};
}

std::string osim_control(OsimDescription& out, pugi::xml_node actuator) {
  return out.add_input(OsimXml::name_of(actuator), 0, osim_control_limits(out.xml, actuator),
                       out.xml.where(actuator));
}

std::vector<pugi::xml_node> osim_known_forces(const OsimDescription& of) {
  std::vector<pugi::xml_node> out;
  for (const pugi::xml_node element : acting_elements(of))
    if (force_type(element) != nullptr) out.push_back(element);
  return out;
}

void add_osim_forces(OsimDescription& out) {
  for (const pugi::xml_node force : acting_elements(out)) {
    const ForceType* const type = force_type(force);
    const std::size_t before = out.warnings.size();
    if (type == nullptr)
      out.left(force, "forces of this kind are not read");
    else if (type->add(out, force))
      out.took(force.name());
    else if (out.warnings.size() == before)
      out.left(force, "it cannot be read as it is written");
  }
  for (const auto& [set, why] : kLeftSets)
    for (const pugi::xml_node object : OsimXml::elements(out.model.element.child(set).child("objects")))
      out.left(object, why);
}

}  // namespace alembert

#include "import/opensim/osim_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_contacts.hpp"
#include "import/opensim/osim_muscles.hpp"
#include "import/opensim/osim_paths.hpp"
#include "import/opensim/osim_sockets.hpp"
#include "import/opensim/osim_wrenches.hpp"

namespace alembert {
namespace {

std::string times(double factor, const std::string& of) {
  return factor == 1 ? of : fmt::format("{}*{}", number_text(factor), of);
}

/// Of a Ligament that says none, over its length in resting lengths.
constexpr const char* kLigamentCurve =
    "[-5, 0.998, 0.999, 1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.601, 1.602, 5]; "
    "[0, 0, 0, 0, 0.035, 0.12, 0.26, 0.55, 1.17, 2, 2, 2, 2]";

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
  return Along{name, times(driver->second, fmt::format("d({})", on)), on, driver->second};
}

void put_along(OsimDescription& out, pugi::xml_node element, const Along& where, const std::string& value) {
  const SourceLocation at = out.xml.where(element);
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  out.put(force, where.on.empty() ? "along" : "on", where.on.empty() ? where.position : where.on, at);
  out.put(force, "value",
          where.factor == 1 ? value : fmt::format("{}*({})", number_text(where.factor), value), at);
}

std::string input_of(OsimDescription& out, pugi::xml_node actuator) {
  return out.add_input(OsimXml::name_of(actuator), 0, osim_control_limits(out.xml, actuator),
                       out.xml.where(actuator));
}

bool add_coordinate_actuator(OsimDescription& out, pugi::xml_node element) {
  const std::optional<Along> where = along(out, element);
  if (!where) return false;
  put_along(out, element, *where, times(out.xml.number(element, "optimal_force", 1), input_of(out, element)));
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

bool add_point_spring(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const std::string first = point_frame(out, element, {"socket_body1", "body1"}, "point1", "_1"),
                    second = point_frame(out, element, {"socket_body2", "body2"}, "point2", "_2");
  const double stiffness = out.xml.number(element, "stiffness", 1),
               rest = out.xml.number(element, "rest_length", 0);
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  out.nodes.put(force, "between", out.nodes.list({first, second}, at));
  out.put(force, "tension",
          fmt::format("{}*({})", number_text(stiffness), sum_text({"length", number_text(-rest)})), at);
  return true;
}

/// The energy of three angles, of the second frame in the first, and of its origin in the first's axes; damping acts along
/// each of the six.
bool add_bushing(OsimDescription& out, pugi::xml_node element) {
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
  const std::array<double, 3> none{}, turn = out.xml.vector<3>(element, "rotational_stiffness", none),
                                      shift = out.xml.vector<3>(element, "translational_stiffness", none);
  const std::string angles[] = {fmt::format("atan2(-{}, {})", entry('y', 'z'), entry('z', 'z')),
                                fmt::format("asin({})", entry('x', 'z')),
                                fmt::format("atan2(-{}, {})", entry('x', 'y'), entry('x', 'x'))};
  const auto shift_along = [&](std::size_t axis) {
    std::vector<std::string> sum;
    for (const char k : {'x', 'y', 'z'})
      sum.push_back(fmt::format("rotation({0}).{1}{2}*(position({3}).{1} - position({0}).{1})", a, k,
                                static_cast<char>('x' + axis), b));
    return sum_text(sum);
  };
  std::vector<std::string> terms;
  for (std::size_t i = 0; i < 3; ++i)
    if (turn[i] != 0) terms.push_back(times(turn[i] / 2, angles[i] + "^2"));
  for (std::size_t i = 0; i < 3; ++i)
    if (shift[i] != 0) terms.push_back(times(shift[i] / 2, fmt::format("({})^2", shift_along(i))));
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  out.put(force, "potential", sum_text(terms), at);
  const std::array<double, 3> slow_turn = out.xml.vector<3>(element, "rotational_damping", none),
                              slow_shift = out.xml.vector<3>(element, "translational_damping", none);
  for (std::size_t i = 0; i < 6; ++i) {
    const double damping = i < 3 ? slow_turn[i] : slow_shift[i - 3];
    if (damping == 0) continue;
    YamlNode& damper = out.add_force(
        fmt::format("{}_{}_{}", OsimXml::name_of(element), i < 3 ? "turn" : "shift", "xyz"[i % 3]), at);
    out.put(damper, "along", i < 3 ? angles[i] : shift_along(i - 3), at);
    out.put(damper, "value", times(-damping, "rate"), at);
  }
  return true;
}

/// A force of a tension along a path.
bool put_on_path(OsimDescription& out, pugi::xml_node element, const std::string& tension) {
  const SourceLocation at = out.xml.where(element);
  YamlNode& force = out.add_force(OsimXml::name_of(element), at);
  if (!add_osim_path(out, force, element)) {
    out.sections["forces"]->items.pop_back();
    return false;
  }
  out.put(force, "tension", tension, at);
  return true;
}

bool add_path_actuator(OsimDescription& out, pugi::xml_node element) {
  return put_on_path(out, element,
                     times(out.xml.number(element, "optimal_force", 1), input_of(out, element)));
}

bool add_path_spring(OsimDescription& out, pugi::xml_node element) {
  const double rest = out.xml.number(element, "resting_length", 0),
               k = out.xml.number(element, "stiffness", 0),
               dissipation = out.xml.number(element, "dissipation", 0);
  return put_on_path(out, element,
                     fmt::format("{}*max(0, {})*(1 + {}*rate)", number_text(k),
                                 sum_text({"length", number_text(-rest)}), number_text(dissipation)));
}

/// A curve of the length in resting lengths, and nothing below.
bool add_ligament(OsimDescription& out, pugi::xml_node element) {
  const double rest = out.xml.positive_number(element, "resting_length", 0),
               force = out.xml.number(element, "pcsa_force", 0);
  const std::string length = fmt::format("(length/{})", number_text(rest));
  const pugi::xml_node curve = find_osim_function(element, "force_length_curve");
  const std::string tension = curve
                                  ? scaled_text(force, read_osim_function(out.xml, curve, {length}))
                                  : times(force, fmt::format("simm_spline({}; {})", length, kLigamentCurve));
  return put_on_path(out, element, fmt::format("select(length - {}, {}, 0)", number_text(rest), tension));
}

/// Quadratic in the strain up to that of the transition, then straight; damped where it is stretched and lengthens, which
/// sets in over a strain of 0.01 by 10 s^3 - 15 s^4 + 6 s^5. Source: Blankevoort and Huiskes, Ligament-Bone Interaction
/// in a Three-Dimensional Model of the Knee, Journal of Biomechanical Engineering 113 (1991), 263-269.
bool add_blankevoort_ligament(OsimDescription& out, pugi::xml_node element) {
  const double slack = out.xml.positive_number(element, "slack_length", 0),
               stiffness = out.xml.number(element, "linear_stiffness", 1),
               transition = out.xml.number(element, "transition_strain", 0.06),
               damping = out.xml.number(element, "damping_coefficient", 0.003);
  const std::string strain = fmt::format("(length/{} - 1)", number_text(slack));
  std::vector<std::string> terms;
  if (transition > 0)
    terms.push_back(fmt::format("{}*clamp({}, 0, {})^2", number_text(stiffness / (2 * transition)), strain,
                                number_text(transition)));
  terms.push_back(fmt::format("{}*max(0, length/{} - {})", number_text(stiffness), number_text(slack),
                              number_text(1 + std::max(0.0, transition))));
  if (damping > 0) {
    const std::string onset = fmt::format("clamp(100*{}, 0, 1)", strain);
    terms.push_back(
        fmt::format("{0}*max(0, rate)*{1}^3*(10 - 15*{1} + 6*{1}^2)", number_text(damping / slack), onset));
  }
  return put_on_path(out, element, sum_text(terms));
}

struct ForceType {
  std::string_view name;
  bool (*add)(OsimDescription&, pugi::xml_node);
};
constexpr ForceType kForceTypes[] = {{"CoordinateActuator", add_coordinate_actuator},
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

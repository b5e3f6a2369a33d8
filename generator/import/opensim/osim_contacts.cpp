// Sources of the laws: Sherman, Seth and Delp, Simbody: multibody dynamics for biomedical research, Procedia IUTAM 2 (2011),
// 241-261; Serrancoli and others, Subject-Exoskeleton Contact Model Calibration Leads to Accurate Interaction Force
// Predictions, IEEE Transactions on Neural Systems and Rehabilitation Engineering 27 (2019), 1597-1605.
#include "import/opensim/osim_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

/// Where OpenSim's law has none, the least slip that friction is reckoned with, in transition velocities: it changes it by
/// the square of this.
constexpr double kLeastSlip = 1e-6;

/// A <ContactSphere> or <ContactHalfSpace>, with the material that a force gives it.
struct Surface {
  pugi::xml_node element;
  bool sphere = false;
  std::size_t frame = 0;
  double radius = 0;  ///< sphere
  double modulus = 0, dissipation = 0, still = 0, sliding = 0, viscous = 0;
};

/// Of the ContactGeometrySet, and among the components of the model and its bodies.
std::vector<pugi::xml_node> contact_geometry(const OsimDescription& of) {
  std::vector<pugi::xml_node> out;
  const auto add = [&](const std::vector<pugi::xml_node>& elements) {
    for (const pugi::xml_node element : elements)
      if (std::string_view(element.name()).starts_with("Contact")) out.push_back(element);
  };
  add(of.xml.objects(of.model.element, "ContactGeometrySet"));
  add(of.xml.components(of.model.element));
  for (const OsimBody& body : of.model.bodies) add(OsimXml::elements(body.element.child("components")));
  return out;
}

pugi::xml_node find_geometry(const OsimDescription& of, pugi::xml_node force, const std::string& path) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  std::vector<std::string> names;
  for (const pugi::xml_node element : contact_geometry(of)) {
    if (OsimXml::name_of(element) == name) return element;
    names.push_back(OsimXml::name_of(element));
  }
  throw InputError(of.xml.where(force),
                   fmt::format("{} names an unknown contact geometry '{}'{}", OsimXml::title(force),
                               printable(path), did_you_mean(name, names)));
}

/// None, with a warning, if it is neither a sphere nor a half space.
std::optional<Surface> read_surface(OsimDescription& out, pugi::xml_node force, const std::string& path) {
  const pugi::xml_node element = find_geometry(out, force, path);
  Surface surface;
  surface.element = element;
  surface.sphere = element.name() == std::string_view("ContactSphere");
  if (!surface.sphere && element.name() != std::string_view("ContactHalfSpace")) {
    out.left(element, "only spheres and half spaces are in contact");
    return {};
  }
  surface.frame = resolve_osim_frame(out.model, OsimXml::text(element, {"socket_frame", "body_name"}),
                                     "/contactgeometryset", out.xml.where(element), OsimXml::title(element));
  if (surface.sphere) surface.radius = out.xml.positive_number(element, "radius", 0);
  return surface;
}

/// The frame of a surface: its origin is the centre of a sphere, or on the surface of a half space, which is where its
/// x is positive.
std::string frame_of(OsimDescription& out, const Surface& surface) {
  const pugi::xml_node element = surface.element;
  const std::array<double, 3> none{}, at = out.xml.vector<3>(element, "location", none),
                                      turn = out.xml.vector<3>(element, "orientation", none);
  return out.add_frame(OsimXml::name_of(element), surface.frame,
                       {number_text(at[0]), number_text(at[1]), number_text(at[2])}, out.xml.where(element),
                       surface.sphere ? none : turn);
}

/// What the two surfaces have in common.
double mean(double a, double b) {
  return a == 0 || b == 0 ? 0 : 2 * a * b / (a + b);
}

/// Coefficient over the slip: up to the transition it rises to that at rest, then it falls; 0 where there is none.
std::string friction_text(double still, double sliding, double viscous, double transition) {
  std::string coefficient = number_text(sliding);
  if (still != sliding)
    coefficient =
        "(" +
        sum_text({coefficient, fmt::format("{}/(1 + (slip/{})^2)", number_text(2 * (still - sliding)),
                                           number_text(transition))}) +
        ")";
  std::vector<std::string> terms;
  if (still != 0 || sliding != 0)
    terms.push_back(fmt::format("{}*min(slip/{}, 1)", coefficient, number_text(transition)));
  if (viscous != 0) terms.push_back(fmt::format("{}*slip", number_text(viscous)));
  return terms.empty() ? "0" : sum_text(terms);
}

/// A contact of a sphere with a surface, without its law.
YamlNode& begin_contact(OsimDescription& out, const std::string& name, const Surface& sphere,
                        const Surface& other, const SourceLocation& at) {
  const std::string center = frame_of(out, sphere);
  const std::string touched = frame_of(out, other);
  YamlNode& force = out.add_force(name, at);
  YamlNode& contact = out.nodes.mapping(at);
  out.nodes.put(force, "contact", contact);
  out.put(contact, "frame", center, at);
  out.put(contact, "radius", number_text(sphere.radius), at);
  YamlNode& on = out.nodes.mapping(at);
  out.put(on, "frame", touched, at);
  if (other.sphere)
    out.put(on, "radius", number_text(other.radius), at);
  else
    out.nodes.put(on, "normal", out.nodes.list({"-1", "0", "0"}, at));
  out.nodes.put(contact, other.sphere ? "sphere" : "plane", on);
  return contact;
}

void put_friction(OsimDescription& out, YamlNode& contact, const std::string& friction, double least_slip,
                  const SourceLocation& at) {
  if (friction == "0") return;
  out.put(contact, "friction", friction, at);
  out.put(contact, "slip_velocity", number_text(least_slip), at);
}

/// All surfaces of a HuntCrossleyForce.
std::vector<Surface> read_surfaces(OsimDescription& out, pugi::xml_node element) {
  std::vector<Surface> surfaces;
  for (const pugi::xml_node group : out.xml.objects(element, "HuntCrossleyForce::ContactParametersSet"))
    for (const std::string& name : OsimXml::words(group, "geometry")) {
      std::optional<Surface> surface = read_surface(out, element, name);
      if (!surface) continue;
      surface->modulus = out.xml.positive_number(group, "stiffness", 0, true);
      surface->dissipation = out.xml.number(group, "dissipation", 0);
      surface->still = out.xml.number(group, "static_friction", 0);
      surface->sliding = out.xml.number(group, "dynamic_friction", 0);
      surface->viscous = out.xml.number(group, "viscous_friction", 0);
      surfaces.push_back(*surface);
    }
  return surfaces;
}

}  // namespace

/// With E1, E2 the moduli, k1 = E1^(2/3), and the first surface's share s = k2/(k1 + k2) of the depth: the stiffness is
/// 4/3 sqrt(R) (k1 s)^(3/2) at the relative radius R, the dissipation c1 s + c2 (1 - s).
bool add_hunt_crossley(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const double transition = out.xml.positive_number(element, "transition_velocity", 0.01);
  struct Pair {
    const Surface *sphere, *other;
  };
  const std::vector<Surface> surfaces = read_surfaces(out, element);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (std::size_t k = i + 1; k < surfaces.size(); ++k) {
      const Surface &a = surfaces[i], &b = surfaces[k];
      if (!a.sphere && !b.sphere) continue;
      if (out.model.frames[a.frame].body == out.model.frames[b.frame].body) continue;
      pairs.push_back(a.sphere ? Pair{&a, &b} : Pair{&b, &a});
    }
  for (const auto& [sphere, other] : pairs) {
    if (sphere->modulus == 0 || other->modulus == 0) continue;
    std::string name = OsimXml::name_of(element);
    if (pairs.size() > 1)
      name += fmt::format("_{}_{}", OsimXml::name_of(sphere->element), OsimXml::name_of(other->element));
    YamlNode& contact = begin_contact(out, name, *sphere, *other, at);
    const double k1 = std::pow(sphere->modulus, 2.0 / 3), k2 = std::pow(other->modulus, 2.0 / 3),
                 share = k2 / (k1 + k2);
    const double R =
        other->sphere ? sphere->radius * other->radius / (sphere->radius + other->radius) : sphere->radius;
    out.put(contact, "stiffness", number_text(4.0 / 3 * std::sqrt(R) * std::pow(k1 * share, 1.5)), at);
    const double dissipation = sphere->dissipation * share + other->dissipation * (1 - share);
    if (dissipation != 0) out.put(contact, "dissipation", number_text(dissipation), at);
    put_friction(out, contact,
                 friction_text(mean(sphere->still, other->still), mean(sphere->sliding, other->sliding),
                               mean(sphere->viscous, other->viscous), transition),
                 kLeastSlip * transition, at);
    out.put(contact, "flattening", number_text(share), at);
  }
  if (pairs.empty()) out.left(element, "no sphere of it meets a surface of another body");
  return !pairs.empty();
}

/// With k = E^(2/3)/2, the depth d and its rate, and small e:
///   f = 4/3 k sqrt(R k) (d^2 + e)^(3/4) (1 + tanh(b_d d))/2 (1 + 3/2 c d') (1 + tanh(b_v (d' + 2/(3 c))))/2,
/// halfway between the two surfaces; slips are sqrt(v_t^2 + e).
bool add_smooth_contact(OsimDescription& out, pugi::xml_node element) {
  const SourceLocation at = out.xml.where(element);
  const std::optional<Surface> sphere = read_surface(out, element, OsimXml::text(element, "socket_sphere")),
                               plane =
                                   read_surface(out, element, OsimXml::text(element, "socket_half_space"));
  if (!sphere || !plane || !sphere->sphere || plane->sphere) return false;
  if (out.model.frames[sphere->frame].body == out.model.frames[plane->frame].body)
    return true;  // moves nothing
  const auto number = [&](const char* property, double otherwise) {
    return out.xml.number(element, property, otherwise);
  };
  // OpenSim called it by the second name once.
  const double blur = number("constant_contact_force", number("derivative_smoothing", 1e-5)),
               c = number("dissipation", 0),
               k = std::pow(out.xml.positive_number(element, "stiffness", 1, true), 2.0 / 3) / 2;
  if (blur < 0)
    throw InputError(
        at, fmt::format("expected no negative <constant_contact_force> of {}", OsimXml::title(element)));
  const double transition = out.xml.positive_number(element, "transition_velocity", 0.01);
  std::string normal = fmt::format("{}*(depth^2 + {})^0.75*(0.5 + 0.5*tanh({}*depth))",
                                   number_text(4.0 / 3 * k * std::sqrt(sphere->radius * k)),
                                   number_text(blur), number_text(number("hertz_smoothing", 300)));
  if (c != 0)
    normal += fmt::format("*(1 + {}*rate)*(0.5 + 0.5*tanh({}*(rate + {})))", number_text(1.5 * c),
                          number_text(number("hunt_crossley_smoothing", 50)), number_text(2 / (3 * c)));
  YamlNode& contact = begin_contact(out, OsimXml::name_of(element), *sphere, *plane, at);
  out.put(contact, "normal_force", normal, at);
  put_friction(out, contact,
               friction_text(number("static_friction", 0), number("dynamic_friction", 0),
                             number("viscous_friction", 0), transition),
               blur > 0 ? std::sqrt(blur) : kLeastSlip * transition, at);
  out.put(contact, "flattening", "0.5", at);
  return true;
}

}  // namespace alembert

// Contacts of a sphere or a point with a plane or another sphere. A mapping in; wrenches out, expressions of positions and
// velocities of frames. With n the normal towards the sphere, d the depth, v the velocity of the point where they act
// relative to what the sphere touches, v_n and v_t its parts along n and across, and s = sqrt(v_t^2 + v_s^2) the slip:
//
//   f_n = k max(0, d)^(3/2) max(0, 1 - 3/2 c v_n), or any function of d and -v_n;    f = f_n (n - mu(s) v_t / s)
//
// They act at the sphere's deepest point, or above it by a share of d.
//
// Source: Hunt and Crossley, Coefficient of restitution interpreted as damping in vibroimpact, Journal of Applied
// Mechanics 42 (1975), 440-445.
#include "mechanism/contact_reader.hpp"

#include <fmt/format.h>

#include "mechanism/section.hpp"

namespace alembert {
namespace {

class ContactReader {
 public:
  ContactReader(Loading& loading, const YamlNode& node, const std::string& name)
      : loading_(loading),
        section_(loading.document, node, fmt::format("the contact of force '{}'", name),
                 {"frame", "radius", "plane", "sphere", "normal_force", "stiffness", "dissipation",
                  "friction", "slip_velocity", "flattening"}) {
    contact_.name = name;
  }

  std::vector<Force> read(const SourceLocation& where) {
    contact_.frame = loading_.reader.expect_frame(section_.require("frame"), of("the frame"));
    contact_.radius = or_zero("radius");
    const YamlNode *plane = section_.find("plane"), *sphere = section_.find("sphere");
    if ((plane == nullptr) == (sphere == nullptr))
      throw InputError(
          loading_.document.where(section_.node()),
          fmt::format("the contact of force '{}' needs one of 'plane' and 'sphere'", contact_.name));
    if (plane != nullptr)
      read_plane(*plane);
    else
      read_sphere(*sphere);
    std::vector<Force> forces = wrenches(where);
    loading_.mechanism.contacts.push_back(contact_);
    return forces;
  }

 private:
  std::string of(std::string_view what) const {
    return fmt::format("{} in the contact of force '{}'", what, contact_.name);
  }
  Expr or_zero(std::string_view key) {
    const YamlNode* node = section_.find(key);
    if (node == nullptr) return loading_.graph.zero();
    return coefficient(*node, of(fmt::format("the {}", key)), false);
  }
  Expr coefficient(const YamlNode& node, const std::string& what, bool positive) {
    return loading_.reader.coefficient(node, what, positive);
  }
  Vec3 vector(int frame, FrameQuantity quantity) { return loading_.reader.vector_of(frame, quantity); }
  Vec3 zero() { return zeros<3, 1>(loading_.graph); }

  void check_apart(const YamlNode& node, int other) const {
    const auto body = [&](int frame) {
      return frame < 0 ? -1 : loading_.mechanism.frames[static_cast<std::size_t>(frame)].body;
    };
    if (body(contact_.frame) != body(other)) return;
    throw InputError(loading_.document.where(node),
                     fmt::format("force '{}' is a contact of a body with itself", contact_.name));
  }

  void read_plane(const YamlNode& node) {
    const Section plane(loading_.document, node, of("the plane"), {"frame", "point", "normal"});
    if (const YamlNode* frame = plane.find("frame"))
      contact_.other = loading_.reader.expect_frame(*frame, of("the plane"));
    check_apart(node, contact_.other);
    Vec3 point = zero();
    if (const YamlNode* given = plane.find("point"))
      point = loading_.reader.read_vector(*given, Allowed::parameters, of("the point of the plane"));
    const YamlNode& direction = plane.require("normal");
    contact_.normal =
        loading_.reader.read_vector(direction, Allowed::parameters, of("the normal of the plane"));
    if (contact_.normal[0].is_zero() && contact_.normal[1].is_zero() && contact_.normal[2].is_zero())
      throw InputError(loading_.document.where(direction), of("the normal of the plane") + " is 0");
    const Expr length = sqrt(dot(contact_.normal, contact_.normal));
    for (Expr& entry : contact_.normal.entries) entry = entry / length;
    contact_.plane = true;
    contact_.plane_point = point;
    contact_.plane_normal = contact_.normal;
    if (contact_.other >= 0) {
      const Mat3 R = loading_.reader.rotation_of(contact_.other);
      contact_.normal = R * contact_.normal;
      point = vector(contact_.other, FrameQuantity::position) + R * point;
    }
    const Vec3 above = vector(contact_.frame, FrameQuantity::position) - point;
    contact_.depth = contact_.radius - dot(contact_.normal, above);
  }

  void read_sphere(const YamlNode& node) {
    const Section sphere(loading_.document, node, of("the sphere"), {"frame", "radius"});
    contact_.other = loading_.reader.expect_frame(sphere.require("frame"), of("the sphere"));
    check_apart(node, contact_.other);
    const Expr radius = coefficient(sphere.require("radius"), of("the radius of the sphere"), true);
    contact_.other_radius = radius;
    const Expr distance = loading_.reader.distance(contact_.frame, contact_.other);
    contact_.normal =
        vector(contact_.frame, FrameQuantity::position) - vector(contact_.other, FrameQuantity::position);
    for (Expr& entry : contact_.normal.entries) entry = entry / distance;
    contact_.depth = contact_.radius + radius - distance;
  }

  /// Velocity of a point that moves with a frame, at `arm` from its origin.
  Vec3 velocity_at(int frame, const Vec3& arm) {
    return vector(frame, FrameQuantity::velocity) +
           cross(vector(frame, FrameQuantity::angular_velocity), arm);
  }

  /// By Hunt and Crossley, or as it is given.
  Expr normal_force(const Expr& speed) {
    if (const YamlNode* given = section_.find("normal_force")) {
      for (const char* key : {"stiffness", "dissipation"})
        if (const YamlNode* other = section_.find(key))
          throw InputError(loading_.document.where(*other),
                           of(fmt::format("'normal_force' takes the place of '{}'", key)));
      return loading_.reader
          .read_with(*given, {{"depth", contact_.depth, Dependence::coordinate}, {"rate", -speed, kMoving}},
                     Allowed::force, of("the normal force"))
          .expr;
    }
    ExprGraph& graph = loading_.graph;
    const Expr deep = if_positive(contact_.depth, contact_.depth);
    const Expr loss = graph.rational(Rational(3, 2)) * (or_zero("dissipation") * speed);
    const Expr damped = graph.one() - loss;
    const Expr stiffness = coefficient(section_.require("stiffness"), of("the stiffness"), false);
    const Expr spring = stiffness * (deep * sqrt(deep));
    return spring * if_positive(damped, damped);
  }

  Vec3 force(const Vec3& velocity) {
    const Expr speed = dot(contact_.normal, velocity);
    const Expr strength = normal_force(speed);
    contact_.strength = strength;
    const YamlNode* given = section_.find("friction");
    if (given == nullptr) return strength * contact_.normal;
    const YamlNode* least = section_.find("slip_velocity");
    const Expr slow =
        least == nullptr ? loading_.graph.zero() : coefficient(*least, of("the slip velocity"), true);
    const Vec3 slip = velocity - speed * contact_.normal;
    const Expr size = sqrt(dot(slip, slip) + slow * slow);
    const Expr friction =
        loading_.reader.coefficient_with(*given, {{"slip", size, kMoving}}, of("the friction"));
    if (friction.is_zero()) return strength * contact_.normal;
    section_.require("slip_velocity");
    return strength * (contact_.normal - (friction / size) * slip);
  }

  /// Where the forces act, from the centre of the sphere.
  Vec3 lever() {
    const YamlNode* given = section_.find("flattening");
    if (given == nullptr) return -contact_.radius * contact_.normal;
    const std::string what = of("the flattening");
    const Quantity share = loading_.reader.read(*given, Allowed::parameters, what);
    if (share.initial < 0 || share.initial > 1)
      throw InputError(
          loading_.document.where(*given),
          fmt::format("{} is {:.6g}; expected a share of the depth, from 0 to 1", what, share.initial));
    return (share.expr * contact_.depth - contact_.radius) * contact_.normal;
  }

  std::vector<Force> wrenches(const SourceLocation& where) {
    const Vec3 arm = lever();
    Vec3 velocity = velocity_at(contact_.frame, arm), other_arm = zero();
    if (contact_.other >= 0) {
      other_arm = vector(contact_.frame, FrameQuantity::position) + arm -
                  vector(contact_.other, FrameQuantity::position);
      velocity = velocity - velocity_at(contact_.other, other_arm);
    }
    const Vec3 f = force(velocity);
    std::vector<Force> result;
    const auto add = [&](int frame, const Vec3& on, const Vec3& at) {
      Force wrench;
      wrench.name = contact_.name;
      wrench.kind = ForceKind::wrench;
      wrench.frame = frame;
      wrench.frame_axes = false;
      wrench.force = on;
      wrench.torque = cross(at, on);
      wrench.where = where;
      result.push_back(std::move(wrench));
    };
    add(contact_.frame, f, arm);
    if (contact_.other >= 0) add(contact_.other, zero() - f, other_arm);
    return result;
  }

  static constexpr Dependence kMoving = Dependence::coordinate | Dependence::speed;

  Loading& loading_;
  Section section_;
  SphereContact contact_;
};

}  // namespace

std::vector<Force> read_contact(Loading& loading, const YamlNode& node, const std::string& name,
                                const SourceLocation& where) {
  return ContactReader(loading, node, name).read(where);
}

}  // namespace alembert

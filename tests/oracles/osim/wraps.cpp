#include "oracles/osim/wraps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace alembert::oracles {
namespace {

using SimTK::Pi;
using SimTK::Vec3;

struct WrapSurface {
  bool cylinder = false;
  double radius = 0, length = 0;
  int axis = -1;  // of the quadrant; none: -1
  double sign = 0;
  SimTK::Transform pose;  // in the ground
};

/// From one angle to another, one way around.
double turn(double from, double to, double way) {
  const double angle = way * (to - from);
  return angle - 2 * Pi * std::floor(angle / (2 * Pi));
}

/// Whether the line comes nearer to the centre than the radius, between its ends.
template <int kSize>
bool crosses(const SimTK::Vec<kSize>& a, const SimTK::Vec<kSize>& b, double radius) {
  const SimTK::Vec<kSize> along = b - a;
  const double foot = -SimTK::dot(a, along) / SimTK::dot(along, along);
  return foot > 0 && foot < 1 && (a + foot * along).norm() < radius;
}

double around_sphere(const Vec3& a, const Vec3& b, double r) {
  const double la = a.norm(), lb = b.norm();
  if (la < r || lb < r || !crosses<3>(a, b, r)) return (b - a).norm();
  const double angle = std::acos(SimTK::dot(a, b) / (la * lb)) - std::acos(r / la) - std::acos(r / lb);
  return std::sqrt(la * la - r * r) + r * angle + std::sqrt(lb * lb - r * r);
}

double around_cylinder(const Vec3& a, const Vec3& b, const WrapSurface& of) {
  const double r = of.radius, la = std::hypot(a[0], a[1]), lb = std::hypot(b[0], b[1]);
  const SimTK::Vec2 pa(a[0], a[1]), pb(b[0], b[1]);
  const double straight = (b - a).norm();
  if (la < r || lb < r) return straight;
  const double angle_a = std::atan2(a[1], a[0]), angle_b = std::atan2(b[1], b[0]);
  const double reach_a = std::acos(r / la), reach_b = std::acos(r / lb);
  const auto length = [&](double way) {
    const double arc = turn(angle_a + way * reach_a, angle_b - way * reach_b, way);
    const double to_arc = std::sqrt(la * la - r * r), off_it = std::sqrt(lb * lb - r * r);
    const double flat = to_arc + r * arc + off_it, slope = (b[2] - a[2]) / flat;
    if (std::min(std::abs(a[2] + slope * to_arc), std::abs(b[2] - slope * off_it)) > of.length / 2)
      return straight;
    return std::hypot(flat, b[2] - a[2]);
  };
  const bool in_the_way = crosses<2>(pa, pb, r);
  if (of.axis < 0) return in_the_way ? std::min(length(1), length(-1)) : straight;
  const auto is_active = [&](double x) { return (x >= 0 ? 1 : -1) == of.sign; };
  const bool active_a = is_active(a[of.axis]), active_b = is_active(b[of.axis]);
  if ((active_a || active_b) && !in_the_way) {
    const SimTK::Vec2 along = pb - pa;
    const SimTK::Vec2 nearest = pa - SimTK::dot(pa, along) / SimTK::dot(along, along) * along;
    if (active_a == active_b || is_active(nearest[of.axis])) return straight;
  }
  // Which of the tangents' points is on the active side, ways 1 and -1 around.
  const auto tangent = [&](double angle) { return of.axis == 0 ? std::cos(angle) : std::sin(angle); };
  const bool a_1 = is_active(tangent(angle_a + reach_a)), a_2 = is_active(tangent(angle_a - reach_a));
  const bool b_2 = is_active(tangent(angle_b + reach_b)), b_1 = is_active(tangent(angle_b - reach_b));
  if (a_1 != a_2) return length(a_1 ? 1 : -1);
  if (b_2 || a_1) return length(b_2 ? -1 : 1);
  if (b_1) return length(1);
  const auto apart = [&](double way) {
    return std::acos(std::cos(angle_a + way * reach_a - (angle_b - way * reach_b)));
  };
  return length(apart(1) > apart(-1) ? 1 : -1);
}

std::optional<WrapSurface> find(const OsimSkeleton& skeleton, const std::string& name) {
  for (const char* type : {"WrapCylinder", "WrapSphere"})
    for (const pugi::xpath_node found :
         skeleton.model().select_nodes((std::string("//") + type + "[@name='" + name + "']").c_str())) {
      const pugi::xml_node element = found.node();
      WrapSurface out;
      out.cylinder = type == std::string("WrapCylinder");
      out.radius = element.child("radius").text().as_double();
      out.length = element.child("length").text().as_double();
      const std::string quadrant = element.child("quadrant").child_value();
      if (!quadrant.empty() && quadrant != "all") {
        out.axis = quadrant.back() - 'x';
        out.sign = quadrant[0] == '-' ? -1 : 1;
        if (!out.cylinder || out.axis > 1) return std::nullopt;
      }
      const std::vector<double> p = numbers_in(element.child("translation")),
                                a = numbers_in(element.child("xyz_body_rotation"));
      const SimTK::Rotation turned(SimTK::BodyRotationSequence, a[0], SimTK::XAxis, a[1], SimTK::YAxis, a[2],
                                   SimTK::ZAxis);
      const pugi::xml_node owner = element.parent().parent().parent();
      const char* body = owner.name() == std::string("Ground") ? "ground" : owner.attribute("name").value();
      out.pose = skeleton.pose(body, "") * SimTK::Transform(turned, Vec3(p[0], p[1], p[2]));
      return out;
    }
  return std::nullopt;
}

}  // namespace

double wrapped_length(const OsimSkeleton& skeleton, pugi::xml_node path, const std::vector<PathStop>& stops) {
  std::map<std::size_t, WrapSurface> on;  // by the number of the point before
  for (const pugi::xml_node wrap : path.child("PathWrapSet").child("objects").children("PathWrap")) {
    const std::optional<WrapSurface> surface = find(skeleton, wrap.child("wrap_object").child_value());
    if (!surface) continue;
    const std::vector<double> range = numbers_in(wrap.child("range"));
    const double first = range.size() == 2 && range[0] >= 1 ? range[0] - 1 : 0;
    const double last = range.size() == 2 && range[1] >= 1 ? range[1] - 1 : 1e9;
    std::vector<std::size_t> stretches;
    bool possible = true;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const auto number = static_cast<double>(stops[i].number);
      if (number < first || number >= last) continue;
      possible = possible && !stops[i].beside_conditional && on.count(stops[i].number) == 0;
      stretches.push_back(stops[i].number);
    }
    if (!possible) continue;
    for (const std::size_t i : stretches) on[i] = *surface;
  }
  double length = 0;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const auto found = on.find(stops[i].number);
    if (found == on.end()) {
      length += (stops[i + 1].at - stops[i].at).norm();
      continue;
    }
    const WrapSurface& surface = found->second;
    const Vec3 a = surface.pose.invert() * stops[i].at, b = surface.pose.invert() * stops[i + 1].at;
    length += surface.cylinder ? around_cylinder(a, b, surface) : around_sphere(a, b, surface.radius);
  }
  return length;
}

}  // namespace alembert::oracles

#include "import/opensim/osim_constraints.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_coordinates.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

using Point = std::array<double, 3>;

/// A point of a constraint in the axes of a frame, and points off it.
class Anchor {
 public:
  Anchor(OsimDescription& out, pugi::xml_node constraint, std::initializer_list<const char*> socket,
         const Point& point, const std::string& suffix)
      : Anchor(out, constraint,
               resolve_osim_frame(out.model, OsimXml::text(constraint, socket),
                                  "/constraintset/" + OsimXml::name_of(constraint), out.xml.where(constraint),
                                  OsimXml::title(constraint)),
               point, suffix) {}
  Anchor(OsimDescription& out, pugi::xml_node constraint, std::size_t frame, const Point& point,
         const std::string& suffix)
      : out_(out),
        at_(out.xml.where(constraint)),
        name_(OsimXml::name_of(constraint) + suffix),
        point_(point),
        frame_(frame),
        origin_(this->frame("", {})) {}
  const std::string& origin() const { return origin_; }
  /// Name of a frame that is so far off.
  std::string frame(const std::string& suffix, const Point& off) const {
    std::array<std::string, 3> text;
    for (std::size_t i = 0; i < 3; ++i) text[i] = number_text(point_[i] + off[i]);
    return out_.add_frame(name_ + suffix, frame_, text, at_);
  }

 private:
  OsimDescription& out_;
  SourceLocation at_;
  std::string name_;
  Point point_;
  std::size_t frame_;
  std::string origin_;
};

std::string difference(const std::string& a, const std::string& b, char axis) {
  return fmt::format("position({}).{} - position({}).{}", a, axis, b, axis);
}

/// (b - a) . (d - c)
std::string product_of_lines(const std::string& a, const std::string& b, const std::string& c,
                             const std::string& d) {
  std::vector<std::string> terms;
  for (const char axis : {'x', 'y', 'z'})
    terms.push_back(fmt::format("({})*({})", difference(b, a, axis), difference(d, c, axis)));
  return sum_text(terms);
}

std::vector<std::string> meeting(const Anchor& a, const Anchor& b) {
  std::vector<std::string> out;
  for (const char axis : {'x', 'y', 'z'}) out.push_back(difference(a.origin(), b.origin(), axis));
  return out;
}

std::vector<std::string> welded(const Anchor& a, const Anchor& b) {
  std::vector<std::string> equations = meeting(a, b);
  const std::string ay = a.frame("_y", {0, 1, 0}), az = a.frame("_z", {0, 0, 1}),
                    bx = b.frame("_x", {1, 0, 0}), by = b.frame("_y", {0, 1, 0});
  equations.push_back(product_of_lines(a.origin(), ay, b.origin(), bx));
  equations.push_back(product_of_lines(a.origin(), az, b.origin(), bx));
  equations.push_back(product_of_lines(a.origin(), az, b.origin(), by));
  return equations;
}

std::vector<std::string> weld(OsimDescription& out, pugi::xml_node element) {
  const auto places = out.model.places.find(element);
  const auto anchor = [&](std::size_t i, const char* socket, const char* suffix) {
    return places == out.model.places.end() ? Anchor(out, element, {socket}, {}, suffix)
                                            : Anchor(out, element, places->second[i], {}, suffix);
  };
  const Anchor a = anchor(0, "socket_frame1", "_1"), b = anchor(1, "socket_frame2", "_2");
  return welded(a, b);
}

std::vector<std::string> point(OsimDescription& out, pugi::xml_node element) {
  const Point first = out.xml.vector<3>(element, "location_body_1", {}),
              second = out.xml.vector<3>(element, "location_body_2", {});
  const Anchor a(out, element, {"socket_body_1", "body_1"}, first, "_1");
  const Anchor b(out, element, {"socket_body_2", "body_2"}, second, "_2");
  return meeting(a, b);
}

std::vector<std::string> distance(OsimDescription& out, pugi::xml_node element) {
  const Point first = out.xml.vector<3>(element, "location_body_1", {}),
              second = out.xml.vector<3>(element, "location_body_2", {});
  const double length = out.xml.required_number(element, "constant_distance");
  const Anchor a(out, element, {"socket_body_1", "body_1"}, first, "_1");
  const Anchor b(out, element, {"socket_body_2", "body_2"}, second, "_2");
  return {product_of_lines(a.origin(), b.origin(), a.origin(), b.origin()) + " - " +
          number_text(length * length)};
}

std::vector<std::string> point_on_line(OsimDescription& out, pugi::xml_node element) {
  const Point on_line = out.xml.vector<3>(element, "point_on_line", {}),
              follower = out.xml.vector<3>(element, "point_on_follower", {}),
              along = out.xml.vector<3>(element, "line_direction_vec", {0, 0, 1});
  const Eigen::Vector3d direction(along[0], along[1], along[2]);
  if (direction.norm() == 0)
    throw InputError(out.xml.where(element), OsimXml::title(element) + " has a line without direction");
  const Anchor line(out, element, {"socket_line_body", "line_body"}, on_line, "_line");
  const Anchor point(out, element, {"socket_follower_body", "follower_body"}, follower, "_point");
  // Nothing of the point is across the line, in either direction.
  const Eigen::Vector3d u = direction.unitOrthogonal(), v = direction.normalized().cross(u);
  const std::string to_u = line.frame("_u", {u.x(), u.y(), u.z()}),
                    to_v = line.frame("_v", {v.x(), v.y(), v.z()});
  return {product_of_lines(line.origin(), point.origin(), line.origin(), to_u),
          product_of_lines(line.origin(), point.origin(), line.origin(), to_v)};
}

struct OsimConstraintType {
  std::string_view name;
  std::vector<std::string> (*equations)(OsimDescription&, pugi::xml_node);
};
constexpr OsimConstraintType kOsimConstraintTypes[] = {{"WeldConstraint", weld},
                                                       {"PointConstraint", point},
                                                       {"ConstantDistanceConstraint", distance},
                                                       {"PointOnLineConstraint", point_on_line}};

}  // namespace

void add_osim_constraints(OsimDescription& out) {
  for (const pugi::xml_node element : osim_constraints(out)) {
    if (std::string_view(element.name()) == "CoordinateCouplerConstraint" ||
        !osim_is_enforced(out.xml, element))
      continue;
    const auto type =
        std::ranges::find(kOsimConstraintTypes, std::string_view(element.name()), &OsimConstraintType::name);
    if (type == std::end(kOsimConstraintTypes)) {
      out.left(element, "the equations are those without it", "add it to the description as a constraint");
      continue;
    }
    const SourceLocation at = out.xml.where(element);
    const std::string name = out.constraint_names.add(OsimXml::name_of(element), at);
    out.nodes.add_holonomic(*out.sections["constraints"], name, type->equations(out, element), at);
    out.took(element.name());
  }
  for (const OsimClosure& closure : out.model.closures) {
    const SourceLocation at = out.xml.where(closure.joint);
    const std::string name = out.constraint_names.add(OsimXml::name_of(closure.joint), at);
    const Anchor a(out, closure.joint, closure.frames[0], {}, "_1"),
        b(out, closure.joint, closure.frames[1], {}, "_2");
    out.nodes.add_holonomic(*out.sections["constraints"], name, welded(a, b), at);
    out.took("joints that close chains");
  }
}

}  // namespace alembert

#include "import/opensim/osim_wraps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "import/common/snapped_angle.hpp"
#include "mechanism/wrapped_path.hpp"

namespace alembert {
namespace {

/// Of x, +x or -x, say: a point beyond the surface along that axis. None where it is neither along x nor along y.
std::optional<std::array<double, 3>> point_of_quadrant(std::string_view quadrant, double radius) {
  const bool negative = quadrant[0] == '-';
  if (negative || quadrant[0] == '+') quadrant.remove_prefix(1);
  const std::size_t axis = std::string_view("xyXY").find(quadrant);
  if (quadrant.size() != 1 || axis == std::string_view::npos) return std::nullopt;
  std::array<double, 3> out{};
  out[axis % 2] = (negative ? -2 : 2) * radius;
  return out;
}

Eigen::Vector3d vector_of(const std::array<double, 3>& entries) {
  return Eigen::Vector3d(entries.data());
}

}  // namespace

OsimWraps::OsimWraps(OsimDescription& out, pugi::xml_node force, std::span<const OsimPathPoint> points)
    : out_(out), points_(points) {
  std::vector<std::string> straight;
  for (const pugi::xml_node wrap : out.xml.objects(force.child("GeometryPath"), "PathWrapSet")) {
    const std::string object = OsimXml::text(wrap, "wrap_object");
    const std::string name = object.empty() ? OsimXml::name_of(wrap) : object;
    const std::optional<Surface> surface = find(name);
    if (surface && !out.xml.flag(surface->element, "active", true)) continue;
    if (!surface || !add(wrap, *surface)) straight.push_back(printable(name));
  }
  if (!straight.empty())
    out.approximated(
        force, fmt::format("wraps over {}; its path is drawn straight there", fmt::join(straight, ", ")),
        "points of the path that are there under a condition (`when`) can lead it round");
}

YamlNode* OsimWraps::after(std::size_t point) const {
  const auto found = nodes_.find(point);
  return found == nodes_.end() ? nullptr : found->second;
}

/// Of the first body that has one of this name.
std::optional<OsimWraps::Surface> OsimWraps::find(const std::string& name) const {
  for (std::size_t b = 0; b < out_.model.bodies.size(); ++b)
    for (const pugi::xml_node element : out_.xml.objects(out_.model.bodies[b].element, "WrapObjectSet"))
      if (OsimXml::name_of(element) == name) return read(element, b);
  return std::nullopt;
}

std::optional<OsimWraps::Surface> OsimWraps::read(pugi::xml_node element, std::size_t body) const {
  const std::string_view type = element.name();
  Surface out{element, body, type == "WrapCylinder", 0, 0, {}, {}};
  if (!out.cylinder && type != "WrapSphere") return std::nullopt;
  out.radius = out_.xml.number(element, "radius", 0);
  if (!(out.radius > 0)) return std::nullopt;
  if (out.cylinder) out.length = out_.xml.number(element, "length", 0);
  out.offset = {out_.xml.vector<3>(element, "translation", {}),
                out_.xml.vector<3>(element, "xyz_body_rotation", {})};
  const std::string quadrant = OsimXml::text(element, "quadrant");
  if (quadrant.empty() || quadrant == "all" || quadrant == "All") return out;
  if (out.cylinder) out.side = point_of_quadrant(quadrant, out.radius);
  return out.side ? std::optional(out) : std::nullopt;
}

/// Whether a stretch that stays where it is, seen from the surface, misses it.
bool OsimWraps::is_clear(const Surface& surface, std::size_t point) const {
  const OsimPathPoint* ends[] = {&points_[point], &points_[point + 1]};
  std::array<Eigen::Vector3d, 2> seen;
  for (std::size_t i = 0; i < 2; ++i) {
    const OsimFrame& frame = out_.model.frames[ends[i]->on];
    if (frame.body != surface.body || !ends[i]->location) return false;
    seen[i] = pose_of({surface.offset}).inverse() * (pose_of(frame.offsets) * vector_of(*ends[i]->location));
  }
  const auto side = surface.side ? std::optional(vector_of(*surface.side)) : std::nullopt;
  return length_around(surface.cylinder, surface.radius, seen[0], seen[1], side) <=
         (seen[1] - seen[0]).norm();
}

bool OsimWraps::add(pugi::xml_node wrap, const Surface& surface) {
  // Points count from 1; less than that is the first and the last.
  const std::array<double, 2> range = out_.xml.vector<2>(wrap, "range", {-1, -1});
  const double count = static_cast<double>(points_.size());
  const auto index_of = [&](double number, double otherwise) {
    return static_cast<std::size_t>(std::min(number < 1 ? otherwise : number, count)) - 1;
  };
  const std::size_t begin = index_of(range[0], 1), end = index_of(range[1], count);
  std::vector<std::size_t> stretches;
  for (std::size_t i = begin; i < end; ++i) {
    if (is_clear(surface, i)) continue;
    if (points_[i].conditional || points_[i + 1].conditional || nodes_.contains(i)) return false;
    stretches.push_back(i);
  }
  for (const std::size_t i : stretches) nodes_.emplace(i, &node_of(surface));
  return true;
}

YamlNode& OsimWraps::node_of(const Surface& surface) const {
  const SourceLocation at = out_.xml.where(surface.element);
  const auto text = [](const auto& x) {
    return std::array{number_text(x[0]), number_text(x[1]), number_text(x[2])};
  };
  const std::string name = OsimXml::name_of(surface.element);
  YamlNode& out = out_.nodes.mapping(at);
  out_.put(
      out, surface.cylinder ? "cylinder" : "sphere",
      out_.add_frame(name, surface.body, text(surface.offset.translation), at, surface.offset.orientation),
      at);
  out_.put(out, "radius", number_text(surface.radius), at);
  if (surface.length > 0) out_.put(out, "length", number_text(surface.length), at);
  if (!surface.side) return out;
  const Eigen::Vector3d beyond = pose_of({surface.offset}) * vector_of(*surface.side);
  out_.put(out, "side", out_.add_frame(name + "_side", surface.body, text(beyond), at), at);
  return out;
}

}  // namespace alembert

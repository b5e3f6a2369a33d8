#include "import/mjcf/geom.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/shortest_turn.hpp"

namespace alembert {
namespace {

constexpr int kVisibleGroups = 3;  // 0, 1 and 2, as MuJoCo's viewers have it

}  // namespace

MjcfGeom::MjcfGeom(const MjcfElement& element, const RigidPose& frame, const MjcfCompiler& compiler,
                   const MjcfAssets& assets)
    : element_(element), assets_(assets) {
  shape_.where = element.where();
  const std::size_t type = element.word(
      "type", {"plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf"}, 2);
  massless_kind_ = type < 2;
  mesh_ = type >= 7;
  constexpr SolidKind kKinds[] = {SolidKind::sphere, SolidKind::capsule, SolidKind::ellipsoid,
                                  SolidKind::cylinder, SolidKind::box};
  group_ = static_cast<int>(element.number("group", 0));
  const bool primitive = type >= 2 && type < 7;
  // A primitive with a mesh is fitted to that, which is for viewers and contacts.
  if (primitive && !element.has("mesh")) shape_.kind = kKinds[type - 2];
  const std::optional<DrawnMesh> drawn = type == 7 ? assets.drawn(element.string("mesh")) : std::nullopt;
  RigidPose pose = compiler.pose(element);
  constexpr std::size_t kCounts[] = {1, 2, 3, 2, 3};
  std::size_t count = primitive ? kCounts[type - 2] : 0;
  if (const std::vector<double> ends = element.list("fromto", 6, 6);
      !ends.empty() && primitive && type != 2) {
    const Eigen::Vector3d from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
    const double length = (from - to).norm();
    if (!(length > 0))
      throw element.error("fromto", fmt::format("the ends of {} are one point", element.what()));
    pose.shift = (from + to) / 2;
    pose.turn = shortest_turn(Eigen::Vector3d::UnitZ(), (from - to) / length);
    if (shape_.kind != SolidKind::none) read_sizes(1);
    half_[1] = length / 2;
    if (count == 3) half_ = {half_[0], half_[0], length / 2};
  } else if (shape_.kind != SolidKind::none) {
    read_sizes(count);
  }
  shape_.pose = frame * pose;
  shape_.hidden = group_ >= kVisibleGroups;
  shape_.sizes = half_;
  if (count == 2) shape_.sizes[1] *= 2;
  if (shape_.kind == SolidKind::box)
    for (double& size : shape_.sizes) size *= 2;
  if (drawn) {
    shape_.kind = SolidKind::mesh;
    shape_.file = drawn->file.string();
    shape_.sizes = drawn->scale;
  }
  if (const std::vector<double> rgba = element.list("rgba", 4, 4); !rgba.empty())
    shape_.colour = {rgba[0], rgba[1], rgba[2]};
  else
    shape_.colour = assets.colour(element.string("material"));
  if (shape_.colour)
    for (double& each : *shape_.colour) each = std::clamp(each, 0.0, 1.0);
}

void MjcfGeom::read_sizes(std::size_t count) {
  if (!element_.has("size"))
    throw InputError(element_.where(), fmt::format("no size of {}", element_.what()));
  const std::vector<double> sizes = element_.overlaid("size", 3);
  if (sizes.size() < count)
    throw element_.error(
        "size", fmt::format("expected {} sizes of {}, found {}", count, element_.what(), sizes.size()));
  for (std::size_t i = 0; i < count; ++i) {
    if (!(sizes[i] > 0))
      throw element_.error("size",
                           fmt::format("expected positive sizes of {}, found {}", element_.what(), sizes[i]));
    half_[i] = sizes[i];
  }
}

BodyMass MjcfGeom::of_unit_density(bool shell) const {
  if (mesh_) {
    const BodyMass mesh = assets_.mesh(element_, shell);
    return mesh.moved(shape_.pose);
  }
  if (shape_.kind == SolidKind::none)
    throw element_.error(
        "mesh", fmt::format("{} is fitted to a mesh: its inertia is not worked out", element_.what()),
        "give the body an <inertial>");
  if (shell && shape_.kind == SolidKind::ellipsoid)
    throw element_.error("shellinertia", fmt::format("{} is the shell of an ellipsoid, whose inertia is not "
                                                     "worked out",
                                                     element_.what()));
  const BodyMass out =
      shell ? surface_of_unit_density(shape_.kind, half_) : solid_of_unit_density(shape_.kind, half_);
  return out.moved(shape_.pose);
}

BodyMass MjcfGeom::mass() const {
  if (massless_kind_) return {};
  if (element_.has("mass")) {
    const double mass = element_.number("mass", 0);
    if (mass < 0) throw element_.error("mass", fmt::format("the mass of {} is negative", element_.what()));
    if (mass == 0) return {};
    const BodyMass unit = of_unit_density(element_.flag("shellinertia", false));
    return unit.times(mass / unit.mass);
  }
  const double density = element_.number("density", 1000);
  if (density < 0)
    throw element_.error("density", fmt::format("the density of {} is negative", element_.what()));
  if (density == 0) return {};
  return of_unit_density(element_.flag("shellinertia", false)).times(density);
}

}  // namespace alembert

#include "import/mjcf/geom.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/shortest_turn.hpp"

namespace alembert {
namespace {

constexpr int kVisibleGroups = 3;  // 0, 1 and 2, as MuJoCo's viewers have it
/// Principal moments that differ by less, of the larger one, are those of a mesh that is meant to be symmetric.
constexpr double kAlikeMoments = 1e-6;

}  // namespace

MjcfGeom::MjcfGeom(const MjcfElement& element, const RigidPose& frame, const MjcfCompiler& compiler,
                   const MjcfAssets& assets)
    : element_(element), assets_(assets), fit_bounds_(compiler.fit_bounds) {
  shape_.where = element.where();
  const std::size_t type = element.word(
      "type", {"plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf"}, 2);
  massless_kind_ = type < 2;
  mesh_ = type >= 7;
  constexpr SolidKind kKinds[] = {SolidKind::sphere, SolidKind::capsule, SolidKind::ellipsoid,
                                  SolidKind::cylinder, SolidKind::box};
  group_ = static_cast<int>(element.number("group", 0));
  const bool primitive = type >= 2 && type < 7;
  if (primitive) primitive_ = kKinds[type - 2];
  // One with a mesh is fitted to that where its mass is asked for, and is not drawn: it is for contacts.
  if (!element.has("mesh")) shape_.kind = primitive_;
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
  shape_.colour = element.colour();
  if (!shape_.colour) shape_.colour = assets.colour(element.string("material"));
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

std::optional<MjcfFluidShape> MjcfGeom::fluid_shape() const {
  if (element_.word("fluidshape", {"none", "ellipsoid"}, 0) == 0) return {};
  MjcfFluidShape out{shape_.pose, half_, {0.5, 0.25, 1.5, 1, 1}, element_.where()};
  auto& d = out.semiaxes;
  if (primitive_ == SolidKind::sphere) d = {d[0], d[0], d[0]};
  if (primitive_ == SolidKind::capsule) d = {d[0], d[0], d[1] + d[0]};
  if (primitive_ == SolidKind::cylinder) d = {d[0], d[0], d[1]};
  std::ranges::copy(element_.overlaid("fluidcoef", out.coefficients.size()), out.coefficients.begin());
  return out;
}

BodyMass MjcfGeom::fitted_of_unit_density(bool shell) const {
  const MeshBox box = assets_.box(element_, fit_bounds_);
  const auto alike = [&](std::size_t i) {
    return box.moments[i] - box.moments[i + 1] <= kAlikeMoments * box.moments[i];
  };
  const bool has_axis = primitive_ == SolidKind::capsule || primitive_ == SolidKind::cylinder;
  if (fit_bounds_ ? alike(0) || alike(1) : has_axis && alike(1))
    throw element_.error(
        "mesh",
        fmt::format("{} is fitted to a mesh with equal principal moments of inertia, which do not "
                    "tell its axes",
                    element_.what()),
        "give the body an <inertial>");
  std::array<double, 3> half = box.half;
  const auto [x, y, z] = box.half;
  if (primitive_ == SolidKind::sphere) {
    half[0] = fit_bounds_ ? std::max({x, y, z}) : (x + y + z) / 3;
  } else if (has_axis) {
    half[0] = fit_bounds_ ? std::max(x, y) : (x + y) / 2;
    half[1] = z;
    if (primitive_ == SolidKind::capsule)
      half[1] = fit_bounds_ ? z - half[0] : std::max(0.0, z - half[0] / 2);
  }
  const double scale = element_.number("fitscale", 1);
  for (double& each : half) each *= scale;
  if (!(half[0] > 0) || half[1] < 0)
    throw element_.error("mesh", fmt::format("{} cannot be fitted to its mesh: a size would not be positive",
                                             element_.what()));
  const BodyMass out =
      shell ? surface_of_unit_density(primitive_, half) : solid_of_unit_density(primitive_, half);
  return out.moved(shape_.pose * box.pose);
}

BodyMass MjcfGeom::of_unit_density(bool shell) const {
  if (mesh_) {
    const BodyMass mesh = assets_.mesh(element_, shell);
    return mesh.moved(shape_.pose);
  }
  if (element_.has("mesh")) return fitted_of_unit_density(shell);
  const BodyMass out =
      shell ? surface_of_unit_density(primitive_, half_) : solid_of_unit_density(primitive_, half_);
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

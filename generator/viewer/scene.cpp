// Scenes from mechanisms and motions: poses to quaternions, parts to bodies, mechanisms beside each other.
#include "viewer/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/shortest_turn.hpp"
#include "viewer/contact_hints.hpp"
#include "viewer/coordinate_unit.hpp"
#include "viewer/looks.hpp"
#include "viewer/shapes.hpp"

namespace alembert {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d pose_of(std::span<const double> rows) {
  Isometry3d pose = Isometry3d::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) pose.matrix()(r, c) = rows[static_cast<std::size_t>(4 * r + c)];
  }
  return pose;
}

/// The turn that brings gravity to point down in the scene.
Eigen::Quaterniond upright(const Vector3d& gravity) {
  const double size = gravity.norm();
  if (!(size > 0)) return Eigen::Quaterniond::Identity();
  if (gravity[2] > (1 - 1e-9) * size)
    return Eigen::Quaterniond(0, 1, 0, 0);  // upside down: half a turn about x
  return shortest_turn(-gravity, Vector3d::UnitZ());
}

std::string unused_name(const Scene& scene, const std::string& name) {
  const auto taken = [&](const std::string& candidate) {
    return std::any_of(scene.mechanisms.begin(), scene.mechanisms.end(),
                       [&](const SceneMechanism& m) { return m.name == candidate; });
  };
  std::string candidate = name;
  for (int i = 2; taken(candidate); ++i) candidate = fmt::format("{} {}", name, i);
  return candidate;
}

std::vector<Series> coordinate_series(const InitialValues& initial, const BakedMotion& motion) {
  static constexpr const char* kParts[] = {".x", ".y", ".z", ".w"};
  std::vector<Series> out;
  for (const Coordinate& coordinate : initial.mechanism().coordinates) {
    const std::string unit = coordinate_unit(initial, coordinate);
    for (int part = 0; part < coordinate.nq(); ++part) {
      Series series{
          coordinate.name + (coordinate.nq() == 1 ? "" : kParts[part]), {}, unit, coordinate.limits};
      for (const std::vector<double>& q : motion.q)
        series.values.push_back(q.at(static_cast<std::size_t>(coordinate.first_q + part)));
      out.push_back(std::move(series));
    }
  }
  return out;
}

/// Points of a part, in place, that lie farthest out in 26 directions: enough for a box around it, however
/// turned.
std::vector<Vector3d> outermost(const Scene& scene, const ScenePart& part) {
  std::vector<Vector3d> out;
  for (int direction = 0; direction < 27; ++direction) {
    const Eigen::Vector3f d(static_cast<float>(direction % 3 - 1), static_cast<float>(direction / 3 % 3 - 1),
                            static_cast<float>(direction / 9 - 1));
    if (d.isZero()) continue;
    const std::vector<Eigen::Vector3f>& points = scene.meshes[part.mesh].positions;
    const auto farthest = std::max_element(points.begin(), points.end(),
                                           [&](const auto& a, const auto& b) { return a.dot(d) < b.dot(d); });
    out.push_back(part.placement * farthest->cast<double>());
  }
  return out;
}

}  // namespace

std::size_t Scene::mesh_index(Mesh mesh) {
  const auto found = std::find(meshes.begin(), meshes.end(), mesh);
  if (found != meshes.end()) return static_cast<std::size_t>(found - meshes.begin());
  meshes.push_back(std::move(mesh));
  return meshes.size() - 1;
}

void add_mechanism(Scene& scene, const Mechanism& mechanism, ExprGraph& graph, const BakedMotion& motion,
                   Warnings& warnings) {
  std::vector<BodyPoses> frames;
  for (const std::vector<double>& poses : motion.poses) {
    BodyPoses& frame = frames.emplace_back();
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
      frame.push_back(pose_of(std::span(poses).subspan(12 * b, 12)));
  }
  Looks looks = mechanism_looks(scene, mechanism, graph, motion, frames, warnings);

  SceneMechanism out;
  out.name = unused_name(scene, mechanism.name);
  out.description = mechanism.description;
  out.times = motion.times;
  const InitialValues values(mechanism, graph);
  out.placement.linear() = upright(values(mechanism.gravity)).toRotationMatrix();
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    SceneBody body;
    body.name = mechanism.bodies[b].name;
    body.center_of_mass = values(mechanism.bodies[b].mass_properties.com);
    Vec3 mass = mechanism.bodies[b].mass_properties.com;
    mass[0] = mechanism.bodies[b].mass_properties.mass;
    body.mass = values(mass)[0];
    body.parts = std::move(looks.bodies[b]);
    for (const BodyPoses& frame : frames) {
      body.origins.push_back(frame[b].translation());
      Eigen::Quaterniond rotation(frame[b].linear());
      rotation.normalize();
      if (!body.rotations.empty() && rotation.dot(body.rotations.back()) < 0)
        rotation.coeffs() = -rotation.coeffs();
      body.rotations.push_back(rotation);
    }
    out.bodies.push_back(std::move(body));
  }
  out.scenery = std::move(looks.world);
  out.coordinates = coordinate_series(values, motion);
  Series total{"total", {}, "J", {}};
  for (std::size_t k = 0; k < motion.times.size(); ++k)
    total.values.push_back(motion.kinetic[k] + motion.potential[k]);
  out.energies = {
      {"kinetic", motion.kinetic, "J", {}}, {"potential", motion.potential, "J", {}}, std::move(total)};
  out.acting = motion.acting;
  add_contact_hints(scene, out, values);
  if (!scene.title.empty()) scene.title += ", ";
  scene.title += out.name;
  scene.mechanisms.push_back(std::move(out));
}

Eigen::AlignedBox3d bounds(const Scene& scene, const SceneMechanism& mechanism, std::size_t frames) {
  Eigen::AlignedBox3d box;
  for (const ScenePart& part : mechanism.scenery) {
    for (const Vector3d& point : outermost(scene, part)) box.extend(point);
  }
  for (const SceneBody& body : mechanism.bodies) {
    std::vector<Vector3d> points;
    for (const ScenePart& part : body.parts) {
      const std::vector<Vector3d> more = outermost(scene, part);
      points.insert(points.end(), more.begin(), more.end());
    }
    if (points.empty()) points.push_back(body.center_of_mass);
    for (std::size_t k = 0; k < std::min(frames, body.origins.size()); ++k) {
      for (const Vector3d& point : points) box.extend(body.origins[k] + body.rotations[k] * point);
    }
  }
  for (const SceneLine& line : mechanism.acting.lines) {
    for (const std::vector<Vector3d>& point : line.points)
      for (std::size_t k = 0; k < std::min(frames, point.size()); ++k) box.extend(point[k]);
  }
  if (box.isEmpty()) box.extend(Vector3d::Zero());
  return box;
}

void place_side_by_side(Scene& scene) {
  const std::size_t n = scene.mechanisms.size();
  if (n < 2) return;
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<double> widths(columns), depths((n + columns - 1) / columns);
  double sizes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    boxes.push_back(bounds(scene, scene.mechanisms[i]).transformed(scene.mechanisms[i].placement));
    const Vector3d size = boxes[i].sizes();
    widths[i % columns] = std::max(widths[i % columns], size[0]);
    depths[i / columns] = std::max(depths[i / columns], size[1]);
    sizes += size.norm();
  }
  const double gap = 0.15 * sizes / static_cast<double>(n);
  double front = 0;
  for (std::size_t row = 0; row < depths.size(); ++row) {
    double left = 0;
    for (std::size_t column = 0; column < columns && row * columns + column < n; ++column) {
      const std::size_t i = row * columns + column;
      const Vector3d place(left + widths[column] / 2, front - depths[row] / 2, 0);
      Vector3d shift = place - boxes[i].center();
      shift[2] = -boxes[i].min()[2];
      scene.mechanisms[i].placement.pretranslate(shift);
      left += widths[column] + gap;
    }
    front -= depths[row] + gap;
  }
}

}  // namespace alembert

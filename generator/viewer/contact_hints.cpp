// Spheres and planes of contacts as parts (see the header).
#include "viewer/contact_hints.hpp"

#include <algorithm>

#include "support/shortest_turn.hpp"
#include "viewer/contacts.hpp"

namespace alembert {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// A piece of a plane, in sizes of the mechanism: beyond what touches it, how far at most, and how thick.
constexpr double kBeyond = 0.3, kReach = 2, kThickness = 0.012;

class ContactHints {
 public:
  ContactHints(Scene& scene, SceneMechanism& shown, const InitialValues& values)
      : scene_(scene), shown_(shown), values_(values) {}

  void add() {
    const std::vector<SphereContact>& contacts = values_.mechanism().contacts;
    for (const SphereContact& contact : contacts) {
      sphere(contact.frame, contact.radius);
      if (!contact.plane) sphere(contact.other, contact.other_radius);
    }
    const double size = std::max(bounds(scene_, shown_, 1).sizes().norm(), 1e-9);
    for (std::size_t i = 0; i < std::min(contacts.size(), shown_.acting.contacts.size()); ++i)
      if (contacts[i].plane) plane(contacts[i], shown_.acting.contacts[i].points, size);
  }

 private:
  int body_of(int frame) const {
    return frame < 0 ? -1 : values_.mechanism().frames[static_cast<std::size_t>(frame)].body;
  }
  Isometry3d placement_of(int frame) const {
    if (frame < 0) return Isometry3d::Identity();
    return values_.pose(values_.mechanism().frames[static_cast<std::size_t>(frame)].transform);
  }

  void add(int body, Mesh mesh, const Isometry3d& placement) {
    std::vector<ScenePart>& parts =
        body < 0 ? shown_.scenery : shown_.bodies[static_cast<std::size_t>(body)].parts;
    const Color color = body < 0 ? kSceneryColor : body_color(static_cast<std::size_t>(body));
    const std::size_t index = scene_.mesh_index(std::move(mesh));
    const bool there = std::ranges::any_of(parts, [&](const ScenePart& part) {
      return part.mesh == index && part.placement.isApprox(placement, 1e-9);
    });
    if (!there) parts.push_back({index, placement, color});
  }

  void sphere(int frame, const Expr& radius) {
    if (has_shapes(values_.mechanism(), body_of(frame))) return;
    const double size = values_({{radius, radius, radius}})[0];
    if (size > 0) add(body_of(frame), ellipsoid_mesh(Vector3d::Constant(size)), placement_of(frame));
  }

  /// As far as the points of contact go, and a little farther.
  void plane(const SphereContact& contact, const std::vector<Vector3d>& points, double size) {
    const int body = body_of(contact.other);
    if (has_shapes(values_.mechanism(), body)) return;
    const Vector3d normal = values_(contact.plane_normal);
    const Isometry3d placement = placement_of(contact.other) *
                                 Eigen::Translation3d(values_(contact.plane_point)) *
                                 shortest_turn(Vector3d::UnitZ(), normal);
    Eigen::AlignedBox2d reached;
    for (std::size_t k = 0; k < points.size(); ++k) {
      Isometry3d pose = Isometry3d::Identity();
      if (body >= 0) {
        const SceneBody& moving = shown_.bodies[static_cast<std::size_t>(body)];
        pose = Eigen::Translation3d(moving.origins[k]) * moving.rotations[k];
      }
      const Vector3d point = (pose * placement).inverse() * points[k];
      const Eigen::AlignedBox2d more = reached.merged(Eigen::AlignedBox2d(point.head<2>()));
      if (k > 0 && more.sizes().maxCoeff() > kReach * size) break;
      reached = more;
    }
    const double thickness = kThickness * size;
    const Eigen::Vector2d edges = reached.sizes().array() + 2 * kBeyond * size;
    const Vector3d center(reached.center()[0], reached.center()[1], -thickness / 2);
    add(body, box_mesh({edges[0], edges[1], thickness}), placement * Eigen::Translation3d(center));
  }

  Scene& scene_;
  SceneMechanism& shown_;
  const InitialValues& values_;
};

}  // namespace

void add_contact_hints(Scene& scene, SceneMechanism& shown, const InitialValues& values) {
  if (values.mechanism().contacts.empty() || shown.times.empty()) return;
  ContactHints(scene, shown, values).add();
}

}  // namespace alembert

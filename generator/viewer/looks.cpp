// What bodies look like (looks.hpp): shapes of the description, or mass and links.
#include "viewer/looks.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mechanism/transform_checks.hpp"
#include "support/shortest_turn.hpp"
#include "viewer/contacts.hpp"
#include "viewer/file_mesh.hpp"
#include "viewer/found_joint.hpp"
#include "viewer/shapes.hpp"

namespace alembert {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Kind = FoundJoint::Kind;

/// At most so many frames, evenly over the motion, are looked at to find joints.
constexpr std::size_t kJointFrames = 48;

Isometry3d at(const Vector3d& position) {
  return Isometry3d(Eigen::Translation3d(position));
}

/// Frame whose z axis points along a direction.
Isometry3d along(const Vector3d& position, const Vector3d& direction) {
  return at(position) * Isometry3d(shortest_turn(Vector3d::UnitZ(), direction));
}

/// Mass, centre and principal inertia of a body as numbers.
struct MassNumbers {
  double mass = 0;
  Vector3d center = Vector3d::Zero();
  Vector3d moments = Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

MassNumbers mass_numbers(const MassProperties& properties, const InitialValues& values) {
  MassNumbers out;
  Vec3 column = properties.com;
  out.center = values(column);
  column[0] = properties.mass;
  out.mass = values(column)[0];
  Eigen::Matrix3d inertia;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t r = 0; r < 3; ++r) column[r] = properties.inertia(r, c);
    inertia.col(static_cast<Eigen::Index>(c)) = values(column);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  out.moments = solver.eigenvalues().cwiseMax(0);
  out.axes = solver.eigenvectors();
  if (out.axes.determinant() < 0) out.axes.col(0) = -out.axes.col(0);
  return out;
}

/// Default looks of a mechanism: works out joints and sizes first, then draws body by body.
class DefaultLooks {
 public:
  DefaultLooks(Scene& scene, const Mechanism& mechanism, const InitialValues& values,
               std::span<const BodyPoses> frames)
      : scene_(scene), mechanism_(mechanism) {
    for (const Body& body : mechanism.bodies) masses_.push_back(mass_numbers(body.mass_properties, values));
    for (const Frame& frame : mechanism.frames) frames_.push_back(values.pose(frame.transform).translation());
    find_joints(frames);
    choose_sizes(frames);
  }

  /// Adds to the shapes that are there. A body that shows the surface it touches with needs no other shape of
  /// its mass.
  void draw(Looks& looks) {
    for (const std::vector<ScenePart>& parts : looks.bodies) has_surface_.push_back(!parts.empty());
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      if (!looks.has_shapes[b]) draw_body(looks, b);
      draw_joint(looks, b);
    }
  }

 private:
  void find_joints(std::span<const BodyPoses> frames) {
    Eigen::AlignedBox3d box;
    for (const BodyPoses& frame : frames) {
      for (std::size_t b = 0; b < frame.size(); ++b) box.extend(frame[b] * masses_[b].center);
    }
    extent_ = std::max(box.sizes().norm(), 1e-9);
    const std::size_t step = 1 + (frames.size() - 1) / kJointFrames;
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      const int parent = mechanism_.bodies[b].parent;
      std::vector<Isometry3d> relative;
      for (std::size_t k = 0; k < frames.size(); k += step) {
        relative.push_back(parent < 0 ? frames[k][b]
                                      : frames[k][static_cast<std::size_t>(parent)].inverse() * frames[k][b]);
      }
      joints_.push_back(find_joint(relative, extent_));
      // What several coordinates move, as a body that falls, may run straight without a rail.
      if (joints_.back().kind == Kind::slide && coordinates_of(mechanism_.bodies[b]) > 1) joints_.back() = {};
    }
  }

  std::size_t coordinates_of(const Body& body) const {
    const std::vector<Expr> moving = expressions_of(body.transform.factors, mechanism_);
    std::size_t count = 0;
    for (const Coordinate& coordinate : mechanism_.coordinates)
      count += depends_on(moving, coordinate.symbols[0]) ? static_cast<std::size_t>(coordinate.nv()) : 0;
    return count;
  }

  /// Points of a body that its links join: where it is held, where it holds others, and its named points.
  std::vector<Vector3d> ends(std::size_t b) const {
    std::vector<Vector3d> out;
    const FoundJoint& own = joints_[b];
    const Vector3d start = own.kind == Kind::none ? masses_[b].center : own.in_body;
    out.push_back(start);
    for (std::size_t child = 0; child < joints_.size(); ++child) {
      if (mechanism_.bodies[child].parent != static_cast<int>(b)) continue;
      const FoundJoint& held = joints_[child];
      if (held.kind == Kind::none) continue;
      const bool end_nearer =
          held.kind == Kind::slide && (held.end - start).norm() < (held.in_parent - start).norm();
      out.push_back(end_nearer ? held.end : held.in_parent);
    }
    for (std::size_t f = 0; f < mechanism_.frames.size(); ++f) {
      if (mechanism_.frames[f].body == static_cast<int>(b)) out.push_back(frames_[f]);
    }
    if (out.size() == 1 && masses_[b].mass > 0) out.push_back(masses_[b].center);
    return out;
  }

  void choose_sizes(std::span<const BodyPoses> frames) {
    double lengths = 0, masses = 0, radii = 0;
    int count = 0, heavy = 0, solid = 0;
    for (std::size_t b = 0; b < joints_.size(); ++b) {
      const std::vector<Vector3d> points = ends(b);
      for (std::size_t i = 1; i < points.size(); ++i) {
        const double length = (points[i] - points[0]).norm();
        if (length <= 1e-3 * extent_) continue;
        lengths += length;
        ++count;
      }
      if (masses_[b].mass <= 0) continue;
      masses += masses_[b].mass;
      ++heavy;
      if (masses_[b].moments.maxCoeff() <= 0) continue;
      radii += equivalent_ellipsoid(masses_[b].mass, masses_[b].moments).maxCoeff();
      ++solid;
    }
    mean_mass_ = heavy > 0 ? masses / heavy : 1;
    if (count > 0)
      length_ = lengths / count;
    else if (solid > 0)
      length_ = 3 * radii / solid;
    else
      length_ = frames.size() > 1 ? 0.3 * extent_ : 1;
    if (!(length_ > 1e-6)) length_ = 1;
  }

  double link_radius() const { return 0.035 * length_; }

  void add(std::vector<ScenePart>& parts, Mesh mesh, const Isometry3d& placement, Color color) {
    parts.push_back({scene_.mesh_index(std::move(mesh)), placement, color});
  }

  void link(std::vector<ScenePart>& parts, const Vector3d& from, const Vector3d& to, double radius,
            Color color) {
    const double length = (to - from).norm();
    if (length <= 1e-3 * length_) return;
    add(parts, capsule_mesh(radius, length), along((from + to) / 2, to - from), color);
  }

  void draw_body(Looks& looks, std::size_t b) {
    std::vector<ScenePart>& parts = looks.bodies[b];
    const Color color = body_color(b);
    if (has_surface_[b]) return;
    const std::vector<Vector3d> points = ends(b);
    for (std::size_t i = 1; i < points.size(); ++i) link(parts, points[0], points[i], link_radius(), color);
    const MassNumbers& mass = masses_[b];
    if (mass.mass <= 0) return;
    if (mass.moments.maxCoeff() > 0) {
      Vector3d axes = equivalent_ellipsoid(mass.mass, mass.moments);
      axes *= std::min(1.0, 0.55 * length_ / axes.maxCoeff());  // an odd inertia must not hide all else
      axes = axes.cwiseMax(0.02 * length_);
      Isometry3d placement = at(mass.center);
      placement.linear() = mass.axes;
      add(parts, ellipsoid_mesh(axes), placement, color);
    } else {
      const double size = 0.13 * length_ * std::clamp(std::cbrt(mass.mass / mean_mass_), 0.6, 1.6);
      add(parts, ellipsoid_mesh(Vector3d::Constant(size)), at(mass.center), color);
    }
  }

  /// What holds body b: a pin, a ball or a rail; only between bodies that have no shapes of their own.
  void draw_joint(Looks& looks, std::size_t b) {
    const Body& body = mechanism_.bodies[b];
    const FoundJoint& joint = joints_[b];
    const bool on_world = body.parent < 0;
    if (looks.has_shapes[b]) return;
    if (!on_world && looks.has_shapes[static_cast<std::size_t>(body.parent)]) return;
    const double radius = link_radius();
    switch (joint.kind) {
      case Kind::none:
      case Kind::fixed:
        return;
      case Kind::axis:
        add(looks.bodies[b], cylinder_mesh(1.7 * radius, 4.4 * radius), along(joint.in_body, joint.axis),
            kJointColor);
        return;
      case Kind::point:
        add(looks.bodies[b], ellipsoid_mesh(Vector3d::Constant(2 * radius)), at(joint.in_body), kJointColor);
        return;
      case Kind::slide: {
        std::vector<ScenePart>& parts =
            on_world ? looks.world : looks.bodies[static_cast<std::size_t>(body.parent)];
        const Vector3d margin = 0.05 * (joint.end - joint.in_parent);
        link(parts, joint.in_parent - margin, joint.end + margin, 0.6 * radius,
             on_world ? kSceneryColor : kJointColor);
        add(looks.bodies[b], box_mesh(Vector3d(3, 3, 5) * radius), along(Vector3d::Zero(), joint.axis),
            kJointColor);
        return;
      }
    }
  }

  Scene& scene_;
  const Mechanism& mechanism_;
  std::vector<MassNumbers> masses_;
  std::vector<FoundJoint> joints_;
  std::vector<bool> has_surface_;
  std::vector<Vector3d> frames_;  ///< named points, each on its body
  double extent_ = 1, length_ = 1, mean_mass_ = 1;
};

}  // namespace

Vector3d equivalent_ellipsoid(double mass, const Vector3d& moments, double least) {
  const double sum = moments.sum();
  const Vector3d squares = (5 / (2 * mass)) * (Vector3d::Constant(sum) - 2 * moments);
  const Vector3d axes = squares.cwiseMax(0).cwiseSqrt();
  return axes.cwiseMax(least * axes.maxCoeff());
}

Color body_color(std::size_t i) {
  static constexpr Color kPalette[] = {
      {0.306, 0.475, 0.655}, {0.949, 0.557, 0.169}, {0.349, 0.631, 0.310},
      {0.882, 0.341, 0.349}, {0.463, 0.718, 0.698}, {0.690, 0.478, 0.631},
      {0.929, 0.788, 0.282}, {0.612, 0.459, 0.373}, {1.000, 0.616, 0.655},
  };
  return kPalette[i % std::size(kPalette)];
}

Looks mechanism_looks(Scene& scene, const Mechanism& mechanism, ExprGraph& graph, const BakedMotion& motion,
                      std::span<const BodyPoses> frames, Warnings& warnings) {
  const InitialValues values(mechanism, graph);
  Looks looks;
  looks.bodies.resize(mechanism.bodies.size());
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    for (const Shape& shape : mechanism.bodies[b].geometry) {
      const Eigen::Isometry3d pose = values.pose(shape.transform);
      if (shape.kind != ShapeKind::mesh) {
        looks.bodies[b].push_back(
            {scene.mesh_index(shape_mesh(shape, values)), pose, shape.color.value_or(body_color(b))});
        continue;
      }
      try {
        for (ColoredMesh& part : file_meshes(shape))
          looks.bodies[b].push_back({scene.mesh_index(std::move(part.mesh)), pose,
                                     shape.color.value_or(part.color.value_or(body_color(b)))});
      } catch (const std::runtime_error& error) {
        warnings.push_back({shape.where,
                            fmt::format("'{}' {}: it is not drawn", printable(shape.file), error.what()),
                            "files of meshes are named from the folder of the description", "mesh"});
      }
    }
    looks.has_shapes.push_back(!looks.bodies[b].empty());
  }
  add_contacts(scene, looks, mechanism, graph, motion);
  if (!frames.empty()) DefaultLooks(scene, mechanism, values, frames).draw(looks);
  return looks;
}

}  // namespace alembert

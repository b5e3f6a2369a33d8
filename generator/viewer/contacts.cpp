// The curves and surfaces that bodies move on (looks.hpp): each is drawn once on the body or world it is
// fixed to, over the coordinates' limits, a full turn where it repeats after one, or as far as the motion
// goes.
#include "viewer/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/overloaded.hpp"
#include "symbolic/postorder.hpp"
#include "viewer/looks.hpp"
#include "viewer/shapes.hpp"
#include "viewer/swept_mesh.hpp"

namespace alembert {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// A curve or surface and the axes it is given in, relative to a body.
struct Contact {
  int body;  ///< -1: world
  Isometry3d placement;
  const Vec3* point;
  std::vector<Expr> along;
};

class ContactFinder {
 public:
  ContactFinder(const Mechanism& mechanism, const InitialValues& values)
      : mechanism_(mechanism), values_(values) {}

  std::vector<Contact> find() {
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      const Body& body = mechanism_.bodies[b];
      const std::span<const Factor> factors(body.transform.factors);
      for (std::size_t i = 0; i < factors.size(); ++i) {
        const auto add = [&](const Vec3& point, std::vector<Expr> along) {
          add_contact(static_cast<int>(b), i, point, std::move(along));
        };
        std::visit(Overloaded{[&](const CurveFrame& curve) { add(curve.point, {curve.along}); },
                              [&](const SurfaceFrame& surface) {
                                add(surface.point, {surface.u, surface.v});
                              },
                              [](const OneOf<Translation, AxisRotation, VectorRotation, QuaternionRotation,
                                             RigidMatrix> auto&) {}},
                   factors[i].value);
      }
    }
    return std::move(contacts_);
  }

 private:
  /// A curve or surface is given in the axes reached before its factor, the one of an inverse in those after it.
  void add_contact(int b, std::size_t i, const Vec3& point, std::vector<Expr> along) {
    const Body& body = mechanism_.bodies[static_cast<std::size_t>(b)];
    const std::span<const Factor> factors(body.transform.factors);
    const bool inverse = factors[i].inverse;
    const auto pose = constant_pose(inverse ? factors.subspan(i + 1) : factors.first(i));
    if (pose && depends_only_on(point.entries, along))
      contacts_.push_back(
          {inverse ? b : body.parent, inverse ? pose->inverse() : *pose, &point, std::move(along)});
  }

  std::optional<Isometry3d> constant_pose(std::span<const Factor> factors) {
    Transform transform;
    transform.factors.assign(factors.begin(), factors.end());
    const Isometry3d pose = values_.pose(transform);
    // Moved by a coordinate or by time: seen from the pose at another state.
    InitialValues other = values_;
    for (const Coordinate& coordinate : mechanism_.coordinates) {
      if (coordinate.type == CoordinateType::quaternion) {
        static constexpr double kTurned[4] = {0.5, 0.5, 0.5, 0.5};
        for (std::size_t i = 0; i < 4; ++i) other.set(coordinate.symbols[i], kTurned[i]);
      } else {
        other.set(coordinate.symbols[0], coordinate.initial[0] + 0.0123);
      }
    }
    other.set(mechanism_.time, 0.0321);
    const Isometry3d moved = other.pose(transform);
    if (!((moved.matrix() - pose.matrix()).norm() < 1e-9)) return std::nullopt;
    return pose;
  }

  bool depends_only_on(std::span<const Expr> roots, std::span<const Expr> symbols) const {
    for (const Coordinate& coordinate : mechanism_.coordinates) {
      for (const Expr& symbol : coordinate.symbols) {
        if (std::find(symbols.begin(), symbols.end(), symbol) == symbols.end() && has(roots, symbol))
          return false;
      }
    }
    return !has(roots, mechanism_.time);
  }
  static bool has(std::span<const Expr> roots, Expr symbol) {
    for (const std::uint32_t id : postorder(roots)) {
      if (id == symbol.ref().node()) return true;
    }
    return false;
  }

  const Mechanism& mechanism_;
  const InitialValues& values_;
  std::vector<Contact> contacts_;
};

/// The range over which to draw along a coordinate; `repeats` after a full turn.
Range drawn_range(const Mechanism& mechanism, const BakedMotion& motion, Expr symbol, bool repeats) {
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (coordinate.type != CoordinateType::real || coordinate.symbols[0] != symbol) continue;
    if (coordinate.limits) return {coordinate.limits->first, coordinate.limits->second};
    if (repeats) return {0, 2 * std::numbers::pi};
    Range range{coordinate.initial[0], coordinate.initial[0]};
    for (const std::vector<double>& q : motion.q) {
      const double value = q.at(static_cast<std::size_t>(coordinate.first_q));
      range = {std::min(range[0], value), std::max(range[1], value)};
    }
    const double margin = std::max(0.15 * (range[1] - range[0]), 0.25);
    return {range[0] - margin, range[1] + margin};
  }
  return {0, 2 * std::numbers::pi};
}

class ContactDrawing {
 public:
  ContactDrawing(const Contact& contact, const InitialValues& values) : contact_(contact), values_(values) {}

  Vector3d operator()(double u, double v = 0) const {
    InitialValues values = values_;
    values.set(contact_.along[0], u);
    if (contact_.along.size() > 1) values.set(contact_.along[1], v);
    return values(*contact_.point);
  }

  bool repeats(std::size_t parameter) const {
    static constexpr double kTurn = 2 * std::numbers::pi;
    for (const double u : {-0.7, 0.4, 1.9}) {
      for (const double v : {-0.3, 0.8}) {
        const Vector3d here = (*this)(u, v);
        const Vector3d there = parameter == 0 ? (*this)(u + kTurn, v) : (*this)(u, v + kTurn);
        if (!((there - here).norm() < 1e-9 * (1 + here.norm()))) return false;
      }
    }
    return true;
  }

 private:
  const Contact& contact_;
  const InitialValues& values_;
};

double diagonal(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : mesh.positions) box.extend(point);
  return static_cast<double>(box.sizes().norm());
}

Mesh contact_mesh(const Contact& contact, const InitialValues& values, const Mechanism& mechanism,
                  const BakedMotion& motion) {
  const ContactDrawing drawing(contact, values);
  const Range u = drawn_range(mechanism, motion, contact.along[0], drawing.repeats(0));
  if (contact.along.size() > 1) {
    const Range v = drawn_range(mechanism, motion, contact.along[1], drawing.repeats(1));
    return surface_mesh(drawing, u, v);
  }
  const auto curve = [&](double s) { return drawing(s); };
  // Thick enough to be seen: a share of the curve's own size.
  const double size = diagonal(tube_mesh(curve, u, 1e-6, 64));
  return tube_mesh(curve, u, 0.006 * size);
}

}  // namespace

bool has_shapes(const Mechanism& mechanism, int body) {
  if (body >= 0) return !mechanism.bodies[static_cast<std::size_t>(body)].geometry.empty();
  return std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(), [](const Body& b) {
    return b.parent < 0 && b.transform.factors.empty() && !b.geometry.empty();
  });
}

void add_contacts(Scene& scene, Looks& looks, const Mechanism& mechanism, ExprGraph& graph,
                  const BakedMotion& motion) {
  const InitialValues values(mechanism, graph);
  for (const Contact& contact : ContactFinder(mechanism, values).find()) {
    const bool world = contact.body < 0;
    const std::size_t b = static_cast<std::size_t>(std::max(contact.body, 0));
    if (has_shapes(mechanism, contact.body)) continue;
    Mesh mesh;
    try {
      mesh = contact_mesh(contact, values, mechanism, motion);
    } catch (const std::domain_error&) {
      continue;  // what has no picture still moves
    }
    std::vector<ScenePart>& parts = world ? looks.world : looks.bodies[b];
    const std::size_t index = scene.mesh_index(std::move(mesh));
    const bool there = std::any_of(parts.begin(), parts.end(), [&](const ScenePart& part) {
      return part.mesh == index && part.placement.isApprox(contact.placement, 1e-9);
    });
    if (!there) parts.push_back({index, contact.placement, world ? kSceneryColor : body_color(b)});
  }
}

}  // namespace alembert

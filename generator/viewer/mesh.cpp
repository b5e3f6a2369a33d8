// Meshes of solids of known form: their normals are known too. And what can be asked of every mesh.
#include "viewer/mesh.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace alembert {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Cosine and sine of turn i of n, exact where they are 0 and 1, and the same for i = 0 and i = n.
Vector2d turn(int i, int n) {
  const int k = i % n;
  if (4 * k % n == 0) {
    static const double kQuarters[5] = {1, 0, -1, 0, 1};
    const int quarter = 4 * k / n;
    return {kQuarters[quarter], quarter == 0 ? 0.0 : kQuarters[quarter - 1]};
  }
  return {std::cos(2 * pi * k / n), std::sin(2 * pi * k / n)};
}

std::uint32_t add(Mesh& mesh, const Vector3d& position, const Vector3d& normal) {
  mesh.positions.push_back(position.cast<float>());
  mesh.normals.push_back(normal.normalized().cast<float>());
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Distance from the z axis and height of a point of a meridian, with the normal there.
struct MeridianPoint {
  Vector2d position, normal;
};

/// The body swept by turning a meridian about z: upwards, its outside away from the axis. Points on the axis
/// become poles.
void revolve(Mesh& mesh, const std::vector<MeridianPoint>& meridian, int segments) {
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const MeridianPoint& point : meridian) {
    for (int i = 0; i <= segments; ++i) {
      const Vector2d t = turn(i, segments);
      const auto around = [&](const Vector2d& x) { return Vector3d(x[0] * t[0], x[0] * t[1], x[1]); };
      add(mesh, around(point.position), around(point.normal));
    }
  }
  const std::uint32_t row = static_cast<std::uint32_t>(segments) + 1;
  for (std::uint32_t j = 0; j + 1 < meridian.size(); ++j) {
    for (std::uint32_t i = 0; i < row - 1; ++i) {
      const std::uint32_t a = first + j * row + i, b = a + 1, c = a + row, d = c + 1;
      if (meridian[j].position[0] > 0) mesh.triangles.push_back({a, b, d});
      if (meridian[j + 1].position[0] > 0) mesh.triangles.push_back({a, d, c});
    }
  }
}

/// Flat end of a cylinder: a disc about the axis at a height, facing up or down.
void disc(Mesh& mesh, double radius, double height, bool up, int segments) {
  const Vector3d normal(0, 0, up ? 1 : -1);
  const std::uint32_t centre = add(mesh, {0, 0, height}, normal);
  for (int i = 0; i <= segments; ++i) {
    const Vector2d t = radius * turn(i, segments);
    const std::uint32_t rim = add(mesh, {t[0], t[1], height}, normal);
    if (i == 0) continue;
    if (up)
      mesh.triangles.push_back({centre, rim - 1, rim});
    else
      mesh.triangles.push_back({centre, rim, rim - 1});
  }
}

}  // namespace

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3d x = mesh.positions[a].cast<double>(), y = mesh.positions[b].cast<double>(),
                   z = mesh.positions[c].cast<double>();
    sum += x.dot(y.cross(z)) / 6;
  }
  return sum;
}

bool watertight(const Mesh& mesh) {
  using Point = std::array<float, 3>;
  const auto point = [&](std::uint32_t i) {
    // + 0 makes one zero of both.
    return Point{mesh.positions[i][0] + 0.0F, mesh.positions[i][1] + 0.0F, mesh.positions[i][2] + 0.0F};
  };
  std::map<std::pair<Point, Point>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point from = point(triangle[k]), to = point(triangle[(k + 1) % 3]);
      if (++edges[{from, to}] > 1) return false;
    }
  }
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge.second, edge.first})) return false;
  }
  return !edges.empty();
}

Mesh box_mesh(const Vector3d& edges) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vector3d normal = Vector3d::Zero(), u = normal, v = normal;
      normal[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1;
      std::array<std::uint32_t, 4> corners{};
      static constexpr std::array<std::array<int, 2>, 4> kSigns{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
      for (std::size_t k = 0; k < 4; ++k) {
        const Vector3d at = normal + kSigns[k][0] * u + kSigns[k][1] * v;
        corners[k] = add(mesh, 0.5 * at.cwiseProduct(edges), normal);
      }
      mesh.triangles.push_back({corners[0], corners[1], corners[2]});
      mesh.triangles.push_back({corners[0], corners[2], corners[3]});
    }
  }
  return mesh;
}

Mesh ellipsoid_mesh(const Vector3d& semi_axes, int segments) {
  // A unit sphere, stretched; normals by the inverse.
  Mesh mesh;
  std::vector<MeridianPoint> meridian;
  const int half = segments / 2;
  for (int j = 0; j <= half; ++j) {
    const Vector2d t = turn(j, 2 * half);  // from the lower pole
    meridian.push_back({{t[1], -t[0]}, {t[1], -t[0]}});
  }
  revolve(mesh, meridian, segments);
  const Eigen::Vector3f stretch = semi_axes.cast<float>();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = mesh.positions[i].cwiseProduct(stretch);
    mesh.normals[i] = mesh.normals[i].cwiseQuotient(stretch).normalized();
  }
  return mesh;
}

Mesh cylinder_mesh(double radius, double length, int segments) {
  Mesh mesh;
  revolve(mesh, {{{radius, -length / 2}, {1, 0}}, {{radius, length / 2}, {1, 0}}}, segments);
  disc(mesh, radius, -length / 2, false, segments);
  disc(mesh, radius, length / 2, true, segments);
  return mesh;
}

Mesh capsule_mesh(double radius, double length, int segments) {
  Mesh mesh;
  std::vector<MeridianPoint> meridian;
  const int quarter = segments / 4;
  for (int j = 0; j <= quarter; ++j) {
    const Vector2d t = turn(j, 4 * quarter);
    meridian.push_back({{radius * t[1], -length / 2 - radius * t[0]}, {t[1], -t[0]}});
  }
  for (int j = length > 0 ? 0 : 1; j <= quarter; ++j) {
    const Vector2d t = turn(quarter - j, 4 * quarter);
    meridian.push_back({{radius * t[1], length / 2 + radius * t[0]}, {t[1], t[0]}});
  }
  revolve(mesh, meridian, segments);
  return mesh;
}

Mesh torus_mesh(double radius, double tube_radius, int segments) {
  Mesh mesh;
  std::vector<MeridianPoint> meridian;
  const int around = segments / 2;
  for (int j = 0; j <= around; ++j) {
    const Vector2d t = turn(j, around);
    meridian.push_back({{radius + tube_radius * t[0], tube_radius * t[1]}, t});
  }
  revolve(mesh, meridian, segments);
  return mesh;
}

}  // namespace alembert

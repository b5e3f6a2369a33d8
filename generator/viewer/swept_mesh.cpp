// Meshes of tubes along curves and of surfaces given as functions. Both sample a grid; whether its sides meet
// is seen from the samples, and then they are made equal, so that the mesh is closed.
#include "viewer/swept_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "meshes/mesh_file.hpp"
#include "support/shortest_turn.hpp"
#include "viewer/mesh.hpp"

namespace alembert {

namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// Points nearer than this times the size of the whole are taken for one.
constexpr double kMeet = 1e-6;

double extent(const std::vector<Vector3d>& points) {
  Vector3d lower = points.front(), upper = points.front();
  for (const Vector3d& point : points) {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  return (upper - lower).norm();
}

/// (rows + 1) x (columns + 1) points, row by row.
struct Grid {
  std::uint32_t rows, columns;
  std::vector<Vector3d> points;
  std::uint32_t index(std::uint32_t r, std::uint32_t c) const { return r * (columns + 1) + c; }
  Vector3d& at(std::uint32_t r, std::uint32_t c) { return points[index(r, c)]; }
};

enum class Side { open, wraps, shrinks };

/// Makes the points of two opposite sides (or of one, shrunk to a point) equal where they are nearly so.
/// `along(i, end)` is point i of the first or last line of `count`.
template <class Along>
std::array<Side, 2> join(Along along, std::uint32_t count, double near) {
  std::array<Side, 2> sides{Side::wraps, Side::wraps};
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((along(i, false) - along(i, true)).norm() > near) sides = {Side::open, Side::open};
  }
  if (sides[0] == Side::wraps) {
    for (std::uint32_t i = 0; i < count; ++i) along(i, true) = along(i, false);
  }
  for (const bool end : {false, true}) {
    bool shrinks = true;
    for (std::uint32_t i = 1; i < count; ++i)
      shrinks = shrinks && (along(i, end) - along(0, end)).norm() <= near;
    if (!shrinks) continue;
    sides[end ? 1 : 0] = Side::shrinks;
    for (std::uint32_t i = 1; i < count; ++i) along(i, end) = along(0, end);
  }
  return sides;
}

/// Normals from the triangles around each point, those of equal points added up: second order in the grid's
/// spacing.
void smooth_normals(Mesh& mesh, const std::vector<Vector3d>& points) {
  std::vector<std::size_t> order(points.size()), same(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) {
    return std::array{mesh.positions[i][0], mesh.positions[i][1], mesh.positions[i][2]};
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    same[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? same[order[k - 1]] : order[k];
  }
  std::vector<Vector3d> sums(points.size(), Vector3d::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3d area = (points[b] - points[a]).cross(points[c] - points[a]);
    for (const std::uint32_t vertex : {a, b, c}) sums[same[vertex]] += area;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d& sum = sums[same[i]];
    const Vector3d unit = sum.norm() > 0 ? Vector3d(sum.normalized()) : Vector3d::UnitZ();
    mesh.normals.push_back(unit.cast<float>());
  }
}

Mesh mesh_of(const Grid& grid) {
  Mesh mesh;
  for (const Vector3d& point : grid.points) mesh.positions.push_back(point.cast<float>());
  const auto distinct = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return mesh.positions[a] != mesh.positions[b] && mesh.positions[b] != mesh.positions[c] &&
           mesh.positions[c] != mesh.positions[a];
  };
  for (std::uint32_t r = 0; r < grid.rows; ++r) {
    for (std::uint32_t c = 0; c < grid.columns; ++c) {
      const std::uint32_t a = grid.index(r, c), b = grid.index(r + 1, c), d = grid.index(r + 1, c + 1),
                          e = grid.index(r, c + 1);
      if (distinct(a, b, d)) mesh.triangles.push_back({a, b, d});
      if (distinct(a, d, e)) mesh.triangles.push_back({a, d, e});
    }
  }
  return mesh;
}

void turn_inside_out(Mesh& mesh) {
  turn_over(mesh.triangles);
  for (Eigen::Vector3f& normal : mesh.normals) normal = -normal;
}

double parameter(Range range, std::uint32_t i, std::uint32_t n) {
  return i == n ? range[1] : range[0] + (range[1] - range[0]) * i / n;
}

}  // namespace

Mesh surface_mesh(const std::function<Vector3d(double, double)>& surface, Range u_range, Range v_range,
                  int u_segments, int v_segments) {
  Grid grid{static_cast<std::uint32_t>(u_segments), static_cast<std::uint32_t>(v_segments), {}};
  for (std::uint32_t r = 0; r <= grid.rows; ++r) {
    for (std::uint32_t c = 0; c <= grid.columns; ++c) {
      grid.points.push_back(surface(parameter(u_range, r, grid.rows), parameter(v_range, c, grid.columns)));
      if (!grid.points.back().allFinite()) throw std::domain_error("the surface is not finite everywhere");
    }
  }
  const double near = kMeet * extent(grid.points);
  const auto u_sides =
      join([&](std::uint32_t i, bool end) -> Vector3d& { return grid.at(end ? grid.rows : 0, i); },
           grid.columns + 1, near);
  const auto v_sides =
      join([&](std::uint32_t i, bool end) -> Vector3d& { return grid.at(i, end ? grid.columns : 0); },
           grid.rows + 1, near);
  Mesh mesh = mesh_of(grid);
  if (mesh.triangles.empty() || !(near > 0)) throw std::domain_error("the surface has no area");
  smooth_normals(mesh, grid.points);
  const auto open = [](Side side) { return side == Side::open; };
  mesh.closed = std::none_of(u_sides.begin(), u_sides.end(), open) &&
                std::none_of(v_sides.begin(), v_sides.end(), open);
  if (mesh.closed && volume(mesh) < 0) turn_inside_out(mesh);
  return mesh;
}

Mesh tube_mesh(const std::function<Vector3d(double)>& curve, Range range, double radius, int segments) {
  const std::uint32_t n = static_cast<std::uint32_t>(segments);
  constexpr std::uint32_t kAround = 16;
  std::vector<Vector3d> centres;
  for (std::uint32_t i = 0; i <= n; ++i) {
    const Vector3d point = curve(parameter(range, i, n));
    if (!point.allFinite()) throw std::domain_error("the curve is not finite everywhere");
    // Points that the next one does not leave would have no tangent.
    if (centres.empty() || (point - centres.back()).norm() > 1e-9 * radius) centres.push_back(point);
  }
  if (centres.size() < 2) throw std::domain_error("the curve does not move");
  const std::size_t last = centres.size() - 1;
  const bool closed = last > 2 && (centres[last] - centres[0]).norm() <= kMeet * extent(centres);
  if (closed) centres[last] = centres[0];

  std::vector<Vector3d> tangents(centres.size());
  for (std::size_t i = 0; i <= last; ++i) {
    const Vector3d& before = i > 0 ? centres[i - 1] : centres[closed ? last - 1 : 0];
    const Vector3d& after = i < last ? centres[i + 1] : centres[closed ? 1 : last];
    tangents[i] = (after - before).normalized();
    if (!tangents[i].allFinite()) tangents[i] = i > 0 ? tangents[i - 1] : Vector3d::UnitX().eval();
  }
  // A direction across, carried along by the smallest turn from tangent to tangent.
  std::vector<Vector3d> across{tangents[0].unitOrthogonal()};
  for (std::size_t i = 1; i <= last; ++i) {
    const Vector3d carried = shortest_turn(tangents[i - 1], tangents[i]) * across[i - 1];
    across.push_back((carried - carried.dot(tangents[i]) * tangents[i]).normalized());
  }
  double twist = 0;  // by which a closed curve comes back turned, spread over its length
  if (closed) {
    const Vector3d& end = across[last];
    twist = std::atan2(end.cross(across[0]).dot(tangents[0]), end.dot(across[0]));
  }
  Mesh mesh;
  std::vector<Vector3d> ring;
  for (std::size_t i = 0; i <= last; ++i) {
    if (closed && i == last) {  // the same ring, to the last bit
      for (std::size_t k = 0; k <= kAround; ++k) {
        mesh.positions.push_back(Eigen::Vector3f(mesh.positions[k]));
        mesh.normals.push_back(Eigen::Vector3f(mesh.normals[k]));
      }
      break;
    }
    const double turned = twist * static_cast<double>(i) / static_cast<double>(last);
    for (std::uint32_t k = 0; k <= kAround; ++k) {
      const double angle = turned + 2 * pi * (k % kAround) / kAround;
      const Vector3d normal =
          (std::cos(angle) * across[i] + std::sin(angle) * tangents[i].cross(across[i])).normalized();
      mesh.positions.push_back((centres[i] + radius * normal).cast<float>());
      mesh.normals.push_back(normal.cast<float>());
    }
  }
  for (std::uint32_t i = 0; i < last; ++i) {
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const std::uint32_t a = i * (kAround + 1) + k, b = a + 1, c = a + kAround + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  if (closed) return mesh;
  for (const bool end : {false, true}) {
    const Eigen::Vector3f normal = (end ? tangents[last] : Vector3d(-tangents[0])).cast<float>();
    const std::uint32_t from = end ? static_cast<std::uint32_t>(last) * (kAround + 1) : 0;
    const std::uint32_t centre = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(centres[end ? last : 0].cast<float>());
    mesh.normals.push_back(normal);
    for (std::uint32_t k = 0; k <= kAround; ++k) {
      mesh.positions.push_back(Eigen::Vector3f(mesh.positions[from + k]));
      mesh.normals.push_back(normal);
      if (k == 0) continue;
      const std::uint32_t rim = centre + k;
      if (end)
        mesh.triangles.push_back({centre, rim, rim + 1});
      else
        mesh.triangles.push_back({centre, rim + 1, rim});
    }
  }
  return mesh;
}

}  // namespace alembert

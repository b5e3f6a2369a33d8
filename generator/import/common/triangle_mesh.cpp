// Mass properties of triangles by pyramids over them.
#include "import/common/triangle_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "meshes/mesh_file.hpp"

namespace alembert {
namespace {

/// Triangles about a point: pyramids over them, whose tip it is, or the triangles themselves.
struct Pyramid {
  double volume = 0;
  Eigen::Vector3d middle;  ///< of the triangle
  std::array<Eigen::Vector3d, 3> corners;

  Pyramid(const TriangleMesh& mesh, const std::array<std::size_t, 3>& triangle, const Eigen::Vector3d& tip,
          MeshVolume how) {
    for (std::size_t i = 0; i < 3; ++i) corners[i] = mesh.vertices[triangle[i]] - tip;
    middle = (corners[0] + corners[1] + corners[2]) / 3;
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2;
    volume = how == MeshVolume::shell ? normal.norm() : middle.dot(normal) / 3;
    if (how == MeshVolume::positive) volume = std::abs(volume);
  }
};

}  // namespace

TriangleMesh read_triangle_mesh(const std::filesystem::path& file) {
  TriangleMesh out;
  for (const MeshSurface& surface : read_mesh_file(file, MeshNormals::none)) {
    const std::size_t first = out.vertices.size();
    out.vertices.insert(out.vertices.end(), surface.vertices.begin(), surface.vertices.end());
    for (const auto& [a, b, c] : surface.triangles)
      out.triangles.push_back({first + a, first + b, first + c});
  }
  return out;
}

void stretch(TriangleMesh& mesh, const Eigen::Vector3d& factors) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = factors.cwiseProduct(vertex);
  if (factors.prod() < 0) turn_over(mesh.triangles);
}

BodyMass mass_properties(const TriangleMesh& mesh, MeshVolume how) {
  // About the middle of the surface, where the tips of pyramids cancel least.
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const Pyramid flat(mesh, triangle, Eigen::Vector3d::Zero(), MeshVolume::shell);
    area += flat.volume;
    tip += flat.volume * flat.middle;
  }
  if (area > 0) tip /= area;
  BodyMass out;
  double volume = 0;
  for (const auto& triangle : mesh.triangles) {
    const Pyramid pyramid(mesh, triangle, tip, how);
    volume += pyramid.volume;
    out.centre += pyramid.volume * (how == MeshVolume::shell ? 1.0 : 0.75) * pyramid.middle;
  }
  if (volume == 0) return {};
  out.centre = (out.centre / volume + tip).eval();
  for (const Eigen::Vector3d& vertex : mesh.vertices) out.summed = std::max(out.summed, vertex.norm());
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T
  // The volume of an open surface, and that of which all is counted as positive, depend on the tip: MuJoCo's is the
  // centre of mass.
  for (const auto& triangle : mesh.triangles) {
    const Pyramid pyramid(mesh, triangle, out.centre, how);
    out.mass += pyramid.volume;
    const auto& [d, e, f] = pyramid.corners;
    const Eigen::Vector3d sum = d + e + f;
    second += pyramid.volume / (how == MeshVolume::shell ? 12 : 20) *
              (d * d.transpose() + e * e.transpose() + f * f.transpose() + sum * sum.transpose());
  }
  out.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  return out;
}

}  // namespace alembert

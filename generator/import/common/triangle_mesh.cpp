// Surfaces by assimp, from memory, so that no file but the one that was named is opened.
#include "import/common/triangle_mesh.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace alembert {
namespace {

constexpr std::uintmax_t kMaximumFile = std::uintmax_t{256} << 20;

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
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) throw std::runtime_error("cannot be read: " + code.message());
  if (size > kMaximumFile) throw std::runtime_error("has more than 256 MiB");
  std::string bytes(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw std::runtime_error("cannot be read");
  std::string kind = file.extension().string();
  if (!kind.empty()) kind.erase(0, 1);
  Assimp::Importer importer;
  const aiScene* const scene =
      importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, kind.c_str());
  if (scene == nullptr || scene->mNumMeshes == 0)
    throw std::runtime_error(std::string("is no mesh that can be read: ") + importer.GetErrorString());
  TriangleMesh out;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    const std::size_t first = out.vertices.size();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      out.vertices.emplace_back(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      out.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  return out;
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
  for (const auto& triangle : mesh.triangles) {
    const Pyramid pyramid(mesh, triangle, tip, how);
    out.mass += pyramid.volume;
    out.centre += pyramid.volume * (how == MeshVolume::shell ? 1.0 : 0.75) * pyramid.middle;
  }
  if (out.mass == 0) return {};
  out.centre = (out.centre / out.mass + tip).eval();
  for (const Eigen::Vector3d& vertex : mesh.vertices) out.summed = std::max(out.summed, vertex.norm());
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T
  for (const auto& triangle : mesh.triangles) {
    const Pyramid pyramid(mesh, triangle, out.centre, how);
    const auto& [d, e, f] = pyramid.corners;
    const Eigen::Vector3d sum = d + e + f;
    second += pyramid.volume / (how == MeshVolume::shell ? 12 : 20) *
              (d * d.transpose() + e * e.transpose() + f * f.transpose() + sum * sum.transpose());
  }
  out.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  return out;
}

}  // namespace alembert

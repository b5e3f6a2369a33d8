#include "viewer/file_mesh.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "meshes/mesh_file.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTriangles = 8000;  ///< of a file
constexpr float kDeviation = 0.01f;       ///< share of the mesh's size by which fewer triangles may miss it

/// At most `triangles`, or as few as may be.
std::vector<unsigned> simplified(const MeshSurface& surface, std::size_t triangles) {
  std::vector<unsigned> indices;
  for (const auto& triangle : surface.triangles)
    for (const std::size_t index : triangle) indices.push_back(static_cast<unsigned>(index));
  if (surface.triangles.size() <= triangles) return indices;
  std::vector<float> positions;
  for (const Eigen::Vector3d& v : surface.vertices)
    for (const double x : v) positions.push_back(static_cast<float>(x));
  std::vector<unsigned> out(indices.size());
  const std::size_t wanted = 3 * triangles;
  out.resize(meshopt_simplify(out.data(), indices.data(), indices.size(), positions.data(),
                              surface.vertices.size(), 3 * sizeof(float), wanted, kDeviation, 0, nullptr));
  // Surfaces that are in pieces stay in pieces above; below they grow together.
  if (out.size() > 4 * wanted) {
    out.resize(indices.size());
    out.resize(meshopt_simplifySloppy(out.data(), indices.data(), indices.size(), positions.data(),
                                      surface.vertices.size(), 3 * sizeof(float), wanted, kDeviation,
                                      nullptr));
  }
  return out;
}

Mesh drawn(const MeshSurface& surface, std::size_t triangles, const Eigen::Vector3d& scale) {
  const std::vector<unsigned> indices = simplified(surface, triangles);
  Mesh out;
  out.closed = false;  // files promise nothing
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(surface.vertices.size(), kUnused);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned v = indices[i + k];
      if (place[v] == kUnused) {
        place[v] = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(scale.cwiseProduct(surface.vertices[v]).cast<float>());
        out.normals.push_back(surface.normals[v].cwiseQuotient(scale).normalized().cast<float>());
      }
      triangle[k] = place[v];
    }
    out.triangles.push_back(triangle);
  }
  if (scale.prod() < 0) turn_over(out.triangles);
  const auto finite = [](const Eigen::Vector3f& v) { return v.allFinite(); };
  if (!std::ranges::all_of(out.positions, finite) || !std::ranges::all_of(out.normals, finite))
    throw std::runtime_error("has points that are not finite");
  return out;
}

}  // namespace

std::vector<ColoredMesh> file_meshes(const Shape& shape) {
  const std::string& description = shape.where.source->name;
  const fs::path folder = description == "<stdin>" ? fs::path() : fs::path(description).parent_path();
  const std::vector<MeshSurface> surfaces = read_mesh_file(folder / shape.file, MeshNormals::smooth);
  std::size_t all = 0;
  for (const MeshSurface& surface : surfaces) all += surface.triangles.size();
  std::vector<ColoredMesh> out;
  for (const MeshSurface& surface : surfaces) {
    if (surface.triangles.empty()) continue;
    // Each surface keeps its share.
    const std::size_t share = all <= kTriangles
                                  ? surface.triangles.size()
                                  : std::max<std::size_t>(kTriangles * surface.triangles.size() / all, 4);
    Mesh mesh = drawn(surface, share, {shape.sizes[0], shape.sizes[1], shape.sizes[2]});
    if (!mesh.triangles.empty()) out.push_back({std::move(mesh), surface.color});
  }
  if (out.empty()) throw std::runtime_error("has no triangles");
  return out;
}

}  // namespace alembert

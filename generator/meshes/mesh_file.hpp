// Files of triangles (STL, OBJ, Collada, MSH of MuJoCo, and what else assimp reads). In: a file. Out: its surfaces as
// they lie in it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace alembert {

/// Triangles of one colour, counter-clockwise seen from outside where the file has them so.
struct MeshSurface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3d> normals;  ///< as many, of length 1, if they were asked for
  std::vector<std::array<std::size_t, 3>> triangles;
  std::optional<std::array<double, 3>> color;  ///< red green blue, 0 to 1
};

/// A surface that was mirrored, inside out again: corners of its triangles in the opposite order.
template <class Triangles>
void turn_over(Triangles& triangles) {
  for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

enum class MeshNormals {
  none,    ///< every vertex as it stands in the file
  smooth,  ///< means over faces that meet at less than 40 degrees; equal vertices are one
};

/// Lengths are the file's, in metres where it says how long its unit is (Collada). Axes are the file's: that it calls one
/// of them up turns nothing. Throws std::runtime_error, in words.
std::vector<MeshSurface> read_mesh_file(const std::filesystem::path& file, MeshNormals normals);

}  // namespace alembert

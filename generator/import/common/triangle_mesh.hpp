// Triangles of a surface, as files hold them; the mass properties of what they enclose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <vector>

#include "import/common/mass_properties.hpp"

namespace alembert {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
};

enum class MeshVolume {
  exact,     ///< by signed volumes: right for every closed surface whose triangles are turned outwards
  positive,  ///< every pyramid over a triangle counts as positive: as MuJoCo does unless it is told otherwise
  shell      ///< of the surface, not of what it encloses
};

/// All triangles of a file (meshes/mesh_file.hpp). Throws std::runtime_error, in words.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file);

/// Stretches it along its axes; by a negative factor it is mirrored, and its triangles turn outwards again.
void stretch(TriangleMesh& mesh, const Eigen::Vector3d& factors);

/// Of unit density, the mass being the volume, or the area of a shell.
BodyMass mass_properties(const TriangleMesh& mesh, MeshVolume how);

}  // namespace alembert

// Meshes of files as viewers draw them. In: a shape of the description that names one. Out: its surfaces, with no more
// triangles than can be told apart.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/model.hpp"
#include "viewer/mesh.hpp"
#include "viewer/scene.hpp"

namespace alembert {

struct ColoredMesh {
  Mesh mesh;
  std::optional<Color> color;  ///< of the file
};

/// In the axes of the shape. Throws std::runtime_error, in words, where the file is no mesh that can be read.
std::vector<ColoredMesh> file_meshes(const Shape& shape);

}  // namespace alembert

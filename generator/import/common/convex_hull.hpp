// Convex hulls of vertices, by qhull.
#pragma once

#include <optional>

#include "import/common/triangle_mesh.hpp"

namespace alembert {

/// The hull of a mesh's vertices as triangles turned outwards; of at most so many of them, the farthest first, if a
/// number (4 or more) is given. Throws std::runtime_error, in words, where they lie in one plane.
TriangleMesh convex_hull(const TriangleMesh& mesh, std::optional<int> vertices = std::nullopt);

}  // namespace alembert

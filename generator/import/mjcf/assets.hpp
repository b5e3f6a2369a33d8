// What geoms share: materials and meshes.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "import/common/triangle_mesh.hpp"
#include "import/mjcf/compiler_settings.hpp"

namespace alembert {

class MjcfAssets {
 public:
  MjcfAssets(const MjcfText& text, const MjcfDefaults& defaults, const MjcfCompiler& compiler);

  std::optional<std::array<double, 3>> colour(const std::string& material) const;
  /// Of unit density. Throws InputError, at the place that asks or in the asset, if the mesh is not there or
  /// encloses nothing.
  BodyMass mesh(const MjcfElement& geom, bool shell) const;

 private:
  TriangleMesh triangles(const MjcfElement& asset) const;

  const MjcfCompiler& compiler_;
  std::map<std::string, std::array<double, 3>, std::less<>> colours_;
  std::map<std::string, MjcfElement, std::less<>> meshes_;
};

}  // namespace alembert

// What geoms share: materials and meshes.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "import/common/triangle_mesh.hpp"
#include "import/mjcf/compiler_settings.hpp"

namespace alembert {

/// A mesh as it lies in its file, but for a scale.
struct DrawnMesh {
  std::filesystem::path file;
  std::array<double, 3> scale;
};

/// A box that stands for a mesh. Its axes are the principal axes of the mesh, that of the largest moment first.
struct MeshBox {
  RigidPose pose;  ///< of its middle and axes, in the frame of the mesh
  std::array<double, 3> half;
  std::array<double, 3> moments;  ///< of unit density
};

class MjcfAssets {
 public:
  MjcfAssets(const MjcfText& text, const MjcfDefaults& defaults, const MjcfCompiler& compiler);

  std::optional<std::array<double, 3>> colour(const std::string& material) const;
  /// Of unit density. Throws InputError, at the place that asks or in the asset, if the mesh is not there or
  /// encloses nothing.
  BodyMass mesh(const MjcfElement& geom, bool shell) const;
  /// The box with the inertia of the mesh, or with `bounds` the smallest that holds it. Throws as mesh() does.
  MeshBox box(const MjcfElement& geom, bool bounds) const;
  /// Nothing if there is no such file, or the asset is more than a file and a scale.
  std::optional<DrawnMesh> drawn(const std::string& mesh) const;

 private:
  /// Throws InputError if there is none of the name.
  const MjcfElement& asset_of(const MjcfElement& geom) const;
  TriangleMesh triangles(const MjcfElement& asset) const;
  /// Throws InputError if it lies outside the folder of the model.
  std::filesystem::path path_of(const MjcfElement& asset) const;

  const MjcfCompiler& compiler_;
  std::map<std::string, std::array<double, 3>, std::less<>> colours_;
  std::map<std::string, MjcfElement, std::less<>> meshes_;
  mutable std::map<std::pair<std::string, bool>, BodyMass> masses_;  ///< by mesh, and whether it is a shell
};

}  // namespace alembert

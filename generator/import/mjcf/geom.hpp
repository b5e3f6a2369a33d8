// A <geom> in; what is drawn of it and what mass it has out.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "import/mjcf/assets.hpp"

namespace alembert {

enum class MjcfShapeKind { none, sphere, capsule, ellipsoid, cylinder, box };

/// What viewers draw; sizes as the language takes them.
struct MjcfShape {
  MjcfShapeKind kind = MjcfShapeKind::none;
  std::array<double, 3>
      sizes{};  ///< sphere: radius; capsule, cylinder: radius and length; else along the axes
  MjcfPose pose;
  std::optional<std::array<double, 3>> colour;
  bool hidden = false;  ///< of a group that viewers leave out
  SourceLocation where;
};

class MjcfGeom {
 public:
  /// `frame`: where the element stands in its body.
  MjcfGeom(const MjcfElement& element, const MjcfPose& frame, const MjcfCompiler& compiler,
           const MjcfAssets& assets);

  const MjcfShape& shape() const { return shape_; }
  const MjcfElement& element() const { return element_; }
  bool has_fluid_shape() const { return element_.string("fluidshape", "none") == "ellipsoid"; }
  int group() const { return group_; }
  /// In the body's frame. Throws InputError where they cannot be found.
  BodyMass mass() const;

 private:
  BodyMass of_unit_density(bool shell) const;
  void read_sizes(std::size_t count);

  MjcfElement element_;
  const MjcfAssets& assets_;
  MjcfShape shape_;
  bool massless_kind_ = false, mesh_ = false;  ///< planes and height fields; meshes
  int group_ = 0;
  std::array<double, 3> half_{};  ///< sizes as the model gives them
};

}  // namespace alembert

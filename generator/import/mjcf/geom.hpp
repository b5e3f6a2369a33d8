// A <geom> in; what is drawn of it and what mass it has out.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "import/common/solid_shape.hpp"
#include "import/mjcf/assets.hpp"

namespace alembert {

/// An ellipsoid that the fluid flows around.
struct MjcfFluidShape {
  RigidPose pose;                      ///< in the body's frame
  std::array<double, 3> semiaxes;      ///< m; 0 where a mesh tells them
  std::array<double, 5> coefficients;  ///< blunt, slender and angular drag, Kutta's and Magnus' lift
  SourceLocation where;
};

class MjcfGeom {
 public:
  /// `frame`: where the element stands in its body.
  MjcfGeom(const MjcfElement& element, const RigidPose& frame, const MjcfCompiler& compiler,
           const MjcfAssets& assets);

  const PlacedShape& shape() const { return shape_; }
  const MjcfElement& element() const { return element_; }
  /// The ellipsoid that a fluid flows around, if it has one.
  std::optional<MjcfFluidShape> fluid_shape() const;
  bool is_mesh() const { return mesh_; }
  int group() const { return group_; }
  /// In the body's frame. Throws InputError where they cannot be found.
  BodyMass mass() const;

 private:
  BodyMass of_unit_density(bool shell) const;
  BodyMass fitted_of_unit_density(bool shell) const;
  void read_sizes(std::size_t count);

  MjcfElement element_;
  const MjcfAssets& assets_;
  PlacedShape shape_;
  SolidKind primitive_ = SolidKind::none;
  bool massless_kind_ = false, mesh_ = false;  ///< planes and height fields; meshes
  bool fit_bounds_;                            ///< primitives to the bounds of meshes, not to their inertia
  int group_ = 0;
  std::array<double, 3> half_{};  ///< sizes as the model gives them
};

}  // namespace alembert

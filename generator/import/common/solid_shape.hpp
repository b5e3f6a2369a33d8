// Shapes that viewers draw and whose mass properties are known; how the language says them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "import/common/mass_properties.hpp"
#include "import/common/transform_factors.hpp"

namespace alembert {

enum class SolidKind { none, sphere, capsule, ellipsoid, cylinder, box, mesh };

/// What viewers draw; sizes as the language takes them.
struct SolidShape {
  SolidKind kind = SolidKind::none;
  std::array<double, 3>
      sizes{};  ///< sphere: radius; capsule, cylinder: radius and length; else along the axes; mesh: its scale
  std::string file;                             ///< mesh: its path
  std::optional<std::array<double, 3>> colour;  ///< red green blue
  SourceLocation where;
};

struct PlacedShape : SolidShape {
  RigidPose pose;       ///< in the body
  bool hidden = false;  ///< of a group that viewers leave out
};

/// Whether there is a shape besides meshes. What becomes a body must not depend on whether files are there.
template <class Shapes>
bool has_solid(const Shapes& shapes) {
  return std::ranges::any_of(shapes, [](const SolidShape& shape) { return shape.kind != SolidKind::mesh; });
}

/// About the centre, in the axes of the shape; nothing for a mesh. Half sizes: edges and lengths by two, radii as they are.
BodyMass solid_of_unit_density(SolidKind kind, const std::array<double, 3>& half);
/// The same of the surface, the mass being the area. For an ellipsoid it is what MuJoCo takes: the area by Thomsen's
/// formula (within 1.1 %), and the mass spread as between it and an ellipsoid with half axes a micrometre longer.
BodyMass surface_of_unit_density(SolidKind kind, const std::array<double, 3>& half);

/// Appends an item of `geometry`, unless the kind is none.
/// \param pose    factors of where it lies in the body; may be empty
/// \param folder  of the description, from which meshes are named (mesh_names.hpp)
void add_shape(DescriptionNodes& nodes, YamlNode& shapes, const SolidShape& shape, const YamlNode& pose,
               const std::string& folder);
void add_shape(DescriptionNodes& nodes, const TransformFactors& factors, YamlNode& shapes,
               const PlacedShape& shape, const std::string& folder);

}  // namespace alembert

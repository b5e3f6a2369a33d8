// The mass of a body: what <inertial> says, or its geoms, corrected as <compiler> asks.
#pragma once

#include <vector>

#include "import/mjcf/compiler_settings.hpp"
#include "import/mjcf/geom.hpp"

namespace alembert {

/// `frame`: where the element stands in its body.
BodyMass read_inertial(const MjcfElement& element, const RigidPose& frame, const MjcfCompiler& compiler);

/// Of all geoms whose group counts.
BodyMass mass_of_geoms(const std::vector<MjcfGeom>& geoms, const MjcfCompiler& compiler);
/// The one of them that has mass; none if more have, or none has.
const MjcfGeom* only_geom_with_mass(const std::vector<MjcfGeom>& geoms, const MjcfCompiler& compiler);

/// The axes of an inertia.
Eigen::Quaterniond principal_turn(const BodyMass& mass);

/// With the least mass and inertia that the compiler asks for, and balanced. Throws InputError at `where` at an
/// inertia that no body can have, as MuJoCo does.
BodyMass corrected(BodyMass mass, const MjcfCompiler& compiler, const SourceLocation& where,
                   const std::string& what);

}  // namespace alembert

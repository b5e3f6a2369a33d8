// Mass properties in, keys of a body out.
#pragma once

#include "import/common/description_nodes.hpp"
#include "import/common/mass_properties.hpp"

namespace alembert {

/// `mass`, `com` and `inertia`, those that are not zero.
void add_mass(DescriptionNodes& nodes, YamlNode& body, const BodyMass& mass, const SourceLocation& where);

/// A force `at` the frame, the centre of mass of a body, that bears a part of the body's weight.
/// \param lift  the force, world axes
void add_borne_weight(DescriptionNodes& nodes, YamlNode& forces, const std::string& name,
                      const std::string& frame, const Eigen::Vector3d& lift, const SourceLocation& where);

}  // namespace alembert

// A <link> in, what it says of the robot out. What does not change the equations is told as a warning.
#pragma once

#include <array>
#include <map>
#include <pugixml.hpp>
#include <string>

#include "import/common/xml_text.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {

using Colour = std::array<double, 3>;
using Colours = std::map<std::string, Colour, std::less<>>;  // by material

/// The only <origin> of an element, or none: no shift and no turn.
UrdfPose read_origin(const XmlText& xml, pugi::xml_node element, const std::string& what);

/// Adds the colour of a <material>, if it has a name and a colour.
void read_material(const XmlText& xml, pugi::xml_node material, Colours& colours);

/// Name and place are those of the attribute `name`, which must be there.
UrdfLink read_link(const XmlText& xml, pugi::xml_node element, const Colours& colours);

}  // namespace alembert

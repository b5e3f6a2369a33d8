// A <joint> in, what it says of the robot out. What does not change the equations is told as a warning.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "import/common/xml_text.hpp"
#include "import/urdf/robot.hpp"

namespace alembert {

using Indices = std::map<std::string, std::size_t, std::less<>>;  // of links or joints, by name

/// The same; the joint that one mimics is found later. Throws at links that are none of `links`.
UrdfJoint read_joint(const XmlText& xml, pugi::xml_node element, const Indices& links);

/// A <transmission>: the reduction between the drive and the joints that it names, and the inertia of its
/// rotor, of which only Drake's dialect knows. A reduction below 0 turns the other way round; 0, no inertia and
/// what is no number say nothing.
void read_transmission(const XmlText& xml, pugi::xml_node element, std::vector<UrdfJoint>& joints,
                       const Indices& names);

/// The names, for messages.
std::vector<std::string> keys(const Indices& indices);

}  // namespace alembert

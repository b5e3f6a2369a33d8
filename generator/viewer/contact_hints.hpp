// What touches, where the description gives it no shape. In: contacts and the motion of a mechanism. Out: spheres, and
// pieces of the planes that the motion comes near to.
#pragma once

#include "viewer/scene.hpp"
#include "viewer/shapes.hpp"

namespace alembert {

/// Adds to the parts of a mechanism whose bodies and motion are there.
void add_contact_hints(Scene& scene, SceneMechanism& shown, const InitialValues& values);

}  // namespace alembert

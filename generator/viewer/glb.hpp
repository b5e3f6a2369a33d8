// Scenes as glTF 2.0 binary files. In: a scene. Out: the bytes of a .glb, which Blender, three.js and others
// open.
#pragma once

#include <string>

#include "viewer/scene.hpp"

namespace alembert {

/// A node for each mechanism and in it one for each body, moved by an animation: translation and rotation at
/// each frame, linear in between. The file's y axis points up, as glTF wants it: a node at the root turns the
/// mechanisms' z there.
std::string glb_file(const Scene& scene);

}  // namespace alembert

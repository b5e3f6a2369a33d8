// Scenes as one self-contained HTML page. In: a scene. Out: the page, with three.js, the scene and all else
// inside.
#pragma once

#include <string>
#include <string_view>

#include "viewer/scene.hpp"

namespace alembert {

/// The page with slots `@title@` and `@scene@`, as it was bundled when alembert was built; empty if it was
/// built without.
std::string page_template();

/// The scene as JSON: numbers of meshes and poses as little-endian float32 in base64. Contains no `<`, so
/// that no name can end the element it stands in.
std::string scene_json(const Scene& scene);

/// Text with the characters that HTML gives a meaning escaped.
std::string html_escaped(std::string_view text);

/// The page. Throws InternalError if page_template() is empty: whoever calls says what is missing.
std::string html_page(const Scene& scene);

}  // namespace alembert

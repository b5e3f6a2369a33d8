// Names of mesh files: what a description calls them.
#pragma once

#include <filesystem>
#include <string>

namespace alembert {

/// Whether a path is that of the folder or of what is in it; both weakly canonical.
bool lies_below(const std::filesystem::path& path, const std::filesystem::path& folder);

/// A file as a description in `folder` names it: from there. `folder` empty: the path as it is.
std::string described_mesh_name(const std::filesystem::path& file, const std::string& folder);

}  // namespace alembert

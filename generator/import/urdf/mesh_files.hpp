// Where the meshes of a robot are. In: what a URDF calls them. Out: files that are there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alembert {

/// The file of `package://PACKAGE/REST`, `model://MODEL/REST`, `file://PATH` or of a path beside the robot. A package is a
/// folder of that name above the robot, or one of `folders` or in it. Nothing where there is no such file, or where it
/// lies outside the package, the robot's folder and `folders`.
/// \param robot  name of the robot's file
std::optional<std::filesystem::path> find_urdf_mesh(const std::string& name, const std::string& robot,
                                                    const std::vector<std::string>& folders);

}  // namespace alembert

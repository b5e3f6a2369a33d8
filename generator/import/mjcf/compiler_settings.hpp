// What <compiler> says of how a model is to be read; orientations, which depend on it.
#pragma once

#include <array>
#include <string>

#include "import/common/rigid_pose.hpp"
#include "import/mjcf/element.hpp"

namespace alembert {

/// Vectors and quaternions shorter than this have no direction for MuJoCo.
inline constexpr double kNoDirection = 1e-14;

struct MjcfCompiler {
  bool degrees = true;
  bool global = false;        ///< whether places are in the axes of the world, as before MuJoCo 2.3.4
  std::string euler = "xyz";  ///< axes in order; capital ones do not move
  bool autolimits = true;
  enum class FromGeoms { no, yes, where_missing } inertia_from_geoms = FromGeoms::where_missing;
  std::array<double, 2> inertia_groups{0, 5};
  bool balance = false;
  double least_mass = 0, least_inertia = 0, total_mass = -1;
  bool strip_path = false, exact_meshes = false, fit_bounds = false;
  std::string mesh_folder;
  bool resolves_conflicts = false;  ///< between options of attached models: otherwise the model's own count

  /// Radians of an angle as the model gives it.
  double angle(double value) const;
  RigidPose pose(const MjcfElement& element) const;
  Eigen::Quaterniond turn(const MjcfElement& element) const;
  /// Of three angles as the model gives them, about the axes of `euler`.
  Eigen::Quaterniond euler_turn(const Eigen::Vector3d& angles) const;
};

MjcfCompiler read_compiler(const MjcfText& text);

}  // namespace alembert

// What every importer is asked for, and what it gives.
#pragma once

#include <string>
#include <vector>

#include "mechanism/document.hpp"
#include "support/error.hpp"

namespace alembert {

/// What becomes of joints that move no mass: forward dynamics has no solution with them.
enum class Massless {
  keep,      ///< they stay, with a warning
  armature,  ///< their coordinates get an armature
  freeze,    ///< they stand still at zero
  drop       ///< they are left out, and what they move with them
};

/// Where friction is tanh 1 of its largest, rad/s or m/s: robots' formats have no such width.
inline constexpr double kFrictionVelocity = 0.01;

struct DescribeOptions {
  bool floating = false;       ///< the root moves freely, by a position and a quaternion
  double snap_angles = 1e-10;  ///< angles of origins so near to a multiple of pi/12 are that multiple, rad
  Massless massless = Massless::keep;  ///< what becomes of joints that move no mass
  double armature = 1e-4;              ///< kg m^2 or kg, of their coordinates, if they get one
  bool resistance = true;              ///< damping and friction of joints act
  std::vector<std::string> include_folders =
      {};                   ///< where included models and meshes are looked for, besides the file's folder
  std::string folder = {};  ///< of the description, from which it names meshes; empty: the file's
  std::string name = {};    ///< what the mechanism is called; empty: as the file calls it

  const std::string& name_or(const std::string& own) const { return name.empty() ? own : name; }
};

struct DescribedRobot {
  Document document;
  Warnings warnings;                    ///< what is doubtful or left out
  std::string left = {};                ///< what was approximated or left out, in a line
  std::vector<std::string> files = {};  ///< what was read besides the source
};

}  // namespace alembert

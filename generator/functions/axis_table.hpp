// The numbers of a tree of axes (alembert/axis_tree.hpp), as generated code has them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "program/program.hpp"

namespace alembert {

/// An entry for each row, branch by branch: a speed and the frame that follows its motion.
struct AxisTable {
  std::vector<int> speeds;
  std::vector<int> parents;  ///< the row that carries it, or -1
  std::array<std::vector<double>, 3>
      directions;              ///< x y z of the axis in the frame, as long as the twist at unit speed
  std::vector<bool> turns;     ///< about the axis, or slides along it
  std::vector<double> masses;  ///< of what is fixed to the frame
  std::array<std::vector<double>, 3> centers;   ///< of mass, in the frame
  std::array<std::vector<double>, 6> inertias;  ///< about it, in the frame's axes: xx yy zz xy xz yz
  std::vector<double> armatures;
  std::vector<bool> first_of_three;  ///< whether the three speeds of a quaternion start here
  std::array<double, 3> gravity{};
  /// Which entries of the derivatives of applied forces are not zero: of those along the speeds, row by row, and then of
  /// those by the speeds.
  std::vector<int> force_entries;
};

/// What generated code has of a tree of axes. The programs are called axis_frames and axis_forces.
struct AxisPrograms {
  AxisTable table;
  Program frames;                 ///< AxisForm::frames
  std::optional<Program> forces;  ///< Q and changes of an AxisForm, where it has them
};

}  // namespace alembert

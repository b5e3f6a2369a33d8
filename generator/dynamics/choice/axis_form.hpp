// Mechanisms that are trees of axes: each speed turns or slides one frame about or along an axis that is fixed in it, as
// in alembert/axis_tree.hpp. In: kinematics. Out: the numbers of the tree, and as expressions what changes with the
// state, or nothing where a mechanism is more than that.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "functions/axis_table.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// More are left to functions written out: tables grow with their square.
inline constexpr int kMostAxes = 256;

struct AxisForm {
  AxisTable table;
  /// 12 x nv: for each row of the table [R p] of its frame, entry after entry. p is the way from the origin of a frame in
  /// the middle of the tree, so that a mechanism has its digits wherever it stands.
  std::vector<Expr> frames;
  /// Applied forces by rows, and the force_entries of their derivatives; empty where there are none.
  std::vector<Expr> Q, changes;
};

/// Inertias and gravity must be numbers; frames and applied forces may be of runtime parameters. Nothing for mechanisms of
/// so few speeds that linearize does not use it, or of too many.
std::optional<AxisForm> axis_form(const Kinematics& kinematics);

}  // namespace alembert

// What acts on a mechanism beside gravity and wrenches, as a description says it. Expressions here are over a longer
// list of variables than others: coordinates, speeds, the position of each frame, inputs, states, then of each frame
// its velocity, rotation (by rows) and angular velocity, all in the world, and of each path its length or value and the rate of that.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "oracles/description/expression.hpp"

namespace alembert::oracles {

/// A number that a state gives, or does not.
struct Input {
  std::string name;
  double initial = 0;
  std::optional<std::pair<double, double>> limits;
};

/// A number that is integrated beside coordinates and speeds.
struct Integrated {
  std::string name;
  double initial = 0;
  std::optional<std::pair<double, double>> limits;
  Expression rate;
};

/// The origin of a frame, where the condition is positive; elsewhere the path leads past it.
struct PathPoint {
  std::size_t frame;  ///< index
  Expression when;    ///< of no speeds, and of paths before this one; null: always
};
/// A sphere about the origin of a frame, or a cylinder about its z axis, that a path leads around; on the side of another
/// frame's origin, if there is one.
struct PathObstacle {
  std::size_t frame = 0;
  bool cylinder = false;
  Expression radius;
  Expression length;  ///< of a cylinder; null: endless
  std::optional<std::size_t> side;
};
/// From one point to the next; or, without points, something that has a value as a path has a length.
struct FramePath {
  std::vector<PathPoint> points;
  Expression value;                               ///< of no speeds, and of paths before this one
  std::map<std::size_t, PathObstacle> obstacles;  ///< by the point before them
};

struct SpeedForce {
  int speed;  ///< index
  Expression value;
};
struct Potential {
  Expression value;  ///< of no speeds
};
struct Tension {
  std::size_t path;    ///< index
  Expression tension;  ///< positive: shortens the path
};
/// Along what has a value in place of points.
struct ForceAlong {
  std::size_t path;  ///< index
  Expression value;  ///< positive: lets it grow
};
struct FrameForce {
  std::size_t frame;        ///< index; at its origin, and on its turn
  bool world_axes = false;  ///< or along the frame's axes
  Expression3 force, torque;
};
/// What is worth having, over the same variables.
struct Output {
  std::string name;
  Expression value;
};
using AppliedForce = std::variant<SpeedForce, Potential, Tension, ForceAlong, FrameForce>;

}  // namespace alembert::oracles

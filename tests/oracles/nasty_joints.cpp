// Draws coordinates and joints (see the header).
#include "oracles/nasty_joints.hpp"

#include <algorithm>
#include <array>

namespace alembert::oracles {

namespace {

// One for each mechanism: traps are met with few speeds as well, in less time.
constexpr std::array<std::size_t, 4> kMostSpeeds{3, 4, 6, 8};
constexpr int kMostSpeedsOfTransform = 6;

std::string joint_of(const std::string& type, const std::string& keys, const std::string& coordinates) {
  return "{joint: {type: " + type + ", " + keys + "coordinates: [" + coordinates + "]}}";
}

}  // namespace

NastyJoints::NastyJoints(RandomExpressions& draw, const NastyKind& kind, NastyMechanism& result)
    : NastyNumbers(draw, kind, result),
      draw_(draw),
      kind_(kind),
      result_(result),
      most_speeds_(kMostSpeeds[static_cast<std::size_t>(draw.below(static_cast<int>(kMostSpeeds.size())))]),
      late_(draw, result.events) {}

void NastyJoints::begin_transform() {
  used_.clear();
  used_speeds_ = 0;
}

bool NastyJoints::has_room(int speeds) const {
  return speeds_.size() + static_cast<std::size_t>(speeds) <= most_speeds_ &&
         used_speeds_ + speeds <= kMostSpeedsOfTransform;
}

void NastyJoints::use(const std::string& name, int speeds) {
  if (std::find(used_.begin(), used_.end(), name) != used_.end()) return;
  used_.push_back(name);
  used_speeds_ += speeds;
}

std::string NastyJoints::declared(const std::string& limits, double armature) {
  const std::string name = "q" + std::to_string(reals_++);
  coordinates_ += "  - {name: " + name + ", limits: [" + limits + "]";
  if (draw_.chance(0.1))
    coordinates_ += ", armature: " + value_or_parameter(armature * draw_.between(0.01, 1));
  coordinates_ += "}\n";
  speeds_.push_back("d(" + name + ")");
  use(name, 1);
  return name;
}

std::string NastyJoints::new_angle() {
  const double unit = scale() * result_.length;
  angles_.push_back(declared(kind_.late ? "-1, 10" : "-3, 3", mass() * unit * unit));
  return angles_.back();
}

std::string NastyJoints::new_length() {
  const double unit = scale() * result_.length;
  const std::string half = decimal(0.5 * unit);
  const std::string name = declared("-" + half + ", " + half, mass());
  result_.lengths[name] = unit;
  return name;
}

std::string NastyJoints::new_quaternion() {
  const std::string name = "r" + std::to_string(quaternions_++);
  coordinates_ += "  - {name: " + name + ", type: quaternion}\n";
  for (const char* axis : {"x", "y", "z"}) speeds_.push_back("d(" + name + ")." + axis);
  use(name, 3);
  return name;
}

std::string NastyJoints::old_angle() {
  if (angles_.empty()) return has_room(1) ? new_angle() : "t";
  const std::string name = angles_[static_cast<std::size_t>(draw_.below(static_cast<int>(angles_.size())))];
  const bool known = std::find(used_.begin(), used_.end(), name) != used_.end();
  if (!known && used_speeds_ >= kMostSpeedsOfTransform) return "t";
  use(name, 1);
  return name;
}

std::string NastyJoints::free_joint() {
  const std::string x = new_length(), y = new_length(), z = new_length();
  return joint_of("free", "", x + ", " + y + ", " + z + ", " + new_quaternion());
}

std::string NastyJoints::spherical_joint() {
  return joint_of("spherical", "", new_quaternion());
}

std::string NastyJoints::joint() {
  const std::string axis = joint_axis();
  const std::string about = "axis: " + axis + ", ";
  const int which = draw_.below(24);
  if (which < 4 && !speeds_.empty()) return joint_of("prismatic", about, new_length());
  if (which == 4 || which == 5) {
    const std::string pitch = value_or_parameter(draw_.between(0.05, 0.1) * result_.length);
    return joint_of("helical", about + "pitch: " + pitch + ", ", new_angle());
  }
  if (which == 6 && has_room(2)) {
    const std::string angle = new_angle(), length = new_length();
    return joint_of("cylindrical", about, angle + ", " + length);
  }
  if (which == 7 && has_room(2)) {
    const std::string first = new_angle(), second = new_angle();
    // Across the first axis, which may be along y in three ways.
    const bool along_y =
        axis == "y" || axis.rfind("[0, -1", 0) == 0 || axis.find(", -1, 0]") != std::string::npos;
    return joint_of("universal", "axes: [" + axis + (along_y ? ", x], " : ", y], "), first + ", " + second);
  }
  if (which == 8 && has_room(3)) {
    const std::string x = new_length(), y = new_length(), angle = new_angle();
    return joint_of("planar", "", x + ", " + y + ", " + angle);
  }
  if (which == 9 && has_room(3)) return spherical_joint();
  return joint_of("revolute", about, new_angle());
}

std::string NastyJoints::follower() {
  const std::string axis = joint_axis(), name = old_angle();
  const std::string k = number(-2, 2), b = number(-0.5, 0.5);
  const auto turned = [&](const std::string& angle) {
    return "{rotate: {axis: " + axis + ", angle: \"" + angle + "\"}}";
  };
  switch (draw_.below(6)) {
    case 0:
      return turned(late_.spline(name, 0.7, kind_.late ? 3 : -2, kind_.late ? 9 : 2));
    case 1:
      return turned(k + "*sin(" + name + ") + " + b);
    case 2:
      // Turns back what an earlier joint turned, or turns with it.
      return turned("-" + name);
    case 3:
      return name == "t" ? turned(name) : joint_of("revolute", "axis: " + axis + ", ", name);
    case 4:
      return turned(draw_.curved("sin(" + name + ")"));
    default:
      return turned(k + "*" + name + " + " + b);
  }
}

std::string NastyJoints::driven() {
  const std::string k = number(-2, 2);
  if (draw_.chance(0.5)) {
    const std::string axis = joint_axis(), b = number(-0.5, 0.5);
    return "{rotate: {axis: " + axis + ", angle: \"" + k + "*t + " + b + "*sin(3*t)\"}}";
  }
  const std::string x = length(), y = length();
  return "{translate: " + list({x + "*sin(" + k + "*t)", "0", y + "*t"}) + "}";
}

}  // namespace alembert::oracles

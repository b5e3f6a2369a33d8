#include "import/common/loop_equations.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};

/// The scalar product of steps from one origin to another.
std::string step_product(const std::string& a, const std::string& to_a, const std::string& b,
                         const std::string& to_b) {
  std::string out;
  for (const char* axis : kAxisNames)
    out += fmt::format("{}(position({}).{} - position({}).{})*(position({}).{} - position({}).{})",
                       out.empty() ? "" : " + ", to_a, axis, a, axis, to_b, axis, b, axis);
  return out;
}

/// Two directions at right angles to an axis and to each other.
std::array<Eigen::Vector3d, 2> across(const Eigen::Vector3d& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d one = axis.cross(Eigen::Vector3d::Unit(least)).normalized();
  return {one, axis.cross(one)};
}

}  // namespace

LoopEquations::LoopEquations(AddFrame add_frame)
    : add_frame_(std::move(add_frame)),
      first_(add_frame_(1, "", Eigen::Vector3d::Zero())),
      second_(add_frame_(2, "", Eigen::Vector3d::Zero())) {}

void LoopEquations::origins_meet() {
  for (const char* axis : kAxisNames)
    equations_.push_back(fmt::format("position({}).{} - position({}).{}", first_, axis, second_, axis));
}

void LoopEquations::axes_meet() {
  // Axes of the one are at right angles to the next axes of the other.
  std::string of_first[3], of_second[3];
  for (int k = 0; k < 3; ++k) {
    of_first[k] = add_frame_(1, kAxisNames[k], Eigen::Vector3d::Unit(k));
    of_second[k] = add_frame_(2, kAxisNames[k], Eigen::Vector3d::Unit(k));
  }
  for (int k = 0; k < 3; ++k)
    equations_.push_back(step_product(first_, of_first[k], second_, of_second[(k + 1) % 3]));
}

void LoopEquations::axis_meets(const Eigen::Vector3d& axis) {
  const std::string along = add_frame_(1, "axis", axis);
  for (int k = 0; k < 2; ++k)
    equations_.push_back(
        step_product(first_, along, second_,
                     add_frame_(2, k == 0 ? "u" : "v", across(axis)[static_cast<std::size_t>(k)])));
}

void LoopEquations::origin_on(const Eigen::Vector3d& axis) {
  for (int k = 0; k < 2; ++k)
    equations_.push_back(
        step_product(first_, add_frame_(1, k == 0 ? "u" : "v", across(axis)[static_cast<std::size_t>(k)]),
                     first_, second_));
}

void LoopEquations::angle_stays(const Eigen::Vector3d& of_first, const Eigen::Vector3d& of_second) {
  const std::string along = add_frame_(1, "axis", of_first), other = add_frame_(2, "axis", of_second);
  const std::string equation = step_product(first_, along, second_, other);
  const double cosine = of_first.dot(of_second);
  equations_.push_back(std::abs(cosine) < 1e-12 ? equation
                                                : fmt::format("{} - ({})", equation, number_text(cosine)));
}

}  // namespace alembert

// Equations by which frames of two bodies meet: those of joints that close a chain.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace alembert {

class LoopEquations {
 public:
  /// Adds the frame of one end, 1 or 2, shifted in its own axes, and gives its name. The suffix belongs to its name.
  using AddFrame =
      std::function<std::string(int end, const std::string& suffix, const Eigen::Vector3d& offset)>;
  explicit LoopEquations(AddFrame add_frame);

  /// The origins are one point.
  void origins_meet();
  /// The axes are parallel.
  void axes_meet();
  /// The axis, of length 1, has one direction in both frames.
  void axis_meets(const Eigen::Vector3d& axis);
  /// The second origin lies on the axis through the first.
  void origin_on(const Eigen::Vector3d& axis);
  /// An axis of the first frame and one of the second keep their angle.
  void angle_stays(const Eigen::Vector3d& of_first, const Eigen::Vector3d& of_second);

  std::vector<std::string> take() { return std::move(equations_); }

 private:
  AddFrame add_frame_;
  std::string first_, second_;
  std::vector<std::string> equations_;
};

}  // namespace alembert

// Coordinates of a description that is hard on numbers, and the factors of transforms that move with them.
#pragma once

#include <string>
#include <vector>

#include "oracles/late_functions.hpp"
#include "oracles/nasty_numbers.hpp"

namespace alembert::oracles {

class NastyJoints : public NastyNumbers {
 public:
  NastyJoints(RandomExpressions& draw, const NastyKind& kind, NastyMechanism& result);

  /// Begins a transform, which may depend on six speeds at most.
  void begin_transform();
  /// Whether there is room for so many new speeds.
  bool has_room(int speeds) const;
  /// Late functions change within the limits of an angle, far from where it begins.
  std::string new_angle();
  std::string new_length();
  std::string new_quaternion();
  /// Any angle that the transform may depend on, or a new one; time if there is no room.
  std::string old_angle();

  /// A joint of its own coordinates, of any type; there must be room for one.
  std::string joint();
  /// Shifts and turns that are free.
  std::string free_joint();
  std::string spherical_joint();
  /// Moves with an earlier coordinate and with none of its own.
  std::string follower();
  /// Moves with time alone.
  std::string driven();

  const std::string& coordinates() const { return coordinates_; }
  const std::vector<std::string>& angles() const { return angles_; }
  /// Texts of all speeds: d(q0), d(r0).x.
  const std::vector<std::string>& speeds() const { return speeds_; }
  LateFunctions& late() { return late_; }

 private:
  std::string declared(const std::string& limits, double armature);
  void use(const std::string& name, int speeds);

  RandomExpressions& draw_;
  const NastyKind& kind_;
  NastyMechanism& result_;
  std::size_t most_speeds_;
  LateFunctions late_;
  std::string coordinates_;
  std::vector<std::string> angles_, speeds_;
  std::vector<std::string> used_;  ///< in the transform that is being written
  int used_speeds_ = 0, quaternions_ = 0, reals_ = 0;
};

}  // namespace alembert::oracles

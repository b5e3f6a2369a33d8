// Random numbers, names and expressions of a description that is being written.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace alembert::oracles {

std::string decimal(double value);
/// A YAML list of quoted texts.
std::string list(const std::vector<std::string>& items);

/// Draws from one generator, one after another in a fixed order, so that a seed means one text with every
/// compiler.
class RandomExpressions {
 public:
  explicit RandomExpressions(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high);
  int below(int n);
  bool chance(double p);
  /// A number, or the name of a new parameter.
  std::string constant(double low, double high);
  /// Declares a runtime parameter with its default.
  void declare_parameter(const std::string& name, const std::string& usual);

  /// Begins a transform. What it depends on is counted, since it may have six speeds at most.
  void begin_transform();
  bool has_room(int speeds) const;
  bool depends_on_nothing() const { return used_.empty() && used_speeds_of_quaternions_ == 0; }
  /// Keeps room for coordinates that the transform will still need.
  void reserve(int speeds) { reserved_ = speeds; }
  std::string new_coordinate(double low = -1.5, double high = 1.5);
  std::string new_quaternion();
  /// An earlier coordinate, if the transform may still depend on it, or a number.
  std::string old_coordinate();

  /// Any real coordinate, or the speed of any coordinate, whatever it moves; a number if there is none.
  std::string any_coordinate();
  std::string any_speed();
  int speeds() const { return speeds_; }

  /// A smooth function of x alone, defined for |x| <= 1.5.
  std::string curved(const std::string& x);
  /// A function that moves with x, and perhaps with earlier coordinates and time.
  std::string function(const std::string& x);
  std::string axis();

  /// Declarations of the parameters that the text mentions: some are drawn in vain.
  std::string parameters_in(const std::string& text) const;
  const std::string& coordinates() const { return coordinates_; }
  const std::string& definitions() const { return definitions_; }

 private:
  std::mt19937_64 random_;
  std::map<std::string, std::string> parameters_;  // the line of each
  std::string coordinates_, definitions_;
  std::vector<std::string> reals_;
  std::vector<std::string> used_;       // real coordinates in the transform being written
  int used_speeds_of_quaternions_ = 0;  // in the same
  int reserved_ = 0;                    // speeds that the transform being written will still need
  int speeds_ = 0, quaternions_ = 0, parameter_count_ = 0, definition_count_ = 0;
};

}  // namespace alembert::oracles

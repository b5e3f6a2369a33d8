// Ways to write the same values: what recursions over several trees and whatever else give in, the shortest out.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/recursions/meeting_frames.hpp"

namespace alembert {

class Candidates {
 public:
  explicit Candidates(const Kinematics& kinematics) : kinematics_(kinematics) {}

  void add(const std::vector<Expr>& values);
  /// Over all trees of the motions, with and without meeting frames.
  void add_recursions(const EquationsOfMotion& equations,
                      const std::function<std::vector<Expr>(const WrittenTree&, FarPairs)>& values);
  /// Whether differentiating the whole can be shorter: beyond so many operations of a recursion it takes more, and
  /// long to write.
  bool may_be_whole() const { return least_ <= kWhole; }
  /// Of those that are close, what the optimised programs decide.
  std::vector<Expr> shortest() const;

 private:
  static constexpr std::size_t kWhole = 6'000;
  /// Beyond so many, expressions are counted, not programs, ...
  static constexpr std::size_t kCounted = 10'000;
  /// ... and only the estimated best meeting frames are tried, on the tree that M is of.
  static constexpr std::size_t kLong = 40'000;

  const Kinematics& kinematics_;
  std::vector<std::pair<std::size_t, std::vector<Expr>>> found_;  ///< with their operations
  std::size_t least_ = static_cast<std::size_t>(-1);
};

}  // namespace alembert

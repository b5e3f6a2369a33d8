// How long the programs of values are. In: lists of expressions. Out: what `optimize` makes of each, and the
// operations that it takes: what counts in the end. The same list is optimised once only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"
#include "symbolic/rewrite/optimize.hpp"

namespace alembert {

/// Operations, trigonometric functions and divisions among them; and those that are no sines and cosines,
/// which other functions may share. For these they are not weighted: by weights, 17 of 542 functions are longer
/// and none is shorter (mass matrix and bias of the knee 254 to 292).
using Length = std::pair<std::size_t, std::size_t>;

/// Whether a list of so many operations is not worth optimising, which takes time: it is hardly ever the shorter one in the
/// end. Over 321 choices among candidates and 6,161 trials of forms, none that was so much longer was taken.
constexpr bool is_far_longer(std::size_t operations, std::size_t least) {
  return operations > least + least / 10 + 30;
}

/// How much shorter optimising still makes a list behind each of its stages, at most, of the lists seen so far. Lists that are
/// compared with one another are alike: one that would end longer than it may, by this, is given up. It is a choice of length
/// only.
class LengthTrend {
 public:
  /// Whether a list will take more than `most` operations, of which it takes so many at a stage.
  bool is_above(std::size_t most, std::size_t stage, std::size_t operations) const;
  /// \param met  operations at each stage
  void add(const std::array<std::size_t, kOptimizeStages>& met, std::size_t in_the_end);

 private:
  int seen_ = 0;
  std::array<double, kOptimizeStages> least_{1, 1};  ///< of the operations in the end by those at a stage
};

/// Lists that were optimised, and their lengths.
class ProgramLengths {
 public:
  Length of(std::span<const Expr> values) { return measured(values).length; }
  /// Nothing where that is more than `most` operations for certain, or by the trend.
  std::optional<Length> within(std::size_t most, std::span<const Expr> values, LengthTrend& trend);
  const std::vector<Expr>& optimized(std::span<const Expr> values) { return measured(values).values; }

 private:
  struct Measured {
    Length length;
    std::vector<Expr> values;
  };
  using Key = std::vector<std::uint32_t>;  ///< the bits of the values
  static Key key_of(std::span<const Expr> values);
  const Measured& measured(std::span<const Expr> values);
  const Measured& add(Key key, std::vector<Expr> optimized);

  std::map<Key, Measured> known_;
  std::map<Key, std::size_t> above_;  ///< the most that lists were given up for
};

}  // namespace alembert

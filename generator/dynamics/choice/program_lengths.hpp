// How long the programs of values are. In: lists of expressions. Out: what `optimize` makes of each, and the
// operations that it takes: what counts in the end. The same list is optimised once only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "symbolic/expr.hpp"

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

/// Lists that were optimised, and their lengths.
class ProgramLengths {
 public:
  Length of(std::span<const Expr> values) { return measured(values).length; }
  const std::vector<Expr>& optimized(std::span<const Expr> values) { return measured(values).values; }

 private:
  struct Measured {
    Length length;
    std::vector<Expr> values;
  };
  const Measured& measured(std::span<const Expr> values);

  std::map<std::vector<std::uint32_t>, Measured> known_;  ///< by the bits of the values
};

}  // namespace alembert

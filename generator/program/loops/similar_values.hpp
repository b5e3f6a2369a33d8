// Which values of a program come about in the same way one step further along: in a recursion along a chain
// the angular velocity of a body and that of the next. In: a program. Out: for each value the one that it
// corresponds to in the next step.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "program/program.hpp"
#include "support/no_index.hpp"

namespace alembert {

/// A program without its signs: negations are none, differences are sums. Flattened, a sum of sums that are
/// used nowhere else is one value with many operands, and a product likewise.
class UnsignedProgram {
 public:
  struct Operand {
    std::uint32_t value;
    bool negative;
  };

  enum class Form : std::uint8_t { binary, flattened };

  explicit UnsignedProgram(const Program& program, Form form = Form::binary);

  /// Dot products in loops, which come last, are no values here.
  std::uint32_t size() const {
    return static_cast<std::uint32_t>(program_.code.size()) - program_.dot_product_code;
  }
  const Program& program() const { return program_; }
  /// Operation of a value; sums for differences. Negations remain, and no operand is one.
  Operation op(std::uint32_t v) const {
    return program_.code[v].op == Operation::sub ? Operation::add : program_.code[v].op;
  }
  std::span<const Operand> operands(std::uint32_t v) const { return operands_[v]; }
  /// True for what has become part of a flattened value.
  bool absorbed(std::uint32_t v) const { return absorbed_[v]; }
  bool constant(std::uint32_t v) const { return program_.code[v].op == Operation::constant; }
  bool leaf(std::uint32_t v) const { return constant(v) || program_.code[v].op == Operation::input; }
  bool commutes(std::uint32_t v) const { return op(v) == Operation::add || op(v) == Operation::mul; }
  /// True if operands x of a value and y of the next one are a pair by `next` too, or the same, or constants.
  bool pair(std::span<const std::uint32_t> next, std::uint32_t x, std::uint32_t y) const {
    return x == y || next[x] == y || (constant(x) && constant(y));
  }
  /// What an instruction is before its negation.
  Operand plain(std::uint32_t v) const { return plain_[v]; }
  /// Instructions that are wanted as they are: results and rows of dot products.
  std::vector<std::uint32_t> wanted() const;

 private:
  void flatten();

  const Program& program_;
  std::vector<Operand> plain_;
  std::vector<std::vector<Operand>> operands_;
  std::vector<bool> absorbed_;
};

/// Inputs that belong to a coordinate, in the order of the coordinates.
constexpr bool is_of_coordinate(ArgumentKind kind) {
  return kind == ArgumentKind::q || kind == ArgumentKind::qd || kind == ArgumentKind::qdd ||
         kind == ArgumentKind::tau || kind == ArgumentKind::mu;
}

/// How far apart the elements of q, and those of qd, qdd, tau and mu, are that correspond to each other: a
/// quaternion has four coordinates and three speeds.
struct Shift {
  std::uint32_t coordinates = 1, speeds = 1;
  std::uint32_t of(ArgumentKind kind) const { return kind == ArgumentKind::q ? coordinates : speeds; }
};

/// A partial, injective map between values. Values with the same operations a few levels deep correspond if
/// what they are computed from does, or what is computed from them.
struct Correspondence {
  Shift shift;
  std::vector<std::uint32_t> next, previous;  ///< of a value, or kNoIndex
  std::size_t size = 0;                       ///< values that have a next one
  bool along(std::uint32_t v) const { return next[v] != kNoIndex || previous[v] != kNoIndex; }
};

/// First come values with the same operations depths[0] levels deep, then depths[1], ...: deep ones tell
/// apart what is used alike, shallow ones reach farther towards the ends of a chain. The same program gives
/// the same.
Correspondence corresponding_values(const UnsignedProgram& program, Shift shift, std::span<const int> depths);

/// The shift, of some short ones, by which most values correspond to others with all that they are computed
/// from.
Shift shift_of_steps(const UnsignedProgram& program, std::span<const int> depths);

}  // namespace alembert

// Where the loops of a function find and leave values. In: a program with loops. Out: for each operand and
// each value of an iteration an element of kept, of an argument or of a table of constants, as a linear function
// of the number of the iteration.
//
// Values that follow each other in a loop lie side by side in kept, with what comes before the first and after
// the last. What needs another arrangement too lies there twice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "program/program.hpp"
#include "support/no_index.hpp"

namespace alembert {

/// Element first + step k of an array, for iteration k.
struct Element {
  std::int64_t first = 0, step = 0;
};

/// What an operand of an instruction is in all iterations.
struct LoopOperand {
  enum class Kind : std::uint8_t {
    inside,    ///< value `index` of the iteration
    literal,   ///< the constant `index` of the code
    constant,  ///< column `index` of the loop's table of constants
    input,     ///< element of an argument
    memory,    ///< element of kept
    carried,   ///< value `index` of the iteration before; of the first one, the element of kept
  } kind = Kind::inside;
  std::uint32_t index = 0;
  ArgumentKind array = ArgumentKind::q;
  Element element;
};

/// What one iteration of a loop is.
struct LoopBody {
  std::vector<std::array<LoopOperand, 2>> operands;                     ///< by instruction
  std::vector<std::vector<Element>> stores;                             ///< in kept
  std::vector<std::vector<std::pair<std::uint32_t, Element>>> results;  ///< output arrays and elements
  std::vector<double> constants;                                        ///< a row for each iteration
  std::uint32_t columns = 0;                                            ///< of that table
};

/// For each instruction the number of the loop that it is in, or kNoIndex.
std::vector<std::uint32_t> loop_numbers(const Program& program);

class LoopLayout {
 public:
  /// Values that lie side by side whatever the loops want: element i at `first` + i `step`.
  struct Fixed {
    std::vector<std::uint32_t> values;
    std::int64_t first, step;
  };

  LoopLayout(const Program& program, std::vector<Fixed> fixed, std::size_t first_place);

  /// False if the values of a loop cannot be arranged. Then nothing else can be asked for.
  bool possible() const { return possible_; }
  const std::vector<LoopBody>& bodies() const { return bodies_; }
  /// Where straight code leaves a value of its own, or takes one of a loop.
  const std::vector<std::uint32_t>& places(std::uint32_t v) const { return places_[v]; }
  /// Places of values of loops that straight code has to fill.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& late() const { return late_; }
  /// Whether straight code writes the results that a value of a loop is.
  bool results_late(std::uint32_t v) const { return results_late_[v]; }
  /// The loop that a value is of, or kNoIndex.
  std::uint32_t loop(std::uint32_t v) const { return loop_[v]; }
  /// End of what is used of kept.
  std::size_t end() const { return end_; }

 private:
  /// Values side by side, from position `low` on, kNoIndex in gaps.
  struct Track {
    std::vector<std::uint32_t> values;
    int low = 0;
    std::int64_t first = 0, step = 1;  ///< place of position 0, once it is known
    bool fixed = false;
  };
  struct Position {
    std::uint32_t track;
    int position;
  };
  using Additions = std::map<int, std::uint32_t>;

  int operands(std::uint32_t v) const;
  std::uint32_t operand(std::uint32_t v, std::size_t k) const {
    return k == 0 ? program_.code[v].a : program_.code[v].b;
  }
  std::uint32_t value(std::uint32_t loop, std::uint32_t iteration, std::uint32_t i) const {
    const Loop& l = program_.loops[loop];
    return l.first + iteration * l.length + i;
  }
  std::uint32_t iteration(std::uint32_t v) const {
    const Loop& l = program_.loops[loop_[v]];
    return (v - l.first) / l.length;
  }
  bool is_constant(std::uint32_t v) const;
  double constant(std::uint32_t v) const { return program_.constants[program_.code[v].a]; }

  void add_fixed(std::vector<Fixed> fixed);
  void find_results();
  void add_rows();
  void find_operands();
  LoopOperand operand_of(std::uint32_t loop, std::uint32_t i, std::size_t k);
  std::optional<LoopOperand> input_of(const std::vector<std::uint32_t>& values) const;
  std::optional<Position> find_track(const std::vector<std::uint32_t>& values, int& direction);
  /// Puts values side by side if they fit; loops store no more than they do unless they may.
  bool arrange(std::uint32_t track, int position, int direction, const std::vector<std::uint32_t>& values,
               bool more_stores);
  bool add(Additions& additions, const Track& track, int position, std::uint32_t v) const;
  bool is_left_at(const Track& track, int position, std::uint32_t v) const;
  int direction_of_row(const std::vector<std::uint32_t>& values, std::size_t k, int direction) const;
  std::uint32_t at(const Track& track, int position) const;
  void set(std::uint32_t track, int position, std::uint32_t v);
  std::int64_t place(const Position& position) const;
  void assign_places();
  void find_carried();
  void find_stores();
  void check() const;

  const Program& program_;
  bool possible_ = true;
  std::size_t end_;
  std::vector<std::uint32_t> loop_;
  std::vector<LoopBody> bodies_;
  std::vector<Track> tracks_;
  std::vector<std::vector<Position>> where_;  // of a value
  std::vector<std::vector<std::uint32_t>> places_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> late_;
  std::vector<bool> results_late_;
};

}  // namespace alembert

// Which values of a program get a statement of their own, and in which block of a long function each is
// computed. In: Program. Out: for every value whether it is live and named, its block, and its places in the
// array kept: of values that cross blocks, of tables whose rows' dot products are computed in loops, and of what
// loops find and leave there (loop_layout.hpp). A loop is a block of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "program/program.hpp"
#include "registers/loop_layout.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {

/// Functions of more statements than `longest` are cut into blocks of about `size`. Sines and cosines do not
/// count: those that come first stay together, however many they are.
struct BlockSizes {
  std::size_t longest = 2000, size = 1000;
};

/// What a statement is: an expression, as large as can be read, or an operation, with the product that a sum
/// takes up and signs.
enum class Grain { expressions, operations };

/// Operations where a plan says what registers hold, which it does for programs without loops.
inline Grain grain_over_packs(const Program& program) {
  return program.loops.empty() ? Grain::operations : Grain::expressions;
}

/// Layout of one program: what is live, named, in which block, and where values cross.
class StatementLayout {
 public:
  StatementLayout(const Program& program, const BlockSizes& sizes, Grain grain = Grain::expressions);

  bool live(std::uint32_t v) const { return uses_[v] > 0; }
  /// Has a statement of its own. Leaves have none.
  bool named(std::uint32_t v) const { return named_[v]; }
  /// The named value whose statement v is written in; kNoIndex if v is a leaf or not live.
  std::uint32_t statement(std::uint32_t v) const { return statement_[v]; }
  /// Number of a named value, in the order of the code.
  std::uint32_t number(std::uint32_t v) const { return number_[v]; }
  std::uint32_t block(std::uint32_t v) const { return block_[v]; }
  std::uint32_t blocks() const { return blocks_; }
  /// Place in w from which later blocks take the value, or kNoIndex.
  std::uint32_t place(std::uint32_t v) const { return place_[v]; }
  /// Size of kept.
  std::size_t crossing() const { return crossing_; }
  /// The first sine or cosine. There, those of all angles that are known by then and are wanted in the same
  /// block are computed together, if there are two or more; kNoIndex if there are not.
  std::uint32_t trig_call() const { return trig_call_; }
  /// The angles of that call.
  const std::vector<std::uint32_t>& angles() const { return angles_; }
  /// For a sine or cosine from that call the place of its angle, otherwise kNoIndex.
  std::uint32_t angle(std::uint32_t v) const { return angle_[v]; }
  /// Results that value v is, in order: pairs of output array and index.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& results(std::uint32_t v) const {
    return results_[v];
  }
  /// A single result and nothing else: `tau[0] = ...` without a name.
  bool result_only(std::uint32_t v) const { return results_[v].size() == 1 && uses_[v] == 1; }
  /// Places in w that value v has in the tables of dot products and for loops. The left tables are row after
  /// row, the right ones hold the first entries of all rows, then the second ones, and so on.
  const std::vector<std::uint32_t>& table_places(std::uint32_t v) const { return table_places_[v]; }
  /// A single entry of a table and nothing else.
  bool table_only(std::uint32_t v) const { return table_places_[v].size() == 1 && uses_[v] == 1; }
  /// Where the tables of each set of dot products begin in w.
  struct TablePlace {
    std::uint32_t left, right;
  };
  const std::vector<TablePlace>& tables() const { return tables_; }
  /// The loops, if the program has some.
  const std::optional<LoopLayout>& loops() const { return loops_; }
  /// First value of the loop that v is in.
  std::uint32_t first_of_loop(std::uint32_t v) const { return loop(v)->first; }
  /// Place in w of the sines of the call for all angles, which the cosines follow; kNoIndex if they are
  /// local.
  std::uint32_t trig_place() const { return trig_place_; }

 private:
  int operands(std::uint32_t v) const { return operand_count(program_.code[v].op); }
  void place_tables();
  void collect_uses();
  void choose_names();
  void name_operations();
  void collect_statements();
  void assign_blocks(const BlockSizes& sizes);
  void assign_crossings();
  void collect_angles();
  void place_loops();
  const Loop* loop(std::uint32_t v) const {
    return loop_[v] == kNoIndex ? nullptr : &program_.loops[loop_[v]];
  }
  /// The same value of the first iteration.
  std::uint32_t in_first(std::uint32_t v) const {
    return loop(v)->first + (v - loop(v)->first) % loop(v)->length;
  }
  bool same_iteration(std::uint32_t v, std::uint32_t w) const {
    return loop_[v] == loop_[w] && v - in_first(v) == w - in_first(w);
  }

  const Program& program_;
  std::size_t size_;
  std::vector<std::uint32_t> uses_, statement_, number_, block_, place_, angle_, angles_;
  std::vector<bool> named_;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> results_;
  std::vector<std::vector<std::uint32_t>> table_places_;
  std::vector<TablePlace> tables_;
  std::vector<std::uint32_t> loop_;  // of a value, or kNoIndex
  std::optional<LoopLayout> loops_;
  std::uint32_t blocks_ = 1, trig_call_ = kNoIndex, trig_place_ = kNoIndex;
  std::size_t crossing_ = 0;
};

}  // namespace alembert

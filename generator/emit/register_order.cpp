// Orders statements, see the header.
#include "emit/register_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "emit/statement_layout.hpp"
#include "program/operation.hpp"
#include "support/error.hpp"

namespace alembert {
namespace {

/// One fewer than x86 has, for what is being computed.
constexpr std::size_t kRegisters = 15;

/// Statements later than the first unwritten one by more are not looked at: the order of the whole stays, and
/// the time is linear.
constexpr std::uint32_t kLookAhead = 256;

// A choice's weights: a register that becomes free, a value that is in none, an operation between the choice
// and the last result that hangs on it (for one state only); and at most so many statements since the last
// use of an operand.
constexpr int kFreed = 200, kMissing = 100, kHeight = 128, kLongAgo = 100;

// A division takes as long as some other operations.
constexpr int kDivision = 4;

/// One statement: a named value with what is written into it.
struct Statement {
  std::vector<std::uint32_t> members;  ///< instructions, in their order; the last is the named value
  std::vector<std::uint32_t> reads;    ///< inputs and values of other statements, each once
  std::vector<std::uint32_t> readers;  ///< statements that read its value
  std::uint32_t unknown = 0;           ///< statements still to be written before it
  int height = 0;                      ///< operations from its first to the last result that needs it
  bool written = false;
};

class Ordering {
 public:
  Ordering(const Program& program, States states) : program_(program), size_(program.code.size()) {
    collect_statements();
    if (states == States::one) measure_heights();
    result_ = program;
    result_.code.clear();
    result_.constants.clear();
    place_.assign(size_, kNoPlace);
    used_at_.assign(size_, kNoPlace);
  }

  /// Instructions in their new order.
  const std::vector<std::uint32_t>& instructions() const { return instructions_; }

  Program order() {
    // All angles are known before the first sine.
    for (std::uint32_t s = 0; s < leading_; ++s)
      for (const std::uint32_t v : statements_[s].reads)
        if (is_leaf(program_.code[v].op)) emit(v);
    std::uint32_t next = 0;  // the first that is not written
    for (; next < leading_; ++next) write(next);
    while (next < statements_.size()) {
      write(best(next));
      while (next < statements_.size() && statements_[next].written) ++next;
    }
    const std::size_t straight = size_ - program_.dot_product_code;
    // Results and entries of tables that are inputs or constants.
    for (const OutputArray& output : program_.outputs)
      for (const std::uint32_t value : output.values)
        if (value < straight) emit(value);
    // What loops compute stays last.
    for (DotProducts& products : result_.dot_products)
      for (std::vector<std::uint32_t>* rows : {&products.left, &products.right})
        for (std::uint32_t& value : *rows) {
          emit(value);
          value = place_[value];
        }
    for (std::size_t v = straight; v < size_; ++v) emit(static_cast<std::uint32_t>(v));
    for (OutputArray& output : result_.outputs)
      for (std::uint32_t& value : output.values) value = place_[value];
    return std::move(result_);
  }

 private:
  std::array<std::uint32_t, 2> operands(std::uint32_t v) const {
    const Instruction& c = program_.code[v];
    const int count = operand_count(c.op);
    return {count > 0 ? c.a : kNoPlace, count > 1 ? c.b : kNoPlace};
  }

  void collect_statements() {
    const StatementLayout layout(program_, {size_, size_});
    std::vector<std::uint32_t> statement(size_, kNoPlace);
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!layout.live(v) || !layout.named(v)) continue;
      statement[v] = static_cast<std::uint32_t>(statements_.size());
      statements_.emplace_back();
      if (layout.angle(v) != kNoPlace) leading_ = statement[v] + 1;
    }
    // What is written into its user; users have larger indices.
    for (std::uint32_t v = static_cast<std::uint32_t>(size_); v-- > 0;)
      for (const std::uint32_t operand : operands(v))
        if (operand != kNoPlace && layout.live(v) && !layout.named(operand) &&
            !is_leaf(program_.code[operand].op))
          statement[operand] = statement[v];
    left_.assign(size_, 0);
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (statement[v] == kNoPlace) continue;
      Statement& s = statements_[statement[v]];
      s.members.push_back(v);
      for (const std::uint32_t operand : operands(v)) {
        if (operand == kNoPlace || program_.code[operand].op == Operation::constant) continue;
        if (statement[operand] == statement[v] || std::ranges::find(s.reads, operand) != s.reads.end())
          continue;
        s.reads.push_back(operand);
        ++left_[operand];
        if (statement[operand] == kNoPlace) continue;
        statements_[statement[operand]].readers.push_back(statement[v]);
        ++s.unknown;
      }
    }
  }

  void measure_heights() {
    std::vector<int> height(size_, 0);
    for (std::size_t v = size_; v-- > 0;) {
      height[v] += program_.code[v].op == Operation::div ? kDivision : 1;
      for (const std::uint32_t operand : operands(static_cast<std::uint32_t>(v)))
        if (operand != kNoPlace) height[operand] = std::max(height[operand], height[v]);
    }
    for (Statement& s : statements_)
      for (const std::uint32_t v : s.members) s.height = std::max(s.height, height[v]);
  }

  bool in_register(std::uint32_t v) const { return used_at_[v] != kNoPlace; }

  int score(const Statement& s) const {
    int score = kHeight * s.height, age = kLongAgo;
    for (const std::uint32_t v : s.reads) {
      if (!in_register(v)) {
        score -= kMissing;
        continue;
      }
      if (left_[v] == 1) score += kFreed;
      age = std::min(age, static_cast<int>(time_ - used_at_[v]));
    }
    return score - age;
  }

  std::uint32_t best(std::uint32_t first) const {
    const auto count = static_cast<std::uint32_t>(statements_.size());
    std::optional<std::pair<int, std::uint32_t>> found;
    for (std::uint32_t s = first; s < std::min(first + kLookAhead, count); ++s) {
      if (statements_[s].written || statements_[s].unknown > 0) continue;
      const int value = score(statements_[s]);
      if (!found || value > found->first) found = {value, s};
    }
    if (!found) throw InternalError("emit: no statement of " + program_.function + " can be next");
    return found->second;
  }

  void emit(std::uint32_t v) {
    if (place_[v] != kNoPlace) return;
    for (const std::uint32_t operand : operands(v))
      if (operand != kNoPlace && is_leaf(program_.code[operand].op)) emit(operand);
    Instruction c = program_.code[v];
    if (c.op == Operation::constant) {
      result_.constants.push_back(program_.constants[c.a]);
      c.a = static_cast<std::uint32_t>(result_.constants.size() - 1);
    }
    if (operand_count(c.op) > 0) c.a = place_[c.a];
    if (operand_count(c.op) > 1) c.b = place_[c.b];
    place_[v] = static_cast<std::uint32_t>(result_.code.size());
    result_.code.push_back(c);
    instructions_.push_back(v);
  }

  void write(std::uint32_t number) {
    Statement& s = statements_[number];
    for (const std::uint32_t v : s.members) emit(v);
    s.written = true;
    ++time_;
    for (const std::uint32_t v : s.reads) {
      use(v);
      if (--left_[v] == 0) give_up(v);
    }
    // Sines and cosines wait in memory, as inputs do.
    if (!s.readers.empty() && number >= leading_) use(s.members.back());
    while (registers_.size() > kRegisters)
      give_up(*std::ranges::min_element(registers_, {}, [&](std::uint32_t v) { return used_at_[v]; }));
    for (const std::uint32_t reader : s.readers) --statements_[reader].unknown;
  }

  void use(std::uint32_t v) {
    if (!in_register(v)) registers_.push_back(v);
    used_at_[v] = time_;
  }

  void give_up(std::uint32_t v) {
    registers_.erase(std::ranges::find(registers_, v));
    used_at_[v] = kNoPlace;
  }

  const Program& program_;
  std::size_t size_;
  Program result_;
  std::vector<std::uint32_t> instructions_;
  std::vector<Statement> statements_;
  std::uint32_t leading_ = 0;             // statements up to the last of the call for all angles
  std::uint32_t time_ = 0;                // statements written
  std::vector<std::uint32_t> left_;       // of a value: statements that will read it
  std::vector<std::uint32_t> used_at_;    // of a value in a register: the time of its last use
  std::vector<std::uint32_t> registers_;  // values in registers
  std::vector<std::uint32_t> place_;      // of an instruction: in the result
};

/// Orders what lies between loops, and one iteration of each, which stands for all.
class LoopOrdering {
 public:
  LoopOrdering(const Program& program, States states)
      : program_(program),
        states_(states),
        size_(static_cast<std::uint32_t>(program.code.size())),
        segment_(size_, 0) {}

  Program order() {
    divide();
    std::uint32_t begin = 0;
    for (const Loop& loop : program_.loops) {
      straight(begin, loop.first);
      begin = loop.first + loop.length * loop.count;
      const std::vector<std::uint32_t> one = ordered(loop.first, loop.first + loop.length);
      loops_.push_back({static_cast<std::uint32_t>(order_.size()), loop.length, loop.count});
      for (std::uint32_t k = 0; k < loop.count; ++k)
        for (const std::uint32_t v : one) order_.push_back(v + k * loop.length);
    }
    straight(begin, size_ - program_.dot_product_code);
    for (std::uint32_t v = size_ - program_.dot_product_code; v < size_; ++v) order_.push_back(v);
    return rearranged();
  }

 private:
  /// segment_: a number for each iteration and each stretch of straight code. Leaves go first.
  void divide() {
    std::uint32_t begin = 0, segment = 1;
    const auto number = [&](std::uint32_t end) {
      for (std::uint32_t v = begin; v < end; ++v) segment_[v] = is_leaf(program_.code[v].op) ? 0 : segment;
      begin = end;
      ++segment;
    };
    for (const Loop& loop : program_.loops) {
      number(loop.first);
      for (std::uint32_t k = 1; k <= loop.count; ++k) number(loop.first + k * loop.length);
    }
    number(size_ - program_.dot_product_code);
    number(size_);
    wanted_.assign(size_, false);
    for (std::uint32_t v = 0; v < size_; ++v) {
      const Instruction& c = program_.code[v];
      const int count = operand_count(c.op);
      if (count > 0 && segment_[c.a] != segment_[v]) wanted_[c.a] = true;
      if (count > 1 && segment_[c.b] != segment_[v]) wanted_[c.b] = true;
    }
    for (const OutputArray& output : program_.outputs)
      for (const std::uint32_t v : output.values) wanted_[v] = true;
    for (const DotProducts& products : program_.dot_products)
      for (const auto* rows : {&products.left, &products.right})
        for (const std::uint32_t v : *rows) wanted_[v] = true;
    for (std::uint32_t v = 0; v < size_; ++v)
      if (segment_[v] == 0) order_.push_back(v);
  }

  void straight(std::uint32_t begin, std::uint32_t end) {
    const std::vector<std::uint32_t> part = ordered(begin, end);
    order_.insert(order_.end(), part.begin(), part.end());
  }

  /// A program of these instructions alone, with what they take from elsewhere as its inputs.
  std::vector<std::uint32_t> ordered(std::uint32_t begin, std::uint32_t end) {
    Program part;
    part.function = program_.function;
    part.outputs.push_back({"values", 0, 1, {}});
    std::vector<std::uint32_t> origin;
    std::map<std::uint32_t, std::uint32_t> place;
    const auto take = [&](std::uint32_t v) {
      if (const auto known = place.find(v); known != place.end()) return known->second;
      Instruction c = program_.code[v];
      if (c.op == Operation::constant) {
        part.constants.push_back(program_.constants[c.a]);
        c.a = static_cast<std::uint32_t>(part.constants.size() - 1);
      } else {
        part.inputs.push_back({ArgumentKind::parameter, static_cast<std::uint32_t>(part.inputs.size()), ""});
        c = {Operation::input, static_cast<std::uint32_t>(part.inputs.size() - 1), 0};
      }
      part.code.push_back(c);
      origin.push_back(kNoPlace);
      return place.emplace(v, static_cast<std::uint32_t>(part.code.size() - 1)).first->second;
    };
    for (std::uint32_t v = begin; v < end; ++v) {
      Instruction c = program_.code[v];
      if (is_leaf(c.op)) continue;
      if (operand_count(c.op) > 0) c.a = take(c.a);
      if (operand_count(c.op) > 1) c.b = take(c.b);
      place[v] = static_cast<std::uint32_t>(part.code.size());
      part.code.push_back(c);
      origin.push_back(v);
      if (wanted_[v] || wanted_in_loop(v)) part.outputs[0].values.push_back(place[v]);
    }
    part.outputs[0].rows = static_cast<std::uint32_t>(part.outputs[0].values.size());
    Ordering ordering(part, states_);
    ordering.order();
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : ordering.instructions())
      if (origin[i] != kNoPlace) out.push_back(origin[i]);
    return out;
  }

  /// Whether any iteration's value of the same place is wanted elsewhere.
  bool wanted_in_loop(std::uint32_t v) const {
    for (const Loop& loop : program_.loops) {
      if (v < loop.first || v >= loop.first + loop.length) continue;
      for (std::uint32_t k = 0; k < loop.count; ++k)
        if (wanted_[v + k * loop.length]) return true;
    }
    return false;
  }

  Program rearranged() const {
    Program out = program_;
    std::vector<std::uint32_t> place(size_, 0);
    for (std::uint32_t i = 0; i < size_; ++i) place[order_[i]] = i;
    for (std::uint32_t i = 0; i < size_; ++i) {
      Instruction c = program_.code[order_[i]];
      if (operand_count(c.op) > 0) c.a = place[c.a];
      if (operand_count(c.op) > 1) c.b = place[c.b];
      out.code[i] = c;
    }
    const auto move = [&](std::vector<std::uint32_t>& values) {
      for (std::uint32_t& v : values) v = place[v];
    };
    for (OutputArray& output : out.outputs) move(output.values);
    for (DotProducts& products : out.dot_products) {
      move(products.left);
      move(products.right);
    }
    out.loops = loops_;
    return out;
  }

  const Program& program_;
  States states_;
  std::uint32_t size_;
  std::vector<std::uint32_t> segment_;
  std::vector<bool> wanted_;  // by another segment, or as a result
  std::vector<std::uint32_t> order_;
  std::vector<Loop> loops_;
};

}  // namespace

Program order_for_registers(const Program& program, States states) {
  return program.loops.empty() ? Ordering(program, states).order() : LoopOrdering(program, states).order();
}

}  // namespace alembert

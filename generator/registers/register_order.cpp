// Orders statements, see the header.
#include "registers/register_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "program/count.hpp"
#include "program/interpret.hpp"
#include "registers/list_schedule.hpp"
#include "registers/order_search.hpp"
#include "registers/statement_layout.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

// For one state, statements later than the first unwritten one by more are not looked at: the order of the
// whole stays.
constexpr std::uint32_t kLookAhead = 256;

// One register fewer than x86 has, for what is being computed.
constexpr ScheduleWeights kOneState = {15, 200, 100, 128};

// Over packs the best of these is taken, or of the first ones in long programs, so that the time is bounded.
constexpr std::size_t kRegistersTried[] = {12, 16, 14, 10, 8, 20, 13, 11};
constexpr int kMissingTried[] = {100, 200, 30, 400};
constexpr std::size_t kAllStatements = 100'000;

// A division takes as long as some other operations.
constexpr int kDivision = 4;

class Ordering {
 public:
  Ordering(const Program& program, States states)
      : program_(program), states_(states), size_(program.code.size()) {
    collect_statements();
    if (states == States::one) measure_heights();
    result_ = program;
    result_.code.clear();
    result_.constants.clear();
    place_.assign(size_, kNoIndex);
  }

  /// Instructions in their new order.
  const std::vector<std::uint32_t>& instructions() const { return instructions_; }

  Program order() {
    // All angles are known before the first sine.
    for (std::uint32_t s = 0; s < leading_; ++s)
      for (const std::uint32_t v : statements_[s].reads)
        if (is_leaf(program_.code[v].op)) emit(v);
    const std::vector<std::uint32_t> sequence =
        states_ == States::one ? list_schedule(statements_, leading_, left_, kOneState, kLookAhead)
                               : best_of_many();
    for (const std::uint32_t s : sequence)
      for (const std::uint32_t v : statements_[s].members) emit(v);
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
    return {count > 0 ? c.a : kNoIndex, count > 1 ? c.b : kNoIndex};
  }

  void collect_statements() {
    const StatementLayout layout(program_, {size_, size_},
                                 states_ == States::many ? grain_over_packs(program_) : Grain::expressions);
    std::vector<std::uint32_t> statement(size_, kNoIndex);
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!layout.live(v) || !layout.named(v)) continue;
      statement[v] = static_cast<std::uint32_t>(statements_.size());
      statements_.emplace_back();
      if (layout.angle(v) != kNoIndex) leading_ = statement[v] + 1;
    }
    for (std::uint32_t v = 0; v < size_; ++v)
      if (layout.statement(v) != kNoIndex) statement[v] = statement[layout.statement(v)];
    left_.assign(size_, 0);
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (statement[v] == kNoIndex) continue;
      ScheduledStatement& s = statements_[statement[v]];
      s.members.push_back(v);
      for (const std::uint32_t operand : operands(v)) {
        if (operand == kNoIndex || program_.code[operand].op == Operation::constant) continue;
        if (statement[operand] == statement[v] || std::ranges::find(s.reads, operand) != s.reads.end())
          continue;
        s.reads.push_back(operand);
        ++left_[operand];
        if (statement[operand] == kNoIndex) continue;
        statements_[statement[operand]].readers.push_back(statement[v]);
        ++s.before;
      }
    }
  }

  void measure_heights() {
    std::vector<int> height(size_, 0);
    for (std::size_t v = size_; v-- > 0;) {
      height[v] += program_.code[v].op == Operation::div ? kDivision : 1;
      for (const std::uint32_t operand : operands(static_cast<std::uint32_t>(v)))
        if (operand != kNoIndex) height[operand] = std::max(height[operand], height[v]);
    }
    for (ScheduledStatement& s : statements_)
      for (const std::uint32_t v : s.members) s.height = std::max(s.height, height[v]);
  }

  void emit(std::uint32_t v) {
    if (place_[v] != kNoIndex) return;
    for (const std::uint32_t operand : operands(v))
      if (operand != kNoIndex && is_leaf(program_.code[operand].op)) emit(operand);
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

  /// The cheapest of several orders, made cheaper by moving statements behind those of the call for all
  /// angles.
  std::vector<std::uint32_t> best_of_many() const {
    RegisterUses uses;
    for (std::uint32_t v = 0; v < size_; ++v) uses.in_memory.push_back(is_leaf(program_.code[v].op) ? 1 : 0);
    Predecessors predecessors(statements_.size());
    for (std::uint32_t i = 0; i < statements_.size(); ++i) {
      const ScheduledStatement& s = statements_[i];
      const std::uint32_t result = s.members.back();
      if (i < leading_) uses.in_memory[result] = 1;
      uses.add(s.reads, s.readers.empty() ? kNoIndex : result);
      for (const std::uint32_t reader : s.readers) predecessors[reader].push_back(i);
    }
    RegisterFile file(uses);
    std::vector<std::uint32_t> best;
    std::uint64_t cost = RegisterFile::kNoLimit;
    const auto count = static_cast<std::uint32_t>(statements_.size());
    std::size_t written = 0;
    for (const std::size_t registers : kRegistersTried)
      for (const int missing : kMissingTried) {
        if (written > kAllStatements) break;
        written += statements_.size();
        std::vector<std::uint32_t> sequence =
            list_schedule(statements_, leading_, left_, {registers, 200, missing, 0}, count);
        sequence.erase(sequence.begin(), sequence.begin() + leading_);
        const std::uint64_t c = file.cost(sequence, cost);
        if (c >= cost) continue;
        cost = c;
        best = std::move(sequence);
      }
    search_order(uses, predecessors, best);
    std::vector<std::uint32_t> all(leading_);
    std::iota(all.begin(), all.end(), 0U);
    all.insert(all.end(), best.begin(), best.end());
    return all;
  }

  const Program& program_;
  States states_;
  std::size_t size_;
  Program result_;
  std::vector<std::uint32_t> instructions_;
  std::vector<ScheduledStatement> statements_;
  std::uint32_t leading_ = 0;         // statements up to the last of the call for all angles
  std::vector<std::uint32_t> left_;   // of a value: statements that read it
  std::vector<std::uint32_t> place_;  // of an instruction: in the result
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
      origin.push_back(kNoIndex);
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
      if (origin[i] != kNoIndex) out.push_back(origin[i]);
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

void expect_same_values(const Program& verified, const Program& written) {
  std::vector<double> inputs(verified.inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = std::sin(1.0 + static_cast<double>(i));
  std::size_t count = 0;
  for (const OutputArray& output : verified.outputs) count += output.values.size();
  std::vector<double> expected(count), found(count), scratch;
  interpret(verified, inputs, expected, scratch);
  interpret(written, inputs, found, scratch);
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  if (!std::ranges::equal(expected, found, {}, bits, bits))
    throw InternalError(verified.function + ": what is written has other values than what was verified");
}

Program order_for_registers(const Program& program, States states) {
  Program ordered =
      program.loops.empty() ? Ordering(program, states).order() : LoopOrdering(program, states).order();
  expect_same_values(program, ordered);
  return ordered;
}

}  // namespace alembert

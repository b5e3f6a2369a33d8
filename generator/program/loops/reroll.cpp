// Stage `reroll`: repeated steps become iterations of loops. Scheduled program in; the same
// operations out, ordered so that iterations follow each other, with the loops beside them.
//
// First sums and products are put together alike in all steps (align_sums). Values that correspond
// (similar_values.hpp) form rows, one value a step. Steps are numbered by the coordinates that a value
// depends on: by the last one in a sweep outwards, by the first one in a sweep inwards, which start from what
// earlier sweeps have. A loop is what a sweep has in all of a range of steps. The rest, mostly the ends of a
// chain, is straight code before, between and after.
#include "program/loops/reroll.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "program/count.hpp"
#include "program/loops/align_sums.hpp"
#include "program/loops/signs.hpp"
#include "program/loops/similar_values.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

// A loop has so many values a step, or more.
constexpr std::size_t kFewestValues = 16;

// So many ranges of steps are tried for a loop, those first that would be best if all went well.
constexpr std::size_t kLoopTries = 100;

// Sweeps along a chain: forward dynamics has three.
constexpr int kMostSweeps = 6;

// Longer chains are left alone: ranges of steps are compared in pairs.
constexpr int kMostSteps = 2000;

constexpr int kNoStep = -1;
constexpr int kAhead = -1;  // sweep of what is computed before the sines, and of these
constexpr int kNoSweep = -2;

/// Values of a loop: `steps[k][i]` is value i of iteration k.
struct Body {
  std::vector<std::vector<std::uint32_t>> steps;
  std::size_t saved() const { return steps.empty() ? 0 : (steps.size() - 1) * steps[0].size(); }
};

/// Steps `begin`, ..., `end` - 1 as a loop. `saved`: values that the loop removes from the code. `others`:
/// values of these steps that may block it.
struct Range {
  int begin, end;
  std::size_t saved, others;
  auto promise() const { return static_cast<std::ptrdiff_t>(saved) - static_cast<std::ptrdiff_t>(others); }
};

class Rerolling {
 public:
  explicit Rerolling(const Program& program) : program_(program), values_(program), size_(values_.size()) {}

  Program run(Shift shift, std::span<const int> depths) {
    find_ahead();
    map_ = corresponding_values(values_, shift, depths);
    number_steps();
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) find_loops(sweep);
    std::ranges::stable_sort(loops_, std::ranges::greater(), &Body::saved);
    while (!order()) loops_.pop_back();
    if (loops_.empty()) return program_;
    return with_signs(values_, order_, swapped(), bodies());
  }

 private:
  /// Sines and cosines of angles that are known without any, with all that comes before the last of them.
  void find_ahead() {
    sweep_.assign(size_, kNoSweep);
    step_.assign(size_, kNoStep);
    const auto is_sine = [&](std::uint32_t v) {
      return values_.op(v) == Operation::sin || values_.op(v) == Operation::cos;
    };
    std::uint32_t first = 0;
    while (first < size_ && !is_sine(first)) ++first;
    for (std::uint32_t v = 0; v < size_; ++v)
      if (values_.leaf(v) || (first < size_ && (v < first || (is_sine(v) && program_.code[v].a < first))))
        sweep_[v] = kAhead;
  }

  void number_steps() {
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (sweep_[v] != kAhead || !map_.along(v)) continue;
      step_[v] = extreme(v, step_, true);
      const Instruction& c = program_.code[v];
      if (c.op != Operation::input) continue;
      const InputSlot& slot = program_.inputs[c.a];
      if (is_of_coordinate(slot.kind)) step_[v] = static_cast<int>(slot.index / map_.shift.of(slot.kind));
    }
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) number_steps(sweep);
  }

  /// The last or first step of the operands that have one.
  int extreme(std::uint32_t v, const std::vector<int>& steps, bool last) const {
    int found = kNoStep;
    for (const auto& operand : values_.operands(v)) {
      const std::uint32_t x = operand.value;
      const int step = step_[x] != kNoStep ? step_[x] : steps[x];
      if (step == kNoStep || !map_.along(x)) continue;
      if (found == kNoStep || (last ? step > found : step < found)) found = step;
    }
    return found;
  }

  /// Values whose steps go up by one from each to the next, a few times. Others depend on one end of the
  /// chain.
  void number_steps(int sweep) {
    std::vector<int> steps(size_, kNoStep);
    const auto open = [&](std::uint32_t v) { return sweep_[v] == kNoSweep && map_.along(v); };
    for (std::uint32_t v = 0; v < size_; ++v)
      if (sweep_[v] == kNoSweep) steps[v] = extreme(v, steps, sweep % 2 == 0);
    const auto follows = [&](std::uint32_t a, std::uint32_t b) {
      return a != kNoIndex && b != kNoIndex && open(a) && open(b) && steps[a] != kNoStep &&
             steps[b] == steps[a] + 1;
    };
    std::vector<std::uint32_t> run;
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (!open(v) || follows(map_.previous[v], v)) continue;
      run = {v};
      while (follows(run.back(), map_.next[run.back()])) run.push_back(map_.next[run.back()]);
      if (run.size() < kFewestSteps) continue;
      for (const std::uint32_t x : run) {
        sweep_[x] = sweep;
        step_[x] = steps[x];
      }
    }
  }

  /// True if operand i of a value and operand k of the next one are such a pair too, or the same, or
  /// constants.
  bool pair(std::uint32_t a, std::uint32_t b, std::size_t i, std::size_t k) const {
    const std::uint32_t x = values_.operands(a)[i].value, y = values_.operands(b)[k].value;
    return values_.pair(map_.next, x, y);
  }
  bool straight(std::uint32_t a, std::uint32_t b) const {
    return pair(a, b, 0, 0) && (values_.operands(a).size() == 1 || pair(a, b, 1, 1));
  }
  bool crossed(std::uint32_t a, std::uint32_t b) const {
    return values_.commutes(a) && !straight(a, b) && pair(a, b, 0, 1) && pair(a, b, 1, 0);
  }

  /// Values of one sweep in steps `begin`, ..., `end` - 1, the first of which is `first`.
  struct Row {
    std::uint32_t first;
    int begin, end;
  };

  std::vector<Row> rows_of(int sweep) const {
    std::vector<Row> rows;
    const auto joined = [&](std::uint32_t a, std::uint32_t b) {
      return a != kNoIndex && b != kNoIndex && sweep_[a] == sweep && sweep_[b] == sweep &&
             step_[b] == step_[a] + 1 && (straight(a, b) || crossed(a, b));
    };
    for (std::uint32_t v = 0; v < size_; ++v) {
      if (sweep_[v] != sweep || joined(map_.previous[v], v)) continue;
      Row row{v, step_[v], step_[v] + 1};
      for (std::uint32_t x = v; joined(x, map_.next[x]); x = map_.next[x]) ++row.end;
      if (row.end - row.begin >= static_cast<int>(kFewestSteps)) rows.push_back(row);
    }
    return rows;
  }

  void find_loops(int sweep) {
    const std::vector<Row> rows = rows_of(sweep);
    int steps = 0;
    for (const Row& row : rows) steps = std::max(steps, row.end);
    if (steps == 0 || steps > kMostSteps) return;
    // covering[begin][end]: rows that begin there or before and end there or after.
    std::vector<std::vector<std::size_t>> covering(
        static_cast<std::size_t>(steps) + 1, std::vector<std::size_t>(static_cast<std::size_t>(steps) + 1));
    const auto at = [&](int begin, int end) -> std::size_t& {
      return covering[static_cast<std::size_t>(begin)][static_cast<std::size_t>(end)];
    };
    for (const Row& row : rows) ++at(row.begin, row.end);
    for (int begin = 0; begin <= steps; ++begin)
      for (int end = steps; end >= 0; --end) {
        if (begin > 0) at(begin, end) += at(begin - 1, end);
        if (end < steps) at(begin, end) += at(begin, end + 1);
        if (begin > 0 && end < steps) at(begin, end) -= at(begin - 1, end + 1);
      }
    std::vector<int> begins, ends;
    for (const Row& row : rows) {
      begins.push_back(row.begin);
      ends.push_back(row.end);
    }
    for (std::vector<int>* list : {&begins, &ends}) {
      std::ranges::sort(*list);
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    // Rows that end there or before, and that begin before.
    std::vector<std::size_t> ended(covering.size(), 0), begun(covering.size() + 1, 0);
    for (const Row& row : rows) {
      ++ended[static_cast<std::size_t>(row.end)];
      ++begun[static_cast<std::size_t>(row.begin) + 1];
    }
    std::partial_sum(ended.begin(), ended.end(), ended.begin());
    std::partial_sum(begun.begin(), begun.end(), begun.begin());
    std::vector<Range> ranges;
    for (const int begin : begins)
      for (const int end : ends) {
        const std::size_t all = at(begin, end);
        if (end - begin < static_cast<int>(kFewestSteps) || all < kFewestValues) continue;
        const std::size_t touching =
            begun[static_cast<std::size_t>(end)] - ended[static_cast<std::size_t>(begin)];
        const auto steps_saved = static_cast<std::size_t>(end - begin - 1);
        ranges.push_back({begin, end, all * steps_saved, (touching - all) * steps_saved});
      }
    std::ranges::stable_sort(ranges, std::ranges::greater(), &Range::promise);
    while (!ranges.empty()) {
      Body best;
      Range from{};
      std::size_t tries = kLoopTries;
      for (const Range& range : ranges) {
        if (tries-- == 0) break;
        if (range.saved <= best.saved()) continue;
        Body body = body_of(rows, range, sweep % 2 == 0);
        separate(body);
        if (body.steps.size() >= kFewestSteps && body.saved() > best.saved()) {
          best = std::move(body);
          from = range;
        }
      }
      if (best.steps.empty()) return;
      loops_.push_back(std::move(best));
      std::erase_if(ranges,
                    [&](const Range& range) { return range.begin < from.end && from.begin < range.end; });
    }
  }

  Body body_of(const std::vector<Row>& rows, const Range& range, bool outwards) const {
    const int begin = range.begin, end = range.end;
    Body body;
    body.steps.resize(static_cast<std::size_t>(end - begin));
    for (const Row& row : rows) {
      if (row.begin > begin || row.end < end) continue;
      std::uint32_t v = row.first;
      for (int step = row.begin; step < end; ++step, v = map_.next[v])
        if (step >= begin)
          body.steps[static_cast<std::size_t>(outwards ? step - begin : end - 1 - step)].push_back(v);
    }
    // Operands first, as in one of the steps: within a step the others have the same.
    const std::vector<std::uint32_t>& one = body.steps[0];
    std::vector<std::size_t> order(one.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return one[i]; });
    for (std::vector<std::uint32_t>& step : body.steps) {
      std::vector<std::uint32_t> sorted;
      for (const std::size_t i : order) sorted.push_back(step[i]);
      step = std::move(sorted);
    }
    return body;
  }

  /// Keeps the longest range of iterations of which no value needs another value that needs one of them.
  void separate(Body& body) {
    const int count = static_cast<int>(body.steps.size());
    std::vector<int> own(size_, kNoStep), before(size_, kNoStep), after(size_, count);
    for (int k = 0; k < count; ++k)
      for (const std::uint32_t v : body.steps[static_cast<std::size_t>(k)]) own[v] = k;
    // before: the last iteration that a value needs; after: the first one that needs it.
    for (std::uint32_t v = 0; v < size_; ++v) {
      for (const auto& operand : values_.operands(v)) before[v] = std::max(before[v], before[operand.value]);
      before[v] = std::max(before[v], own[v]);
    }
    for (std::uint32_t v = size_; v-- > 0;) {
      if (own[v] != kNoStep) after[v] = own[v];
      for (const auto& operand : values_.operands(v))
        after[operand.value] = std::min(after[operand.value], after[v]);
    }
    // first_end[b]: where a range that begins at b must end.
    std::vector<int> first_end(static_cast<std::size_t>(count) + 1, count);
    for (std::uint32_t v = 0; v < size_; ++v)
      if (own[v] == kNoStep && before[v] != kNoStep && after[v] < count) {
        int& end = first_end[static_cast<std::size_t>(before[v])];
        end = std::min(end, after[v]);
      }
    int begin = 0, end = 0, limit = count;
    for (int b = count; b-- > 0;) {
      limit = std::min(limit, first_end[static_cast<std::size_t>(b)]);
      if (limit - b >= end - begin) {
        begin = b;
        end = limit;
      }
    }
    body.steps.erase(body.steps.begin() + end, body.steps.end());
    body.steps.erase(body.steps.begin(), body.steps.begin() + begin);
  }

  /// order_: all that results need, operands first, iterations of a loop together; what comes ahead of the
  /// sines first. False if loops need each other.
  bool order() {
    enum : std::uint8_t { untouched, open, done };
    std::vector<std::uint32_t> loop(size_, kNoIndex);
    for (std::uint32_t l = 0; l < loops_.size(); ++l)
      for (const auto& step : loops_[l].steps)
        for (const std::uint32_t v : step) loop[v] = l;
    order_.clear();
    first_.assign(loops_.size(), 0);
    // A unit is a value or a whole loop.
    std::vector<std::uint8_t> state(size_ + loops_.size(), untouched);
    const auto unit_of = [&](std::uint32_t v) { return loop[v] == kNoIndex ? v : size_ + loop[v]; };
    struct Visit {
      std::uint32_t unit;
      std::vector<std::uint32_t> needs;
      std::size_t next = 0;
    };
    const auto visit = [&](std::uint32_t unit) {
      Visit out{unit, {}};
      const auto add = [&](std::uint32_t v) {
        for (const auto& operand : values_.operands(v))
          if (const std::uint32_t x = unit_of(operand.value); x != unit && state[x] != done)
            out.needs.push_back(x);
      };
      if (unit < size_) {
        add(unit);
      } else {
        for (const auto& step : loops_[unit - size_].steps)
          for (const std::uint32_t v : step) add(v);
      }
      state[unit] = open;
      return out;
    };
    std::vector<Visit> stack;
    const auto reach = [&](std::uint32_t v) {
      if (state[unit_of(v)] == untouched) stack.push_back(visit(unit_of(v)));
      while (!stack.empty()) {
        Visit& top = stack.back();
        if (top.next < top.needs.size()) {
          const std::uint32_t unit = top.needs[top.next++];
          if (state[unit] == open) return false;
          if (state[unit] == untouched) stack.push_back(visit(unit));
          continue;
        }
        state[top.unit] = done;
        if (top.unit < size_) {
          order_.push_back(top.unit);
        } else {
          first_[top.unit - size_] = order_.size();
          for (const auto& step : loops_[top.unit - size_].steps)
            order_.insert(order_.end(), step.begin(), step.end());
        }
        stack.pop_back();
      }
      return true;
    };
    std::vector<std::uint32_t> results;
    for (const std::uint32_t v : values_.wanted()) results.push_back(values_.plain(v).value);
    const std::vector<bool> needed = needed_by(results);
    for (std::uint32_t v = 0; v < size_; ++v)
      if (sweep_[v] == kAhead && needed[v] && !reach(v)) return false;
    return std::ranges::all_of(results, reach);
  }

  std::vector<bool> needed_by(const std::vector<std::uint32_t>& results) const {
    std::vector<bool> needed(size_, false);
    for (const std::uint32_t v : results) needed[v] = true;
    for (std::uint32_t v = size_; v-- > 0;)
      if (needed[v])
        for (const auto& operand : values_.operands(v)) needed[operand.value] = true;
    return needed;
  }

  /// Values of loops that have their operands in another order than in the first iteration.
  std::vector<bool> swapped() const {
    std::vector<bool> out(size_, false);
    for (const Body& body : loops_)
      for (std::size_t k = 1; k < body.steps.size(); ++k)
        for (std::size_t i = 0; i < body.steps[k].size(); ++i) {
          const std::uint32_t a = body.steps[k - 1][i], b = body.steps[k][i];
          out[b] = out[a] != (map_.next[a] == b ? crossed(a, b) : crossed(b, a));
        }
    return out;
  }

  std::vector<Steps> bodies() const {
    std::vector<Steps> out;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      out.push_back({first_[l], loops_[l].steps[0].size(), loops_[l].steps.size()});
    std::ranges::sort(out, {}, &Steps::first);
    return out;
  }

  const Program& program_;
  UnsignedProgram values_;
  std::uint32_t size_;
  Correspondence map_;
  std::vector<int> sweep_, step_;
  std::vector<Body> loops_;
  std::vector<std::size_t> first_;  // of each loop, in order_
  std::vector<std::uint32_t> order_;
};

}  // namespace

Program reroll(const Program& program) {
  // Which way of telling values apart finds most differs from program to program.
  static constexpr std::array kGoingUp{8, 5, 3, 2, 1};
  static constexpr std::array<std::span<const int>, 4> kWays{kGoingUp, std::span(kGoingUp).subspan(2, 1),
                                                             std::span(kGoingUp).subspan(3, 1),
                                                             std::span(kGoingUp).subspan(4)};
  const UnsignedProgram flat(program, UnsignedProgram::Form::flattened);
  const Shift shift = shift_of_steps(flat, kGoingUp);
  Program best = program;
  for (const std::span<const int> depths : kWays) {
    const Program aligned = align_sums(program, shift, depths);
    if (Program found = Rerolling(aligned).run(shift, depths);
        operations_in_loops(found) > operations_in_loops(best))
      best = std::move(found);
  }
  return best;
}

std::size_t operations_in_loops(const Program& program) {
  std::size_t operations = 0;
  for (const Loop& loop : program.loops)
    for (std::uint32_t i = 0; i < loop.length; ++i) {
      const Operation op = program.code[loop.first + i].op;
      const bool counts = op == Operation::add || op == Operation::sub || op == Operation::mul;
      operations += counts ? loop.count : 0;
    }
  return operations;
}

}  // namespace alembert

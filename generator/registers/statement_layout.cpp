// Lays out statements, see the header.
#include "registers/statement_layout.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>

#include "support/error.hpp"
#include "support/no_index.hpp"

namespace alembert {
namespace {

// Bounds of an expression written in one statement: nesting and number of operations. Deep enough for a
// compiler that contracts a*b + c only inside one expression, small enough to read.
constexpr int kMaxDepth = 12;
constexpr int kMaxOperations = 16;

}  // namespace

StatementLayout::StatementLayout(const Program& program, const BlockSizes& sizes, Grain grain)
    : program_(program), size_(program.code.size()), loop_(loop_numbers(program)) {
  place_tables();
  collect_uses();
  choose_names();
  if (grain == Grain::operations) name_operations();
  collect_statements();
  assign_blocks(sizes);
  collect_angles();
  if (!program.loops.empty()) place_loops();
  assign_crossings();
}

void StatementLayout::place_tables() {
  uses_.assign(size_, 0);
  table_places_.resize(size_);
  const auto next_place = [&] { return static_cast<std::uint32_t>(crossing_); };
  const auto add = [&](std::uint32_t v, std::uint32_t place) {
    table_places_[v].push_back(place);
    ++uses_[v];
    if (loop(v) != nullptr) uses_[in_first(v)] += 2;
    ++crossing_;
  };
  for (const DotProducts& products : program_.dot_products) {
    tables_.push_back({next_place(), 0});
    for (const std::uint32_t v : products.left) add(v, next_place());
    tables_.back().right = next_place();
    const auto rows = static_cast<std::uint32_t>(products.right.size()) / products.terms;
    const std::uint32_t first = next_place();
    for (std::uint32_t i = 0; i < products.right.size(); ++i)
      add(products.right[i], first + i % products.terms * rows + i / products.terms);
  }
}

void StatementLayout::collect_uses() {
  // What loops compute has no statements.
  const std::size_t straight = size_ - program_.dot_product_code;
  results_.resize(size_);
  for (std::uint32_t array = 0; array < program_.outputs.size(); ++array) {
    const auto& values = program_.outputs[array].values;
    for (std::uint32_t k = 0; k < values.size(); ++k) {
      if (values[k] >= straight) continue;
      results_[values[k]].emplace_back(array, k);
      ++uses_[values[k]];
      if (loop(values[k]) != nullptr) uses_[in_first(values[k])] += 2;
    }
  }
  // What crosses the border of an iteration has a name, in each iteration if it has in one.
  const auto use = [&](std::uint32_t v, std::uint32_t operand) {
    const bool crosses = (loop(v) != nullptr || loop(operand) != nullptr) && !same_iteration(v, operand);
    if (!crosses && loop(v) != nullptr && in_first(v) != v) return;
    uses_[operand] += crosses ? 2 : 1;
    if (crosses && loop(operand) != nullptr) uses_[in_first(operand)] += 2;
  };
  for (std::uint32_t v = static_cast<std::uint32_t>(size_); v-- > 0;) {
    const Instruction& instruction = program_.code[v];
    if ((operands(v) > 0 && instruction.a >= v) || (operands(v) > 1 && instruction.b >= v))
      throw InternalError("emit: a value of " + program_.function + " is used before it is computed");
    if (!live(v) && loop(v) == nullptr) continue;
    if (operands(v) > 0) use(v, instruction.a);
    if (operands(v) > 1) use(v, instruction.b);
  }
}

void StatementLayout::choose_names() {
  named_.assign(size_, false);
  std::vector<int> depth(size_, 0), operations(size_, 0);
  for (std::uint32_t v = 0; v < size_; ++v) {
    const Instruction& instruction = program_.code[v];
    if (!live(v) || is_leaf(instruction.op)) continue;
    if (loop(v) != nullptr && in_first(v) != v) {
      named_[v] = true;
      continue;
    }
    depth[v] = 1;
    operations[v] = 1;
    const std::array<std::uint32_t, 2> operand{instruction.a, instruction.b};
    for (int k = 0; k < operands(v); ++k) {
      const std::uint32_t child = operand[static_cast<std::size_t>(k)];
      if (named_[child] || is_leaf(program_.code[child].op)) continue;
      if (operations[v] + operations[child] > kMaxOperations || depth[child] + 1 > kMaxDepth) {
        named_[child] = true;  // too much for one line: the child gets a name after all
        continue;
      }
      depth[v] = std::max(depth[v], depth[child] + 1);
      operations[v] += operations[child];
    }
    named_[v] = uses_[v] > 1 || !results_[v].empty() || !table_places_[v].empty() || is_call(instruction.op);
  }
}

void StatementLayout::name_operations() {
  std::vector<bool> taken_up(size_, false);
  for (std::uint32_t v = 0; v < size_; ++v) {
    const Instruction& c = program_.code[v];
    if (c.op != Operation::add && c.op != Operation::sub) continue;
    for (const std::uint32_t operand : {c.a, c.b}) {
      if (named_[operand] || program_.code[operand].op != Operation::mul) continue;
      taken_up[operand] = true;
      break;
    }
  }
  for (std::uint32_t v = 0; v < size_; ++v) {
    const Operation op = program_.code[v].op;
    if (live(v) && !is_leaf(op) && op != Operation::neg && !taken_up[v]) named_[v] = true;
  }
}

void StatementLayout::collect_statements() {
  statement_.assign(size_, kNoIndex);
  // Users have larger indices.
  for (std::uint32_t v = static_cast<std::uint32_t>(size_); v-- > 0;) {
    if (!live(v) || is_leaf(program_.code[v].op)) continue;
    if (named_[v]) statement_[v] = v;
    const std::array<std::uint32_t, 2> operand{program_.code[v].a, program_.code[v].b};
    for (int k = 0; k < operands(v); ++k) {
      const std::uint32_t child = operand[static_cast<std::size_t>(k)];
      if (!named_[child] && !is_leaf(program_.code[child].op)) statement_[child] = statement_[v];
    }
  }
}

void StatementLayout::assign_blocks(const BlockSizes& sizes) {
  const auto counts = [&](std::uint32_t v) {
    const Operation op = program_.code[v].op;
    return op != Operation::sin && op != Operation::cos;
  };
  block_.assign(size_, kNoIndex);
  number_.assign(size_, kNoIndex);
  blocks_ = 0;
  std::uint32_t number = 0;
  const auto add_straight = [&](std::uint32_t begin, std::uint32_t end) {
    std::size_t statements = 0, before = 0;
    bool any = false;
    for (std::uint32_t v = begin; v < end; ++v) {
      any = any || (live(v) && named_[v]);
      statements += live(v) && named_[v] && counts(v) ? 1 : 0;
    }
    // A function has a block, whatever it is.
    if (!any && (blocks_ > 0 || end < size_)) return;
    const std::size_t count = statements > sizes.longest ? (statements + sizes.size - 1) / sizes.size : 1;
    for (std::uint32_t v = begin; v < end; ++v) {
      if (!live(v) || !named_[v]) continue;
      block_[v] = blocks_ + static_cast<std::uint32_t>(
                                std::min(before * count / std::max<std::size_t>(statements, 1), count - 1));
      number_[v] = number++;
      before += counts(v) ? 1 : 0;
    }
    blocks_ += static_cast<std::uint32_t>(count);
  };
  std::uint32_t begin = 0;
  for (const Loop& loop : program_.loops) {
    add_straight(begin, loop.first);
    begin = loop.first + loop.length * loop.count;
    for (std::uint32_t v = loop.first; v < begin; ++v) {
      block_[v] = blocks_;
      number_[v] = number++;
    }
    ++blocks_;
  }
  add_straight(begin, static_cast<std::uint32_t>(size_));
  // What is written into its user belongs to the user's block.
  for (std::uint32_t v = 0; v < size_; ++v)
    if (statement_[v] != kNoIndex) block_[v] = block_[statement_[v]];
}

void StatementLayout::assign_crossings() {
  std::vector<std::uint32_t> last(size_, 0);  // block of the last use
  for (std::uint32_t v = 0; v < size_; ++v) {
    if (!live(v) || is_leaf(program_.code[v].op) || loop(v) != nullptr) continue;
    const std::array<std::uint32_t, 2> operand{program_.code[v].a, program_.code[v].b};
    for (int k = 0; k < operands(v); ++k) {
      const std::uint32_t child = operand[static_cast<std::size_t>(k)];
      last[child] = std::max(last[child], block_[v]);
    }
  }
  // A place is free again for blocks after that of its last use; the lowest free place is taken.
  place_.assign(size_, kNoIndex);
  std::vector<std::vector<std::uint32_t>> expiring(blocks_ + 1);
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_places;
  std::uint32_t current = 0;
  for (std::uint32_t v = 0; v < size_; ++v) {
    if (!live(v) || !named_[v]) continue;
    for (; current < block_[v]; ++current)
      for (const std::uint32_t place : expiring[current]) free_places.push(place);
    if (loop(v) != nullptr) {
      if (!loops_->places(v).empty()) place_[v] = loops_->places(v).front();
      continue;
    }
    if (last[v] <= block_[v]) continue;
    if (trig_place_ != kNoIndex && angle_[v] != kNoIndex) {
      const bool sine = program_.code[v].op == Operation::sin;
      place_[v] = trig_place_ + angle_[v] + (sine ? 0 : static_cast<std::uint32_t>(angles_.size()));
      continue;
    }
    if (!table_places_[v].empty()) {
      place_[v] = table_places_[v].front();
      continue;
    }
    if (free_places.empty()) free_places.push(static_cast<std::uint32_t>(crossing_++));
    place_[v] = free_places.top();
    free_places.pop();
    expiring[last[v]].push_back(place_[v]);
  }
}

void StatementLayout::collect_angles() {
  angle_.assign(size_, kNoIndex);
  std::uint32_t first = kNoIndex;
  std::vector<std::uint32_t> place(size_, kNoIndex);
  for (std::uint32_t v = 0; v < size_; ++v) {
    const Instruction& c = program_.code[v];
    if (!live(v) || (c.op != Operation::sin && c.op != Operation::cos)) continue;
    if (first == kNoIndex) first = v;
    if (c.a >= first || block_[v] != block_[first]) continue;
    if (place[c.a] == kNoIndex) {
      place[c.a] = static_cast<std::uint32_t>(angles_.size());
      angles_.push_back(c.a);
    }
    angle_[v] = place[c.a];
  }
  if (angles_.size() >= 2)
    trig_call_ = first;
  else
    angle_.assign(size_, kNoIndex);
}

void StatementLayout::place_loops() {
  std::vector<LoopLayout::Fixed> fixed;
  if (trig_call_ != kNoIndex) {
    const auto count = static_cast<std::uint32_t>(angles_.size());
    trig_place_ = static_cast<std::uint32_t>(crossing_);
    for (const Operation op : {Operation::sin, Operation::cos}) {
      std::vector<std::uint32_t> values(count, kNoIndex);
      for (std::uint32_t v = 0; v < size_; ++v)
        if (angle_[v] != kNoIndex && program_.code[v].op == op) values[angle_[v]] = v;
      fixed.push_back({std::move(values), static_cast<std::int64_t>(crossing_), 1});
      crossing_ += count;
    }
  }
  for (std::size_t i = 0; i < program_.dot_products.size(); ++i) {
    const DotProducts& products = program_.dot_products[i];
    const std::size_t terms = products.terms;
    for (const bool left : {true, false}) {
      const std::vector<std::uint32_t>& rows = left ? products.left : products.right;
      for (std::size_t column = 0; column < terms; ++column) {
        std::vector<std::uint32_t> values;
        for (std::size_t k = column; k < rows.size(); k += terms) values.push_back(rows[k]);
        const std::size_t first = left ? tables_[i].left + column : tables_[i].right + column * values.size();
        fixed.push_back({std::move(values), static_cast<std::int64_t>(first),
                         left ? static_cast<std::int64_t>(terms) : 1});
      }
    }
  }
  loops_.emplace(program_, std::move(fixed), crossing_);
  crossing_ = loops_->end();
  for (std::uint32_t v = 0; v < size_; ++v) {
    if (loop(v) != nullptr) {
      table_places_[v].clear();
      if (!loops_->results_late(v)) results_[v].clear();
      continue;
    }
    table_places_[v] = loops_->places(v);
    if (trig_place_ != kNoIndex && angle_[v] != kNoIndex)
      std::erase_if(table_places_[v], [&](std::uint32_t place) {
        return place >= trig_place_ && place < trig_place_ + 2 * angles_.size();
      });
  }
}

}  // namespace alembert

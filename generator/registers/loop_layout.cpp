// Lays out loops, see the header.
#include "registers/loop_layout.hpp"

#include <algorithm>

#include "registers/statement_layout.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

/// The element of each iteration as a linear function, if it is one.
template <class Numbers>
std::optional<Element> linear(const Numbers& numbers) {
  Element element{static_cast<std::int64_t>(numbers[0]), 0};
  if (numbers.size() > 1) element.step = static_cast<std::int64_t>(numbers[1]) - element.first;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (static_cast<std::int64_t>(numbers[k]) != element.first + static_cast<std::int64_t>(k) * element.step)
      return std::nullopt;
  return element;
}

}  // namespace

std::vector<std::uint32_t> loop_numbers(const Program& program) {
  std::vector<std::uint32_t> numbers(program.code.size(), kNoIndex);
  for (std::uint32_t l = 0; l < program.loops.size(); ++l)
    std::fill_n(numbers.begin() + program.loops[l].first, program.loops[l].length * program.loops[l].count,
                l);
  return numbers;
}

LoopLayout::LoopLayout(const Program& program, std::vector<Fixed> fixed, std::size_t first_place)
    : program_(program),
      end_(first_place),
      loop_(loop_numbers(program)),
      bodies_(program.loops.size()),
      where_(program.code.size()),
      places_(program.code.size()),
      results_late_(program.code.size(), false) {
  for (std::uint32_t l = 0; l < program.loops.size(); ++l) {
    bodies_[l].operands.resize(program.loops[l].length);
    bodies_[l].stores.resize(program.loops[l].length);
    bodies_[l].results.resize(program.loops[l].length);
  }
  add_fixed(std::move(fixed));
  find_results();
  add_rows();
  find_operands();
  if (!possible_) return;
  assign_places();
  find_stores();
  check();
}

int LoopLayout::operands(std::uint32_t v) const {
  return operand_count(program_.code[v].op);
}

bool LoopLayout::is_constant(std::uint32_t v) const {
  return program_.code[v].op == Operation::constant;
}

void LoopLayout::add_fixed(std::vector<Fixed> fixed) {
  for (Fixed& values : fixed) {
    const auto track = static_cast<std::uint32_t>(tracks_.size());
    for (std::size_t i = 0; i < values.values.size(); ++i)
      if (values.values[i] != kNoIndex) where_[values.values[i]].push_back({track, static_cast<int>(i)});
    tracks_.push_back({std::move(values.values), 0, values.first, values.step, true});
  }
}

/// Results that are the same elements, or elements at even distances, in all iterations. Straight code writes
/// the others.
void LoopLayout::find_results() {
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> results(program_.code.size());
  for (std::uint32_t array = 0; array < program_.outputs.size(); ++array)
    for (std::uint32_t k = 0; k < program_.outputs[array].values.size(); ++k)
      results[program_.outputs[array].values[k]].emplace_back(array, k);
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l)
    for (std::uint32_t i = 0; i < program_.loops[l].length; ++i) {
      const std::uint32_t count = program_.loops[l].count;
      std::vector<std::pair<std::uint32_t, Element>> found;
      bool even = true;
      for (std::size_t r = 0; r < results[value(l, 0, i)].size() && even; ++r) {
        std::vector<std::uint32_t> elements;
        const std::uint32_t array = results[value(l, 0, i)][r].first;
        for (std::uint32_t k = 0; k < count; ++k) {
          const auto& own = results[value(l, k, i)];
          even &= own.size() == results[value(l, 0, i)].size() && own[r].first == array;
          if (even) elements.push_back(own[r].second);
        }
        const std::optional<Element> element = even ? linear(elements) : std::nullopt;
        even &= element.has_value();
        if (even) found.emplace_back(array, *element);
      }
      if (results[value(l, 0, i)].empty()) even = false;
      if (even) bodies_[l].results[i] = std::move(found);
      for (std::uint32_t k = 0; k < count && !even; ++k)
        results_late_[value(l, k, i)] = !results[value(l, k, i)].empty();
    }
}

/// A track for each value of an iteration that is read elsewhere and not in a fixed track as a whole.
void LoopLayout::add_rows() {
  std::vector<bool> read(results_late_);
  for (std::uint32_t v = 0; v < program_.code.size(); ++v)
    for (int k = 0; k < operands(v); ++k) {
      const std::uint32_t x = operand(v, static_cast<std::size_t>(k));
      if (loop_[x] != kNoIndex && (loop_[v] != loop_[x] || iteration(v) != iteration(x))) read[x] = true;
    }
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l)
    for (std::uint32_t i = 0; i < program_.loops[l].length; ++i) {
      std::vector<std::uint32_t> row;
      bool is_read = false;
      for (std::uint32_t k = 0; k < program_.loops[l].count; ++k) {
        row.push_back(value(l, k, i));
        is_read = is_read || read[row.back()] || !where_[row.back()].empty();
      }
      int direction = 1;
      if (is_read && !find_track(row, direction)) possible_ = false;
    }
}

void LoopLayout::find_operands() {
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l)
    for (std::uint32_t i = 0; i < program_.loops[l].length; ++i)
      for (int k = 0; k < operands(value(l, 0, i)); ++k)
        bodies_[l].operands[i][static_cast<std::size_t>(k)] = operand_of(l, i, static_cast<std::size_t>(k));
  // The tables are complete: a row for each iteration.
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l) {
    LoopBody& body = bodies_[l];
    std::vector<double> rows;
    const std::uint32_t count = program_.loops[l].count;
    for (std::uint32_t k = 0; k < count; ++k)
      for (std::uint32_t c = 0; c < body.columns; ++c) rows.push_back(body.constants[c * count + k]);
    body.constants = std::move(rows);
  }
}

LoopOperand LoopLayout::operand_of(std::uint32_t loop, std::uint32_t i, std::size_t k) {
  const Loop& l = program_.loops[loop];
  const std::uint32_t first = operand(value(loop, 0, i), k);
  LoopOperand out;
  if (loop_[first] == loop && iteration(first) == 0) {
    out.index = first - l.first;
    return out;
  }
  std::vector<std::uint32_t> values;
  for (std::uint32_t n = 0; n < l.count; ++n) values.push_back(operand(value(loop, n, i), k));
  if (std::ranges::all_of(values, [&](std::uint32_t v) { return is_constant(v); })) {
    const bool same = std::ranges::all_of(values, [&](std::uint32_t v) { return v == first; });
    LoopBody& body = bodies_[loop];
    out.kind = same ? LoopOperand::Kind::literal : LoopOperand::Kind::constant;
    out.index = same ? first : body.columns++;
    for (const std::uint32_t v : values)
      if (!same) body.constants.push_back(constant(v));
    return out;
  }
  if (const std::optional<LoopOperand> input = input_of(values)) return *input;
  int direction = 1;
  const std::optional<Position> found = find_track(values, direction);
  out.kind = LoopOperand::Kind::memory;
  if (!found) {
    possible_ = false;
    return out;
  }
  out.index = found->track;  // until places are known
  out.element = {found->position, direction};
  return out;
}

std::optional<LoopOperand> LoopLayout::input_of(const std::vector<std::uint32_t>& values) const {
  std::vector<std::uint32_t> elements;
  LoopOperand out;
  out.kind = LoopOperand::Kind::input;
  for (const std::uint32_t v : values) {
    if (program_.code[v].op != Operation::input) return std::nullopt;
    const InputSlot& slot = program_.inputs[program_.code[v].a];
    if (!elements.empty() && slot.kind != out.array) return std::nullopt;
    out.array = slot.kind;
    elements.push_back(slot.index);
  }
  const std::optional<Element> element = linear(elements);
  if (!element) return std::nullopt;
  out.element = *element;
  return out;
}

std::uint32_t LoopLayout::at(const Track& track, int position) const {
  const int i = position - track.low;
  return i < 0 || i >= static_cast<int>(track.values.size()) ? kNoIndex
                                                             : track.values[static_cast<std::size_t>(i)];
}

void LoopLayout::set(std::uint32_t number, int position, std::uint32_t v) {
  Track& track = tracks_[number];
  if (track.values.empty()) track.low = position;
  while (position < track.low) {
    track.values.insert(track.values.begin(), kNoIndex);
    --track.low;
  }
  const auto i = static_cast<std::size_t>(position - track.low);
  if (i >= track.values.size()) track.values.resize(i + 1, kNoIndex);
  track.values[i] = v;
  where_[v].push_back({number, position});
}

/// A track that has the values one after the other, forwards or backwards, or can take them; a new one if
/// there is none. Repeated values need one place.
std::optional<LoopLayout::Position> LoopLayout::find_track(const std::vector<std::uint32_t>& values,
                                                           int& direction) {
  std::vector<std::uint32_t> wanted = values;
  const bool same = std::ranges::all_of(values, [&](std::uint32_t v) { return v == values[0]; });
  if (same) wanted.resize(1);
  for (const bool more_stores : {false, true})
    for (std::size_t k = 0; k < wanted.size(); ++k)
      for (std::size_t n = 0; n < where_[wanted[k]].size(); ++n) {
        const Position there = where_[wanted[k]][n];
        for (const int d : {1, -1}) {
          const int start = there.position - d * static_cast<int>(k);
          if (!arrange(there.track, start, d, wanted, more_stores)) continue;
          direction = same ? 0 : d;
          return Position{there.track, start};
        }
      }
  tracks_.emplace_back();
  const auto number = static_cast<std::uint32_t>(tracks_.size() - 1);
  direction = same ? 0 : 1;
  return arrange(number, 0, 1, wanted, true) ? std::optional(Position{number, 0}) : std::nullopt;
}

bool LoopLayout::add(Additions& additions, const Track& track, int position, std::uint32_t v) const {
  const std::uint32_t there = at(track, position);
  if (there == v) return true;
  if (there != kNoIndex || track.fixed) return false;
  return additions.emplace(position, v).first->second == v;
}

/// How the row of a loop that values[k] is of lies in a track with the values in the direction: one iteration
/// is so many positions on.
int LoopLayout::direction_of_row(const std::vector<std::uint32_t>& values, std::size_t k,
                                 int direction) const {
  const std::uint32_t v = values[k], loop = loop_[v];
  const Loop& l = program_.loops[loop];
  const auto from = [&](std::size_t other) -> int {
    const std::uint32_t x = values[other];
    if (loop_[x] != loop || x == v || (x > v ? x - v : v - x) % l.length != 0) return 0;
    return (x > v) == (other > k) ? direction : -direction;
  };
  if (k + 1 < values.size() && from(k + 1) != 0) return from(k + 1);
  if (k > 0 && from(k - 1) != 0) return from(k - 1);
  // Alone: the rest of the row goes away from the other values.
  const bool last = iteration(v) + 1 == l.count;
  return (k == 0) == last ? direction : -direction;
}

/// Whether a loop leaves value v at a position of a track: its row lies there as a whole. Only fixed tracks
/// have parts of rows; straight code fills those, after all loops.
bool LoopLayout::is_left_at(const Track& track, int position, std::uint32_t v) const {
  if (loop_[v] == kNoIndex || !track.fixed) return true;
  const Loop& l = program_.loops[loop_[v]];
  const auto own = static_cast<int>(iteration(v));
  for (const int d : {1, -1}) {
    bool whole = true;
    for (int n = 0; n < static_cast<int>(l.count) && whole; ++n)
      whole = at(track, position + d * (n - own)) ==
              value(loop_[v], static_cast<std::uint32_t>(n), (v - l.first) % l.length);
    if (whole) return true;
  }
  return false;
}

bool LoopLayout::arrange(std::uint32_t number, int position, int direction,
                         const std::vector<std::uint32_t>& values, bool more_stores) {
  const Track& track = tracks_[number];
  Additions additions;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const int here = position + direction * static_cast<int>(k);
    const std::uint32_t v = values[k];
    if (at(track, here) == v) {
      if (!is_left_at(track, here, v)) return false;
      continue;
    }
    if (!more_stores && loop_[v] != kNoIndex) return false;
    if (!add(additions, track, here, v)) return false;
    if (loop_[v] == kNoIndex) continue;
    // A loop leaves a value in all iterations or in none.
    const int step = direction_of_row(values, k, direction);
    const auto own = static_cast<int>(iteration(v));
    const Loop& l = program_.loops[loop_[v]];
    for (int n = 0; n < static_cast<int>(l.count); ++n)
      if (!add(additions, track, here + step * (n - own),
               value(loop_[v], static_cast<std::uint32_t>(n), (v - l.first) % l.length)))
        return false;
  }
  for (const auto& [there, v] : additions) set(number, there, v);
  return true;
}

std::int64_t LoopLayout::place(const Position& position) const {
  const Track& track = tracks_[position.track];
  return track.first + track.step * position.position;
}

/// What the iteration before has computed need not come from memory, which takes longer than an operation.
void LoopLayout::find_carried() {
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l)
    for (std::uint32_t i = 0; i < program_.loops[l].length; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        LoopOperand& o = bodies_[l].operands[i][k];
        if (o.kind != LoopOperand::Kind::memory) continue;
        const std::uint32_t second = operand(value(l, 1, i), k);
        if (loop_[second] != l || iteration(second) != 0) continue;
        o.kind = LoopOperand::Kind::carried;
        o.index = second - program_.loops[l].first;
      }
}

void LoopLayout::assign_places() {
  for (Track& track : tracks_) {
    if (track.fixed) continue;
    track.first = static_cast<std::int64_t>(end_) - track.low;
    end_ += track.values.size();
  }
  for (LoopBody& body : bodies_)
    for (auto& pair : body.operands)
      for (LoopOperand& o : pair)
        if (o.kind == LoopOperand::Kind::memory) {
          const Track& track = tracks_[o.index];
          o.element = {track.first + track.step * o.element.first, track.step * o.element.step};
        }
  find_carried();
  for (std::uint32_t v = 0; v < where_.size(); ++v)
    for (const Position& position : where_[v])
      places_[v].push_back(static_cast<std::uint32_t>(place(position)));
}

/// Each iteration leaves a value in every track that has all of its row. Straight code copies the others.
void LoopLayout::find_stores() {
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l)
    for (std::uint32_t i = 0; i < program_.loops[l].length; ++i) {
      const Loop& loop = program_.loops[l];
      std::vector<std::uint32_t> stored;
      for (const std::uint32_t start : places_[value(l, 0, i)])
        for (const std::uint32_t next : places_[value(l, 1, i)]) {
          const Element element{start, static_cast<std::int64_t>(next) - start};
          bool all = true;
          for (std::uint32_t k = 2; k < loop.count && all; ++k)
            all = std::ranges::count(places_[value(l, k, i)],
                                     static_cast<std::uint32_t>(element.first + k * element.step)) > 0;
          if (!all) continue;
          bodies_[l].stores[i].push_back(element);
          for (std::uint32_t k = 0; k < loop.count; ++k)
            stored.push_back(static_cast<std::uint32_t>(element.first + k * element.step));
        }
      for (std::uint32_t k = 0; k < loop.count; ++k) {
        std::vector<std::uint32_t>& places = places_[value(l, k, i)];
        for (const std::uint32_t place : places)
          if (std::ranges::count(stored, place) == 0) late_.emplace_back(value(l, k, i), place);
        std::erase_if(places, [&](std::uint32_t place) { return std::ranges::count(stored, place) == 0; });
      }
    }
}

/// Goes through the loops as the code will, and looks whether they find what they are to find.
void LoopLayout::check() const {
  std::vector<std::uint32_t> held(end_, kNoIndex);  // the value in each element of w
  const auto leave = [&](std::uint32_t v) {
    for (const std::uint32_t place : places_[v]) held[place] = v;
  };
  for (std::uint32_t v = 0; v < program_.code.size(); ++v)
    if (is_leaf(program_.code[v].op)) leave(v);
  std::uint32_t begin = 0;
  for (std::uint32_t l = 0; l < program_.loops.size(); ++l) {
    const Loop& loop = program_.loops[l];
    for (; begin < loop.first; ++begin) leave(begin);
    begin += loop.length * loop.count;
    for (std::uint32_t n = 0; n < loop.count; ++n)
      for (std::uint32_t i = 0; i < loop.length; ++i) {
        const std::uint32_t v = value(l, n, i);
        for (int k = 0; k < operands(v); ++k) {
          const LoopOperand& o = bodies_[l].operands[i][static_cast<std::size_t>(k)];
          const std::uint32_t wanted = operand(v, static_cast<std::size_t>(k));
          bool found = true;  // what is no value of w is compared where it is found
          if (o.kind == LoopOperand::Kind::inside) found = value(l, n, o.index) == wanted;
          if (o.kind == LoopOperand::Kind::carried && n > 0) found = value(l, n - 1, o.index) == wanted;
          if (o.kind == LoopOperand::Kind::memory || (o.kind == LoopOperand::Kind::carried && n == 0))
            found = held[static_cast<std::size_t>(o.element.first + o.element.step * n)] == wanted;
          if (!found) throw InternalError("a loop does not find a value that it needs");
        }
        for (const Element& e : bodies_[l].stores[i])
          held[static_cast<std::size_t>(e.first + e.step * n)] = v;
      }
  }
}

}  // namespace alembert

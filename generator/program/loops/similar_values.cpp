// Finds values that correspond to each other, see the header.
//
// Correspondence grows from the inputs and the rows of dot products: from a pair to the only pair of like
// users, and to the operands, until nothing more follows. What is ambiguous waits until one of the
// possibilities is known.
#include "program/loops/similar_values.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

// Coordinates of a step.
constexpr std::uint32_t kLongestShift = 8;

// Of a sum in a flattened sum, and likewise of products: what is longer stays a value of its own.
constexpr std::size_t kMostOperands = 24;

std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

using Classes = std::vector<std::uint64_t>;

/// Values are of one class if they come about by the same operations so many levels deep, whatever the signs,
/// constants and elements of inputs are.
Classes classes_of(const UnsignedProgram& program, int depth) {
  Classes own(program.size());
  for (std::uint32_t v = 0; v < program.size(); ++v) {
    const Instruction& c = program.program().code[v];
    const auto kind =
        c.op == Operation::input ? static_cast<std::uint64_t>(program.program().inputs[c.a].kind) + 1 : 0;
    own[v] = mixed(static_cast<std::uint64_t>(program.op(v)) + 64 * kind + 1);
  }
  Classes current = own, next = own;
  for (int level = 0; level < depth; ++level) {
    for (std::uint32_t v = 0; v < program.size(); ++v) {
      std::uint64_t sum = 0, weight = 1;
      for (const auto& operand : program.operands(v)) {
        sum += weight * mixed(current[operand.value]);
        if (!program.commutes(v)) weight += 2;
      }
      if (!program.operands(v).empty()) next[v] = mixed(own[v] ^ sum);
    }
    current = next;
  }
  return current;
}

using Users = std::vector<std::vector<std::uint32_t>>;

/// Values by class, and the users of each in the order of their classes: those of one class are found without a look at
/// the others, of which a sine may have hundreds.
struct Level {
  Classes classes;
  Users users;

  std::span<const std::uint32_t> users_of_class(std::uint32_t v, std::uint64_t wanted) const {
    const auto of_class = [&](std::uint32_t user) { return classes[user]; };
    return {std::ranges::lower_bound(users[v], wanted, {}, of_class),
            std::ranges::upper_bound(users[v], wanted, {}, of_class)};
  }
};

class Growth {
 public:
  Growth(const UnsignedProgram& program, const Users& users, Shift shift) : program_(program), users_(users) {
    map_.shift = shift;
    map_.next.assign(program.size(), kNoIndex);
    map_.previous.assign(program.size(), kNoIndex);
  }

  void grow(const Level& level) {
    level_ = &level;
    start();
    ambiguous_.clear();
    for (std::uint32_t v = 0; v < program_.size(); ++v)
      if (map_.next[v] != kNoIndex) ambiguous_.emplace_back(v, map_.next[v]);
    for (std::size_t known = kNoIndex; known != map_.size;) {
      known = map_.size;
      for (const auto& [a, b] : std::exchange(ambiguous_, {})) follow(a, b);
      while (!queue_.empty()) {
        const auto [a, b] = queue_.front();
        queue_.pop_front();
        follow(a, b);
      }
    }
  }

  Correspondence found() { return std::move(map_); }

 private:
  using Operand = UnsignedProgram::Operand;

  const InputSlot* input(std::uint32_t v) const {
    const Instruction& c = program_.program().code[v];
    return c.op == Operation::input ? &program_.program().inputs[c.a] : nullptr;
  }

  void start() {
    std::map<std::pair<ArgumentKind, std::uint32_t>, std::uint32_t> at;
    for (std::uint32_t v = 0; v < program_.size(); ++v)
      if (const InputSlot* slot = input(v); slot != nullptr && is_of_coordinate(slot->kind))
        at.emplace(std::pair(slot->kind, slot->index), v);
    for (const auto& [element, v] : at)
      if (const auto other = at.find({element.first, element.second + map_.shift.of(element.first)});
          other != at.end())
        propose(v, other->second);
    for (const DotProducts& products : program_.program().dot_products) start_at(products);
  }

  /// The rows of dot products, by the row and column of the result that they stand for, tell apart what is
  /// used alike, such as the axes of a frame. An array that has not a row for each speed, as Jacobians have
  /// six for each body, has as many more a step.
  void start_at(const DotProducts& products) {
    const OutputArray& output = program_.program().outputs[products.output];
    const std::uint32_t columns = output.columns, shift = map_.shift.speeds;
    const std::uint32_t rows_in_step = shift * output.rows / columns;
    if (rows_in_step == 0 || rows_in_step * columns != shift * output.rows) return;
    // Which row of a step, and where along the other side.
    using Place = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Place, std::uint32_t> left, right;
    for (const DotProducts::Run& run : products.runs) {
      const std::uint32_t row = run.first / columns, of_step = row % rows_in_step;
      left.emplace(Place(of_step, row), run.left);
      for (std::uint32_t i = 0; i < run.count; ++i)
        right.emplace(Place(of_step, (run.first + i * run.stride) % columns), run.right + i);
    }
    const auto pair_rows = [&](const std::map<Place, std::uint32_t>& at,
                               const std::vector<std::uint32_t>& values, std::uint32_t step) {
      for (const auto& [place, row] : at)
        if (const auto other = at.find({place.first, place.second + step}); other != at.end())
          for (std::uint32_t k = 0; k < products.terms; ++k)
            propose(program_.plain(values[row * products.terms + k]).value,
                    program_.plain(values[other->second * products.terms + k]).value);
    };
    pair_rows(left, products.left, rows_in_step);
    pair_rows(right, products.right, shift);
  }

  bool possible(std::uint32_t a, std::uint32_t b) const {
    if (map_.next[a] == b) return true;
    if (a == b || level_->classes[a] != level_->classes[b] || program_.constant(a)) return false;
    if (map_.next[a] != kNoIndex || map_.previous[b] != kNoIndex) return false;
    const InputSlot *from = input(a), *to = input(b);
    if (from == nullptr) return true;
    return from->kind == to->kind && from->kind != ArgumentKind::time &&
           (!is_of_coordinate(from->kind) || from->index + map_.shift.of(from->kind) == to->index);
  }

  void propose(std::uint32_t a, std::uint32_t b) {
    if (map_.next[a] == b || !possible(a, b)) return;
    map_.next[a] = b;
    map_.previous[b] = a;
    ++map_.size;
    queue_.emplace_back(a, b);
  }

  void follow(std::uint32_t a, std::uint32_t b) {
    bool done = follow_operands(a, b);
    done &= follow_users(a, b);
    if (!done) ambiguous_.emplace_back(a, b);
  }

  /// How much speaks for two operands being a pair: known, reached over one operand of theirs, or possible;
  /// none if they are not.
  std::optional<int> evidence(std::uint32_t a, std::uint32_t b) const {
    if (program_.constant(a) || program_.constant(b))
      return program_.constant(a) && program_.constant(b) ? std::optional(0) : std::nullopt;
    if (map_.next[a] == b) return 2;
    if (a == b) return 0;
    if (!possible(a, b)) return std::nullopt;
    for (const Operand& x : program_.operands(a))
      for (const Operand& y : program_.operands(b))
        if (map_.next[x.value] == y.value) return 1;
    return 0;
  }

  /// True if nothing more can follow.
  bool follow_operands(std::uint32_t a, std::uint32_t b) {
    const auto given = program_.operands(a), other = program_.operands(b);
    if (given.size() != other.size()) return true;
    if (!program_.commutes(a)) {
      for (std::size_t k = 0; k < given.size(); ++k) propose(given[k].value, other[k].value);
      return true;
    }
    std::vector<std::uint32_t> from = values_of(given), to = values_of(other);
    std::erase_if(from, [&](std::uint32_t x) {
      const auto known = std::ranges::find_if(to, [&](std::uint32_t y) {
        return map_.next[x] == y || (program_.constant(x) && program_.constant(y));
      });
      if (known == to.end()) return false;
      to.erase(known);
      return true;
    });
    // An operand that stands twice, as in x + x, is one candidate.
    for (std::vector<std::uint32_t>* values : {&from, &to}) {
      std::ranges::sort(*values);
      values->erase(std::unique(values->begin(), values->end()), values->end());
    }
    if (from.size() != to.size()) return true;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    while (!from.empty()) {
      Candidates right(from.size()), left(to.size()), better_right(from.size()), better_left(to.size());
      for (std::size_t i = 0; i < from.size(); ++i)
        for (std::size_t k = 0; k < to.size(); ++k) {
          const std::optional<int> found = evidence(from[i], to[k]);
          if (!found) continue;
          right[i].push_back(k);
          left[k].push_back(i);
          if (*found == 0) continue;
          better_right[i].push_back(k);
          better_left[k].push_back(i);
        }
      const auto none = [](const auto& candidates) { return candidates.empty(); };
      if (std::ranges::any_of(right, none) || std::ranges::any_of(left, none)) return true;
      auto pair = certain_pair(right, left);
      if (!pair) pair = certain_pair(better_right, better_left);
      if (!pair) break;
      pairs.emplace_back(from[pair->first], to[pair->second]);
      from.erase(from.begin() + static_cast<std::ptrdiff_t>(pair->first));
      to.erase(to.begin() + static_cast<std::ptrdiff_t>(pair->second));
    }
    for (const auto& [x, y] : pairs) propose(x, y);
    return from.empty();
  }

  using Candidates = std::vector<std::vector<std::size_t>>;

  static std::vector<std::uint32_t> values_of(std::span<const Operand> operands) {
    std::vector<std::uint32_t> out;
    for (const Operand& o : operands) out.push_back(o.value);
    return out;
  }

  /// Two of which one has no other candidate, nor is the only one of a third.
  static std::optional<std::pair<std::size_t, std::size_t>> certain_pair(const Candidates& right,
                                                                         const Candidates& left) {
    const auto sole = [](const Candidates& one, const Candidates& other, std::size_t i) {
      return one[i].size() == 1 && std::ranges::none_of(other[one[i][0]], [&](std::size_t rival) {
               return rival != i && one[rival].size() == 1;
             });
    };
    for (std::size_t i = 0; i < right.size(); ++i)
      if (sole(right, left, i)) return std::pair(i, right[i][0]);
    for (std::size_t k = 0; k < left.size(); ++k)
      if (sole(left, right, k)) return std::pair(left[k][0], k);
    return std::nullopt;
  }

  bool follow_users(std::uint32_t a, std::uint32_t b) {
    bool done = true;
    for (const std::uint32_t user : users_[a]) {
      if (map_.next[user] != kNoIndex) continue;
      const auto of_a = level_->users_of_class(a, level_->classes[user]);
      const auto of_b = level_->users_of_class(b, level_->classes[user]);
      if (of_a.size() == 1 && of_b.size() == 1) {
        propose(user, of_b[0]);
        continue;
      }
      // All operands known: the only user that has what corresponds to them. A sum and a difference of the
      // same two values are told apart by what they are used for.
      const bool known = std::ranges::all_of(
          program_.operands(user), [&](const Operand& x) { return map_.next[x.value] != kNoIndex; });
      const auto match = !known ? kNoIndex : only(of_b, [&](std::uint32_t other) {
        return map_.previous[other] == kNoIndex && operands_known(user, other);
      });
      const bool alone =
          match != kNoIndex && only(of_a, [&](std::uint32_t other) {
                                 return map_.next[other] == kNoIndex && operands_known(other, match);
                               }) == user;
      if (alone) propose(user, match);
      done &= alone || of_b.empty();
    }
    return done;
  }

  /// The only one of which the condition holds, or kNoIndex.
  template <class Condition>
  static std::uint32_t only(std::span<const std::uint32_t> values, const Condition& condition) {
    std::uint32_t found = kNoIndex;
    for (const std::uint32_t v : values)
      if (condition(v)) {
        if (found != kNoIndex) return kNoIndex;
        found = v;
      }
    return found;
  }

  bool operands_known(std::uint32_t a, std::uint32_t b) {
    const auto from = program_.operands(a), to = program_.operands(b);
    if (from.size() != to.size()) return false;
    taken_.assign(to.size(), false);
    for (std::size_t i = 0; i < from.size(); ++i) {
      bool known = false;
      for (std::size_t k = 0; k < to.size() && !known; ++k) {
        if (taken_[k] || (k != i && !program_.commutes(a)) || map_.next[from[i].value] != to[k].value)
          continue;
        taken_[k] = known = true;
      }
      if (!known) return false;
    }
    return true;
  }

  const UnsignedProgram& program_;
  const Level* level_ = nullptr;
  const Users& users_;
  Correspondence map_;
  std::vector<char> taken_;  // of operands_known(), which is asked too often to take memory
  std::deque<std::pair<std::uint32_t, std::uint32_t>> queue_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ambiguous_;
};

Users users_of(const UnsignedProgram& program) {
  Users users(program.size());
  for (std::uint32_t v = 0; v < program.size(); ++v)
    for (const auto& operand : program.operands(v))
      if (users[operand.value].empty() || users[operand.value].back() != v) users[operand.value].push_back(v);
  return users;
}

std::vector<Level> levels_of(const UnsignedProgram& program, const Users& users,
                             std::span<const int> depths) {
  std::vector<Level> levels;
  for (const int depth : depths) {
    Level level{classes_of(program, depth), users};
    for (std::vector<std::uint32_t>& all : level.users)
      std::ranges::stable_sort(all, {}, [&](std::uint32_t user) { return level.classes[user]; });
    levels.push_back(std::move(level));
  }
  return levels;
}

/// Numbers of coordinates and speeds, as far as arguments and results tell.
std::pair<std::uint32_t, std::uint32_t> dimensions(const Program& program) {
  std::uint32_t coordinates = 0, speeds = 0;
  for (const InputSlot& slot : program.inputs)
    if (is_of_coordinate(slot.kind)) {
      std::uint32_t& number = slot.kind == ArgumentKind::q ? coordinates : speeds;
      number = std::max(number, slot.index + 1);
    }
  for (const OutputArray& output : program.outputs) speeds = std::max(speeds, output.columns);
  return {coordinates, speeds};
}

/// Values that correspond to others with all that they are computed from.
std::size_t whole_pairs(const UnsignedProgram& program, const Correspondence& map) {
  const auto whole = [&](std::uint32_t a, std::uint32_t b) {
    return std::ranges::all_of(program.operands(a), [&](const auto& x) {
      return std::ranges::any_of(program.operands(b),
                                 [&](const auto& y) { return program.pair(map.next, x.value, y.value); });
    });
  };
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < program.size(); ++v)
    count += !program.leaf(v) && map.next[v] != kNoIndex && whole(v, map.next[v]) ? 1 : 0;
  return count;
}

Correspondence grown(const UnsignedProgram& program, const Users& users, Shift shift,
                     const std::vector<Level>& levels) {
  Growth growth(program, users, shift);
  for (const Level& level : levels) growth.grow(level);
  return growth.found();
}

}  // namespace

UnsignedProgram::UnsignedProgram(const Program& program, Form form) : program_(program) {
  plain_.resize(size());
  operands_.resize(size());
  absorbed_.assign(size(), false);
  for (std::uint32_t v = 0; v < size(); ++v) {
    const Instruction& c = program.code[v];
    if (c.op == Operation::neg) {
      plain_[v] = {plain_[c.a].value, !plain_[c.a].negative};
      continue;
    }
    plain_[v] = {v, false};
    if (operand_count(c.op) > 0) operands_[v].push_back(plain_[c.a]);
    if (operand_count(c.op) > 1) operands_[v].push_back(plain_[c.b]);
    if (c.op == Operation::sub) operands_[v][1].negative = !operands_[v][1].negative;
  }
  if (form == Form::flattened) flatten();
}

void UnsignedProgram::flatten() {
  std::vector<std::uint32_t> uses(size(), 0);
  for (std::uint32_t v = 0; v < size(); ++v)
    for (const Operand& o : operands_[v]) ++uses[o.value];
  for (const std::uint32_t v : wanted()) ++uses[plain_[v].value];
  for (std::uint32_t v = 0; v < size(); ++v) {
    if (!commutes(v)) continue;
    std::vector<Operand> all;
    for (const Operand& o : operands_[v]) {
      const std::vector<Operand>& inner = operands_[o.value];
      if (uses[o.value] != 1 || op(o.value) != op(v) || inner.size() > kMostOperands) {
        all.push_back(o);
        continue;
      }
      absorbed_[o.value] = true;
      const std::size_t first = all.size();
      all.insert(all.end(), inner.begin(), inner.end());
      const std::size_t turned = !o.negative ? first : op(v) == Operation::mul ? first + 1 : all.size();
      for (std::size_t k = first; k < turned; ++k) all[k].negative = !all[k].negative;
    }
    operands_[v] = std::move(all);
  }
  for (std::uint32_t v = 0; v < size(); ++v)
    if (absorbed_[v]) operands_[v].clear();
}

std::vector<std::uint32_t> UnsignedProgram::wanted() const {
  std::vector<std::uint32_t> out;
  for (const OutputArray& output : program_.outputs)
    for (const std::uint32_t v : output.values)
      if (v < size()) out.push_back(v);
  for (const DotProducts& products : program_.dot_products)
    for (const std::vector<std::uint32_t>* rows : {&products.left, &products.right})
      out.insert(out.end(), rows->begin(), rows->end());
  return out;
}

Correspondence corresponding_values(const UnsignedProgram& program, Shift shift,
                                    std::span<const int> depths) {
  const Users users = users_of(program);
  return grown(program, users, shift, levels_of(program, users, depths));
}

Shift shift_of_steps(const UnsignedProgram& program, std::span<const int> depths) {
  const Users users = users_of(program);
  const std::vector<Level> levels = levels_of(program, users, depths);
  const auto [coordinates, speeds] = dimensions(program.program());
  Shift best;
  std::size_t size = 0;
  const auto attempt = [&](Shift shift) {
    const std::size_t found = whole_pairs(program, grown(program, users, shift, levels));
    if (found > size) best = shift;
    size = std::max(size, found);
  };
  for (std::uint32_t shift = 1; shift <= kLongestShift; ++shift) {
    attempt({shift, shift});
    // As many coordinates for so many speeds as on average.
    const std::uint32_t share = (shift * coordinates + speeds / 2) / std::max(speeds, 1u);
    if (share > shift) attempt({share, shift});
  }
  return best;
}

}  // namespace alembert

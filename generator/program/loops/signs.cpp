// Chooses signs, see the header.
#include "program/loops/signs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

/// Signs of values, related by linear equations modulo 2, which are brought into echelon form as they come.
class SignEquations {
 public:
  explicit SignEquations(std::size_t size) : unknown_(size, kNoIndex) {}

  /// The sum of the signs of these values is `odd`. What contradicts earlier equations is left out.
  void add(const std::vector<std::uint32_t>& values, bool odd) {
    std::vector<std::uint32_t> sum;
    for (const std::uint32_t v : values) sum.push_back(unknown(v));
    std::ranges::sort(sum);
    for (std::size_t i = 0; i + 1 < sum.size();) {
      if (sum[i] == sum[i + 1])
        sum.erase(sum.begin() + static_cast<std::ptrdiff_t>(i),
                  sum.begin() + static_cast<std::ptrdiff_t>(i) + 2);
      else
        ++i;
    }
    while (!sum.empty()) {
      Row& row = rows_[sum.back()];
      sum.pop_back();
      if (!row.known) {
        row = {std::move(sum), odd, true};
        return;
      }
      std::vector<std::uint32_t> both;
      std::ranges::set_symmetric_difference(sum, row.others, std::back_inserter(both));
      sum = std::move(both);
      odd = odd != row.odd;
    }
  }

  /// A solution, by value; signs that are free are even.
  std::vector<bool> solution() const {
    std::vector<bool> signs;
    for (const Row& row : rows_) {
      bool sign = row.odd;
      for (const std::uint32_t other : row.others) sign = sign != signs[other];
      signs.push_back(sign);
    }
    std::vector<bool> out;
    for (const std::uint32_t number : unknown_) out.push_back(number != kNoIndex && signs[number]);
    return out;
  }

 private:
  /// An unknown as the sum of earlier ones.
  struct Row {
    std::vector<std::uint32_t> others;
    bool odd = false, known = false;
  };

  std::uint32_t unknown(std::uint32_t v) {
    if (unknown_[v] == kNoIndex) {
      unknown_[v] = static_cast<std::uint32_t>(rows_.size());
      rows_.emplace_back();
    }
    return unknown_[v];
  }

  std::vector<std::uint32_t> unknown_;  // of a value
  std::vector<Row> rows_;
};

class Signs {
 public:
  Signs(const UnsignedProgram& values, std::span<const std::uint32_t> order, const std::vector<bool>& swapped)
      : values_(values),
        order_(order),
        swapped_(swapped),
        sign_(values.size(), unknown),
        place_(values.size(), kNoIndex) {
    results_.resize(values.size());
    for (const std::uint32_t v : values.wanted()) {
      const Operand result = values.plain(v);
      results_[result.value][result.negative ? 1 : 0] = true;
    }
  }

  Program write(std::span<const Steps> ranges) {
    is_inside_.assign(values_.size(), false);
    for (const Steps& steps : ranges)
      for (std::size_t i = steps.first; i < steps.first + steps.length * steps.count; ++i)
        is_inside_[order_[i]] = true;
    argument_.assign(values_.size(), unknown);
    for (std::uint32_t v = 0; v < values_.size(); ++v)
      if (!is_free(v))
        for (const Operand& o : values_.operands(v)) argument_[o.value] = o.negative ? minus : plus;
    relate(ranges);
    choose(ranges);
    std::size_t begin = 0;
    for (const Steps& steps : ranges) {
      write_straight(begin, steps.first);
      write_steps(steps);
      begin = steps.first + steps.count * steps.length;
    }
    write_straight(begin, order_.size());
    return finished();
  }

 private:
  using Operand = UnsignedProgram::Operand;
  enum Sign : std::uint8_t { plus, minus, unknown };
  static constexpr std::uint32_t kLeaf = 1u << 31;  // with the number of a leaf

  std::uint32_t next() const { return static_cast<std::uint32_t>(out_.code.size()); }

  std::array<Operand, 2> operands(std::uint32_t v) const { return {operand(v, 0), operand(v, 1)}; }

  Operand operand(std::uint32_t v, std::size_t k) const {
    return values_.operands(v)[swapped_[v] ? 1 - k : k];
  }

  bool constant(Operand o) const { return values_.constant(o.value); }
  bool known(Operand o) const { return !constant(o) && sign_[o.value] != unknown; }
  /// Whether what is computed enters with a minus.
  bool negative(Operand o) const { return o.negative != (sign_[o.value] == minus); }

  bool is_product(std::uint32_t v) const {
    return values_.op(v) == Operation::mul || values_.op(v) == Operation::div;
  }

  /// It or its negative can be computed with as many operations.
  bool is_free(std::uint32_t v) const { return values_.op(v) == Operation::add || is_product(v); }
  /// Its negative can be had for a negation ahead of the loops.
  bool can_turn(std::uint32_t v) const { return !is_free(v) && !values_.constant(v) && !is_inside_[v]; }
  bool has_choice(std::uint32_t v) const { return is_free(v) || can_turn(v); }
  bool is_result(std::uint32_t v) const { return results_[v][0] || results_[v][1]; }

  /// Sets a sign; what it decides about operands comes with `spread`.
  void settle(std::uint32_t v, bool is_minus) {
    sign_[v] = is_minus ? minus : plus;
    if (has_kin_[v] && kin_sign_[kin(v)] == unknown) kin_sign_[kin(v)] = is_minus != odd_[v] ? minus : plus;
    if (is_free(v)) open_.push_back(v);
  }

  /// Lets an operand enter with this sign if it can.
  void settle(Operand o, bool is_minus) {
    if (!constant(o) && !find(o.value)) settle(o.value, o.negative != is_minus);
  }

  void spread() {
    while (!open_.empty()) {
      const std::uint32_t v = open_.back();
      open_.pop_back();
      const bool is_minus = sign_[v] == minus;
      const auto [a, b] = operands(v);
      if (values_.op(v) == Operation::add) {
        settle(a, is_minus);
        settle(b, is_minus);
      } else if (!constant(a) && !constant(b)) {
        if (known(b)) {
          settle(a, is_minus != negative(b));
        } else {
          settle(a, false);
          settle(b, is_minus != negative(a));
        }
      }
    }
  }

  /// The sign of a value, if anything but constants decides it.
  bool find(std::uint32_t v) {
    if (sign_[v] != unknown) return true;
    if (!is_free(v)) return false;
    const auto [a, b] = operands(v);
    if (values_.op(v) == Operation::add) {
      if (!known(a) && !known(b)) return false;
      settle(v, negative(known(a) ? a : b));
      return true;
    }
    if (constant(a) || constant(b) || !known(a) || !known(b)) return false;
    settle(v, negative(a) != negative(b));
    return true;
  }

  void relate(std::span<const Steps> ranges) {
    SignEquations equations(values_.size());
    for (const Steps& steps : ranges)
      for (std::size_t i = steps.first; i + steps.length < steps.first + steps.length * steps.count; ++i)
        relate(order_[i], order_[i + steps.length], equations);
    // If nothing speaks against it, none or all are wanted with the other sign, and nothing is turned.
    for (const auto& [v, w] : related_) {
      if (is_inside_[v] && is_inside_[w] && is_result(v) && is_result(w))
        equations.add({v, w}, results_[v][1] != results_[w][1]);
      if (can_turn(v) || can_turn(w)) equations.add({v, w}, false);
    }
    odd_ = equations.solution();
    kin_.resize(values_.size());
    std::iota(kin_.begin(), kin_.end(), 0u);
    for (const auto& [v, w] : related_) kin_[kin(v)] = kin(w);
    has_kin_.assign(values_.size(), false);
    for (const auto& [v, w] : related_) has_kin_[v] = has_kin_[w] = true;
    kin_sign_.assign(values_.size(), unknown);
  }

  /// One that stands for all values whose signs are related.
  std::uint32_t kin(std::uint32_t v) {
    while (kin_[v] != v) v = kin_[v] = kin_[kin_[v]];
    return v;
  }

  /// v in one step is w in the next: the sign of each operand, relative to that of the value, has to stay.
  void relate(std::uint32_t v, std::uint32_t w, SignEquations& equations) {
    const bool product = is_product(v);
    std::vector<std::uint32_t> signs;
    bool odd = false;
    const auto add = [&](std::uint32_t x, std::uint32_t y) {
      signs.insert(signs.end(), {x, y});
      related_.emplace_back(x, y);
    };
    if (is_free(v)) add(v, w);
    const std::size_t own = signs.size();
    for (std::size_t k = 0; k < values_.operands(v).size(); ++k) {
      const Operand a = operand(v, k), b = operand(w, k);
      if (constant(a) && product) return;
      if (constant(a)) continue;
      if (a.value != b.value && has_choice(a.value) && has_choice(b.value)) add(a.value, b.value);
      odd = odd != (a.negative != b.negative);
      if (product) continue;
      equations.add(signs, odd);
      signs.resize(own);
      odd = false;
    }
    if (product) equations.add(signs, odd);
  }

  /// Step by step, and what lies between, so that no step depends on a later one.
  void choose(std::span<const Steps> ranges) {
    std::size_t begin = 0;
    for (const Steps& steps : ranges) {
      choose(begin, steps.first);
      for (std::size_t k = 0; k < steps.count; ++k)
        choose(steps.first + k * steps.length, steps.first + (k + 1) * steps.length);
      begin = steps.first + steps.count * steps.length;
    }
    choose(begin, order_.size());
  }

  void choose(std::size_t begin, std::size_t end) {
    const std::span<const std::uint32_t> part = order_.subspan(begin, end - begin);
    for (const std::uint32_t v : part) {
      if (values_.constant(v)) continue;
      if (!is_free(v)) {
        if (!can_turn(v) || !follow(v)) settle(v, false);
        for (const Operand& o : values_.operands(v)) settle(o, false);
      } else if (!follow(v)) {
        if (argument_[v] == unknown)
          find(v);
        else
          settle(v, argument_[v] == minus);
      }
      spread();
    }
    // What nothing decides: first what is like something, or something like it.
    for (const std::uint32_t v : part) {
      if (!values_.constant(v) && has_kin_[v] && !follow(v) && !find(v)) settle(v, false);
      spread();
    }
    for (std::size_t i = part.size(); i-- > 0;) {
      if (const std::uint32_t v = part[i]; !values_.constant(v) && !find(v))
        settle(v, results_[v][1] && !results_[v][0]);
      spread();
    }
  }

  /// Takes the sign from a value that it is related to, if that is known.
  bool follow(std::uint32_t v) {
    if (sign_[v] != unknown || !has_kin_[v] || kin_sign_[kin(v)] == unknown) return false;
    settle(v, (kin_sign_[kin(v)] == minus) != odd_[v]);
    return true;
  }

  std::uint32_t append(Operation op, std::uint32_t a, std::uint32_t b = 0) {
    out_.code.push_back({op, a, b});
    return next() - 1;
  }

  std::uint32_t constant(std::uint32_t v, bool negated) {
    const double given = values_.program().constants[values_.program().code[v].a];
    const double value = given == 0 ? 0 : negated ? -given : given;
    const auto [entry, fresh] = constant_at_.try_emplace(std::bit_cast<std::uint64_t>(value), kNoIndex);
    if (fresh) {
      out_.constants.push_back(value);
      entry->second = leaf({Operation::constant, static_cast<std::uint32_t>(out_.constants.size() - 1), 0});
    }
    return entry->second;
  }

  std::uint32_t leaf(Instruction c) {
    leaves_.push_back(c);
    return kLeaf | static_cast<std::uint32_t>(leaves_.size() - 1);
  }

  /// What there is of an operand, or its negative.
  std::uint32_t read(Operand o, bool negated) {
    if (constant(o)) return constant(o.value, o.negative != negated);
    return place_[o.value];
  }

  std::uint32_t read_exactly(Operand o) {
    const std::uint32_t there = read(o, false);
    if (constant(o) || !negative(o)) return there;
    const auto negated = negative_at_.find(o.value);
    return negated != negative_at_.end() ? negated->second : append(Operation::neg, there);
  }

  void write(std::uint32_t v) {
    if (values_.constant(v)) return;
    const Instruction& c = values_.program().code[v];
    const bool is_minus = sign_[v] == minus;
    std::uint32_t& place = place_[v];
    if (c.op == Operation::input) {
      place = leaf(c);
    } else if (values_.op(v) == Operation::add) {
      const auto [a, b] = operands(v);
      const std::uint32_t x = read(a, is_minus), y = read(b, is_minus);
      const bool minus_a = !constant(a) && negative(a) != is_minus,
                 minus_b = !constant(b) && negative(b) != is_minus;
      if (minus_a == minus_b)
        place = append(Operation::add, x, y);
      else
        place = minus_b ? append(Operation::sub, x, y) : append(Operation::sub, y, x);
      if (minus_a && minus_b) place = append(Operation::neg, place);
    } else if (is_product(v)) {
      const auto [a, b] = operands(v);
      // The sign that is left is a constant's, or that of the product.
      const bool left = is_minus != ((!constant(a) && negative(a)) != (!constant(b) && negative(b)));
      const std::uint32_t x = read(a, left), y = read(b, left && !constant(a));
      place = append(c.op, x, y);
      if (left && !constant(a) && !constant(b)) place = append(Operation::neg, place);
    } else {
      std::array<std::uint32_t, 2> read{};
      const auto given = values_.operands(v);
      for (std::size_t k = 0; k < given.size(); ++k) read[k] = read_exactly(given[k]);
      place = append(c.op, read[0], read[1]);
    }
    if (is_minus && !is_free(v)) {
      negative_at_[v] = place;
      place = append(Operation::neg, place);
    }
  }

  bool is_negative_wanted(std::uint32_t v) const {
    return !values_.constant(v) && results_[v][sign_[v] == minus ? 0 : 1] && !negative_at_.contains(v);
  }
  void negate(std::uint32_t v) { negative_at_[v] = append(Operation::neg, place_[v]); }

  void write_straight(std::size_t begin, std::size_t end) {
    for (const std::uint32_t v : order_.subspan(begin, end - begin)) {
      write(v);
      if (is_negative_wanted(v)) negate(v);
    }
  }

  /// Negatives that are wanted of all steps are part of them; others come after.
  void write_steps(const Steps& steps) {
    const auto at = [&](std::size_t k, std::size_t i) { return order_[steps.first + k * steps.length + i]; };
    std::vector<bool> inside(steps.length, true);
    for (std::size_t k = 0; k < steps.count; ++k)
      for (std::size_t i = 0; i < steps.length; ++i) inside[i] = inside[i] && is_negative_wanted(at(k, i));
    std::vector<std::uint32_t> begins;
    for (std::size_t k = 0; k < steps.count; ++k) {
      begins.push_back(next());
      for (std::size_t i = 0; i < steps.length; ++i) {
        write(at(k, i));
        if (inside[i]) negate(at(k, i));
      }
    }
    begins.push_back(next());
    for (std::size_t k = 0; k < steps.count; ++k)
      for (std::size_t i = 0; i < steps.length; ++i)
        if (!inside[i] && is_negative_wanted(at(k, i))) negate(at(k, i));
    add_loop(begins);
  }

  /// Whether steps k and k + 1 are the same instructions.
  bool alike(const std::vector<std::uint32_t>& begins, std::size_t k) const {
    const std::uint32_t here = begins[k], there = begins[k + 1], length = there - here;
    if (begins[k + 2] - there != length) return false;
    const auto same = [&](std::uint32_t x, std::uint32_t y) {
      const bool inside = (x & kLeaf) == 0 && x >= here, still_inside = (y & kLeaf) == 0 && y >= there;
      return inside == still_inside && (!inside || x - here == y - there);
    };
    for (std::uint32_t i = 0; i < length; ++i) {
      const Instruction &x = out_.code[here + i], &y = out_.code[there + i];
      const int count = operand_count(x.op);
      if (x.op != y.op || (count > 0 && !same(x.a, y.a)) || (count > 1 && !same(x.b, y.b))) return false;
    }
    return true;
  }

  void add_loop(const std::vector<std::uint32_t>& begins) {
    std::size_t first = 0, count = 1;
    for (std::size_t k = 0, from = 0; k + 2 < begins.size(); ++k) {
      if (!alike(begins, k)) from = k + 1;
      if (k + 2 - from > count) {
        first = from;
        count = k + 2 - from;
      }
    }
    if (count < kFewestSteps) return;
    out_.loops.push_back(
        {begins[first], begins[first + 1] - begins[first], static_cast<std::uint32_t>(count)});
  }

  /// Leaves first, then the code, then dot products as they are.
  Program finished() {
    const Program& given = values_.program();
    const std::uint32_t straight = values_.size();
    std::vector<std::uint32_t> products;
    const auto exactly = [&](std::uint32_t v) {
      if (v >= straight) return products[v - straight];
      const Operand o = values_.plain(v);
      return constant(o) || !negative(o) ? read(o, false) : negative_at_.at(o.value);
    };
    for (std::uint32_t v = straight; v < given.code.size(); ++v) {
      const Instruction& c = given.code[v];
      products.push_back(append(c.op, exactly(c.a), operand_count(c.op) > 1 ? exactly(c.b) : 0));
    }
    out_.function = given.function;
    out_.formulation = given.formulation;
    out_.inputs = given.inputs;
    out_.outputs = given.outputs;
    out_.dot_products = given.dot_products;
    out_.dot_product_code = given.dot_product_code;
    std::vector<std::vector<std::uint32_t>*> wanted;
    for (OutputArray& output : out_.outputs) wanted.push_back(&output.values);
    for (DotProducts& p : out_.dot_products) wanted.insert(wanted.end(), {&p.left, &p.right});
    for (std::vector<std::uint32_t>* values : wanted)
      for (std::uint32_t& v : *values) v = exactly(v);
    const auto shift = static_cast<std::uint32_t>(leaves_.size());
    const auto move = [&](std::uint32_t& x) { x = (x & kLeaf) != 0 ? x & ~kLeaf : x + shift; };
    for (Instruction& c : out_.code) {
      const int count = operand_count(c.op);
      if (count > 0) move(c.a);
      if (count > 1) move(c.b);
    }
    for (std::vector<std::uint32_t>* values : wanted)
      for (std::uint32_t& v : *values) move(v);
    for (Loop& loop : out_.loops) loop.first += shift;
    out_.code.insert(out_.code.begin(), leaves_.begin(), leaves_.end());
    return std::move(out_);
  }

  const UnsignedProgram& values_;
  std::span<const std::uint32_t> order_;
  const std::vector<bool>& swapped_;
  std::vector<Sign> sign_;
  std::vector<std::uint32_t> open_;  // have a sign that their operands are yet to follow
  std::vector<Sign> argument_;       // sign of the argument of a function that a value is
  std::vector<bool> is_inside_;      // a value of a loop
  // Values whose signs follow from each other: as pairs, as sets with one that stands for all, and whether a
  // sign is the other one of the sign of the set.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> related_;
  std::vector<std::uint32_t> kin_;
  std::vector<bool> has_kin_, odd_;
  std::vector<Sign> kin_sign_;
  std::vector<std::uint32_t> place_;                    // of a value in the code
  std::vector<std::array<bool, 2>> results_;            // whether a value is a result, and its negative
  std::map<std::uint32_t, std::uint32_t> negative_at_;  // the negative of what is computed
  std::map<std::uint64_t, std::uint32_t> constant_at_;
  std::vector<Instruction> leaves_;
  Program out_;
};

}  // namespace

Program with_signs(const UnsignedProgram& values, std::span<const std::uint32_t> order,
                   const std::vector<bool>& swapped, std::span<const Steps> ranges) {
  return Signs(values, order, swapped).write(ranges);
}

}  // namespace alembert

// Stage `gather`: results that are dot products of the same rows, as the far entries of a mass matrix are of
// twists and momenta. Scheduled program in, the same program with these at its end and the tables of rows
// beside it, so that they can be written as loops.
//
// A result qualifies if it is a sum of products, each wanted by it alone; one of them may be a value times
// one, as in velocities of the points of a body. Given a row, all results that have one factor of each
// product in it are its dot products with the rows of what is left; those rows lead to further ones. A first
// row is what two results have in common.
#include "program/loops/dot_products.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "support/no_index.hpp"
#include "support/operation.hpp"

namespace alembert {
namespace {

// Stands for the factor one among values.
constexpr std::uint32_t kOne = kNoIndex - 1;

// A loop over fewer results takes longer to begin than it saves.
constexpr std::uint32_t kShortestRun = 4;

// With fewer, reading and writing is most of the work.
constexpr std::size_t kFewestTerms = 3;

// For a first row, so many results are looked at that have one of its values.
constexpr std::size_t kTries = 16;

struct Term {
  std::uint32_t a, b;
  bool negative;
};

/// A result that is a sum of products.
struct Sum {
  std::uint32_t value;
  std::uint32_t output;
  std::array<std::uint32_t, 2> places;  ///< elements of the output, ascending, or one twice
  std::vector<Term> terms;
  std::vector<std::uint32_t> members;               ///< itself and all values that it alone needs
  std::uint32_t left = kNoIndex, right = kNoIndex;  ///< rows, once they are known
};

/// A value or its negative.
struct Entry {
  std::uint32_t value;
  bool negative;
  auto operator<=>(const Entry&) const = default;
};
using Row = std::vector<Entry>;

/// The rows of one side.
class Table {
 public:
  std::uint32_t add(const Row& row) {
    const auto [found, is_new] = numbers_.emplace(row, static_cast<std::uint32_t>(rows_.size()));
    if (is_new) {
      rows_.push_back(row);
      for (const Entry& entry : row) with_[entry.value].push_back(found->second);
    }
    return found->second;
  }
  std::optional<std::uint32_t> find(const Row& row) const {
    const auto found = numbers_.find(row);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }
  const Row& operator[](std::uint32_t number) const { return rows_[number]; }
  /// Rows that have this value in them.
  std::span<const std::uint32_t> with(std::uint32_t value) const {
    const auto found = with_.find(value);
    return found == with_.end() ? std::span<const std::uint32_t>() : found->second;
  }

 private:
  std::vector<Row> rows_;
  std::map<Row, std::uint32_t> numbers_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> with_;
};

/// A term of its own for each entry of a row.
class Matching {
 public:
  Matching(const Sum& sum, const Row& row) : sum_(sum), row_(row), entry_(sum.terms.size(), kNoIndex) {}

  /// The row of which the sum is the dot product with this one; none if this one has not a factor of each
  /// term.
  std::optional<Row> other_row() {
    for (std::uint32_t i = 0; i < row_.size(); ++i)
      if (std::vector<bool> tried(sum_.terms.size(), false); !place(i, tried)) return std::nullopt;
    Row other(row_.size());
    for (std::size_t k = 0; k < entry_.size(); ++k) {
      const Term& term = sum_.terms[k];
      const Entry& entry = row_[entry_[k]];
      other[entry_[k]] = {term.a == entry.value ? term.b : term.a, term.negative != entry.negative};
    }
    return other;
  }

 private:
  /// Finds a term for entry i; those that have one may have to take another.
  bool place(std::uint32_t i, std::vector<bool>& tried) {
    for (std::size_t k = 0; k < entry_.size(); ++k) {
      const Term& term = sum_.terms[k];
      if (tried[k] || (term.a != row_[i].value && term.b != row_[i].value)) continue;
      tried[k] = true;
      if (entry_[k] != kNoIndex && !place(entry_[k], tried)) continue;
      entry_[k] = i;
      return true;
    }
    return false;
  }

  const Sum& sum_;
  const Row& row_;
  std::vector<std::uint32_t> entry_;  // of each term
};

std::optional<Row> other_row(const Sum& sum, const Row& row) {
  return Matching(sum, row).other_row();
}

class Gathering {
 public:
  explicit Gathering(const Program& program) : program_(program) {
    find_sums();
    // Rows are of one length, and meet within one array.
    std::map<std::pair<std::uint32_t, std::size_t>, std::vector<Sum>> groups;
    for (Sum& sum : sums_) groups[{sum.output, sum.terms.size()}].push_back(std::move(sum));
    for (auto& [key, sums] : groups) find_rows(sums);
  }

  Program gathered(std::size_t least) {
    std::size_t found = 0;
    for (const Group& group : groups_) found += group.sums.size();
    Program out = program_;
    if (found == 0 || found < least) return out;
    rewrite(out);
    return out;
  }

 private:
  struct Group {
    DotProducts products;
    std::vector<Row> left, right;
    std::vector<Sum> sums;  ///< in the order of the runs
  };

  void find_sums() {
    constexpr std::uint32_t kTooMany = 3;  // places of a result, or in another array
    const std::size_t size = program_.code.size();
    std::vector<std::uint32_t> uses(size, 0), results(size, 0);
    for (const Instruction& c : program_.code) {
      const int operands = operand_count(c.op);
      if (operands > 0) ++uses[c.a];
      if (operands > 1) ++uses[c.b];
    }
    std::map<std::uint32_t, Sum> candidates;
    for (std::uint32_t output = 0; output < program_.outputs.size(); ++output) {
      const std::vector<std::uint32_t>& values = program_.outputs[output].values;
      for (std::uint32_t place = 0; place < values.size(); ++place) {
        const std::uint32_t v = values[place];
        Sum& sum = candidates.try_emplace(v, Sum{v, output, {place, place}, {}, {}}).first->second;
        sum.places[1] = place;
        results[v] += sum.output == output ? 1 : kTooMany;
      }
    }
    for (auto& [v, sum] : candidates) {
      if (uses[v] > 0 || results[v] >= kTooMany) continue;
      if (collect_terms(sum, uses, results) && sum.terms.size() >= kFewestTerms)
        sums_.push_back(std::move(sum));
    }
  }

  static bool in_sums(Operation op) {
    return op == Operation::mul || op == Operation::add || op == Operation::sub || op == Operation::neg;
  }

  /// False if the value is no sum of products that it alone needs and of one other value at most.
  bool collect_terms(Sum& sum, const std::vector<std::uint32_t>& uses,
                     const std::vector<std::uint32_t>& results) const {
    std::vector<Entry> left{{sum.value, false}};
    Term single{};
    bool has_single = false;
    while (!left.empty()) {
      const auto [v, negative] = left.back();
      left.pop_back();
      const Instruction& c = program_.code[v];
      const bool own = v == sum.value || (uses[v] == 1 && results[v] == 0);
      if (!own || !in_sums(c.op)) {
        if (std::exchange(has_single, true)) return false;
        single = {v, kOne, negative};
        continue;
      }
      sum.members.push_back(v);
      if (c.op == Operation::mul) {
        sum.terms.push_back({c.a, c.b, negative});
      } else if (c.op == Operation::add || c.op == Operation::sub) {
        left.push_back({c.b, negative != (c.op == Operation::sub)});
        left.push_back({c.a, negative});
      } else {
        left.push_back({c.a, !negative});
      }
    }
    // Last, as rows are looked for by the first.
    if (has_single) sum.terms.push_back(single);
    return true;
  }

  void find_rows(std::vector<Sum>& sums) {
    Table left, right;
    std::map<std::uint32_t, std::vector<const Sum*>> with;
    for (const Sum& sum : sums)
      for (const Term& term : sum.terms)
        for (const std::uint32_t v : {term.a, term.b}) with[v].push_back(&sum);
    std::vector<Sum*> open;
    for (Sum& sum : sums) open.push_back(&sum);
    while (!open.empty()) {
      if (std::erase_if(open, [&](Sum* sum) { return resolve(*sum, left, right); }) > 0) continue;
      // None has a known row: the first that shares one with another starts anew.
      const auto start = std::ranges::find_if(open, [&](Sum* sum) {
        const std::optional<Row> row = shared_row(*sum, with);
        if (row) left.add(*row);
        return row.has_value();
      });
      open.erase(open.begin(), start);
    }
    std::erase_if(sums, [](const Sum& sum) { return sum.left == kNoIndex; });
    if (sums.empty()) return;
    // Loops go along the rows of one side; which one is right depends on how the results are arranged.
    Group group = group_of(sums, left, right);
    for (Sum& sum : sums) std::swap(sum.left, sum.right);
    Group other = group_of(std::move(sums), right, left);
    if (other.sums.size() > group.sums.size()) group = std::move(other);
    // Rows are written to memory and read again.
    if (group.sums.size() >= 2 * (group.left.size() + group.right.size()))
      groups_.push_back(std::move(group));
  }

  static bool resolve(Sum& sum, Table& left, Table& right) {
    std::optional<Row> unknown_right;
    for (const std::uint32_t v : {sum.terms[0].a, sum.terms[0].b}) {
      for (const std::uint32_t number : left.with(v)) {
        const std::optional<Row> other = other_row(sum, left[number]);
        if (!other) continue;
        sum.left = number;
        if (const auto known = right.find(*other)) {
          sum.right = *known;
          return true;
        }
        unknown_right = other;
      }
    }
    if (unknown_right) {
      sum.right = right.add(*unknown_right);
      return true;
    }
    for (const std::uint32_t v : {sum.terms[0].a, sum.terms[0].b}) {
      for (const std::uint32_t number : right.with(v)) {
        const std::optional<Row> other = other_row(sum, right[number]);
        if (!other) continue;
        sum.right = number;
        sum.left = left.add(*other);
        return true;
      }
    }
    return false;
  }

  /// One factor of each term, which another sum has too: the row that most sums have.
  static std::optional<Row> shared_row(const Sum& sum,
                                       const std::map<std::uint32_t, std::vector<const Sum*>>& with) {
    std::optional<Row> best;
    std::ptrdiff_t most = 0;
    for (const std::uint32_t v : {sum.terms[0].a, sum.terms[0].b}) {
      const std::span<const Sum*const> all = with.at(v), others = all.first(std::min(all.size(), kTries));
      for (const Sum* other : others) {
        if (other == &sum) continue;
        const auto in_other = [&](std::uint32_t x) {
          return std::ranges::any_of(other->terms,
                                     [&](const Term& term) { return term.a == x || term.b == x; });
        };
        Row row{{v, false}};
        for (const Term& term : std::span(sum.terms).subspan(1))
          if (const bool a = in_other(term.a); a || in_other(term.b))
            row.push_back({a ? term.a : term.b, false});
        if (row.size() < sum.terms.size()) continue;
        const auto having =
            std::ranges::count_if(others, [&](const Sum* x) { return other_row(*x, row).has_value(); });
        if (having > most) {
          best = row;
          most = having;
        }
      }
    }
    return best;
  }

  /// For each row of one side the row that has the next result, with the same row of the other side; or the
  /// next but so many, if none has.
  static std::map<std::uint32_t, std::uint32_t> next_rows(const std::vector<Sum>& sums,
                                                          std::uint32_t Sum::*side,
                                                          std::uint32_t Sum::*other_side) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> row_at;  // by other row and place
    for (const Sum& sum : sums)
      for (const std::uint32_t place : sum.places)
        row_at.emplace(std::pair(sum.*other_side, place), sum.*side);
    std::map<std::uint32_t, std::uint32_t> next, previous;
    for (const bool near : {true, false})
      for (auto at = row_at.begin(), after = at; after != row_at.end() && ++after != row_at.end();
           at = after) {
        const auto [other_row, place] = at->first;
        if (after->first.first != other_row || (near && after->first.second != place + 1)) continue;
        if (next.contains(at->second) || previous.contains(after->second)) continue;
        next.emplace(at->second, after->second);
        previous.emplace(after->second, at->second);
      }
    return next;
  }

  /// The numbers of the rows of one side in the order of the first results that they are in; but a row is
  /// followed by its next one.
  static std::map<std::uint32_t, std::uint32_t> ranks(const std::vector<Sum>& sums, std::uint32_t Sum::*side,
                                                      const std::map<std::uint32_t, std::uint32_t>& next) {
    std::map<std::uint32_t, std::uint32_t> first;
    for (const Sum& sum : sums) {
      const auto [known, is_new] = first.emplace(sum.*side, sum.places[0]);
      if (!is_new) known->second = std::min(known->second, sum.places[0]);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (const auto& [row, place] : first) order.emplace_back(place, row);
    std::ranges::sort(order);
    std::set<std::uint32_t> behind;
    for (const auto& [row, after] : next) behind.insert(after);
    std::map<std::uint32_t, std::uint32_t> rank;
    for (const bool rings : {false, true})
      for (const auto& [place, head] : order) {
        if (!rings && behind.contains(head)) continue;
        std::uint32_t row = head;
        while (rank.emplace(row, static_cast<std::uint32_t>(rank.size())).second && next.contains(row))
          row = next.at(row);
      }
    return rank;
  }

  /// The run of two neighbouring sums: of results that are one element at even distances, or two of which one
  /// lies beside the next.
  static std::optional<DotProducts::Run> run_of(const Sum& one, const Sum& next) {
    const std::array<std::uint32_t, 2>&a = one.places, &b = next.places;
    if (a[0] == a[1] && b[0] == b[1] && b[0] > a[0]) {
      const std::uint32_t step = b[0] - a[0];
      return DotProducts::Run{0, 0, 1, a[0], step, a[0], step};
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t other = 1 - k;
      if (b[k] == a[k] + 1 && b[other] > a[other])
        return DotProducts::Run{0, 0, 1, a[k], 1, a[other], b[other] - a[other]};
    }
    return std::nullopt;
  }

  static bool continues(const DotProducts::Run& run, const Sum& sum) {
    const std::uint32_t first = run.first + run.count * run.stride,
                        mirror = run.mirror + run.count * run.step;
    return sum.places.front() == std::min(first, mirror) && sum.places.back() == std::max(first, mirror);
  }

  static Group group_of(std::vector<Sum> sums, const Table& left, const Table& right) {
    const auto left_rank = ranks(sums, &Sum::left, {}),
               right_rank = ranks(sums, &Sum::right, next_rows(sums, &Sum::right, &Sum::left));
    const auto rank = [&](const Sum& sum) {
      return std::pair(left_rank.at(sum.left), right_rank.at(sum.right));
    };
    std::ranges::sort(sums, {}, rank);
    Group group;
    group.products.output = sums[0].output;
    group.products.terms = static_cast<std::uint32_t>(sums[0].terms.size());
    std::map<std::uint32_t, std::uint32_t> left_place, right_place;  // of a row in use, by rank
    for (std::size_t i = 0; i < sums.size();) {
      const auto follows = [&](std::size_t k) {
        const auto [a, b] = rank(sums[k - 1]);
        return k < sums.size() && rank(sums[k]) == std::pair(a, b + 1);
      };
      std::optional<DotProducts::Run> run;
      if (i + 1 < sums.size() && follows(i + 1)) run = run_of(sums[i], sums[i + 1]);
      const std::size_t begin = i++;
      if (!run) continue;
      while (i < sums.size() && follows(i) && continues(*run, sums[i])) {
        ++run->count;
        ++i;
      }
      if (run->count < kShortestRun) continue;
      std::tie(run->left, run->right) = rank(sums[begin]);
      left_place[run->left];
      for (std::uint32_t k = 0; k < run->count; ++k) right_place[run->right + k];
      group.products.runs.push_back(*run);
      std::move(sums.begin() + static_cast<std::ptrdiff_t>(begin),
                sums.begin() + static_cast<std::ptrdiff_t>(i), std::back_inserter(group.sums));
    }
    const auto collect = [](std::map<std::uint32_t, std::uint32_t>& place,
                            const std::map<std::uint32_t, std::uint32_t>& rank_of, const Table& table) {
      std::map<std::uint32_t, std::uint32_t> number_of;
      for (const auto& [number, its_rank] : rank_of) number_of.emplace(its_rank, number);
      std::vector<Row> rows;
      for (auto& [its_rank, to] : place) {
        to = static_cast<std::uint32_t>(rows.size());
        rows.push_back(table[number_of.at(its_rank)]);
      }
      return rows;
    };
    group.left = collect(left_place, left_rank, left);
    group.right = collect(right_place, right_rank, right);
    for (DotProducts::Run& run : group.products.runs) {
      run.left = left_place.at(run.left);
      run.right = right_place.at(run.right);
    }
    return group;
  }

  void rewrite(Program& out) {
    const std::size_t size = program_.code.size();
    std::vector<bool> inside(size, false), negated(size, false);
    for (const Group& group : groups_) {
      for (const Sum& sum : group.sums)
        for (const std::uint32_t v : sum.members) inside[v] = true;
      for (const std::vector<Row>* rows : {&group.left, &group.right})
        for (const Row& row : *rows)
          for (const Entry& entry : row)
            if (entry.negative && entry.value != kOne) negated[entry.value] = true;
    }
    out.code.clear();
    const auto add = [&](Operation op, std::uint32_t a, std::uint32_t b) {
      out.code.push_back({op, a, b});
      return static_cast<std::uint32_t>(out.code.size() - 1);
    };
    std::vector<std::uint32_t> place(size, kNoIndex), negative(size, kNoIndex);
    for (std::uint32_t v = 0; v < size; ++v) {
      if (inside[v]) continue;
      Instruction c = program_.code[v];
      const int operands = operand_count(c.op);
      if (operands > 0) c.a = place[c.a];
      if (operands > 1) c.b = place[c.b];
      place[v] = add(c.op, c.a, c.b);
      if (negated[v]) negative[v] = add(Operation::neg, place[v], 0);
    }
    for (OutputArray& output : out.outputs)
      for (std::uint32_t& v : output.values)
        if (!inside[v]) v = place[v];
    std::array<std::uint32_t, 2> one{kNoIndex, kNoIndex};  // 1 and -1
    const auto in_table = [&](const Entry& entry) {
      if (entry.value != kOne) return entry.negative ? negative[entry.value] : place[entry.value];
      std::uint32_t& constant = one[entry.negative ? 1 : 0];
      if (constant == kNoIndex) {
        out.constants.push_back(entry.negative ? -1 : 1);
        constant = add(Operation::constant, static_cast<std::uint32_t>(out.constants.size() - 1), 0);
      }
      return constant;
    };
    for (Group& group : groups_) {
      const auto values = [&](const std::vector<Row>& rows) {
        std::vector<std::uint32_t> list;
        for (const Row& row : rows) std::ranges::transform(row, std::back_inserter(list), in_table);
        return list;
      };
      group.products.left = values(group.left);
      group.products.right = values(group.right);
    }
    const std::size_t straight = out.code.size();
    for (Group& group : groups_) {
      DotProducts& products = group.products;
      std::vector<std::uint32_t>& results = out.outputs[products.output].values;
      const auto plus_product = [&](std::uint32_t sum, std::uint32_t a, std::uint32_t b) {
        if (sum == kNoIndex) return add(Operation::mul, a, b);
        for (const std::uint32_t factor : {a, b}) {
          const std::uint32_t other = factor == a ? b : a;
          if (factor == one[0]) return add(Operation::add, sum, other);
          if (factor == one[1]) return add(Operation::sub, sum, other);
        }
        const std::uint32_t product = add(Operation::mul, a, b);
        return add(Operation::add, sum, product);
      };
      for (const DotProducts::Run& run : products.runs)
        for (std::uint32_t i = 0; i < run.count; ++i) {
          const std::uint32_t a = run.left * products.terms, b = (run.right + i) * products.terms;
          std::uint32_t sum = kNoIndex;
          for (std::uint32_t k = 0; k < products.terms; ++k)
            sum = plus_product(sum, products.left[a + k], products.right[b + k]);
          results[run.first + i * run.stride] = results[run.mirror + i * run.step] = sum;
        }
      out.dot_products.push_back(std::move(products));
    }
    out.dot_product_code = static_cast<std::uint32_t>(out.code.size() - straight);
  }

  const Program& program_;
  std::vector<Sum> sums_;
  std::vector<Group> groups_;
};

}  // namespace

Program gather_dot_products(const Program& program, std::size_t least) {
  return Gathering(program).gathered(least);
}

std::size_t dot_products(const Program& program) {
  std::size_t number = 0;
  for (const DotProducts& products : program.dot_products)
    for (const DotProducts::Run& run : products.runs) number += run.count;
  return number;
}

}  // namespace alembert

// Finds blocks that repeat, see the header.
//
// A window is a few instructions in a row with what connects them. Windows of one class start alike; where
// every occurrence of a class is followed by the same class, which has no other predecessor, both belong to
// the same run (as in the compaction of a de Bruijn graph). Runs are then joined in pairs like letters in
// byte-pair encoding, until no pair is frequent.
#include "program/repeated_blocks.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "program/operation.hpp"

namespace alembert {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::size_t kWindow = 12;         // instructions that decide about the class of a place
constexpr std::size_t kMaxJoined = 320;     // length of a repeated block: long enough for calls not to matter
constexpr std::uint32_t kLeastRepeats = 6;  // fewer occurrences of a pair do not pay for its code
constexpr std::uint32_t kShort = 16;        // what is shorter and seldom is no block of its own
constexpr int kMaxRounds = 4000;

std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// A symbol stands for a run of instructions; the sequence of symbols is the program.
struct Symbols {
  std::vector<std::uint32_t> sequence, lengths;
};

class Finder {
 public:
  Finder(const Program& program, std::span<const std::uint32_t> order)
      : program_(program), order_(order), size_(order.size()) {}

  RepeatedBlocks run() {
    collect_tokens();
    classify_windows();
    Symbols symbols = runs();
    join_pairs(symbols);
    return blocks(symbols);
  }

 private:
  /// tokens_[i]: operation of order[i] and the arrays that it gives elements of.
  void collect_tokens() {
    std::vector<std::uint64_t> arrays(program_.code.size(), 0);
    for (std::size_t a = 0; a < program_.outputs.size(); ++a)
      for (const std::uint32_t v : program_.outputs[a].values) arrays[v] = mixed(arrays[v] + a + 1);
    place_.assign(program_.code.size(), kNone);
    for (std::uint32_t i = 0; i < size_; ++i) place_[order_[i]] = i;
    for (const std::uint32_t v : order_)
      tokens_.push_back(mixed(arrays[v] + static_cast<std::uint64_t>(program_.code[v].op)));
  }

  void classify_windows() {
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    classes_.resize(size_);
    for (std::size_t begin = 0; begin < size_; ++begin) {
      std::uint64_t hash = 0;
      const std::size_t end = std::min(begin + kWindow, size_);
      const auto within = [&](std::uint32_t v) -> std::uint64_t {
        return place_[v] != kNone && place_[v] >= begin ? place_[v] - begin + 1 : 0;
      };
      for (std::size_t i = begin; i < end; ++i) {
        const Instruction& c = program_.code[order_[i]];
        const int operands = operand_count(c.op);
        const std::uint64_t a = operands > 0 ? within(c.a) : 0, b = operands > 1 ? within(c.b) : 0;
        hash = mixed(hash ^ tokens_[i] ^ (a << 8) ^ (b << 20));
      }
      classes_[begin] = known.try_emplace(hash, static_cast<std::uint32_t>(known.size())).first->second;
    }
    class_count_ = known.size();
  }

  Symbols runs() const {
    constexpr std::uint32_t kMany = kNone - 1;
    std::vector<std::uint32_t> next(class_count_, kNone), previous(class_count_, kNone),
        count(class_count_, 0);
    const auto note = [](std::uint32_t& slot, std::uint32_t value) {
      if (slot == kNone) slot = value;
      if (slot != value) slot = kMany;
    };
    for (std::size_t i = 0; i < size_; ++i) {
      ++count[classes_[i]];
      if (i + 1 == size_) break;
      note(next[classes_[i]], classes_[i + 1]);
      note(previous[classes_[i + 1]], classes_[i]);
    }
    Symbols out;
    std::map<std::vector<std::uint64_t>, std::uint32_t> known;  // by tokens: classes are only hashes
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= size_; ++i) {
      if (i < size_ && i - begin < kMaxJoined && next[classes_[i - 1]] == classes_[i] &&
          previous[classes_[i]] == classes_[i - 1] && count[classes_[i - 1]] == count[classes_[i]])
        continue;
      std::vector<std::uint64_t> key(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                                     tokens_.begin() + static_cast<std::ptrdiff_t>(i));
      key.push_back(classes_[begin]);
      const auto [entry, fresh] = known.try_emplace(std::move(key), static_cast<std::uint32_t>(known.size()));
      if (fresh) out.lengths.push_back(static_cast<std::uint32_t>(i - begin));
      out.sequence.push_back(entry->second);
      begin = i;
    }
    return out;
  }

  static void join_pairs(Symbols& symbols) {
    struct Pair {
      std::uint64_t key;
      std::uint32_t count;
    };
    for (int round = 0; round < kMaxRounds; ++round) {
      std::vector<std::uint32_t>& sequence = symbols.sequence;
      std::unordered_map<std::uint64_t, std::uint32_t> counts;
      for (std::size_t i = 0; i + 1 < sequence.size(); ++i) {
        const std::uint32_t a = sequence[i], b = sequence[i + 1];
        if (symbols.lengths[a] + symbols.lengths[b] > kMaxJoined) continue;
        ++counts[static_cast<std::uint64_t>(a) << 32 | b];
        if (a == b && i + 2 < sequence.size() && sequence[i + 2] == a) ++i;  // aaa holds one pair
      }
      std::vector<Pair> pairs;
      for (const auto& [key, count] : counts)
        if (count >= kLeastRepeats) pairs.push_back({key, count});
      if (pairs.empty()) return;
      std::ranges::sort(pairs, [](const Pair& x, const Pair& y) {
        return x.count != y.count ? x.count > y.count : x.key < y.key;
      });
      // Of pairs that share a symbol only the most frequent one is joined in this round.
      std::vector<std::uint8_t> taken(symbols.lengths.size(), 0);
      std::unordered_map<std::uint64_t, std::uint32_t> joined;
      for (const Pair& pair : pairs) {
        if (2 * pair.count < pairs.front().count) break;
        const auto a = static_cast<std::uint32_t>(pair.key >> 32), b = static_cast<std::uint32_t>(pair.key);
        if (taken[a] != 0 || taken[b] != 0) continue;
        taken[a] = taken[b] = 1;
        joined.emplace(pair.key, static_cast<std::uint32_t>(symbols.lengths.size()));
        symbols.lengths.push_back(symbols.lengths[a] + symbols.lengths[b]);
      }
      std::vector<std::uint32_t> shorter;
      for (std::size_t i = 0; i < sequence.size(); ++i) {
        const auto found = i + 1 < sequence.size()
                               ? joined.find(static_cast<std::uint64_t>(sequence[i]) << 32 | sequence[i + 1])
                               : joined.end();
        shorter.push_back(found != joined.end() ? found->second : sequence[i]);
        if (found != joined.end()) ++i;
      }
      sequence = std::move(shorter);
    }
  }

  /// What repeats seldom or is short joins the code that does not repeat.
  RepeatedBlocks blocks(const Symbols& symbols) const {
    RepeatedBlocks out;
    out.order.assign(order_.begin(), order_.end());
    std::vector<std::uint32_t> count(symbols.lengths.size(), 0), block(symbols.lengths.size(), kNone);
    for (const std::uint32_t s : symbols.sequence) ++count[s];
    const auto repeats = [&](std::uint32_t s) {
      return count[s] > 1 && (symbols.lengths[s] >= kShort || count[s] >= kLeastRepeats);
    };
    std::uint32_t begin = 0;
    bool open = false;  // the last occurrence is of code that does not repeat
    for (const std::uint32_t s : symbols.sequence) {
      const std::uint32_t length = symbols.lengths[s];
      if (!repeats(s) && open && out.lengths.back() + length <= kMaxBlockLength) {
        out.lengths.back() += length;
      } else {
        if (!repeats(s) || block[s] == kNone) {
          block[s] = static_cast<std::uint32_t>(out.lengths.size());
          out.lengths.push_back(length);
        }
        out.occurrences.push_back({block[s], begin});
        open = !repeats(s);
      }
      begin += length;
    }
    return out;
  }

  const Program& program_;
  std::span<const std::uint32_t> order_;
  std::size_t size_, class_count_ = 0;
  std::vector<std::uint32_t> place_, classes_;
  std::vector<std::uint64_t> tokens_;
};

}  // namespace

std::size_t RepeatedBlocks::code() const {
  std::size_t total = 0;
  for (const std::uint32_t length : lengths) total += length;
  return total;
}

RepeatedBlocks find_repeated_blocks(const Program& program, std::span<const std::uint32_t> order) {
  if (order.empty()) return {};
  return Finder(program, order).run();
}

}  // namespace alembert

// Sets of (root, variable) pairs, as bits. A root mask times a variable mask would be smaller, but factoring
// makes edges whose sets are no such products.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alembert {

class PairSet {
 public:
  PairSet() = default;
  explicit PairSet(std::size_t pair_count) : words_((pair_count + 63) / 64) {}
  bool contains(std::size_t pair) const { return (words_[pair / 64] >> (pair % 64) & 1u) != 0; }
  void insert(std::size_t pair) { words_[pair / 64] |= std::uint64_t{1} << (pair % 64); }
  void erase(std::size_t pair) { words_[pair / 64] &= ~(std::uint64_t{1} << (pair % 64)); }
  void insert(const PairSet& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] |= other.words_[k];
  }
  void erase(const PairSet& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] &= ~other.words_[k];
  }
  bool includes(const PairSet& other) const {
    for (std::size_t k = 0; k < words_.size(); ++k)
      if ((other.words_[k] & ~words_[k]) != 0) return false;
    return true;
  }
  /// Calls visit(pair) in ascending order.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (std::size_t k = 0; k < words_.size(); ++k)
      for (std::uint64_t bits = words_[k]; bits != 0; bits &= bits - 1)
        visit(k * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace alembert

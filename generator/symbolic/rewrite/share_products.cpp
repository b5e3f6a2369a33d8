// Rewrite of stage `optimise`: products of several factors bracketed so that they share pairs. In: live nodes.
// Out: the same roots, with the pairs of factors that most products have in common multiplied once. See the
// header.
#include "symbolic/rewrite/share_products.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "support/operation.hpp"

namespace alembert {
namespace {

constexpr std::uint32_t kNoProduct = ~std::uint32_t{0};

/// Position of a node, or, from `first_pair` on, a pair of factors.
using FactorId = std::uint32_t;
using Pair = std::pair<FactorId, FactorId>;  ///< ascending

class ProductSharing : NodeRewrite {
 public:
  explicit ProductSharing(const LiveNodes& from) : NodeRewrite(from) {}

  std::optional<LiveNodes> run() {
    collect();
    if (!extract()) return std::nullopt;
    rewrite_nodes([this](std::uint32_t id) { return rewrite(id); });
    return finished();
  }

 private:
  static constexpr std::size_t kMaxFactors = 8;
  using Monomial = std::vector<FactorId>;  ///< ascending, with repetitions

  bool is_product(std::uint32_t id) const { return !is_constant(id) && op(id) == Operation::mul; }
  FactorId first_pair() const { return size(); }

  // The factors of every product that is used other than once in another product.
  void collect() {
    std::vector<char> inner(size(), 0);
    for (std::uint32_t id = 0; id < size(); ++id) {
      if (!is_product(id)) continue;
      for (const std::uint32_t operand : {operands(id).a >> 1, operands(id).b >> 1}) {
        if (uses_[operand] == 1 && is_product(operand)) inner[operand] = 1;
      }
    }
    // A product that was taken in is still built where another one had no room for it.
    monomial_of_.assign(size(), kNoProduct);
    for (std::uint32_t id = 0; id < size(); ++id) {
      if (!is_product(id)) continue;
      Monomial factors;
      for (const std::uint32_t operand : {operands(id).a >> 1, operands(id).b >> 1}) {
        const std::uint32_t part = monomial_of_[operand];
        if (part == kNoProduct || !inner[operand] || monomials_[part].size() + factors.size() > kMaxFactors) {
          factors.push_back(operand);
        } else {
          factors.insert(factors.end(), monomials_[part].begin(), monomials_[part].end());
        }
      }
      std::sort(factors.begin(), factors.end());
      monomial_of_[id] = static_cast<std::uint32_t>(monomials_.size());
      counted_.push_back(inner[id] == 0);
      monomials_.push_back(std::move(factors));
    }
  }

  static std::vector<Pair> pairs_of(const Monomial& factors) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      for (std::size_t j = i + 1; j < factors.size(); ++j) pairs.emplace_back(factors[i], factors[j]);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// A pair and the products that have it. Pairs of one product are left out: no other can come to have it.
  struct SharedPair {
    Pair pair;
    std::size_t count;                  ///< of the products below those that still have it
    std::vector<std::uint32_t> places;  ///< monomials that had it when it came up
  };
  using SharedPairs = std::vector<SharedPair>;  ///< ascending

  static SharedPairs shared_pairs(std::vector<std::pair<Pair, std::uint32_t>> occurrences) {
    std::sort(occurrences.begin(), occurrences.end());
    SharedPairs shared;
    for (std::size_t begin = 0, end = 0; begin < occurrences.size(); begin = end) {
      while (end < occurrences.size() && occurrences[end].first == occurrences[begin].first) ++end;
      if (end - begin < 2) continue;
      SharedPair& made = shared.emplace_back(SharedPair{occurrences[begin].first, end - begin, {}});
      for (std::size_t i = begin; i < end; ++i) made.places.push_back(occurrences[i].second);
    }
    return shared;
  }

  /// Takes out the most frequent pair again and again. False if no product is bracketed otherwise than it
  /// was.
  bool extract() {
    struct Entry {
      std::size_t count;
      Pair pair;
      bool operator<(const Entry& other) const {  // the most frequent first, then the earliest
        return count != other.count ? count < other.count : pair > other.pair;
      }
    };
    // A pair comes up with its second factor: [0] is of factors as given, the others of pairs in their order.
    std::vector<SharedPairs> shared(1);
    const auto find = [&](const Pair& pair) -> SharedPair* {
      SharedPairs& among = shared[pair.second < first_pair() ? 0 : pair.second - first_pair() + 1];
      const auto at = std::lower_bound(among.begin(), among.end(), pair,
                                       [](const SharedPair& x, const Pair& y) { return x.pair < y; });
      return at != among.end() && at->pair == pair ? &*at : nullptr;
    };
    std::priority_queue<Entry> queue;
    std::vector<std::pair<Pair, std::uint32_t>> occurrences;
    for (std::uint32_t m = 0; m < monomials_.size(); ++m) {
      if (!counted_[m]) continue;
      for (const Pair& pair : pairs_of(monomials_[m])) occurrences.emplace_back(pair, m);
    }
    shared[0] = shared_pairs(std::move(occurrences));
    for (const SharedPair& s : shared[0]) queue.push({s.count, s.pair});
    while (!queue.empty()) {
      const Entry top = queue.top();
      queue.pop();
      SharedPair& best = *find(top.pair);
      if (best.count < 2) continue;
      if (best.count != top.count) {
        queue.push({best.count, top.pair});
        continue;
      }
      const FactorId taken = first_pair() + static_cast<FactorId>(pairs_.size());
      pairs_.push_back(top.pair);
      occurrences.clear();
      const std::vector<std::uint32_t> places = std::move(best.places);
      best.count = 0;
      for (const std::uint32_t m : places) {
        Monomial& factors = monomials_[m];
        Monomial rest = factors;
        bool both = true;
        for (const FactorId f : {top.pair.first, top.pair.second}) {
          const auto at = std::find(rest.begin(), rest.end(), f);
          both = both && at != rest.end();
          if (at != rest.end()) rest.erase(at);
        }
        if (!both) continue;
        const std::vector<Pair> before = pairs_of(factors);
        rest.push_back(taken);
        factors = std::move(rest);
        const std::vector<Pair> after = pairs_of(factors);
        for (const Pair& pair : before) {
          if (pair == top.pair || std::binary_search(after.begin(), after.end(), pair)) continue;
          if (SharedPair* lost = find(pair)) --lost->count;
        }
        for (const Pair& pair : after) {
          if (pair.second == taken) occurrences.emplace_back(pair, m);
        }
      }
      shared.push_back(shared_pairs(std::move(occurrences)));
      for (const SharedPair& s : shared.back()) queue.push({s.count, s.pair});
    }
    return !pairs_.empty();
  }

  Ref built(FactorId factor) {
    if (factor < first_pair()) return image_[factor];
    const std::size_t p = factor - first_pair();
    if (built_.size() < pairs_.size()) built_.resize(pairs_.size());
    if (!built_[p]) {
      const Ref a = built(pairs_[p].first);
      const Ref b = built(pairs_[p].second);
      built_[p] = make(Operation::mul, a, b);
    }
    return *built_[p];
  }

  Ref rewrite(std::uint32_t id) {
    const std::uint32_t m = monomial_of_[id];
    if (m == kNoProduct || !counted_[m]) return copied(id);
    // The constant, which comes first in a product, last.
    const Monomial& factors = monomials_[m];
    Ref product = built(factors.back());
    for (std::size_t i = factors.size() - 1; i-- > 0;) {
      const Ref factor = built(factors[i]);
      product = make(Operation::mul, product, factor);
    }
    return product;
  }

  std::vector<Monomial> monomials_;
  std::vector<char> counted_;               ///< of each monomial: whether it is no part of another one
  std::vector<std::uint32_t> monomial_of_;  ///< by node; kNoProduct: no product
  std::vector<Pair> pairs_;
  std::vector<std::optional<Ref>> built_;
};

}  // namespace

std::optional<LiveNodes> share_products(const LiveNodes& nodes) {
  return ProductSharing(nodes).run();
}

}  // namespace alembert

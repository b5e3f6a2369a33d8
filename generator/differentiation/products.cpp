// Pairs of neighbours are counted once and kept up to date while lists shrink.
#include "differentiation/products.hpp"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>

namespace alembert {

namespace {

class ProductSharing {
 public:
  explicit ProductSharing(ExprGraph& graph) : graph_(graph) {}

  /// Adds a list; equal lists are added once. Returns its number.
  std::size_t add(const std::vector<Ref>& path) {
    std::vector<std::uint32_t> list;
    bool negative = false;
    for (const Ref factor : path) {
      if (factor.negative()) negative = !negative;
      if (Expr(graph_, Ref(factor.node(), false)).is_one()) continue;
      list.push_back(number(factor.node()));
    }
    const auto [at, is_new] = known_.try_emplace(list, lists_.size());
    if (is_new) lists_.push_back(list);
    results_.push_back({at->second, negative});
    return results_.size() - 1;
  }

  void share(std::uint64_t max_work) {
    for (std::size_t l = 0; l < lists_.size(); ++l) enter(l);
    announce();
    while (!queue_.empty() && work_ < max_work) {
      const Entry top = queue_.top();
      queue_.pop();
      const auto at = pairs_.find(key(top.x, top.y));
      if (at == pairs_.end() || at->second.count != top.count) continue;
      const Expr product = factor(top.x) * factor(top.y);
      const std::uint32_t replacement = number(product.ref().node());
      const bool negative = product.ref().negative();
      const std::set<std::size_t> places = at->second.lists;
      for (const std::size_t l : places) replace(l, top.x, top.y, replacement, negative);
      announce();
    }
  }

  Expr product(std::size_t path) const {
    const auto& [list, negative] = results_[path];
    Expr product = graph_.one();
    for (const std::uint32_t f : lists_[list]) product *= factor(f);
    return negative != flipped(list) ? -product : product;
  }

 private:
  struct Neighbours {
    std::uint32_t count = 0;
    std::set<std::size_t> lists;
    bool touched = false;
  };
  struct Entry {
    std::uint32_t count, x, y;
    bool operator<(const Entry& other) const {
      if (count != other.count) return count < other.count;
      return std::tuple(x, y) > std::tuple(other.x, other.y);
    }
  };

  static std::uint64_t key(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{std::min(x, y)} << 32 | std::max(x, y);
  }
  Expr factor(std::uint32_t f) const { return {graph_, Ref(nodes_[f], false)}; }
  bool flipped(std::size_t list) const { return list < flips_.size() && flips_[list]; }

  /// Factors are numbered as they first occur, so that nothing depends on node ids.
  std::uint32_t number(std::uint32_t node) {
    const auto [at, is_new] = numbers_.try_emplace(node, static_cast<std::uint32_t>(nodes_.size()));
    if (is_new) nodes_.push_back(node);
    return at->second;
  }

  void enter(std::size_t l) {
    const std::vector<std::uint32_t>& list = lists_[l];
    for (std::size_t k = 1; k < list.size(); ++k) {
      const std::uint64_t where = key(list[k - 1], list[k]);
      Neighbours& pair = pairs_[where];
      ++pair.count;
      pair.lists.insert(l);
      touch(where, pair);
    }
    work_ += list.size();
  }

  void withdraw(std::size_t l) {
    const std::vector<std::uint32_t>& list = lists_[l];
    for (std::size_t k = 1; k < list.size(); ++k) {
      const std::uint64_t where = key(list[k - 1], list[k]);
      Neighbours& pair = pairs_[where];
      --pair.count;
      pair.lists.erase(l);
      touch(where, pair);
    }
    work_ += list.size();
  }

  void replace(std::size_t l, std::uint32_t x, std::uint32_t y, std::uint32_t replacement, bool negative) {
    withdraw(l);
    std::vector<std::uint32_t>& list = lists_[l];
    std::size_t kept = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (k + 1 < list.size() && key(list[k], list[k + 1]) == key(x, y)) {
        list[kept++] = replacement;
        if (negative) {
          flips_.resize(lists_.size());
          flips_[l] = !flips_[l];
        }
        ++k;
      } else {
        list[kept++] = list[k];
      }
    }
    list.resize(kept);
    enter(l);
  }

  void touch(std::uint64_t where, Neighbours& pair) {
    if (pair.touched) return;
    pair.touched = true;
    touched_.push_back(where);
  }

  void announce() {
    for (const std::uint64_t where : touched_) {
      Neighbours& pair = pairs_[where];
      pair.touched = false;
      if (pair.count >= 2)
        queue_.push({pair.count, static_cast<std::uint32_t>(where >> 32), static_cast<std::uint32_t>(where)});
      if (pair.count == 0) pairs_.erase(where);
    }
    touched_.clear();
  }

  ExprGraph& graph_;
  std::vector<std::uint32_t> nodes_;                          // of each factor
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;  // node -> factor; looked up only
  std::vector<std::vector<std::uint32_t>> lists_;
  std::vector<bool> flips_;  // signs that products brought with them
  std::map<std::vector<std::uint32_t>, std::size_t> known_;
  std::vector<std::pair<std::size_t, bool>> results_;
  std::unordered_map<std::uint64_t, Neighbours> pairs_;  // looked up only
  std::vector<std::uint64_t> touched_;
  std::priority_queue<Entry> queue_;
  std::uint64_t work_ = 0;
};

}  // namespace

std::vector<Expr> shared_products(ExprGraph& graph, const std::vector<std::vector<Ref>>& paths,
                                  std::uint64_t max_work) {
  ProductSharing sharing(graph);
  for (const std::vector<Ref>& path : paths) sharing.add(path);
  sharing.share(max_work);
  std::vector<Expr> products;
  products.reserve(paths.size());
  for (std::size_t k = 0; k < paths.size(); ++k) products.push_back(sharing.product(k));
  return products;
}

}  // namespace alembert

// Compares bounds of rounding errors, see the header.
#include "symbolic/exactness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "symbolic/error_bound.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

namespace {

constexpr double kErrorFactor = 16;  // as the search for the shortest equations allows

}  // namespace

std::vector<std::vector<double>> points_near_and_far(ExprGraph& graph) {
  static constexpr double kSpreads[] = {1, 30, 3, 0.1, 10, 100};
  std::vector<std::vector<double>> points;
  std::mt19937_64 random(1);
  for (const double spread : kSpreads) {
    std::vector<double> point(graph.symbol_count());
    for (std::uint32_t i = 0; i < point.size(); ++i) {
      const Interval range = graph.bounds(graph.symbol_at(i).ref());
      const double unit = std::ldexp(static_cast<double>(random() >> 11), -53);
      point[i] = std::clamp(spread * (2 * unit - 1), range.lower, range.upper);
    }
    points.push_back(std::move(point));
  }
  return points;
}

bool is_as_exact(const Approximate& found, const Approximate& given) {
  if (!std::isfinite(given.value) || !std::isfinite(given.error)) return true;
  const double rounding = std::numeric_limits<double>::epsilon() * std::abs(given.value);
  return found.error <= kErrorFactor * std::max(given.error, rounding);
}

bool Exactness::keeps(std::span<const Expr> roots, std::size_t first) {
  if (points_.empty()) {
    points_ = points_near_and_far(*graph_of(roots_));
    given_ = evaluate_bounded(roots_, points_);
  }
  const std::vector<std::vector<Approximate>> found = evaluate_bounded(roots, points_);
  for (std::size_t k = 0; k < points_.size(); ++k)
    for (std::size_t i = 0; i < roots.size(); ++i)
      if (!is_as_exact(found[k][i], given_[k][first + i])) return false;
  return true;
}

}  // namespace alembert

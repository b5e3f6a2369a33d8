// Compares running error bounds (see the header).
#include "dynamics/choice/conditioning.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "dynamics/tree/state_values.hpp"
#include "symbolic/error_bound.hpp"

namespace alembert {

namespace {

constexpr unsigned kBoundedStates = 4;
constexpr double kWorse = 16;

}  // namespace

Conditioning::Conditioning(const Kinematics& kinematics, std::span<const Expr> plain) {
  for (unsigned seed = 1; seed <= kBoundedStates; ++seed)
    states_.push_back(state_values(kinematics.mechanism, kinematics.graph, seed));
  plain_ = evaluate_bounded(plain, states_);
  most_ = errors(plain_, true);
  const std::size_t n = static_cast<std::size_t>(kinematics.mechanism.nv);
  if (most_.size() == n * n && n > 1) {
    const std::vector<double> plain_bounds = most_;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        most_[i * n + j] =
            std::max(most_[i * n + j], std::sqrt(plain_bounds[i * n + i] * plain_bounds[j * n + j]));
    }
  }
  for (double& x : most_) x *= kWorse;
}

// Constants may have been rounded before, which no bound tells: then the values differ.
std::vector<double> Conditioning::errors(const std::vector<std::vector<Approximate>>& values,
                                         bool with_bounds) const {
  std::vector<double> worst(values.empty() ? 0 : values.front().size(), 0.0);
  for (std::size_t s = 0; s < values.size(); ++s) {
    for (std::size_t i = 0; i < worst.size(); ++i) {
      const Approximate &here = values[s][i], &plain = plain_[s][i];
      if (!std::isfinite(here.value)) continue;
      if (with_bounds) worst[i] = std::max(worst[i], here.error);
      if (std::isfinite(plain.value)) worst[i] = std::max(worst[i], std::abs(here.value - plain.value));
    }
  }
  return worst;
}

bool Conditioning::is_good(std::span<const Expr> values) const {
  return is_within(values, true);
}
bool Conditioning::has_values(std::span<const Expr> values) const {
  return is_within(values, false);
}
bool Conditioning::is_within(std::span<const Expr> values, bool with_bounds) const {
  const std::vector<double> found = errors(evaluate_bounded(values, states_), with_bounds);
  return std::equal(found.begin(), found.end(), most_.begin(), std::less_equal<>());
}

}  // namespace alembert

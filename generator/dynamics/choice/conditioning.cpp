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
  most_ = bounds(plain);
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

std::vector<double> Conditioning::bounds(std::span<const Expr> values) const {
  std::vector<double> worst(values.size(), 0.0);
  for (const std::vector<Approximate>& here : evaluate_bounded(values, states_)) {
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (std::isfinite(here[i].value)) worst[i] = std::max(worst[i], here[i].error);
    }
  }
  return worst;
}

bool Conditioning::is_good(std::span<const Expr> values) const {
  const std::vector<double> errors = bounds(values);
  return std::equal(errors.begin(), errors.end(), most_.begin(), std::less_equal<>());
}

}  // namespace alembert

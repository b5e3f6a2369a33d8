// Optimised candidates, counted (see the header).
#include "dynamics/choice/program_lengths.hpp"

#include <algorithm>

#include "symbolic/count_operations.hpp"

namespace alembert {

bool LengthTrend::is_above(std::size_t most, std::size_t stage, std::size_t operations) const {
  constexpr int kSeen = 4;
  constexpr double kSlack = 0.01;  // of what a list may do better than all before it
  return seen_ >= kSeen &&
         static_cast<double>(operations) * (least_[stage] - kSlack) > static_cast<double>(most);
}

void LengthTrend::add(const std::array<std::size_t, kOptimizeStages>& met, std::size_t in_the_end) {
  ++seen_;
  for (std::size_t stage = 0; stage < met.size(); ++stage)
    if (met[stage] > 0)
      least_[stage] =
          std::min(least_[stage], static_cast<double>(in_the_end) / static_cast<double>(met[stage]));
}

ProgramLengths::Key ProgramLengths::key_of(std::span<const Expr> values) {
  Key key;
  key.reserve(values.size());
  for (const Expr& value : values) key.push_back(value.ref().bits);
  return key;
}

const ProgramLengths::Measured& ProgramLengths::add(Key key, std::vector<Expr> optimized) {
  const OperationCount n = count_operations(optimized);
  return known_.emplace(std::move(key), Measured{{n.all(), n.total()}, std::move(optimized)}).first->second;
}

const ProgramLengths::Measured& ProgramLengths::measured(std::span<const Expr> values) {
  Key key = key_of(values);
  const auto known = known_.find(key);
  return known != known_.end() ? known->second : add(std::move(key), optimize(values));
}

std::optional<Length> ProgramLengths::within(std::size_t most, std::span<const Expr> values,
                                             LengthTrend& trend) {
  Key key = key_of(values);
  if (const auto known = known_.find(key); known != known_.end()) return known->second.length;
  if (const auto above = above_.find(key); above != above_.end() && most <= above->second)
    return std::nullopt;
  std::array<std::size_t, kOptimizeStages> met{};
  std::optional<std::vector<Expr>> optimized =
      optimize(values, [&](std::size_t stage, std::size_t operations) {
        met[stage] = operations;
        return !trend.is_above(most, stage, operations);
      });
  if (!optimized) {
    above_.insert_or_assign(std::move(key), most);
    return std::nullopt;
  }
  const Length length = add(std::move(key), *std::move(optimized)).length;
  trend.add(met, length.first);
  return length;
}

}  // namespace alembert

// Bounds and errors of operations, by their rows (see the header).
#include "support/operation.hpp"

namespace alembert {

Interval bounds_of(Operation op, Interval a, Interval b) {
  return use_row(op, interval::kWhole, [&](auto row) { return row.bounds(a, b); });
}

double error_bound(Operation op, Approximate a, Approximate b, double result) {
  if (!std::isfinite(a.value) || !std::isfinite(b.value) || !std::isfinite(result)) return rows::kInfinite;
  const double carried = use_row(op, rows::kInfinite, [&](auto row) { return row.carried(a, b, result); });
  // Below the smallest normal number there are fewer digits. Sums are exact there.
  constexpr double least = std::numeric_limits<double>::min();
  const bool has_roundings = facts(op).roundings > 0 && op != Operation::add && op != Operation::sub;
  const bool underflows =
      has_roundings && std::abs(result) < least && a.value != 0 && (operand_count(op) < 2 || b.value != 0);
  return carried + facts(op).roundings * kUnitRoundoff * std::abs(result) + (underflows ? least : 0);
}

}  // namespace alembert

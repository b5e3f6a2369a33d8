#include "dynamics/choice/candidates.hpp"

#include <algorithm>
#include <optional>

#include "symbolic/count_operations.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

void Candidates::add(const std::vector<Expr>& values) {
  std::vector<Expr> numbered = value_number(values);
  const std::size_t operations = count_operations(numbered).total();
  least_ = std::min(least_, operations);
  found_.emplace_back(operations, std::move(numbered));
}

void Candidates::add_recursions(
    const EquationsOfMotion& equations,
    const std::function<std::vector<Expr>(const WrittenTree&, FarPairs)>& values) {
  std::vector<WrittenTree> tried;
  const auto add_those_of = [&](const WrittenTree& tree) {
    if (std::find(tried.begin(), tried.end(), tree) != tried.end()) return;
    tried.push_back(tree);
    for (const FarPairs far : {FarPairs::meet, FarPairs::meet_sooner, FarPairs::carry}) {
      add(values(tree, far));
      if (found_.back().first > kLong) break;
    }
  };
  const auto is_short = [&] { return found_.empty() || found_.front().first <= kLong; };
  if (equations.articulated) add_those_of(*equations.articulated);
  if (equations.tree && is_short()) add_those_of(*equations.tree);
  if (!is_short()) return;
  add_those_of(kinematics_.tree);
  if (kinematics_.peeled) add_those_of(*kinematics_.peeled);
}

std::vector<Expr> Candidates::shortest() const {
  if (!kinematics_.graph.simplifies())
    return found_.front().second;  // what is left as written is not chosen by length
  std::size_t best = 0;
  std::optional<Length> shortest;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const auto& [operations, values] = found_[i];
    if (is_far_longer(operations, least_)) continue;
    const Length length = least_ > kCounted ? Length{operations, 0} : kinematics_.lengths.of(values);
    if (shortest && !(length < *shortest)) continue;
    shortest = length;
    best = i;
  }
  return found_[best].second;
}

}  // namespace alembert

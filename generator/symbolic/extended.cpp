// Evaluation with 50 digits (see the header).
#include "symbolic/extended.hpp"

#include <boost/math/constants/constants.hpp>

#include "symbolic/node_values.hpp"

namespace alembert {

struct ExtendedFunction::Order {
  Postorder nodes;
};

ExtendedFunction::ExtendedFunction(std::span<const Expr> roots) : roots_(roots.begin(), roots.end()) {
  if (!roots_.empty()) order_ = std::make_unique<const Order>(Order{indexed_postorder(roots_)});
}
ExtendedFunction::~ExtendedFunction() = default;
ExtendedFunction::ExtendedFunction(ExtendedFunction&&) noexcept = default;

std::size_t ExtendedFunction::nodes() const {
  return roots_.empty() ? 0 : order_->nodes.ids.size();
}

std::vector<Extended> ExtendedFunction::operator()(std::span<const Extended> symbols) const {
  std::vector<Extended> out;
  if (roots_.empty()) return out;
  const std::vector<Extended> values =
      node_values<Extended>(roots_[0].graph(), order_->nodes, symbols, boost::math::constants::pi<Extended>(),
                            [](const Rational& x) { return Extended(x.numerator) / x.denominator; });
  out.reserve(roots_.size());
  for (const Expr& root : roots_) {
    const Extended& value = values[order_->nodes.at(root.ref().node())];
    out.push_back(root.ref().negative() ? Extended(-value) : value);
  }
  return out;
}

std::vector<Extended> evaluate_extended(std::span<const Expr> roots, std::span<const Extended> symbols) {
  return ExtendedFunction(roots)(symbols);
}

std::vector<Extended> evaluate_extended(std::span<const Expr> roots, std::span<const double> symbols) {
  const std::vector<Extended> values(symbols.begin(), symbols.end());
  return evaluate_extended(roots, values);
}

Extended extended_value_of(Expr constant) {
  return evaluate_extended({&constant, 1}, std::span<const Extended>())[0];
}

}  // namespace alembert

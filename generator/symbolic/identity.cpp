// Proofs that expressions are zero (see the header).
#include "symbolic/identity.hpp"

#include <algorithm>

#include "symbolic/evaluate_modular.hpp"
#include "symbolic/extended.hpp"

namespace alembert {

std::vector<char> vanishing(std::span<const Expr> roots, double size) {
  std::vector<char> zero(roots.size(), 1);
  std::vector<Expr> constants, others;
  for (const Expr& root : roots) (root.is_constant() ? constants : others).push_back(root);
  const std::vector<Extended> numbers = evaluate_extended(constants, std::span<const Extended>());
  std::vector<char> other_zero(others.size(), 1);
  for (unsigned k = 0; k < kIdentityPoints; ++k) {
    if (std::find(other_zero.begin(), other_zero.end(), 1) == other_zero.end()) break;
    const std::vector<Modular> values =
        evaluate_modular(others, random_modular_point(others[0].graph().symbol_count(), 0x7a65726f + k));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!(values[i] == Modular{})) other_zero[i] = 0;
    }
  }
  std::size_t constant = 0, other = 0;
  for (std::size_t i = 0; i < roots.size(); ++i)
    zero[i] = roots[i].is_constant() ? abs(numbers[constant++]) <= kExtendedRounding * size
                                     : other_zero[other++] != 0;
  return zero;
}

bool vanishes(Expr x, double size) {
  return vanishing({&x, 1}, size)[0] != 0;
}

}  // namespace alembert

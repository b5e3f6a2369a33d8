// From polynomials back to expressions. In: a polynomial. Out: an expression of equal value, common factors
// pulled out of all terms, then the factor that most terms share, and so on.
#include <algorithm>

#include "symbolic/polynomial.hpp"

namespace alembert {
namespace {

bool has(const PolynomialTerm& term, Ref base, bool positive) {
  return std::any_of(term.powers.begin(), term.powers.end(), [&](const Power& power) {
    return power.base == base && (power.halves > 0) == positive;
  });
}

}  // namespace

Ref Algebra::expression(const PolynomialTerm& x) {
  Ref above = kOne, below = kOne;
  for (const Power& power : x.powers) {
    const int size = std::abs(power.halves);
    Ref factor = build_.integer_power(power.base, size / 2);
    if (size % 2 != 0) factor = build_.product(build_.function(Operation::sqrt, power.base), factor);
    Ref& side = power.halves > 0 ? above : below;
    side = build_.product(side, factor);
  }
  const Ref quotient = build_.quotient(above, below);
  return build_.product(x.number, quotient);
}

// Terms that differ in constants only become one term whose coefficient is one constant.
Polynomial Algebra::with_gathered_constants(const Polynomial& x) {
  struct Group {
    Monomial variable;
    Polynomial constants;
  };
  std::vector<Group> groups;
  bool any = false;
  for (const PolynomialTerm& term : x) {
    Monomial variable;
    PolynomialTerm constant{term.number, {}};
    for (const Power& power : term.powers) {
      (build_.constant(power.base) ? constant.powers : variable).push_back(power);
    }
    any = any || !constant.powers.empty();
    const auto at =
        std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.variable == variable; });
    if (at == groups.end()) {
      groups.push_back({variable, {constant}});
    } else {
      at->constants.push_back(constant);
    }
  }
  if (!any) return x;
  if (groups.size() == 1 && groups.front().variable.empty()) return x;  // a constant as a whole
  std::vector<PolynomialTerm> terms;
  for (const Group& group : groups) {
    const Ref coefficient = expression(sorted(group.constants));
    if (coefficient == kZero) continue;
    PolynomialTerm term{kOne, group.variable};
    const PolynomialTerm factor = monomial(coefficient);
    term.number = factor.number;
    // One constant, as a single base.
    const Ref rest = expression(PolynomialTerm{kOne, factor.powers});
    if (rest != kOne) put(term.powers, Builder::magnitude(rest), 2);
    if (rest.negative()) term.number = -term.number;
    terms.push_back(std::move(term));
  }
  return sorted(std::move(terms));
}

Ref Algebra::expression(const Polynomial& x) {
  return factored(with_gathered_constants(x));
}

Ref Algebra::factored(Polynomial x) {
  if (x.empty()) return kZero;
  if (x.size() == 1) return expression(x.front());
  spend(x.size());
  const PolynomialTerm common = common_factor(x);
  if (!common.powers.empty() || common.number != kOne) {
    const PolynomialTerm divisor = inverse(common);
    Polynomial rest = reduce(multiply(x, divisor));
    // Reduction may bring a factor back (the circle identities with constant angles do): it is taken out only
    // if that ends.
    const PolynomialTerm left = common_factor(rest);
    if (left.powers.empty() && left.number == kOne) {
      const Ref inside = factored(std::move(rest));
      const Ref outside = expression(common);
      return build_.product(outside, inside);
    }
  }
  // The factor that most terms have; numbers count as factors, after the others.
  struct Choice {
    Ref base;
    bool positive = true, number = false;
    std::size_t count = 1;
  } best;
  const auto consider = [&](const Choice& choice) {
    if (choice.count > best.count) best = choice;
  };
  std::vector<Choice> seen;
  const auto tally = [&](Ref base, bool positive, bool number) {
    for (Choice& choice : seen) {
      if (choice.base == base && choice.positive == positive && choice.number == number) {
        ++choice.count;
        return;
      }
    }
    seen.push_back({base, positive, number, 1});
  };
  for (const PolynomialTerm& term : x) {
    for (const Power& power : term.powers) tally(power.base, power.halves > 0, false);
  }
  for (const PolynomialTerm& term : x) {
    const Ref number = Builder::magnitude(term.number);
    if (number != kOne) tally(number, true, true);
  }
  // Ties go to the base that comes first by content, so that the order of terms does not matter.
  std::stable_sort(seen.begin(), seen.end(), [this](const Choice& p, const Choice& q) {
    if (p.number != q.number) return q.number;
    return build_.before(p.base, q.base);
  });
  for (const Choice& choice : seen) consider(choice);
  // A base of all terms was a common factor that would come back: nothing is gained by splitting then.
  if (best.count < 2 || best.count >= x.size()) {
    Ref sum = kZero;
    for (const PolynomialTerm& term : x) {
      const Ref next = expression(term);
      sum = build_.sum(sum, next);
    }
    return sum;
  }
  Polynomial with, without;
  for (PolynomialTerm& term : x) {
    const bool in =
        best.number ? Builder::magnitude(term.number) == best.base : has(term, best.base, best.positive);
    (in ? with : without).push_back(std::move(term));
  }
  const Ref inside = factored(std::move(with));
  const Ref outside = factored(std::move(without));
  return build_.sum(inside, outside);
}

}  // namespace alembert

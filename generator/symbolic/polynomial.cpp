// Arithmetic of polynomials in atoms. In and out: polynomials in descending order of their monomials.
#include "symbolic/polynomial.hpp"

#include <algorithm>
#include <cstdlib>

namespace alembert {
namespace {

int exponent_of(const Monomial& in, Ref base) {
  for (const Power& power : in) {
    if (power.base == base) return power.halves;
  }
  return 0;
}

}  // namespace

bool Algebra::less(const Monomial& x, const Monomial& y) const {
  for (std::size_t i = 0; i < x.size() || i < y.size(); ++i) {
    if (i == x.size()) return y[i].halves > 0;
    if (i == y.size()) return x[i].halves < 0;
    if (x[i].base == y[i].base) {
      if (x[i].halves != y[i].halves) return x[i].halves < y[i].halves;
    } else if (build_.before(x[i].base, y[i].base)) {
      return x[i].halves < 0;
    } else {
      return y[i].halves > 0;
    }
  }
  return false;
}

void Algebra::put(Monomial& into, Ref base, int halves) {
  const auto at = std::find_if(into.begin(), into.end(),
                               [&](const Power& power) { return !build_.before(power.base, base); });
  if (at == into.end() || at->base != base) {
    if (halves != 0) into.insert(at, {base, halves});
  } else {
    at->halves += halves;
    if (at->halves == 0) into.erase(at);
  }
}

// Multiplies x by base^(halves/2) and keeps it in normal form: numbers in front, products and quotients taken
// apart, no whole powers of a root or of an absolute value.
void Algebra::multiply_into(PolynomialTerm& x, Ref base, int halves) {
  struct Factor {
    Ref base;
    int halves;
  };
  std::vector<Factor> open{{base, halves}};
  constexpr int kMostHalves = 1 << 20;
  while (!open.empty()) {
    const Factor next = open.back();
    open.pop_back();
    if (next.halves == 0) continue;
    if (std::abs(next.halves) > kMostHalves) throw TooLarge();
    spend(1);
    Ref of = next.base;
    if (next.halves % 2 == 0) {
      if (of.negative()) {
        if (next.halves % 4 != 0) x.number = -x.number;
        of = Builder::magnitude(of);
      }
      const Node& node = build_.node(of);
      const bool plain_number = node.op == Operation::rational || node.op == Operation::real;
      if (plain_number) {
        const Ref power = build_.integer_power(of, next.halves / 2);
        x.number = exact(build_.product(x.number, power));
        continue;
      }
      if (node.op == Operation::pi_multiple && build_.rational_of(of) != Rational(1)) {
        open.push_back({build_.number(build_.rational_of(of)), next.halves});
        open.push_back({build_.pi(Rational(1)), next.halves});
        continue;
      }
      if (node.op == Operation::mul && node.a == node.b) {
        open.push_back({node.a, 2 * next.halves});
        continue;
      }
      if (node.op == Operation::mul || node.op == Operation::div) {
        open.push_back({node.a, next.halves});
        open.push_back({node.b, node.op == Operation::mul ? next.halves : -next.halves});
        continue;
      }
      if (node.op == Operation::sqrt && !node.a.negative()) {
        open.push_back({node.a, next.halves / 2});
        continue;
      }
      if (node.op == Operation::abs && next.halves % 4 == 0) {
        open.push_back({node.a, next.halves});
        continue;
      }
    }
    const int before = exponent_of(x.powers, of);
    const int after = before + next.halves;
    if (std::abs(after) > kMostHalves) throw TooLarge();
    // A root or an absolute value that became whole is taken apart again.
    const Operation op = build_.op(of);
    const bool composite =
        op == Operation::rational || op == Operation::mul || op == Operation::div || op == Operation::sqrt;
    if ((composite && before % 2 != 0 && after % 2 == 0) ||
        (op == Operation::abs && after != 0 && after % 4 == 0)) {
      put(x.powers, of, -before);
      open.push_back({of, after});
    } else {
      put(x.powers, of, next.halves);
    }
  }
}

Ref Algebra::exact(Ref number) const {
  // A rational that overflowed has become a double: what should cancel no longer does.
  if (build_.op(number) == Operation::real) throw TooLarge();
  return number;
}

PolynomialTerm Algebra::monomial(Ref x) {
  PolynomialTerm out{kOne, {}};
  multiply_into(out, x, 2);
  return out;
}

PolynomialTerm Algebra::multiply(const PolynomialTerm& x, const PolynomialTerm& y) {
  spend(1);
  PolynomialTerm out{exact(build_.product(x.number, y.number)), x.powers};
  for (const Power& power : y.powers) multiply_into(out, power.base, power.halves);
  return out;
}

PolynomialTerm Algebra::inverse(PolynomialTerm x) {
  PolynomialTerm out{build_.quotient(kOne, x.number), {}};
  for (const Power& power : x.powers) multiply_into(out, power.base, -power.halves);
  return out;
}

Polynomial Algebra::sorted(std::vector<PolynomialTerm> terms) {
  std::sort(terms.begin(), terms.end(),
            [this](const PolynomialTerm& x, const PolynomialTerm& y) { return less(y.powers, x.powers); });
  Polynomial out;
  for (PolynomialTerm& term : terms) {
    if (!out.empty() && out.back().powers == term.powers) {
      out.back().number = exact(build_.sum(out.back().number, term.number));
      if (out.back().number == kZero) out.pop_back();
    } else {
      out.push_back(std::move(term));
    }
  }
  return out;
}

Polynomial Algebra::add(const Polynomial& x, const Polynomial& y) {
  std::vector<PolynomialTerm> terms(x);
  terms.insert(terms.end(), y.begin(), y.end());
  return sorted(std::move(terms));
}

Polynomial Algebra::negated(Polynomial x) const {
  for (PolynomialTerm& term : x) term.number = -term.number;
  return x;
}

Polynomial Algebra::multiply(const Polynomial& x, const Polynomial& y) {
  std::vector<PolynomialTerm> terms;
  terms.reserve(x.size() * y.size());
  for (const PolynomialTerm& p : x) {
    for (const PolynomialTerm& q : y) terms.push_back(multiply(p, q));
  }
  return sorted(std::move(terms));
}

Polynomial Algebra::multiply(const Polynomial& x, const PolynomialTerm& y) {
  return multiply(x, Polynomial{y});
}

// Quotient of two terms if no exponent becomes negative that was not.
std::optional<PolynomialTerm> Algebra::divide(const PolynomialTerm& x, const PolynomialTerm& y) {
  for (const Power& power : y.powers) {
    if (power.halves > 0 && exponent_of(x.powers, power.base) < power.halves) return std::nullopt;
    if (power.halves < 0 && exponent_of(x.powers, power.base) > power.halves) return std::nullopt;
  }
  return multiply(x, inverse(y));
}

std::optional<Polynomial> Algebra::divide(const Polynomial& x, const Polynomial& y) {
  if (y.empty()) return std::nullopt;
  if (x.empty()) return x;
  constexpr std::size_t kMostSteps = 64;
  Polynomial rest = x, out;
  for (std::size_t step = 0; step < kMostSteps && !rest.empty(); ++step) {
    const auto next = divide(rest.front(), y.front());
    if (!next) return std::nullopt;
    const Monomial last = rest.front().powers;
    rest = add(rest, negated(multiply(y, *next)));
    // The leading term must go away; with powers of roots it need not.
    if (!rest.empty() && !less(rest.front().powers, last)) return std::nullopt;
    if (rest.size() > x.size() * y.size() + kMostSteps) return std::nullopt;
    out.push_back(*next);
  }
  if (!rest.empty()) return std::nullopt;
  return sorted(std::move(out));
}

std::optional<Polynomial> Algebra::square_root(const Polynomial& x) {
  if (x.empty()) return x;
  const auto root_of_term = [this](const PolynomialTerm& term) -> std::optional<PolynomialTerm> {
    if (term.number.negative() || !build_.rational(term.number)) return std::nullopt;
    const Ref root = build_.function(Operation::sqrt, term.number);
    if (!build_.rational(root)) return std::nullopt;
    PolynomialTerm out{root, term.powers};
    for (Power& power : out.powers) {
      if (power.halves % 4 != 0) return std::nullopt;
      power.halves /= 2;
    }
    return out;
  };
  const auto first = root_of_term(x.front());
  if (!first) return std::nullopt;
  // A square of k terms has at least 2k - 1 terms.
  const std::size_t most_terms = (x.size() + 1) / 2;
  Polynomial out{*first};
  Polynomial rest = add(x, negated(multiply(out, *first)));
  while (!rest.empty()) {
    if (out.size() >= most_terms) return std::nullopt;
    const PolynomialTerm twice{build_.product(build_.number(2), first->number), first->powers};
    const auto next = divide(rest.front(), twice);
    if (!next || !less(next->powers, out.back().powers)) return std::nullopt;
    // x - (q + t)^2 = (x - q^2) - 2 q t - t^2
    Polynomial added = multiply(out, *next);
    added = add(added, added);
    added = add(added, multiply(Polynomial{*next}, *next));
    const Monomial last = rest.front().powers;
    rest = add(rest, negated(added));
    if (!rest.empty() && !less(rest.front().powers, last)) return std::nullopt;
    out.push_back(*next);
  }
  return out;
}

PolynomialTerm Algebra::common_factor(const Polynomial& x) {
  PolynomialTerm out{kOne, {}};
  if (x.empty()) return out;
  for (const Power& power : x.front().powers) {
    int common = power.halves;
    for (const PolynomialTerm& term : x) {
      const int here = exponent_of(term.powers, power.base);
      common = common > 0 ? std::clamp(here, 0, common) : std::clamp(here, common, 0);
    }
    if (common != 0) out.powers.push_back({power.base, common});
  }
  const Ref number = Builder::magnitude(x.front().number);
  if (std::all_of(x.begin(), x.end(),
                  [&](const PolynomialTerm& term) { return Builder::magnitude(term.number) == number; })) {
    out.number = number;
  }
  return out;
}

}  // namespace alembert

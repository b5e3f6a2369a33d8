// Reduction of polynomials by sin^2 + cos^2 = 1 and cosh^2 - sinh^2 = 1. In: a polynomial. Out: one of equal
// value with as few terms as the candidates tried here have.
#include <algorithm>

#include "symbolic/polynomial.hpp"

namespace alembert {
namespace {

bool on_circle(Operation op) {
  return op == Operation::sin || op == Operation::cos;
}
bool on_hyperbola(Operation op) {
  return op == Operation::sinh || op == Operation::cosh;
}

std::size_t degree(const Polynomial& x) {
  std::size_t sum = 0;
  for (const PolynomialTerm& term : x) {
    for (const Power& power : term.powers) sum += static_cast<std::size_t>(std::abs(power.halves));
  }
  return sum;
}

bool simpler(const Polynomial& x, const Polynomial& y) {
  return x.size() != y.size() ? x.size() < y.size() : degree(x) < degree(y);
}

}  // namespace

std::vector<CirclePair> Algebra::circle_pairs(const Polynomial& x) {
  std::vector<CirclePair> out;
  for (const PolynomialTerm& term : x) {
    for (const Power& power : term.powers) {
      const Node node = build_.node(power.base);
      const bool hyperbolic = on_hyperbola(node.op);
      if (power.halves < 4 || !(on_circle(node.op) || hyperbolic)) continue;
      const bool known = std::any_of(out.begin(), out.end(), [&](const CirclePair& pair) {
        return pair.first == power.base || pair.second == power.base;
      });
      if (known) continue;
      const bool is_first = node.op == Operation::sin || node.op == Operation::cosh;
      const Operation partner_op = node.op == Operation::sin    ? Operation::cos
                                   : node.op == Operation::cos  ? Operation::sin
                                   : node.op == Operation::sinh ? Operation::cosh
                                                                : Operation::sinh;
      const Ref partner = build_.intern(partner_op, node.a, Ref());
      out.push_back({is_first ? power.base : partner, is_first ? partner : power.base, hyperbolic});
    }
  }
  std::sort(out.begin(), out.end(),
            [this](const CirclePair& p, const CirclePair& q) { return build_.before(p.first, q.first); });
  return out;
}

Polynomial Algebra::eliminated(Polynomial x, const std::vector<CirclePair>& pairs, unsigned second) {
  // A term with squares of k pairs becomes 2^k terms.
  const Polynomial original = x;
  const std::size_t most = 4 * x.size() + 64;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const CirclePair& pair = pairs[k];
    // first^2 = 1 - s second^2 and second^2 = s (1 - first^2), with s = 1 on the circle and -1 on the
    // hyperbola.
    const bool gone_is_second = (second >> k & 1u) != 0;
    const Ref gone = gone_is_second ? pair.second : pair.first,
              kept = gone_is_second ? pair.first : pair.second;
    const PolynomialTerm kept_square{pair.hyperbolic && !gone_is_second ? kOne : -kOne, {{kept, 4}}};
    const PolynomialTerm one{kOne, {}};
    Polynomial by = add(Polynomial{kept_square}, Polynomial{one});
    if (pair.hyperbolic && gone_is_second) by = negated(by);
    for (bool found = true; found;) {
      found = false;
      Polynomial done, open;
      for (PolynomialTerm& term : x) {
        const auto at = std::find_if(term.powers.begin(), term.powers.end(), [&](const Power& power) {
          return power.base == gone && power.halves >= 4;
        });
        if (at == term.powers.end()) {
          done.push_back(std::move(term));
          continue;
        }
        found = true;
        at->halves -= 4;
        if (at->halves == 0) term.powers.erase(at);
        open.push_back(std::move(term));
      }
      x = found ? add(done, multiply(open, by)) : std::move(done);
      if (x.size() > most) return original;
    }
  }
  return x;
}

// For every monomial m: a m + b m first^2 + c m second^2 loses one of its terms where two of them would go.
Polynomial Algebra::paired(Polynomial x, const std::vector<CirclePair>& pairs) {
  const auto find = [&](const Monomial& powers) {
    const auto at = std::lower_bound(
        x.begin(), x.end(), powers,
        [this](const PolynomialTerm& term, const Monomial& m) { return less(m, term.powers); });
    return at != x.end() && at->powers == powers ? at->number : kZero;
  };
  for (bool again = true; again;) {
    again = false;
    spend(x.size());
    for (const CirclePair& pair : pairs) {
      for (std::size_t i = 0; i < x.size() && !again; ++i) {
        for (const Ref base : {pair.first, pair.second}) {
          const auto power = std::find_if(x[i].powers.begin(), x[i].powers.end(),
                                          [&](const Power& p) { return p.base == base && p.halves >= 4; });
          if (power == x[i].powers.end()) continue;
          Monomial plain = x[i].powers;
          put(plain, base, -4);
          Monomial first = plain, second = plain;
          put(first, pair.first, 4);
          put(second, pair.second, 4);
          const Ref a = find(plain), b = find(first), c = find(second);
          const int terms = (a != kZero ? 1 : 0) + (b != kZero ? 1 : 0) + (c != kZero ? 1 : 0);
          if (terms < 2) continue;
          // Adding t (first^2 + s second^2 - 1) = 0 changes (a, b, c) to (a - t, b + t, c + s t).
          const auto signed_c = [&](Ref t) { return pair.hyperbolic ? -t : t; };
          const Ref options[] = {a, -b, -signed_c(c)};
          for (const Ref t : options) {
            if (t == kZero) continue;
            const Ref na = build_.sum(a, -t), nb = build_.sum(b, t), nc = build_.sum(c, signed_c(t));
            const int left = (na != kZero ? 1 : 0) + (nb != kZero ? 1 : 0) + (nc != kZero ? 1 : 0);
            if (left >= terms) continue;
            Polynomial change;
            if (na != a) change.push_back({-t, plain});
            change.push_back({t, first});
            change.push_back({signed_c(t), second});
            x = add(x, sorted(std::move(change)));
            again = true;
            break;
          }
          if (again) break;
        }
      }
      if (again) break;
    }
  }
  return x;
}

Polynomial Algebra::reduce(const Polynomial& x) {
  const std::vector<CirclePair> pairs = circle_pairs(x);
  if (pairs.empty()) return x;
  constexpr std::size_t kMostPairs = 24;
  Polynomial best = paired(x, pairs);
  const auto consider = [&](const Polynomial& candidate) {
    // Elimination brings in squares of the partner: pairs are those of the candidate and the original
    // together.
    Polynomial made = paired(candidate, pairs);
    if (simpler(made, best)) best = std::move(made);
  };
  if (best.size() < 2) return best;
  if (pairs.size() <= kMostPairs) {
    consider(eliminated(x, pairs, 0));
    consider(eliminated(x, pairs, ~0u));
    if (pairs.size() > 1) {
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::vector<CirclePair> one{pairs[k]};
        consider(eliminated(best, one, 0));
        consider(eliminated(best, one, 1));
      }
    }
  }
  return best;
}

}  // namespace alembert

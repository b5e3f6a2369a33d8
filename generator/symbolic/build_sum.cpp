// Rules of construction for sums. In: two operands with signs. Out: their sum in normal form: operands
// ordered by content, the first one positive, the sign outside.
#include <algorithm>
#include <array>
#include <cmath>

#include "symbolic/builder.hpp"

namespace alembert {
namespace {

// The factors of a product of at most kMost factors.
struct Factors {
  static constexpr std::size_t kMost = 8;
  std::array<Ref, kMost> at;
  std::size_t size = 0;
  bool complete = true;
};

Factors factors(const ExprGraph& graph, Ref x) {
  Factors out;
  std::array<Ref, Factors::kMost> open;
  std::size_t waiting = 0;
  open[waiting++] = Builder::magnitude(x);
  while (waiting > 0) {
    const Ref next = open[--waiting];
    const Node& node = graph.node(next.node());
    if (node.op == Operation::mul) {
      if (out.size + waiting + 2 > Factors::kMost) {
        out.complete = false;
        return out;
      }
      open[waiting++] = node.b;
      open[waiting++] = node.a;
    } else {
      out.at[out.size++] = next;
    }
  }
  return out;
}

void erase(Factors& from, std::size_t i) {
  for (std::size_t k = i + 1; k < from.size; ++k) from.at[k - 1] = from.at[k];
  --from.size;
}

// Removes one occurrence of x, if there is one.
bool take(Factors& from, Ref x) {
  for (std::size_t i = 0; i < from.size; ++i) {
    if (from.at[i] == x) {
      erase(from, i);
      return true;
    }
  }
  return false;
}

bool same(Factors x, Factors y) {
  if (x.size != y.size) return false;
  const auto by_id = [](Ref p, Ref q) { return p.bits < q.bits; };  // for comparison only
  std::sort(x.at.begin(), x.at.begin() + x.size, by_id);
  std::sort(y.at.begin(), y.at.begin() + y.size, by_id);
  return std::equal(x.at.begin(), x.at.begin() + x.size, y.at.begin());
}

// What is left of doubles that cancel to this fraction is rounding.
constexpr double kCancellation = 0x1p-48;

}  // namespace

Ref Builder::intern_sum(Ref a, Ref b) {
  if (before(b, a)) std::swap(a, b);
  return a.negative() ? -intern(Operation::add, -a, -b) : intern(Operation::add, a, b);
}

// Sum of two numbers, unless it has no exact form of its own (1 + pi), or what is left as it was written has none.
std::optional<Ref> Builder::fold_sum(Ref a, Ref b) {
  if (op(a) == op(b) && op(a) != Operation::real) {
    if (const auto exact = add(rational_of(a), rational_of(b)))
      return rational(a) ? number(*exact) : pi(*exact);
  } else if (op(a) != Operation::real && op(b) != Operation::real) {
    return std::nullopt;
  }
  if (!graph.simplifies_) return std::nullopt;
  const double x = numeric_value(a), sum = x + numeric_value(b);
  return std::abs(sum) < kCancellation * std::abs(x) ? kZero : real(sum);
}

Ref Builder::sum(Ref a, Ref b) {
  if (a == kZero) return b;
  if (b == kZero) return a;
  if (a.node() == b.node()) return a == b ? product(number(2), a) : kZero;
  const Nested nested(*this);
  if (too_deep()) return intern_sum(a, b);
  if (before(b, a)) std::swap(a, b);

  if (numeric(a) && numeric(b)) {
    if (const auto folded = fold_sum(a, b)) return *folded;
    return intern_sum(a, b);
  }
  if (constant(a) && constant(b) && !graph.simplifies_) return intern_sum(a, b);
  const Operation oa = op(a), ob = op(b);
  if (graph.keeps_brackets_) {
    if (numeric(a) && ob == Operation::add) {
      if (const auto found = sum_with_nested(a, b)) return *found;
    }
    return intern_sum(a, b);
  }
  const bool product_a = oa == Operation::mul || oa == Operation::div,
             product_b = ob == Operation::mul || ob == Operation::div;
  if (product_a || product_b) {
    // Like terms: c*x + d*x.
    const Term ta = term(a), tb = term(b);
    if (ta.rest == tb.rest) {
      const Ref coefficient = sum(ta.coefficient, tb.coefficient);
      return product(coefficient, ta.rest);
    }
    if (ob == Operation::mul) {
      if (const auto found = pythagorean(a, b)) return *found;
    }
  }
  if (ob == Operation::add) {
    if (const auto found = sum_with_nested(a, b)) return *found;
  }
  if (oa == Operation::add) {
    if (const auto found = sum_with_nested(b, a)) return *found;
    if (ob == Operation::add) {
      if (const auto found = sum_of_sums(a, b)) return *found;
    }
  }
  return intern_sum(a, b);
}

// a + (p + q): constants are gathered, multiples of pi (offsets of angles) move outward, terms that cancel go
// away.
std::optional<Ref> Builder::sum_with_nested(Ref a, Ref b) {
  const Ref p = signed_as(node(b).a, b.negative()), q = signed_as(node(b).b, b.negative());
  if (a == -p) return q;
  if (a == -q) return p;
  if (constant(p)) {
    const bool fold =
        numeric(a) && numeric(p) && (op(a) == op(p) || op(a) == Operation::real || op(p) == Operation::real);
    if (fold || (constant(a) && !constant(q))) {
      const Ref gathered = sum(a, p);
      return sum(gathered, q);
    }
    if (op(p) == Operation::pi_multiple && !constant(a)) {
      const Ref rest = sum(a, q);
      return sum(p, rest);
    }
  }
  if (op(a) != Operation::mul) return std::nullopt;
  // c*x + (d*x + q): never more operations, because both coefficients were multiplications.
  const Term ta = term(a);
  if (magnitude(ta.coefficient) == kOne) return std::nullopt;
  for (const bool first : {true, false}) {
    const Ref like = first ? p : q, other = first ? q : p;
    if (op(like) != Operation::mul) continue;
    const Term tl = term(like);
    if (tl.rest != ta.rest || magnitude(tl.coefficient) == kOne) continue;
    const Ref coefficient = sum(ta.coefficient, tl.coefficient);
    const Ref joined = product(coefficient, ta.rest);
    return sum(joined, other);
  }
  return std::nullopt;
}

// (p + q) + (r + s) where two terms cancel.
std::optional<Ref> Builder::sum_of_sums(Ref a, Ref b) {
  const Ref p = signed_as(node(a).a, a.negative()), q = signed_as(node(a).b, a.negative());
  const Ref r = signed_as(node(b).a, b.negative()), s = signed_as(node(b).b, b.negative());
  if (p == -r) return sum(q, s);
  if (p == -s) return sum(q, r);
  if (q == -r) return sum(p, s);
  if (q == -s) return sum(p, r);
  return std::nullopt;
}

// f sin^2 + f cos^2 = f,  f cosh^2 - f sinh^2 = f, and, for a constant f, f - f sin^2 = f cos^2, f - f cos^2
// = f sin^2.
std::optional<Ref> Builder::pythagorean(Ref a, Ref b) {
  const bool lone = constant(a), multiplied = op(a) == Operation::mul;
  if (!lone && !multiplied) return std::nullopt;
  Factors fb = factors(graph, b);
  if (!fb.complete || fb.size < 2) return std::nullopt;
  // A squared function among the factors of b.
  std::size_t at = fb.size;
  for (std::size_t i = 0; i + 1 < fb.size && at == fb.size; ++i) {
    const Operation o = op(fb.at[i]);
    if (o != Operation::sin && o != Operation::cos && o != Operation::sinh && o != Operation::cosh) continue;
    for (std::size_t k = i + 1; k < fb.size; ++k) {
      if (fb.at[k] == fb.at[i]) at = i;
    }
  }
  if (at == fb.size) return std::nullopt;
  Factors fa = magnitude(a) == kOne ? Factors() : factors(graph, a);
  if (!fa.complete) return std::nullopt;
  for (; at + 1 < fb.size; ++at) {
    const Ref squared = fb.at[at];
    const Operation o = op(squared);
    if (o != Operation::sin && o != Operation::cos && o != Operation::sinh && o != Operation::cosh) continue;
    Factors rest = fb;
    erase(rest, at);
    if (!take(rest, squared)) continue;
    const bool hyperbolic = o == Operation::sinh || o == Operation::cosh;
    const Operation partner_op = o == Operation::sin    ? Operation::cos
                                 : o == Operation::cos  ? Operation::sin
                                 : o == Operation::sinh ? Operation::cosh
                                                        : Operation::sinh;
    const Ref argument = node(squared).a;
    if (lone && !hyperbolic && a.negative() != b.negative() && same(rest, fa)) {
      const Ref partner = function(partner_op, argument);
      const Ref square = product(partner, partner);
      return product(a, square);
    }
    if (!multiplied || (a.negative() != b.negative()) != hyperbolic) continue;
    for (std::size_t i = 0; i < fa.size; ++i) {
      if (op(fa.at[i]) != partner_op || node(fa.at[i]).a != argument) continue;
      Factors remaining = fa;
      const Ref partner = fa.at[i];
      erase(remaining, i);
      if (!take(remaining, partner) || !same(remaining, rest)) break;
      Ref common = kOne;
      for (std::size_t k = 0; k < remaining.size; ++k) common = product(common, remaining.at[k]);
      // cosh^2 carries the sign of the whole.
      return signed_as(common, o == Operation::cosh ? b.negative() : a.negative());
    }
  }
  return std::nullopt;
}

}  // namespace alembert

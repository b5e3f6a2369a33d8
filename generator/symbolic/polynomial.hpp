// Polynomials in atoms: the form in which expressions are compared and rearranged by `simplify`. In:
// expressions. Out: sums of terms number * product of base^(halves/2), where a base is any node that is no
// product (a symbol, a function, a sum kept whole, the radicand of a root) and exponents may be negative.
// Private to this room.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "symbolic/builder.hpp"

namespace alembert {

struct Power {
  Ref base;    // unsigned; a rational only under a root (halves == 1)
  int halves;  // twice the exponent, never 0
  friend bool operator==(const Power&, const Power&) = default;
};
using Monomial = std::vector<Power>;  // ordered by Builder::before on the bases

struct PolynomialTerm {
  Ref number;  // rational or real with sign, never 0
  Monomial powers;
};
using Polynomial = std::vector<PolynomialTerm>;  // descending in `Algebra::less`, no two terms alike

/// A function pair that obeys first^2 + sign * second^2 = 1: (sin, cos) or (cosh, sinh).
struct CirclePair {
  Ref first, second;  // nodes; second is made where it is missing
  bool hyperbolic;
};

/// Thrown where a polynomial would grow beyond what is worth its time; whoever simplifies keeps what it had.
struct TooLarge {};

class Algebra {
 public:
  /// Throws TooLarge once `budget` steps (about one for each term touched) are done.
  Algebra(ExprGraph& graph, std::size_t budget) : build_(graph), budget_(budget) {}

  /// x as one term, without multiplying out sums: products, quotients and roots are taken apart.
  PolynomialTerm monomial(Ref x);
  Polynomial polynomial(Ref x) { return x == kZero ? Polynomial() : Polynomial{monomial(x)}; }

  Polynomial add(const Polynomial& x, const Polynomial& y);
  Polynomial negated(Polynomial x) const;
  Polynomial multiply(const Polynomial& x, const Polynomial& y);
  Polynomial multiply(const Polynomial& x, const PolynomialTerm& y);
  PolynomialTerm inverse(PolynomialTerm x);
  /// x/y if that is a polynomial.
  std::optional<Polynomial> divide(const Polynomial& x, const Polynomial& y);
  /// q with q^2 = x, if there is one; its sign is arbitrary.
  std::optional<Polynomial> square_root(const Polynomial& x);
  /// Greatest monomial by which every term can be divided, with the common magnitude of all numbers if there
  /// is one.
  PolynomialTerm common_factor(const Polynomial& x);

  /// The same value with fewest terms, as far as sin^2 + cos^2 = 1 and cosh^2 - sinh^2 = 1 give it.
  Polynomial reduce(const Polynomial& x);
  /// Pairs of which a square occurs in x.
  std::vector<CirclePair> circle_pairs(const Polynomial& x);
  /// x with all squares of the one function (or the other) of these pairs replaced; bit k of `second` chooses
  /// for pair k.
  Polynomial eliminated(Polynomial x, const std::vector<CirclePair>& pairs, unsigned second);

  /// The expression of a term, and of a polynomial with common factors pulled out, the most frequent one
  /// first.
  Ref expression(const PolynomialTerm& x);
  Ref expression(const Polynomial& x);

  Builder& builder() { return build_; }
  /// Steps done so far.
  std::size_t work() const { return work_; }

  bool less(const Monomial& x, const Monomial& y) const;  ///< lexicographic, compatible with products

 private:
  Ref exact(Ref number) const;  ///< the number itself; throws TooLarge if it is a rounded one
  void multiply_into(PolynomialTerm& x, Ref base, int halves);
  void put(Monomial& into, Ref base, int halves);
  PolynomialTerm multiply(const PolynomialTerm& x, const PolynomialTerm& y);
  Polynomial sorted(std::vector<PolynomialTerm> terms);
  std::optional<PolynomialTerm> divide(const PolynomialTerm& x, const PolynomialTerm& y);
  Polynomial paired(Polynomial x, const std::vector<CirclePair>& pairs);
  Polynomial with_gathered_constants(const Polynomial& x);
  Ref factored(Polynomial x);

  void spend(std::size_t steps) {
    work_ += steps;
    if (work_ > budget_) throw TooLarge();
  }

  Builder build_;
  std::size_t work_ = 0, budget_;
};

}  // namespace alembert

// Exact evaluation: the field, roots, the circle, what is told apart.
#include <cmath>
#include <limits>

#include "symbolic/evaluate_modular.hpp"
#include "symbolic/modular.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"

namespace alembert {
namespace {

constexpr std::uint64_t kPrime = modular::kPrime;

Modular random_element(TestRandom& random) {
  return {random.next() % kPrime, random.next() % kPrime};
}

TEST(Modular, FieldLaws) {
  TestRandom random(3);
  for (int i = 0; i < 2000; ++i) {
    const Modular x = random_element(random), y = random_element(random), z = random_element(random);
    EXPECT_EQ(modular::multiply(x, modular::add(y, z)),
              modular::add(modular::multiply(x, y), modular::multiply(x, z)));
    EXPECT_EQ(modular::multiply(x, modular::multiply(y, z)), modular::multiply(modular::multiply(x, y), z));
    EXPECT_EQ(modular::multiply(x, modular::inverse(x)), (Modular{1, 0}));
    EXPECT_EQ(modular::multiply(x.re, modular::inverse(x.re)), 1u);
    EXPECT_TRUE(modular::is_zero(modular::add(x, modular::negate(x))));
    EXPECT_NE(modular::is_upper(x), modular::is_upper(modular::negate(x)));
  }
  EXPECT_EQ(modular::multiply(kPrime - 1, kPrime - 1), 1u);
  EXPECT_EQ(modular::add(kPrime - 1, 1), 0u);
  EXPECT_EQ(modular::inverse(0), 0u);
  EXPECT_EQ(modular::inverse(1), 1u);
  EXPECT_EQ(modular::inverse(kPrime - 1), kPrime - 1);
}

TEST(Modular, Roots) {
  TestRandom random(4);
  for (int i = 0; i < 500; ++i) {
    const Modular x = random_element(random), square = modular::multiply(x, x);
    const auto root = modular::root(square);
    ASSERT_TRUE(root);
    EXPECT_EQ(modular::multiply(*root, *root), square);
    EXPECT_FALSE(modular::is_upper(*root));
    const Modular base{x.re, 0};  // every element of the prime field has a root
    const auto real_root = modular::root(base);
    ASSERT_TRUE(real_root);
    EXPECT_EQ(modular::multiply(*real_root, *real_root), base);
  }
  EXPECT_EQ(modular::root({0, 0}), (Modular{0, 0}));
  // About half of the larger field has no root, and says so.
  int without = 0;
  for (int i = 0; i < 500; ++i) without += modular::root(random_element(random)) ? 0 : 1;
  EXPECT_NEAR(without, 250, 60);
}

TEST(Modular, Numbers) {
  ExprGraph g;
  const auto value = [](Expr x) { return evaluate_modular(std::vector<Expr>{x}, {})[0]; };
  EXPECT_EQ(value(g.integer(-1)), (Modular{kPrime - 1, 0}));
  EXPECT_EQ(modular::multiply(value(g.rational({3, 7})), {7, 0}), (Modular{3, 0}));
  ExprGraph h;
  const double third = 1.0 / 3.0;
  const Expr x = h.real(third);
  EXPECT_EQ(h.node(x.ref().node()).op, Operation::real);
  // A double stands for itself only, so that a residue of rounding is not taken for a number: 2^61 = 1 in
  // this field.
  EXPECT_EQ(value(-x).re, kPrime - value(x).re);
  EXPECT_NE(value(h.real(0x1p-62)), value(h.rational(Rational(1, 2))));
  EXPECT_NE(value(h.real(0x1p-61)), value(h.one()));
}

TEST(Modular, CircleAndHyperbola) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = g.symbol("y"), w = x * y - sqrt(y);
  const std::vector<Expr> roots{sin(w), cos(w), tan(w), sinh(w), cosh(w), tanh(w), sin(g.zero() - w),
                                cos(-w)};
  const std::vector<Modular> v = evaluate_modular(roots, random_modular_point(2, 9));
  const auto square = [](Modular m) { return modular::multiply(m, m); };
  EXPECT_EQ(modular::add(square(v[0]), square(v[1])), (Modular{1, 0}));
  EXPECT_EQ(modular::multiply(v[2], v[1]), v[0]);
  EXPECT_EQ(modular::add(square(v[4]), modular::negate(square(v[3]))), (Modular{1, 0}));
  EXPECT_EQ(modular::multiply(v[5], v[4]), v[3]);
  EXPECT_EQ(v[6], modular::negate(v[0]));
  EXPECT_EQ(v[7], v[1]);
}

// Equal arguments that are different nodes still give equal values.
TEST(Modular, FunctionsSeeValues) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = g.symbol("y");
  const Expr p = (x + y) * (x + y), q = x * x + g.integer(2) * x * y + y * y, n = (y - x) * (x - y),
             m = (x - y) * (x - y);
  ASSERT_NE(p, q);
  const std::vector<Expr> roots{sin(p),      sin(q),      exp(p),  exp(q),  sqrt(p + x), sqrt(q + x),
                                atan2(p, x), atan2(q, x), sin(n),  -sin(m), abs(n + x),  abs(x - m),
                                pow(p, x),   pow(q, x),   sign(n), sign(-m)};
  const std::vector<Modular> v = evaluate_modular(roots, random_modular_point(2, 5));
  for (std::size_t i = 0; i < v.size(); i += 2) EXPECT_EQ(v[i], v[i + 1]) << to_string(roots[i]);
}

TEST(Modular, TellsApart) {
  ExprGraph g;
  const Expr x = g.symbol("x"), y = g.symbol("y");
  const std::vector<Expr> different{
      x,         y,         x + y,       x * y,       x / y,   sin(x),  cos(x),   tan(x),  asin(x),   acos(x),
      atan(x),   exp(x),    log(x),      sinh(x),     cosh(x), tanh(x), abs(x),   sign(x), sqrt(x),   sqrt(y),
      pow(x, y), pow(y, x), atan2(x, y), atan2(y, x), g.pi(),  g.one(), g.zero(), sin(y),  sin(x + y)};
  const std::vector<Modular> v = evaluate_modular(different, random_modular_point(2, 6));
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(v[i], v[k]) << to_string(different[i]) << " " << to_string(different[k]);
  }
}

TEST(Modular, PointsAreReproducible) {
  EXPECT_EQ(random_modular_point(5, 1), random_modular_point(5, 1));
  EXPECT_NE(random_modular_point(5, 1), random_modular_point(5, 2));
  ExprGraph g;
  EXPECT_THROW(evaluate_modular(std::vector<Expr>{g.symbol("x")}, {}), std::out_of_range);
  EXPECT_TRUE(evaluate_modular({}, {}).empty());
}

}  // namespace
}  // namespace alembert

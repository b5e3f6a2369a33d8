// What equations of motion need of simplification: twists of rotations, and frames of surfaces that become
// products of plane rotations.
#include "symbolic/matrix.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/same.hpp"
#include "symbolic/simplify.hpp"

namespace alembert {
namespace {

Mat3 plane_rotation(ExprGraph& g, std::size_t axis, Expr angle, int derivatives = 0) {
  Mat3 out = derivatives == 0 ? identity3(g) : zeros<3, 3>(g);
  const std::size_t i = (axis + 1) % 3, k = (axis + 2) % 3;
  const Expr c = derivatives == 0 ? cos(angle) : -sin(angle), s = derivatives == 0 ? sin(angle) : cos(angle);
  out(i, i) = c;
  out(k, k) = c;
  out(i, k) = -s;
  out(k, i) = s;
  return out;
}

std::vector<Expr> twist(const Mat3& e, const Mat3& de) {
  const Mat3 skew = transpose(e) * de;
  return {skew(2, 1), skew(0, 2), skew(1, 0)};
}

void expect_same(const std::vector<Expr>& found, const std::vector<Expr>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_TRUE(same(found[i], expected[i])) << "entry " << i;
}

TEST(Frames, TwistsOfEulerAngles) {
  ExprGraph g;
  const Expr q1 = g.symbol("q1"), q2 = g.symbol("q2"), q3 = g.symbol("q3");
  const Mat3 z1 = plane_rotation(g, 2, q1), x2 = plane_rotation(g, 0, q2), z3 = plane_rotation(g, 2, q3);
  const Mat3 e = z1 * x2 * z3;
  expect_same(simplify(twist(e, plane_rotation(g, 2, q1, 1) * x2 * z3)),
              {sin(q2) * sin(q3), sin(q2) * cos(q3), cos(q2)});
  expect_same(simplify(twist(e, z1 * plane_rotation(g, 0, q2, 1) * z3)), {cos(q3), -sin(q3), g.zero()});
  expect_same(simplify(twist(e, z1 * x2 * plane_rotation(g, 2, q3, 1))), {g.zero(), g.zero(), g.one()});
}

TEST(Frames, TwistThroughConstantRotation) {
  ExprGraph g;
  const Expr q1 = g.symbol("q1"), q2 = g.symbol("q2"), alpha = g.rational({3, 10});
  const Mat3 constant = plane_rotation(g, 0, alpha), z2 = plane_rotation(g, 2, q2);
  const Mat3 e = plane_rotation(g, 2, q1) * constant * z2;
  expect_same(simplify(twist(e, plane_rotation(g, 2, q1, 1) * constant * z2)),
              {sin(alpha) * sin(q2), sin(alpha) * cos(q2), cos(alpha)});
}

TEST(Frames, RotationsAreOrthogonal) {
  ExprGraph g;
  Mat3 e = identity3(g);
  for (std::size_t k = 0; k < 4; ++k) e = e * plane_rotation(g, k % 3, g.symbol(numbered('q', k)));
  const Mat3 product = transpose(e) * e, unit = identity3(g);
  expect_same(simplify(std::vector<Expr>(product.entries.begin(), product.entries.end())),
              std::vector<Expr>(unit.entries.begin(), unit.entries.end()));
}

// f(u, v) = [(R + r cos v) cos u, (R + r cos v) sin u, r sin v] and its frame [p0 p1 n].
void expect_torus_frame(ExprGraph& g, Expr big, Expr small, bool expanded) {
  const Expr u = g.symbol("u"), v = g.symbol("v"), su = sin(u), cu = cos(u), sv = sin(v), cv = cos(v);
  const Expr reach = big + small * cv;
  Vec3 fu, fv;
  fu[0] = expanded ? -(big * su + small * (cv * su)) : -(reach * su);
  fu[1] = expanded ? big * cu + cv * (small * cu) : reach * cu;
  fu[2] = g.zero();
  fv[0] = -(small * sv * cu);
  fv[1] = -(small * sv * su);
  fv[2] = small * cv;
  const Expr length = sqrt(dot(fu, fu));
  expect_same(simplify(std::vector<Expr>{length}), {reach});
  Vec3 p0;
  for (std::size_t i = 0; i < 3; ++i) p0[i] = fu[i] / length;
  const Vec3 normal = cross(p0, fv);
  const Expr size = sqrt(dot(normal, normal));
  Vec3 n;
  for (std::size_t i = 0; i < 3; ++i) n[i] = normal[i] / size;
  const Vec3 p1 = cross(n, p0);
  expect_same(simplify(std::vector<Expr>{p0[0], p0[1], p0[2], p1[0], p1[1], p1[2], n[0], n[1], n[2]}),
              {-su, cu, g.zero(), -(cu * sv), -(su * sv), cv, cu * cv, su * cv, sv});
  // The columns are those of Rz(u) times a rotation in the plane of v.
  const Mat3 turn = plane_rotation(g, 2, u);
  Mat3 tilt = zeros<3, 3>(g);
  tilt(1, 0) = g.one();
  tilt(0, 1) = -sv;
  tilt(2, 1) = cv;
  tilt(0, 2) = cv;
  tilt(2, 2) = sv;
  const Mat3 frame = turn * tilt;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Expr> row = simplify(std::vector<Expr>{p0[i], p1[i], n[i]});
    expect_same(row, {frame(i, 0), frame(i, 1), frame(i, 2)});
  }
}

TEST(Frames, TorusWithNumbers) {
  for (const bool expanded : {false, true}) {
    ExprGraph g;
    expect_torus_frame(g, g.integer(2), g.rational({1, 2}), expanded);
  }
}

TEST(Frames, TorusWithBoundedSymbols) {
  for (const bool expanded : {false, true}) {
    ExprGraph g;
    const Expr big = g.symbol("R"), small = g.symbol("r");
    g.assume(big, {1, 4});
    g.assume(small, {0.125, 0.875});
    expect_torus_frame(g, big, small, expanded);
  }
}

TEST(Frames, TorusWithoutBoundsKeepsTheAbsoluteValue) {
  ExprGraph g;
  const Expr big = g.symbol("R"), small = g.symbol("r"), u = g.symbol("u"), v = g.symbol("v");
  const Expr reach = big + small * cos(v);
  const Expr length = sqrt(reach * sin(u) * (reach * sin(u)) + reach * cos(u) * (reach * cos(u)));
  EXPECT_TRUE(same(simplify(std::vector<Expr>{length})[0], abs(reach)));
}

TEST(Frames, Sphere) {
  ExprGraph g;
  const Expr r = g.symbol("r"), u = g.symbol("u"), v = g.symbol("v");
  g.assume(r, {0.5, 1});
  g.assume(v, {-1.5, 1.5});
  // Tangents of r [cos u cos v, sin u cos v, sin v].
  const std::vector<Expr> fv{-(r * cos(u) * sin(v)), -(r * sin(u) * sin(v)), r * cos(v)};
  Expr sum = g.zero();
  for (const Expr& e : fv) sum += e * e;
  EXPECT_TRUE(same(simplify(std::vector<Expr>{sqrt(sum)})[0], r));
}

}  // namespace
}  // namespace alembert

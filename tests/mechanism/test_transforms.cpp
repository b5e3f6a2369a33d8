// Transform factors one by one.
#include <gtest/gtest.h>

#include "mechanism/loaded.hpp"
#include "mechanism/mate.hpp"

namespace alembert {
namespace {

using test::error_of;
using test::factors;
using test::Loaded;
using test::with_transform;

template <typename T>
const T& only(const Loaded& loaded) {
  EXPECT_EQ(factors(loaded).size(), 1u);
  return std::get<T>(factors(loaded).at(0).value);
}
Vec3 vector(Expr x, Expr y, Expr z) {
  Vec3 v;
  v[0] = x, v[1] = y, v[2] = z;
  return v;
}

TEST(Transforms, Translate) {
  Loaded loaded(with_transform("[{translate: [q, 1/2, -q^2]}]"));
  const Expr q = loaded.symbol("q");
  EXPECT_EQ(only<Translation>(loaded).offset, vector(q, loaded.number(1, 2), -(q * q)));
  EXPECT_EQ(factors(loaded)[0].where.line, 5);
}

TEST(Transforms, RotateAboutAxes) {
  const char* names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    Loaded loaded(with_transform("[{rotate: {axis: " + std::string(names[axis]) + ", angle: 2*q}}]"));
    EXPECT_EQ(only<AxisRotation>(loaded).axis, axis);
    EXPECT_EQ(only<AxisRotation>(loaded).angle, loaded.number(2) * loaded.symbol("q"));
  }
}

TEST(Transforms, RotateAboutVectorsAlongAxes) {
  Loaded loaded(
      with_transform("[{rotate: {axis: [0, 3, 0], angle: q}}, {rotate: {axis: [0, 1 - 1, -2], angle: q}}]"));
  const auto& along = std::get<AxisRotation>(factors(loaded)[0].value);
  EXPECT_EQ(along.axis, 1);
  EXPECT_EQ(along.angle, loaded.symbol("q"));
  const auto& against = std::get<AxisRotation>(factors(loaded)[1].value);
  EXPECT_EQ(against.axis, 2);
  EXPECT_EQ(against.angle, -loaded.symbol("q"));
}

TEST(Transforms, NormaliseVectorsExactly) {
  Loaded loaded(with_transform("[{rotate: {axis: [3, 0, -4], angle: q}}]"));
  EXPECT_EQ(only<VectorRotation>(loaded).axis,
            vector(loaded.number(3, 5), loaded.number(0), loaded.number(-4, 5)));
  Loaded irrational(with_transform("[{rotate: {axis: [1, 1, 0], angle: q}}]"));
  const Vec3& axis = only<VectorRotation>(irrational).axis;
  EXPECT_EQ(axis[0], irrational.number(1) / sqrt(irrational.number(2)));
}

TEST(Transforms, RotateByQuaternion) {
  Loaded loaded(with_transform("[{translate: [q, 0, 0]}, {rotate: {quaternion: b}}]",
                               "[q, {name: b, type: quaternion}]"));
  EXPECT_EQ(std::get<QuaternionRotation>(factors(loaded)[1].value).coordinate, 1);
}

TEST(Transforms, Matrix) {
  Loaded loaded(
      with_transform("[{matrix: [[cos(q), -sin(q), 0, 1], [sin(q), cos(q), 0, 2], [0, 0, 1, q]]}]"));
  const RigidMatrix& m = only<RigidMatrix>(loaded);
  EXPECT_EQ(m.rotation(1, 0), sin(loaded.symbol("q")));
  EXPECT_EQ(m.rotation(0, 1), -sin(loaded.symbol("q")));
  EXPECT_EQ(m.translation, vector(loaded.number(1), loaded.number(2), loaded.symbol("q")));
}

TEST(Transforms, MatrixMayHaveALimitedDomain) {
  EXPECT_EQ(error_of(with_transform(
                "[{matrix: [[sqrt(1 - q^2), -q, 0, 0], [q, sqrt(1 - q^2), 0, 0], [0, 0, 1, 0]]}]",
                "[{name: q, initial: 0.9}]")),
            "");
}

TEST(Transforms, MatrixIsCheckedAwayFromTheInitialState) {
  const std::string error = error_of(
      with_transform("[{matrix: [[1, 0, 0, q], [0, cos(q), -sin(q)*cos(q), 0], [0, sin(q), cos(q), 0]]}]"));
  EXPECT_NE(error.find("is not a rotation at a state near the initial one"), std::string::npos) << error;
}

TEST(Transforms, Curve) {
  Loaded loaded(with_transform("[{curve: {point: [cos(q), sin(q), q], along: q, frame: frenet}}]"));
  const CurveFrame& curve = only<CurveFrame>(loaded);
  EXPECT_EQ(curve.along, loaded.symbol("q"));
  EXPECT_EQ(curve.point[0], cos(loaded.symbol("q")));
  EXPECT_FALSE(curve.reference.has_value());
  Loaded without(with_transform("[{curve: {point: [cos(q), sin(q), q], along: q}}]"));
  EXPECT_FALSE(only<CurveFrame>(without).reference.has_value());
}

TEST(Transforms, CurveWithReference) {
  Loaded loaded(with_transform("[{curve: {point: [q, 0, 0], along: q, frame: {reference: [0, 0, 1]}}}]"));
  ASSERT_TRUE(only<CurveFrame>(loaded).reference.has_value());
  EXPECT_EQ(*only<CurveFrame>(loaded).reference,
            vector(loaded.number(0), loaded.number(0), loaded.number(1)));
}

TEST(Transforms, Surface) {
  Loaded loaded(with_transform(
      "[{surface: {point: [u, v, u*v], along: [u, v]}}, {surface: {point: [u, v, 0], along: [v, u], "
      "flip: true}}]",
      "[u, v]"));
  const auto& one = std::get<SurfaceFrame>(factors(loaded)[0].value);
  EXPECT_EQ(one.u, loaded.symbol("u"));
  EXPECT_EQ(one.v, loaded.symbol("v"));
  EXPECT_FALSE(one.flip);
  const auto& two = std::get<SurfaceFrame>(factors(loaded)[1].value);
  EXPECT_EQ(two.u, loaded.symbol("v"));
  EXPECT_TRUE(two.flip);
}

TEST(Transforms, Mate) {
  const std::string sides =
      "mate: [{surface: {point: [u, v, 0], along: [u, v]}}, {surface: {point: [a, b, 0], along: [a, b], "
      "flip: true}}]";
  Loaded loaded(with_transform("[{" + sides + ", spin: 2*s}]", "[u, v, a, b, s]"));
  ASSERT_EQ(factors(loaded).size(), kMateFactors);
  const Mate mate = mate_at(loaded.mechanism.bodies.at(0).transform, 0).value();
  EXPECT_FALSE(mate.first.flip);
  EXPECT_TRUE(mate.second.flip);
  EXPECT_EQ(mate.second.u, loaded.symbol("a"));
  EXPECT_EQ(mate.spin, loaded.number(2) * loaded.symbol("s"));
  Loaded without(with_transform("[{" + sides + "}]", "[u, v, a, b]"));
  EXPECT_TRUE(mate_at(without.mechanism.bodies.at(0).transform, 0).value().spin.is_zero());
}

TEST(Transforms, Inverse) {
  Loaded loaded(
      with_transform("[{inverse: [{translate: [1, 0, 0]}, {inverse: [{rotate: {axis: x, angle: q}}]}]}]"));
  ASSERT_EQ(factors(loaded).size(), 2u);
  EXPECT_EQ(std::get<AxisRotation>(factors(loaded)[0].value).axis, 0);
  EXPECT_FALSE(factors(loaded)[0].inverse) << "inverted twice";
  EXPECT_TRUE(std::holds_alternative<Translation>(factors(loaded)[1].value));
  EXPECT_TRUE(factors(loaded)[1].inverse);
}

TEST(Transforms, CoordinatesInsideAnInverseAreUsed) {
  EXPECT_EQ(
      error_of(with_transform("[{inverse: [{translate: [p, 0, 0]}]}, {translate: [q, 0, 0]}]", "[q, p]")),
      "");
}

}  // namespace
}  // namespace alembert

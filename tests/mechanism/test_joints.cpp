// Joints: the factors that each stands for.
#include <gtest/gtest.h>

#include "mechanism/loaded.hpp"

namespace alembert {
namespace {

using test::factors;
using test::Loaded;
using test::with_transform;

std::string with_joint(const std::string& joint, const std::string& coordinates) {
  return with_transform("[{joint: {" + joint + "}}]", coordinates);
}
void expect_rotation(const Factor& factor, int axis, Expr angle) {
  const auto* rotation = std::get_if<AxisRotation>(&factor.value);
  ASSERT_NE(rotation, nullptr);
  EXPECT_EQ(rotation->axis, axis);
  EXPECT_EQ(rotation->angle, angle);
}
void expect_shift(const Factor& factor, Expr x, Expr y, Expr z) {
  const auto* translation = std::get_if<Translation>(&factor.value);
  ASSERT_NE(translation, nullptr);
  EXPECT_EQ(translation->offset[0], x);
  EXPECT_EQ(translation->offset[1], y);
  EXPECT_EQ(translation->offset[2], z);
}

TEST(Joints, Revolute) {
  Loaded loaded(with_joint("type: revolute, coordinates: [q]", "[q]"));
  ASSERT_EQ(factors(loaded).size(), 1u);
  expect_rotation(factors(loaded)[0], 2, loaded.symbol("q"));
  Loaded about_y(with_joint("type: revolute, axis: y, coordinates: [q]", "[q]"));
  expect_rotation(factors(about_y)[0], 1, about_y.symbol("q"));
  Loaded against(with_joint("type: revolute, axis: [-1, 0, 0], coordinates: [q]", "[q]"));
  expect_rotation(factors(against)[0], 0, -against.symbol("q"));
  Loaded skew(with_joint("type: revolute, axis: [0, 3, 4], coordinates: [q]", "[q]"));
  EXPECT_EQ(std::get<VectorRotation>(factors(skew)[0].value).axis[2], skew.number(4, 5));
}

TEST(Joints, Prismatic) {
  Loaded loaded(with_joint("type: prismatic, axis: [0, -3, 4], coordinates: [q]", "[q]"));
  ASSERT_EQ(factors(loaded).size(), 1u);
  const Expr q = loaded.symbol("q");
  expect_shift(factors(loaded)[0], loaded.number(0), loaded.number(-3, 5) * q, loaded.number(4, 5) * q);
}

TEST(Joints, Helical) {
  Loaded loaded(with_joint("type: helical, axis: x, pitch: 0.01/(2*pi), coordinates: [q]", "[q]"));
  ASSERT_EQ(factors(loaded).size(), 2u);
  const Expr q = loaded.symbol("q"), zero = loaded.number(0);
  expect_rotation(factors(loaded)[0], 0, q);
  const Expr pitch = loaded.number(1, 100) / (loaded.number(2) * loaded.graph.pi());
  expect_shift(factors(loaded)[1], pitch * q, zero, zero);
}

TEST(Joints, Cylindrical) {
  Loaded loaded(with_joint("type: cylindrical, coordinates: [turn, out]", "[out, turn]"));
  ASSERT_EQ(factors(loaded).size(), 2u);
  const Expr zero = loaded.number(0);
  expect_rotation(factors(loaded)[0], 2, loaded.symbol("turn"));
  expect_shift(factors(loaded)[1], zero, zero, loaded.symbol("out"));
}

TEST(Joints, Universal) {
  Loaded loaded(with_joint("type: universal, coordinates: [a, b]", "[a, b]"));
  ASSERT_EQ(factors(loaded).size(), 2u);
  expect_rotation(factors(loaded)[0], 0, loaded.symbol("a"));
  expect_rotation(factors(loaded)[1], 1, loaded.symbol("b"));
  Loaded other(with_joint("type: universal, axes: [z, [0, -1, 0]], coordinates: [a, b]", "[a, b]"));
  expect_rotation(factors(other)[0], 2, other.symbol("a"));
  expect_rotation(factors(other)[1], 1, -other.symbol("b"));
}

TEST(Joints, Planar) {
  Loaded loaded(with_joint("type: planar, coordinates: [x, y, a]", "[x, y, a]"));
  ASSERT_EQ(factors(loaded).size(), 2u);
  expect_shift(factors(loaded)[0], loaded.symbol("x"), loaded.symbol("y"), loaded.number(0));
  expect_rotation(factors(loaded)[1], 2, loaded.symbol("a"));
}

TEST(Joints, Spherical) {
  Loaded loaded(with_joint("type: spherical, coordinates: [b]", "[{name: b, type: quaternion}]"));
  ASSERT_EQ(factors(loaded).size(), 1u);
  EXPECT_EQ(std::get<QuaternionRotation>(factors(loaded)[0].value).coordinate, 0);
}

TEST(Joints, Free) {
  Loaded loaded(
      with_joint("type: free, coordinates: [x, y, z, b]", "[x, y, z, {name: b, type: quaternion}]"));
  ASSERT_EQ(factors(loaded).size(), 2u);
  expect_shift(factors(loaded)[0], loaded.symbol("x"), loaded.symbol("y"), loaded.symbol("z"));
  EXPECT_EQ(std::get<QuaternionRotation>(factors(loaded)[1].value).coordinate, 3);
  EXPECT_EQ(loaded.mechanism.nq, 7);
  EXPECT_EQ(loaded.mechanism.nv, 6);
}

TEST(Joints, KeepTheirPlace) {
  Loaded loaded(with_joint("type: revolute, coordinates: [q]", "[q]"));
  EXPECT_EQ(factors(loaded)[0].where.line, 5);
  EXPECT_EQ(factors(loaded)[0].where.column, 46);
}

}  // namespace
}  // namespace alembert

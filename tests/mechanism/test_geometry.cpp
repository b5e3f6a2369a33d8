// Shapes of bodies: sizes, curves and surfaces over names of their own, transforms and colours.
#include <gtest/gtest.h>

#include "mechanism/loaded.hpp"

namespace alembert {
namespace {

using test::error_of;
using test::Loaded;

/// A description whose body `arm` has the shapes given (a flow list).
std::string with_geometry(const std::string& geometry) {
  return "alembert: 1\nname: one\nparameters: {r: 0.25, k: {value: 3, runtime: true}}\n"
         "coordinates: [q]\ngravity: [r, k, 0]\ndefinitions: {w: 2*r}\n"
         "bodies:\n  - {name: arm, mass: w, transform: [{translate: [q, 0, 0]}], geometry: " +
         geometry + "}\n";
}
const Shape& shape(const Loaded& loaded, std::size_t i = 0) {
  return loaded.mechanism.bodies.at(0).geometry.at(i);
}

TEST(Geometry, IsEmptyUnlessGiven) {
  EXPECT_TRUE(Loaded(test::with_transform("[{translate: [q, 0, 0]}]")).mechanism.bodies[0].geometry.empty());
  EXPECT_TRUE(Loaded(with_geometry("[]")).mechanism.bodies[0].geometry.empty());
}

TEST(Geometry, ReadsEveryKindInOrder) {
  Loaded loaded(with_geometry(
      "[{box: [1, r, w]}, {sphere: k/2}, {ellipsoid: [1, 2, 3]}, {cylinder: {radius: r, length: 2}}, "
      "{capsule: {length: 3, radius: 1}}, {torus: {radius: 1, tube: 0.1}}]"));
  const auto& shapes = loaded.mechanism.bodies[0].geometry;
  ASSERT_EQ(shapes.size(), 6u);
  const std::pair<ShapeKind, std::vector<double>> expected[] = {
      {ShapeKind::box, {1, 0.25, 0.5}}, {ShapeKind::sphere, {1.5}},   {ShapeKind::ellipsoid, {1, 2, 3}},
      {ShapeKind::cylinder, {0.25, 2}}, {ShapeKind::capsule, {1, 3}}, {ShapeKind::torus, {1, 0.1}},
  };
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(shapes[i].kind, expected[i].first) << i;
    EXPECT_EQ(shapes[i].sizes, expected[i].second) << i;
    EXPECT_TRUE(shapes[i].transform.factors.empty());
    EXPECT_FALSE(shapes[i].color.has_value());
    EXPECT_EQ(shapes[i].where.line, 8);
  }
}

TEST(Geometry, ReadsTubes) {
  Loaded loaded(with_geometry(
      "[{tube: {curve: [cos(s), r*sin(s), k*s], along: s, range: [-pi, 2*pi], radius: 0.01}}]"));
  const Expr s = loaded.symbol("s");
  EXPECT_EQ(shape(loaded).kind, ShapeKind::tube);
  EXPECT_EQ(shape(loaded).u, s);
  EXPECT_EQ(shape(loaded).point[0], cos(s));
  EXPECT_EQ(shape(loaded).point[1], loaded.number(1, 4) * sin(s));
  EXPECT_EQ(shape(loaded).point[2], loaded.symbol("k") * s);
  EXPECT_DOUBLE_EQ(shape(loaded).u_range[0], -3.14159265358979323846);
  EXPECT_DOUBLE_EQ(shape(loaded).u_range[1], 6.28318530717958647693);
  EXPECT_EQ(shape(loaded).sizes, std::vector<double>{0.01});
}

TEST(Geometry, ReadsSurfaces) {
  Loaded loaded(
      with_geometry("[{surface: {point: [a, b, \"sqrt(a^2 + b^2)/a\"], along: [a, b], range: [[0, 1], [r, "
                    "k]]}}, {surface: {point: [b, a, 0], along: [b, a], range: [[0, 1], [0, 2]]}}]"));
  EXPECT_EQ(shape(loaded).u, loaded.symbol("a"));
  EXPECT_EQ(shape(loaded).v, loaded.symbol("b"));
  EXPECT_EQ(shape(loaded).v_range, (std::array<double, 2>{0.25, 3}));
  EXPECT_TRUE(shape(loaded).sizes.empty());
  EXPECT_EQ(shape(loaded, 1).u, loaded.symbol("b"));
}

TEST(Geometry, KeepsNamesOfAShapeToItself) {
  EXPECT_NE(error_of(with_geometry(
                         "[{tube: {curve: [s, 0, 0], along: s, range: [0, 1], radius: 1}}, {tube: {curve: "
                         "[s, x, 0], along: x, range: [0, 1], radius: 1}}]"))
                .find("unknown name 's'"),
            std::string::npos);
}

TEST(Geometry, ReadsTransformsAndColours) {
  Loaded loaded(
      with_geometry("[{sphere: 1, color: [1, 0, r], transform: [{translate: [k, 0, 0]}, {rotate: {axis: x, "
                    "angle: pi/2}}]}]"));
  ASSERT_EQ(shape(loaded).transform.factors.size(), 2u);
  EXPECT_EQ(std::get<Translation>(shape(loaded).transform.factors[0].value).offset[0], loaded.symbol("k"));
  EXPECT_EQ(shape(loaded).color, (std::array<double, 3>{1, 0, 0.25}));
}

TEST(Geometry, DoesNotCountAsMotion) {
  // A coordinate that moves only a shape's transform moves no body; the shape is to blame.
  EXPECT_NE(
      error_of("alembert: 1\nname: one\ncoordinates: [q, p]\nbodies:\n  - {name: arm, mass: 1, transform: "
               "[{translate: [q, 0, 0]}], geometry: [{sphere: 1, transform: [{translate: [p, 0, 0]}]}]}\n")
          .find("must be constant"),
      std::string::npos);
}

}  // namespace
}  // namespace alembert

// Meshes: closed, facing outwards, with normals of length 1, and of the volumes that polyhedra of their kind
// have.
#include "viewer/mesh.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "viewer/swept_mesh.hpp"

namespace alembert {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

struct Named {
  std::string name;
  Mesh mesh;
  double most;    ///< volume of the polyhedron where it is known, otherwise of the solid it is inscribed in
  double within;  ///< relative
};

constexpr double kRounding = 2e-6;  // coordinates are of single precision

/// Volume between regular n-gons whose radius changes linearly along z from point to point of a meridian:
/// n/2 sin(2 pi/n) times the sum of (r0^2 + r0 r1 + r1^2)/3 (z1 - z0).
double revolved(const std::vector<Eigen::Vector2d>& meridian, int n) {
  double sum = 0;
  for (std::size_t j = 0; j + 1 < meridian.size(); ++j) {
    const double r0 = meridian[j][0], r1 = meridian[j + 1][0];
    sum += (r0 * r0 + r0 * r1 + r1 * r1) / 3 * (meridian[j + 1][1] - meridian[j][1]);
  }
  return n / 2.0 * std::sin(2 * pi / n) * sum;
}

/// Meridian of `count` equal turns of a circle from an angle on, its centre off the axis and at a height.
std::vector<Eigen::Vector2d> arc(double off, double height, double radius, double from, double turn,
                                 int count) {
  std::vector<Eigen::Vector2d> out;
  for (int j = 0; j <= count; ++j) {
    const double angle = from + turn * j / count;
    out.emplace_back(off + radius * std::cos(angle), height + radius * std::sin(angle));
  }
  return out;
}

double sphere_polyhedron(double radius, int n) {
  return revolved(arc(0, 0, radius, -pi / 2, pi, n / 2), n);
}

double capsule_polyhedron(double radius, double length, int n) {
  std::vector<Eigen::Vector2d> meridian = arc(0, -length / 2, radius, -pi / 2, pi / 2, n / 4);
  const std::vector<Eigen::Vector2d> upper = arc(0, length / 2, radius, 0, pi / 2, n / 4);
  meridian.insert(meridian.end(), upper.begin(), upper.end());
  return revolved(meridian, n);
}

Vector3d torus_point(double u, double v) {
  return {(1.1 + 0.35 * std::cos(v)) * std::cos(u), (1.1 + 0.35 * std::cos(v)) * std::sin(u),
          0.35 * std::sin(v)};
}

std::vector<Named> closed_meshes() {
  const double sphere = 4 * pi / 3;
  const auto circle = [](double s) { return Vector3d(std::cos(s), std::sin(s), 0); };
  // A closed curve that leaves its plane: its cross-section comes back turned.
  const auto knot = [](double s) {
    return Vector3d((2 + std::cos(3 * s)) * std::cos(2 * s), (2 + std::cos(3 * s)) * std::sin(2 * s),
                    std::sin(3 * s));
  };
  double knot_length = 0;
  for (int i = 0; i < 20000; ++i)
    knot_length += (knot(2 * pi * (i + 1) / 20000) - knot(2 * pi * i / 20000)).norm();
  const auto ball = [](double u, double v) {
    return Vector3d(std::cos(u) * std::sin(v), std::sin(u) * std::sin(v), std::cos(v));
  };
  return {
      {"box", box_mesh({2, 3, 5}), 30, kRounding},
      {"sphere", ellipsoid_mesh({0.5, 0.5, 0.5}), sphere_polyhedron(0.5, 40), kRounding},
      {"ellipsoid", ellipsoid_mesh({1, 0.4, 0.2}), 0.08 * sphere_polyhedron(1, 40), kRounding},
      {"cylinder", cylinder_mesh(0.3, 2), revolved({{0.3, 0}, {0.3, 2}}, 40), kRounding},
      {"capsule", capsule_mesh(0.2, 1), capsule_polyhedron(0.2, 1, 32), kRounding},
      {"capsule without length", capsule_mesh(0.2, 0), capsule_polyhedron(0.2, 0, 32), kRounding},
      {"torus", torus_mesh(1.1, 0.35), revolved(arc(1.1, 0, 0.35, 0, 2 * pi, 32), 64), kRounding},
      {"tube, closed", tube_mesh(circle, {0, 2 * pi}, 0.1), 2 * pi * pi * 0.01, 0.03},
      {"tube, open", tube_mesh(circle, {0, pi}, 0.1), pi * pi * 0.01, 0.03},
      {"tube, knotted", tube_mesh(knot, {0, 2 * pi}, 0.05), knot_length * pi * 0.0025, 0.03},
      {"surface, torus", surface_mesh(torus_point, {0, 2 * pi}, {0, 2 * pi}), 2 * pi * pi * 1.1 * 0.35 * 0.35,
       0.015},
      {"surface, torus inside out",
       surface_mesh([](double u, double v) { return torus_point(v, u); }, {0, 2 * pi}, {0, 2 * pi}),
       2 * pi * pi * 1.1 * 0.35 * 0.35, 0.015},
      {"surface, sphere with poles", surface_mesh(ball, {0, 2 * pi}, {0, pi}), sphere, 0.01},
  };
}

TEST(Mesh, BoundsAVolumeAndFacesOutwards) {
  for (const Named& solid : closed_meshes()) {
    SCOPED_TRACE(solid.name);
    EXPECT_TRUE(solid.mesh.closed);
    EXPECT_TRUE(watertight(solid.mesh));
    const double share = volume(solid.mesh) / solid.most;  // positive: triangles are turned outwards
    EXPECT_LE(share, 1 + kRounding);
    EXPECT_GE(share, 1 - solid.within);
  }
}

TEST(Mesh, HasUnitNormalsOnTheSideOfItsTriangles) {
  for (const Named& solid : closed_meshes()) {
    SCOPED_TRACE(solid.name);
    const Mesh& mesh = solid.mesh;
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    for (const Eigen::Vector3f& normal : mesh.normals) ASSERT_NEAR(normal.norm(), 1, 1e-5);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Eigen::Vector3f face =
          (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
      ASSERT_GT(face.norm(), 0);
      for (const std::uint32_t vertex : {a, b, c})
        ASSERT_GT(face.normalized().dot(mesh.normals[vertex]), 0.5F) << vertex;
    }
  }
}

TEST(Mesh, OfASphereConvergesWithTheSquareOfTheSpacing) {
  const auto error = [](int n) { return 4 * pi / 3 - volume(ellipsoid_mesh(Vector3d::Ones(), n)); };
  EXPECT_NEAR(error(20) / error(40), 4, 0.1);
  EXPECT_NEAR(error(40) / error(80), 4, 0.1);
}

TEST(Mesh, OfASurfaceHasTheSurfacesNormals) {
  const Mesh mesh = surface_mesh(torus_point, {0, 2 * pi}, {0, 2 * pi});
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector3d x = mesh.positions[i].cast<double>();
    const Vector3d centre = Vector3d(x[0], x[1], 0).normalized() * 1.1;
    EXPECT_GT(mesh.normals[i].cast<double>().dot((x - centre).normalized()), 0.9999) << i;
  }
}

TEST(Mesh, OfAnOpenSurfaceIsOpen) {
  const Mesh mesh =
      surface_mesh([](double u, double v) { return Vector3d(u, v, u * v); }, {-1, 1}, {-1, 1}, 8, 8);
  EXPECT_FALSE(mesh.closed);
  EXPECT_FALSE(watertight(mesh));
  EXPECT_EQ(mesh.triangles.size(), 128u);
  for (const Eigen::Vector3f& normal : mesh.normals) EXPECT_GT(normal[2], 0);  // along f_u x f_v
}

TEST(Mesh, ThatCannotBeDrawnIsRefused) {
  const auto rest = [](double) { return Vector3d(1, 2, 3); };
  EXPECT_THROW(tube_mesh(rest, {0, 1}, 0.1), std::domain_error);
  const auto pole = [](double s) { return Vector3d(1 / s, 0, 0); };
  EXPECT_THROW(tube_mesh(pole, {0, 1}, 0.1), std::domain_error);
  EXPECT_THROW(surface_mesh([](double u, double) { return Vector3d(u, 0, 0); }, {0, 1}, {0, 1}),
               std::domain_error);
  EXPECT_THROW(surface_mesh([](double u, double v) { return Vector3d(u, std::log(v), 0); }, {0, 1}, {0, 1}),
               std::domain_error);
}

}  // namespace
}  // namespace alembert

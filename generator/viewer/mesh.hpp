// Triangle meshes of shapes. In: sizes in metres, or a curve or surface as a function. Out: vertices with
// unit normals, triangles counter-clockwise seen from outside. No expressions here: functions are of doubles.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace alembert {

/// Vertices with normals and triangles over them. Where normals jump (the rim of a cylinder) or a parameter
/// wraps around, vertices lie on the same point, with equal coordinates to the last bit.
struct Mesh {
  std::vector<Eigen::Vector3f> positions, normals;  ///< of equal size; normals of length 1
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool closed = true;  ///< bounds a volume; otherwise both sides are to be drawn
  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// Signed volume, sum of det(a, b, c)/6 over triangles: positive if normals point outwards.
double volume(const Mesh& mesh);
/// True if every edge, of vertices told apart by position, is run through once in each direction.
bool watertight(const Mesh& mesh);

/// Centred box with edges along x, y, z.
Mesh box_mesh(const Eigen::Vector3d& edges);
/// Centred ellipsoid with semi-axes along x, y, z; `segments` around z, half as many from pole to pole. A
/// sphere has three equal ones.
Mesh ellipsoid_mesh(const Eigen::Vector3d& semi_axes, int segments = 40);
/// Centred cylinder along z.
Mesh cylinder_mesh(double radius, double length, int segments = 40);
/// Centred capsule along z; `length` lies between the centres of its caps.
Mesh capsule_mesh(double radius, double length, int segments = 32);
/// Torus about z: radius of its centre line and of its tube; `segments` along the centre line.
Mesh torus_mesh(double radius, double tube_radius, int segments = 64);

}  // namespace alembert

// Meshes of curves and surfaces that are given as functions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>

#include "viewer/mesh.hpp"

namespace alembert {

using Range = std::array<double, 2>;

/// Tube of a radius about f(u), u in the range, of round cross-section. A curve whose ends meet is closed
/// without a seam; others get flat ends. Cross-sections are carried along without twist. Throws
/// std::domain_error where f is not finite, or does not move.
Mesh tube_mesh(const std::function<Eigen::Vector3d(double)>& curve, Range range, double radius,
               int segments = 256);

/// Surface f(u, v) over a rectangle. Sides that meet, or shrink to a point, are joined; if nothing is left
/// open, the mesh is closed and turned so that its normals point outwards, otherwise they are along f_u x
/// f_v. Throws std::domain_error where f is not finite, or has no area.
Mesh surface_mesh(const std::function<Eigen::Vector3d(double, double)>& surface, Range u_range, Range v_range,
                  int u_segments = 64, int v_segments = 48);

}  // namespace alembert

// Frames on curves and surfaces (README.md, 4): rotation matrices whose columns follow a curve's
// tangent or a surface's normal.
#pragma once

#include "mechanism/model.hpp"
#include "symbolic/matrix.hpp"

namespace alembert {

/// The two vectors whose cross product is along the normal n of a frame: f_s and f_ss or the reference; f_u
/// and f_v. The frame is singular where that product is zero.
struct NormalFactors {
  Vec3 first, second;
};
NormalFactors normal_factors(const CurveFrame& curve);
NormalFactors normal_factors(const SurfaceFrame& surface);

/// Columns b = f_s/|f_s|, p = n x b, n = b x f_ss normalised (or b x reference normalised). Throws InputError
/// at `where` if the columns are undefined for all values of the coordinate, naming the cure.
Mat3 curve_rotation(const CurveFrame& curve, const SourceLocation& where, ExprGraph& graph);

/// Columns p0 = f_u/|f_u|, p1 = n x p0, n = f_u x f_v normalised (negated by `flip`). Throws InputError at
/// `where` if f_u x f_v is zero.
Mat3 surface_rotation(const SurfaceFrame& surface, const SourceLocation& where, ExprGraph& graph);

}  // namespace alembert

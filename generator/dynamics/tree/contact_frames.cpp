// Frames on curves and surfaces (see the header).
#include "dynamics/tree/contact_frames.hpp"

#include <array>
#include <vector>

#include "differentiation/jacobian.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

namespace {

Vec3 derivative(const Vec3& f, Expr along) {
  const std::array<Expr, 1> variables{along};
  const Jacobian jacobian = alembert::jacobian(f.entries, variables);
  const std::vector<Expr> values = simplify(jacobian.entries);
  return {{values[0], values[1], values[2]}};
}

Vec3 simplified(const Vec3& v) {
  const std::vector<Expr> values = simplify(v.entries);
  return {{values[0], values[1], values[2]}};
}

bool is_zero(const Vec3& v) {
  return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

/// v/|v|.
Vec3 normalized(const Vec3& v) {
  const std::array<Expr, 1> square{dot(v, v)};
  const std::array<Expr, 1> norm{sqrt(simplify(square)[0])};
  const Expr length = simplify(norm)[0];
  return simplified({{v[0] / length, v[1] / length, v[2] / length}});
}

Mat3 columns(const Vec3& x, const Vec3& y, const Vec3& z) {
  Mat3 m;
  for (std::size_t r = 0; r < 3; ++r) {
    m(r, 0) = x[r];
    m(r, 1) = y[r];
    m(r, 2) = z[r];
  }
  return m;
}

}  // namespace

NormalFactors normal_factors(const CurveFrame& curve) {
  const Vec3 tangent = derivative(curve.point, curve.along);
  return {tangent, curve.reference ? *curve.reference : derivative(tangent, curve.along)};
}

NormalFactors normal_factors(const SurfaceFrame& surface) {
  const Vec3 along_u = derivative(surface.point, surface.u);
  const Vec3 along_v = derivative(surface.point, surface.v);
  return {along_u, along_v};
}

Mat3 curve_rotation(const CurveFrame& curve, const SourceLocation& where, ExprGraph&) {
  const auto [tangent, toward] = normal_factors(curve);
  if (is_zero(tangent)) {
    throw InputError(where, "the curve does not move along its coordinate '" + to_string(curve.along) +
                                "': it has no tangent");
  }
  const Vec3 across = simplified(cross(tangent, toward));
  if (is_zero(across)) {
    if (curve.reference) {
      throw InputError(where,
                       "the reference direction is parallel to the curve's tangent: choose another one");
    }
    throw InputError(where, "the Frenet frame of this curve is undefined: its second derivative along '" +
                                to_string(curve.along) +
                                "' is parallel to its tangent; use `frame: {reference: [x, y, z]}` with a "
                                "direction that is nowhere "
                                "parallel to the tangent");
  }
  const Vec3 b = normalized(tangent);
  const Vec3 n = normalized(across);
  const Vec3 p = simplified(cross(n, b));
  return columns(b, p, n);
}

Mat3 surface_rotation(const SurfaceFrame& surface, const SourceLocation& where, ExprGraph&) {
  const auto [fu, fv] = normal_factors(surface);
  const Vec3 across = simplified(cross(fu, fv));
  if (is_zero(across)) {
    throw InputError(where, "the surface has no normal: its derivatives along '" + to_string(surface.u) +
                                "' and '" + to_string(surface.v) + "' are parallel everywhere");
  }
  const Vec3 p0 = normalized(fu);
  Vec3 n = normalized(across);
  if (surface.flip) n = {{-n[0], -n[1], -n[2]}};
  const Vec3 p1 = simplified(cross(n, p0));
  return columns(p0, p1, n);
}

}  // namespace alembert

#include "mechanism/wrapped_path.hpp"

#include "symbolic/evaluate.hpp"

namespace alembert {
namespace {

Expr select(const Expr& c, const Expr& a, const Expr& b) {
  return if_positive(c, a) + unless_positive(c, b);
}
Expr lower(const Expr& a, const Expr& b) {
  return select(b - a, a, b);
}
Expr higher(const Expr& a, const Expr& b) {
  return select(a - b, a, b);
}

}  // namespace

Expr length_around(const RoundObstacle& obstacle, const Vec3& from, const Vec3& to,
                   const std::optional<Vec3>& side, const Expr& straight) {
  ExprGraph& graph = straight.graph();
  const Expr one = graph.one(), zero = graph.zero(), two = graph.integer(2);
  const Expr &r = obstacle.radius, square = r * r;

  // The plane of the arc: the x-y plane of a cylinder, that through both points and the centre of a sphere. In it, points
  // have squares and products, and `across` is |a| |b| times the sine of the angle between them, from 0 to pi.
  const auto in_plane = [&](const Vec3& x, const Vec3& y) {
    return obstacle.cylinder ? x[0] * y[0] + x[1] * y[1] : dot(x, y);
  };
  const Expr aa = in_plane(from, from), bb = in_plane(to, to), ab = in_plane(from, to);
  // What has no derivative or value where a point is inside or the points are in line with the centre, is chosen there by
  // nobody, and constant.
  const Expr beyond_a = aa - square, beyond_b = bb - square, outside = lower(beyond_a, beyond_b);
  const Expr tangent_a = sqrt(select(beyond_a, beyond_a, one)),
             tangent_b = sqrt(select(beyond_b, beyond_b, one));
  Expr across;
  if (obstacle.cylinder) {
    across = abs(from[0] * to[1] - from[1] * to[0]);
  } else {
    const Vec3 normal = cross(from, to);
    const Expr area = dot(normal, normal);
    across = if_positive(area, sqrt(select(area, area, one)));
  }
  const Expr between = atan2(across, select(outside, ab, one));
  const Expr reach_a = atan2(tangent_a, r), reach_b = atan2(tangent_b, r), reach = reach_a + reach_b;
  const Expr near_arc = between - reach;
  Expr arc = near_arc, touches = near_arc;
  if (side) {
    const Expr far_arc = two * graph.pi() - between - reach;
    const Expr as = in_plane(from, *side), bs = in_plane(to, *side);
    // Where each arc is: the sum of the points where the line leaves the obstacle, along the side, times `across`.
    const Expr along_a = r * across * as / select(outside, aa, one),
               along_b = r * across * bs / select(outside, bb, one);
    const Expr turned = tangent_a * (bs - as * ab / select(outside, aa, one)) +
                        tangent_b * (as - bs * ab / select(outside, bb, one));
    const Expr near_side = (along_a + along_b + turned) * abs(cos(far_arc / two));
    const Expr far_side = (along_a + along_b - turned) * abs(cos(near_arc / two));
    // Tangents that cross are no way; those that pass each other meet after nearly a whole turn.
    const Expr crossing = lower(-near_arc, between - abs(reach_a - reach_b));
    const Expr far = higher(crossing, far_side - near_side);
    arc = select(far, far_arc, near_arc + unless_positive(near_arc, two * graph.pi()));
    // The point of the straight line that is nearest to the centre, and whether it is on the other side.
    const Expr apart = aa + bb - two * ab;
    const Expr part = lower(one, higher(zero, (aa - ab) / select(apart, apart, one)));
    touches = higher(near_arc, -(as + part * (bs - as)));
  }
  const Expr in_plane_length = tangent_a + tangent_b + r * arc;
  const Expr rise = to[2] - from[2];
  const Expr length =
      obstacle.cylinder ? sqrt(in_plane_length * in_plane_length + rise * rise) : in_plane_length;
  return select(lower(outside, touches), length, straight);
}

double length_around(bool cylinder, double radius, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     const std::optional<Eigen::Vector3d>& side) {
  ExprGraph graph;
  const auto vector = [&](const Eigen::Vector3d& x) {
    return Vec3{{graph.real(x[0]), graph.real(x[1]), graph.real(x[2])}};
  };
  const Expr length =
      length_around({cylinder, graph.real(radius)}, vector(from), vector(to),
                    side ? std::optional(vector(*side)) : std::nullopt, graph.real((to - from).norm()));
  return value_of(length);
}

}  // namespace alembert

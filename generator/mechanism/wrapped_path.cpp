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

/// A line around something. Some terms have no value or derivative where a point is inside, or where the points are in line
/// with the centre: a constant stands in their place there, and no result uses it.
class Wrapping {
 public:
  Wrapping(const RoundObstacle& obstacle, const Vec3& from, const Vec3& to, const std::optional<Vec3>& side)
      : graph_(from[0].graph()), obstacle_(obstacle), from_(from), to_(to) {
    const Expr one = graph_.one(), &r = obstacle.radius;
    const Expr beyond_a = aa_ - r * r, beyond_b = bb_ - r * r;
    outside_ = lower(beyond_a, beyond_b);
    tangent_a_ = sqrt(select(beyond_a, beyond_a, one));
    tangent_b_ = sqrt(select(beyond_b, beyond_b, one));
    if (obstacle.cylinder) {
      across_ = abs(from[0] * to[1] - from[1] * to[0]);
    } else {
      const Vec3 normal = cross(from, to);
      const Expr area = dot(normal, normal);
      across_ = if_positive(area, sqrt(select(area, area, one)));
    }
    const Expr between = atan2(across_, select(outside_, ab_, one));
    const Expr reach_b = atan2(tangent_b_, r);
    reach_a_ = atan2(tangent_a_, r);
    near_arc_ = arc_ = touches_ = between - (reach_a_ + reach_b);
    if (side) choose_side(*side, between, reach_b);
    in_plane_length_ = tangent_a_ + tangent_b_ + r * arc_;
    if (obstacle.cylinder && obstacle.length) {
      // How far the ends of the arc are within the cylinder's, times in_plane_length_.
      const Expr rise = to[2] - from[2], half = *obstacle.length / graph_.integer(2);
      const auto within = [&](const Expr& z) { return half * in_plane_length_ - abs(z); };
      touches_ = lower(touches_, higher(within(from[2] * in_plane_length_ + rise * tangent_a_),
                                        within(to[2] * in_plane_length_ - rise * tangent_b_)));
    }
  }

  Expr leads_around() const { return lower(outside_, touches_); }
  Expr length() const {
    const Expr rise = to_[2] - from_[2];
    return obstacle_.cylinder ? sqrt(in_plane_length_ * in_plane_length_ + rise * rise) : in_plane_length_;
  }
  /// From one end of the arc to the other as `part` goes from 0 to 1.
  Vec3 point(const Expr& part) const {
    const Expr one = graph_.one(), turn = reach_a_ + part * arc_;
    const Expr size = sqrt(select(aa_, aa_, one)), &r = obstacle_.radius;
    // Along the first point, and perpendicular to it, towards the other one or away from it.
    const Expr towards = r * sin(turn) * size / select(across_, across_, one);
    const Expr sign = far_ ? select(*far_, -one, one) : one;
    const Expr of_from = r * cos(turn) / size - sign * towards * ab_ / select(aa_, aa_, one);
    Vec3 out = of_from * from_ + sign * towards * to_;
    if (obstacle_.cylinder)
      out[2] = from_[2] + (to_[2] - from_[2]) * (tangent_a_ + r * part * arc_) / in_plane_length_;
    return out;
  }

 private:
  /// The plane of the arc: the x-y plane of a cylinder, that through both points and the centre of a sphere.
  Expr in_plane(const Vec3& x, const Vec3& y) const {
    return obstacle_.cylinder ? x[0] * y[0] + x[1] * y[1] : dot(x, y);
  }

  void choose_side(const Vec3& side, const Expr& between, const Expr& reach_b) {
    const Expr one = graph_.one(), zero = graph_.zero(), two = graph_.integer(2), &r = obstacle_.radius;
    const Expr far_arc = two * graph_.pi() - between - (reach_a_ + reach_b);
    const Expr as = in_plane(from_, side), bs = in_plane(to_, side);
    // Where each arc is: the sum of the points where the line leaves the obstacle, along the side, times across_.
    const Expr along_a = r * across_ * as / select(outside_, aa_, one),
               along_b = r * across_ * bs / select(outside_, bb_, one);
    const Expr turned = tangent_a_ * (bs - as * ab_ / select(outside_, aa_, one)) +
                        tangent_b_ * (as - bs * ab_ / select(outside_, bb_, one));
    const Expr near_side = (along_a + along_b + turned) * abs(cos(far_arc / two));
    const Expr far_side = (along_a + along_b - turned) * abs(cos(near_arc_ / two));
    // Tangents that cross are no way; those that pass each other meet after nearly a whole turn.
    const Expr crossing = lower(-near_arc_, between - abs(reach_a_ - reach_b));
    far_ = higher(crossing, far_side - near_side);
    arc_ = select(*far_, far_arc, near_arc_ + unless_positive(near_arc_, two * graph_.pi()));
    // The point of the straight line that is nearest to the centre, and whether it is on the other side.
    const Expr apart = aa_ + bb_ - two * ab_;
    const Expr part = lower(one, higher(zero, (aa_ - ab_) / select(apart, apart, one)));
    touches_ = higher(near_arc_, -(as + part * (bs - as)));
  }

  ExprGraph& graph_;
  RoundObstacle obstacle_;
  Vec3 from_, to_;
  // Squares and the product of both points in the plane; across_ is that of their lengths and the sine between them.
  Expr aa_ = in_plane(from_, from_), bb_ = in_plane(to_, to_), ab_ = in_plane(from_, to_), across_;
  Expr outside_, touches_;  // positive where both points are outside, and where the obstacle is in the way
  Expr tangent_a_, tangent_b_, reach_a_, near_arc_, arc_, in_plane_length_;
  std::optional<Expr> far_;  // positive where the longer arc is taken
};

}  // namespace

Expr length_around(const RoundObstacle& obstacle, const Vec3& from, const Vec3& to,
                   const std::optional<Vec3>& side, const Expr& straight) {
  const Wrapping wrapping(obstacle, from, to, side);
  return select(wrapping.leads_around(), wrapping.length(), straight);
}

double length_around(bool cylinder, double radius, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                     const std::optional<Eigen::Vector3d>& side) {
  ExprGraph graph;
  const auto vector = [&](const Eigen::Vector3d& x) {
    return Vec3{{graph.real(x[0]), graph.real(x[1]), graph.real(x[2])}};
  };
  return value_of(length_around({cylinder, graph.real(radius)}, vector(from), vector(to),
                                side ? std::optional(vector(*side)) : std::nullopt,
                                graph.real((to - from).norm())));
}

std::vector<Vec3> points_around(const RoundObstacle& obstacle, const Vec3& from, const Vec3& to,
                                const std::optional<Vec3>& side, int count) {
  const Wrapping wrapping(obstacle, from, to, side);
  ExprGraph& graph = from[0].graph();
  const Expr around = wrapping.leads_around();
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i) {
    Vec3 point = wrapping.point(graph.rational({i, count - 1}));
    for (std::size_t k = 0; k < 3; ++k) point[k] = select(around, point[k], from[k]);
    out.push_back(point);
  }
  return out;
}

}  // namespace alembert

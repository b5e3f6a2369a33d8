// Reads units off transforms (see the header).
#include "viewer/coordinate_unit.hpp"

#include <span>

#include "mechanism/transform_checks.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

namespace {

/// What a coordinate does in the factors seen.
class Uses {
 public:
  Uses(const InitialValues& values, const Coordinate& coordinate)
      : values_(values), coordinate_(coordinate), symbol_(coordinate.symbols[0]) {}

  void add(const Transform& transform) {
    for (const Factor& factor : transform.factors) {
      const std::vector<Expr> all = expressions_of(factor, values_.mechanism());
      if (!has(all)) continue;
      angle_ = angle_ || below_trigonometry(all);
      std::visit(*this, factor.value);
    }
  }
  std::string unit() const { return angle_ ? "rad" : shift_ && !other_ ? "m" : ""; }

  void operator()(const Translation& f) { (shifts_by_one(f.offset) ? shift_ : other_) = true; }
  void operator()(const AxisRotation& f) { angle_ = angle_ || has({&f.angle, 1}); }
  void operator()(const VectorRotation& f) { angle_ = angle_ || has({&f.angle, 1}); }
  void operator()(const QuaternionRotation&) { other_ = true; }
  void operator()(const RigidMatrix&) { other_ = true; }
  void operator()(const CurveFrame&) { other_ = true; }
  void operator()(const SurfaceFrame&) { other_ = true; }

 private:
  bool has(std::span<const Expr> roots) const {
    for (const std::uint32_t id : postorder(roots))
      if (id == symbol_.ref().node()) return true;
    return false;
  }
  bool below_trigonometry(std::span<const Expr> roots) const {
    ExprGraph& graph = symbol_.graph();
    for (const std::uint32_t id : postorder(roots)) {
      const Node& node = graph.node(id);
      const Expr operand(graph, node.a);
      if (is_trigonometric(node.op) && has({&operand, 1})) return true;
    }
    return false;
  }
  /// Whether an offset goes a metre a unit in a straight line.
  bool shifts_by_one(const Vec3& offset) const {
    InitialValues values = values_;
    const auto at = [&](double q) {
      values.set(symbol_, q);
      return values(offset);
    };
    const double q = coordinate_.initial[0];
    const Eigen::Vector3d start = at(q), first = at(q + 1) - start, second = at(q + 2) - start;
    constexpr double kTolerance = 1e-9;
    return (second - 2 * first).norm() < kTolerance && std::abs(first.norm() - 1) < kTolerance;
  }

  const InitialValues& values_;
  const Coordinate& coordinate_;
  Expr symbol_;
  bool angle_ = false, shift_ = false, other_ = false;
};

}  // namespace

std::string coordinate_unit(const InitialValues& values, const Coordinate& coordinate) {
  if (coordinate.type == CoordinateType::quaternion) return "";
  Uses uses(values, coordinate);
  for (const Body& body : values.mechanism().bodies) uses.add(body.transform);
  return uses.unit();
}

}  // namespace alembert

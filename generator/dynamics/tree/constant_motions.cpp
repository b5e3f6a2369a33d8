// Constants between motions (see the header).
#include "dynamics/tree/constant_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "symbolic/evaluate.hpp"
#include "symbolic/extended.hpp"
#include "symbolic/identity.hpp"
#include "symbolic/simplify.hpp"

namespace alembert {

namespace {

/// The angle with that cosine and sine, exact at multiples of 15 degrees.
Motion rotation_by(int axis, Expr cosine, Expr sine, ExprGraph& graph) {
  const Extended angle = atan2(extended_value_of(sine), extended_value_of(cosine));
  const Extended steps = angle / (acos(Extended(-1)) / 12);
  const Extended nearest = round(steps);
  if (abs(steps - nearest) <= kAngleRounding) {
    const auto multiple = make_rational(nearest.convert_to<std::int64_t>(), 12);
    return axis_rotation_motion(axis, graph.pi(Rational(1)) * graph.rational(*multiple));
  }
  Motion motion = axis_rotation_motion(axis, atan2(sine, cosine));
  motion.cosine = cosine;
  motion.sine = sine;
  return motion;
}

/// Rotations z, x, z (or one about a coordinate axis) of a matrix of numbers.
std::vector<Motion> plane_rotations(const Mat3& given, ExprGraph& graph) {
  Mat3 R = given;
  std::array<Extended, 9> v{};
  for (std::size_t i = 0; i < 9; ++i) {
    R[i] = short_number(R[i]);
    v[i] = extended_value_of(R[i]);
    if (abs(v[i]) <= kAngleRounding) R[i] = graph.zero();
  }
  std::vector<Motion> out;
  for (std::size_t a = 0; a < 3; ++a) {
    // The axis' own entry is 1 up to rounding for tilts of 1e-8 as well; the entries beside it are the tilt.
    const std::size_t i = (a + 1) % 3, j = (a + 2) % 3;
    const bool tilted = std::max({abs(v[3 * i + a]), abs(v[3 * j + a]), abs(v[3 * a + i]),
                                  abs(v[3 * a + j])}) > kAngleRounding;
    if (v[4 * a] < 0 || tilted) continue;
    append_motion(out, rotation_by(static_cast<int>(a), R(i, i), R(j, i), graph), graph);
    return out;
  }
  out = turned_to_z({{R(0, 2), R(1, 2), R(2, 2)}}, graph);
  if (R(0, 2).is_zero() && R(1, 2).is_zero()) {  // z is turned over
    append_motion(out, rotation_by(2, R(0, 0), -R(0, 1), graph), graph);
    return out;
  }
  const std::array<Expr, 1> square{R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2)};
  const Expr sine = sqrt(simplify(square)[0]);
  append_motion(out, rotation_by(2, R(2, 1) / sine, R(2, 0) / sine, graph), graph);
  return out;
}

bool is_number(const Motion& motion) {
  const auto number = [](Expr e) { return e.is_constant(); };
  switch (motion.kind) {
    case MotionKind::translation:
      return std::all_of(motion.offset.entries.begin(), motion.offset.entries.end(), number);
    case MotionKind::axis_rotation:
      return number(motion.angle);
    case MotionKind::rotation:
      return std::all_of(motion.matrix.entries.begin(), motion.matrix.entries.end(), number);
  }
  return false;
}

bool moves(const Motion& motion, const SpeedDerivatives& derivatives) {
  switch (motion.kind) {
    case MotionKind::translation:
      return derivatives.moves(motion.offset.entries);
    case MotionKind::axis_rotation: {
      const std::array<Expr, 1> angle{motion.angle};
      return derivatives.moves(angle);
    }
    case MotionKind::rotation:
      return derivatives.moves(motion.matrix.entries);
  }
  return true;
}

std::vector<Motion> gathered(const std::vector<Motion>& run, double length, ExprGraph& graph) {
  Pose pose = identity_pose(graph);
  std::vector<Motion> turns;
  bool numbers = true;
  for (const Motion& motion : run) {
    pose = moved(std::move(pose), motion);
    if (motion.kind == MotionKind::translation) continue;
    append_motion(turns, motion, graph);
    numbers = numbers && is_number(motion);
  }
  std::vector<Expr> offset = simplify(pose.origin.entries);
  for (Expr& e : offset) {
    if (!e.is_constant()) continue;
    e = short_number(e);
    if (vanishes(e, length)) e = graph.zero();
  }
  if (numbers) {
    const std::vector<Expr> R = simplify(pose.rotation.entries);
    for (std::size_t i = 0; i < 9; ++i) pose.rotation[i] = R[i];
    turns = plane_rotations(pose.rotation, graph);
  }
  std::vector<Motion> out;
  append_motion(out, translation_motion({{offset[0], offset[1], offset[2]}}), graph);
  for (const Motion& motion : turns) append_motion(out, motion, graph);
  return out;
}

}  // namespace

Expr short_number(Expr constant) {
  ExprGraph& graph = constant.graph();
  const Operation op = graph.node(constant.ref().node()).op;
  if (op == Operation::rational || op == Operation::pi_multiple) return constant;
  const double x = value_of(constant);
  const std::string text = fmt::format("{:.12g}", x);
  const auto fraction = rational_from_decimal(text.data(), text.data() + text.size());
  if (!fraction) return constant;
  const Expr other = graph.rational(*fraction);
  return vanishes(constant - other, std::abs(x)) ? other : constant;
}

std::vector<Motion> turned_to_z(const Vec3& axis, ExprGraph& graph) {
  // Rz(first) Rx(tilt) z = (sin first sin tilt, -cos first sin tilt, cos tilt)
  const std::array<Expr, 1> square{axis[0] * axis[0] + axis[1] * axis[1]};
  const Expr sine = sqrt(simplify(square)[0]);
  std::vector<Motion> out;
  if (!sine.is_zero()) append_motion(out, rotation_by(2, -axis[1] / sine, axis[0] / sine, graph), graph);
  append_motion(out, rotation_by(0, axis[2], sine, graph), graph);
  return out;
}

std::vector<Motion> gathered_constants(const std::vector<Motion>& motions,
                                       const SpeedDerivatives& derivatives, double length, ExprGraph& graph) {
  std::vector<Motion> out, run;
  const auto flush = [&] {
    if (run.empty()) return;
    const std::vector<Motion> shorter =
        run.size() > 1 || run[0].kind == MotionKind::rotation ? gathered(run, length, graph) : run;
    const bool gain = shorter.size() < run.size() || std::any_of(run.begin(), run.end(), [](const Motion& m) {
                        return m.kind == MotionKind::rotation;
                      });
    for (const Motion& motion : gain ? shorter : run) append_motion(out, motion, graph);
    run.clear();
  };
  for (const Motion& motion : motions) {
    if (!moves(motion, derivatives)) {
      run.push_back(motion);
      continue;
    }
    flush();
    append_motion(out, motion, graph);
  }
  flush();
  return out;
}

}  // namespace alembert

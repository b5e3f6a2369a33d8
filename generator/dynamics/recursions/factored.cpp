// Inverse dynamics by the paper's factored Lagrangian, eq. (13), literally (README.md, 1): kept as a
// formulation that can be selected and as a check of the reduced form, with which it shares only the
// transforms of the bodies.
#include "dynamics/recursions/factored.hpp"

#include <algorithm>
#include <map>

#include "dynamics/recursions/armature.hpp"
#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/symbols.hpp"

namespace alembert {

namespace {

Mat4 homogeneous(const Pose& pose, ExprGraph& g) {
  Mat4 m = zeros<4, 4>(g);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) m(r, c) = pose.rotation(r, c);
    m(r, 3) = pose.origin[r];
  }
  m(3, 3) = g.one();
  return m;
}

Mat4 from_values(std::span<const Expr> values, ExprGraph& g) {
  Mat4 m = zeros<4, 4>(g);
  for (std::size_t i = 0; i < 12; ++i) m[i] = values[i];
  return m;
}

Mat4 skew4(const Vec3& v, ExprGraph& g) {
  Mat4 m = zeros<4, 4>(g);
  m(0, 1) = -v[2];
  m(0, 2) = v[1];
  m(1, 0) = v[2];
  m(1, 2) = -v[0];
  m(2, 0) = -v[1];
  m(2, 1) = v[0];
  return m;
}

Mat3 rotation_part(const Mat4& m) {
  Mat3 out;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) out(r, c) = m(r, c);
  }
  return out;
}

/// Vector of the antisymmetric part.
Vec3 vee(const Mat3& m, ExprGraph& g) {
  const Expr half = g.rational(Rational(1, 2));
  return {{half * (m(2, 1) - m(1, 2)), half * (m(0, 2) - m(2, 0)), half * (m(1, 0) - m(0, 1))}};
}

Expr trace_of_product(const Mat4& x, const Mat4& y, ExprGraph& g) {
  Expr sum = g.zero();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) sum += x(i, j) * y(j, i);
  }
  return sum;
}

/// A body's transform with its derivatives, and its motion in the world.
struct BodyMotion {
  Mat4 A;
  std::vector<std::pair<int, Mat4>> dA;     ///< by speed (nv: time)
  std::map<std::pair<int, int>, Mat4> ddA;  ///< D_l D_k + D_k D_l for k < l, D_k D_k for k = l
  Mat4 W, Wd, Wdd;
};

}  // namespace

std::vector<Expr> factored_inverse_dynamics(const Mechanism& mechanism, const SpeedDerivatives& derivatives,
                                            ExprGraph& graph) {
  const std::size_t count = mechanism.bodies.size();
  std::vector<BodyMotion> motions(count);
  BodyMotion world;
  world.W = homogeneous(identity_pose(graph), graph);
  world.Wd = world.Wdd = zeros<4, 4>(graph);

  for (std::size_t b = 0; b < count; ++b) {
    const Body& body = mechanism.bodies[b];
    BodyMotion& s = motions[b];
    Pose pose = identity_pose(graph);
    for (const Motion& motion : elementary_motions(body.transform, mechanism, graph))
      pose = moved(std::move(pose), motion);
    s.A = homogeneous(pose, graph);

    const std::span<const Expr> rows(s.A.entries.data(), 12);
    const std::vector<SpeedPartial> first = derivatives.partials(rows);
    std::vector<Expr> flat;
    for (const SpeedPartial& partial : first) {
      Mat4 d = from_values(partial.values, graph);
      s.dA.emplace_back(partial.speed, d);
      flat.insert(flat.end(), partial.values.begin(), partial.values.end());
    }
    for (const SpeedPartial& inner : derivatives.partials(flat)) {
      for (std::size_t k = 0; k < first.size(); ++k) {
        const Mat4 d = from_values(std::span<const Expr>(inner.values).subspan(12 * k, 12), graph);
        const auto [entry, inserted] = s.ddA.try_emplace(std::minmax(inner.speed, first[k].speed), d);
        if (!inserted) entry->second = entry->second + d;
      }
    }

    // Wdot = Wdot_p A + sum_k u_k (W_p D_k A)
    // Wddot = Wddot_p A + 2 sum_k u_k (Wdot_p D_k A) + W_p (sum_k ud_k D_k A + sum_kl u_k u_l D_l D_k A)
    const BodyMotion& p = body.parent < 0 ? world : motions[static_cast<std::size_t>(body.parent)];
    s.W = p.W * s.A;
    s.Wd = p.Wd * s.A;
    s.Wdd = p.Wdd * s.A;
    Mat4 own = zeros<4, 4>(graph);
    for (const auto& [k, d] : s.dA) {
      const Expr u = derivatives.speed(k);
      s.Wd = s.Wd + u * (p.W * d);
      const Expr two_u = graph.integer(2) * u;
      s.Wdd = s.Wdd + two_u * (p.Wd * d);
      own = own + derivatives.rate(k) * d;
    }
    for (const auto& [pair, d] : s.ddA) {
      const Expr product = derivatives.speed(pair.first) * derivatives.speed(pair.second);
      own = own + product * d;
    }
    s.Wdd = s.Wdd + p.W * own;
  }

  std::vector<Wrench> wrench_of_body(count, zero_wrench(graph));
  for (const auto& [body, wrench] : wrench_symbols(mechanism, graph))
    wrench_of_body[static_cast<std::size_t>(body)] = wrench;

  std::vector<Mat4> phi(count, zeros<4, 4>(graph));
  std::vector<Expr> Q = armature_forces(mechanism);
  for (std::size_t b = count; b-- > 0;) {
    const Body& body = mechanism.bodies[b];
    const BodyMotion& s = motions[b];
    const MassProperties& properties = body.mass_properties;
    const Mat3 R = rotation_part(s.W);
    const Mat3 R_transposed = transpose(R);
    Matrix<4, 1> center;
    for (std::size_t i = 0; i < 3; ++i) center[i] = properties.com[i];
    center[3] = graph.one();

    // a_i = m (rddot_cm - g) - f_ext (world); b_i = I al + om x I om - R^T tau_ext (body)
    const Matrix<4, 1> acceleration = s.Wdd * center;
    Vec3 a;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = properties.mass * (acceleration[i] - mechanism.gravity[i]) - wrench_of_body[b].force[i];
    }
    const Vec3 om = vee(R_transposed * rotation_part(s.Wd), graph);
    const Vec3 al = vee(R_transposed * rotation_part(s.Wdd), graph);
    const Vec3 momentum = properties.inertia * om;
    const Vec3 turning =
        properties.inertia * al + cross(om, momentum) - R_transposed * wrench_of_body[b].moment;

    // phi_i = t_cm [a; 0]^T - 1/2 B U^T + sum over children of A_c phi_c
    Mat4 U = zeros<4, 4>(graph);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) U(r, c) = R(r, c);
    }
    const Mat4 BU = skew4(turning, graph) * transpose(U);
    const Expr half = graph.rational(Rational(1, 2));
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t c = 0; c < 4; ++c) {
        Expr entry = -(half * BU(r, c));
        if (c < 3) entry += center[r] * a[c];
        phi[b](r, c) += entry;
      }
    }

    // Q_k = sum over bodies of tr(W_p (D_k A) phi)
    const Mat4& parent = body.parent < 0 ? world.W : motions[static_cast<std::size_t>(body.parent)].W;
    for (const auto& [k, d] : s.dA) {
      if (k == derivatives.time_index()) continue;
      Q[static_cast<std::size_t>(k)] += trace_of_product(parent * d, phi[b], graph);
    }
    if (body.parent >= 0) {
      Mat4& up = phi[static_cast<std::size_t>(body.parent)];
      up = up + s.A * phi[b];
    }
  }
  return Q;
}

}  // namespace alembert

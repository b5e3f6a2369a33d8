// Forward dynamics in O(n) by articulated bodies. In: tree of motions, forces less the bias. Out: the speeds'
// rates.
//
// After R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7, without velocities: those are all
// in c. With x the force and moment on, and y the acceleration of, all that hangs on a frame,
//
//     x = I y + p,     x = (n, f),     y = (al, acc),     I = [J H; H^T M]
//
// a speed of twist s and force r takes  U = I s,  D = s^T U,  u = r - s^T p  and leaves to what is inward of
// it
//
//     I' = I - U U^T / D,     p' = p + U u / D;       its rate is  (u - U^T y') / D,     y = y' + s rate.
//
// An armature of the speed is added to D.
//
// Several speeds in one frame are taken one after another, as if frames without mass lay between them. A speed
// that moves several bodies, such as a mimic joint's, is taken in the frame where their branches meet, with
// U = sum I s, D = sum s^T I s and sum s^T p over them.
#include "dynamics/recursions/articulated_bodies.hpp"

#include <array>
#include <optional>

#include "dynamics/recursions/armature.hpp"
#include "dynamics/recursions/articulated_joints.hpp"
#include "dynamics/tree/spatial_vectors.hpp"

namespace alembert {

namespace {

struct ArticulatedInertia {
  Mat3 J, H, M;  ///< J and M symmetric, all nine entries kept
};

/// About a point from which this one is at t: with T = skew(t), H' = H + T M, J' = J - H T + T H'^T.
ArticulatedInertia shifted(const ArticulatedInertia& I, const Vec3& t) {
  ArticulatedInertia out = I;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3 column{{I.M(0, c), I.M(1, c), I.M(2, c)}};
    const Vec3 moment = cross(t, column);
    for (std::size_t r = 0; r < 3; ++r) out.H(r, c) = I.H(r, c) + moment[r];
  }
  // Entry (r, c) of -H T is (t x row r of H) at c, and of T H'^T (t x row c of H') at r.
  std::array<Vec3, 3> before, after;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k) {
      before[r][k] = I.H(r, k);
      after[r][k] = out.H(r, k);
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      // A common factor t_k of both is taken out.
      Expr sum = I.J(r, c);
      for (std::size_t k = 0; k < 3; ++k) {
        if (t[k].is_zero()) continue;
        Expr inner = t[k].graph().zero();
        if (k != c) {
          const std::size_t other = 3 - k - c;
          inner = (k + 1) % 3 == other ? inner + before[r][other] : inner - before[r][other];
        }
        if (k != r) {
          const std::size_t other = 3 - k - r;
          inner = (k + 1) % 3 == other ? inner + after[c][other] : inner - after[c][other];
        }
        sum += t[k] * inner;
      }
      out.J(r, c) = out.J(c, r) = sum;
    }
  }
  return out;
}

ArticulatedInertia carried_inward(const ArticulatedInertia& I, const Motion& motion) {
  if (motion.kind == MotionKind::translation) return shifted(I, motion.offset);
  return {turned_symmetric(I.J, motion), turned(I.H, motion), turned_symmetric(I.M, motion)};
}

/// J, H = skew(h), M = m 1.
ArticulatedInertia rigid_body(const NodeMass& mass, ExprGraph& g) {
  ArticulatedInertia I{mass.inertia, zeros<3, 3>(g), zeros<3, 3>(g)};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    I.M(k, k) = mass.mass;
    I.H(j, i) = mass.moment[k];
    I.H(i, j) = -mass.moment[k];
    for (std::size_t c = 0; c < k; ++c) I.J(k, c) = I.J(c, k);
  }
  return I;
}

ArticulatedInertia plus(ArticulatedInertia x, const ArticulatedInertia& y) {
  x.J = x.J + y.J;
  x.H = x.H + y.H;
  x.M = x.M + y.M;
  return x;
}

Wrench operator*(const ArticulatedInertia& I, const Twist& s) {
  return {I.J * s.angular + I.H * s.linear, transpose(I.H) * s.angular + I.M * s.linear};
}

/// Component of a twist that has only one, otherwise 6.
std::size_t only_component(const Twist& twist) {
  std::size_t found = 6;
  for (std::size_t k = 0; k < 6; ++k) {
    if (twist[k].is_zero()) continue;
    if (found < 6) return 6;
    found = k;
  }
  return found;
}

/// What is left of I after a joint, with the row and column of its own component exactly zero.
ArticulatedInertia without(const ArticulatedInertia& I, const Wrench& U, const Wrench& U_over_D,
                           std::size_t own) {
  ArticulatedInertia out = I;
  const auto entry = [&](std::size_t r, std::size_t c) -> Expr& {
    return c < 3 ? out.J(r, c) : r < 3 ? out.H(r, c - 3) : out.M(r - 3, c - 3);
  };
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t c = r; c < 6; ++c) {
      Expr& x = entry(r, c);
      if (r == own || c == own) {
        x = x.graph().zero();
      } else {
        x -= U[r] * U_over_D[c];
      }
      if (c < 3) out.J(c, r) = x;
      if (r >= 3) out.M(c - 3, r - 3) = x;
    }
  }
  return out;
}

}  // namespace

std::optional<std::vector<Expr>> articulated_solve(const Mechanism& mechanism, const MotionTree& tree,
                                                   std::span<const Expr> right_side, ExprGraph& graph) {
  const std::size_t count = tree.nodes.size();
  const std::optional<ArticulatedJoints> joints = articulated_joints(tree, mechanism.nv, graph);
  if (!joints) return std::nullopt;

  struct Solved {
    Wrench U_over_D;
    Expr u_over_D;
  };
  std::vector<ArticulatedInertia> inertias;
  for (const NodeMass& mass : tree.masses) inertias.push_back(rigid_body(mass, graph));
  std::vector<Wrench> forces(count, zero_wrench(graph));
  std::vector<std::vector<Solved>> solved(count);
  const std::vector<Expr> armature = armatures(mechanism);
  // Of a shared joint, as far as it is outward of a node: sums of I s, s^T I s and s^T p over what it moves.
  struct Moved {
    Wrench U;
    Expr D, sp;
  };
  const Moved nothing{zero_wrench(graph), graph.zero(), graph.zero()};
  std::vector<std::vector<Moved>> moved(joints->shared.size(), std::vector<Moved>(count + 1, nothing));
  std::vector<Solved> shared_solved(joints->shared.size(), {zero_wrench(graph), graph.zero()});
  const auto place = [](int node) { return static_cast<std::size_t>(node + 1); };
  const auto solve_shared = [&](std::size_t k) {
    const SharedJoint& joint = joints->shared[k];
    const Moved& m = moved[k][place(joint.base)];
    const std::size_t speed = static_cast<std::size_t>(joint.speed);
    const Expr inverse_D = graph.one() / (m.D + armature[speed]);
    const Expr u = right_side[speed] - m.sp;
    shared_solved[k] = {inverse_D * m.U, inverse_D * u};
    if (joint.base < 0) return;
    const std::size_t base = static_cast<std::size_t>(joint.base);
    inertias[base] = without(inertias[base], m.U, shared_solved[k].U_over_D, 6);
    forces[base] = forces[base] + u * shared_solved[k].U_over_D;
  };
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t k = 0; k < joints->shared.size(); ++k)
      if (joints->shared[k].base == static_cast<int>(i)) solve_shared(k);
    ArticulatedInertia& I = inertias[i];
    Wrench& p = forces[i];
    for (const ArticulatedJoint& joint : joints->of_node[i]) {
      const Twist& s = joint.twist;
      const Wrench U = I * s;
      const Expr a = armature[static_cast<std::size_t>(joint.speed)];
      const Expr inverse_D = graph.one() / (dot(s, U) + a);
      const Expr u = right_side[static_cast<std::size_t>(joint.speed)] - dot(s, p);
      const Wrench U_over_D = inverse_D * U;
      const std::size_t own = a.is_zero() ? only_component(s) : 6;  // with armature, some of it stays
      I = without(I, U, U_over_D, own);
      for (std::size_t k = 0; k < 6; ++k) {
        // s^T p' = r, whatever p was.
        p[k] = k == own ? right_side[static_cast<std::size_t>(joint.speed)] / s[k] : p[k] + U_over_D[k] * u;
      }
      solved[i].push_back({U_over_D, inverse_D * u});
    }
    const MotionNode& node = tree.nodes[i];
    for (std::size_t k = 0; k < joints->shared.size(); ++k) {
      const auto own = joints->shared[k].path.find(i);
      if (own == joints->shared[k].path.end()) continue;
      const Twist& s = own->second;
      const Moved& outer = moved[k][place(static_cast<int>(i))];
      const Wrench U = outer.U + I * s;
      Moved& inner = moved[k][place(node.parent)];
      inner.U = inner.U + inward(node.motion, U);
      inner.D += outer.D + dot(s, outer.U + U);
      inner.sp += outer.sp + dot(s, p);
    }
    if (node.parent < 0) continue;
    const std::size_t parent = static_cast<std::size_t>(node.parent);
    inertias[parent] = plus(inertias[parent], carried_inward(I, node.motion));
    forces[parent] = forces[parent] + inward(node.motion, p);
  }

  std::vector<Expr> rates(static_cast<std::size_t>(mechanism.nv), graph.zero());
  const auto take_shared = [&](int base, const Twist& y) {
    for (std::size_t k = 0; k < joints->shared.size(); ++k)
      if (joints->shared[k].base == base)
        rates[static_cast<std::size_t>(joints->shared[k].speed)] =
            shared_solved[k].u_over_D - dot(y, shared_solved[k].U_over_D);
  };
  for (std::size_t k = 0; k < joints->shared.size(); ++k)
    if (joints->shared[k].base < 0) solve_shared(k);
  take_shared(-1, zero_twist(graph));
  std::vector<Twist> accelerations;
  for (std::size_t i = 0; i < count; ++i) {
    const MotionNode& node = tree.nodes[i];
    Twist y = node.parent < 0 ? zero_twist(graph)
                              : outward(node.motion, accelerations[static_cast<std::size_t>(node.parent)]);
    for (const SharedJoint& joint : joints->shared)
      if (const auto own = joint.path.find(i); own != joint.path.end())
        y = y + rates[static_cast<std::size_t>(joint.speed)] * own->second;
    for (std::size_t k = joints->of_node[i].size(); k-- > 0;) {
      const ArticulatedJoint& joint = joints->of_node[i][k];
      const Expr rate = solved[i][k].u_over_D - dot(y, solved[i][k].U_over_D);
      rates[static_cast<std::size_t>(joint.speed)] = rate;
      y = y + rate * joint.twist;
    }
    take_shared(static_cast<int>(i), y);
    accelerations.push_back(y);
  }
  return rates;
}

}  // namespace alembert

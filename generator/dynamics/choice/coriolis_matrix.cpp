// The Coriolis matrix by recursions, and as half the derivative of c by the speeds (see the header).
#include "dynamics/choice/coriolis_matrix.hpp"

#include <algorithm>

#include "differentiation/jacobian.hpp"
#include "dynamics/choice/candidates.hpp"
#include "dynamics/recursions/coriolis_recursion.hpp"

namespace alembert {
namespace {

/// Where D_i D_j = D_j D_i, that is without quaternions, dc/du = 2 C for the c of bodies alone.
std::vector<Expr> half_of_derivatives(const Kinematics& kinematics, std::vector<Expr> c) {
  const std::vector<Expr>& applied = kinematics.applied.Q;
  for (std::size_t i = 0; i < applied.size(); ++i) c[i] += applied[i];
  std::vector<Expr> speeds;
  for (int k = 0; k < kinematics.mechanism.nv; ++k) speeds.push_back(kinematics.derivatives.speed(k));
  const Jacobian by_speeds = jacobian(c, speeds);
  std::vector<Expr> C;
  const Expr half = kinematics.graph.rational(Rational(1, 2));
  for (const Expr& entry : by_speeds.entries) C.push_back(half * entry);
  return C;
}

}  // namespace

std::vector<Expr> coriolis_matrix(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  Candidates candidates(kinematics);
  candidates.add_recursions(equations, [&](const WrittenTree& tree, FarPairs far) {
    return recursive_coriolis_matrix(kinematics.mechanism, tree, kinematics.derivatives, kinematics.graph,
                                     far);
  });
  const bool commute = kinematics.mechanism.nq == kinematics.mechanism.nv;
  if (commute && candidates.may_be_whole()) candidates.add(half_of_derivatives(kinematics, equations.c));
  return candidates.shortest();
}

}  // namespace alembert

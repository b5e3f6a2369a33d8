// Derivatives of the forces: of the whole by D* and its like, and by recursions (see the header).
#include "dynamics/choice/force_derivatives.hpp"

#include "differentiation/jacobian.hpp"
#include "dynamics/choice/candidates.hpp"
#include "dynamics/recursions/derivative_recursion.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

std::vector<Expr> derivatives_of_the_whole(const Kinematics& kinematics, const std::vector<Expr>& Q) {
  std::vector<Expr> variables;
  for (const Coordinate& coordinate : kinematics.mechanism.coordinates)
    variables.insert(variables.end(), coordinate.symbols.begin(), coordinate.symbols.end());
  const std::size_t nq = variables.size(), nv = Q.size();
  for (int k = 0; k < kinematics.mechanism.nv; ++k) variables.push_back(kinematics.derivatives.speed(k));
  const Jacobian by = jacobian(Q, variables);
  std::vector<Expr> by_coordinates, by_speeds;
  for (std::size_t i = 0; i < nv; ++i) {
    for (std::size_t a = 0; a < nq; ++a) by_coordinates.push_back(by(i, a));
    for (std::size_t k = 0; k < nv; ++k) by_speeds.push_back(by(i, nq + k));
  }
  std::vector<Expr> both = kinematics.derivatives.along_speeds(by_coordinates);
  both.insert(both.end(), by_speeds.begin(), by_speeds.end());
  return both;
}

std::vector<Expr> force_derivatives(const Kinematics& kinematics, const EquationsOfMotion& equations) {
  std::vector<Expr> applied;
  if (!kinematics.applied.Q.empty())
    applied = value_number(derivatives_of_the_whole(kinematics, kinematics.applied.Q));
  Candidates candidates(kinematics);
  candidates.add_recursions(equations, [&](const WrittenTree& tree, FarPairs far) {
    std::vector<Expr> both = recursive_force_derivatives(kinematics.mechanism, tree, kinematics.derivatives,
                                                         kinematics.graph, far);
    for (std::size_t i = 0; i < applied.size(); ++i) both[i] -= applied[i];
    return both;
  });
  if (candidates.may_be_whole()) candidates.add(derivatives_of_the_whole(kinematics, equations.Q));
  return candidates.shortest();
}

}  // namespace alembert

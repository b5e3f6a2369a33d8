// Inertia that a coordinate has beside the bodies it moves, as a geared motor's rotor: a mechanism in; by
// speed, its armature and the force a du/dt out. M has a on its diagonal then, and the kinetic energy a
// u^2/2.
#include "dynamics/recursions/armature.hpp"

namespace alembert {

std::vector<Expr> armatures(const Mechanism& mechanism) {
  std::vector<Expr> result;
  for (const Coordinate& coordinate : mechanism.coordinates)
    result.insert(result.end(), coordinate.rate_symbols.size(), coordinate.armature);
  return result;
}

std::vector<Expr> armature_forces(const Mechanism& mechanism) {
  std::vector<Expr> result;
  for (const Coordinate& coordinate : mechanism.coordinates)
    for (const Expr rate : coordinate.rate_symbols) result.push_back(coordinate.armature * rate);
  return result;
}

}  // namespace alembert

// The list of engines, and the way back from joints to speeds.
#include "oracles/engines/engine.hpp"

#include "oracles/engines/constrained_engine.hpp"

namespace alembert::oracles {

std::vector<Engine> engines() {
  std::vector<Engine> list = {
      {"KDL", 1e-9, {}}, {"MuJoCo", 1e-7, {}}, {"DART", 1e-9, {}}, {"Simbody", 1e-9, {}}};
#ifdef ALEMBERT_ORACLE_KDL
  list[0].make = make_kdl;
#endif
#ifdef ALEMBERT_ORACLE_MUJOCO
  list[1].make = make_mujoco;
#endif
#ifdef ALEMBERT_ORACLE_DART
  list[2].make = make_dart;
#endif
#ifdef ALEMBERT_ORACLE_SIMBODY
  list[3].make = make_simbody;
#endif
  return list;
}

ConstrainedEngine constrained_simbody() {
#ifdef ALEMBERT_ORACLE_SIMBODY
  return {simbody_expresses_constraints, simbody_constrained_accelerations};
#else
  return {};
#endif
}

Dynamics engine_dynamics(EngineModel& model, const JointTree& tree, const State& state) {
  const Eigen::MatrixXd J = tree.jacobian(state);
  const std::vector<LinkWrench> wrenches = tree.wrenches(state);
  const JointMotion moving = tree.motion(state, true);
  const JointMotion coasting = tree.motion(state, false);
  Dynamics result;
  result.tau = J.transpose() * model.inverse_dynamics(moving, wrenches);
  result.bias = J.transpose() * model.inverse_dynamics(coasting, wrenches);
  result.mass_matrix = J.transpose() * model.mass_matrix(moving) * J;
  return result;
}

}  // namespace alembert::oracles

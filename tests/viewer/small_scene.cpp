// Scenes for tests (see the header).
#include "viewer/small_scene.hpp"

#include <gtest/gtest.h>

#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "dynamics/function_builders.hpp"
#include "mechanism/load.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert::test {

void SmallScene::add(const std::string& description, const std::vector<double>& values,
                     const Acting& acting) {
  ExprGraph graph;
  const Mechanism mechanism =
      load_mechanism(std::make_shared<const SourceText>(SourceText{"test.yaml", description}), graph);
  const Kinematics kinematics = symbolic_kinematics(mechanism, graph);
  const EquationsOfMotion equations = equations_of_motion(kinematics, Formulation::reduced);
  const std::vector<Expr> poses =
      function_outputs(kinematics, equations, FunctionKind("body_poses")).at(0).values;
  BakedMotion motion;
  for (const double value : values) {
    std::vector<double> symbols(graph.symbol_count(), 0.0);
    for (const Coordinate& coordinate : mechanism.coordinates)
      symbols[graph.symbol_index(coordinate.symbols[0].ref().node())] = value;
    motion.times.push_back(0.1 * static_cast<double>(motion.times.size()));
    motion.q.emplace_back(static_cast<std::size_t>(mechanism.nq), value);
    motion.poses.push_back(evaluate(poses, symbols));
    motion.kinetic.push_back(value);
    motion.potential.push_back(-value);
  }
  motion.acting = acting;
  Warnings warnings;
  add_mechanism(scene, mechanism, graph, motion, warnings);
  EXPECT_TRUE(warnings.empty());
}

}  // namespace alembert::test

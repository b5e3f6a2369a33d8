// A description loaded for a test, from the catalogue or from text.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "catalogue.hpp"
#include "dynamics/checks/state_checks.hpp"
#include "dynamics/choice/equations_of_motion.hpp"
#include "dynamics/equations.hpp"
#include "dynamics/tree/state_values.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"
#include "symbolic/evaluate.hpp"

namespace alembert::test {

struct LoadedMechanism {
  std::unique_ptr<ExprGraph> graph = std::make_unique<ExprGraph>();
  std::unique_ptr<Mechanism> mechanism;

  static LoadedMechanism file(const std::string& path) {
    LoadedMechanism loaded;
    loaded.mechanism = std::make_unique<Mechanism>(load_mechanism(read_source(path), *loaded.graph));
    return loaded;
  }
  static LoadedMechanism text(const std::string& text) {
    LoadedMechanism loaded;
    loaded.mechanism = std::make_unique<Mechanism>(
        load_mechanism(std::make_shared<const SourceText>(SourceText{"test.yaml", text}), *loaded.graph));
    return loaded;
  }
  Kinematics kinematics() const { return symbolic_kinematics(*mechanism, *graph); }
  std::vector<double> values(std::span<const Expr> expressions, unsigned seed) const {
    return evaluate(expressions, state_values(*mechanism, *graph, seed));
  }
};

}  // namespace alembert::test

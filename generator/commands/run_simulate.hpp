// `simulate`: the free motion from a state.
#pragma once

#include <string>
#include <vector>

#include "commands/common_options.hpp"
#include "simulation/start_state.hpp"

namespace alembert {

struct SimulateOptions {
  double duration = 10, step = 1e-3;
  int every = 10;          ///< one row of output each so many steps
  std::string integrator;  ///< empty: rk4, or implicit where no step of that has a value
  std::string csv;         ///< `-` is standard output, which is the default if nothing else is asked for
  std::string html;        ///< page to be written, if any
  std::string glb;         ///< glTF scene to be written, if any
  double fps = 60;         ///< frames a second of page and scene
  std::vector<std::string> scene;  ///< further descriptions, to be seen beside the first
  StartOptions start;              ///< of the first
  std::string inputs;              ///< table of what its inputs are over time, if any
};
/// What SimulateOptions::integrator may be.
std::vector<std::string> integrator_names();

int run_simulate(const CommonOptions& common, const SimulateOptions& options);

}  // namespace alembert

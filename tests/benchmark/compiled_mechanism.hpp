// A mechanism compiled for the benchmark: its functions as plain pointers, so that one program times them
// all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "alembert/batch.hpp"

namespace alembert::benchmarks {

struct CompiledMechanism {
  std::string name;
  std::string description;  ///< path of the YAML file
  std::string header;       ///< path of the generated header in which operations are counted
  std::size_t n;            ///< coordinates and speeds
  void (*inverse_dynamics)(const double* q, const double* qd, const double* qdd, double* tau);
  void (*mass_matrix)(const double* q, double* M);
  void (*forward_dynamics)(const double* q, const double* qd, const double* tau, double* qdd);

  /// Over n states; null without batches.
  using Batch3 = std::size_t (*)(std::size_t n, std::size_t stride, const double*, const double*,
                                 const double*, double*, const BatchOptions&);
  Batch3 inverse_dynamics_batch = nullptr;
  Batch3 forward_dynamics_batch = nullptr;
};

/// Those chosen when the build was configured.
std::vector<CompiledMechanism> compiled_mechanisms();

}  // namespace alembert::benchmarks

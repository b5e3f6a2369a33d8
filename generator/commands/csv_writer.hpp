// A motion as comma-separated values. In: points of a trajectory. Out: a file or standard output, a header
// and one row a point: t, q, qd, states, kinetic, potential and total energy, outputs, forces; with constraints,
// lambda of each row and the largest violation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/files/waiting_file.hpp"
#include "mechanism/parameter_places.hpp"
#include "simulation/force_readings.hpp"
#include "simulation/trajectory.hpp"

namespace alembert {

/// Writes rows as they come. All members throw InputError where the file cannot be written.
class CsvWriter {
 public:
  /// Opens the file and writes the header. `path` - is standard output.
  CsvWriter(const CompiledMechanism& compiled, const std::string& path);
  void write(const TrajectoryPoint& point);
  /// Moves the file into place; until then there is the one from before. To be called at the end.
  void finish();

 private:
  void put(const std::string& text);
  [[noreturn]] void fail() const;

  const Mechanism& mechanism_;
  std::vector<PlacedParameter> states_;
  ForceReadings readings_;
  std::optional<WaitingFile> file_;  ///< none: standard output
};

}  // namespace alembert

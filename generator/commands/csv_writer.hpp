// A motion as comma-separated values. In: points of a trajectory. Out: a file or standard output, a header
// and one row a point: t, q, qd, kinetic, potential and total energy; with constraints, lambda of each row
// and the largest violation.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "commands/trajectory.hpp"

namespace alembert {

/// Writes rows as they come. All members throw InputError where the file cannot be written.
class CsvWriter {
 public:
  /// Opens the file and writes the header. `path` - is standard output.
  CsvWriter(const Mechanism& mechanism, const std::string& path);
  void write(const TrajectoryPoint& point);
  /// Hands what was written to the system. To be called at the end.
  void flush();

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const {
      if (file != stdout) std::fclose(file);
    }
  };

  void put(const std::string& text);
  [[noreturn]] void fail() const;

  const Mechanism& mechanism_;
  std::string path_;
  std::unique_ptr<std::FILE, CloseFile> file_;
};

}  // namespace alembert

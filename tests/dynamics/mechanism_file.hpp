// A description loaded for a test, from the catalogue or from text.
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dynamics/equations.hpp"
#include "dynamics/state_checks.hpp"
#include "mechanism/load.hpp"
#include "symbolic/passes.hpp"

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

/// All descriptions of the catalogue, sorted.
inline std::vector<std::string> catalogue() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ALEMBERT_SOURCE_DIR "/mechanisms")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Name of a catalogue file as a test suffix.
inline std::string test_name(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

}  // namespace alembert::test

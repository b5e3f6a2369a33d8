// The descriptions in mechanisms/ as parameters of tests. In: nothing. Out: their paths, and names for them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace alembert::test {

/// All descriptions of the catalogue, sorted.
inline std::vector<std::string> catalogue() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ALEMBERT_SOURCE_DIR "/mechanisms")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether a description has constraints, by its text: as cheap as a list of tests must be.
inline bool has_constraints(const std::string& path) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("constraints:")) return true;
  }
  return false;
}

/// Those of the catalogue for which `wanted(path)`.
template <class Wanted>
std::vector<std::string> catalogue_where(const Wanted& wanted) {
  std::vector<std::string> files = catalogue();
  std::erase_if(files, [&](const std::string& path) { return !wanted(path); });
  return files;
}

/// Name of a catalogue file as a test suffix.
inline std::string test_name(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

}  // namespace alembert::test

// The descriptions in mechanisms/ as parameters of tests. In: nothing. Out: their paths, and names for them.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace alembert::test {

/// Name of a catalogue file as a test suffix.
inline std::string test_name(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

/// All descriptions of the catalogue, sorted, but those of the examples, which have tests of their own; or those whose names stand in the environment variable
/// ALEMBERT_CATALOGUE, with blanks between them. Throws if there is no such description.
inline std::vector<std::string> catalogue() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ALEMBERT_SOURCE_DIR "/mechanisms")) {
    const std::string path = entry.path().string();
    if (entry.path().extension() == ".yaml" && path.find("/mechanisms/examples/") == std::string::npos)
      files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  if (const char* names = std::getenv("ALEMBERT_CATALOGUE")) {
    std::vector<std::string> chosen;
    std::istringstream in(names);
    for (std::string name; in >> name;) {
      const auto found = std::ranges::find(files, name, test_name);
      if (found == files.end())
        throw std::invalid_argument("ALEMBERT_CATALOGUE: no description '" + name + "'");
      chosen.push_back(*found);
    }
    return chosen;
  }
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

}  // namespace alembert::test

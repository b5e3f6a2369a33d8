// What a test found against a file that holds what is expected, to the letter. ALEMBERT_UPDATE_GOLDEN=1
// writes such files anew.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace alembert::test {

inline void expect_golden(const std::string& found, const std::filesystem::path& path) {
  if (std::getenv("ALEMBERT_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << found;
    return;
  }
  std::ifstream file(path, std::ios::binary);
  ASSERT_TRUE(file) << "no " << path << "; ALEMBERT_UPDATE_GOLDEN=1 writes it";
  const std::string expected{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(found, expected);
}

/// The files of a folder below the source tree with this extension, sorted.
inline std::vector<std::filesystem::path> files_in(const std::string& folder, const std::string& extension) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(ALEMBERT_SOURCE_DIR) / folder))
    if (entry.path().extension() == extension) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A diagnostic with the folder of its file removed.
inline std::string without_folder(const std::string& diagnostic, const std::filesystem::path& file) {
  const std::string folder = file.parent_path().string() + "/";
  return diagnostic.starts_with(folder) ? diagnostic.substr(folder.size()) : diagnostic;
}

}  // namespace alembert::test

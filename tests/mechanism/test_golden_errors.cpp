// Every tests/golden/errors/bad_X.yaml must fail with the diagnostic in bad_X.err, to the letter.
// ALEMBERT_UPDATE_GOLDEN=1 writes the .err files anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "mechanism/load.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> bad_descriptions() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(fs::path(ALEMBERT_SOURCE_DIR) / "tests/golden/errors"))
    if (entry.path().extension() == ".yaml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The diagnostic with the file's folder removed.
std::string diagnostic(const fs::path& path) {
  ExprGraph graph;
  try {
    load_mechanism(read_source(path), graph);
  } catch (const InputError& error) {
    const std::string text = error.what(), folder = path.parent_path().string() + "/";
    return text.starts_with(folder) ? text.substr(folder.size()) : text;
  }
  return "loads without an error";
}

class GoldenError : public testing::TestWithParam<fs::path> {};

TEST_P(GoldenError, IsUnchanged) {
  const fs::path& path = GetParam();
  const fs::path expected_path = fs::path(path).replace_extension(".err");
  const std::string found = diagnostic(path) + "\n";
  ASSERT_NE(found, "loads without an error\n");
  EXPECT_TRUE(found.starts_with(path.filename().string() + ":")) << found;
  if (std::getenv("ALEMBERT_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(expected_path, std::ios::binary) << found;
    return;
  }
  std::ifstream file(expected_path, std::ios::binary);
  ASSERT_TRUE(file) << "no " << expected_path << "; ALEMBERT_UPDATE_GOLDEN=1 writes it";
  const std::string expected{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(found, expected);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenError, testing::ValuesIn(bad_descriptions()),
                         [](const auto& test) { return test.param.stem().string(); });

TEST(GoldenErrors, CoverTheLanguage) {
  EXPECT_GE(bad_descriptions().size(), 200u);
}

TEST(GoldenErrors, HaveADescriptionEach) {
  for (const auto& entry : fs::directory_iterator(fs::path(ALEMBERT_SOURCE_DIR) / "tests/golden/errors"))
    if (entry.path().extension() == ".err") {
      EXPECT_TRUE(fs::exists(fs::path(entry.path()).replace_extension(".yaml"))) << entry.path();
    }
}

}  // namespace
}  // namespace alembert

// Every tests/golden/errors/bad_X.yaml must fail with the diagnostic in bad_X.err, to the letter, and every
// tests/golden/doubtful/X.yaml load with the warnings in X.err.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "golden/golden_file.hpp"
#include "mechanism/load.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> bad_descriptions() {
  return test::files_in("tests/golden/errors", ".yaml");
}

std::string diagnostic(const fs::path& path) {
  ExprGraph graph;
  try {
    load_mechanism(read_source(path), graph);
  } catch (const InputError& error) {
    return test::without_folder(error.what(), path);
  }
  return "loads without an error";
}

class GoldenError : public testing::TestWithParam<fs::path> {};

TEST_P(GoldenError, IsUnchanged) {
  const fs::path& path = GetParam();
  const std::string found = diagnostic(path) + "\n";
  ASSERT_NE(found, "loads without an error\n");
  EXPECT_TRUE(found.starts_with(path.filename().string() + ":")) << found;
  test::expect_golden(found, fs::path(path).replace_extension(".err"));
}

INSTANTIATE_TEST_SUITE_P(All, GoldenError, testing::ValuesIn(bad_descriptions()),
                         [](const auto& test) { return test.param.stem().string(); });

/// Warnings of a description that loads.
class GoldenWarning : public testing::TestWithParam<fs::path> {};

TEST_P(GoldenWarning, IsUnchanged) {
  const fs::path& path = GetParam();
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(read_source(path), graph);
  std::string found;
  for (const Warning& warning : one_of_each_kind(mechanism.warnings))
    found += test::without_folder(warning_text(warning.where, warning.message, warning.note), path) + "\n";
  EXPECT_NE(found, "");
  test::expect_golden(found, fs::path(path).replace_extension(".err"));
}

INSTANTIATE_TEST_SUITE_P(All, GoldenWarning,
                         testing::ValuesIn(test::files_in("tests/golden/doubtful", ".yaml")),
                         [](const auto& test) { return test.param.stem().string(); });

TEST(GoldenErrors, CoverTheLanguage) {
  EXPECT_GE(bad_descriptions().size(), 200u);
}

TEST(GoldenErrors, HaveADescriptionEach) {
  for (const fs::path& path : test::files_in("tests/golden/errors", ".err"))
    EXPECT_TRUE(fs::exists(fs::path(path).replace_extension(".yaml"))) << path;
}

}  // namespace
}  // namespace alembert

// The README's table of functions is that of the function table. ALEMBERT_UPDATE_GOLDEN=1 rewrites it.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "emit/argument_lists.hpp"
#include "functions/function_table.hpp"

namespace alembert::test {
namespace {

const char* const kReadme = ALEMBERT_SOURCE_DIR "/README.md";
const std::string kTableHead = "| name | arguments | results | meaning |\n| --- | --- | --- | --- |\n";

/// A `*` marks what is written by default.
std::string rows_of_table() {
  std::string rows;
  for (const OutputFunction& row : kOutputFunctions) {
    rows +=
        fmt::format("| `{}`{} | {} | {} | {} |\n", row.name, row.by_default ? " *" : "",
                    fmt::join(argument_names(row), ", "), fmt::join(result_names(row), ", "), row.summary);
  }
  return rows;
}

TEST(Readme, ListsTheFunctionsOfTheTable) {
  std::ifstream in(kReadme);
  std::ostringstream read;
  read << in.rdbuf();
  const std::string text = read.str();
  const std::size_t head = text.find(kTableHead);
  ASSERT_NE(head, std::string::npos);
  const std::size_t begin = head + kTableHead.size(), end = text.find("\n\n", begin) + 1;
  ASSERT_NE(end, 0u);
  if (std::getenv("ALEMBERT_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(kReadme) << text.substr(0, begin) + rows_of_table() + text.substr(end);
    GTEST_SKIP() << "table rewritten";
  }
  EXPECT_EQ(text.substr(begin, end - begin), rows_of_table());
}

}  // namespace
}  // namespace alembert::test

// The tables of functions in README.md (those written by default) and src/README.md (all, in full) are those of
// the function table. ALEMBERT_UPDATE_GOLDEN=1 rewrites them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emit/argument_lists.hpp"
#include "functions/function_table.hpp"

namespace alembert::test {
namespace {

const std::string kReadme = ALEMBERT_SOURCE_DIR "/README.md";
const std::string kCheatSheet = ALEMBERT_SOURCE_DIR "/src/README.md";

/// Rows of a table in a file: they begin behind the text `head` and end at an empty line.
void expect_table(const std::string& path, const std::string& head, const std::string& rows) {
  std::ifstream in(path);
  std::ostringstream read;
  read << in.rdbuf();
  const std::string text = read.str();
  const std::size_t place = text.find(head);
  ASSERT_NE(place, std::string::npos) << path << " has no\n" << head;
  const std::size_t begin = place + head.size();
  // The newline before the rows counts: a table without rows ends at once.
  const std::size_t end = text.find("\n\n", begin - 1) + 1;
  ASSERT_NE(end, 0u) << path << ": no empty line ends the table\n" << head;
  if (std::getenv("ALEMBERT_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(path) << text.substr(0, begin) + rows + text.substr(end);
    return;
  }
  EXPECT_EQ(text.substr(begin, end - begin), rows) << path;
}

TEST(Readme, ListsTheDefaultFunctions) {
  std::string rows;
  for (const OutputFunction& row : kOutputFunctions) {
    if (!row.by_default) continue;
    rows += fmt::format("| `{}({}) -> {}` | {} |\n", row.name, fmt::join(argument_names(row), ", "),
                        fmt::join(result_names(row), ", "), row.summary);
  }
  expect_table(kReadme, "| function | meaning |\n| --- | --- |\n", rows);
}

/// As Eigen's interface has it: one result is returned, several are arguments.
std::string call(const OutputFunction& row) {
  std::vector<std::string_view> arguments = argument_names(row);
  if (row.takes_inputs) arguments.push_back("in");
  if (row.results.size() > 1) {
    for (const std::string_view name : result_names(row)) arguments.push_back(name);
  }
  return fmt::format("{}({})", row.name, fmt::join(arguments, ", "));
}

/// The name of the constant of `Mechanism` is the same with a k.
std::string extent_name(const Extent& extent) {
  const auto times = [&](std::string_view count) {
    return extent.number == 1 ? std::string(count) : fmt::format("{} {}", extent.number, count);
  };
  switch (extent.of) {
    case Extent::Of::number:
      return std::to_string(extent.number);
    case Extent::Of::coordinates:
      return times("nq");
    case Extent::Of::speeds:
      return times("nv");
    case Extent::Of::constraint_rows:
      return times("nc");
    case Extent::Of::outputs:
      return times("noutputs");
    case Extent::Of::parameters:
      return times("nparameters");
    case Extent::Of::inputs:
      return times("ninputs");
    case Extent::Of::states:
      return times("nstates");
    case Extent::Of::forces:
      return times("nforces");
    case Extent::Of::bodies:
      return times("nbodies");
    case Extent::Of::base_parameters:
      return times("nbase");
  }
  throw std::logic_error("no such extent");
}

/// `6 nbodies x nv`, or `nframes of 6 x nv` for an array of matrices.
std::string shape(const ResultArray& result) {
  std::string rows = extent_name(result.rows);
  std::string array;
  if (result.per != Per::mechanism) {
    const std::string blocks = result.per == Per::body ? "nbodies" : "nframes";
    if (result.blocks == Blocks::in_array)
      array = blocks + " of ";
    else
      rows = result.rows == Extent(1) ? blocks : rows + " " + blocks;
  }
  return array + (result.columns == Extent(1) ? rows : rows + " x " + extent_name(result.columns));
}

/// A bar would end the cell, in code too.
std::string cell(std::string text) {
  for (std::size_t i = 0; (i = text.find('|', i)) != std::string::npos; i += 2) text.insert(i, "\\");
  return text;
}

std::string cheat_sheet_row(const OutputFunction& row) {
  std::string results, meaning(row.summary);
  for (const ResultArray& result : row.results)
    results += fmt::format("{}`{}` ({}): {}", results.empty() ? "" : "<br>", result.name, shape(result),
                           result.meaning);
  if (!row.formula.empty()) meaning += fmt::format("<br>`{}`", row.formula);
  if (!row.remark.empty()) meaning += fmt::format("<br>{}", row.remark);
  return fmt::format("| `{}`{} | {} | {} |\n", call(row), row.by_default ? " *" : "", cell(results),
                     cell(meaning));
}

TEST(Readme, CheatSheetHasEveryFunction) {
  const std::pair<Topic, std::string_view> topics[] = {
      {Topic::dynamics, "Dynamics"}, {Topic::kinematics, "Kinematics"}, {Topic::derivatives, "Derivatives"}};
  std::size_t count = 0;
  for (const auto& [topic, title] : topics) {
    std::string rows;
    for (const OutputFunction& row : kOutputFunctions) {
      if (row.topic != topic) continue;
      rows += cheat_sheet_row(row);
      ++count;
    }
    expect_table(
        kCheatSheet,
        fmt::format(
            "### {}\n\n| call | results (size): rows, frames, units | meaning |\n| --- | --- | --- |\n",
            title),
        rows);
  }
  EXPECT_EQ(count, std::size(kOutputFunctions)) << "a topic has no table";
}

}  // namespace
}  // namespace alembert::test

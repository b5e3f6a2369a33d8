// Muscles of the catalogue as tests see them: a description with other text, functions at many states.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command.hpp"

namespace alembert::test {

/// `text` with `from`, which must stand in it, replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

/// The functions (`outputs,state_rates`) of a description at each state, as `evaluate --json` writes them.
inline std::vector<nlohmann::json> values_at(const TemporaryFolder& folder, const std::string& file,
                                             const std::string& functions,
                                             const std::vector<nlohmann::json>& states) {
  std::string lines;
  for (const nlohmann::json& state : states) lines += state.dump() + "\n";
  const CommandResult result =
      alembert(folder, "evaluate --json --functions " + functions + " " + file, lines);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::vector<nlohmann::json> values;
  std::istringstream out(result.out);
  for (std::string line; std::getline(out, line);) values.push_back(nlohmann::json::parse(line));
  EXPECT_EQ(values.size(), states.size());
  return values;
}

/// Where an increasing function, given on [low, high], takes a value.
template <class Function>
double where(const Function& increasing, double value, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (increasing(middle) < value ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace alembert::test

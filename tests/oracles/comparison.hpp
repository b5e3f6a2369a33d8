// Worst errors of one mechanism over random states, against every oracle there is.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracles/alembert_process.hpp"
#include "oracles/engines/engine.hpp"

namespace alembert::oracles {

/// One line of the oracle table.
struct Comparison {
  enum class Verdict { pass, fail, not_expressible, not_installed };
  std::string mechanism, function, oracle;
  std::string formulation;  ///< of the equations under test; empty: an oracle is under test
  double error = 0, tolerance = 0;
  Verdict verdict = Verdict::pass;
  std::string note;  ///< why it failed to run, or is not expressible
};

struct BadlyConditioned : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// States at which M and P M^-1 P^T, scaled to unit diagonals, are well enough conditioned (below 1e5) for
/// accelerations to be compared; throws
/// BadlyConditioned if they are too few.
std::vector<State> comparable_states(const Description& description, int count, std::uint64_t seed);

/// Compares `alembert evaluate`, by both formulations and for every function as it would be generated (or, if
/// `executable` is empty, the numeric Lagrangian) with all oracles. Engines are given `equivalent` instead,
/// if it is not empty: a description of the same mechanism in their words. Runtime parameters have their
/// defaults, or these values. With a `turn`, functions as of functions_in_turn.
std::vector<Comparison> compare(const std::string& executable, const std::string& file, int states,
                                std::uint64_t seed, const std::string& equivalent = "",
                                const std::map<std::string, double>& values = {},
                                std::optional<std::uint64_t> turn = {});

/// Names between commas.
std::set<std::string> names_in(const std::string& list);

/// Prints lines as a table.
void print_table(const std::vector<Comparison>& lines);

}  // namespace alembert::oracles

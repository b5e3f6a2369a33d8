// The generator under test as a black box: a description and states in, what `alembert evaluate FILE --json`
// printed out.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "oracles/state.hpp"
#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_functions.hpp"

namespace alembert::oracles {

struct Answer {
  Dynamics dynamics;
  Eigen::VectorXd rates;        ///< forward dynamics for tau, constrained if there are constraints
  ConstraintRows rows;          ///< empty if there are none
  Eigen::VectorXd multipliers;  ///< of the same size
};

/// What a run of the executable left: its exit code, or minus the signal that ended it.
struct Run {
  int status = 0;
  std::string out, err;
  double seconds = 0;  ///< of processor time
  bool timed_out = false;
};
/// \param seconds  of processor time that it may take; 0: as long as it likes
Run run_alembert(const std::string& executable, const std::vector<std::string>& arguments,
                 const std::string& input, int seconds = 0);

/// The executable did not answer: how its run ended, and what it said.
struct NoAnswer : std::runtime_error {
  NoAnswer(const std::string& what, Run ended) : std::runtime_error(what), run(std::move(ended)) {}
  Run run;
};

/// One line of input for `alembert evaluate --json`.
std::string json_of(const State& state);

/// Runs `executable evaluate file --json --formulation FORMULATION` (auto, factored or reduced). Throws
/// NoAnswer if it fails, or if it does not answer each state.
std::vector<Answer> ask_alembert(const std::string& executable, const std::string& file,
                                 const std::vector<State>& states, const std::string& formulation);

/// The same with `--functions`, of the formulation that is chosen: what each function gives at each state.
/// \param tau  forces at the states
/// \param seconds  of processor time that it may take
std::vector<std::map<std::string, Arrays>> ask_functions(
    const std::string& executable, const std::string& file, const std::vector<State>& states,
    const std::vector<Eigen::VectorXd>& tau, const std::vector<std::string>& functions, int seconds = 0);

}  // namespace alembert::oracles

// The generator under test as a black box: a description and states in, what `alembert evaluate FILE --json`
// printed out.
#pragma once

#include <string>
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

/// One line of input for `alembert evaluate --json`.
std::string json_of(const State& state);

/// Runs `executable evaluate file --json --formulation FORMULATION` (auto, factored or reduced). Throws
/// std::runtime_error with what it said if it fails, or if it does not answer each state.
std::vector<Answer> ask_alembert(const std::string& executable, const std::string& file,
                                 const std::vector<State>& states, const std::string& formulation);

/// The same with `--functions`, of the formulation that is chosen: what each function gives at each state.
/// \param tau  forces at the states
std::vector<std::map<std::string, Arrays>> ask_functions(const std::string& executable,
                                                         const std::string& file,
                                                         const std::vector<State>& states,
                                                         const std::vector<Eigen::VectorXd>& tau,
                                                         const std::vector<std::string>& functions);

}  // namespace alembert::oracles

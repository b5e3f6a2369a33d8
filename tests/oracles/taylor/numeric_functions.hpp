// A mechanism and a state in; out, what each function that can be generated must give there, from motions of
// bodies as numbers.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "oracles/state.hpp"

namespace alembert::oracles {

/// Arrays of one function by name. Vectors are columns; poses are rows [R | p] and inertias rows (mass,
/// centre of mass, xx yy zz xy xz yz), one a body or frame; Jacobians have six rows each.
using Arrays = std::map<std::string, Eigen::MatrixXd>;

/// Whether rows are three angular entries and three of a point: velocities and accelerations.
bool is_six_a_row(const std::string& function);

/// All functions that have a reference; applied forces only where there are any.
std::set<std::string> numeric_function_names(const Description& description);

/// Of these functions the dynamics, constraints, derivatives of inverse dynamics and Jacobians, and of the others each
/// for every seventh of the mechanisms that are numbered by `turn`, of the longest every 13th. Seven and 13 share no
/// factor with the ten kinds of mechanisms, so that each function meets each kind.
std::set<std::string> functions_in_turn(const std::set<std::string>& functions, std::uint64_t turn);

/// By function, all or those that are wanted. Forces of forward dynamics are those that give the state's
/// rates. R is what they are evaluated in, double or long double (constraints always in double).
template <class R = double>
std::map<std::string, Arrays> numeric_functions(const Description& description, const State& state,
                                                const std::set<std::string>& wanted = {});

}  // namespace alembert::oracles

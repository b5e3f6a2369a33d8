// What the functions of a mechanism give at some states, judged against the Taylor oracle in long double.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "oracles/comparison.hpp"
#include "oracles/taylor/numeric_constraints.hpp"

namespace alembert::oracles {

/// 1e-9 of the largest entry of an array. What has parts of different kinds is judged by part: rotations and
/// positions of poses, angular and linear rows of Jacobians, both energies, masses, centres of mass and
/// moments. M is scaled to a unit diagonal first, so that a mirror of 1e-7 kg on a stage of 10 kg counts.
///
/// A state at which the plain equations themselves, in double, are off by more than 1e-10 cannot be judged
/// so: there, 16 times what they are off by is allowed. (The plain equations are the Taylor oracle in
/// double.)
///
/// Accelerations are judged twice. Put into the equations they must leave no force above 1e-9 of the largest
/// force and, as the residual of a backward stable solution is, 64 n eps |M| |qdd|. Scaled to a unit diagonal
/// of M they are right to 1e-9 or, if that is more, 64 n eps times the condition of M so scaled, times how
/// much the forces that cancel exceed their sum. M's inverse, scaled to a unit diagonal of M, and the accelerations'
/// derivatives are right to 1e-9 or, if that is more, 64 n eps times that condition.
///
/// Accelerations and reactions under constraints are put into the equations. They must leave no force above
/// 1e-9 of the largest force, no acceleration of a row above 1e-9 of the terms that it is made of, and 64 n eps
/// times the lengths of motions and reactions in the metric of M more.
inline constexpr double kAgreement = 1e-9;
inline constexpr double kPlainLimit = 1e-10;
inline constexpr double kPlainFactor = 16;
inline constexpr double kStableFactor = 64;

/// All functions that the Taylor oracle knows, without constraints if there are none.
std::set<std::string> comparable_functions(const Description& description);

/// What must come out at one state: in long double, and by plain equations in double.
struct Reference {
  std::map<std::string, Arrays> exact, plain;
  DynamicsOf<long double> dynamics;
  std::optional<ConstraintRowsOf<long double>> rows = {};  ///< if they are asked for
  std::optional<ConstraintRowsOf<double>> plain_rows = {};
};
std::vector<Reference> taylor_references(const Description& description, const std::vector<State>& states,
                                         const std::set<std::string>& functions);

/// One line a function: the worst error relative to what is allowed. One line "all" with a note, if the
/// executable gave no answer.
std::vector<Comparison> compare_functions(const std::string& executable, const std::string& file,
                                          const Description& description, const std::vector<State>& states,
                                          const std::set<std::string>& functions);
/// The same against references that are given.
/// \param seconds  of processor time that it may take; 0: any
std::vector<Comparison> compare_functions(const std::string& executable, const std::string& file,
                                          const std::string& mechanism, const std::vector<State>& states,
                                          const std::vector<Reference>& references,
                                          const std::set<std::string>& functions, int seconds = 0);

/// Accelerations and reactions under constraints and the forces of inverse dynamics: one line, of which the
/// function is "constrained_dynamics".
Comparison compare_constrained(const std::string& executable, const std::string& file,
                               const Description& description, const std::vector<State>& states,
                               const std::vector<Reference>& references);

/// What M's inverse may be off by, relative to its largest entry, both scaled to a unit diagonal of M: 64 n eps times the
/// condition of M so scaled.
double stable_inverse(const MatrixOf<long double>& M);
/// What a backward stable solution may be off by, relative to the largest rate, all scaled to a unit diagonal of
/// M: stable_inverse times how much the forces that cancel exceed their sum.
double stable_accelerations(const DynamicsOf<long double>& dynamics, const VectorOf<long double>& rates);

/// Condition of M scaled to a unit diagonal; infinite where it is not positive definite.
long double scaled_condition(const MatrixOf<long double>& M);

}  // namespace alembert::oracles

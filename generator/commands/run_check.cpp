// `check`: does a description load, and do its equations, by the passes asked for, obey their laws at random
// states?
#include "commands/run_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "commands/common_options.hpp"
#include "commands/run_import.hpp"
#include "commands/warnings.hpp"
#include "dynamics/checks/constraint_checks.hpp"
#include "dynamics/checks/plain_equations.hpp"
#include "dynamics/checks/state_checks.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/tree/state_values.hpp"
#include "mechanism/constraint_rows.hpp"
#include "mechanism/load.hpp"
#include "symbolic/error_bound.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

namespace {

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

/// Random states at which all motions and their derivatives have a value: elsewhere there is no mechanism,
/// and one form of an equation may have a value where another has none.
std::vector<std::vector<double>> random_states(const Kinematics& kinematics) {
  std::vector<Expr> motions;
  for (const MotionNode& node : kinematics.tree.nodes) {
    const Pose pose = moved(identity_pose(kinematics.graph), node.motion);
    motions.insert(motions.end(), pose.rotation.entries.begin(), pose.rotation.entries.end());
    motions.insert(motions.end(), pose.origin.entries.begin(), pose.origin.entries.end());
    motions.insert(motions.end(), node.velocity.entries.begin(), node.velocity.entries.end());
    motions.insert(motions.end(), node.acceleration.entries.begin(), node.acceleration.entries.end());
  }
  std::vector<std::vector<double>> states;
  for (unsigned seed = 1; seed <= 16; ++seed) {
    std::vector<double> state = state_values(kinematics.mechanism, kinematics.graph, seed);
    if (all_finite(evaluate(motions, state))) states.push_back(std::move(state));
  }
  return states;
}

/// Worst difference of two lists of expressions at states, relative to the larger of 1 and the values;
/// infinite where only one of the two has a value, none if nothing could be compared. Differences above
/// `tolerance` that rounding explains, as of sines of very large angles, are passed over.
std::optional<double> worst_difference(std::span<const std::vector<double>> states, std::span<const Expr> x,
                                       std::span<const Expr> y, double tolerance) {
  constexpr double kBoundFactor = 8;  // constants are folded, of which bounds know nothing
  std::optional<double> worst;
  for (const std::vector<double>& state : states) {
    const std::vector<Approximate> a = evaluate_bounded(x, state), b = evaluate_bounded(y, state);
    double scale = 1;
    bool both = true;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const bool one = std::isfinite(a[i].value), other = std::isfinite(b[i].value);
      if (one != other) return std::numeric_limits<double>::infinity();
      both = both && one;
      scale = std::max(scale, std::abs(b[i].value));
    }
    if (!both) continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double difference = std::abs(a[i].value - b[i].value);
      const bool rounding = difference <= kBoundFactor * (a[i].error + b[i].error);
      if (difference > tolerance * scale && rounding) continue;
      worst = std::max(worst.value_or(0), difference / scale);
    }
  }
  return worst;
}

/// False if the law fails. What could not be measured is no failure.
bool report_law(std::string_view name, std::optional<double> worst, double tolerance) {
  if (!worst) {
    fmt::print("{:<52} {:>9} not measured\n", name, "-");
    return true;
  }
  const bool holds = *worst <= tolerance;
  fmt::print("{:<52} {:>9} {}\n", name, fmt::format("{:.1e}", *worst), holds ? "ok" : "FAILS");
  return holds;
}

/// Laws of the constraints; warnings where rows are redundant or the initial state is off.
bool check_constraints(const Kinematics& kinematics, std::span<const Expr> M, Warnings& warnings) {
  const Mechanism& mechanism = kinematics.mechanism;
  const ConstraintEquations equations =
      constraint_equations(mechanism, kinematics.tree, kinematics.derivatives, kinematics.graph);
  const std::vector<ConstraintRow> rows = constraint_rows(mechanism);
  const bool holonomic = std::ranges::any_of(
      rows, [](const ConstraintRow& row) { return row.type == ConstraintType::holonomic; });
  // Rates are measured by finite differences, which have no more digits.
  constexpr double kMeasured = 1e-7;
  const ConstraintLaws laws = constraint_laws(kinematics, equations);
  bool good = true;
  if (holonomic) good = report_law("constraints: d/dt position = velocity", laws.position_rate, kMeasured);
  good = report_law("constraints: d/dt velocity = P qdd + gamma", laws.velocity_rate, kMeasured) && good;

  const auto warn = [&](std::size_t row, const std::string& message) {
    warnings.push_back(
        {mechanism.constraints[rows[row].constraint].where, "row '" + rows[row].name + "' " + message});
  };
  const std::vector<std::size_t> redundant = redundant_rows(kinematics, equations, M);
  fmt::print("constraints: rows {}, rank {} at the initial state, free speeds {}\n", rows.size(),
             rows.size() - redundant.size(),
             static_cast<std::size_t>(mechanism.nv) - (rows.size() - redundant.size()));
  for (const std::size_t row : redundant)
    warn(row, "is redundant at the initial state: the rows before it say the same");
  constexpr double kConsistent = 1e-9;
  for (const InitialResidual& residual : initial_residuals(kinematics, equations, kConsistent)) {
    warn(residual.row,
         fmt::format("does not hold at the initial state: it is off by {:.3g}, its rate by {:.3g}",
                     residual.position, residual.velocity));
  }
  return good;
}

int check_laws(const std::shared_ptr<const SourceText>& source, const Passes& passes, bool strict) {
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(source, graph);
  Warnings warnings = mechanism.warnings;
  const Kinematics kinematics = symbolic_kinematics(mechanism, graph);
  const EquationsOfMotion reduced = equations_of_motion(kinematics, Formulation::reduced, passes);
  try {
    check_mass_matrix(kinematics, PlainEquations(kinematics));
  } catch (const SingularMassMatrix& error) {
    warnings.push_back({error.where(), error.message(), error.note()});
  }
  const EquationsOfMotion factored = equations_of_motion(kinematics, Formulation::factored);

  // Q = M ud + c
  std::vector<Expr> composed = reduced.c;
  const std::size_t nv = static_cast<std::size_t>(mechanism.nv);
  for (std::size_t i = 0; i < nv; ++i) {
    for (std::size_t j = 0; j < nv; ++j)
      composed[i] += reduced.M[i * nv + j] * kinematics.derivatives.rate(static_cast<int>(j));
  }
  const std::vector<Expr> coefficients = coefficient_mass_matrix(mechanism, reduced.Q);

  constexpr double kTolerance = 1e-9;
  const std::vector<std::vector<double>> states = random_states(kinematics);
  bool good = true;
  const auto law = [&](std::string_view name, std::span<const Expr> x, std::span<const Expr> y) {
    good = report_law(name, worst_difference(states, x, y, kTolerance), kTolerance) && good;
  };
  fmt::print("{}: {} coordinates, {} speeds, {} bodies\n", mechanism.name, mechanism.nq, mechanism.nv,
             mechanism.bodies.size());
  law("Q = M qdd + c", reduced.Q, composed);
  law("M = coefficient(Q, qdd)", reduced.M, coefficients);
  law("reduced form = eq. (13): Q", reduced.Q, factored.Q);
  law("reduced form = eq. (13): M", reduced.M, factored.M);
  law("reduced form = eq. (13): c", reduced.c, factored.c);
  if (!mechanism.constraints.empty()) good = check_constraints(kinematics, reduced.M, warnings) && good;
  if (!good)
    throw InternalError(
        "the equations of this mechanism do not obey their laws; please report the description");
  report_warnings(warnings, strict);
  return 0;
}

/// The certificate of every function, at as many states as are asked for. Its warnings are those of the laws.
void report_errors(const std::shared_ptr<const SourceText>& source, const Passes& passes, int states) {
  CompileOptions options;
  options.passes = passes;
  options.inapplicable = Inapplicable::leave_out;
  options.states = states;
  for (const OutputFunction& row : kOutputFunctions) options.functions.emplace_back(row);
  for (const CompiledFunction& function : compile_mechanism(source, options).functions) {
    fmt::print("{}: relative error {:.2g} at {} states\n", to_string(function.kind), function.error.relative,
               function.error.states);
  }
}

}  // namespace

int run_check(const CommonOptions& common, const CheckOptions& options) {
  const std::shared_ptr<const SourceText> source = description_of(common);
  try {
    const int result = check_laws(source, common.passes, common.strict);
    if (options.states > 0) report_errors(source, common.passes, options.states);
    return result;
  } catch (const std::domain_error& error) {
    fail_without_value(source, error);
  }
}

}  // namespace alembert

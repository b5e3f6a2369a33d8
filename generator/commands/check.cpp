// `check`: does a description load, and do its equations obey their laws at random states?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/commands.hpp"
#include "dynamics/formulations.hpp"
#include "dynamics/state_checks.hpp"
#include "mechanism/load.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

/// Worst difference of two lists of expressions at random states, relative to the larger of 1 and the values;
/// none if no state was finite.
std::optional<double> worst_difference(const Mechanism& mechanism, ExprGraph& graph, std::span<const Expr> x,
                                       std::span<const Expr> y) {
  std::optional<double> worst;
  for (unsigned seed = 1; seed <= 16; ++seed) {
    const std::vector<double> state = state_values(mechanism, graph, seed);
    const std::vector<double> a = evaluate(x, state), b = evaluate(y, state);
    double scale = 1, difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      scale = std::max(scale, std::abs(b[i]));
      difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    if (std::isfinite(difference / scale)) worst = std::max(worst.value_or(0), difference / scale);
  }
  return worst;
}

}  // namespace

int run_check(const CommonOptions& common) {
  ExprGraph graph;
  const Mechanism mechanism = load_mechanism(read_source(common.file), graph);
  const Kinematics kinematics = symbolic_kinematics(mechanism, graph);
  const EquationsOfMotion reduced = equations_of_motion(kinematics, Formulation::reduced);
  check_mass_matrix(kinematics, reduced);
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
  bool good = true;
  const auto law = [&](std::string_view name, std::span<const Expr> x, std::span<const Expr> y) {
    const std::optional<double> worst = worst_difference(mechanism, graph, x, y);
    const bool holds = worst && *worst <= kTolerance;
    good = good && holds;
    fmt::print("{:<52} {:>9} {}\n", name, worst ? fmt::format("{:.1e}", *worst) : "no state",
               holds ? "ok" : "FAILS");
  };
  fmt::print("{}: {} coordinates, {} speeds, {} bodies\n", mechanism.name, mechanism.nq, mechanism.nv,
             mechanism.bodies.size());
  law("Q = M qdd + c", reduced.Q, composed);
  law("M = coefficient(Q, qdd)", reduced.M, coefficients);
  law("reduced form = eq. (13): Q", reduced.Q, factored.Q);
  law("reduced form = eq. (13): M", reduced.M, factored.M);
  law("reduced form = eq. (13): c", reduced.c, factored.c);
  if (!good)
    throw InternalError(
        "the equations of this mechanism do not obey their laws; please report the description");
  return 0;
}

}  // namespace alembert

// The comparison behind the oracle table (see the header).
#include "oracles/comparison.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include "oracles/engines/constrained_engine.hpp"
#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_functions.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

constexpr double kTolerance = 1e-9;
constexpr double kConditionLimit = 1e5;
/// Of more bodies `auto` is `reduced`, so that asking for both would only ask twice.
constexpr std::size_t kChosenUpTo = 3;

/// Of M scaled to a unit diagonal, which is what a Cholesky solution's error follows: small links do not
/// count against it.
double condition(const Eigen::MatrixXd& M) {
  if (!M.allFinite() || M.diagonal().minCoeff() <= 0) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * M * scale.asDiagonal();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  return values.minCoeff() <= 0 ? std::numeric_limits<double>::infinity()
                                : values.maxCoeff() / values.minCoeff();
}

void append(std::vector<Comparison>& lines, const Comparison& base, const std::vector<Dynamics>& subject,
            const std::vector<Dynamics>& oracle) {
  Comparison tau = base, mass = base, bias = base;
  tau.function = "inverse_dynamics";
  mass.function = "mass_matrix";
  bias.function = "bias";
  for (std::size_t i = 0; i < oracle.size(); ++i) {
    tau.error = std::max(tau.error, relative_error(subject[i].tau, oracle[i].tau));
    mass.error = std::max(mass.error, relative_error(subject[i].mass_matrix, oracle[i].mass_matrix));
    bias.error = std::max(bias.error, relative_error(subject[i].bias, oracle[i].bias));
  }
  for (Comparison* line : {&tau, &mass, &bias}) {
    line->verdict = line->error <= line->tolerance ? Comparison::Verdict::pass : Comparison::Verdict::fail;
    lines.push_back(*line);
  }
}

Comparison judged(Comparison line, const std::string& function) {
  line.function = function;
  line.verdict = line.error <= line.tolerance ? Comparison::Verdict::pass : Comparison::Verdict::fail;
  return line;
}

/// Accelerations under the forces that unconstrained motion with the state's rates takes, and, with
/// constraints, their rows and the reactions P^T lambda.
void append_forward(std::vector<Comparison>& lines, const Comparison& base,
                    const std::vector<Answer>& answers, const Description& description,
                    const std::vector<State>& states) {
  Comparison forward = base, rows = base, reactions = base;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Answer& answer = answers[i];
    const auto grow = [](Comparison& line, const Eigen::MatrixXd& subject, const Eigen::MatrixXd& oracle) {
      line.error = std::max(line.error, relative_error(subject, oracle));
    };
    if (description.constraints.empty()) {
      const Eigen::Map<const Eigen::VectorXd> rates(states[i].rates.data(),
                                                    static_cast<Eigen::Index>(states[i].rates.size()));
      grow(forward, answer.rates, rates);
      continue;
    }
    const ConstraintRows expected = numeric_constraints(description, states[i]);
    grow(rows, answer.rows.P, expected.P);
    grow(rows, answer.rows.gamma, expected.gamma);
    grow(rows, answer.rows.velocity, expected.velocity);
    grow(rows, answer.rows.position, expected.position);
    const ConstrainedMotion motion = constrained_motion(numeric_lagrangian(description, states[i]), expected);
    grow(forward, answer.rates, motion.rates);
    if (answer.multipliers.size() != motion.multipliers.size()) {
      reactions.error = std::numeric_limits<double>::infinity();
      continue;
    }
    grow(reactions, answer.rows.P.transpose() * answer.multipliers,
         expected.P.transpose() * motion.multipliers);
  }
  lines.push_back(judged(forward, "forward_dynamics"));
  if (description.constraints.empty()) return;
  lines.push_back(judged(rows, "constraints"));
  lines.push_back(judged(reactions, "reactions"));
}

/// Each function as it would be generated. What inverse dynamics, M and c are at the states goes to
/// `subject`.
void append_functions(std::vector<Comparison>& lines, const Comparison& base, const std::string& executable,
                      const std::string& file, const Description& description,
                      const std::vector<State>& states, std::optional<std::uint64_t> turn,
                      std::vector<Dynamics>& subject) {
  std::set<std::string> wanted = numeric_function_names(description);
  if (turn) wanted = functions_in_turn(wanted, *turn);
  std::vector<std::map<std::string, Arrays>> expected;
  std::vector<Eigen::VectorXd> tau;
  for (const State& state : states) {
    expected.push_back(numeric_functions<double>(description, state, wanted));
    tau.emplace_back(expected.back().at("inverse_dynamics").at("tau"));
  }
  std::vector<std::string> functions;
  for (const auto& [function, arrays] : expected.front()) functions.push_back(function);
  const auto found = ask_functions(executable, file, states, tau, functions);
  for (const std::string& function : functions) {
    Comparison line = base;
    for (std::size_t i = 0; i < states.size(); ++i) {
      for (const auto& [name, values] : expected[i].at(function)) {
        const Eigen::MatrixXd& subjects = found[i].at(function).at(name);
        if (values.size() > 0 || subjects.size() > 0)
          line.error = std::max(line.error, relative_error(subjects, values));
      }
    }
    lines.push_back(judged(line, function));
    if (!expected.front().at(function).empty()) continue;
    lines.back().verdict = Comparison::Verdict::not_expressible;
    lines.back().note = "rounding does not tell what is independent";
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    subject[i] = {found[i].at("inverse_dynamics").at("tau"), found[i].at("mass_matrix").at("M"),
                  found[i].at("bias").at("c")};
  }
}

void append_engine(std::vector<Comparison>& lines, Comparison base, const Engine& engine,
                   const Description& description, const std::vector<State>& states,
                   const std::vector<Dynamics>& subject) {
  base.oracle = engine.name;
  base.tolerance = engine.tolerance;
  base.function = "all";
  if (!engine.make) {
    base.verdict = Comparison::Verdict::not_installed;
    return lines.push_back(base);
  }
  try {
    const JointTree tree(description);
    const auto model = engine.make(tree);
    std::vector<Dynamics> dynamics;
    for (const State& state : states) dynamics.push_back(engine_dynamics(*model, tree, state));
    append(lines, base, subject, dynamics);
  } catch (const NotExpressible& reason) {
    base.verdict = Comparison::Verdict::not_expressible;
    base.note = reason.what();
    lines.push_back(base);
  } catch (const std::exception& failure) {
    base.verdict = Comparison::Verdict::fail;
    base.error = std::numeric_limits<double>::infinity();
    base.note = failure.what();
    lines.push_back(base);
  }
}

bool well_conditioned(const Description& description, const State& state) {
  const Dynamics dynamics = numeric_lagrangian(description, state);
  if (!(condition(dynamics.mass_matrix) < kConditionLimit)) return false;
  if (description.constraints.empty()) return true;
  return constrained_motion(dynamics, numeric_constraints(description, state)).condition < kConditionLimit;
}

/// Random states near the initial one that keep the constraints, with rates that take no forces.
std::vector<State> constrained_states(const Description& description, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<State> states;
  for (int trial = 0; trial < 50 * count && static_cast<int>(states.size()) < count; ++trial) {
    State near = random_state(description, random);
    for (const Coordinate& c : description.coordinates) {
      double square = 0;
      for (std::size_t i = 0; i < c.initial.size(); ++i) {
        double& x = near.q[static_cast<std::size_t>(c.first_q) + i];
        x = c.initial[i] + 0.2 * (x - c.initial[i]);
        square += x * x;
      }
      for (std::size_t i = 0; c.quaternion && i < 4; ++i)
        near.q[static_cast<std::size_t>(c.first_q) + i] /= std::sqrt(square);
    }
    std::optional<State> state = consistent(description, near);
    if (!state || !well_conditioned(description, *state)) continue;
    const Dynamics dynamics = numeric_lagrangian(description, *state);
    const Eigen::VectorXd rates = dynamics.mass_matrix.ldlt().solve(-dynamics.bias);
    state->rates.assign(rates.begin(), rates.end());
    states.push_back(*state);
  }
  if (static_cast<int>(states.size()) < count)
    throw BadlyConditioned(description.name + ": too few states keep the constraints");
  return states;
}

/// Accelerations of bodies under constraints and no forces but gravity, at states that keep the constraints.
void append_constrained_engine(std::vector<Comparison>& lines, Comparison base, const std::string& executable,
                               const std::string& file, const Description& description, int count,
                               std::uint64_t seed) {
  base.oracle = "Simbody";
  base.tolerance = kTolerance;
  base.formulation = executable.empty() ? "" : "auto";
  base.function = "forward_dynamics";
  const ConstrainedEngine engine = constrained_simbody();
  if (!engine.accelerations) {
    base.verdict = Comparison::Verdict::not_installed;
    return lines.push_back(base);
  }
  if (!engine.expresses(description)) {
    base.verdict = Comparison::Verdict::not_expressible;
    base.note = "constraints not written down for Simbody";
    return lines.push_back(base);
  }
  const std::vector<State> states = constrained_states(description, count, seed);
  std::vector<Answer> answers;
  if (!executable.empty()) answers = ask_alembert(executable, file, states, "auto");
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::VectorXd rates = executable.empty()
                                      ? constrained_motion(numeric_lagrangian(description, states[i]),
                                                           numeric_constraints(description, states[i]))
                                            .rates
                                      : answers[i].rates;
    base.error = std::max(base.error, relative_error(body_accelerations(description, states[i], rates),
                                                     engine.accelerations(description, states[i])));
  }
  lines.push_back(judged(base, "forward_dynamics"));
}

const char* to_string(Comparison::Verdict verdict) {
  switch (verdict) {
    case Comparison::Verdict::pass:
      return "PASS";
    case Comparison::Verdict::fail:
      return "FAIL";
    case Comparison::Verdict::not_expressible:
      return "-";
    case Comparison::Verdict::not_installed:
      return "not installed";
  }
  return "?";
}

}  // namespace

std::vector<State> comparable_states(const Description& description, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<State> states;
  for (int trial = 0; trial < 20 * count && static_cast<int>(states.size()) < count; ++trial) {
    const State state = random_state(description, random);
    if (well_conditioned(description, state)) states.push_back(state);
  }
  if (static_cast<int>(states.size()) < count) {
    throw BadlyConditioned(description.name +
                           ": M or its constraints are badly conditioned at almost all states");
  }
  return states;
}

std::vector<Comparison> compare(const std::string& executable, const std::string& file, int count,
                                std::uint64_t seed, const std::string& equivalent,
                                const std::map<std::string, double>& values,
                                std::optional<std::uint64_t> turn) {
  Comparison base;
  base.mechanism = file;
  base.oracle = "Taylor";
  base.tolerance = kTolerance;
  std::vector<Comparison> lines;
  try {
    const Description description = read_description(file, values);
    base.mechanism = description.name;
    const std::vector<State> states = comparable_states(description, count, seed);
    std::vector<Dynamics> taylor;
    for (const State& state : states) taylor.push_back(numeric_lagrangian(description, state));
    std::vector<Dynamics> subject = taylor;
    if (!executable.empty()) {
      for (const std::string formulation : {"factored", "reduced"}) {
        if (formulation == "reduced" && description.bodies.size() > kChosenUpTo) continue;
        base.formulation = formulation;
        const std::vector<Answer> answers = ask_alembert(executable, file, states, formulation);
        for (std::size_t i = 0; i < states.size(); ++i) subject[i] = answers[i].dynamics;
        append(lines, base, subject, taylor);
        append_forward(lines, base, answers, description, states);
      }
      base.formulation = "auto";
      append_functions(lines, base, executable, file, description, states, turn, subject);
    }
    const Description for_engines = equivalent.empty() ? description : read_description(equivalent);
    if (!equivalent.empty() && executable.empty()) {
      base.oracle = "Taylor";
      std::vector<Dynamics> other;
      for (const State& state : states) other.push_back(numeric_lagrangian(for_engines, state));
      append(lines, base, subject, other);
    }
    for (const Engine& engine : engines()) append_engine(lines, base, engine, for_engines, states, subject);
    if (!description.constraints.empty())
      append_constrained_engine(lines, base, executable, file, description, count, seed);
  } catch (const std::exception& failure) {
    base.function = "all";
    base.verdict = Comparison::Verdict::fail;
    base.error = std::numeric_limits<double>::infinity();
    base.note = failure.what();
    lines.push_back(base);
  }
  return lines;
}

std::set<std::string> names_in(const std::string& list) {
  std::set<std::string> names;
  std::istringstream words(list);
  for (std::string name; std::getline(words, name, ',');) names.insert(name);
  return names;
}

void print_table(const std::vector<Comparison>& lines) {
  std::printf("%-22s %-28s %-11s %-8s %12s %8s  %s\n", "mechanism", "function", "formulation", "oracle",
              "worst error", "within", "verdict");
  for (const Comparison& line : lines) {
    const bool measured =
        line.verdict == Comparison::Verdict::pass || line.verdict == Comparison::Verdict::fail;
    char error[32] = "", tolerance[32] = "";
    if (measured) {
      std::snprintf(error, sizeof error, "%.1e", line.error);
      std::snprintf(tolerance, sizeof tolerance, "%.0e", line.tolerance);
    }
    std::printf("%-22s %-28s %-11s %-8s %12s %8s  %s%s%s\n", line.mechanism.c_str(), line.function.c_str(),
                line.formulation.c_str(), line.oracle.c_str(), error, tolerance, to_string(line.verdict),
                line.note.empty() ? "" : "  ", line.note.c_str());
  }
}

}  // namespace alembert::oracles

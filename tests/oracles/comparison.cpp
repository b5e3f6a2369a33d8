// The comparison behind the oracle table (see the header).
#include "oracles/comparison.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

constexpr double kTolerance = 1e-9;
constexpr double kConditionLimit = 1e5;

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

void append_forward(std::vector<Comparison>& lines, const Comparison& base,
                    const std::vector<Answer>& answers, const std::vector<State>& states) {
  Comparison line = base;
  line.function = "forward_dynamics";
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::Map<const Eigen::VectorXd> rates(states[i].rates.data(),
                                                  static_cast<Eigen::Index>(states[i].rates.size()));
    line.error = std::max(line.error, relative_error(answers[i].rates, rates));
  }
  line.verdict = line.error <= line.tolerance ? Comparison::Verdict::pass : Comparison::Verdict::fail;
  lines.push_back(line);
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
    if (condition(numeric_lagrangian(description, state).mass_matrix) < kConditionLimit)
      states.push_back(state);
  }
  if (static_cast<int>(states.size()) < count) {
    throw BadlyConditioned(description.name + ": M is badly conditioned at almost all states");
  }
  return states;
}

std::vector<Comparison> compare(const std::string& executable, const std::string& file, int count,
                                std::uint64_t seed, const std::string& equivalent) {
  Comparison base;
  base.mechanism = file;
  base.oracle = "Taylor";
  base.tolerance = kTolerance;
  std::vector<Comparison> lines;
  try {
    const Description description = read_description(file);
    base.mechanism = description.name;
    const std::vector<State> states = comparable_states(description, count, seed);
    std::vector<Dynamics> taylor;
    for (const State& state : states) taylor.push_back(numeric_lagrangian(description, state));
    std::vector<Dynamics> subject = taylor;
    if (!executable.empty()) {
      for (const char* formulation : {"factored", "reduced", "auto"}) {
        base.formulation = formulation;
        const std::vector<Answer> answers = ask_alembert(executable, file, states, formulation);
        for (std::size_t i = 0; i < states.size(); ++i) subject[i] = answers[i].dynamics;
        append(lines, base, subject, taylor);
        append_forward(lines, base, answers, states);
      }
    }
    const Description for_engines = equivalent.empty() ? description : read_description(equivalent);
    if (!equivalent.empty() && executable.empty()) {
      base.oracle = "Taylor";
      std::vector<Dynamics> other;
      for (const State& state : states) other.push_back(numeric_lagrangian(for_engines, state));
      append(lines, base, subject, other);
    }
    for (const Engine& engine : engines()) append_engine(lines, base, engine, for_engines, states, subject);
  } catch (const std::exception& failure) {
    base.function = "all";
    base.verdict = Comparison::Verdict::fail;
    base.error = std::numeric_limits<double>::infinity();
    base.note = failure.what();
    lines.push_back(base);
  }
  return lines;
}

void print_table(const std::vector<Comparison>& lines) {
  std::printf("%-22s %-18s %-11s %-8s %12s %8s  %s\n", "mechanism", "function", "formulation", "oracle",
              "worst error", "within", "verdict");
  for (const Comparison& line : lines) {
    const bool measured =
        line.verdict == Comparison::Verdict::pass || line.verdict == Comparison::Verdict::fail;
    char error[32] = "", tolerance[32] = "";
    if (measured) {
      std::snprintf(error, sizeof error, "%.1e", line.error);
      std::snprintf(tolerance, sizeof tolerance, "%.0e", line.tolerance);
    }
    std::printf("%-22s %-18s %-11s %-8s %12s %8s  %s%s%s\n", line.mechanism.c_str(), line.function.c_str(),
                line.formulation.c_str(), line.oracle.c_str(), error, tolerance, to_string(line.verdict),
                line.note.empty() ? "" : "  ", line.note.c_str());
  }
}

}  // namespace alembert::oracles

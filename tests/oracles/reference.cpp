// Judges answers, part by part (see the header).
#include "oracles/reference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "oracles/taylor/numeric_constraints.hpp"
#include "oracles/taylor/numeric_functions.hpp"
#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

using Wide = long double;
using Matrices = std::vector<Eigen::MatrixXd>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Below this part of its largest value over all states, a value counts for so much.
constexpr double kFloor = 1e-6;

Eigen::MatrixXd columns(const Eigen::MatrixXd& from, const std::vector<Eigen::Index>& which) {
  return from(Eigen::all, which);
}

/// Rows r with r % 6 below 3, or those not.
Eigen::MatrixXd half_rows(const Eigen::MatrixXd& from, bool first) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index r = 0; r < from.rows(); ++r)
    if ((r % 6 < 3) == first) rows.push_back(r);
  return from(rows, Eigen::all);
}

/// Parts of an array that are judged one by one. `unit` scales M.
Matrices parts(const std::string& function, const std::string& name, const Eigen::MatrixXd& values,
               const Eigen::VectorXd& unit) {
  if (values.size() == 0) return {values};
  if (function == "body_poses" || function == "frame_poses") {
    return {columns(values, {0, 1, 2, 4, 5, 6, 8, 9, 10}), columns(values, {3, 7, 11})};
  }
  if (is_six_a_row(function)) return {columns(values, {0, 1, 2}), columns(values, {3, 4, 5})};
  if (name == "Minv" || name == "qdd_tau") {
    const Eigen::VectorXd back = unit.cwiseInverse();
    return {back.asDiagonal() * values * back.asDiagonal()};
  }
  if (name == "lambda_q" || name == "lambda_qd") return {values};
  if (name == "lambda_tau") return {values * unit.cwiseInverse().asDiagonal()};
  if (name == "qdd_q" || name == "qdd_qd") return {unit.cwiseInverse().asDiagonal() * values};
  if (function == "body_jacobians" || function == "frame_jacobians" || function == "frame_jacobian_rates" ||
      (function == "centroidal_momentum" && name != "com"))
    return {half_rows(values, true), half_rows(values, false)};
  if (function == "energy") return {values.topRows(1), values.bottomRows(1)};
  if (function == "body_inertias")
    return {columns(values, {0}), columns(values, {1, 2, 3}), columns(values, {4, 5, 6, 7, 8, 9})};
  if (function == "base_regressor") return {unit.asDiagonal() * values};
  if (name == "Y") {
    // Columns by what they are multiplied with.
    Matrices all;
    for (const auto& [first, end] : {std::pair(0, 1), std::pair(1, 4), std::pair(4, 10)}) {
      std::vector<Eigen::Index> which;
      for (Eigen::Index c = 0; c < values.cols(); ++c)
        if (c % 10 >= first && c % 10 < end) which.push_back(c);
      const Eigen::MatrixXd some = columns(values, which);
      if (function == "energy_regressor") {
        all.push_back(some.topRows(1));
        all.push_back(some.bottomRows(1));
      } else {
        all.push_back(unit.asDiagonal() * some);
      }
    }
    return all;
  }
  if (name == "M" || name == "C") return {unit.asDiagonal() * values * unit.asDiagonal()};
  if (name == "Minv") return {unit.asDiagonal().inverse() * values * unit.asDiagonal().inverse()};
  return {values};
}

bool same_shape(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a.size() == 0 && b.size() == 0) || (a.rows() == b.rows() && a.cols() == b.cols());
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (!same_shape(a, b) || !a.allFinite()) return kInfinity;
  return a.size() == 0 ? 0 : (a - b).cwiseAbs().maxCoeff();
}

struct Judged {
  double error = 0, allowed = kAgreement;
  std::string where = {};
};
void keep_worse(Judged& worst, const Judged& other) {
  if (other.error / other.allowed > worst.error / worst.allowed) worst = other;
}

/// 1/sqrt of M's diagonal; of its largest entry, for coordinates that move no mass.
Eigen::VectorXd unit_of(const Reference& state) {
  VectorOf<Wide> diagonal = state.dynamics.mass_matrix.diagonal();
  const Wide largest = diagonal.maxCoeff();
  for (Wide& x : diagonal)
    if (x <= 0) x = largest > 0 ? largest : 1;
  return diagonal.cwiseSqrt().cwiseInverse().cast<double>();
}

/// By function, the function and its array that an array is made of by differentiating once more.
const std::map<std::string, std::pair<std::string, std::string>>& origins() {
  static const std::map<std::string, std::pair<std::string, std::string>> all{
      {"frame_bias_accelerations", {"frame_velocities", "V"}},
      {"frame_jacobian_rates", {"frame_jacobians", "J"}},
      {"coriolis_matrix", {"mass_matrix", "M"}},
      {"body_accelerations", {"body_velocities", "V"}},
      {"centroidal_momentum", {"centroidal_momentum", "h"}}};
  return all;
}

/// What the parts of an array are made of, where they may cancel to rounding at every state, as the angular
/// accelerations of turns about parallel axes do: its largest entry times the largest speed, or the rates that the
/// forces alone would give. Nothing, where there is no such array.
std::vector<double> made_of(const std::string& function, const std::string& name, const Reference& state) {
  const Eigen::VectorXd unit = unit_of(state);
  if (name == "qdd_q" || name == "qdd_qd")
    return {unit.cwiseProduct(state.exact.at("inverse_dynamics").at("tau")).cwiseAbs().maxCoeff()};
  if (function == "regressor") {
    // The column of a mass is the acceleration of its body's origin times the origin's distance from the axis.
    const auto J = state.exact.find("body_jacobians");
    if (J == state.exact.end()) return {};
    const Eigen::MatrixXd ways = half_rows(J->second.at("J"), false) * unit.asDiagonal();
    const Eigen::MatrixXd& Y = state.exact.at(function).at(name);
    double acceleration = 0;
    for (Eigen::Index c = 0; c < Y.cols(); ++c)
      if (c % 10 >= 1 && c % 10 < 4) acceleration = std::max(acceleration, Y.col(c).cwiseAbs().maxCoeff());
    return {ways.cwiseAbs().maxCoeff() * acceleration};
  }
  const auto from = origins().find(function);
  if (from == origins().end() || (function == "centroidal_momentum" && name != "bias")) return {};
  const auto there = state.exact.find(from->second.first), rates = state.exact.find("coordinate_rates");
  if (there == state.exact.end() || rates == state.exact.end()) return {};
  const double fastest = rates->second.at("qdot").cwiseAbs().maxCoeff();
  std::vector<double> sizes;
  for (const Eigen::MatrixXd& part :
       parts(there->first, from->second.second, there->second.at(from->second.second), unit))
    sizes.push_back(part.size() == 0 ? 0 : fastest * part.cwiseAbs().maxCoeff());
  return sizes;
}

/// One array at all states.
Judged judge_array(const std::string& function, const std::string& name, const std::vector<Reference>& states,
                   const std::vector<std::map<std::string, Arrays>>& found) {
  Judged worst;
  std::vector<Matrices> exact;
  std::vector<double> largest;
  for (const Reference& state : states) {
    exact.push_back(parts(function, name, state.exact.at(function).at(name), unit_of(state)));
    if (!state.exact.at(function).at(name).allFinite()) return {kInfinity, kAgreement};
    // Forces and rates that do not depend on something have derivatives that are rounding of theirs.
    largest.resize(exact.back().size(), 0.0);
    const auto floor_by = [&](const std::string& of, const std::string& values) {
      const auto rates = state.exact.find(of);
      if (rates != state.exact.end() && rates->second.at(values).size() > 0)
        largest[0] = std::max(largest[0], rates->second.at(values).cwiseAbs().maxCoeff());
    };
    if (function.rfind("inverse_dynamics_", 0) == 0) floor_by("inverse_dynamics", "tau");
    if (function == "state_rates_derivatives") floor_by("state_rates", "sdot");
    const std::vector<double> from = made_of(function, name, state);
    for (std::size_t p = 0; p < std::min(from.size(), largest.size()); ++p)
      largest[p] = std::max(largest[p], from[p]);
    for (std::size_t p = 0; p < largest.size(); ++p) {
      if (exact.back()[p].size() > 0)
        largest[p] = std::max(largest[p], exact.back()[p].cwiseAbs().maxCoeff());
    }
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::MatrixXd& subject = found[i].at(function).at(name);
    if (!same_shape(subject, states[i].exact.at(function).at(name))) return {kInfinity, kAgreement};
    const Matrices subjects = parts(function, name, subject, unit_of(states[i]));
    const Matrices plain = parts(function, name, states[i].plain.at(function).at(name), unit_of(states[i]));
    for (std::size_t p = 0; p < subjects.size(); ++p) {
      if (exact[i][p].size() == 0) continue;
      double scale = std::max(exact[i][p].cwiseAbs().maxCoeff(), kFloor * largest[p]);
      // Gravity is a part of the forces. Where axes are vertical but for the rounding of pi/2, what is left of the
      // weights in it is that rounding.
      if (function == "gravity")
        scale = std::max(scale, states[i].exact.at("inverse_dynamics").at("tau").cwiseAbs().maxCoeff());
      // So are the columns at rest of those of a motion.
      if (function == "static_regressor")
        scale = std::max(
            scale, parts("regressor", name, states[i].exact.at("regressor").at(name), unit_of(states[i]))[p]
                       .cwiseAbs()
                       .maxCoeff());
      const auto relative = [&](double x) { return x == 0 ? 0 : x / scale; };
      Judged here{relative(difference(subjects[p], exact[i][p])), kAgreement};
      const double by_plain = relative(difference(plain[p], exact[i][p]));
      if (by_plain > kPlainLimit) here.allowed = std::max(kAgreement, kPlainFactor * by_plain);
      if (name == "Minv" || name.rfind("qdd_", 0) == 0)
        here.allowed = std::max(here.allowed, stable_inverse(states[i].dynamics.mass_matrix));
      here.where = name + " at state " + std::to_string(i + 1);
      keep_worse(worst, here);
    }
  }
  return worst;
}

/// Accelerations at one state.
Judged judge_rates(const Reference& state, const Eigen::VectorXd& found) {
  const auto n = static_cast<Eigen::Index>(state.dynamics.bias.size());
  if (found.size() != n || !found.allFinite()) return {kInfinity, kAgreement};
  const MatrixOf<Wide>& M = state.dynamics.mass_matrix;
  const VectorOf<Wide>& c = state.dynamics.bias;
  const VectorOf<Wide> qdd = found.cast<Wide>();
  const VectorOf<Wide> tau = state.exact.at("inverse_dynamics").at("tau").cast<Wide>();  // as it was given
  const double stable = kStableFactor * static_cast<double>(n) * std::numeric_limits<double>::epsilon();

  const VectorOf<Wide> forces = M.cwiseAbs() * qdd.cwiseAbs();
  const Wide largest =
      std::max({tau.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff(), forces.maxCoeff() * stable});
  const Wide residual = (M * qdd + c - tau).cwiseAbs().maxCoeff();
  Judged result;
  if (residual > 0) {
    result.error = static_cast<double>(residual / largest);
    result.allowed = kAgreement + static_cast<double>(stable * forces.maxCoeff() / largest);
  }

  const VectorOf<Wide> unit = M.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixOf<Wide> scaled = unit.asDiagonal() * M * unit.asDiagonal();
  const VectorOf<Wide> right = unit.cwiseProduct(tau - c);
  const VectorOf<Wide> expected = scaled.ldlt().solve(right);
  const VectorOf<Wide> given = qdd.cwiseQuotient(unit);
  const Wide size = expected.cwiseAbs().maxCoeff();
  const Wide off = (given - expected).cwiseAbs().maxCoeff();
  if (off == 0) return result;
  const double allowed = stable_accelerations({tau, M, c}, expected.cwiseProduct(unit));
  keep_worse(result, {static_cast<double>(off / size), std::max(kAgreement, allowed)});
  return result;
}

/// Sizes of what sums to zero in each row of constraints.
VectorOf<Wide> terms_of(const ConstraintRowsOf<Wide>& rows, const VectorOf<Wide>& qdd) {
  return rows.P.cwiseAbs() * qdd.cwiseAbs() + rows.gamma.cwiseAbs();
}

/// Accelerations and reactions under constraints at one state. `largest_terms` are the largest of each row over all
/// states: where a step is flat, its curvature is the rounding of terms as large as those on its slope.
Judged judge_constrained(const Reference& state, const ConstraintRowsOf<Wide>& rows,
                         const ConstraintRowsOf<double>& plain, const Answer& answer,
                         const VectorOf<Wide>& largest_terms) {
  const Eigen::Index n = state.dynamics.bias.size(), m = rows.gamma.size();
  if (answer.rates.size() != n || answer.multipliers.size() != m || !answer.rates.allFinite() ||
      !answer.multipliers.allFinite())
    return {kInfinity, kAgreement};
  const MatrixOf<Wide>& M = state.dynamics.mass_matrix;
  const VectorOf<Wide>& c = state.dynamics.bias;
  const VectorOf<Wide> tau = state.exact.at("inverse_dynamics").at("tau").cast<Wide>();
  const VectorOf<Wide> qdd = answer.rates.cast<Wide>(), lambda = answer.multipliers.cast<Wide>();
  const double stable = kStableFactor * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  // Lengths of rows in the metric of M^-1, of the motion and of the reactions in that of M.
  const VectorOf<Wide> row = (rows.P * M.ldlt().solve(rows.P.transpose())).diagonal().cwiseSqrt();
  const Wide motion = std::sqrt(qdd.dot(M * qdd)), reaction = row.dot(lambda.cwiseAbs());

  const VectorOf<Wide> forces = M.cwiseAbs() * qdd.cwiseAbs();
  const VectorOf<Wide> reactions = rows.P.cwiseAbs().transpose() * lambda.cwiseAbs();
  const Wide largest = std::max(
      {tau.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff(), reactions.maxCoeff(), forces.maxCoeff() * stable});
  const Wide rounding = stable * (forces.maxCoeff() + std::sqrt(M.diagonal().maxCoeff()) * reaction);
  const Wide left = (M * qdd + c - tau - rows.P.transpose() * lambda).cwiseAbs().maxCoeff();
  Judged worst;
  if (left > 0)
    worst = {static_cast<double>(left / largest), kAgreement + static_cast<double>(rounding / largest)};
  const VectorOf<Wide> slip = (rows.P * qdd + rows.gamma).cwiseAbs();
  const VectorOf<Wide> terms = terms_of(rows, qdd);
  // What cancels in a row weighs by the motion that it does not constrain, and by what reactions do alone: those of rows
  // that nearly follow from each other are large, and hold against each other.
  const VectorOf<Wide> by_plain = (plain.P.cast<Wide>() - rows.P).cwiseAbs() * qdd.cwiseAbs() +
                                  (plain.gamma.cast<Wide>() - rows.gamma).cwiseAbs();
  for (Eigen::Index i = 0; i < m; ++i) {
    if (!(slip[i] > 0)) continue;
    const Wide rounded = stable * (row[i] * (motion + reaction) + largest_terms[i]) +
                         (by_plain[i] > kPlainLimit * terms[i] ? kPlainFactor * by_plain[i] : 0);
    keep_worse(worst, {static_cast<double>(slip[i] / terms[i]),
                       kAgreement + static_cast<double>(rounded / terms[i])});
  }
  return worst;
}

/// The same at all states.
Judged judge_constrained(const std::vector<Reference>& states,
                         const std::vector<ConstraintRowsOf<Wide>>& rows,
                         const std::vector<ConstraintRowsOf<double>>& plain,
                         const std::vector<Answer>& answers) {
  VectorOf<Wide> largest = VectorOf<Wide>::Zero(rows.front().gamma.size());
  for (std::size_t i = 0; i < states.size(); ++i)
    if (answers[i].rates.size() == rows[i].P.cols() && answers[i].rates.allFinite())
      largest = largest.cwiseMax(terms_of(rows[i], answers[i].rates.cast<Wide>()));
  Judged worst;
  for (std::size_t i = 0; i < states.size(); ++i)
    keep_worse(worst, judge_constrained(states[i], rows[i], plain[i], answers[i], largest));
  return worst;
}

}  // namespace

double stable_inverse(const MatrixOf<long double>& M) {
  return kStableFactor * static_cast<double>(M.rows()) * std::numeric_limits<double>::epsilon() *
         static_cast<double>(scaled_condition(M));
}

double stable_accelerations(const DynamicsOf<long double>& dynamics, const VectorOf<long double>& rates) {
  const VectorOf<Wide> unit = dynamics.mass_matrix.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixOf<Wide> scaled = unit.asDiagonal() * dynamics.mass_matrix * unit.asDiagonal();
  const Wide cancelled = unit.cwiseProduct(dynamics.tau.cwiseAbs() + dynamics.bias.cwiseAbs()).maxCoeff() /
                         (scaled.cwiseAbs() * rates.cwiseQuotient(unit).cwiseAbs()).maxCoeff();
  return stable_inverse(dynamics.mass_matrix) * static_cast<double>(1 + cancelled);
}

long double scaled_condition(const MatrixOf<long double>& M) {
  const long double infinity = std::numeric_limits<long double>::infinity();
  if (!M.allFinite() || M.diagonal().minCoeff() <= 0) return infinity;
  const VectorOf<Wide> unit = M.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixOf<Wide> scaled = unit.asDiagonal() * M * unit.asDiagonal();
  const VectorOf<Wide> values =
      Eigen::SelfAdjointEigenSolver<MatrixOf<Wide>>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  return values.minCoeff() <= 0 ? infinity : values.maxCoeff() / values.minCoeff();
}

std::set<std::string> comparable_functions(const Description& description) {
  std::set<std::string> all = numeric_function_names(description);
  // Which columns are independent, no rounding tells where axes nearly meet.
  all.erase("base_regressor");
  // Without a mass there is no centre of mass.
  if (std::ranges::all_of(description.bodies, [](const Body& body) { return body.mass == 0; }))
    all.erase("centroidal_momentum");
  for (auto name = all.begin(); name != all.end();) {
    const bool has_none = (name->rfind("frame_", 0) == 0 && description.frames.empty()) ||
                          (*name == "constraints" && description.constraints.empty());
    name = has_none ? all.erase(name) : std::next(name);
  }
  return all;
}

std::vector<Reference> taylor_references(const Description& description, const std::vector<State>& states,
                                         const std::set<std::string>& functions) {
  std::set<std::string> wanted = functions;
  wanted.insert("inverse_dynamics");
  // What errors are measured by.
  for (const std::string& function : functions) {
    const auto from = origins().find(function);
    if (from == origins().end()) continue;
    wanted.insert(from->second.first);
    wanted.insert("coordinate_rates");
  }
  if (functions.count("state_rates_derivatives") != 0) wanted.insert("state_rates");
  if (functions.count("static_regressor") != 0) wanted.insert("regressor");
  if (functions.count("regressor") != 0) wanted.insert("body_jacobians");
  std::vector<Reference> all;
  for (const State& state : states) {
    all.push_back({numeric_functions<Wide>(description, state, wanted),
                   numeric_functions<double>(description, state, wanted),
                   numeric_lagrangian<Wide>(description, state),
                   {}});
    if (wanted.count("constrained_forward_dynamics") != 0) {
      all.back().rows = numeric_constraints<Wide>(description, state);
      all.back().plain_rows = numeric_constraints<double>(description, state);
    }
  }
  return all;
}

std::vector<Comparison> compare_functions(const std::string& executable, const std::string& file,
                                          const Description& description, const std::vector<State>& states,
                                          const std::set<std::string>& functions) {
  return compare_functions(executable, file, description.name, states,
                           taylor_references(description, states, functions), functions);
}

std::vector<Comparison> compare_functions(const std::string& executable, const std::string& file,
                                          const std::string& mechanism, const std::vector<State>& states,
                                          const std::vector<Reference>& references,
                                          const std::set<std::string>& functions, int seconds) {
  Comparison base;
  base.mechanism = mechanism;
  base.oracle = "Taylor";
  base.formulation = "auto";
  base.tolerance = kAgreement;
  std::vector<Eigen::VectorXd> tau;
  for (const Reference& state : references) tau.emplace_back(state.exact.at("inverse_dynamics").at("tau"));
  std::vector<std::map<std::string, Arrays>> found;
  try {
    found = ask_functions(executable, file, states, tau, {functions.begin(), functions.end()}, seconds);
  } catch (const NoAnswer& failure) {
    base.function = "all";
    base.error = kInfinity;
    base.verdict = Comparison::Verdict::fail;
    base.note = failure.what();
    return {base};
  }
  std::vector<Comparison> lines;
  for (const std::string& function : functions) {
    Judged worst;
    if (function == "forward_dynamics") {
      for (std::size_t i = 0; i < references.size(); ++i)
        keep_worse(worst, judge_rates(references[i], found[i].at(function).at("qdd")));
    } else if (function == "constrained_forward_dynamics") {
      std::vector<ConstraintRowsOf<Wide>> rows;
      std::vector<ConstraintRowsOf<double>> plain;
      std::vector<Answer> answers(references.size());
      for (std::size_t i = 0; i < references.size(); ++i) {
        rows.push_back(references[i].rows.value());
        plain.push_back(references[i].plain_rows.value());
        answers[i].rates = found[i].at(function).at("qdd");
        answers[i].multipliers = found[i].at(function).at("lambda");
      }
      worst = judge_constrained(references, rows, plain, answers);
    } else {
      for (const auto& [name, values] : references[0].exact.at(function))
        keep_worse(worst, judge_array(function, name, references, found));
    }
    Comparison line = base;
    line.function = function;
    line.error = worst.error;
    line.tolerance = worst.allowed;
    if (!(worst.error <= worst.allowed)) {
      line.verdict = Comparison::Verdict::fail;
      line.note = worst.where;
    }
    lines.push_back(line);
  }
  return lines;
}

Comparison compare_constrained(const std::string& executable, const std::string& file,
                               const Description& description, const std::vector<State>& states,
                               const std::vector<Reference>& references) {
  Comparison line;
  line.mechanism = description.name;
  line.function = "constrained_dynamics";
  line.oracle = "Taylor";
  line.formulation = "auto";
  try {
    const std::vector<Answer> answers = ask_alembert(executable, file, states, "auto");
    std::vector<ConstraintRowsOf<Wide>> rows;
    std::vector<ConstraintRowsOf<double>> plain;
    for (const State& state : states) {
      rows.push_back(numeric_constraints<Wide>(description, state));
      plain.push_back(numeric_constraints<double>(description, state));
    }
    const Judged worst = judge_constrained(references, rows, plain, answers);
    line.error = worst.error;
    line.tolerance = worst.allowed;
  } catch (const std::runtime_error& failure) {
    line.error = kInfinity;
    line.note = failure.what();
  }
  if (!(line.error <= line.tolerance)) line.verdict = Comparison::Verdict::fail;
  return line;
}

}  // namespace alembert::oracles

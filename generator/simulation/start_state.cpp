// The state to start from (see the header).
#include "simulation/start_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>

#include "alembert/consistent_state.hpp"
#include "mechanism/load.hpp"
#include "mechanism/parameter_places.hpp"
#include "simulation/interpreted_mechanism.hpp"

namespace alembert {

namespace {

constexpr double kKept = 1e-8;      // violations up to this are none, in SI units
constexpr double kChanged = 1e-12;  // smaller changes are not worth telling
constexpr std::size_t kListed = 12;

/// \param text  NAME=VALUE
void set_parameter(const Mechanism& mechanism, const std::string& text, EvaluationState& state) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError(mechanism.where, "--parameter takes NAME=VALUE, not '" + printable(text) + "'");
  const std::string name = text.substr(0, equals);
  const std::vector<PlacedParameter> placed = placed_parameters(mechanism, ParameterRole::parameter);
  std::vector<std::string> names;
  for (const PlacedParameter& one : placed) names.push_back(one.parameter.name);
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw InputError(mechanism.where, "--parameter: there is no runtime parameter '" + printable(name) + "'" +
                                          did_you_mean(name, names));
  double value = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data() + equals + 1, end, value);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
    throw InputError(mechanism.where, "--parameter: '" + printable(text.substr(equals + 1)) +
                                          "' is no value for '" + name + "': expected a number");
  state.parameters[placed[static_cast<std::size_t>(found - names.begin())].place] = value;
}

EvaluationState given_state(const CompiledMechanism& compiled, const StartOptions& options) {
  EvaluationState state = DynamicsEvaluator(compiled).initial_state();
  const auto replace = [&](const char* option, const std::vector<double>& given, std::span<double> values) {
    if (given.empty()) return;
    if (given.size() != values.size())
      throw InputError(compiled.mechanism->where,
                       fmt::format("{} takes {} value{}, not {}", option, values.size(),
                                   values.size() == 1 ? "" : "s", given.size()));
    std::ranges::copy(given, values.begin());
  };
  const std::size_t states = placed_parameters(*compiled.mechanism, ParameterRole::state).size();
  replace("--q", options.q, state.q);
  replace("--qd", options.qd, state.qd);
  replace("--states", options.states, std::span(state.parameters).last(states));
  for (const std::string& parameter : options.parameters)
    set_parameter(*compiled.mechanism, parameter, state);
  if (const Coordinate* none = normalise_quaternions(*compiled.mechanism, state.q)) {
    throw InputError(compiled.mechanism->where,
                     fmt::format("--q gives the quaternion '{}' no direction: its length is 0", none->name));
  }
  return state;
}

ProjectionOptions<double, Eigen::Dynamic> projection_options(const Mechanism& mechanism,
                                                             const std::vector<std::string>& hold) {
  ProjectionOptions<double, Eigen::Dynamic> options;
  options.held.setConstant(mechanism.nv, false);
  std::vector<std::string> names;
  for (const Coordinate& coordinate : mechanism.coordinates) names.push_back(coordinate.name);
  for (const std::string& name : hold) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      throw InputError(mechanism.where, "--hold: there is no coordinate '" + printable(name) + "'" +
                                            did_you_mean(name, names));
    }
    const Coordinate& coordinate = mechanism.coordinates[static_cast<std::size_t>(found - names.begin())];
    for (int a = 0; a < coordinate.nv(); ++a) options.held(coordinate.first_speed + a) = true;
  }
  return options;
}

/// `, x 0.1 -> 0.2` for all that changed.
class Changes {
 public:
  void add(const std::string& name, double before, double after) {
    if (std::abs(after - before) <= kChanged) return;
    if (++count_ <= kListed) text_ += fmt::format(", {} {:.6g} -> {:.6g}", name, before, after);
  }
  std::string text() const {
    if (count_ == 0) return ": nothing by more than rounding";
    return ": " + text_.substr(2) + (count_ > kListed ? fmt::format(" and {} more", count_ - kListed) : "");
  }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

std::string changes(const Mechanism& mechanism, const EvaluationState& before, const EvaluationState& after) {
  static constexpr const char* kParts[] = {".x", ".y", ".z", ".w"};
  Changes out;
  for (const Coordinate& c : mechanism.coordinates) {
    for (int a = 0; a < c.nq(); ++a) {
      const std::size_t i = static_cast<std::size_t>(c.first_q + a);
      out.add(c.name + (c.nq() == 1 ? "" : kParts[a]), before.q[i], after.q[i]);
    }
  }
  for (const Coordinate& c : mechanism.coordinates) {
    for (int a = 0; a < c.nv(); ++a) {
      const std::size_t i = static_cast<std::size_t>(c.first_speed + a);
      out.add("d(" + c.name + ")" + (c.nv() == 1 ? "" : kParts[a]), before.qd[i], after.qd[i]);
    }
  }
  return out.text();
}

/// Throws at the expression of the description that has no value at the given coordinates, if there is one: a
/// linkage in closed form that cannot close there, say.
void explain_no_value(const Mechanism& mechanism, const EvaluationState& state) {
  ExprGraph graph;
  try {
    static_cast<void>(load_mechanism(Document(mechanism.where.source), graph, state.q));
  } catch (const InputError& error) {
    std::string at;
    for (const Coordinate& c : mechanism.coordinates) {
      if (c.nq() == 1)
        at += fmt::format("{}{} = {:.6g}", at.empty() ? "" : ", ", c.name,
                          state.q[static_cast<std::size_t>(c.first_q)]);
    }
    throw InputError(error.where(), error.message(),
                     fmt::format("--q starts at {}: the mechanism cannot be put together there", at));
  }
}

/// Whether M and c have values at a state.
bool has_dynamics(const InterpretedMechanism& system, const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  Eigen::MatrixXd M;
  Eigen::VectorXd c;
  system.mass_matrix_and_bias(q, u, M, c);
  return M.allFinite() && c.allFinite();
}

}  // namespace

EvaluationState start_state(const CompiledMechanism& compiled, const StartOptions& options,
                            const std::function<void(const std::string&)>& note) {
  const Mechanism& mechanism = *compiled.mechanism;
  const EvaluationState given = given_state(compiled, options);
  const ProjectionOptions<double, Eigen::Dynamic> projection = projection_options(mechanism, options.hold);
  const InterpretedMechanism system(compiled, given);
  Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(given.q.data(), system.nq());
  Eigen::VectorXd u = Eigen::Map<const Eigen::VectorXd>(given.qd.data(), system.nv());
  if (!options.q.empty() && !has_dynamics(system, q, u)) explain_no_value(mechanism, given);
  if (system.nc() == 0) return given;
  const auto row = [&](int index) -> const ConstraintRow& {
    return system.rows()[static_cast<std::size_t>(index)];
  };
  const auto where = [&](int index) {
    return index < 0 ? mechanism.where : mechanism.constraints[row(index).constraint].where;
  };

  const Violation before = worst_violation(system, q, u);
  if (std::isnan(before.size)) {
    throw InputError(where(before.row),
                     fmt::format("row {} has no value at the initial state", row(before.row).name));
  }
  if (before.size <= projection.tolerance) return given;
  if (!options.assemble) {
    if (before.size <= kKept) return given;
    throw InputError(where(before.row),
                     fmt::format("the initial state does not keep row {}: it is off by {:.6g}",
                                 row(before.row).name, before.size));
  }
  ConstraintReport<Eigen::Dynamic> report;
  const Status status = project_state(system, q, u, projection, report);
  if (status == Status::inconsistent_constraints) {
    throw InputError(
        where(report.inconsistent_row),
        fmt::format("no state near the initial one keeps the constraints: row {} contradicts those that "
                    "it depends on, or the mechanism is at a singular position on the way; start from "
                    "other values",
                    row(report.inconsistent_row).name));
  }
  if (status != Status::ok) {
    throw InputError(
        where(before.row),
        fmt::format("no state near the initial one keeps the constraints ({}); row {} is off by {:.6g}; "
                    "start from other values",
                    to_string(status), row(before.row).name, before.size));
  }
  EvaluationState state = system.state(q, u);
  note(fmt::format("the initial state did not keep the constraints (row {} was off by {:.6g}); changed{}",
                   row(before.row).name, before.size, changes(mechanism, given, state)));
  return state;
}

}  // namespace alembert

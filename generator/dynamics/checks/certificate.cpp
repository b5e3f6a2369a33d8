// Measures programs (see the header).
#include "dynamics/checks/certificate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>

#include "dynamics/checks/state_checks.hpp"
#include "dynamics/tree/symbols.hpp"
#include "program/interpret.hpp"
#include "support/operation.hpp"
#include "symbolic/error_bound.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

namespace {

/// States for each function of a small mechanism, and what they may take of a large one: nodes that are
/// evaluated.
constexpr int kMeasuredStates = 10, kFewestStates = 3;
constexpr double kMeasuringWork = 4e6;

bool finite(const VectorXe& v) {
  return std::all_of(v.begin(), v.end(), [](const Extended& x) { return isfinite(x); });
}

/// One array as it should be: all of it, or its product with a vector.
struct Wanted {
  VectorXe values;
  std::optional<VectorXe> times = {};
  Extended noise = 0;  ///< of the values: so much is left of what cancels
  bool rows = false;   ///< `times` are weights of rows, not of columns
};

Extended largest_entry(const VectorXe& v) {
  return v.size() == 0 ? Extended(0) : v.lpNorm<Eigen::Infinity>();
}

using State = PlainEquations::State;

/// By what rows and columns of an array are multiplied before they are compared; nothing: 1.
struct Scales {
  VectorXe rows, columns;
  Extended row(std::size_t i) const { return rows.size() == 0 ? 1 : rows[static_cast<Eigen::Index>(i)]; }
  Extended column(std::size_t i) const {
    return columns.size() == 0 ? 1 : columns[static_cast<Eigen::Index>(i)];
  }
};

/// Of matrices that act on speeds, and of rates: so that they do not depend on the units of the coordinates, and a
/// mirror of milligrams on a stage of tonnes has its digits too. `inertia` are the roots of M's diagonal.
struct ScaledArray {
  std::string_view name;
  int rows, columns;  ///< powers of the inertia that they are multiplied by
};
constexpr std::array kScaledArrays{
    ScaledArray{"M", -1, -1},     ScaledArray{"C", -1, -1},   ScaledArray{"Minv", 1, 1},
    ScaledArray{"qdd", 1, 0},     ScaledArray{"qdd_q", 1, 0}, ScaledArray{"qdd_qd", 1, 0},
    ScaledArray{"qdd_tau", 1, 1},
};

bool is_scaled(std::string_view array) {
  return std::ranges::find(kScaledArrays, array, &ScaledArray::name) != kScaledArrays.end();
}

Scales scales_of(std::string_view array, const VectorXe& inertia) {
  const auto* row = std::ranges::find(kScaledArrays, array, &ScaledArray::name);
  if (row == kScaledArrays.end()) return {};
  const auto power = [&](int exponent) {
    return exponent == 0 ? VectorXe() : exponent < 0 ? VectorXe(inertia.cwiseInverse()) : inertia;
  };
  return {power(row->rows), power(row->columns)};
}

/// Arrays as they are compared: whole, but for the energies, of which a small one has its digits beside a large one.
std::vector<MeasuredPart> measured_parts(std::span<const OutputArray> outputs) {
  std::vector<MeasuredPart> parts;
  for (std::size_t a = 0; a < outputs.size(); ++a) {
    const std::size_t size = outputs[a].values.size();
    const std::size_t step = outputs[a].name == "e" ? 1 : size;
    for (std::size_t first = 0; first < size; first += step) parts.push_back({a, first, step});
  }
  return parts;
}

/// The arrays of a function that is compared with the forces themselves, or with differences of them.
struct ByForces {
  FunctionKind kind;
  std::vector<Wanted> (*arrays)(const PlainEquations&, const State&, const VectorXe& signs,
                                const VectorXe& inertia);
};

std::vector<Wanted> with_noise(const Extended& noise, std::vector<Wanted> arrays) {
  for (Wanted& array : arrays) array.noise = noise;
  return arrays;
}
Extended rounding_of_forces(const PlainEquations& plain, const State& state) {
  return kExtendedRounding * largest_entry(plain.forces(state));
}

Wanted mass_times(const PlainEquations& plain, const State& state, const VectorXe& v) {
  return {plain.mass_times(state, v), v, rounding_of_forces(plain, state) * largest_entry(v)};
}

/// These need no expressions of their own: what is written is compared with the forces, evaluated more often.
/// Every other function is compared with what its builder makes of the plain equations.
const std::array kByForces{
    ByForces{FunctionKind("inverse_dynamics"),
             [](const PlainEquations& plain, const State& state, const VectorXe&, const VectorXe&) {
               return with_noise(rounding_of_forces(plain, state), {{plain.forces(state)}});
             }},
    ByForces{
        FunctionKind("mass_matrix"),
        [](const PlainEquations& plain, const State& state, const VectorXe& signs, const VectorXe& inertia) {
          return std::vector<Wanted>{mass_times(plain, state, signs.cwiseQuotient(inertia))};
        }},
    ByForces{FunctionKind("bias"),
             [](const PlainEquations& plain, const State& state, const VectorXe&, const VectorXe&) {
               return with_noise(rounding_of_forces(plain, state), {{plain.bias(state)}});
             }},
    ByForces{
        FunctionKind("mass_matrix_and_bias"),
        [](const PlainEquations& plain, const State& state, const VectorXe& signs, const VectorXe& inertia) {
          return std::vector<Wanted>{mass_times(plain, state, signs.cwiseQuotient(inertia)),
                                     {plain.bias(state), {}, rounding_of_forces(plain, state)}};
        }},
    ByForces{FunctionKind("forward_dynamics"),
             [](const PlainEquations& plain, const State& state, const VectorXe&, const VectorXe&) {
               return std::vector<Wanted>{{plain.accelerations(state)}};
             }},
    ByForces{FunctionKind("inverse_dynamics_derivatives"),
             [](const PlainEquations& plain, const State& state, const VectorXe& signs, const VectorXe&) {
               return with_noise(kDifferenceNoise * largest_entry(plain.forces(state)),
                                 {{plain.along_speeds(&PlainEquations::forces, state, signs), signs},
                                  {plain.by_speeds(&PlainEquations::forces, state, signs), signs}});
             }},
    ByForces{FunctionKind("inverse_dynamics_second_derivatives"),
             [](const PlainEquations& plain, const State& state, const VectorXe& signs, const VectorXe&) {
               const VectorXe along = plain.along_speeds(&PlainEquations::weighted_gradient, state, signs);
               const VectorXe by_speeds = plain.by_speeds(&PlainEquations::weighted_gradient, state, signs);
               const Eigen::Index nv = signs.size();
               return with_noise(kDifferenceNoise * largest_entry(plain.weighted_gradient(state)),
                                 {{along.head(nv), signs},
                                  {along.segment(nv, nv), signs, 0, true},
                                  {by_speeds.segment(nv, nv), signs},
                                  {along.tail(nv), signs, 0, true}});
             }},
    ByForces{
        FunctionKind("forward_dynamics_derivatives"),
        [](const PlainEquations& plain, const State& state, const VectorXe& signs, const VectorXe& inertia) {
          const VectorXe forces = signs.cwiseProduct(inertia);
          const auto qdd = plain.accelerations_along(state, signs, forces);
          std::vector<Wanted> arrays = with_noise(kDifferenceNoise * largest_entry(qdd.values),
                                                  {{qdd.along_speeds, signs}, {qdd.by_speeds, signs}});
          arrays.push_back({qdd.by_forces, forces});
          return arrays;
        }},
};

/// What the arrays of a function should be.
std::vector<Wanted> wanted_arrays(const PlainEquations& plain, FunctionKind kind,
                                  std::span<const OutputArray> outputs, const State& state,
                                  const VectorXe& signs, const VectorXe& inertia) {
  if (const auto* row = std::ranges::find(kByForces, kind, &ByForces::kind); row != kByForces.end())
    return row->arrays(plain, state, signs, inertia);
  const std::vector<Extended> all = plain.outputs(kind, state);
  const Extended noise = kExtendedRounding * largest_entry(Eigen::Map<const VectorXe>(
                                                 all.data(), static_cast<Eigen::Index>(all.size())));
  std::vector<Wanted> arrays;
  Eigen::Index at = 0;
  for (const OutputArray& output : outputs) {
    const Eigen::Index size = static_cast<Eigen::Index>(output.values.size());
    arrays.push_back({Eigen::Map<const VectorXe>(all.data() + at, size), {}, noise});
    at += size;
  }
  return arrays;
}

/// The errors of one array at states.
class ArrayErrors {
 public:
  void add(std::size_t state, const Wanted& wanted, std::span<const double> found, std::size_t columns,
           const Scales& scales) {
    VectorXe here = VectorXe::Zero(wanted.values.size());
    Extended largest = 0, difference = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Extended x = found[i], size = abs(x) * scales.row(i / columns) * scales.column(i % columns);
      largest = std::max(largest, size);
      is_zero_ = is_zero_ && x == 0;
      if (wanted.times) {
        const std::size_t entry = wanted.rows ? i % columns : i / columns;
        const std::size_t weight = wanted.rows ? i / columns : i % columns;
        here[static_cast<Eigen::Index>(entry)] += x * (*wanted.times)[static_cast<Eigen::Index>(weight)];
      } else {
        here[static_cast<Eigen::Index>(i)] = x;
      }
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(here.size()); ++i) {
      const Extended& value = wanted.values[static_cast<Eigen::Index>(i)];
      const Extended off = abs(here[static_cast<Eigen::Index>(i)] - value);
      const Extended scale =
          wanted.times ? scales.row(i) : Extended(scales.row(i / columns) * scales.column(i % columns));
      if (!wanted.times) largest = std::max(largest, Extended(abs(value) * scale));
      const bool has_digits = off > wanted.noise && off >= std::numeric_limits<double>::min();
      if (has_digits) difference = std::max(difference, Extended(off * scale));
    }
    const std::size_t terms = wanted.times ? found.size() / static_cast<std::size_t>(here.size()) : 1;
    states_.push_back({state, terms, difference, largest});
    size_ = std::max(size_, largest);
  }

  /// Adds what is no small part of the entries at its state (which may be next to nothing there: of a thousandth
  /// of what they are elsewhere, then), and the largest part.
  void report(const MeasuredPart& part, const std::string& name, MeasuredError& error) const {
    for (const AtState& at : states_) {
      if (at.difference < std::numeric_limits<double>::min()) continue;  // below, double has no digits
      const double relative =
          Extended(at.difference / std::max(at.largest, Extended(size_ / 1000))).convert_to<double>();
      if (relative > kLargestError)
        error.excesses.push_back({at.state, part, at.terms, at.difference.convert_to<double>(), is_zero_});
      if (is_zero_ && error.array.empty()) error.array = name;
      if (is_zero_ || relative <= error.relative) continue;
      error.relative = relative;
      error.array = name;
    }
  }

 private:
  struct AtState {
    std::size_t state, terms;
    Extended difference, largest;  ///< the largest difference and entry
  };
  std::vector<AtState> states_;
  Extended size_ = 0;
  bool is_zero_ = true;
};

/// What decides choices and signs below these expressions.
std::vector<Expr> conditions_below(std::span<const Expr> roots) {
  std::vector<Expr> conditions;
  for (const std::uint32_t id : postorder(roots)) {
    ExprGraph& graph = roots.front().graph();
    const Node& node = graph.node(id);
    if (is_choice(node.op) || node.op == Operation::abs || node.op == Operation::sign)
      conditions.emplace_back(graph, node.a);
  }
  return conditions;
}

/// Whether rounding, or a difference quotient, would decide.
bool is_undecided(std::span<const Expr> conditions, std::span<const double> state) {
  return std::ranges::any_of(evaluate_bounded(conditions, state), [](const Approximate& condition) {
    return !(std::abs(condition.value) > condition.error);
  });
}

}  // namespace

double rounded_correctly(Operation op, double a, double b) {
  return apply(op, Extended(a), Extended(b)).convert_to<double>();
}

Certificate::Certificate(const Kinematics& kinematics, const std::vector<SymbolBinding>& bindings,
                         std::optional<int> states)
    : kinematics_(kinematics),
      bindings_(bindings),
      plain_(kinematics),
      most_(states.value_or(kMeasuredStates)),
      work_(states ? HUGE_VAL : kMeasuringWork) {
  std::vector<Expr> roots = kinematics.applied.Q;
  roots.push_back(kinematics.applied.potential);
  std::ranges::copy(kinematics.applied.outputs, std::back_inserter(roots));
  std::ranges::copy(kinematics.applied.rates, std::back_inserter(roots));
  const std::vector<Expr> conditions = conditions_below(roots);
  // More than are wanted: the equations may have no value at some.
  std::vector<std::vector<double>> undecided;
  for (int k = 0; k < 4 * most_; ++k) {
    std::vector<double> state = state_in_range(kinematics, static_cast<unsigned>(k));
    (is_undecided(conditions, state) ? undecided : states_).push_back(std::move(state));
  }
  // Where choices are undecided at every state, a measurement that may be too strict is better than none.
  if (states_.empty()) states_ = std::move(undecided);
}

const VectorXe& Certificate::inertia_at(std::size_t state, FunctionKind kind) const {
  const bool constrained = kind.row().needs == Needs::regular_constrained_motion;
  const auto [at, fresh] = inertia_.try_emplace({state, constrained});
  if (fresh) {
    const State here = plain_.state(states_[state]);
    at->second = constrained ? plain_.constrained_inertia(here) : plain_.inertia(here);
  }
  return at->second;
}

std::vector<double> Certificate::values_at(std::size_t state, const VectorXe& inertia) const {
  std::vector<double> values = states_[state];
  for (Eigen::Index k = 0; k < inertia.size(); ++k)
    values[kinematics_.graph.symbol_index(
        tau_symbol(kinematics_.mechanism, static_cast<int>(k), kinematics_.graph).ref().node())] *=
        inertia[k].convert_to<double>();
  return values;
}

MeasuredError Certificate::measure(const Program& program, FunctionKind kind) const {
  std::vector<double> scratch;
  return measure(program.outputs, kind, [&](std::span<const double> inputs, std::span<double> found) {
    interpret(program, inputs, found, scratch, rounded_correctly);
  });
}

MeasuredError Certificate::measure(std::span<const OutputArray> outputs, FunctionKind kind,
                                   const Values& values_of) const {
  const std::vector<MeasuredPart> parts = measured_parts(outputs);
  std::vector<ArrayErrors> errors(parts.size());
  MeasuredError worst;
  std::mt19937_64 random(1);
  double work = 0;
  std::size_t entries = 0;
  bool scaled = false;
  for (const OutputArray& output : outputs) {
    entries += output.values.size();
    scaled = scaled || is_scaled(output.name);
  }
  std::vector<double> inputs, found(entries);
  for (std::size_t k = 0; k < states_.size(); ++k) {
    if (worst.states >= most_ || (work > work_ && worst.states >= kFewestStates)) break;
    const VectorXe inertia = scaled ? inertia_at(k, kind) : VectorXe();
    const std::vector<double> values = values_at(k, inertia);
    const State state = plain_.state(values);
    VectorXe signs(kinematics_.mechanism.nv);
    for (Extended& sign : signs) sign = (random() >> 63) != 0 ? -1 : 1;
    work += static_cast<double>(2 * plain_.nodes());
    std::vector<Wanted> arrays = wanted_arrays(plain_, kind, outputs, state, signs, inertia);
    if (!std::all_of(arrays.begin(), arrays.end(), [](const Wanted& w) { return finite(w.values); }))
      continue;
    inputs.clear();
    for (const SymbolBinding& binding : bindings_)
      inputs.push_back(values[kinematics_.graph.symbol_index(binding.symbol.ref().node())]);
    values_of(inputs, found);
    if (!std::all_of(found.begin(), found.end(), [](double x) { return std::isfinite(x); })) {
      worst.without_value.push_back(k);
      continue;
    }
    ++worst.states;
    const double* at = found.data();
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const auto [array, first, count] = parts[p];
      const OutputArray& output = outputs[array];
      Wanted& wanted = arrays[array];
      const Wanted part = count == output.values.size()
                              ? std::move(wanted)
                              : Wanted{wanted.values.segment(static_cast<Eigen::Index>(first),
                                                             static_cast<Eigen::Index>(count)),
                                       {},
                                       wanted.noise};
      errors[p].add(k, part, {at, count}, output.columns, scales_of(output.name, inertia));
      at += count;
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    errors[p].report(parts[p], outputs[parts[p].array].name, worst);
  return worst;
}

bool Certificate::explains(const MeasuredError& error, FunctionKind kind) const {
  const std::vector<OutputExpressions>& plain = plain_.expressions(kind);
  const auto inertia_of = [&](const OutputExpressions& output, std::size_t state) {
    return is_scaled(output.name) ? inertia_at(state, kind) : VectorXe();
  };
  const auto evaluated = [&](const OutputExpressions& output, std::size_t state) {
    return evaluate_bounded(output.values, values_at(state, inertia_of(output, state)));
  };
  const auto scaled = [](const Scales& scales, std::size_t entry, std::size_t columns, double value) {
    return Extended(scales.row(entry / columns) * scales.column(entry % columns)).convert_to<double>() *
           value;
  };
  const auto rounding = [&](const OutputExpressions& output, std::size_t first, std::size_t count,
                            std::size_t state) {
    const Scales scales = scales_of(output.name, inertia_of(output, state));
    const std::vector<Approximate> values = evaluated(output, state);
    double most = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      const Approximate& x = values[i];
      if (!std::isfinite(x.value) || !std::isfinite(x.error)) return HUGE_VAL;
      most = std::max(most, scaled(scales, i, output.columns, x.error));
    }
    return most;
  };
  // What the plain equations give there may have no digit right either: a pivot that is all rounding need not be 0.
  const auto has_digits = [&](const OutputExpressions& output, std::size_t state) {
    const Scales scales = scales_of(output.name, inertia_of(output, state));
    const std::vector<Approximate> values = evaluated(output, state);
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      largest = std::max(largest, scaled(scales, i, output.columns, std::abs(values[i].value)));
    const double lost = rounding(output, 0, values.size(), state);
    return lost == 0 || lost < largest;
  };
  for (const std::size_t state : error.without_value)
    if (std::ranges::all_of(plain,
                            [&](const OutputExpressions& output) { return has_digits(output, state); }))
      return false;
  return std::ranges::all_of(error.excesses, [&](const Excess& excess) {
    const auto& [array, first, count] = excess.part;
    double most = rounding(plain[array], first, count, excess.state);
    // The numbers of a description are rounded too. An axis has not quite the length 1: what is 0 where it has is
    // then as large as the rounding errors of forces.
    if (excess.of_zeros) {
      const OutputExpressions& forces = plain_.expressions(FunctionKind("inverse_dynamics")).front();
      most = std::max(most, rounding(forces, 0, forces.values.size(), excess.state));
    }
    return excess.difference <= static_cast<double>(excess.terms) * most;
  });
}

}  // namespace alembert

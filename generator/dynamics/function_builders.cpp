// The builders of output functions (see the header).
#include "dynamics/function_builders.hpp"

#include <algorithm>
#include <initializer_list>

#include "differentiation/jacobian.hpp"
#include "dynamics/choice/candidates.hpp"
#include "dynamics/choice/conditioning.hpp"
#include "dynamics/choice/constrained_dynamics.hpp"
#include "dynamics/choice/coriolis_matrix.hpp"
#include "dynamics/choice/force_derivatives.hpp"
#include "dynamics/choice/forward_dynamics.hpp"
#include "dynamics/choice/second_derivatives.hpp"
#include "dynamics/recursions/constraints.hpp"
#include "dynamics/recursions/joint_reactions.hpp"
#include "dynamics/recursions/moving_bodies.hpp"
#include "dynamics/recursions/outputs.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/recursions/regressor.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/parameter_places.hpp"
#include "support/error.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

/// What a builder may use.
struct Ingredients {
  const Kinematics& kinematics;
  std::vector<const MotionTree*> trees;  ///< of the same motions; any will do
  const EquationsOfMotion* equations;    ///< null unless the builder is of_equations

  const Mechanism& mechanism() const { return kinematics.mechanism; }
  ExprGraph& graph() const { return kinematics.graph; }
};

/// The entries of each result, row by row.
using Results = std::vector<std::vector<Expr>>;

/// What `make(i)` gives for one of so many trees of motions: for the one that takes the fewest operations.
template <class Make>
Results shortest_of(const Kinematics& kinematics, std::size_t trees, Make make) {
  if (trees == 1) return {make(0)};
  Candidates candidates(kinematics);
  for (std::size_t i = 0; i < trees; ++i) candidates.add(make(i));
  return {candidates.shortest()};
}
template <class Make>
Results for_shortest_moving_tree(const Ingredients& given, Make make) {
  return shortest_of(given.kinematics, given.trees.size(), [&](std::size_t i) {
    return make(given.mechanism(), *given.trees[i], given.kinematics.derivatives, given.graph());
  });
}
template <class Make>
Results for_shortest_tree(const Ingredients& given, Make make) {
  return shortest_of(given.kinematics, given.trees.size(),
                     [&](std::size_t i) { return make(given.mechanism(), *given.trees[i], given.graph()); });
}

Results build_forward_dynamics(const Ingredients& given) {
  return {forward_dynamics(given.kinematics, *given.equations)};
}

Results build_forward_dynamics_derivatives(const Ingredients& given) {
  ForwardDerivatives found = forward_dynamics_derivatives(given.kinematics, *given.equations);
  return {std::move(found.along_speeds), std::move(found.by_speeds), std::move(found.by_forces)};
}

Results build_constrained_forward_dynamics(const Ingredients& given) {
  ConstrainedMotion found = constrained_forward_dynamics(given.kinematics, *given.equations);
  return {std::move(found.rates), std::move(found.lambdas)};
}

Results build_constrained_forward_dynamics_derivatives(const Ingredients& given) {
  ConstrainedDerivatives found = constrained_forward_dynamics_derivatives(given.kinematics, *given.equations);
  return {std::move(found.rates_along),       std::move(found.rates_by_speeds),
          std::move(found.rates_by_forces),   std::move(found.lambdas_along),
          std::move(found.lambdas_by_speeds), std::move(found.lambdas_by_forces)};
}

Results build_gravity(const Ingredients& given) {
  std::vector<WrittenTree> trees;
  for (const MotionTree* tree : given.trees) trees.emplace_back(*tree);
  if (given.equations->tree && std::ranges::find(trees, *given.equations->tree) == trees.end())
    trees.push_back(*given.equations->tree);
  return shortest_of(given.kinematics, trees.size(), [&](std::size_t i) {
    return gravity_forces(given.mechanism(), trees[i], given.graph());
  });
}

Results build_applied_forces(const Ingredients& given) {
  const std::vector<Expr>& Q = given.kinematics.applied.Q;
  if (!Q.empty()) return {Q};
  return {std::vector<Expr>(static_cast<std::size_t>(given.mechanism().nv), given.graph().zero())};
}

/// A row a value: its derivatives along the speeds.
std::vector<Expr> along_speeds(const Kinematics& kinematics, const std::vector<Expr>& values) {
  const std::size_t nv = static_cast<std::size_t>(kinematics.mechanism.nv);
  std::vector<Expr> J(values.size() * nv, kinematics.graph.zero());
  for (const SpeedPartial& partial : kinematics.derivatives.partials(values)) {
    if (partial.speed == kinematics.derivatives.time_index()) continue;
    for (std::size_t i = 0; i < values.size(); ++i)
      J[i * nv + static_cast<std::size_t>(partial.speed)] = partial.values[i];
  }
  return J;
}

/// A row a value: its derivatives by symbols.
std::vector<Expr> derivatives_by(const std::vector<Expr>& values, const std::vector<Expr>& symbols) {
  std::vector<Expr> out;
  if (values.empty() || symbols.empty()) return out;
  const Jacobian by = jacobian(values, symbols);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = 0; k < symbols.size(); ++k) out.push_back(by(i, k));
  return out;
}

/// The symbols of inputs or states.
std::vector<Expr> symbols_of(const Ingredients& given, ParameterRole role) {
  std::vector<Expr> out;
  for (const PlacedParameter& placed : placed_parameters(given.mechanism(), role))
    out.push_back(given.graph().symbol(placed.parameter.name));
  return out;
}

Results build_input_jacobian(const Ingredients& given) {
  return {derivatives_by(build_applied_forces(given).front(), symbols_of(given, ParameterRole::input))};
}

Results build_state_jacobian(const Ingredients& given) {
  return {derivatives_by(build_applied_forces(given).front(), symbols_of(given, ParameterRole::state))};
}

Results build_state_input_jacobian(const Ingredients& given) {
  return {derivatives_by(given.kinematics.applied.rates, symbols_of(given, ParameterRole::input))};
}

Results build_state_rates_derivatives(const Ingredients& given) {
  const std::vector<Expr>& rates = given.kinematics.applied.rates;
  std::vector<Expr> speeds;
  for (int k = 0; k < given.mechanism().nv; ++k) speeds.push_back(given.kinematics.derivatives.speed(k));
  return {along_speeds(given.kinematics, rates), derivatives_by(rates, speeds),
          derivatives_by(rates, symbols_of(given, ParameterRole::state))};
}

Results build_outputs(const Ingredients& given) {
  return {given.kinematics.applied.outputs};
}

const std::vector<Expr>& outputs_of_position(const Ingredients& given) {
  for (const Output& output : given.mechanism().outputs)
    if (output.of_speeds)
      throw InputError(output.where,
                       "output '" + output.name + "' depends on speeds: it has no Jacobian along them",
                       "ask for 'outputs' alone, or leave this one out");
  return given.kinematics.applied.outputs;
}

Results build_outputs_jacobian(const Ingredients& given) {
  return {along_speeds(given.kinematics, outputs_of_position(given))};
}

Results build_outputs_rate(const Ingredients& given) {
  const std::vector<Expr>& values = outputs_of_position(given);
  const SpeedDerivatives& derivatives = given.kinematics.derivatives;
  return {derivatives.first_rate(derivatives.partials(values), values.size())};
}

Results build_outputs_bias(const Ingredients& given) {
  const std::vector<Expr>& values = outputs_of_position(given);
  const SpeedDerivatives& derivatives = given.kinematics.derivatives;
  return {derivatives.quadratic_rate(derivatives.partials(values), values.size())};
}

Results build_energy(const Ingredients& given) {
  Results energy = for_shortest_tree(given, energies);
  energy.front()[1] += given.kinematics.applied.potential;
  return energy;
}

Results build_coordinate_rates(const Ingredients& given) {
  const SpeedDerivatives& derivatives = given.kinematics.derivatives;
  const std::vector<Expr> N = derivatives.coordinate_rate_matrix();
  const std::size_t nv = static_cast<std::size_t>(given.mechanism().nv);
  std::vector<Expr> rates(static_cast<std::size_t>(given.mechanism().nq), given.graph().zero());
  for (std::size_t i = 0; i < N.size(); ++i)
    rates[i / nv] += N[i] * derivatives.speed(static_cast<int>(i % nv));
  return {rates};
}

Results build_frame_jacobians(const Ingredients& given) {
  const std::vector<Expr> poses = frame_poses(given.mechanism(), given.kinematics.tree, given.graph());
  return {frame_jacobians(given.mechanism(), given.kinematics.derivatives, poses, given.graph())};
}

Results build_frame_jacobian_rates(const Ingredients& given) {
  const std::vector<Expr> J = build_frame_jacobians(given).front();
  const SpeedDerivatives& derivatives = given.kinematics.derivatives;
  return {derivatives.first_rate(derivatives.partials(J), J.size())};
}

Results build_centroidal_momentum(const Ingredients& given) {
  const auto make = [&](MomentumFrom from) {
    CentroidalMomentum found = centroidal_momentum(given.mechanism(), given.kinematics.tree,
                                                   given.kinematics.derivatives, given.graph(), from);
    return Results{std::move(found.h), std::move(found.A), std::move(found.bias), std::move(found.com)};
  };
  Results plain = make(MomentumFrom::heaviest_body);
  if (!given.graph().simplifies()) return plain;
  Results other = make(MomentumFrom::world);
  const auto joined = [](const Results& all, std::initializer_list<std::size_t> which) {
    std::vector<Expr> out;
    for (const std::size_t i : which) out.insert(out.end(), all[i].begin(), all[i].end());
    return out;
  };
  const Conditioning conditioning(given.kinematics, joined(plain, {0, 2}));
  const auto operations = [&](const Results& all) {
    return count_operations(value_number(joined(all, {0, 1, 2, 3}))).total();
  };
  return operations(other) < operations(plain) && conditioning.is_good(joined(other, {0, 2})) ? other : plain;
}

Results build_constraints(const Ingredients& given) {
  ConstraintEquations equations = constraint_equations(given.mechanism(), given.kinematics.tree,
                                                       given.kinematics.derivatives, given.graph());
  return {std::move(equations.P), std::move(equations.gamma), std::move(equations.velocity),
          std::move(equations.position)};
}

Results build_inverse_dynamics_derivatives(const Ingredients& given) {
  const std::vector<Expr> both = force_derivatives(given.kinematics, *given.equations);
  const auto middle = both.begin() + static_cast<std::ptrdiff_t>(both.size() / 2);
  return {{both.begin(), middle}, {middle, both.end()}};
}

Results build_inverse_dynamics_second_derivatives(const Ingredients& given) {
  SecondForceDerivatives found = second_force_derivatives(given.kinematics, *given.equations);
  return {std::move(found.along_speeds_twice), std::move(found.along_speeds_by_speeds),
          std::move(found.by_speeds_twice), std::move(found.along_speeds_by_rates)};
}

Results build_inverse_dynamics_parameter_derivatives(const Ingredients& given) {
  return {value_number(derivatives_by(given.equations->Q, symbols_of(given, ParameterRole::parameter)))};
}

/// Columns of the regressor.
Results build_base_regressor(const Ingredients& given) {
  const std::vector<Expr> Y = for_shortest_tree(given, force_regressor).front();
  const std::size_t columns = kStandardParameters * given.mechanism().bodies.size();
  std::vector<Expr> out;
  for (std::size_t row = 0; row * columns < Y.size(); ++row)
    for (const int column : given.mechanism().base_columns)
      out.push_back(Y[row * columns + static_cast<std::size_t>(column)]);
  return {std::move(out)};
}

struct Builder {
  FunctionKind kind;
  bool of_equations;
  Results (*build)(const Ingredients& given);
};

constexpr Builder kBuilders[] = {
    {FunctionKind("inverse_dynamics"), true,
     [](const Ingredients& given) -> Results { return {given.equations->Q}; }},
    {FunctionKind("mass_matrix"), true,
     [](const Ingredients& given) -> Results { return {given.equations->M}; }},
    {FunctionKind("bias"), true, [](const Ingredients& given) -> Results { return {given.equations->c}; }},
    {FunctionKind("gravity"), true, build_gravity},
    {FunctionKind("applied_forces"), false, build_applied_forces},
    {FunctionKind("force_contributions"), false,
     [](const Ingredients& given) -> Results {
       return {force_contributions(given.mechanism(), given.kinematics.tree, given.kinematics.derivatives,
                                   given.graph())};
     }},
    {FunctionKind("outputs"), false, build_outputs},
    {FunctionKind("outputs_jacobian"), false, build_outputs_jacobian},
    {FunctionKind("outputs_rate"), false, build_outputs_rate},
    {FunctionKind("outputs_bias"), false, build_outputs_bias},
    {FunctionKind("coriolis_matrix"), true,
     [](const Ingredients& given) -> Results {
       return {coriolis_matrix(given.kinematics, *given.equations)};
     }},
    {FunctionKind("mass_matrix_and_bias"), true,
     [](const Ingredients& given) -> Results {
       return {given.equations->M, given.equations->c};
     }},
    {FunctionKind("forward_dynamics"), true, build_forward_dynamics},
    {FunctionKind("mass_matrix_inverse"), true,
     [](const Ingredients& given) -> Results {
       return {inverse_mass_matrix(given.kinematics, *given.equations)};
     }},
    {FunctionKind("forward_dynamics_derivatives"), true, build_forward_dynamics_derivatives},
    {FunctionKind("constrained_forward_dynamics"), true, build_constrained_forward_dynamics},
    {FunctionKind("constrained_forward_dynamics_derivatives"), true,
     build_constrained_forward_dynamics_derivatives},
    {FunctionKind("coordinate_rates"), false, build_coordinate_rates},
    {FunctionKind("energy"), false, build_energy},
    {FunctionKind("body_poses"), false,
     [](const Ingredients& given) { return for_shortest_tree(given, body_poses); }},
    {FunctionKind("frame_poses"), false,
     [](const Ingredients& given) { return for_shortest_tree(given, frame_poses); }},
    {FunctionKind("frame_jacobians"), false, build_frame_jacobians},
    {FunctionKind("frame_velocities"), false,
     [](const Ingredients& given) { return for_shortest_moving_tree(given, frame_velocities); }},
    {FunctionKind("frame_bias_accelerations"), false,
     [](const Ingredients& given) {
       return for_shortest_moving_tree(
           given, [](auto&... of) { return frame_accelerations(of..., SpeedRates::left_out); });
     }},
    {FunctionKind("frame_jacobian_rates"), false, build_frame_jacobian_rates},
    {FunctionKind("constraints"), false, build_constraints},
    {FunctionKind("body_jacobians"), false,
     [](const Ingredients& given) { return for_shortest_tree(given, body_jacobians); }},
    {FunctionKind("body_velocities"), false,
     [](const Ingredients& given) { return for_shortest_moving_tree(given, body_velocities); }},
    {FunctionKind("body_accelerations"), false,
     [](const Ingredients& given) {
       return for_shortest_moving_tree(
           given, [](auto&... of) { return body_accelerations(of..., SpeedRates::included); });
     }},
    {FunctionKind("centroidal_momentum"), false, build_centroidal_momentum},
    {FunctionKind("joint_reactions"), false,
     [](const Ingredients& given) { return for_shortest_moving_tree(given, joint_reactions); }},
    {FunctionKind("body_inertias"), false,
     [](const Ingredients& given) -> Results { return {body_inertias(given.mechanism())}; }},
    {FunctionKind("regressor"), false,
     [](const Ingredients& given) { return for_shortest_tree(given, force_regressor); }},
    {FunctionKind("base_regressor"), false, build_base_regressor},
    {FunctionKind("static_regressor"), false,
     [](const Ingredients& given) { return for_shortest_tree(given, gravity_regressor); }},
    {FunctionKind("energy_regressor"), false,
     [](const Ingredients& given) { return for_shortest_tree(given, energy_regressor); }},
    {FunctionKind("inverse_dynamics_derivatives"), true, build_inverse_dynamics_derivatives},
    {FunctionKind("inverse_dynamics_second_derivatives"), true, build_inverse_dynamics_second_derivatives},
    {FunctionKind("inverse_dynamics_parameter_derivatives"), true,
     build_inverse_dynamics_parameter_derivatives},
    {FunctionKind("state_rates"), false,
     [](const Ingredients& given) -> Results { return {given.kinematics.applied.rates}; }},
    {FunctionKind("input_jacobian"), false, build_input_jacobian},
    {FunctionKind("state_jacobian"), false, build_state_jacobian},
    {FunctionKind("state_rates_derivatives"), false, build_state_rates_derivatives},
    {FunctionKind("state_input_jacobian"), false, build_state_input_jacobian},
};

constexpr bool all_have_builders() {
  return std::ranges::all_of(kOutputFunctions, [](const OutputFunction& row) {
    return std::ranges::count(kBuilders, FunctionKind(row), &Builder::kind) == 1;
  });
}
static_assert(all_have_builders(), "each row of the function table needs one entry here");

const Builder& builder_of(FunctionKind kind) {
  return *std::ranges::find(kBuilders, kind, &Builder::kind);
}

std::vector<OutputExpressions> with_shapes(const Mechanism& mechanism, FunctionKind kind, Results values) {
  std::vector<OutputExpressions> outputs;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ResultArray& result = kind.row().results[i];
    const TableShape shape = table_shape(result, mechanism);
    outputs.push_back({std::string(result.name), static_cast<std::uint32_t>(shape.rows),
                       static_cast<std::uint32_t>(shape.columns), std::move(values[i])});
  }
  return outputs;
}

}  // namespace

bool is_of_equations(FunctionKind kind) {
  return builder_of(kind).of_equations;
}

std::vector<OutputExpressions> function_outputs(const Kinematics& kinematics,
                                                const EquationsOfMotion& equations, FunctionKind kind) {
  const Builder& builder = builder_of(kind);
  Ingredients given{kinematics, {&kinematics.tree}, &equations};
  if (kinematics.peeled) given.trees.push_back(&*kinematics.peeled);
  Results values = builder.build(given);
  if (!builder.of_equations) {
    // Equations are numbered already.
    std::vector<std::vector<Expr>*> arrays;
    for (std::vector<Expr>& array : values) arrays.push_back(&array);
    value_number_all(arrays);
  }
  return with_shapes(kinematics.mechanism, kind, std::move(values));
}

std::vector<OutputExpressions> plain_function_outputs(const Kinematics& kinematics, FunctionKind kind) {
  const Builder& builder = builder_of(kind);
  std::optional<EquationsOfMotion> equations;
  if (builder.of_equations) {
    Passes passes = plain_passes();
    passes.augmentation = true;
    equations = equations_of_motion(kinematics, Formulation::reduced, passes);
  }
  return with_shapes(kinematics.mechanism, kind,
                     builder.build({kinematics, {&kinematics.tree}, equations ? &*equations : nullptr}));
}

}  // namespace alembert

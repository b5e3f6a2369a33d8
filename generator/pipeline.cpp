// The stages in order (see the header).
#include "pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "dynamics/checks/axis_check.hpp"
#include "dynamics/checks/certificate.hpp"
#include "dynamics/checks/state_checks.hpp"
#include "dynamics/choice/axis_form.hpp"
#include "dynamics/choice/base_parameters.hpp"
#include "dynamics/choice/row_lengths.hpp"
#include "dynamics/function_builders.hpp"
#include "dynamics/tree/symbols.hpp"
#include "functions/array_shape.hpp"
#include "mechanism/extreme_number.hpp"
#include "mechanism/load.hpp"
#include "program/count.hpp"
#include "program/dump.hpp"
#include "program/loops/dot_products.hpp"
#include "program/loops/reroll.hpp"
#include "program/lower.hpp"
#include "program/schedule.hpp"
#include "program/verify/verify.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/to_string.hpp"

namespace alembert {

namespace {

/// Reports time, nodes and operations of stages as they end.
class StageLog {
 public:
  StageLog(std::ostream* talk, const ExprGraph& graph) : talk_(talk), graph_(graph) {}
  void done(std::string_view stage, std::string_view what = {}) {
    const auto now = std::chrono::steady_clock::now();
    if (talk_ != nullptr) {
      *talk_ << fmt::format("{:<12} {:>9.3f} ms {:>9} nodes  {}\n", stage,
                            std::chrono::duration<double, std::milli>(now - last_).count(), graph_.size(),
                            what);
    }
    last_ = now;
  }
  bool on() const { return talk_ != nullptr; }

 private:
  std::ostream* talk_;
  const ExprGraph& graph_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::string describe(const OperationCount& n) {
  return fmt::format("{} mul {} add {} div {} trig {} other", n.mul, n.add, n.div, n.trig, n.other);
}

/// Of programs that are all off by more than is good, a longer one must be off by so much less.
constexpr double kWorseError = 16;

/// Equations by whichever formulations are to be compared.
std::vector<EquationsOfMotion> candidate_equations(const Kinematics& kinematics,
                                                   const CompileOptions& options, StageLog& log) {
  std::vector<EquationsOfMotion> candidates;
  const auto add = [&](Formulation formulation, Passes passes) {
    candidates.push_back(equations_of_motion(kinematics, formulation, passes));
    const EquationsOfMotion& equations = candidates.back();
    log.done("equations",
             fmt::format("{}: Q {} operations, M {}, c {}", to_string(formulation),
                         count_operations(equations.Q).total(), count_operations(equations.M).total(),
                         count_operations(equations.c).total()));
  };
  // Programs of several are compared, unless one's equations are all so much longer that nothing can change it.
  const auto is_much_longer = [](const EquationsOfMotion& x, const EquationsOfMotion& y) {
    const auto by = [](std::span<const Expr> a, std::span<const Expr> b) {
      return 4 * count_operations(a).total() > 5 * count_operations(b).total();
    };
    return by(x.Q, y.Q) && by(x.M, y.M) && by(x.c, y.c);
  };
  if (options.formulation == Formulation::factored) {
    add(Formulation::factored, options.passes);
    return candidates;
  }
  add(Formulation::reduced, options.passes);
  if (options.passes.peeling && kinematics.peeled) {
    Passes others = options.passes;
    others.peeling = false;
    others.effort = 0;
    add(Formulation::reduced, others);
    if (is_much_longer(candidates[1], candidates[0])) candidates.pop_back();
  }
  if (options.formulation) return candidates;
  // The literal form repeats every product of 4x4 matrices. It can only win where there is next to nothing to
  // multiply, so it is tried only there.
  constexpr std::size_t kSmall = 3;
  if (kinematics.mechanism.bodies.size() <= kSmall) {
    add(Formulation::factored, options.passes);
    if (is_much_longer(candidates.back(), candidates.front())) candidates.pop_back();
  }
  return candidates;
}

/// Straight on, or with dot products and steps that repeat as loops.
Program in_final_order(const CompiledFunction& function, const CompileOptions& options) {
  Program program = schedule(function.program);
  if (options.loop_results > 0) program = gather_dot_products(program, options.loop_results);
  const std::size_t straight = function.count.all() - program.dot_product_code;
  if (straight <= options.loop_operations) return program;
  // Few steps among much else are not worth their way through memory.
  Program rerolled = reroll(program);
  return 4 * operations_in_loops(rerolled) >= straight ? rerolled : program;
}

void dump_expressions(std::ostream& out, std::string_view title, std::span<const Expr> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    out << fmt::format("{}[{}] = {}\n", title, i, to_string(values[i], 4000));
}

void dump_mechanism(std::ostream& out, const Mechanism& mechanism) {
  out << fmt::format("mechanism {}: {} coordinates, {} speeds, {} bodies\n", mechanism.name, mechanism.nq,
                     mechanism.nv, mechanism.bodies.size());
  for (const Body& body : mechanism.bodies) {
    out << fmt::format(
        "body {} parent {} factors {} mass {}\n", body.name,
        body.parent < 0 ? "world" : mechanism.bodies[static_cast<std::size_t>(body.parent)].name,
        body.transform.factors.size(), to_string(body.mass_properties.mass));
  }
}

void dump_tree(std::ostream& out, const MotionTree& tree) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const MotionNode& node = tree.nodes[i];
    out << fmt::format("node {} parent {}", i, node.parent);
    switch (node.motion.kind) {
      case MotionKind::translation:
        out << " translation";
        for (const Expr& e : node.motion.offset.entries) out << ' ' << to_string(e);
        break;
      case MotionKind::axis_rotation:
        out << " rotation "
            << "xyz"[node.motion.axis] << ' ' << to_string(node.motion.angle);
        break;
      case MotionKind::rotation:
        out << " rotation";
        for (const Expr& e : node.motion.matrix.entries) out << ' ' << to_string(e);
        break;
    }
    out << '\n';
    for (const TwistPartial& partial : node.partials) {
      out << "  speed " << partial.speed << ':';
      for (const Expr& e : partial.direction.entries) out << ' ' << to_string(e);
      out << '\n';
    }
  }
}

}  // namespace

std::vector<std::string> dump_stages() {
  return {"load", "kinematics", "equations", "optimise", "lower", "schedule"};
}

const CompiledFunction& CompiledMechanism::function(FunctionKind kind) const {
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const CompiledFunction& f) { return f.kind == kind; });
  if (found == functions.end())
    throw InternalError(fmt::format("function {} was not compiled", to_string(kind)));
  return *found;
}

std::vector<FunctionKind> default_functions(const Mechanism& mechanism) {
  std::vector<FunctionKind> kinds;
  for (const OutputFunction& row : kOutputFunctions) {
    if (row.by_default && has_results(row, mechanism)) kinds.emplace_back(row);
  }
  return kinds;
}

namespace {

/// From equations to the program of a function that is verified last: the shortest that is near enough to the
/// plain equations.
class FunctionWriter {
 public:
  FunctionWriter(const Kinematics& kinematics, const std::vector<SymbolBinding>& bindings,
                 const Certificate& certificate, const CompileOptions& options)
      : kinematics_(kinematics), bindings_(bindings), certificate_(certificate), options_(options) {}

  /// Throws SingularMassMatrix where that is why a function that divides by M loses its digits.
  CompiledFunction write(FunctionKind kind, const std::vector<EquationsOfMotion>& candidates) const {
    try {
      return shortest(kind, candidates);
    } catch (const std::logic_error&) {  // a defect, or a division by zero
      const Needs needs = kind.row().needs;
      if (needs == Needs::regular_mass_matrix || needs == Needs::regular_constrained_motion)
        check_mass_matrix(kinematics_, certificate_.plain(), kNearlySingular);
      throw;
    }
  }

 private:
  CompiledFunction shortest(FunctionKind kind, const std::vector<EquationsOfMotion>& candidates) const {
    std::vector<Candidate> found;
    for (const EquationsOfMotion& equations : candidates) {
      if (!found.empty() && !is_of_equations(kind)) break;
      std::optional<std::vector<OutputExpressions>> outputs = outputs_of(equations, kind);
      if (!outputs ||
          std::any_of(found.begin(), found.end(), [&](const Candidate& c) { return c.outputs == *outputs; }))
        continue;
      found.push_back(candidate(kind, equations.formulation, *std::move(outputs)));
    }
    // Unweighted, since functions share sines and cosines: by weights, gravity of the four-bar knee is 6 longer.
    std::stable_sort(found.begin(), found.end(), [](const Candidate& x, const Candidate& y) {
      return x.function.count.all() < y.function.count.all();
    });
    MeasuredError error;
    std::optional<CompiledFunction> explained;
    const auto is_good = [&](Candidate& one) {
      finish(one);
      error = one.function.error;
      if (certificate_.is_small(error)) return true;
      const bool worse = explained && (explained->error.without_value.size() < error.without_value.size() ||
                                       explained->error.relative <= kWorseError * error.relative);
      if (!worse && certificate_.explains(error, kind)) explained = one.function;
      return false;
    };
    for (Candidate& one : found)
      if (is_good(one)) return written(std::move(one.function));
    // Of what comes late, nothing that fails keeps what is explained from being written.
    const auto is_better = [&](Candidate& one) {
      try {
        return is_good(one);
      } catch (const InternalError&) {
        if (!explained) throw;
        return false;
      }
    };
    // What loses too many digits gives way to less of the same.
    const Formulation formulation = candidates.front().formulation;
    for (Passes passes = options_.passes; formulation == Formulation::reduced;) {
      passes.effort = 0;
      if (passes.regrouping) {
        passes.regrouping = false;
      } else if (passes.placement || passes.scaling || passes.peeling) {
        const bool articulation = passes.articulation;
        passes = plain_passes();
        passes.articulation = articulation;
      } else if (passes.articulation) {
        passes.articulation = false;
      } else if (!passes.augmentation && kind.row().needs == Needs::regular_constrained_motion) {
        passes.augmentation = true;
      } else {
        break;
      }
      std::optional<std::vector<OutputExpressions>> outputs =
          outputs_of(equations_of_motion(kinematics_, formulation, passes), kind);
      if (!outputs) continue;
      Candidate one = candidate(kind, formulation, *std::move(outputs));
      if (is_better(one)) return written(std::move(one.function));
    }
    // The plain equations may lose as many digits, or not; as they are, since what is shorter may overflow sooner.
    Candidate plain = as_they_are(kind, formulation, certificate_.plain().expressions(kind));
    if (is_better(plain)) return written(std::move(plain.function));
    if (explained) return written(*std::move(explained));
    if (!error.without_value.empty())
      throw InternalError(
          fmt::format("{} has no value in double precision at a state where the plain equations have one",
                      to_string(kind)));
    if (error.relative <= kLargestError)
      throw InternalError(fmt::format("{}: {} is 0 where the plain equations give {:.1e}", to_string(kind),
                                      error.array, error.excesses.front().difference));
    throw InternalError(
        fmt::format("{}: its relative error is {:.1e} in {}, where {:.0e} is the most that is written",
                    to_string(kind), error.relative, error.array, kLargestError));
  }

  struct Candidate {
    CompiledFunction function;
    std::vector<OutputExpressions> outputs;
  };

  /// None where these equations divide by what cancels to zero: others may not.
  std::optional<std::vector<OutputExpressions>> outputs_of(const EquationsOfMotion& equations,
                                                           FunctionKind kind) const {
    try {
      return function_outputs(kinematics_, equations, kind);
    } catch (const std::domain_error&) {
      return std::nullopt;
    }
  }

  Candidate candidate(FunctionKind kind, Formulation formulation,
                      std::vector<OutputExpressions> outputs) const {
    const std::vector<OutputExpressions> optimized =
        with_elements(outputs, kinematics_.lengths.optimized(elements(outputs)));
    for (const OutputExpressions& output : optimized)
      if (dumping("optimise")) dump_expressions(*options_.dump, output.name, output.values);
    Candidate one = as_they_are(kind, formulation, optimized);
    one.outputs = std::move(outputs);
    return one;
  }
  Candidate as_they_are(FunctionKind kind, Formulation formulation,
                        std::vector<OutputExpressions> outputs) const {
    Program program = lower(std::string(to_string(kind)), outputs, bindings_);
    program.formulation = to_string(formulation);
    if (dumping("lower")) *options_.dump << dump(program);
    const OperationCount operations = count(program);
    return {{kind, formulation, std::move(program), operations, {}}, std::move(outputs)};
  }

  /// Puts a program in its final order, verifies it and measures how far it is from the plain equations.
  void finish(Candidate& one) const {
    CompiledFunction& function = one.function;
    function.program = in_final_order(function, options_);
    if (dumping("schedule")) *options_.dump << dump(function.program);
    verify(function.program, one.outputs, bindings_);
    function.error = certificate_.measure(function.program, function.kind);
  }

  static CompiledFunction written(CompiledFunction function) {
    function.program = without_unused_inputs(std::move(function.program));
    if (function.error.states > 0) function.program.error = function.error.relative;
    return function;
  }

  bool dumping(std::string_view stage) const {
    return options_.dump != nullptr && options_.dump_stage == stage;
  }

  const Kinematics& kinematics_;
  const std::vector<SymbolBinding>& bindings_;
  const Certificate& certificate_;
  const CompileOptions& options_;
};

/// What linearize of the runtime takes instead of M, c and the derivatives of inverse dynamics.
std::optional<AxisPrograms> axis_programs(const Kinematics& kinematics,
                                          const std::vector<SymbolBinding>& bindings,
                                          const Certificate& certificate, StageLog& log) {
  const std::optional<AxisForm> form = axis_form(kinematics);
  if (!form) return std::nullopt;
  const auto written = [&](std::string name, std::vector<OutputExpressions> outputs) {
    const std::vector<OutputExpressions> optimized =
        with_elements(outputs, kinematics.lengths.optimized(elements(outputs)));
    Program program = schedule(lower(std::move(name), optimized, bindings));
    verify(program, outputs, bindings);
    return program;
  };
  const auto n = static_cast<std::uint32_t>(kinematics.mechanism.nv);
  AxisPrograms axes{form->table, written("axis_frames", {{"frames", 12, n, form->frames}}), {}};
  if (!form->Q.empty())
    axes.forces = written("axis_forces",
                          {{"Q", n, 1, form->Q},
                           {"changes", static_cast<std::uint32_t>(form->changes.size()), 1, form->changes}});
  const std::optional<double> error = axis_error(certificate, bindings, axes);
  log.done("axes",
           error ? fmt::format("frames: {}; relative error {:.1e}", describe(count(axes.frames)), *error)
                 : "nothing to compare");
  if (!error || *error > kLargestAxisError) return std::nullopt;
  axes.frames = without_unused_inputs(std::move(axes.frames));
  if (axes.forces) axes.forces = without_unused_inputs(*std::move(axes.forces));
  return axes;
}

/// What is done about functions that the mechanism has no values for (Inapplicable).
void check_applicable(const Kinematics& kinematics, const PlainEquations& plain,
                      const CompileOptions& options, std::vector<FunctionKind>& kinds) {
  if (options.inapplicable == Inapplicable::leave_out) {
    std::erase_if(kinds, [&](FunctionKind kind) { return !has_results(kind.row(), kinematics.mechanism); });
  }
  for (const FunctionKind kind : kinds) {
    const Needs needs = kind.row().needs;
    if ((needs != Needs::mass && needs != Needs::inertia) || has_results(kind.row(), kinematics.mechanism))
      continue;
    throw InputError(kinematics.mechanism.bodies.front().where,
                     fmt::format("{} has no value: no body has a mass{}", to_string(kind),
                                 needs == Needs::inertia ? " or an inertia" : ""));
  }
  try {
    check_mass_matrix(kinematics, plain);
  } catch (const SingularMassMatrix& error) {
    const auto solves = [](FunctionKind kind) { return kind.row().needs == Needs::regular_mass_matrix; };
    const bool solved = std::ranges::any_of(kinds, solves);
    if (options.inapplicable == Inapplicable::refuse_singular ||
        (options.inapplicable == Inapplicable::refuse && solved))
      throw;
    std::erase_if(kinds, solves);
    if (options.warn) options.warn({{error.where(), error.message(), error.note()}});
  }
}

/// A warning where few digits are right: in which functions, and the coordinate that the others leave no inertia.
Warnings doubtful_functions(const Kinematics& kinematics, const PlainEquations& plain,
                            const std::vector<CompiledFunction>& functions) {
  std::vector<std::string> errors;
  bool divides = false;
  for (const CompiledFunction& function : functions) {
    if (!(function.error.relative > kDoubtfulError)) continue;
    errors.push_back(fmt::format("{:.1e} in {}", function.error.relative, to_string(function.kind)));
    divides |= function.kind.row().needs == Needs::regular_mass_matrix;
  }
  if (errors.empty()) return {};
  const std::string message =
      fmt::format("double precision leaves few right digits, in the plain equations too: errors are {}, ",
                  fmt::join(errors, ", ")) +
      "relative to the largest entry";
  std::string note;
  if (const auto light = divides ? light_coordinate(kinematics, plain, kNearlySingular) : std::nullopt)
    note = fmt::format("of the inertia along '{}' {:.1g} is left while the others move; ",
                       light->coordinate->name, light->fraction) +
           "an `armature` there (a rotor's inertia) gives digits back";
  return {{kinematics.mechanism.where, message, note}};
}

CompiledMechanism compile_stages(std::shared_ptr<const SourceText> source, const CompileOptions& options) {
  CompiledMechanism compiled;
  compiled.graph = std::make_unique<ExprGraph>();
  ExprGraph& graph = *compiled.graph;
  StageLog log(options.talk, graph);
  const auto dumping = [&](std::string_view stage) {
    return options.dump != nullptr && options.dump_stage == stage;
  };

  auto loaded = std::make_unique<Mechanism>(load_mechanism(std::move(source), graph, options.inputs));
  std::vector<int>& base_columns = loaded->base_columns;
  std::vector<double>& lengths = loaded->row_lengths;
  compiled.mechanism = std::move(loaded);
  const Mechanism& mechanism = *compiled.mechanism;
  if (options.warn) options.warn(mechanism.warnings);
  log.done("load", fmt::format("{} bodies, {} coordinates", mechanism.bodies.size(), mechanism.nq));
  if (dumping("load")) dump_mechanism(*options.dump, mechanism);

  const Kinematics kinematics = symbolic_kinematics(mechanism, graph);
  log.done("kinematics", fmt::format("{} elementary motions", kinematics.tree.nodes.size()));
  if (const std::size_t times = kinematics.derivatives.d_star_gave_up(); log.on() && times > 0) {
    *options.talk << fmt::format(
        "note: D* reached its step cap {} times; forward or reverse mode was kept there\n", times);
  }
  if (dumping("kinematics")) {
    dump_tree(*options.dump, kinematics.tree);
    if (kinematics.peeled) {
      *options.dump << "with screws peeled off:\n";
      dump_tree(*options.dump, *kinematics.peeled);
    }
  }

  if (std::ranges::find(options.functions, FunctionKind("base_regressor")) != options.functions.end()) {
    for (const BaseParameter& parameter : base_parameters(kinematics).base)
      base_columns.push_back(static_cast<int>(parameter.parameter));
    log.done("base", fmt::format("{} base parameters", base_columns.size()));
  }

  std::vector<FunctionKind> kinds =
      options.functions.empty() ? default_functions(mechanism) : options.functions;
  // Short equations are searched for where something is made of them.
  const auto have_lengths = [&] {
    return std::ranges::find(kinds, FunctionKind("constraints")) != kinds.end();
  };
  CompileOptions searching = options;
  if (!have_lengths() && !dumping("equations") && std::ranges::none_of(kinds, is_of_equations))
    searching.passes = plain_passes();
  const std::vector<EquationsOfMotion> candidates = candidate_equations(kinematics, searching, log);
  if (dumping("equations")) {
    dump_expressions(*options.dump, "Q", candidates.front().Q);
    dump_expressions(*options.dump, "M", candidates.front().M);
    dump_expressions(*options.dump, "c", candidates.front().c);
  }

  const std::vector<SymbolBinding> bindings = symbol_bindings(mechanism, graph);
  const Certificate certificate(kinematics, bindings, options.states);
  check_applicable(kinematics, certificate.plain(), options, kinds);
  log.done("certificate", "the plain equations, and whether M is singular");
  if (have_lengths())
    lengths = row_lengths(kinematics,
                          constraint_equations(mechanism, kinematics.tree, kinematics.derivatives, graph),
                          candidates.front().M);
  const FunctionWriter writer(kinematics, bindings, certificate, options);
  for (const FunctionKind kind : kinds) {
    try {
      CompiledFunction written = writer.write(kind, candidates);
      log.done("program", fmt::format("{}: {}; relative error {:.1e} at {} states", to_string(kind),
                                      describe(written.count), written.error.relative, written.error.states));
      compiled.functions.push_back(std::move(written));
    } catch (const SingularMassMatrix& error) {
      if (options.inapplicable != Inapplicable::leave_out) throw;
      if (options.warn) options.warn({{error.where(), error.message(), error.note()}});
    }
  }
  if (options.axes && std::ranges::count(compiled.functions, FunctionKind("mass_matrix_and_bias"),
                                         &CompiledFunction::kind) > 0)
    compiled.axes = axis_programs(kinematics, bindings, certificate, log);
  if (options.warn) options.warn(doubtful_functions(kinematics, certificate.plain(), compiled.functions));
  return compiled;
}

}  // namespace

void fail_without_value(std::shared_ptr<const SourceText> source, const std::domain_error& error) {
  const std::string message = std::string("the equations of this mechanism have no value: ") + error.what();
  if (dynamic_cast<const ConstantOutOfRange*>(&error) == nullptr)
    throw InputError({std::move(source), 1, 1}, message);
  throw InputError(most_extreme_number(source), message,
                   "a product of numbers is out of range; this one is the farthest from 1");
}

CompiledMechanism compile_mechanism(std::shared_ptr<const SourceText> source, const CompileOptions& options) {
  try {
    return compile_stages(source, options);
  } catch (const std::domain_error& error) {
    fail_without_value(std::move(source), error);
  }
}

}  // namespace alembert

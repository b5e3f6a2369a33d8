// `report`: operations of each function, by the counting convention of program/program.hpp.
#include "commands/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

#include "commands/common_options.hpp"
#include "mechanism/constraint_rows.hpp"
#include "program/loops/dot_products.hpp"
#include "program/loops/reroll.hpp"

namespace alembert {

namespace {

constexpr const char* kConvention =
    "x and + (subtractions are adds); negation and multiplication by +-1 free, 2x is one add; divisions and "
    "trigonometry apart;\n"
    "a constant offset in a trigonometric argument belongs to that call; constants folded; gravity "
    "included\n";

/// Whether a function is counted unless others are asked for: poses, Jacobians and derivatives are not.
bool is_of_dynamics(FunctionKind kind) {
  switch (kind) {
    case FunctionKind::inverse_dynamics:
    case FunctionKind::mass_matrix:
    case FunctionKind::bias:
    case FunctionKind::mass_matrix_and_bias:
    case FunctionKind::forward_dynamics:
    case FunctionKind::coordinate_rates:
    case FunctionKind::energy:
    case FunctionKind::constraints:
      return true;
    case FunctionKind::body_poses:
    case FunctionKind::frame_poses:
    case FunctionKind::frame_jacobians:
    case FunctionKind::body_jacobians:
    case FunctionKind::body_inertias:
    case FunctionKind::inverse_dynamics_derivatives:
      return false;
  }
  return false;
}

}  // namespace

int run_report(const CommonOptions& common, const ReportOptions& options) {
  std::vector<FunctionKind> functions = function_kinds(options.functions);
  const SingularMass singular =
      functions.empty() ? SingularMass::leave_out : SingularMass::refuse_where_solved;
  if (functions.empty())
    std::ranges::copy_if(all_function_kinds(), std::back_inserter(functions), is_of_dynamics);
  CompiledMechanism compiled = compile(common, functions, singular);
  const Mechanism& mechanism = *compiled.mechanism;
  const std::size_t rows = constraint_rows(mechanism).size();
  if (rows == 0) {
    std::erase_if(compiled.functions,
                  [](const CompiledFunction& f) { return f.kind == FunctionKind::constraints; });
  }
  if (options.json) {
    nlohmann::ordered_json out;
    out["mechanism"] = mechanism.name;
    out["coordinates"] = mechanism.nq;
    out["speeds"] = mechanism.nv;
    if (rows > 0) out["constraint_rows"] = rows;
    for (const CompiledFunction& f : compiled.functions) {
      out["functions"][std::string(to_string(f.kind))] = {
          {"mul", f.count.mul},   {"add", f.count.add},     {"div", f.count.div},
          {"trig", f.count.trig}, {"other", f.count.other}, {"formulation", to_string(f.formulation)}};
      if (f.program.error) out["functions"][std::string(to_string(f.kind))]["error"] = *f.program.error;
      if (const std::size_t n = dot_products(f.program); n > 0)
        out["functions"][std::string(to_string(f.kind))]["dot_products"] = n;
      if (const std::size_t n = operations_in_loops(f.program); n > 0)
        out["functions"][std::string(to_string(f.kind))]["in_loops"] = n;
    }
    fmt::print("{}\n", out.dump(2));
    return 0;
  }
  fmt::print("{}: {} coordinates, {} speeds, {} bodies{}\n", mechanism.name, mechanism.nq, mechanism.nv,
             mechanism.bodies.size(), rows > 0 ? fmt::format(", {} rows of constraints", rows) : "");
  std::size_t width = 22;
  for (const CompiledFunction& f : compiled.functions) width = std::max(width, to_string(f.kind).size());
  fmt::print("{:<{}} {:>7} {:>7} {:>9} {:>5} {:>5} {:>6}  {}\n", "function", width, "x", "+", "x and +",
             "div", "trig", "other", "formulation");
  for (const CompiledFunction& f : compiled.functions) {
    fmt::print("{:<{}} {:>7} {:>7} {:>9} {:>5} {:>5} {:>6}  {}\n", to_string(f.kind), width, f.count.mul,
               f.count.add, f.count.arithmetic(), f.count.div, f.count.trig, f.count.other,
               to_string(f.formulation));
  }
  for (const CompiledFunction& f : compiled.functions) {
    if (const std::size_t n = dot_products(f.program); n > 0)
      fmt::print("{} has {} dot products in loops (--loop-results {})\n", to_string(f.kind), n,
                 common.loop_results);
    if (const std::size_t n = operations_in_loops(f.program); n > 0)
      fmt::print("{} has {} operations in loops over steps (--loop-operations {})\n", to_string(f.kind), n,
                 common.loop_operations);
  }
  fmt::print("\n{}", kConvention);
  return 0;
}

}  // namespace alembert

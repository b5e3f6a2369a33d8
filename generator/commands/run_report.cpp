// `report`: operations of each function, by the counting convention of program/count.hpp.
#include "commands/run_report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands/common_options.hpp"
#include "commands/memory.hpp"
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

}  // namespace

int run_report(const CommonOptions& common, const ReportOptions& options) {
  FunctionChoice choice = function_choice(options.functions);
  if (choice.kinds.empty()) {
    for (const OutputFunction& row : kOutputFunctions) {
      if (row.topic == Topic::dynamics) choice.kinds.emplace_back(row);
    }
    choice.inapplicable = Inapplicable::leave_out;
  }
  const CompiledMechanism compiled = compile(common, choice.kinds, choice.inapplicable);
  const Mechanism& mechanism = *compiled.mechanism;
  std::optional<MechanismMemory> memory;
  if (!options.memory.empty()) memory = measured_memory(compiled, options.memory, options.compiler);
  const std::size_t rows = constraint_rows(mechanism).size();
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
    for (std::size_t f = 0; memory && f < compiled.functions.size(); ++f) {
      auto& function = out["functions"][std::string(to_string(compiled.functions[f].kind))];
      function["code_bytes"] = memory->functions[f].code;
      function["stack_bytes"] = memory->functions[f].stack;
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
  if (!memory) return 0;
  fmt::print("\nC99 for {}, compiled by `{}`: bytes of code, of stack\n", options.memory, options.compiler);
  for (std::size_t f = 0; f < compiled.functions.size(); ++f)
    fmt::print("{:<{}} {:>7} {:>7}\n", to_string(compiled.functions[f].kind), width,
               memory->functions[f].code, memory->functions[f].stack);
  fmt::print(
      "shared code {}, constants and names {}. The stack is what the compiler says of frames, those of\n"
      "sin, cos and other functions of the C library apart.\n",
      memory->shared_code, memory->constants);
  return 0;
}

}  // namespace alembert

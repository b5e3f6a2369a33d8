// Stage `dump`: program in, text out, one instruction a line, for people and for comparing two programs.
#include "program/dump.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

#include "support/operation.hpp"

namespace alembert {
std::string dump(const Program& program) {
  std::string text = "function " + program.function;
  if (!program.formulation.empty()) text += " (" + program.formulation + ")";
  text += "\n";
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < program.code.size(); ++i) {
    const Instruction& c = program.code[i];
    const std::string_view name = operation_name(c.op);
    fmt::format_to(out, "t{} = ", i);
    if (c.op == Operation::constant) {
      fmt::format_to(out, "{}", program.constants[c.a]);
    } else if (c.op == Operation::input) {
      const InputSlot& slot = program.inputs[c.a];
      if (slot.kind == ArgumentKind::time)
        fmt::format_to(out, "t");
      else
        fmt::format_to(out, "{}[{}]", argument_name(slot.kind), slot.index);
      if (!slot.name.empty()) fmt::format_to(out, "  # {}", slot.name);
    } else if (c.op == Operation::neg) {
      fmt::format_to(out, "-t{}", c.a);
    } else if (!is_call(c.op)) {
      fmt::format_to(out, "t{} {} t{}", c.a, name, c.b);
    } else if (operand_count(c.op) == 2) {
      fmt::format_to(out, "{}(t{}, t{})", name, c.a, c.b);
    } else {
      fmt::format_to(out, "{}(t{})", name, c.a);
    }
    text += "\n";
  }
  for (const OutputArray& output : program.outputs)
    for (std::size_t k = 0; k < output.values.size(); ++k)
      fmt::format_to(out, "{}[{}] = t{}\n", output.name, k, output.values[k]);
  for (const Loop& loop : program.loops)
    fmt::format_to(out, "loop: {} iterations of {} instructions from t{}\n", loop.count, loop.length,
                   loop.first);
  for (const DotProducts& products : program.dot_products)
    for (const DotProducts::Run& run : products.runs)
      fmt::format_to(
          out, "loop: {0}[{1} + {2} i], {0}[{3} + {4} i] for i < {5}: left row {6}, right row {7} + i\n",
          program.outputs[products.output].name, run.first, run.stride, run.mirror, run.step, run.count,
          run.left, run.right);
  return text;
}

}  // namespace alembert

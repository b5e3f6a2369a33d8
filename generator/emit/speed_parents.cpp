#include "emit/speed_parents.hpp"

#include <algorithm>
#include <cstddef>

namespace alembert {
namespace {

bool is_zero(const Program& program, std::uint32_t value) {
  const Instruction& instruction = program.code[value];
  return instruction.op == Operation::real && program.constants[instruction.a] == 0;
}

}  // namespace

std::vector<int> speed_parents(std::span<const Program> programs, int nv) {
  const auto n = static_cast<std::size_t>(nv);
  const auto program = std::ranges::find(programs, "mass_matrix_and_bias", &Program::function);
  const OutputArray* mass = nullptr;
  if (program != programs.end()) {
    const auto found = std::ranges::find(program->outputs, "M", &OutputArray::name);
    if (found != program->outputs.end()) mass = &*found;
  }
  // Of row k of L, entries before the diagonal that may differ from zero.
  std::vector<std::vector<bool>> rows(n);
  for (std::size_t k = 0; k < n; ++k) {
    rows[k].assign(k, true);
    for (std::size_t i = 0; mass && i < k; ++i)
      rows[k][i] = !is_zero(*program, mass->values[i * n + k]) || !is_zero(*program, mass->values[k * n + i]);
  }
  std::vector<int> parents(n, -1);
  for (std::size_t k = n; k-- > 0;) {
    std::size_t parent = k;
    while (parent > 0 && !rows[k][parent - 1]) --parent;
    if (parent-- == 0) continue;
    parents[k] = static_cast<int>(parent);
    for (std::size_t i = 0; i < parent; ++i)
      if (rows[k][i]) rows[parent][i] = true;
  }
  return parents;
}

}  // namespace alembert

#include "emit/speed_parents.hpp"

#include <cstddef>

namespace alembert {
namespace {

bool is_zero(const Program& program, std::uint32_t value) {
  const Instruction& instruction = program.code[value];
  return instruction.op == Operation::real && program.constants[instruction.a] == 0;
}

}  // namespace

std::vector<int> speed_parents(const Program& program, int nv) {
  const std::vector<std::uint32_t>& mass = program.outputs.front().values;
  const auto n = static_cast<std::size_t>(nv);
  // Of row k of L, entries before the diagonal that may differ from zero.
  std::vector<std::vector<bool>> rows(n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < k; ++i)
      rows[k].push_back(!is_zero(program, mass[i * n + k]) || !is_zero(program, mass[k * n + i]));
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

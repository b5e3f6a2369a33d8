// Rewrite of stage `optimise`: common factors of sums.
#include "program/rewrites.hpp"

namespace alembert {
ValueProgram factor_sums(const ValueProgram& program) {
  return program;
}
}  // namespace alembert

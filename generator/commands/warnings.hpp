// Warnings in, diagnostics on standard error out.
#pragma once

#include "support/error.hpp"

namespace alembert {

/// Shows warnings on standard error. If `strict`, they are errors: the last one is thrown.
void report_warnings(const Warnings& warnings, bool strict);

}  // namespace alembert

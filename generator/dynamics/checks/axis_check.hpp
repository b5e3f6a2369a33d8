// Whether a mechanism may be linearized as a tree of axes: what alembert/axis_tree.hpp makes of it, in double precision,
// is compared with the plain equations. In: numbers of the tree and programs. Out: errors.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/checks/certificate.hpp"
#include "functions/axis_table.hpp"

namespace alembert {

/// Errors above it are too large: sums about one point lose digits of what is small and far from it.
inline constexpr double kLargestAxisError = 1e-11;

/// The largest relative error of M, c and the derivatives of inverse dynamics, or nothing where they could not be
/// compared. The programs have all bindings as inputs.
std::optional<double> axis_error(const Certificate& certificate, const std::vector<SymbolBinding>& bindings,
                                 const AxisPrograms& axes);

}  // namespace alembert

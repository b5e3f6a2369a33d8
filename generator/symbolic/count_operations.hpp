// Counting. In: roots. Out: operations, what roots share counted once.
#pragma once

#include <span>

#include "support/operation_count.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

/// Operations of a set of roots, each node counted once, by the convention at `OperationCount`.
OperationCount count_operations(std::span<const Expr> roots);
/// Likewise where the order of what the roots need, which are not empty, is known.
OperationCount count_operations(std::span<const Expr> roots, const Postorder& order);

}  // namespace alembert

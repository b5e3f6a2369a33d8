// Products of the edges of paths. In: one list of factors a path. Out: the products, built so that what many
// paths have in common is multiplied once.
#pragma once

#include <cstdint>
#include <vector>

#include "symbolic/expr.hpp"

namespace alembert {

/// Product of each list (an empty list gives one). The pair of neighbours that occurs in most places is
/// multiplied first and becomes a factor itself, until no pair occurs twice; factors commute, so x y and y x
/// are the same pair. Among equals the pair whose factors occurred first is taken. After `max_work` factors
/// looked at, the rest is multiplied without sharing.
std::vector<Expr> shared_products(ExprGraph& graph, const std::vector<std::vector<Ref>>& paths,
                                  std::uint64_t max_work);

}  // namespace alembert

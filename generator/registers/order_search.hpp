// Search for an order of statements in which registers hold more of what is read. In: an order that obeys
// dependences. Out: one that does too and costs no more (register_file.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "registers/register_file.hpp"

namespace alembert {

/// Statements that must come before a statement, by statement.
using Predecessors = std::vector<std::vector<std::uint32_t>>;

/// Moves runs of statements to other places as long as the cost falls or, at first, rises by little
/// (threshold accepting: G. Dueck and T. Scheuer, Journal of Computational Physics 90, 161, 1990), in windows
/// of some hundred statements, since a change is paid for by going through all of them. Deterministic.
void search_order(const RegisterUses& uses, const Predecessors& predecessors,
                  std::vector<std::uint32_t>& order);

}  // namespace alembert

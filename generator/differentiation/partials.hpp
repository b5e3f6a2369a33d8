// Local derivatives. In: a node and one of its operand slots. Out: the partial derivative of the node with
// respect to the operand's node, as an expression that reuses the node and its operands wherever that saves
// work.
#pragma once

#include <cstdint>

#include "symbolic/expr.hpp"

namespace alembert {

/// d node / d operand, where `slot` 0 is Node::a and 1 is Node::b; the other operand is held fixed. The
/// derivative is with respect to the unsigned operand node, so the sign an operand carries is part of the
/// result. `sign` has derivative zero and `abs` has derivative sign. Throws InternalError for a slot that the
/// operation does not have.
Ref local_partial(ExprGraph& graph, std::uint32_t node, int slot);

}  // namespace alembert

// Screw peeling: motions of any spelling in; where they are screws, products of plane rotations and shifts out.
//
// A frame on a torus, a mate, a matrix or a composition is often a product of screws in disguise. If the
// spatial twist (D_k A) A^-1 is the same in all states, A = exp(xi q_k) A' and q_k is gone from A': it is
// peeled from the left; if A^-1 (D_k A) is, from the right. Whether it is the same is proved in a
// finite field, where functions that are flat somewhere are not constant; what it is comes from the
// expressions at a reference value, so that constants stay exact and runtime parameters symbols. The product
// is compared with the given one at random states besides, and thrown away if they differ.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/tree/motion.hpp"
#include "dynamics/tree/motion_tree.hpp"

namespace alembert {

/// The motions of one transform with screws peeled off, constants between them gathered. Nothing if there is
/// nothing to peel, that is if they are plane rotations and shifts of one coordinate each already.
std::optional<std::vector<Motion>> peeled_motions(const std::vector<Motion>& motions,
                                                  const Mechanism& mechanism,
                                                  const SpeedDerivatives& derivatives, ExprGraph& graph);

}  // namespace alembert

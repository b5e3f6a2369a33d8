// What bodies slide on. In: a mechanism and its motion. Out: curves and surfaces as parts of a scene.
#pragma once

#include "viewer/looks.hpp"

namespace alembert {

/// Whether a body has shapes of its own; -1: the world, which has those of bodies without a transform.
bool has_shapes(const Mechanism& mechanism, int body);

/// The curves and surfaces that bodies move on, drawn on what they are fixed to, unless that has shapes of
/// its own.
void add_contacts(Scene& scene, Looks& looks, const Mechanism& mechanism, ExprGraph& graph,
                  const BakedMotion& motion);

}  // namespace alembert

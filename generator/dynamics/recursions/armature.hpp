// Inertia that a coordinate has beside the bodies it moves.
#pragma once

#include <vector>

#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// By speed: inertia of its own (armature.cpp), and the force that accelerates it.
std::vector<Expr> armatures(const Mechanism& mechanism);
std::vector<Expr> armature_forces(const Mechanism& mechanism);

}  // namespace alembert

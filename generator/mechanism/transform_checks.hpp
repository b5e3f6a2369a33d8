// Checks of transforms: rotations, and which coordinates move what.
#pragma once

#include <span>
#include <vector>

#include "mechanism/loading.hpp"

namespace alembert {

/// Throws at the first matrix that is no rotation at the initial state or at random states near it
/// (transform_checks.cpp).
void check_matrices(const Loading& loading);

/// All expressions of factors, one after another as model.hpp has them (of a rotation matrix row by row); of a
/// quaternion its first symbol, of a frame the point.
std::vector<Expr> expressions_of(std::span<const Factor> factors, const Mechanism& mechanism);
std::vector<Expr> expressions_of(const Factor& factor, const Mechanism& mechanism);
/// Whether one of the expressions has a symbol below it.
bool depends_on(std::span<const Expr> expressions, const Expr& symbol);
/// Throws where a body's transform moves with more than six speeds, at a shape that moves in its body, and at
/// a coordinate that moves no body.
void check_coordinates(const Loading& loading, const std::vector<const Body*>& bodies_in_file_order);

}  // namespace alembert

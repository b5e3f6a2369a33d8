// Dot products of rows of tables: a program in; the same out, with those that are worth a loop listed.
#pragma once

#include <cstddef>

#include "program/program.hpp"

namespace alembert {

/// After `schedule`: results that are dot products of the rows of two tables, as the far entries of a mass
/// matrix are, move to the end of the code and into `dot_products`. Only if there are `least` or more, in
/// long enough runs to be worth a loop; otherwise the program stays as it is. Same operations; sums may be
/// rounded in another order.
Program gather_dot_products(const Program& program, std::size_t least);

/// How many dot products a program has in loops.
std::size_t dot_products(const Program& program);

}  // namespace alembert

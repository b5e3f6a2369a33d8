// Which speed carries which. In: the program of the mass matrix. Out: the tree that its zeros make of the speeds.
#pragma once

#include <vector>

#include "program/program.hpp"

namespace alembert {

/// For each speed k the last i < k for which L of M = L^T D L may have L(k, i) != 0, or -1: parents in the
/// elimination tree, from the last row up (Davis, Direct Methods for Sparse Linear Systems, 2006, section 4.1, there
/// from the first row down). Between speeds neither of which stands above the other there, M and L are zero at any
/// state.
/// \param program  one of which M, nv x nv, is the first result, such as mass_matrix_and_bias
std::vector<int> speed_parents(const Program& program, int nv);

}  // namespace alembert

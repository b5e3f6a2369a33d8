// puma560: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over many states at a time, on packs of two, four or eight by the instructions that the machine has.
//
// Arrays hold entry i of state s at x[i * stride + s], s = 0 ... n - 1, stride not below n; matrices and poses row by
// row. So lie the columns of a column-major matrix with a row for each state. Arrays must not overlap. What a function
// gives for a state is the same whatever n, its place and the number of threads are.
#pragma once

#include <alembert/batch.hpp>
#include <cstddef>

#include "puma560_raw.hpp"

namespace alembert::mechanisms::puma560 {

/// What the functions take besides the states.
struct BatchInputs {
  Inputs<double> common;                 ///< of all states
  const double* t = nullptr;             ///< [n] if given, in place of common.t
  const double* parameters = nullptr;    ///< [0 x stride] if given, in place of common.parameters
  const double* wrenches = nullptr;      ///< [0 x 6 x stride] if given, in place of common.wrenches
};

/// inverse_dynamics for n states. Returns 0, or for how many of them the result is not finite.
::std::size_t inverse_dynamics_batch(::std::size_t n, ::std::size_t stride, const double* q, const double* qd,
                                     const double* qdd, const BatchInputs& in, double* tau,
                                     const ::alembert::BatchOptions& options = {});

/// mass_matrix_and_bias for n states. Returns 0, or for how many of them the result is not finite.
::std::size_t mass_matrix_and_bias_batch(::std::size_t n, ::std::size_t stride, const double* q, const double* qd,
                                        const BatchInputs& in, double* M, double* c,
                                        const ::alembert::BatchOptions& options = {});

/// forward_dynamics for n states. Returns 0, or for how many of them the result is not finite.
::std::size_t forward_dynamics_batch(::std::size_t n, ::std::size_t stride, const double* q, const double* qd,
                                     const double* tau, const BatchInputs& in, double* qdd,
                                     const ::alembert::BatchOptions& options = {});

}  // namespace alembert::mechanisms::puma560

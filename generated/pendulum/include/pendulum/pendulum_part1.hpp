// pendulum: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "pendulum". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "pendulum_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::pendulum {

// inverse_dynamics: 2 multiplications, 1 addition, 1 sin/cos/tan (reduced formulation; relative error 2.4e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::sin;
  const S q0 = q[0];  // q
  const S t0 = sin(q0);
  const S qdd0 = qdd[0];  // dd(q)
  tau[0] = S(0.30582) * qdd0 + S(5.35626) * t0;
}

// mass_matrix: 0 multiplications, 0 additions (reduced formulation; relative error 6.3e-17 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  M[0] = S(0.30582);
}

// bias: 1 multiplication, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::sin;
  const S q0 = q[0];  // q
  const S t0 = sin(q0);
  c[0] = S(5.35626) * t0;
}

// mass_matrix_and_bias: 1 multiplication, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::sin;
  const S q0 = q[0];  // q
  const S t0 = sin(q0);
  c[0] = S(5.35626) * t0;
  M[0] = S(0.30582);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q)
  qdot[0] = qd0;
}

// energy: 3 multiplications, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 1.7e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  const S q0 = q[0];  // q
  const S t0 = cos(q0);
  e[1] = S(-5.35626) * t0;
  const S qd0 = qd[0];  // d(q)
  e[0] = S(0.15291) * (qd0 * qd0);
}

// body_poses: 0 multiplications, 0 additions, 2 sin/cos/tan (reduced formulation; relative error 5e-17 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q
  const S t0 = sin(q0);
  W[2] = t0;
  const S t1 = cos(q0);
  W[0] = t1;
  W[10] = t1;
  W[8] = -t0;
  W[1] = S(0.0);
  W[3] = S(0.0);
  W[4] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[5] = S(1.0);
}

}  // namespace alembert::mechanisms::pendulum

// cart_pole: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "cart_pole". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "cart_pole_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::cart_pole {

// inverse_dynamics: 9 multiplications, 5 additions, 2 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S qdd0 = qdd[0];  // dd(x)
  const S qdd1 = qdd[1];  // dd(q)
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(cart).fx
  tau[0] = S(2.76) * qdd0 - (f0 - S(0.1728) * (qdd1 * t0 - qd1 * qd1 * t1));
  tau[1] = S(0.111044) * qdd1 - S(0.1728) * (S(9.81) * t1 - qdd0 * t0);
}

// mass_matrix: 1 multiplication, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 9e-17 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  const S q1 = q[1];  // q
  const S t0 = cos(q1);
  const S t1 = S(0.1728) * t0;
  M[1] = t1;
  M[2] = t1;
  M[0] = S(2.76);
  M[3] = S(0.111044);
}

// bias: 4 multiplications, 1 addition, 1 sin/cos/tan (reduced formulation; relative error 9.9e-17 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::sin;
  const S q1 = q[1];  // q
  const S t0 = sin(q1);
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(cart).fx
  c[0] = S(-0.1728) * (qd1 * qd1 * t0) - f0;
  c[1] = S(-1.695168) * t0;
}

// mass_matrix_and_bias: 5 multiplications, 1 addition, 2 sin/cos/tan (reduced formulation; relative error 9.9e-17 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = S(0.1728) * t1;
  M[1] = t2;
  M[2] = t2;
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(cart).fx
  c[0] = S(-0.1728) * (qd1 * qd1 * t0) - f0;
  c[1] = S(-1.695168) * t0;
  M[0] = S(2.76);
  M[3] = S(0.111044);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(x)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q)
  qdot[1] = qd1;
}

// energy: 7 multiplications, 2 additions, 1 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  const S q1 = q[1];  // q
  const S t0 = cos(q1);
  const S qd1 = qd[1];  // d(q)
  const S qd0 = qd[0];  // d(x)
  e[0] = qd0 * (S(0.1728) * (qd1 * t0) + S(1.38) * qd0) + S(0.055522) * (qd1 * qd1);
  e[1] = S(1.695168) * t0;
}

// body_poses: 0 multiplications, 0 additions, 2 sin/cos/tan (reduced formulation; relative error 5e-17 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q
  const S t0 = sin(q1);
  W[14] = t0;
  const S t1 = cos(q1);
  W[12] = t1;
  W[22] = t1;
  W[20] = -t0;
  W[0] = S(1.0);
  W[5] = S(1.0);
  W[10] = S(1.0);
  W[17] = S(1.0);
  W[1] = S(0.0);
  W[2] = S(0.0);
  W[4] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[13] = S(0.0);
  W[16] = S(0.0);
  W[18] = S(0.0);
  W[19] = S(0.0);
  W[21] = S(0.0);
  W[23] = S(0.0);
  const S q0 = q[0];  // x
  W[3] = q0;
  W[15] = q0;
}

}  // namespace alembert::mechanisms::cart_pole

// double_pendulum: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "double_pendulum". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "double_pendulum_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::double_pendulum {

// inverse_dynamics: 15 multiplications, 10 additions, 4 sin/cos/tan (reduced formulation; relative error 2.8e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S qd1 = qd[1];  // d(q2)
  const S qd0 = qd[0];  // d(q1)
  const S t4 = qd1 + qd0;
  const S qdd1 = qdd[1];  // dd(q2)
  const S qdd0 = qdd[0];  // dd(q1)
  const S t5 = qdd1 + qdd0;
  const S t0 = cosine[0];
  const S t3 = sine[1];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t6 = S(0.2295) * (t3 * (S(0.55) * (qd0 * qd0) + S(9.81) * t0) + t2 * (S(0.55) * qdd0 + S(9.81) * t1)) + S(0.081465) * t5;
  tau[1] = t6;
  tau[0] = S(0.126225) * (t5 * t2 - t3 * t4 * t4) + t6 + (S(8.235495) * t1 + S(0.406645) * qdd0);
}

// mass_matrix: 2 multiplications, 2 additions, 1 sin/cos/tan (reduced formulation; relative error 1.2e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  const S q1 = q[1];  // q2
  const S t0 = cos(q1);
  M[0] = S(0.25245) * t0 + S(0.48811);
  const S t2 = S(0.126225) * t0 + S(0.081465);
  M[1] = t2;
  M[2] = t2;
  M[3] = S(0.081465);
}

// bias: 11 multiplications, 5 additions, 4 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S qd1 = qd[1];  // d(q2)
  const S qd0 = qd[0];  // d(q1)
  const S t4 = qd1 + qd0;
  const S t0 = cosine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t1 = sine[0];
  const S t5 = S(0.2295) * (t2 * (S(0.55) * (qd0 * qd0) + S(9.81) * t0) + S(9.81) * (t3 * t1));
  c[1] = t5;
  c[0] = t5 - S(0.126225) * (t4 * t4 * t2) + S(8.235495) * t1;
}

// mass_matrix_and_bias: 13 multiplications, 7 additions, 4 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S qd1 = qd[1];  // d(q2)
  const S qd0 = qd[0];  // d(q1)
  const S t4 = qd1 + qd0;
  const S t0 = cosine[0];
  const S t3 = sine[1];
  const S t2 = cosine[1];
  const S t1 = sine[0];
  const S t5 = S(0.2295) * (t3 * (S(0.55) * (qd0 * qd0) + S(9.81) * t0) + S(9.81) * (t2 * t1));
  c[1] = t5;
  c[0] = t5 - S(0.126225) * (t4 * t4 * t3) + S(8.235495) * t1;
  M[0] = S(0.25245) * t2 + S(0.48811);
  const S t8 = S(0.126225) * t2 + S(0.081465);
  M[1] = t8;
  M[2] = t8;
  M[3] = S(0.081465);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q2)
  qdot[1] = qd1;
}

// energy: 12 multiplications, 6 additions, 4 sin/cos/tan (reduced formulation; relative error 2.1e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S qd1 = qd[1];  // d(q2)
  const S qd0 = qd[0];  // d(q1)
  const S t4 = qd1 + qd0;
  const S t2 = cosine[1];
  e[0] = S(0.2033225) * (qd0 * qd0) + (S(0.0407325) * t4 + S(0.126225) * (qd0 * t2)) * t4;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t3 = sine[1];
  e[1] = S(-3.64932) * t0 - S(8.3385) * (S(0.27) * (t2 * t0 - t1 * t3) + S(0.55) * t0);
}

// body_poses: 6 multiplications, 2 additions, 4 sin/cos/tan (reduced formulation; relative error 9.5e-17 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  W[0] = cosine[0];
  W[10] = cosine[0];
  W[2] = sine[0];
  const S t1 = sine[0];
  W[8] = -t1;
  W[15] = S(-0.55) * t1;
  const S t2 = cosine[1];
  const S t0 = cosine[0];
  const S t3 = sine[1];
  const S t6 = t2 * t1 + t0 * t3;
  W[14] = t6;
  const S t7 = t2 * t0 - t1 * t3;
  W[12] = t7;
  W[22] = t7;
  W[23] = S(-0.55) * t0;
  W[20] = -t6;
  W[1] = S(0.0);
  W[3] = S(0.0);
  W[4] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[13] = S(0.0);
  W[16] = S(0.0);
  W[18] = S(0.0);
  W[19] = S(0.0);
  W[21] = S(0.0);
  W[5] = S(1.0);
  W[17] = S(1.0);
}

}  // namespace alembert::mechanisms::double_pendulum

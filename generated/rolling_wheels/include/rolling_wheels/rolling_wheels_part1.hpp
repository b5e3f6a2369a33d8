// rolling_wheels: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "rolling_wheels". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "rolling_wheels_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::rolling_wheels {

// inverse_dynamics: 64 multiplications, 43 additions, 8 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // q1
  const S t0 = S(4.0) * q0;
  const S q1 = q[1];  // q2
  const S t1 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t10 = qd0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t11 = qd1 * (S(0.37) * qd1 + S(2.96) * qd0) + S(5.92) * t10;
  const S t12 = S(3.0833333333333335) * qd1 + S(4.0) * qd0;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t3 = cosine[0];
  const S t2 = sine[0];
  const S t13 = qdd0 * t3 - t2 * t10 + S(9.81);
  const S t14 = t3 * t10 + qdd0 * t2;
  const S t15 = t12 * t12;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t16 = S(0.37) * qdd1 + S(1.48) * qdd0;
  const S t17 = S(4.0) * qdd0 + S(3.0833333333333335) * qdd1;
  const S t6 = sine[2];
  const S t7 = cosine[2];
  const S t18 = t6 * t14 + t13 * t7;
  const S t19 = t6 * t13 - t7 * t14;
  const S t4 = cosine[1];
  const S t5 = sine[1];
  const S t20 = t4 * t11 - t19 + t16 * t5;
  const S t21 = t4 * t16 - (t11 * t5 - t18);
  const S t8 = cosine[3];
  const S t9 = sine[3];
  const S t22 = S(0.21) * t21 + S(0.0015143315356948754) * (t17 * t8 - t9 * t15);
  const S t23 = S(0.0015143315356948754) * (t15 * t8 + t9 * t17) + S(0.21) * t20;
  const S t24 = S(0.0015143315356948754) * (t9 * t20 + t21 * t8) + S(0.00151092) * t17;
  const S t25 = S(0.37) * (t23 * t5 + t4 * t22);
  const S f0 = in.wrenches[0];  // wrench(wheel).fx
  const S f1 = in.wrenches[1];  // wrench(wheel).fy
  const S t26 = f0 * t6 - f1 * t7;
  const S t27 = f0 * t7 + f1 * t6;
  const S t28 = t27 + (S(0.48) * t10 - S(0.078) * qdd0) + t23;
  const S t29 = S(0.312) * t10 + S(0.12) * qdd0 + t26 + t22;
  const S f5 = in.wrenches[5];  // wrench(wheel).tz
  const S t30 = S(4.0) * (f5 + (S(0.013) * t27 - S(0.02) * t26) - (S(0.267414) * qdd0 + (S(0.03) * t18 + S(0.0195) * t19)) - (t24 + t25));
  tau[0] = t2 * (t6 * t29 + t7 * t28 + S(1.5) * t14) + (t29 * t7 - t6 * t28 + S(1.5) * t13) * t3 - t30;
  tau[1] = S(3.0833333333333335) * t24 + t25;
}

// mass_matrix: 31 multiplications, 22 additions, 8 sin/cos/tan (reduced formulation; relative error 2.9e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S t0 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S q0 = q[0];  // q1
  const S t1 = S(4.0) * q0;
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S t6 = sine[2];
  const S t10 = S(0.0015143315356948754) * t6;
  const S t7 = cosine[2];
  const S t11 = S(0.0015143315356948754) * t7;
  const S t4 = sine[1];
  const S t5 = cosine[1];
  const S t12 = t4 * t10 + t5 * t11;
  const S t13 = S(0.37) * t12;
  const S t2 = sine[0];
  const S t8 = cosine[3];
  const S t9 = sine[3];
  const S t3 = cosine[0];
  const S t14 = t2 * t8 - t9 * t3;
  const S t15 = t8 * t3 + t9 * t2;
  const S t16 = S(8.0) * (t14 * (S(0.0195) - (S(0.0777) * t4 + t10)) - t15 * (t11 + S(0.0777) * t5 + S(0.03)));
  const S t17 = S(4.0) * (t13 + S(0.028749)) + (S(12.333333333333334) * (t13 + S(0.00151092)) + (S(3.0833333333333335) * (t11 * t15 + t14 * t10) + S(0.0777) * (t14 * t4 + t5 * t15)));
  M[1] = t17;
  M[2] = t17;
  M[0] = S(16.0) * (S(0.74) * ((S(0.03885) * t4 + t10) * t4 + (t11 + S(0.03885) * t5) * t5) + S(0.06836442)) - t16 + S(1.71);
  M[3] = S(2.2816666666666667) * t12 + S(0.0431132325);
}

// bias: 49 multiplications, 31 additions, 8 sin/cos/tan (reduced formulation; relative error 5.2e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // q1
  const S t0 = S(4.0) * q0;
  const S q1 = q[1];  // q2
  const S t1 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t10 = qd0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t11 = qd1 * (S(0.37) * qd1 + S(2.96) * qd0) + S(5.92) * t10;
  const S t12 = S(3.0833333333333335) * qd1 + S(4.0) * qd0;
  const S t2 = sine[0];
  const S t13 = S(9.81) - t2 * t10;
  const S t14 = S(0.0015143315356948754) * (t12 * t12);
  const S t3 = cosine[0];
  const S t15 = t3 * t10;
  const S t6 = cosine[2];
  const S t7 = sine[2];
  const S t16 = t6 * t13 + t7 * t15;
  const S t17 = t7 * t13 - t6 * t15;
  const S t4 = cosine[1];
  const S t18 = t4 * t11 - t17;
  const S t5 = sine[1];
  const S t19 = t11 * t5 - t16;
  const S f0 = in.wrenches[0];  // wrench(wheel).fx
  const S f1 = in.wrenches[1];  // wrench(wheel).fy
  const S t20 = f0 * t7 - f1 * t6;
  const S t21 = f0 * t6 + f1 * t7;
  const S t8 = sine[3];
  const S t22 = t14 * t8 + S(0.21) * t19;
  const S t9 = cosine[3];
  const S t23 = S(0.21) * t18 + t14 * t9;
  const S t24 = t8 * t18 - t19 * t9;
  const S t25 = S(0.37) * (t4 * t22 - t23 * t5);
  const S t26 = S(0.312) * t10 + t20 - t22;
  const S t27 = t23 + (S(0.48) * t10 + t21);
  const S f5 = in.wrenches[5];  // wrench(wheel).tz
  const S t28 = S(4.0) * (f5 + (S(0.013) * t21 - S(0.02) * t20) - (S(0.0195) * t17 + S(0.03) * t16) - (S(0.0015143315356948754) * t24 - t25));
  c[0] = (S(1.5) * t15 + (t7 * t26 + t6 * t27)) * t2 + t3 * (t6 * t26 - t7 * t27 + S(1.5) * t13) - t28;
  c[1] = S(0.004669188901725866) * t24 - t25;
}

// mass_matrix_and_bias: 77 multiplications, 53 additions, 8 sin/cos/tan (reduced formulation; relative error 5.2e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S t0 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S q0 = q[0];  // q1
  const S t1 = S(4.0) * q0;
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t10 = qd0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t11 = qd1 * (S(0.37) * qd1 + S(2.96) * qd0) + S(5.92) * t10;
  const S t12 = S(3.0833333333333335) * qd1 + S(4.0) * qd0;
  const S t2 = sine[0];
  const S t13 = S(9.81) - t2 * t10;
  const S t3 = cosine[0];
  const S t14 = t3 * t10;
  const S t15 = t12 * t12;
  const S t9 = sine[3];
  const S t8 = cosine[3];
  const S t16 = t9 * t13 - t8 * t14;
  const S t17 = t8 * t13 + t9 * t14;
  const S t4 = sine[1];
  const S t18 = t11 * t4 - t17;
  const S t5 = cosine[1];
  const S t19 = t5 * t11 - t16;
  const S t6 = sine[2];
  const S t20 = S(0.0015143315356948754) * t6;
  const S t21 = t15 * t20 + S(0.21) * t18;
  const S t7 = cosine[2];
  const S t22 = t6 * t19 - t18 * t7;
  const S t23 = S(0.0015143315356948754) * t7;
  const S t24 = S(0.21) * t19 + t23 * t15;
  const S f0 = in.wrenches[0];  // wrench(wheel).fx
  const S f1 = in.wrenches[1];  // wrench(wheel).fy
  const S t25 = f0 * t8 + f1 * t9;
  const S t26 = f0 * t9 - f1 * t8;
  const S t27 = S(0.312) * t10 + t26 - t21;
  const S t28 = t24 + (S(0.48) * t10 + t25);
  const S t29 = S(0.37) * (t24 * t4 - t5 * t21);
  const S t30 = t4 * t20 + t5 * t23;
  const S t31 = t2 * t8 - t9 * t3;
  const S t32 = t8 * t3 + t9 * t2;
  const S t33 = (S(1.5) * t13 - (t9 * t28 - t8 * t27)) * t3 + t2 * (S(1.5) * t14 + (t9 * t27 + t8 * t28));
  const S t34 = S(8.0) * (t31 * (S(0.0195) - (S(0.0777) * t4 + t20)) - t32 * (t23 + S(0.0777) * t5 + S(0.03)));
  M[0] = S(16.0) * (S(0.74) * ((S(0.03885) * t4 + t20) * t4 + (t23 + S(0.03885) * t5) * t5) + S(0.06836442)) - t34 + S(1.71);
  const S f5 = in.wrenches[5];  // wrench(wheel).tz
  c[0] = S(4.0) * (S(0.0015143315356948754) * t22 + t29 - (f5 + (S(0.013) * t25 - S(0.02) * t26) - (S(0.0195) * t16 + S(0.03) * t17))) + t33;
  c[1] = S(0.004669188901725866) * t22 + t29;
  const S t38 = S(0.37) * t30;
  const S t39 = S(4.0) * (t38 + S(0.028749)) + (S(12.333333333333334) * (t38 + S(0.00151092)) + (S(3.0833333333333335) * (t23 * t32 + t31 * t20) + S(0.0777) * (t31 * t4 + t5 * t32)));
  M[1] = t39;
  M[2] = t39;
  M[3] = S(2.2816666666666667) * t30 + S(0.0431132325);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q2)
  qdot[1] = qd1;
}

// energy: 42 multiplications, 24 additions, 8 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // q1
  const S t0 = S(4.0) * q0;
  const S q1 = q[1];  // q2
  const S t1 = S(3.0833333333333335) * q1;
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t2 = cosine[0];
  const S t10 = qd0 * t2;
  const S t3 = sine[0];
  const S t11 = qd0 * t3;
  const S qd1 = qd[1];  // d(q2)
  const S t12 = S(0.37) * qd1 + S(1.48) * qd0;
  const S t13 = S(3.0833333333333335) * qd1 + S(4.0) * qd0;
  const S t6 = sine[2];
  const S t7 = cosine[2];
  const S t14 = t6 * t10 - t11 * t7;
  const S t15 = t7 * t10 + t6 * t11;
  const S t4 = cosine[1];
  const S t16 = t15 + t4 * t12;
  const S t5 = sine[1];
  const S t17 = t14 - t12 * t5;
  const S t9 = sine[3];
  const S t8 = cosine[3];
  const S t18 = S(2.0601) * (S(0.004) * (t9 * t7 + t6 * t8) - S(0.006) * (t6 * t9 - t8 * t7) + t3 + S(0.37) * (t4 * t6 + t7 * t5));
  e[1] = S(14.715) * (t3 + (S(0.02) * t6 - S(0.013) * t7)) + t18;
  const S t20 = t9 * t16 + t17 * t8;
  const S t21 = t8 * t16 - t17 * t9;
  const S t22 = S(0.105) * (t21 * t21 + t20 * t20) - (S(0.00126) * t20 - S(0.00075546) * t13 - S(0.00084) * t21) * t13;
  e[0] = qd0 * (S(1.284828) * qd0 + (S(0.078) * t14 + S(0.12) * t15)) + t22;
}

// body_poses: 12 multiplications, 6 additions, 8 sin/cos/tan (reduced formulation; relative error 1.5e-15 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // q1
  const S t0 = S(4.0) * q0;
  const S q1 = q[1];  // q2
  const S t1 = S(3.0833333333333335) * q1;
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  W[3] = cosine[0];
  W[7] = sine[0];
  W[0] = cosine[2];
  W[5] = cosine[2];
  W[4] = sine[2];
  const S t7 = sine[2];
  W[1] = -t7;
  const S t4 = sine[1];
  const S t5 = cosine[1];
  const S t6 = cosine[2];
  const S t2 = cosine[0];
  W[15] = t2 - S(0.37) * (t7 * t4 - t5 * t6);
  const S t3 = sine[0];
  W[19] = t3 + S(0.37) * (t5 * t7 + t6 * t4);
  const S t8 = sine[3];
  const S t9 = cosine[3];
  const S t13 = t8 * t6 + t7 * t9;
  W[16] = t13;
  const S t14 = t9 * t6 - t7 * t8;
  W[12] = t14;
  W[17] = t14;
  W[13] = -t13;
  W[2] = S(0.0);
  W[6] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[14] = S(0.0);
  W[18] = S(0.0);
  W[20] = S(0.0);
  W[21] = S(0.0);
  W[23] = S(0.0);
  W[10] = S(1.0);
  W[22] = S(1.0);
}

}  // namespace alembert::mechanisms::rolling_wheels

// moving_base: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "moving_base". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "moving_base_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::moving_base {

// inverse_dynamics: 67 multiplications, 46 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qdd0 = qdd[0];  // dd(q1)
  const S qdd1 = qdd[1];  // dd(q2)
  const S time = in.t;  // t
  const S t0 = sin(q0);
  const S t1 = cos(q0);
  const S t2 = time * (S(0.1) * time + S(0.4));
  const S t3 = cos(t2);
  const S t4 = sin(t2);
  const S t5 = sin(S(3.4) * time);
  const S t6 = t3 * t5;
  const S t7 = cos(S(6.8) * time);
  const S t8 = S(9.81) - S(2.312) * t7;
  const S t9 = S(2.4276) * (t0 * t6) - t1 * t8;
  const S t10 = S(0.2) * time + S(0.4);
  const S t11 = t1 * t10;
  const S t12 = t0 * t10;
  const S t13 = t11 * t12;
  const S t14 = qdd0 - t13;
  const S t15 = t12 * t12;
  const S t16 = cos(q1);
  const S t17 = sin(q1);
  const S t18 = S(2.4276) * (t6 * t1) + t0 * t8 + S(0.5) * t14;
  const S t19 = S(0.2) * t1 - t12 * qd0;
  const S t20 = t11 * t16 - qd0 * t17;
  const S t21 = qd1 - (t12 - qd1);
  const S t22 = qdd0 * t16 + (t17 * t19 + t20 * t21);
  const S t23 = t16 * qd0 + t11 * t17;
  const S t24 = qdd0 * t17 - (t16 * t19 - t21 * t23);
  const S t25 = S(0.5) * (S(0.105) * t22 - S(0.01) * t24 + S(0.9159999999999999) * t18);
  const S t26 = t16 * (S(0.105) * t18 + (S(0.032350000000000004) * t22 - S(0.0018) * t24)) + t17 * (S(0.000899999999999998) * t24 - S(0.0018) * t22 - S(0.01) * t18) + t25;
  tau[0] = S(0.007999999999999981) * t9 + (S(0.0018799999999999997) * (qdd0 + t13) - (S(0.03151999999999999) * t14 + (S(0.0020799999999999924) * (t15 - t11 * t11) + S(8.000000000000003e-05) * t0))) + t26;
  const S t28 = t11 * qd0;
  const S t29 = t28 + S(0.2) * t0;
  const S t30 = S(0.5) * (t28 + t29) - S(2.4276) * (t5 * t4);
  const S t31 = t9 - S(0.5) * (t15 + qd0 * qd0);
  const S t32 = t29 - qdd1;
  const S t33 = t20 * t23;
  const S t34 = S(0.032350000000000004) * (t32 + t33) - S(0.0018) * (t23 * t23 - t20 * t20) + S(0.000899999999999998) * (t32 - t33);
  tau[1] = S(0.01) * (t17 * t30 - t16 * t31) - S(0.105) * (t16 * t30 + t17 * t31) - t34;
}

// mass_matrix: 4 multiplications, 4 additions, 2 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  M[0] = S(0.105) * t0 - t1 * (S(0.031450000000000006) * t1 + S(0.0036) * t0 + S(0.01)) + S(0.23170999999999997);
  M[1] = S(0.0);
  M[2] = S(0.0);
  M[3] = S(0.03325);
}

// bias: 64 multiplications, 40 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S time = in.t;  // t
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = sin(q0);
  const S t3 = cos(q0);
  const S t4 = S(0.2) * time + S(0.4);
  const S t5 = t2 * t4;
  const S t6 = t4 * t3;
  const S t7 = t5 * t6;
  const S t8 = time * (S(0.1) * time + S(0.4));
  const S t9 = cos(t8);
  const S t10 = sin(t8);
  const S t11 = sin(S(3.4) * time);
  const S t12 = t9 * t11;
  const S t13 = cos(S(6.8) * time);
  const S t14 = S(9.81) - S(2.312) * t13;
  const S t15 = S(0.5) * t7 - (S(2.4276) * (t3 * t12) + t2 * t14);
  const S t16 = S(0.2) * t3 - t5 * qd0;
  const S t17 = t6 * t1 - t0 * qd0;
  const S t18 = qd1 - (t5 - qd1);
  const S t19 = t0 * t16 + t17 * t18;
  const S t20 = t1 * qd0 + t6 * t0;
  const S t21 = t1 * t16 - t18 * t20;
  const S t22 = S(0.5) * (S(0.9159999999999999) * t15 - (S(0.01) * t21 + S(0.105) * t19));
  const S t23 = t5 * t5;
  const S t24 = S(2.4276) * (t2 * t12) - t3 * t14;
  const S t25 = S(0.0020799999999999924) * (t23 - t6 * t6) + S(8.000000000000003e-05) * t2 - S(0.03339999999999999) * t7 - S(0.007999999999999981) * t24;
  c[0] = t0 * (S(0.01) * t15 - (S(0.0018) * t19 + S(0.000899999999999998) * t21)) - t1 * (S(0.105) * t15 - (S(0.0018) * t21 + S(0.032350000000000004) * t19)) - t22 - t25;
  const S t27 = t6 * qd0;
  const S t28 = t27 + S(0.2) * t2;
  const S t29 = S(0.5) * (t27 + t28) - S(2.4276) * (t11 * t10);
  const S t30 = t24 - S(0.5) * (t23 + qd0 * qd0);
  const S t31 = t17 * t20;
  const S t32 = S(0.032350000000000004) * (t28 + t31) - S(0.0018) * (t20 * t20 - t17 * t17) + S(0.000899999999999998) * (t28 - t31);
  c[1] = S(0.01) * (t0 * t29 - t1 * t30) - S(0.105) * (t1 * t29 + t0 * t30) - t32;
}

// mass_matrix_and_bias: 68 multiplications, 44 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S time = in.t;  // t
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  M[0] = S(0.105) * t0 - t1 * (S(0.031450000000000006) * t1 + S(0.0036) * t0 + S(0.01)) + S(0.23170999999999997);
  const S t3 = sin(q0);
  const S t4 = cos(q0);
  const S t5 = S(0.2) * time + S(0.4);
  const S t6 = t3 * t5;
  const S t7 = t5 * t4;
  const S t8 = t6 * t7;
  const S t9 = time * (S(0.1) * time + S(0.4));
  const S t10 = cos(t9);
  const S t11 = sin(t9);
  const S t12 = sin(S(3.4) * time);
  const S t13 = t10 * t12;
  const S t14 = cos(S(6.8) * time);
  const S t15 = S(9.81) - S(2.312) * t14;
  const S t16 = S(0.5) * t8 - (S(2.4276) * (t4 * t13) + t3 * t15);
  const S t17 = S(0.2) * t4 - t6 * qd0;
  const S t18 = t0 * t7 - t1 * qd0;
  const S t19 = qd1 - (t6 - qd1);
  const S t20 = t1 * t17 + t18 * t19;
  const S t21 = t0 * qd0 + t1 * t7;
  const S t22 = t0 * t17 - t19 * t21;
  const S t23 = S(0.5) * (S(0.9159999999999999) * t16 - (S(0.01) * t22 + S(0.105) * t20));
  const S t24 = t6 * t6;
  const S t25 = S(2.4276) * (t3 * t13) - t4 * t15;
  const S t26 = S(0.0020799999999999924) * (t24 - t7 * t7) + S(8.000000000000003e-05) * t3 - S(0.03339999999999999) * t8 - S(0.007999999999999981) * t25;
  c[0] = t1 * (S(0.01) * t16 - (S(0.0018) * t20 + S(0.000899999999999998) * t22)) - t0 * (S(0.105) * t16 - (S(0.0018) * t22 + S(0.032350000000000004) * t20)) - t23 - t26;
  const S t28 = t7 * qd0;
  const S t29 = t28 + S(0.2) * t3;
  const S t30 = S(0.5) * (t28 + t29) - S(2.4276) * (t12 * t11);
  const S t31 = t25 - S(0.5) * (t24 + qd0 * qd0);
  const S t32 = t18 * t21;
  const S t33 = S(0.032350000000000004) * (t29 + t32) - S(0.0018) * (t21 * t21 - t18 * t18) + S(0.000899999999999998) * (t29 - t32);
  c[1] = S(0.01) * (t1 * t30 - t0 * t31) - S(0.105) * (t0 * t30 + t1 * t31) - t33;
  M[1] = S(0.0);
  M[2] = S(0.0);
  M[3] = S(0.03325);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  qdot[0] = qd0;
  qdot[1] = qd1;
}

// energy: 77 multiplications, 42 additions, 9 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S time = in.t;  // t
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = cos(S(3.4) * time);
  const S t3 = time * (S(0.1) * time + S(0.4));
  const S t4 = sin(t3);
  const S t5 = cos(t3);
  const S t6 = t2 * t4;
  const S t7 = S(0.2) * time + S(0.4);
  const S t8 = sin(q0);
  const S t9 = cos(q0);
  const S t10 = t7 * t8;
  const S t11 = S(0.714) * t6 + S(0.5) * t10;
  const S t12 = t2 * t5;
  const S t13 = S(6.8) * time;
  const S t14 = sin(t13);
  const S t15 = cos(t13);
  const S t16 = S(0.714) * (t8 * t12) - S(0.34) * (t9 * t14);
  const S t17 = t0 * t11 + t1 * t16;
  const S t18 = S(0.34) * (t8 * t14) + S(0.714) * (t9 * t12);
  const S t19 = t18 - S(0.5) * qd0;
  const S t20 = t1 * t11 - t0 * t16;
  const S t21 = t9 * t7;
  const S t22 = t1 * qd0 + t21 * t0;
  const S t23 = t1 * t21 - qd0 * t0;
  const S t24 = qd1 - t10;
  const S t25 = t10 * (S(0.00208) * t21 - (S(0.07308) * t10 - S(0.0004) * qd0)) + qd0 * (S(0.0004) * t10 - S(0.07416) * qd0) + t21 * (S(0.00208) * t10 - S(0.00228) * t21);
  const S t26 = qd0 * (S(0.008) * t16 + S(0.208) * t18);
  const S t27 = S(0.5) * (t22 * (S(0.0018) * t23 + S(0.03255) * t22) + S(0.03325) * (t24 * t24) + t23 * (S(0.0011) * t23 + S(0.0018) * t22) - t25) - t26;
  const S t28 = t24 * (S(0.105) * t20 - S(0.01) * t17);
  const S t29 = S(0.4) * (t18 * t18 + S(0.509796) * (t6 * t6) + t16 * t16) + (S(0.714) * (t6 * (S(0.208) * t10 - S(0.008) * t21)) + t27) - t28;
  e[0] = S(0.25) * (t17 * t17 + (t19 * t19 + t20 * t20)) - (t19 * (S(0.105) * t22 + S(0.01) * t23) - t29);
  const S t31 = S(0.05) * t15;
  e[1] = S(4.905) * (t31 - t9 * (S(0.5) - (S(0.02) * t0 - S(0.21) * t1))) + S(7.848) * (t31 - (S(0.01) * t8 + S(0.26) * t9));
}

// body_poses: 23 multiplications, 7 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S time = in.t;  // t
  const S t0 = time * (S(0.1) * time + S(0.4));
  const S t1 = cos(t0);
  W[0] = t1;
  W[5] = t1;
  W[17] = t1;
  const S t2 = sin(t0);
  W[4] = t2;
  const S t3 = -t2;
  W[1] = t3;
  W[13] = t3;
  const S t4 = sin(S(3.4) * time);
  const S t5 = S(0.21) * t4;
  W[3] = t5;
  W[15] = t5;
  const S t6 = cos(S(6.8) * time);
  const S t7 = S(0.05) * t6;
  W[11] = t7;
  W[23] = t7;
  const S t8 = cos(q0);
  W[22] = t8;
  const S t9 = sin(q0);
  const S t10 = t1 * t8;
  W[12] = t10;
  W[24] = t10;
  const S t11 = t1 * t9;
  W[14] = t11;
  const S t12 = t2 * t8;
  W[16] = t12;
  W[28] = t12;
  const S t13 = t2 * t9;
  W[18] = t13;
  const S t14 = -t9;
  W[20] = t14;
  W[32] = t14;
  const S t15 = sin(q1);
  const S t16 = cos(q1);
  W[25] = t11 * t15 - t2 * t16;
  W[26] = t2 * t15 + t11 * t16;
  W[27] = t5 - S(0.5) * t11;
  W[29] = t1 * t16 + t13 * t15;
  W[30] = t13 * t16 - t1 * t15;
  W[31] = S(-0.5) * t13;
  W[33] = t8 * t15;
  W[34] = t8 * t16;
  W[35] = t7 - S(0.5) * t8;
  W[2] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[19] = S(0.0);
  W[21] = S(0.0);
  W[10] = S(1.0);
}

}  // namespace alembert::mechanisms::moving_base

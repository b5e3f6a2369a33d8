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

// inverse_dynamics: 59 multiplications, 39 additions, 8 sin/cos/tan (reduced formulation; relative error 3.9e-15 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S t0 = q1 + S(0.09495170634275632);
  const S time = in.t;  // t
  const S t1 = time * (S(0.1) * time + S(0.4));
  const S q0 = q[0];  // q1
  const S angle[] = {q0, t0, t1};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t6 = cos(S(6.8) * time);
  const S t9 = sin(S(3.4) * time);
  const S t10 = S(0.2) * time + S(0.4);
  const S t3 = sine[0];
  const S t11 = t3 * t10;
  const S t2 = cosine[0];
  const S t12 = t2 * t10;
  const S qd0 = qd[0];  // d(q1)
  const S t13 = S(0.2) * t2 - qd0 * t11;
  const S qd1 = qd[1];  // d(q2)
  const S t14 = qd1 + (qd1 - t11);
  const S t5 = sine[1];
  const S t4 = cosine[1];
  const S t15 = qd0 * t5 - t12 * t4;
  const S t16 = qd0 * t4 + t5 * t12;
  const S t17 = t12 * t11;
  const S t18 = t11 * t11;
  const S t19 = S(9.81) - S(2.312) * t6;
  const S t20 = S(2.4276) * t9;
  const S t7 = cosine[2];
  const S t21 = t7 * t20;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t22 = qdd0 * t4 + (t5 * t13 - t14 * t15);
  const S t23 = t13 * t4 - (qdd0 * t5 + t16 * t14);
  const S t24 = qd0 * t12;
  const S t25 = t24 + S(0.2) * t3;
  const S t26 = t3 * t19 + t21 * t2;
  const S t27 = t3 * t21 - t2 * t19;
  const S t28 = S(0.052737557774322465) * t22 + (t4 * (S(0.10547511554864493) * (t26 + S(0.5) * (qdd0 - t17)) - (S(0.0012006741573033707) * t23 - S(0.03240707865168539) * t22)) - t5 * (S(0.0008429213483146097) * t23 - S(0.0012006741573033707) * t22));
  tau[0] = t28 + (S(0.458) * t26 + S(0.008) * t27 - (S(0.1956) * t17 - (S(0.19936) * qdd0 - (S(0.00208) * (t18 - t12 * t12) + S(8e-05) * t3))));
  const S t8 = sine[2];
  const S t30 = S(0.10547511554864493) * ((t8 * t20 - S(0.5) * (t24 + t25)) * t4 + t5 * (S(0.5) * (t18 + qd0 * qd0) - t27));
  const S qdd1 = qdd[1];  // dd(q2)
  tau[1] = S(0.03156415730337078) * t16 * t15 - (S(0.0012006741573033707) * (t16 * t16 - t15 * t15) - S(0.03325) * (qdd1 - t25)) + t30;
}

// mass_matrix: 4 multiplications, 3 additions, 2 sin/cos/tan (reduced formulation; relative error 6e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S t0 = q1 + S(0.09495170634275632);
  const S t1 = cos(t0);
  const S t2 = sin(t0);
  M[0] = S(0.10547511554864493) * t1 - t2 * (S(0.03156415730337078) * t2 - S(0.0024013483146067415) * t1) + S(0.2317670786516854);
  M[1] = S(0.0);
  M[2] = S(0.0);
  M[3] = S(0.03325);
}

// bias: 56 multiplications, 34 additions, 8 sin/cos/tan (reduced formulation; relative error 4.1e-15 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S t0 = q1 + S(0.09495170634275632);
  const S time = in.t;  // t
  const S t1 = time * (S(0.1) * time + S(0.4));
  const S q0 = q[0];  // q1
  const S angle[] = {q0, t0, t1};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t6 = cos(S(6.8) * time);
  const S t9 = sin(S(3.4) * time);
  const S t10 = S(0.2) * time + S(0.4);
  const S t3 = sine[0];
  const S t11 = t3 * t10;
  const S t2 = cosine[0];
  const S t12 = t2 * t10;
  const S qd0 = qd[0];  // d(q1)
  const S t13 = S(0.2) * t2 - qd0 * t11;
  const S qd1 = qd[1];  // d(q2)
  const S t14 = qd1 + (qd1 - t11);
  const S t15 = S(9.81) - S(2.312) * t6;
  const S t16 = S(2.4276) * t9;
  const S t4 = sine[1];
  const S t5 = cosine[1];
  const S t17 = qd0 * t4 - t12 * t5;
  const S t18 = qd0 * t5 + t4 * t12;
  const S t7 = cosine[2];
  const S t19 = t7 * t16;
  const S t20 = t3 * t15 + t19 * t2;
  const S t21 = t3 * t19 - t2 * t15;
  const S t22 = t4 * t13 - t14 * t17;
  const S t23 = t13 * t5 - t18 * t14;
  const S t24 = t12 * t11;
  const S t25 = t11 * t11;
  const S t26 = qd0 * t12;
  const S t27 = t26 + S(0.2) * t3;
  const S t28 = S(0.1956) * t24 + (S(0.00208) * (t25 - t12 * t12) + S(8e-05) * t3) - (S(0.458) * t20 + S(0.008) * t21);
  c[0] = S(0.052737557774322465) * t22 + ((S(0.10547511554864493) * (t20 - S(0.5) * t24) + (S(0.03240707865168539) * t22 - S(0.0012006741573033707) * t23)) * t5 - t4 * (S(0.0008429213483146097) * t23 - S(0.0012006741573033707) * t22)) - t28;
  const S t30 = S(0.03156415730337078) * t18 * t17 - (S(0.0012006741573033707) * (t18 * t18 - t17 * t17) + S(0.03325) * t27);
  const S t8 = sine[2];
  c[1] = S(0.10547511554864493) * ((t8 * t16 - S(0.5) * (t26 + t27)) * t5 + t4 * (S(0.5) * (t25 + qd0 * qd0) - t21)) + t30;
}

// mass_matrix_and_bias: 60 multiplications, 37 additions, 8 sin/cos/tan (reduced formulation; relative error 4.1e-15 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S t0 = q1 + S(0.09495170634275632);
  const S time = in.t;  // t
  const S t1 = time * (S(0.1) * time + S(0.4));
  const S q0 = q[0];  // q1
  const S angle[] = {q0, t0, t1};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t6 = cos(S(6.8) * time);
  const S t9 = sin(S(3.4) * time);
  const S t10 = S(0.2) * time + S(0.4);
  const S t3 = sine[0];
  const S t11 = t3 * t10;
  const S t2 = cosine[0];
  const S t12 = t2 * t10;
  const S qd0 = qd[0];  // d(q1)
  const S t13 = S(0.2) * t2 - qd0 * t11;
  const S qd1 = qd[1];  // d(q2)
  const S t14 = qd1 + (qd1 - t11);
  const S t15 = S(9.81) - S(2.312) * t6;
  const S t16 = S(2.4276) * t9;
  const S t5 = sine[1];
  const S t4 = cosine[1];
  const S t17 = qd0 * t5 - t12 * t4;
  const S t18 = qd0 * t4 + t5 * t12;
  const S t7 = cosine[2];
  const S t19 = t7 * t16;
  const S t20 = t3 * t15 + t19 * t2;
  const S t21 = t3 * t19 - t2 * t15;
  const S t22 = t5 * t13 - t14 * t17;
  const S t23 = t13 * t4 - t18 * t14;
  const S t24 = t12 * t11;
  const S t25 = t11 * t11;
  const S t26 = qd0 * t12;
  const S t27 = t26 + S(0.2) * t3;
  const S t28 = S(0.1956) * t24 + (S(0.00208) * (t25 - t12 * t12) + S(8e-05) * t3) - (S(0.458) * t20 + S(0.008) * t21);
  c[0] = S(0.052737557774322465) * t22 + ((S(0.10547511554864493) * (t20 - S(0.5) * t24) + (S(0.03240707865168539) * t22 - S(0.0012006741573033707) * t23)) * t4 - t5 * (S(0.0008429213483146097) * t23 - S(0.0012006741573033707) * t22)) - t28;
  const S t8 = sine[2];
  const S t30 = S(0.10547511554864493) * ((t8 * t16 - S(0.5) * (t26 + t27)) * t4 + t5 * (S(0.5) * (t25 + qd0 * qd0) - t21));
  c[1] = S(0.03156415730337078) * (t18 * t17) - (S(0.0012006741573033707) * (t18 * t18 - t17 * t17) + S(0.03325) * t27) + t30;
  M[0] = S(0.10547511554864493) * t4 - t5 * (S(0.03156415730337078) * t5 - S(0.0024013483146067415) * t4) + S(0.2317670786516854);
  M[3] = S(0.03325);
  M[1] = S(0.0);
  M[2] = S(0.0);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q2)
  qdot[1] = qd1;
}

// energy: 74 multiplications, 42 additions, 9 sin/cos/tan (reduced formulation; relative error 1.8e-15 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using detail::sines_and_cosines;
  const S time = in.t;  // t
  const S t0 = time * (S(0.1) * time + S(0.4));
  const S t1 = S(6.8) * time;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S angle[] = {q0, q1, t0, t1};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S t6 = cos(S(3.4) * time);
  const S t11 = S(0.2) * time + S(0.4);
  const S t2 = cosine[0];
  const S t12 = t2 * t11;
  const S t3 = sine[0];
  const S t13 = t3 * t11;
  const S qd0 = qd[0];  // d(q1)
  const S t14 = t13 * (S(0.00208) * t12 - (S(0.07308) * t13 - S(0.0004) * qd0)) + qd0 * (S(0.0004) * t13 - S(0.07416) * qd0) + (S(0.00208) * t13 - S(0.00228) * t12) * t12;
  const S t4 = cosine[1];
  const S t5 = sine[1];
  const S t15 = qd0 * t4 + t12 * t5;
  const S t16 = t4 * t12 - qd0 * t5;
  const S qd1 = qd[1];  // d(q2)
  const S t17 = qd1 - t13;
  const S t7 = cosine[2];
  const S t18 = S(0.714) * (t6 * t7);
  const S t8 = sine[2];
  const S t19 = t6 * t8;
  const S t9 = sine[3];
  const S t20 = S(0.34) * t9;
  const S t21 = t18 * t2 + t3 * t20;
  const S t22 = t18 * t3 - t2 * t20;
  const S t23 = S(0.714) * t19;
  const S t24 = t23 + S(0.5) * t13;
  const S t25 = qd0 * (S(0.008) * t22 + S(0.208) * t21);
  const S t26 = S(0.5) * (t14 - ((S(0.0018) * t16 + S(0.03255) * t15) * t15 + S(0.03325) * (t17 * t17) + t16 * (S(0.0011) * t16 + S(0.0018) * t15))) + t25;
  const S t27 = S(0.5) * qd0 - t21;
  const S t28 = t22 * t5 - t4 * t24;
  const S t29 = t4 * t22 + t24 * t5;
  const S t30 = t17 * (S(0.105) * t28 + S(0.01) * t29);
  const S t31 = S(0.4) * (t22 * t22 + (S(0.509796) * t19 * t19 + t21 * t21)) + (t23 * (S(0.208) * t13 - S(0.008) * t12) - t26) + t30;
  e[0] = t27 * (S(0.105) * t15 + S(0.01) * t16) + t31 + S(0.25) * (t29 * t29 + (t28 * t28 + t27 * t27));
  const S t10 = cosine[3];
  const S t33 = S(0.05) * t10;
  e[1] = S(4.905) * (t33 - t2 * (S(0.5) - (S(0.02) * t5 - S(0.21) * t4))) - S(7.848) * (S(0.01) * t3 + S(0.26) * t2 - t33);
}

// body_poses: 23 multiplications, 7 additions, 8 sin/cos/tan (reduced formulation; relative error 7.7e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  const S time = in.t;  // t
  const S t0 = time * (S(0.1) * time + S(0.4));
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S angle[] = {q0, q1, t0};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  W[22] = cosine[0];
  W[0] = cosine[2];
  W[5] = cosine[2];
  W[17] = cosine[2];
  W[4] = sine[2];
  const S t7 = sin(S(3.4) * time);
  const S t8 = cos(S(6.8) * time);
  const S t2 = sine[0];
  const S t5 = cosine[2];
  const S t9 = t2 * t5;
  W[14] = t9;
  const S t6 = sine[2];
  const S t10 = t6 * t2;
  W[18] = t10;
  const S t11 = -t2;
  W[20] = t11;
  W[32] = t11;
  const S t12 = -t6;
  W[1] = t12;
  W[13] = t12;
  W[31] = S(-0.5) * t10;
  const S t14 = S(0.21) * t7;
  W[3] = t14;
  W[15] = t14;
  W[27] = t14 - S(0.5) * t9;
  const S t16 = S(0.05) * t8;
  W[11] = t16;
  W[23] = t16;
  const S t1 = cosine[0];
  W[35] = t16 - S(0.5) * t1;
  const S t18 = t1 * t5;
  W[12] = t18;
  W[24] = t18;
  const S t19 = t6 * t1;
  W[16] = t19;
  W[28] = t19;
  const S t4 = sine[1];
  const S t3 = cosine[1];
  W[25] = t9 * t4 - t3 * t6;
  W[26] = t3 * t9 + t6 * t4;
  W[29] = t4 * t10 + t3 * t5;
  W[30] = t3 * t10 - t4 * t5;
  W[33] = t1 * t4;
  W[34] = t3 * t1;
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

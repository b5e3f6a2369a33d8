// body_on_torus: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "body_on_torus". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "body_on_torus_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::body_on_torus {

// inverse_dynamics: 63 multiplications, 48 additions, 4 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // spin
  const S t0 = q2 + S(1.1071487177940904);
  const S q1 = q[1];  // v
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S qd0 = qd[0];  // d(u)
  const S t2 = sine[0];
  const S t5 = qd0 * t2;
  const S t1 = cosine[0];
  const S t6 = qd0 * t1;
  const S qd1 = qd[1];  // d(v)
  const S t7 = qd1 * t5;
  const S qdd0 = qdd[0];  // dd(u)
  const S t8 = t7 - qdd0 * t1;
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t9 = qd1 * t3 - t6 * t4;
  const S t10 = t3 * t6 + qd1 * t4;
  const S qdd2 = qdd[2];  // dd(spin)
  const S t11 = qdd2 + (qdd0 * t2 + qd1 * t6);
  const S t12 = S(1.1) * (qd0 * qd0);
  const S qdd1 = qdd[1];  // dd(v)
  const S qd2 = qd[2];  // d(spin)
  const S t13 = qdd1 * t4 - t8 * t3 + qd2 * t9;
  const S t14 = qd2 * t10 - (qdd1 * t3 + t8 * t4);
  const S t15 = qd2 + t5;
  const S t16 = t15 * t9;
  const S t17 = t9 * t10;
  const S t18 = t9 * t9;
  const S t19 = t15 * t10;
  const S t20 = t15 * t15;
  const S t21 = t10 * t10;
  const S t22 = t11 - t17;
  const S t23 = t11 + t17;
  const S t24 = t16 + t13;
  const S t25 = S(4.4721359549995795e-05) * (t14 - t19) + S(0.007200138887549323) * (t16 - t13) - S(0.00016) * (t18 - t21) - S(0.00157) * t23 - S(0.00048) * t22;
  const S t26 = t14 + t19;
  const S t27 = S(0.01565247584249853) * (S(9.81) * t2 - t1 * t12) + (S(0.007200138887549323) * (t20 - t21) + (S(4.4721359549995795e-05) * t22 - S(0.00016) * t24) - S(0.00157) * t26);
  const S t28 = S(0.00048) * t24 + (S(0.00016) * t26 + S(0.007200138887549323) * t23 - S(4.4721359549995795e-05) * (t20 - t18));
  const S t29 = S(9.81) * t1 + t12 * t2;
  const S t30 = S(0.01565247584249853) * (t29 * t4 + S(1.1) * (qdd0 * t3)) - t25;
  tau[2] = t30;
  tau[1] = t28 * t4 + t27 * t3 + (S(0.308) * t29 + S(0.13712) * (qdd1 + t5 * t6));
  const S t32 = t8 + t7;
  const S t33 = S(1.1) * (S(0.01565247584249853) * ((t20 + t18) * t4 - t23 * t3) + S(0.308) * t32 - S(0.77) * qdd0);
  tau[0] = t1 * (t3 * t28 - t27 * t4 - (S(0.13712) * t32 - S(0.3388) * qdd0)) + t2 * t30 - t33;
}

// mass_matrix: 20 multiplications, 14 additions, 4 sin/cos/tan (reduced formulation; relative error 5.4e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // spin
  const S t0 = q2 + S(1.1071487177940904);
  const S q1 = q[1];  // v
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t4 = cosine[1];
  const S t3 = sine[1];
  const S t5 = S(0.00032) * t4 + S(0.00109) * t3;
  const S t6 = S(4.4721359549995795e-05) * t3 - S(0.007200138887549323) * t4;
  const S t7 = t5 * t3;
  const S t8 = S(4.4721359549995795e-05) * t4 + S(0.007200138887549323) * t3;
  M[5] = t8;
  M[7] = t8;
  const S t2 = cosine[0];
  const S t1 = sine[0];
  const S t9 = t2 * (S(0.00016) - t4 * t5) + t1 * t8;
  M[1] = t9;
  M[3] = t9;
  const S t10 = t1 * t6;
  M[0] = S(0.84905) - ((t10 + t10 - t2 * (t7 + S(0.13555))) * t2 - S(2.2) * (t1 * (S(0.01565247584249853) * t4) + S(0.308) * t2));
  const S t12 = S(0.017217723426748384) * t4 - (t2 * t6 - S(0.00205) * t1);
  M[2] = t12;
  M[6] = t12;
  M[4] = S(0.13869) - t7;
  M[8] = S(0.00205);
}

// bias: 55 multiplications, 38 additions, 4 sin/cos/tan (reduced formulation; relative error 1.9e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // spin
  const S t0 = q2 + S(1.1071487177940904);
  const S q1 = q[1];  // v
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S qd0 = qd[0];  // d(u)
  const S t1 = cosine[0];
  const S t5 = qd0 * t1;
  const S t2 = sine[0];
  const S t6 = qd0 * t2;
  const S qd1 = qd[1];  // d(v)
  const S t7 = qd1 * t6;
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t8 = qd1 * t3 - t5 * t4;
  const S t9 = t3 * t5 + qd1 * t4;
  const S t10 = qd1 * t5;
  const S t11 = S(1.1) * (qd0 * qd0);
  const S qd2 = qd[2];  // d(spin)
  const S t12 = t3 * t7 - qd2 * t8;
  const S t13 = qd2 + t6;
  const S t14 = qd2 * t9 - t7 * t4;
  const S t15 = t8 * t9;
  const S t16 = t13 * t8;
  const S t17 = t8 * t8;
  const S t18 = t16 - t12;
  const S t19 = t13 * t13;
  const S t20 = t13 * t9;
  const S t21 = t9 * t9;
  const S t22 = t15 - t10;
  const S t23 = t15 + t10;
  const S t24 = t14 + t20;
  const S t25 = S(0.00048) * t18 + (S(0.00016) * t24 + S(0.007200138887549323) * t23 - S(4.4721359549995795e-05) * (t19 - t17));
  const S t26 = S(4.4721359549995795e-05) * t22 + S(0.00016) * t18 - S(0.007200138887549323) * (t19 - t21) + S(0.00157) * t24 - S(0.01565247584249853) * (S(9.81) * t2 - t1 * t11);
  const S t27 = S(9.81) * t1 + t11 * t2;
  const S t28 = S(0.00048) * t22 + (S(0.007200138887549323) * (t16 + t12) + S(4.4721359549995795e-05) * (t14 - t20) - S(0.00016) * (t17 - t21) - S(0.00157) * t23) - S(0.01565247584249853) * (t27 * t4);
  const S t29 = S(1.1) * (S(0.616) * t7 + S(0.01565247584249853) * ((t19 + t17) * t4 - t23 * t3));
  c[0] = t1 * (t26 * t4 + t3 * t25 - S(0.27424) * t7) - t2 * t28 - t29;
  c[1] = t6 * (S(0.13712) * t5) + S(0.308) * t27 - (t26 * t3 - t25 * t4);
  c[2] = -t28;
}

// mass_matrix_and_bias: 75 multiplications, 52 additions, 4 sin/cos/tan (reduced formulation; relative error 5.4e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // spin
  const S t0 = q2 + S(1.1071487177940904);
  const S q1 = q[1];  // v
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S qd0 = qd[0];  // d(u)
  const S t2 = cosine[0];
  const S t5 = qd0 * t2;
  const S t1 = sine[0];
  const S t6 = qd0 * t1;
  const S qd1 = qd[1];  // d(v)
  const S t7 = qd1 * t6;
  const S t4 = cosine[1];
  const S t3 = sine[1];
  const S t8 = qd1 * t4 - t5 * t3;
  const S t9 = t4 * t5 + qd1 * t3;
  const S t10 = qd1 * t5;
  const S t11 = S(1.1) * (qd0 * qd0);
  const S qd2 = qd[2];  // d(spin)
  const S t12 = t4 * t7 - qd2 * t8;
  const S t13 = qd2 + t6;
  const S t14 = qd2 * t9 - t7 * t3;
  const S t15 = t8 * t9;
  const S t16 = t13 * t8;
  const S t17 = t8 * t8;
  const S t18 = t16 - t12;
  const S t19 = t13 * t13;
  const S t20 = t13 * t9;
  const S t21 = t9 * t9;
  const S t22 = t15 - t10;
  const S t23 = t15 + t10;
  const S t24 = t14 + t20;
  const S t25 = S(0.00048) * t18 + (S(0.00016) * t24 + S(0.007200138887549323) * t23 - S(4.4721359549995795e-05) * (t19 - t17));
  const S t26 = S(4.4721359549995795e-05) * t22 + S(0.00016) * t18 - S(0.007200138887549323) * (t19 - t21) + S(0.00157) * t24 - S(0.01565247584249853) * (S(9.81) * t1 - t2 * t11);
  const S t27 = S(9.81) * t2 + t11 * t1;
  const S t28 = S(0.00048) * t22 + (S(0.007200138887549323) * (t16 + t12) + S(4.4721359549995795e-05) * (t14 - t20) - S(0.00016) * (t17 - t21) - S(0.00157) * t23) - S(0.01565247584249853) * t27 * t3;
  const S t29 = S(1.1) * (S(0.616) * t7 + S(0.01565247584249853) * ((t19 + t17) * t3 - t23 * t4));
  c[0] = t2 * (t26 * t3 + t4 * t25 - S(0.27424) * t7) - t1 * t28 - t29;
  const S t31 = S(0.00032) * t4 + S(0.00109) * t3;
  const S t32 = S(4.4721359549995795e-05) * t3 - S(0.007200138887549323) * t4;
  c[1] = t6 * (S(0.13712) * t5) + S(0.308) * t27 - (t26 * t4 - t25 * t3);
  const S t34 = t31 * t3;
  const S t35 = t1 * t32;
  M[0] = S(0.84905) - ((t35 + t35 - t2 * (t34 + S(0.13555))) * t2 - S(2.2) * (t1 * (S(0.01565247584249853) * t4) + S(0.308) * t2));
  const S t37 = S(4.4721359549995795e-05) * t4 + S(0.007200138887549323) * t3;
  M[5] = t37;
  M[7] = t37;
  const S t38 = t2 * (S(0.00016) - t4 * t31) + t1 * t37;
  M[1] = t38;
  M[3] = t38;
  const S t39 = S(0.017217723426748384) * t4 - (t2 * t32 - S(0.00205) * t1);
  M[2] = t39;
  M[6] = t39;
  M[4] = S(0.13869) - t34;
  c[2] = -t28;
  M[8] = S(0.00205);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(u)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(v)
  qdot[1] = qd1;
  const S qd2 = qd[2];  // d(spin)
  qdot[2] = qd2;
}

// energy: 36 multiplications, 22 additions, 4 sin/cos/tan (reduced formulation; relative error 6e-15 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(u)
  const S t0 = cosine[0];
  const S t4 = qd0 * t0;
  const S t1 = sine[0];
  const S qd2 = qd[2];  // d(spin)
  const S t5 = qd2 + qd0 * t1;
  const S t6 = qd0 - t4;
  const S qd1 = qd[1];  // d(v)
  const S t3 = cosine[1];
  const S t7 = qd1 * t3;
  const S t2 = sine[1];
  const S t8 = qd1 * t2;
  const S t9 = t2 * t4 - t7;
  const S t10 = t8 + t3 * t4;
  const S t11 = t5 * (S(0.01088) * t10 - (S(0.02186) * t9 - S(0.00205) * t5)) + (S(0.00034) * t10 + (S(1.66229) * t9 - S(0.02186) * t5)) * t9;
  const S t12 = t8 - t3 * t6;
  const S t13 = t7 + t2 * t6;
  e[1] = S(6.867) * (t0 * (S(0.02) * t2 - S(0.01) * t3) + S(0.44) * t1);
  const S t15 = S(1.1) * ((S(0.007) * t5 + S(1.078) * t10) * t12 + t13 * (S(0.014) * t5 - S(1.078) * t9));
  e[0] = S(0.4235) * (t12 * t12 + t13 * t13) + (S(0.5) * (t10 * (S(1.6632) * t10 + (S(0.00034) * t9 + S(0.01088) * t5)) + t11) - t15);
}

// body_poses: 19 multiplications, 6 additions, 6 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[3], cosine[3];
  sines_and_cosines(3, q, sine, cosine);
  W[10] = sine[1];
  const S t0 = cosine[0];
  const S t2 = sine[1];
  const S t6 = t0 * t2;
  const S t1 = sine[0];
  const S t7 = t2 * t1;
  W[11] = S(0.41) * t2;
  const S t3 = cosine[1];
  const S t9 = t3 * t1;
  W[6] = t9;
  W[7] = S(0.41) * t9 + S(1.1) * t1;
  const S t11 = t3 * t0;
  W[2] = t11;
  W[3] = S(1.1) * t0 + S(0.41) * t11;
  const S t5 = cosine[2];
  const S t4 = sine[2];
  W[5] = -(t5 * t7 + t4 * t0);
  W[4] = t0 * t5 - t4 * t7;
  W[0] = -(t4 * t6 + t5 * t1);
  W[1] = t4 * t1 - t5 * t6;
  W[8] = t3 * t4;
  W[9] = t3 * t5;
}

}  // namespace alembert::mechanisms::body_on_torus

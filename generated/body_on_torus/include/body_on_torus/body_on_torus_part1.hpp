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

// inverse_dynamics: 69 multiplications, 49 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S qdd0 = qdd[0];  // dd(u)
  const S qdd1 = qdd[1];  // dd(v)
  const S qdd2 = qdd[2];  // dd(spin)
  const S t0 = q2 + S(1.1071487177940866);
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = qd0 * qd0;
  const S t6 = S(1.1) * (t1 * t5) + S(9.81) * t2;
  const S t7 = S(1.1) * (t3 * qdd0) + t4 * t6;
  const S t8 = qd0 * t2;
  const S t9 = qdd2 + (qdd0 * t1 + qd1 * t8);
  const S t10 = t4 * qd1 + t3 * t8;
  const S t11 = t3 * qd1 - t4 * t8;
  const S t12 = t10 * t11;
  const S t13 = t9 + t12;
  const S t14 = t1 * qd0;
  const S t15 = qd1 * t14 - qdd0 * t2;
  const S t16 = t3 * t15 - t4 * qdd1 - t11 * qd2;
  const S t17 = t14 + qd2;
  const S t18 = t11 * t17;
  const S t19 = t16 + t18;
  const S t20 = t3 * t6 - S(1.1) * (qdd0 * t4);
  const S t21 = t11 * t11;
  const S t22 = t17 * t17;
  const S t23 = t10 * t17;
  const S t24 = t4 * t15 + t3 * qdd1 - t10 * qd2;
  const S t25 = t23 + t24;
  const S t26 = t9 - t12;
  const S t27 = t10 * t10;
  const S t28 = S(0.01565247584249856) * t7 + (S(0.00048000000000017473) * t26 + (S(0.0015700000000001546) * t13 + (S(4.472135954999628e-05) * t25 - S(0.007200138887549335) * t19 + S(0.00015999999999998947) * (t21 - t27))));
  tau[2] = t28;
  const S t29 = t16 - t18;
  const S t30 = t23 - t24;
  const S t31 = S(0.007200138887549335) * (t22 - t27) + (S(4.472135954999628e-05) * t26 + S(0.00015999999999998947) * t29) + S(0.1371199999999998) * t25 - S(0.0015700000000001546) * t30;
  const S t32 = S(0.01565247584249856) * (S(9.81) * t1 - S(1.1) * (t5 * t2)) + S(0.30800000000000005) * t20 + t31;
  const S t33 = S(0.30800000000000005) * t7 + (S(4.472135954999628e-05) * (t21 - t22) + (S(0.00015999999999998947) * t30 + S(0.007200138887549335) * t13) - S(0.00048000000000017473) * t29 - S(0.1371199999999998) * t19);
  const S t34 = t1 * t28 - t2 * (t4 * t32 - t3 * t33);
  tau[0] = S(1.1) * (t3 * (S(0.7) * t7 + (S(0.01565247584249856) * t13 - S(0.30800000000000005) * t19)) - t4 * (S(0.7) * t20 + (S(0.01565247584249856) * (t21 + t22) + S(0.30800000000000005) * t25))) + t34;
  tau[1] = t4 * t33 + t3 * t32;
}

// mass_matrix: 20 multiplications, 15 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S t0 = q2 + S(1.1071487177940866);
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = S(0.00031999999999997894) * t3 + S(0.0010899999999999799) * t4;
  const S t6 = t4 * t5;
  const S t7 = S(4.472135954999628e-05) * t4 - S(0.007200138887549335) * t3;
  const S t8 = t1 * t7;
  M[0] = S(2.2) * (S(0.01565247584249856) * (t3 * t1) + S(0.30800000000000005) * t2 + S(0.385)) + t2 * (t2 * (t6 + S(0.13554999999999964)) - (t8 + t8)) + S(0.0020500000000003293);
  const S t10 = S(0.007200138887549335) * t4 + S(4.472135954999628e-05) * t3;
  M[5] = t10;
  M[7] = t10;
  const S t11 = t1 * t10 + t2 * (S(0.00015999999999998947) - t3 * t5);
  M[1] = t11;
  M[3] = t11;
  const S t12 = S(0.01721772342674842) * t3 - (t2 * t7 - S(0.0020500000000003293) * t1);
  M[2] = t12;
  M[6] = t12;
  M[4] = S(0.13868999999999995) - t6;
  M[8] = S(0.0020500000000003293);
}

// bias: 61 multiplications, 42 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = q2 + S(1.1071487177940866);
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = qd0 * qd0;
  const S t6 = S(1.1) * (t1 * t5) + S(9.81) * t2;
  const S t7 = t4 * t6;
  const S t8 = qd0 * t2;
  const S t9 = t3 * qd1 - t4 * t8;
  const S t10 = qd1 * t4 + t3 * t8;
  const S t11 = t9 * t10;
  const S t12 = qd1 * t8;
  const S t13 = t11 - t12;
  const S t14 = qd0 * t1;
  const S t15 = qd1 * t14;
  const S t16 = t3 * t15 - qd2 * t9;
  const S t17 = t14 + qd2;
  const S t18 = t9 * t17;
  const S t19 = t16 + t18;
  const S t20 = qd2 * t10 - t15 * t4;
  const S t21 = t17 * t10;
  const S t22 = t20 - t21;
  const S t23 = t9 * t9;
  const S t24 = t10 * t10;
  const S t25 = t11 + t12;
  const S t26 = S(0.01565247584249856) * t7 - (S(0.00048000000000017473) * t13 + (S(0.007200138887549335) * t19 + S(4.472135954999628e-05) * t22 - S(0.00015999999999998947) * (t23 - t24) - S(0.0015700000000001546) * t25));
  c[2] = t26;
  const S t27 = t3 * t6;
  const S t28 = t16 - t18;
  const S t29 = t17 * t17;
  const S t30 = t20 + t21;
  const S t31 = S(0.1371199999999998) * t22 - (S(0.00015999999999998947) * t28 - S(4.472135954999628e-05) * t13 + S(0.007200138887549335) * (t29 - t24)) + S(0.0015700000000001546) * t30;
  const S t32 = S(0.30800000000000005) * t27 + S(0.01565247584249856) * (S(9.81) * t1 - S(1.1) * (t2 * t5)) - t31;
  const S t33 = S(0.00048000000000017473) * t28 - (S(4.472135954999628e-05) * (t23 - t29) + (S(0.007200138887549335) * t25 + S(0.00015999999999998947) * t30)) + S(0.1371199999999998) * t19 - S(0.30800000000000005) * t7;
  const S t34 = S(1.1) * (t3 * (S(0.30800000000000005) * t19 - S(0.01565247584249856) * t25 - S(0.7) * t7) + t4 * (S(0.7) * t27 + (S(0.01565247584249856) * (t23 + t29) - S(0.30800000000000005) * t22)));
  c[0] = t1 * t26 - t2 * (t4 * t32 + t3 * t33) - t34;
  c[1] = t3 * t32 - t4 * t33;
}

// mass_matrix_and_bias: 81 multiplications, 57 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = q2 + S(1.1071487177940866);
  const S angle[] = {q1, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = S(0.00031999999999997894) * t3 + S(0.0010899999999999799) * t4;
  const S t6 = t4 * t5;
  const S t7 = S(4.472135954999628e-05) * t4 - S(0.007200138887549335) * t3;
  const S t8 = t1 * t7;
  M[0] = S(2.2) * (S(0.01565247584249856) * (t3 * t1) + S(0.30800000000000005) * t2 + S(0.385)) + t2 * (t2 * (t6 + S(0.13554999999999964)) - (t8 + t8)) + S(0.0020500000000003293);
  const S t10 = S(0.007200138887549335) * t4 + S(4.472135954999628e-05) * t3;
  M[5] = t10;
  M[7] = t10;
  const S t11 = t1 * t10 + t2 * (S(0.00015999999999998947) - t3 * t5);
  M[1] = t11;
  M[3] = t11;
  const S t12 = S(0.01721772342674842) * t3 - (t2 * t7 - S(0.0020500000000003293) * t1);
  M[2] = t12;
  M[6] = t12;
  M[4] = S(0.13868999999999995) - t6;
  const S t14 = qd0 * qd0;
  const S t15 = S(1.1) * (t1 * t14) + S(9.81) * t2;
  const S t16 = t4 * t15;
  const S t17 = t2 * qd0;
  const S t18 = t3 * qd1 - t4 * t17;
  const S t19 = t4 * qd1 + t3 * t17;
  const S t20 = t18 * t19;
  const S t21 = qd1 * t17;
  const S t22 = t20 - t21;
  const S t23 = t1 * qd0;
  const S t24 = qd1 * t23;
  const S t25 = t3 * t24 - qd2 * t18;
  const S t26 = t23 + qd2;
  const S t27 = t18 * t26;
  const S t28 = t25 + t27;
  const S t29 = qd2 * t19 - t4 * t24;
  const S t30 = t26 * t19;
  const S t31 = t29 - t30;
  const S t32 = t18 * t18;
  const S t33 = t19 * t19;
  const S t34 = t20 + t21;
  const S t35 = S(0.01565247584249856) * t16 - (S(0.00048000000000017473) * t22 + (S(0.007200138887549335) * t28 + S(4.472135954999628e-05) * t31 - S(0.00015999999999998947) * (t32 - t33) - S(0.0015700000000001546) * t34));
  c[2] = t35;
  const S t36 = t3 * t15;
  const S t37 = t25 - t27;
  const S t38 = t26 * t26;
  const S t39 = t29 + t30;
  const S t40 = S(0.1371199999999998) * t31 - (S(0.00015999999999998947) * t37 - S(4.472135954999628e-05) * t22 + S(0.007200138887549335) * (t38 - t33)) + S(0.0015700000000001546) * t39;
  const S t41 = S(0.30800000000000005) * t36 + S(0.01565247584249856) * (S(9.81) * t1 - S(1.1) * (t2 * t14)) - t40;
  const S t42 = S(0.00048000000000017473) * t37 - (S(4.472135954999628e-05) * (t32 - t38) + (S(0.007200138887549335) * t34 + S(0.00015999999999998947) * t39)) + S(0.1371199999999998) * t28 - S(0.30800000000000005) * t16;
  const S t43 = S(1.1) * (t3 * (S(0.30800000000000005) * t28 - S(0.01565247584249856) * t34 - S(0.7) * t16) + t4 * (S(0.7) * t36 + (S(0.01565247584249856) * (t32 + t38) - S(0.30800000000000005) * t31)));
  c[0] = t1 * t35 - t2 * (t4 * t41 + t3 * t42) - t43;
  c[1] = t3 * t41 - t4 * t42;
  M[8] = S(0.0020500000000003293);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  qdot[0] = qd0;
  qdot[1] = qd1;
  qdot[2] = qd2;
}

// energy: 36 multiplications, 22 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  S sine[2], cosine[2];
  sines_and_cosines(2, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = qd1 * t2;
  const S t5 = qd0 * t0;
  const S t6 = t4 + t5 * t3;
  const S t7 = qd2 + qd0 * t1;
  const S t8 = qd1 * t3;
  const S t9 = t8 - t2 * t5;
  const S t10 = t7 * (S(0.02186) * t9 + S(0.00205) * t7 + S(0.01088) * t6) - t9 * (S(0.00034) * t6 - (S(0.02186) * t7 + S(1.66229) * t9));
  const S t11 = qd0 - t5;
  const S t12 = t4 - t11 * t3;
  const S t13 = t8 + t2 * t11;
  const S t14 = S(0.4235) * (t12 * t12 + t13 * t13) - S(1.1) * (t12 * (S(1.078) * t6 + S(0.007) * t7) + t13 * (S(1.078) * t9 + S(0.014) * t7));
  e[0] = S(0.5) * (t6 * (S(1.6632) * t6 + (S(0.01088) * t7 - S(0.00034) * t9)) + t10) + t14;
  e[1] = S(6.867) * (S(0.43999999999999995) * t1 + t0 * (S(0.02) * t2 - S(0.01) * t3));
}

// body_poses: 19 multiplications, 6 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[3], cosine[3];
  sines_and_cosines(3, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  W[10] = t2;
  const S t3 = cosine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = t0 * t2;
  W[0] = -(t4 * t6 + t5 * t1);
  W[1] = t4 * t1 - t6 * t5;
  const S t9 = t0 * t3;
  W[2] = t9;
  W[3] = S(1.1) * t0 + S(0.41) * t9;
  const S t11 = t2 * t1;
  W[4] = t0 * t5 - t4 * t11;
  W[5] = -(t5 * t11 + t4 * t0);
  const S t14 = t1 * t3;
  W[6] = t14;
  W[7] = S(0.41) * t14 + S(1.1) * t1;
  W[8] = t4 * t3;
  W[9] = t5 * t3;
  W[11] = S(0.41) * t2;
}

}  // namespace alembert::mechanisms::body_on_torus

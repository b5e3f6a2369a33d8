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

// inverse_dynamics: 108 multiplications, 73 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S qdd0 = qdd[0];  // dd(u)
  const S qdd1 = qdd[1];  // dd(v)
  const S qdd2 = qdd[2];  // dd(spin)
  const S t0 = S(0.4636476090008061) - q2;
  const S angle[] = {q0, q1, t0};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t1 = cosine[0];
  const S t2 = sine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = cosine[2];
  const S t6 = sine[2];
  const S t7 = S(0.35) * t3 + S(1.1);
  const S t8 = t1 * t7;
  const S t9 = t2 * t4;
  const S t10 = qd2 + t4 * qd0;
  const S t11 = t3 * qd0;
  const S t12 = t5 * t11 - qd1 * t6;
  const S t13 = t10 * t12;
  const S t14 = qd0 * qd1;
  const S t15 = t4 * t14 - t3 * qdd0;
  const S t16 = t5 * qdd1 - t6 * t15 - qd2 * t12;
  const S t17 = t13 + t16;
  const S t18 = qdd2 + (t4 * qdd0 + t3 * t14);
  const S t19 = t5 * qd1 + t11 * t6;
  const S t20 = t12 * t19;
  const S t21 = t18 - t20;
  const S t22 = t1 * t4;
  const S t23 = qd0 * qd0;
  const S t24 = t7 * t2;
  const S t25 = t3 * t2;
  const S t26 = qd1 * qd1;
  const S t27 = S(0.7) * (t14 * t22) + (t23 * t24 - t8 * qdd0 + S(0.35) * (t25 * t26 + t9 * qdd1));
  const S t28 = t1 * t3;
  const S t29 = S(0.35) * (qdd1 * t22 + t26 * t28) + t8 * t23 + qdd0 * t24 - S(0.7) * (t9 * t14);
  const S t30 = t1 * t27 - t2 * t29;
  const S t31 = S(0.35) * (t3 * qdd1 - t4 * t26) + S(9.81);
  const S t32 = t22 * t29 + t9 * t27 + t3 * t31;
  const S t33 = t6 * t30 - t5 * t32;
  const S t34 = S(0.063) * t17 + S(0.01565247584249853) * t21 - S(0.7) * t33;
  const S t35 = t6 * t32 + t5 * t30;
  const S t36 = t6 * qdd1 + t5 * t15 - qd2 * t19;
  const S t37 = t10 * t19;
  const S t38 = t36 + t37;
  const S t39 = t10 * t10;
  const S t40 = t12 * t12;
  const S t41 = S(0.7) * t35 + (S(0.063) * t38 + S(0.01565247584249853) * (t39 + t40));
  const S t42 = t5 * t34 + t6 * t41;
  const S t43 = t6 * t34 - t5 * t41;
  const S t44 = t19 * t19;
  const S t45 = t36 - t37;
  const S t46 = t28 * t29 + t25 * t27 - t4 * t31;
  const S t47 = S(0.063) * (t40 + t44) - S(0.01565247584249853) * t45 + S(0.7) * t46;
  const S t48 = t18 + t20;
  const S t49 = S(0.01565247584249853) * t33 - (S(0.00048) * t48 + (S(0.001721772342674838) * t17 + S(4.472135954999585e-05) * t38 + S(0.00016000000000000042) * (t40 - t44) + S(0.00157) * t21));
  const S t50 = t13 - t16;
  const S t51 = S(0.063) * t33 + (S(0.00016000000000000042) * t45 - S(0.001721772342674838) * t21 + S(4.472135954999585e-05) * (t39 - t40) + S(0.00048) * t50 - S(0.00727) * t17);
  const S t52 = S(4.472135954999585e-05) * t48 + S(0.00016000000000000042) * t50 + S(0.001721772342674838) * (t39 - t44) + S(0.00727) * t38 + S(0.00157) * t45 - (S(0.01565247584249853) * t46 - S(0.063) * t35);
  const S t53 = t4 * t49 + t3 * (t6 * t51 + t5 * t52);
  tau[0] = -(t8 * (t9 * t42 - t1 * t43 + t25 * t47) - t24 * (t2 * t43 + t22 * t42 + t28 * t47) + t53);
  tau[1] = S(0.35) * t42 + t6 * t52 - t5 * t51;
  tau[2] = -t49;
}

// mass_matrix: 49 multiplications, 28 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  S sine[3], cosine[3];
  sines_and_cosines(3, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = S(0.35) * t2 + S(1.1);
  const S t7 = S(0.007) * t4 + S(0.014) * t5;
  const S t8 = t2 * t7;
  const S t9 = S(0.014) * t4 - S(0.007) * t5;
  const S t10 = S(0.063) * t2 - t9 * t3;
  const S t11 = t7 * t3;
  const S t12 = t0 * t3;
  const S t13 = t6 * t1;
  const S t14 = t6 * t0;
  const S t15 = t1 * t3;
  const S t16 = (t8 * (t2 * t0) + (t1 * t10 + t11 * t12)) * t13 + t14 * (t0 * t10 - t11 * t15 - t8 * (t2 * t1));
  const S t17 = S(0.00073) * t5 - S(0.00156) * t4;
  const S t18 = t2 * t17 + S(0.00205) * t3;
  const S t19 = S(0.00068) * t5 - S(0.00091) * t4;
  const S t20 = t4 * t19;
  M[0] = S(0.7) * (t6 * t6) + (t16 + t16 + (t3 * t18 + t2 * (t3 * t17 + t2 * (t20 + S(0.00875)))));
  const S t22 = S(0.00156) * t5 + S(0.00073) * t4;
  const S t23 = t3 * t22 + t2 * (S(0.00034) - t5 * t19) + S(0.35) * t11;
  M[1] = t23;
  M[3] = t23;
  const S t24 = t18 - (t13 * (t1 * t9 - t7 * t12) + t14 * (t7 * t15 + t0 * t9));
  M[2] = t24;
  M[6] = t24;
  M[4] = S(0.13769) - t20;
  const S t26 = t22 + S(0.35) * t7;
  M[5] = t26;
  M[7] = t26;
  M[8] = S(0.00205);
}

// bias: 99 multiplications, 63 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = S(0.4636476090008061) - q2;
  const S angle[] = {q0, q1, t0};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = cosine[2];
  const S t6 = sine[2];
  const S t7 = S(0.35) * t3 + S(1.1);
  const S t8 = t7 * t1;
  const S t9 = t3 * t2;
  const S t10 = t7 * t2;
  const S t11 = qd0 * qd0;
  const S t12 = t1 * t4;
  const S t13 = qd0 * qd1;
  const S t14 = qd1 * qd1;
  const S t15 = t10 * t11 - S(0.7) * (t12 * t13) + S(0.35) * (t9 * t14);
  const S t16 = t3 * t1;
  const S t17 = t2 * t4;
  const S t18 = S(0.35) * (t14 * t16) + (t8 * t11 + S(0.7) * (t13 * t17));
  const S t19 = S(9.81) - S(0.35) * (t4 * t14);
  const S t20 = t9 * t15 + t16 * t18 - t4 * t19;
  const S t21 = t4 * t13;
  const S t22 = t3 * qd0;
  const S t23 = qd1 * t5 + t6 * t22;
  const S t24 = t5 * t21 - qd2 * t23;
  const S t25 = qd2 + qd0 * t4;
  const S t26 = t23 * t25;
  const S t27 = t24 - t26;
  const S t28 = t23 * t23;
  const S t29 = t5 * t22 - qd1 * t6;
  const S t30 = t29 * t29;
  const S t31 = S(0.7) * t20 - (S(0.01565247584249853) * t27 - S(0.063) * (t28 + t30));
  const S t32 = t3 * t19 + (t12 * t18 + t15 * t17);
  const S t33 = t1 * t15 - t2 * t18;
  const S t34 = t6 * t32 - t5 * t33;
  const S t35 = t25 * t25;
  const S t36 = t24 + t26;
  const S t37 = S(0.7) * t34 + (S(0.01565247584249853) * (t30 + t35) + S(0.063) * t36);
  const S t38 = t25 * t29;
  const S t39 = qd2 * t29 + t21 * t6;
  const S t40 = t38 - t39;
  const S t41 = t3 * t13;
  const S t42 = t23 * t29;
  const S t43 = t41 - t42;
  const S t44 = t5 * t32 + t6 * t33;
  const S t45 = S(0.063) * t40 + S(0.01565247584249853) * t43 + S(0.7) * t44;
  const S t46 = t5 * t37 - t6 * t45;
  const S t47 = t6 * t37 + t5 * t45;
  const S t48 = t38 + t39;
  const S t49 = S(0.063) * t44 - (S(0.00016000000000000042) * t27 - S(0.001721772342674838) * t43 - S(4.472135954999585e-05) * (t30 - t35) + S(0.00048) * t48 - S(0.00727) * t40);
  const S t50 = t41 + t42;
  const S t51 = S(4.472135954999585e-05) * t50 + S(0.00016000000000000042) * t48 - S(0.001721772342674838) * (t28 - t35) + S(0.00727) * t36 + S(0.00157) * t27 - (S(0.01565247584249853) * t20 - S(0.063) * t34);
  const S t52 = S(0.01565247584249853) * t44 + (S(0.00048) * t50 + (S(4.472135954999585e-05) * t36 + S(0.001721772342674838) * t40 - S(0.00016000000000000042) * (t28 - t30) + S(0.00157) * t43));
  c[2] = t52;
  const S t53 = t3 * (t6 * t49 - t5 * t51) + t4 * t52;
  c[0] = t8 * (t9 * t31 - (t1 * t46 - t17 * t47)) - t10 * (t16 * t31 + (t12 * t47 + t2 * t46)) + t53;
  c[1] = S(0.35) * t47 + (t6 * t51 + t5 * t49);
}

// mass_matrix_and_bias: 141 multiplications, 90 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = S(0.4636476090008061) - q2;
  const S angle[] = {q0, q1, q2, t0};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S t1 = cosine[0];
  const S t2 = sine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = sine[2];
  const S t6 = cosine[2];
  const S t7 = cosine[3];
  const S t8 = sine[3];
  const S t9 = S(0.35) * t3 + S(1.1);
  const S t10 = S(0.007) * t5 + S(0.014) * t6;
  const S t11 = t3 * t10;
  const S t12 = t3 * t1;
  const S t13 = S(0.014) * t5 - S(0.007) * t6;
  const S t14 = S(0.063) * t3 - t13 * t4;
  const S t15 = t10 * t4;
  const S t16 = t1 * t4;
  const S t17 = t9 * t2;
  const S t18 = t9 * t1;
  const S t19 = t2 * t4;
  const S t20 = t3 * t2;
  const S t21 = (t11 * t12 + (t2 * t14 + t15 * t16)) * t17 + t18 * (t1 * t14 - t15 * t19 - t11 * t20);
  const S t22 = S(0.00073) * t6 - S(0.00156) * t5;
  const S t23 = t3 * t22 + S(0.00205) * t4;
  const S t24 = S(0.00068) * t6 - S(0.00091) * t5;
  const S t25 = t5 * t24;
  M[0] = S(0.7) * (t9 * t9) + (t21 + t21 + (t4 * t23 + t3 * (t4 * t22 + t3 * (t25 + S(0.00875)))));
  const S t27 = S(0.00156) * t6 + S(0.00073) * t5;
  const S t28 = t4 * t27 + t3 * (S(0.00034) - t6 * t24) + S(0.35) * t15;
  M[1] = t28;
  M[3] = t28;
  const S t29 = t23 - (t17 * (t2 * t13 - t10 * t16) + t18 * (t10 * t19 + t1 * t13));
  M[2] = t29;
  M[6] = t29;
  M[4] = S(0.13769) - t25;
  const S t31 = t27 + S(0.35) * t10;
  M[5] = t31;
  M[7] = t31;
  const S t32 = qd0 * qd0;
  const S t33 = qd0 * qd1;
  const S t34 = qd1 * qd1;
  const S t35 = t18 * t32 - S(0.7) * (t19 * t33) + S(0.35) * (t12 * t34);
  const S t36 = S(0.35) * (t20 * t34) + (t17 * t32 + S(0.7) * (t16 * t33));
  const S t37 = S(9.81) - S(0.35) * (t4 * t34);
  const S t38 = t12 * t35 + t20 * t36 - t4 * t37;
  const S t39 = t4 * t33;
  const S t40 = t3 * qd0;
  const S t41 = qd1 * t7 + t8 * t40;
  const S t42 = t7 * t39 - qd2 * t41;
  const S t43 = qd2 + t4 * qd0;
  const S t44 = t41 * t43;
  const S t45 = t42 - t44;
  const S t46 = t41 * t41;
  const S t47 = t7 * t40 - qd1 * t8;
  const S t48 = t47 * t47;
  const S t49 = S(0.7) * t38 - (S(0.01565247584249853) * t45 - S(0.063) * (t46 + t48));
  const S t50 = t3 * t37 + (t19 * t36 + t16 * t35);
  const S t51 = t2 * t35 - t1 * t36;
  const S t52 = t8 * t50 - t7 * t51;
  const S t53 = t43 * t43;
  const S t54 = t42 + t44;
  const S t55 = S(0.7) * t52 + (S(0.01565247584249853) * (t48 + t53) + S(0.063) * t54);
  const S t56 = t43 * t47;
  const S t57 = qd2 * t47 + t39 * t8;
  const S t58 = t56 - t57;
  const S t59 = t3 * t33;
  const S t60 = t41 * t47;
  const S t61 = t59 - t60;
  const S t62 = t7 * t50 + t8 * t51;
  const S t63 = S(0.063) * t58 + S(0.01565247584249853) * t61 + S(0.7) * t62;
  const S t64 = t7 * t55 - t8 * t63;
  const S t65 = t8 * t55 + t7 * t63;
  const S t66 = t56 + t57;
  const S t67 = S(0.063) * t62 - (S(0.00016000000000000042) * t45 - S(0.001721772342674838) * t61 - S(4.472135954999585e-05) * (t48 - t53) + S(0.00048) * t66 - S(0.00727) * t58);
  const S t68 = t59 + t60;
  const S t69 = S(4.472135954999585e-05) * t68 + S(0.00016000000000000042) * t66 - S(0.001721772342674838) * (t46 - t53) + S(0.00727) * t54 + S(0.00157) * t45 - (S(0.01565247584249853) * t38 - S(0.063) * t52);
  const S t70 = S(0.01565247584249853) * t62 + (S(0.00048) * t68 + (S(4.472135954999585e-05) * t54 + S(0.001721772342674838) * t58 - S(0.00016000000000000042) * (t46 - t48) + S(0.00157) * t61));
  c[2] = t70;
  const S t71 = t3 * (t8 * t67 - t7 * t69) + t4 * t70;
  c[0] = t17 * (t12 * t49 - (t2 * t64 - t16 * t65)) - t18 * (t20 * t49 + (t19 * t65 + t1 * t64)) + t71;
  c[1] = S(0.35) * t65 + (t8 * t69 + t7 * t67);
  M[8] = S(0.00205);
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

// energy: 55 multiplications, 27 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  S sine[3], cosine[3];
  sines_and_cosines(3, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = qd0 * t2;
  const S t7 = t4 * t6 - qd1 * t5;
  const S t8 = t4 * qd1 + t6 * t5;
  const S t9 = qd2 + qd0 * t3;
  const S t10 = t9 * (S(0.00156) * t7 - S(0.00073) * t8 - S(0.00205) * t9);
  const S t11 = t3 * t0;
  const S t12 = S(0.35) * t2 + S(1.1);
  const S t13 = qd0 * (t12 * t1) + S(0.35) * (qd1 * t11);
  const S t14 = t3 * t1;
  const S t15 = qd0 * (t0 * t12) - S(0.35) * (qd1 * t14);
  const S t16 = S(0.35) * (t2 * (t2 * qd1)) + (t11 * t13 - t14 * t15);
  const S t17 = t1 * t13 + t0 * t15;
  const S t18 = t5 * t16 - t4 * t17;
  const S t19 = t5 * t17 + t4 * t16;
  const S t20 = S(0.35) * (t18 * t18 + t19 * t19) + (t19 * (S(0.007) * t9 + S(0.063) * t8) - t18 * (S(0.063) * t7 - S(0.014) * t9));
  e[0] = S(0.5) * (t7 * (S(0.00034) * t8 + S(0.00784) * t7 - S(0.00156) * t9) + t8 * (S(0.00073) * t9 + (S(0.00034) * t7 + S(0.00875) * t8)) - t10) + t20;
  e[1] = S(6.867) * (S(0.44) * t3 - t2 * (S(0.01) * t5 - S(0.02) * t4));
}

// body_poses: 20 multiplications, 7 additions, 6 sin/cos/tan (reduced formulation).
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
  const S t10 = S(0.35) * t3 + S(1.1);
  W[3] = S(0.06) * t9 + t0 * t10;
  const S t12 = t2 * t1;
  W[4] = t0 * t5 - t4 * t12;
  W[5] = -(t5 * t12 + t4 * t0);
  const S t15 = t1 * t3;
  W[6] = t15;
  W[7] = t1 * t10 + S(0.06) * t15;
  W[8] = t4 * t3;
  W[9] = t5 * t3;
  W[11] = S(0.41) * t2;
}

}  // namespace alembert::mechanisms::body_on_torus

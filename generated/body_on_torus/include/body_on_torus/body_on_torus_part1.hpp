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
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S qdd0 = qdd[0];  // dd(u)
  const S qdd1 = qdd[1];  // dd(v)
  const S qdd2 = qdd[2];  // dd(spin)
  const S t0 = cos(q0);
  const S t1 = sin(q0);
  const S t2 = cos(q1);
  const S t3 = sin(q1);
  const S t4 = S(0.35) * t2 + S(1.1);
  const S t5 = t0 * t4;
  const S t6 = t1 * t3;
  const S t7 = S(0.4636476090008061) - q2;
  const S t8 = cos(t7);
  const S t9 = sin(t7);
  const S t10 = qd2 + t3 * qd0;
  const S t11 = t2 * qd0;
  const S t12 = t8 * t11 - qd1 * t9;
  const S t13 = t10 * t12;
  const S t14 = qd0 * qd1;
  const S t15 = t3 * t14 - t2 * qdd0;
  const S t16 = t8 * qdd1 - t9 * t15 - qd2 * t12;
  const S t17 = t13 + t16;
  const S t18 = qdd2 + (t3 * qdd0 + t2 * t14);
  const S t19 = t8 * qd1 + t11 * t9;
  const S t20 = t12 * t19;
  const S t21 = t18 - t20;
  const S t22 = t0 * t3;
  const S t23 = qd0 * qd0;
  const S t24 = t4 * t1;
  const S t25 = t2 * t1;
  const S t26 = qd1 * qd1;
  const S t27 = S(0.7) * (t14 * t22) + (t23 * t24 - t5 * qdd0 + S(0.35) * (t25 * t26 + t6 * qdd1));
  const S t28 = t0 * t2;
  const S t29 = S(0.35) * (qdd1 * t22 + t26 * t28) + t5 * t23 + qdd0 * t24 - S(0.7) * (t6 * t14);
  const S t30 = t0 * t27 - t1 * t29;
  const S t31 = S(0.35) * (t2 * qdd1 - t3 * t26) + S(9.81);
  const S t32 = t22 * t29 + t6 * t27 + t2 * t31;
  const S t33 = t9 * t30 - t8 * t32;
  const S t34 = S(0.063) * t17 + S(0.01565247584249853) * t21 - S(0.7) * t33;
  const S t35 = t9 * t32 + t8 * t30;
  const S t36 = t9 * qdd1 + t8 * t15 - qd2 * t19;
  const S t37 = t10 * t19;
  const S t38 = t36 + t37;
  const S t39 = t10 * t10;
  const S t40 = t12 * t12;
  const S t41 = S(0.7) * t35 + (S(0.063) * t38 + S(0.01565247584249853) * (t39 + t40));
  const S t42 = t8 * t34 + t9 * t41;
  const S t43 = t9 * t34 - t8 * t41;
  const S t44 = t19 * t19;
  const S t45 = t36 - t37;
  const S t46 = t28 * t29 + t25 * t27 - t3 * t31;
  const S t47 = S(0.063) * (t40 + t44) - S(0.01565247584249853) * t45 + S(0.7) * t46;
  const S t48 = t18 + t20;
  const S t49 = S(0.01565247584249853) * t33 - (S(0.00048) * t48 + (S(0.001721772342674838) * t17 + S(4.472135954999585e-05) * t38 + S(0.00016000000000000042) * (t40 - t44) + S(0.00157) * t21));
  const S t50 = t13 - t16;
  const S t51 = S(0.063) * t33 + (S(0.00016000000000000042) * t45 - S(0.001721772342674838) * t21 + S(4.472135954999585e-05) * (t39 - t40) + S(0.00048) * t50 - S(0.00727) * t17);
  const S t52 = S(4.472135954999585e-05) * t48 + S(0.00016000000000000042) * t50 + S(0.001721772342674838) * (t39 - t44) + S(0.00727) * t38 + S(0.00157) * t45 - (S(0.01565247584249853) * t46 - S(0.063) * t35);
  const S t53 = t3 * t49 + t2 * (t9 * t51 + t8 * t52);
  tau[0] = -(t5 * (t6 * t42 - t0 * t43 + t25 * t47) - t24 * (t1 * t43 + t22 * t42 + t28 * t47) + t53);
  tau[1] = S(0.35) * t42 + t9 * t52 - t8 * t51;
  tau[2] = -t49;
}

// mass_matrix: 49 multiplications, 28 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(0.35) * t0 + S(1.1);
  const S t3 = sin(q2);
  const S t4 = cos(q2);
  const S t5 = S(0.007) * t3 + S(0.014) * t4;
  const S t6 = t0 * t5;
  const S t7 = cos(q0);
  const S t8 = sin(q0);
  const S t9 = S(0.014) * t3 - S(0.007) * t4;
  const S t10 = S(0.063) * t0 - t9 * t1;
  const S t11 = t5 * t1;
  const S t12 = t7 * t1;
  const S t13 = t2 * t8;
  const S t14 = t2 * t7;
  const S t15 = t8 * t1;
  const S t16 = (t6 * (t0 * t7) + (t8 * t10 + t11 * t12)) * t13 + t14 * (t7 * t10 - t11 * t15 - t6 * (t0 * t8));
  const S t17 = S(0.00073) * t4 - S(0.00156) * t3;
  const S t18 = t0 * t17 + S(0.00205) * t1;
  const S t19 = S(0.00068) * t4 - S(0.00091) * t3;
  const S t20 = t3 * t19;
  M[0] = S(0.7) * (t2 * t2) + (t16 + t16 + (t1 * t18 + t0 * (t1 * t17 + t0 * (t20 + S(0.00875)))));
  const S t22 = S(0.00156) * t4 + S(0.00073) * t3;
  const S t23 = t1 * t22 + t0 * (S(0.00034) - t4 * t19) + S(0.35) * t11;
  M[1] = t23;
  M[3] = t23;
  const S t24 = t18 - (t13 * (t8 * t9 - t5 * t12) + t14 * (t5 * t15 + t7 * t9));
  M[2] = t24;
  M[6] = t24;
  M[4] = S(0.13769) - t20;
  const S t26 = t22 + S(0.35) * t5;
  M[5] = t26;
  M[7] = t26;
  M[8] = S(0.00205);
}

// bias: 99 multiplications, 63 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(0.35) * t0 + S(1.1);
  const S t3 = sin(q0);
  const S t4 = cos(q0);
  const S t5 = t2 * t3;
  const S t6 = t0 * t4;
  const S t7 = t2 * t4;
  const S t8 = qd0 * qd0;
  const S t9 = t3 * t1;
  const S t10 = qd0 * qd1;
  const S t11 = qd1 * qd1;
  const S t12 = t7 * t8 - S(0.7) * (t9 * t10) + S(0.35) * (t6 * t11);
  const S t13 = t0 * t3;
  const S t14 = t4 * t1;
  const S t15 = S(0.35) * (t11 * t13) + (t5 * t8 + S(0.7) * (t10 * t14));
  const S t16 = S(9.81) - S(0.35) * (t1 * t11);
  const S t17 = t6 * t12 + t13 * t15 - t1 * t16;
  const S t18 = S(0.4636476090008061) - q2;
  const S t19 = cos(t18);
  const S t20 = sin(t18);
  const S t21 = t1 * t10;
  const S t22 = t0 * qd0;
  const S t23 = qd1 * t19 + t20 * t22;
  const S t24 = t19 * t21 - qd2 * t23;
  const S t25 = qd2 + qd0 * t1;
  const S t26 = t23 * t25;
  const S t27 = t24 - t26;
  const S t28 = t23 * t23;
  const S t29 = t19 * t22 - qd1 * t20;
  const S t30 = t29 * t29;
  const S t31 = S(0.7) * t17 - (S(0.01565247584249853) * t27 - S(0.063) * (t28 + t30));
  const S t32 = t0 * t16 + (t9 * t15 + t12 * t14);
  const S t33 = t3 * t12 - t4 * t15;
  const S t34 = t20 * t32 - t19 * t33;
  const S t35 = t25 * t25;
  const S t36 = t24 + t26;
  const S t37 = S(0.7) * t34 + (S(0.01565247584249853) * (t30 + t35) + S(0.063) * t36);
  const S t38 = t25 * t29;
  const S t39 = qd2 * t29 + t21 * t20;
  const S t40 = t38 - t39;
  const S t41 = t0 * t10;
  const S t42 = t23 * t29;
  const S t43 = t41 - t42;
  const S t44 = t19 * t32 + t20 * t33;
  const S t45 = S(0.063) * t40 + S(0.01565247584249853) * t43 + S(0.7) * t44;
  const S t46 = t19 * t37 - t20 * t45;
  const S t47 = t20 * t37 + t19 * t45;
  const S t48 = t38 + t39;
  const S t49 = S(0.063) * t44 - (S(0.00016000000000000042) * t27 - S(0.001721772342674838) * t43 - S(4.472135954999585e-05) * (t30 - t35) + S(0.00048) * t48 - S(0.00727) * t40);
  const S t50 = t41 + t42;
  const S t51 = S(4.472135954999585e-05) * t50 + S(0.00016000000000000042) * t48 - S(0.001721772342674838) * (t28 - t35) + S(0.00727) * t36 + S(0.00157) * t27 - (S(0.01565247584249853) * t17 - S(0.063) * t34);
  const S t52 = S(0.01565247584249853) * t44 + (S(0.00048) * t50 + (S(4.472135954999585e-05) * t36 + S(0.001721772342674838) * t40 - S(0.00016000000000000042) * (t28 - t30) + S(0.00157) * t43));
  c[2] = t52;
  const S t53 = t0 * (t20 * t49 - t19 * t51) + t1 * t52;
  c[0] = t5 * (t6 * t31 - (t3 * t46 - t14 * t47)) - t7 * (t13 * t31 + (t9 * t47 + t4 * t46)) + t53;
  c[1] = S(0.35) * t47 + (t20 * t51 + t19 * t49);
}

// mass_matrix_and_bias: 141 multiplications, 90 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(0.35) * t0 + S(1.1);
  const S t3 = sin(q2);
  const S t4 = cos(q2);
  const S t5 = S(0.007) * t3 + S(0.014) * t4;
  const S t6 = t0 * t5;
  const S t7 = cos(q0);
  const S t8 = sin(q0);
  const S t9 = t0 * t7;
  const S t10 = S(0.014) * t3 - S(0.007) * t4;
  const S t11 = S(0.063) * t0 - t10 * t1;
  const S t12 = t5 * t1;
  const S t13 = t7 * t1;
  const S t14 = t2 * t8;
  const S t15 = t2 * t7;
  const S t16 = t8 * t1;
  const S t17 = t0 * t8;
  const S t18 = (t6 * t9 + (t8 * t11 + t12 * t13)) * t14 + t15 * (t7 * t11 - t12 * t16 - t6 * t17);
  const S t19 = S(0.00073) * t4 - S(0.00156) * t3;
  const S t20 = t0 * t19 + S(0.00205) * t1;
  const S t21 = S(0.00068) * t4 - S(0.00091) * t3;
  const S t22 = t3 * t21;
  M[0] = S(0.7) * (t2 * t2) + (t18 + t18 + (t1 * t20 + t0 * (t1 * t19 + t0 * (t22 + S(0.00875)))));
  const S t24 = S(0.00156) * t4 + S(0.00073) * t3;
  const S t25 = t1 * t24 + t0 * (S(0.00034) - t4 * t21) + S(0.35) * t12;
  M[1] = t25;
  M[3] = t25;
  const S t26 = t20 - (t14 * (t8 * t10 - t5 * t13) + t15 * (t5 * t16 + t7 * t10));
  M[2] = t26;
  M[6] = t26;
  M[4] = S(0.13769) - t22;
  const S t28 = t24 + S(0.35) * t5;
  M[5] = t28;
  M[7] = t28;
  const S t29 = qd0 * qd0;
  const S t30 = qd0 * qd1;
  const S t31 = qd1 * qd1;
  const S t32 = t15 * t29 - S(0.7) * (t16 * t30) + S(0.35) * (t9 * t31);
  const S t33 = S(0.35) * (t17 * t31) + (t14 * t29 + S(0.7) * (t13 * t30));
  const S t34 = S(9.81) - S(0.35) * (t1 * t31);
  const S t35 = t9 * t32 + t17 * t33 - t1 * t34;
  const S t36 = S(0.4636476090008061) - q2;
  const S t37 = cos(t36);
  const S t38 = sin(t36);
  const S t39 = t1 * t30;
  const S t40 = t0 * qd0;
  const S t41 = qd1 * t37 + t38 * t40;
  const S t42 = t37 * t39 - qd2 * t41;
  const S t43 = qd2 + t1 * qd0;
  const S t44 = t41 * t43;
  const S t45 = t42 - t44;
  const S t46 = t41 * t41;
  const S t47 = t37 * t40 - qd1 * t38;
  const S t48 = t47 * t47;
  const S t49 = S(0.7) * t35 - (S(0.01565247584249853) * t45 - S(0.063) * (t46 + t48));
  const S t50 = t0 * t34 + (t16 * t33 + t13 * t32);
  const S t51 = t8 * t32 - t7 * t33;
  const S t52 = t38 * t50 - t37 * t51;
  const S t53 = t43 * t43;
  const S t54 = t42 + t44;
  const S t55 = S(0.7) * t52 + (S(0.01565247584249853) * (t48 + t53) + S(0.063) * t54);
  const S t56 = t43 * t47;
  const S t57 = qd2 * t47 + t39 * t38;
  const S t58 = t56 - t57;
  const S t59 = t0 * t30;
  const S t60 = t41 * t47;
  const S t61 = t59 - t60;
  const S t62 = t37 * t50 + t38 * t51;
  const S t63 = S(0.063) * t58 + S(0.01565247584249853) * t61 + S(0.7) * t62;
  const S t64 = t37 * t55 - t38 * t63;
  const S t65 = t38 * t55 + t37 * t63;
  const S t66 = t56 + t57;
  const S t67 = S(0.063) * t62 - (S(0.00016000000000000042) * t45 - S(0.001721772342674838) * t61 - S(4.472135954999585e-05) * (t48 - t53) + S(0.00048) * t66 - S(0.00727) * t58);
  const S t68 = t59 + t60;
  const S t69 = S(4.472135954999585e-05) * t68 + S(0.00016000000000000042) * t66 - S(0.001721772342674838) * (t46 - t53) + S(0.00727) * t54 + S(0.00157) * t45 - (S(0.01565247584249853) * t35 - S(0.063) * t52);
  const S t70 = S(0.01565247584249853) * t62 + (S(0.00048) * t68 + (S(4.472135954999585e-05) * t54 + S(0.001721772342674838) * t58 - S(0.00016000000000000042) * (t46 - t48) + S(0.00157) * t61));
  c[2] = t70;
  const S t71 = t0 * (t38 * t67 - t37 * t69) + t1 * t70;
  c[0] = t14 * (t9 * t49 - (t8 * t64 - t13 * t65)) - t15 * (t17 * t49 + (t16 * t65 + t7 * t64)) + t71;
  c[1] = S(0.35) * t65 + (t38 * t69 + t37 * t67);
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
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S qd0 = qd[0];  // d(u)
  const S qd1 = qd[1];  // d(v)
  const S qd2 = qd[2];  // d(spin)
  const S t0 = sin(q2);
  const S t1 = cos(q2);
  const S t2 = cos(q1);
  const S t3 = sin(q1);
  const S t4 = qd0 * t2;
  const S t5 = t0 * t4 - qd1 * t1;
  const S t6 = t0 * qd1 + t4 * t1;
  const S t7 = qd2 + qd0 * t3;
  const S t8 = t7 * (S(0.00156) * t5 - S(0.00073) * t6 - S(0.00205) * t7);
  const S t9 = cos(q0);
  const S t10 = sin(q0);
  const S t11 = t3 * t9;
  const S t12 = S(0.35) * t2 + S(1.1);
  const S t13 = qd0 * (t12 * t10) + S(0.35) * (qd1 * t11);
  const S t14 = t3 * t10;
  const S t15 = qd0 * (t9 * t12) - S(0.35) * (qd1 * t14);
  const S t16 = S(0.35) * (t2 * (t2 * qd1)) + (t11 * t13 - t14 * t15);
  const S t17 = t10 * t13 + t9 * t15;
  const S t18 = t1 * t16 - t0 * t17;
  const S t19 = t1 * t17 + t0 * t16;
  const S t20 = S(0.35) * (t18 * t18 + t19 * t19) + (t19 * (S(0.007) * t7 + S(0.063) * t6) - t18 * (S(0.063) * t5 - S(0.014) * t7));
  e[0] = S(0.5) * (t5 * (S(0.00034) * t6 + S(0.00784) * t5 - S(0.00156) * t7) + t6 * (S(0.00073) * t7 + (S(0.00034) * t5 + S(0.00875) * t6)) - t8) + t20;
  e[1] = S(6.867) * (S(0.44) * t3 - t2 * (S(0.01) * t1 - S(0.02) * t0));
}

// body_poses: 20 multiplications, 7 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // u
  const S q1 = q[1];  // v
  const S q2 = q[2];  // spin
  const S t0 = sin(q2);
  const S t1 = cos(q2);
  const S t2 = cos(q0);
  const S t3 = sin(q0);
  const S t4 = sin(q1);
  W[10] = t4;
  const S t5 = cos(q1);
  const S t6 = t2 * t4;
  W[0] = -(t0 * t6 + t1 * t3);
  W[1] = t0 * t3 - t6 * t1;
  const S t9 = t2 * t5;
  W[2] = t9;
  const S t10 = S(0.35) * t5 + S(1.1);
  W[3] = S(0.06) * t9 + t2 * t10;
  const S t12 = t4 * t3;
  W[4] = t2 * t1 - t0 * t12;
  W[5] = -(t1 * t12 + t0 * t2);
  const S t15 = t3 * t5;
  W[6] = t15;
  W[7] = t3 * t10 + S(0.06) * t15;
  W[8] = t0 * t5;
  W[9] = t1 * t5;
  W[11] = S(0.41) * t4;
}

}  // namespace alembert::mechanisms::body_on_torus

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

// inverse_dynamics: 113 multiplications, 79 additions, 6 sin/cos/tan (reduced formulation).
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
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = sin(q2);
  const S t3 = cos(q2);
  const S t4 = cos(q0);
  const S t5 = sin(q0);
  const S t6 = t0 * t4;
  const S t7 = t4 * t1;
  const S t8 = qd1 * qd1;
  const S t9 = S(0.35) * t1 + S(1.1);
  const S t10 = t4 * t9;
  const S t11 = qd0 * qd0;
  const S t12 = t9 * t5;
  const S t13 = t0 * t5;
  const S t14 = qd1 * qd0;
  const S t15 = S(0.35) * (t6 * qdd1 + t7 * t8) + t10 * t11 + qdd0 * t12 - S(0.7) * (t13 * t14);
  const S t16 = t1 * t5;
  const S t17 = S(0.7) * (t6 * t14) + (t11 * t12 - t10 * qdd0 + S(0.35) * (t8 * t16 + qdd1 * t13));
  const S t18 = S(0.35) * (qdd1 * t1 - t0 * t8) + S(9.81);
  const S t19 = t6 * t15 + t13 * t17 + t1 * t18;
  const S t20 = t4 * t17 - t5 * t15;
  const S t21 = t2 * t19 - t3 * t20;
  const S t22 = t19 * t3 + t2 * t20;
  const S t23 = qdd2 + (t0 * qdd0 + t1 * t14);
  const S t24 = t1 * qd0;
  const S t25 = qd1 * t3 - t2 * t24;
  const S t26 = t2 * qd1 + t3 * t24;
  const S t27 = t25 * t26;
  const S t28 = t23 + t27;
  const S t29 = t25 * t25;
  const S t30 = t26 * t26;
  const S t31 = t0 * t14 - t1 * qdd0;
  const S t32 = t2 * t31 + qdd1 * t3 - t26 * qd2;
  const S t33 = qd2 + t0 * qd0;
  const S t34 = t26 * t33;
  const S t35 = t32 + t34;
  const S t36 = t25 * t33;
  const S t37 = t2 * qdd1 - t3 * t31 + t25 * qd2;
  const S t38 = t36 - t37;
  const S t39 = t23 - t27;
  const S t40 = S(0.007) * t21 + S(0.014) * t22 + (S(0.00057) * t28 + (S(0.00034) * (t29 - t30) + (S(0.00156) * t35 - S(0.00073) * t38) + S(0.00148) * t39));
  tau[2] = t40;
  const S t41 = t7 * t15 + t16 * t17 - t0 * t18;
  const S t42 = t33 * t33;
  const S t43 = t36 + t37;
  const S t44 = t32 - t34;
  const S t45 = S(0.007) * t41 - S(0.063) * t22 - (S(0.00727) * t35 - (S(0.00073) * (t30 - t42) - (S(0.00156) * t39 - S(0.00034) * t43) - S(0.00057) * t44));
  const S t46 = S(0.014) * t41 + S(0.063) * t21 - (S(0.00727) * t38 - (S(0.00073) * t28 - S(0.00034) * t44 + S(0.00156) * (t29 - t42)) - S(0.00148) * t43);
  const S t47 = S(0.7) * t41 + (S(0.014) * t43 - S(0.007) * t44 + S(0.063) * (t29 + t30));
  const S t48 = S(0.7) * t22 + (S(0.007) * (t29 + t42) + S(0.014) * t39 + S(0.063) * t35);
  const S t49 = S(0.063) * t38 - (S(0.007) * t28 - S(0.014) * (t30 + t42)) - S(0.7) * t21;
  const S t50 = t2 * t48 + t3 * t49;
  const S t51 = t3 * t48 - t2 * t49;
  const S t52 = t12 * (t7 * t47 - (t5 * t50 - t6 * t51)) - t10 * (t16 * t47 + (t13 * t51 + t4 * t50));
  tau[0] = t0 * t40 + t1 * (t2 * t45 + t3 * t46) + t52;
  tau[1] = S(0.35) * t51 + (t2 * t46 - t3 * t45);
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

// bias: 104 multiplications, 69 additions, 6 sin/cos/tan (reduced formulation).
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
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = cos(q2);
  const S t3 = sin(q2);
  const S t4 = sin(q0);
  const S t5 = cos(q0);
  const S t6 = S(0.35) * t1 + S(1.1);
  const S t7 = t5 * t6;
  const S t8 = qd0 * qd0;
  const S t9 = t0 * t4;
  const S t10 = qd1 * qd0;
  const S t11 = qd1 * qd1;
  const S t12 = t5 * t1;
  const S t13 = t7 * t8 - S(0.7) * (t9 * t10) + S(0.35) * (t11 * t12);
  const S t14 = t1 * t4;
  const S t15 = t6 * t4;
  const S t16 = t5 * t0;
  const S t17 = S(0.35) * (t11 * t14) + (t8 * t15 + S(0.7) * (t10 * t16));
  const S t18 = t4 * t13 - t5 * t17;
  const S t19 = S(9.81) - S(0.35) * (t0 * t11);
  const S t20 = t1 * t19 + (t9 * t17 + t16 * t13);
  const S t21 = t2 * t18 + t3 * t20;
  const S t22 = t2 * t20 - t3 * t18;
  const S t23 = t1 * t10;
  const S t24 = t1 * qd0;
  const S t25 = t2 * qd1 - t3 * t24;
  const S t26 = t3 * qd1 + t2 * t24;
  const S t27 = t25 * t26;
  const S t28 = t23 + t27;
  const S t29 = t23 - t27;
  const S t30 = t25 * t25;
  const S t31 = t26 * t26;
  const S t32 = t0 * t10;
  const S t33 = t2 * t32 - t25 * qd2;
  const S t34 = qd2 + t0 * qd0;
  const S t35 = t25 * t34;
  const S t36 = t33 + t35;
  const S t37 = t26 * qd2 - t3 * t32;
  const S t38 = t26 * t34;
  const S t39 = t37 - t38;
  const S t40 = S(0.007) * t21 + S(0.014) * t22 + (S(0.00057) * t28 + (S(0.00148) * t29 + (S(0.00034) * (t30 - t31) - (S(0.00073) * t36 + S(0.00156) * t39))));
  c[2] = t40;
  const S t41 = t33 - t35;
  const S t42 = t34 * t34;
  const S t43 = t37 + t38;
  const S t44 = t12 * t13 + t14 * t17 - t0 * t19;
  const S t45 = S(0.00148) * t41 + (S(0.00727) * t36 - (S(0.00156) * (t30 - t42) + (S(0.00073) * t28 + S(0.00034) * t43))) - (S(0.063) * t21 + S(0.014) * t44);
  const S t46 = S(0.00057) * t43 - (S(0.00073) * (t42 - t31) + (S(0.00034) * t41 + S(0.00156) * t29)) + S(0.00727) * t39 + (S(0.007) * t44 - S(0.063) * t22);
  const S t47 = S(0.7) * t22 + (S(0.014) * t29 + S(0.007) * (t30 + t42) - S(0.063) * t39);
  const S t48 = S(0.7) * t21 - (S(0.063) * t36 + (S(0.014) * (t42 + t31) - S(0.007) * t28));
  const S t49 = t3 * t47 - t2 * t48;
  const S t50 = t2 * t47 + t3 * t48;
  const S t51 = S(0.7) * t44 - (S(0.014) * t41 - S(0.007) * t43 - S(0.063) * (t30 + t31));
  const S t52 = t7 * (t5 * t49 + t9 * t50 + t14 * t51) + t15 * (t4 * t49 - t16 * t50 - t12 * t51);
  c[0] = t0 * t40 - t1 * (t2 * t45 - t3 * t46) - t52;
  c[1] = S(0.35) * t50 - t2 * t46 - t3 * t45;
}

// mass_matrix_and_bias: 146 multiplications, 96 additions, 6 sin/cos/tan (reduced formulation).
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
  const S t30 = qd1 * qd0;
  const S t31 = qd1 * qd1;
  const S t32 = t15 * t29 - S(0.7) * (t16 * t30) + S(0.35) * (t9 * t31);
  const S t33 = S(0.35) * (t17 * t31) + (t14 * t29 + S(0.7) * (t13 * t30));
  const S t34 = t8 * t32 - t7 * t33;
  const S t35 = S(9.81) - S(0.35) * (t1 * t31);
  const S t36 = t0 * t35 + (t16 * t33 + t13 * t32);
  const S t37 = t4 * t34 + t3 * t36;
  const S t38 = t4 * t36 - t3 * t34;
  const S t39 = t0 * t30;
  const S t40 = t0 * qd0;
  const S t41 = t4 * qd1 - t3 * t40;
  const S t42 = t3 * qd1 + t4 * t40;
  const S t43 = t41 * t42;
  const S t44 = t39 + t43;
  const S t45 = t39 - t43;
  const S t46 = t41 * t41;
  const S t47 = t42 * t42;
  const S t48 = t1 * t30;
  const S t49 = t4 * t48 - t41 * qd2;
  const S t50 = qd2 + t1 * qd0;
  const S t51 = t41 * t50;
  const S t52 = t49 + t51;
  const S t53 = t42 * qd2 - t3 * t48;
  const S t54 = t42 * t50;
  const S t55 = t53 - t54;
  const S t56 = S(0.007) * t37 + S(0.014) * t38 + (S(0.00057) * t44 + (S(0.00148) * t45 + (S(0.00034) * (t46 - t47) - (S(0.00073) * t52 + S(0.00156) * t55))));
  c[2] = t56;
  const S t57 = t49 - t51;
  const S t58 = t50 * t50;
  const S t59 = t53 + t54;
  const S t60 = t9 * t32 + t17 * t33 - t1 * t35;
  const S t61 = S(0.00148) * t57 + (S(0.00727) * t52 - (S(0.00156) * (t46 - t58) + (S(0.00073) * t44 + S(0.00034) * t59))) - (S(0.063) * t37 + S(0.014) * t60);
  const S t62 = S(0.00057) * t59 - (S(0.00073) * (t58 - t47) + (S(0.00034) * t57 + S(0.00156) * t45)) + S(0.00727) * t55 + (S(0.007) * t60 - S(0.063) * t38);
  const S t63 = S(0.7) * t38 + (S(0.014) * t45 + S(0.007) * (t46 + t58) - S(0.063) * t55);
  const S t64 = S(0.7) * t37 - (S(0.063) * t52 + (S(0.014) * (t58 + t47) - S(0.007) * t44));
  const S t65 = t3 * t63 - t4 * t64;
  const S t66 = t4 * t63 + t3 * t64;
  const S t67 = S(0.7) * t60 - (S(0.014) * t57 - S(0.007) * t59 - S(0.063) * (t46 + t47));
  const S t68 = t15 * (t7 * t65 + t16 * t66 + t17 * t67) + t14 * (t8 * t65 - t13 * t66 - t9 * t67);
  c[0] = t1 * t56 - t0 * (t4 * t61 - t3 * t62) - t68;
  c[1] = S(0.35) * t66 - t4 * t62 - t3 * t61;
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

// tori_mated: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "tori_mated". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "tori_mated_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::tori_mated {

// inverse_dynamics: 128 multiplications, 96 additions, 8 sin/cos/tan (reduced formulation; relative error 4.5e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // u2
  const S t0 = S(2.5535900500422257) - q2;
  const S q1 = q[1];  // v1
  const S q3 = q[3];  // v2
  const S q4 = q[4];  // turn
  const S angle[] = {q1, q3, q4, t0};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(u1)
  const S t2 = sine[0];
  const S t9 = qd0 * t2;
  const S t1 = cosine[0];
  const S t10 = qd0 * t1;
  const S qd1 = qd[1];  // d(v1)
  const S t11 = qd1 * t9;
  const S qdd0 = qdd[0];  // dd(u1)
  const S t12 = t11 - qdd0 * t1;
  const S t13 = qd0 * qd0;
  const S t14 = qdd0 - S(0.52) * (t11 + t12);
  const S qdd4 = qdd[4];  // dd(turn)
  const S t15 = qdd4 + (qdd0 * t2 + qd1 * t10);
  const S t5 = sine[2];
  const S t6 = cosine[2];
  const S t16 = t5 * t10 - qd1 * t6;
  const S t17 = t6 * t10 + qd1 * t5;
  const S t18 = S(9.81) * t2 - t1 * t13 - S(0.52) * (qd1 * qd1 + t10 * t10);
  const S qdd1 = qdd[1];  // dd(v1)
  const S t19 = S(0.52) * (qdd1 + t10 * t9) + (t2 * t13 + S(9.81) * t1);
  const S qd4 = qd[4];  // d(turn)
  const S t20 = qd4 + t9;
  const S t21 = t6 * t12 - qdd1 * t5 + qd4 * t16;
  const S qdd3 = qdd[3];  // dd(v2)
  const S t22 = qdd3 + (qd4 * t17 - (qdd1 * t6 + t5 * t12));
  const S qd3 = qd[3];  // d(v2)
  const S t23 = qd3 + t16;
  const S t4 = cosine[1];
  const S t3 = sine[1];
  const S t24 = t17 * t4 + t20 * t3;
  const S t25 = t20 * t4 - t3 * t17;
  const S t26 = qd3 * t24 - (t3 * t21 + t15 * t4);
  const S t27 = t3 * t15 - t21 * t4 + qd3 * t25;
  const S t28 = t6 * t19 - t5 * t14;
  const S t29 = t6 * t14 + t5 * t19 + S(0.7) * (t27 + t25 * t23);
  const S t8 = sine[3];
  const S t7 = cosine[3];
  const S t30 = t23 * t8 - t25 * t7;
  const S t31 = t25 * t8 + t23 * t7;
  const S t32 = t18 * t4 - t3 * t28 - S(0.7) * (t24 * t24 + t23 * t23);
  const S t33 = S(0.7) * (t25 * t24 - t22) + (t28 * t4 + t3 * t18);
  const S qd2 = qd[2];  // d(u2)
  const S t34 = qd2 + t24;
  const S t35 = t8 * t26 - t7 * t22 - qd2 * t30;
  const S t36 = qd2 * t31 - (t7 * t26 + t22 * t8);
  const S qdd2 = qdd[2];  // dd(u2)
  const S t37 = qdd2 + t27;
  const S t38 = t34 * t31;
  const S t39 = t30 * t34;
  const S t40 = t34 * t34;
  const S t41 = t30 * t31;
  const S t42 = t31 * t31;
  const S t43 = t30 * t30;
  const S t44 = t37 - t41;
  const S t45 = t37 + t41;
  const S t46 = t35 - t39;
  const S t47 = t35 + t39;
  const S t48 = t38 + t36;
  const S t49 = t38 - t36;
  const S t50 = t29 * t8 - t7 * t32;
  const S t51 = t7 * t29 + t8 * t32;
  const S t52 = S(0.088) * t51 + (S(0.515) * t48 + (S(0.04754890082042664) * t44 + S(0.03) * t46 + S(0.030508510792387603) * (t42 - t40)) - S(0.06852) * t49);
  const S t53 = S(0.088) * t50 - S(0.07932212806020776) * t33 - (S(0.06852) * t47 + (S(0.04754890082042664) * (t43 - t40) + (S(0.03) * t48 - S(0.030508510792387603) * t45)) + S(0.55786) * t46);
  const S t54 = S(0.088) * t47 - S(0.07932212806020776) * (t42 + t40) - S(2.2) * t50;
  const S t55 = S(0.07932212806020776) * t51 + (S(0.515) * t45 + (S(0.55786) * t44 - (S(0.03) * (t43 - t42) + (S(0.030508510792387603) * t47 + S(0.04754890082042664) * t49))));
  tau[2] = t55;
  const S t56 = S(0.088) * t49 - S(0.07932212806020776) * t44 - S(2.2) * t51;
  const S t57 = S(0.088) * (t43 + t42) + S(0.07932212806020776) * t46 + S(2.2) * t33;
  const S t58 = t7 * t56 + t54 * t8;
  const S t59 = t3 * (t7 * t54 - t56 * t8) - t57 * t4;
  const S t60 = t55 - S(0.7) * t58;
  const S t61 = S(0.7) * t57 - (t53 * t7 - t52 * t8);
  const S t62 = t53 * t8 + t52 * t7;
  const S t63 = t3 * t62 - t60 * t4;
  const S t64 = t3 * t60 + t4 * t62;
  tau[4] = t64;
  const S t65 = t5 * t59 - t6 * t58;
  tau[0] = t65 + (t2 * t64 + (S(0.52) * t65 - (t5 * t61 + t6 * t63)) * t1);
  tau[1] = S(-0.52) * (t5 * t58 + t6 * t59) - (t5 * t63 - t6 * t61);
  tau[3] = -t61;
}

// mass_matrix: 74 multiplications, 67 additions, 8 sin/cos/tan (reduced formulation; relative error 1.1e-15 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // u2
  const S t0 = S(2.5535900500422257) - q2;
  const S q1 = q[1];  // v1
  const S q3 = q[3];  // v2
  const S q4 = q[4];  // turn
  const S angle[] = {q1, q3, q4, t0};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S t7 = cosine[3];
  const S t8 = sine[3];
  const S t9 = S(0.06) * t7 - S(0.04286) * t8;
  const S t10 = t9 * t8;
  const S t11 = S(0.04754890082042664) * t7 + S(0.030508510792387603) * t8;
  const S t12 = S(0.11105097928429086) * t7 + (t10 + S(0.55786));
  const S t13 = S(0.05552548964214543) * t8 + (S(0.03) - t7 * t9);
  const S t14 = t11 + S(0.0616);
  const S t3 = sine[1];
  const S t15 = t3 * t14;
  const S t4 = cosine[1];
  const S t16 = t15 + t15 - (t12 + S(1.00948)) * t4;
  const S t17 = S(0.04754890082042664) * t8 - S(0.030508510792387603) * t7;
  const S t18 = S(0.07932212806020776) * t7;
  const S t19 = S(0.515) - t10;
  const S t20 = t18 + S(1.54);
  const S t21 = t3 * t13 + t17 * t4;
  const S t22 = t4 * t16;
  const S t23 = t14 - t3 * t16;
  const S t24 = t12 + S(1.078) + t22;
  const S t25 = t13 * t4 - t3 * t17;
  M[19] = t25;
  M[23] = t25;
  const S t26 = S(0.07932212806020776) * t8;
  const S t27 = t3 * t20 + S(0.088) * t4;
  const S t28 = t20 * t4 - S(0.088) * t3;
  const S t29 = S(1.04) * t28 - t22 + S(0.6634);
  const S t6 = cosine[2];
  const S t30 = t6 * t21;
  const S t5 = sine[2];
  const S t31 = t30 + t30 + t5 * (t19 - t24);
  const S t32 = t5 * t26 + t6 * t27;
  const S t33 = t5 * t25 + t6 * t23 + S(0.52) * t32;
  const S t34 = t5 * t31;
  const S t35 = t5 * t23 - t25 * t6 - S(0.52) * (t26 * t6 - t5 * t27);
  M[9] = t35;
  M[21] = t35;
  const S t36 = t24 + t34;
  const S t37 = t26 * t3;
  const S t38 = S(0.05552548964214543) * t7 + S(1.07286);
  const S t2 = sine[0];
  const S t39 = t2 * t33;
  const S t40 = t3 * t11 - t38 * t4;
  const S t41 = t11 * t4 + t3 * t38;
  M[14] = t41;
  M[22] = t41;
  const S t42 = t6 * t18 + t5 * t37;
  const S t1 = cosine[0];
  const S t43 = t42 - (t1 * (t6 * t40 + t5 * t17 - S(0.52) * t42) - t2 * t41);
  M[2] = t43;
  M[10] = t43;
  const S t44 = S(0.52) * (t5 * t18 - t6 * t37) - (t5 * t40 - t6 * t17);
  M[7] = t44;
  M[11] = t44;
  const S t45 = t12 + S(1.14652);
  M[18] = t45;
  const S t46 = t2 * t32 + (t28 + S(1.144)) * t1;
  M[0] = t19 - t34 + (t36 - t1 * (t1 * (t36 - t29) - (t39 + t39)) + (t46 + t46) + S(2.2));
  const S t48 = t19 + t24;
  M[24] = t48;
  const S t49 = t32 + (t2 * t48 + t33 * t1);
  M[4] = t49;
  M[20] = t49;
  const S t50 = t5 * t28;
  const S t51 = t25 * t2 + (t5 * t45 - t30 + S(0.52) * t50) * t1 + t50;
  M[3] = t51;
  M[15] = t51;
  const S t52 = t6 * (S(-0.52) * t28 - t45) - t5 * t21;
  M[8] = t52;
  M[16] = t52;
  const S t53 = t35 * t2 - (t21 - t6 * t31) * t1;
  M[1] = t53;
  M[5] = t53;
  M[6] = t36 + t29;
  const S t55 = -t17;
  M[13] = t55;
  M[17] = t55;
  M[12] = S(1.07286);
}

// bias: 123 multiplications, 86 additions, 8 sin/cos/tan (reduced formulation; relative error 3.8e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // u2
  const S t0 = S(2.5535900500422257) - q2;
  const S q1 = q[1];  // v1
  const S q3 = q[3];  // v2
  const S q4 = q[4];  // turn
  const S angle[] = {q1, q3, q4, t0};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(u1)
  const S t1 = cosine[0];
  const S t9 = qd0 * t1;
  const S t2 = sine[0];
  const S t10 = qd0 * t2;
  const S t11 = qd0 * qd0;
  const S qd1 = qd[1];  // d(v1)
  const S t12 = qd1 * t10;
  const S t6 = sine[2];
  const S t5 = cosine[2];
  const S t13 = t6 * t9 - qd1 * t5;
  const S t14 = t5 * t9 + qd1 * t6;
  const S t15 = t5 * t12;
  const S qd4 = qd[4];  // d(turn)
  const S t16 = t15 + qd4 * t13;
  const S t17 = qd4 + t10;
  const S t18 = S(0.52) * (t9 * t10) + (t2 * t11 + S(9.81) * t1);
  const S t19 = S(9.81) * t2 - t1 * t11 - S(0.52) * (qd1 * qd1 + t9 * t9);
  const S t20 = qd1 * t9;
  const S t21 = t6 * t12;
  const S t22 = qd4 * t14 - t21;
  const S qd3 = qd[3];  // d(v2)
  const S t23 = qd3 + t13;
  const S t24 = t5 * t18 + S(1.04) * t21;
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t25 = t14 * t3 + t17 * t4;
  const S t26 = t17 * t3 - t4 * t14;
  const S t27 = qd3 * t25 - (t16 * t4 + t20 * t3);
  const S t28 = t16 * t3 - t4 * t20 - qd3 * t26;
  const S t29 = t6 * t18 - S(1.04) * t15 - S(0.7) * (t28 - t26 * t23);
  const S t30 = S(0.7) * (t25 * t25 + t23 * t23) - (t19 * t3 - t4 * t24);
  const S t31 = t24 * t3 + t4 * t19 + S(0.7) * (t26 * t25 - t22);
  const S qd2 = qd[2];  // d(u2)
  const S t32 = qd2 + t25;
  const S t7 = sine[3];
  const S t8 = cosine[3];
  const S t33 = t23 * t7 - t26 * t8;
  const S t34 = t26 * t7 + t23 * t8;
  const S t35 = t27 * t7 - t8 * t22 - qd2 * t33;
  const S t36 = t8 * t27 + t7 * t22 - qd2 * t34;
  const S t37 = t33 * t34;
  const S t38 = t33 * t32;
  const S t39 = t33 * t33;
  const S t40 = t32 * t34;
  const S t41 = t34 * t34;
  const S t42 = t32 * t32;
  const S t43 = t40 - t36;
  const S t44 = t40 + t36;
  const S t45 = t38 - t35;
  const S t46 = t38 + t35;
  const S t47 = t28 + t37;
  const S t48 = t28 - t37;
  const S t49 = t29 * t7 + t8 * t30;
  const S t50 = t7 * t30 - t29 * t8;
  const S t51 = S(0.06852) * t44 - (S(0.515) * t43 + (S(0.030508510792387603) * (t41 - t42) - (S(0.03) * t45 + S(0.04754890082042664) * t47))) + S(0.088) * t50;
  const S t52 = S(0.55786) * t45 - (S(0.04754890082042664) * (t39 - t42) + (S(0.030508510792387603) * t48 + S(0.03) * t43) + S(0.06852) * t46) + (S(0.088) * t49 - S(0.07932212806020776) * t31);
  const S t53 = S(2.2) * t49 - (S(0.088) * t46 - S(0.07932212806020776) * (t41 + t42));
  const S t54 = S(-0.55786) * t47 - (S(0.03) * (t39 - t41) + (S(0.030508510792387603) * t46 + S(0.04754890082042664) * t44)) - S(0.515) * t48 - S(0.07932212806020776) * t50;
  c[2] = t54;
  const S t55 = S(0.07932212806020776) * t47 + S(0.088) * t44 + S(2.2) * t50;
  const S t56 = S(2.2) * t31 + (S(0.088) * (t39 + t41) - S(0.07932212806020776) * t45);
  const S t57 = t7 * t53 - t8 * t55;
  const S t58 = t56 * t3 + t4 * (t8 * t53 + t55 * t7);
  const S t59 = S(0.7) * t57 + t54;
  const S t60 = S(0.7) * t56 - (t51 * t7 + t8 * t52);
  const S t61 = t8 * t51 - t52 * t7;
  const S t62 = t59 * t3 + t4 * t61;
  const S t63 = t3 * t61 - t4 * t59;
  const S t64 = t5 * t57 - t6 * t58;
  c[1] = S(0.52) * (t5 * t58 + t6 * t57) + (t6 * t62 + t5 * t60);
  c[0] = t64 + ((S(0.52) * t64 + (t5 * t62 - t6 * t60)) * t1 - t2 * t63);
  c[3] = -t60;
  c[4] = -t63;
}

// mass_matrix_and_bias: 197 multiplications, 153 additions, 8 sin/cos/tan (reduced formulation; relative error 1.1e-15 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q2 = q[2];  // u2
  const S t0 = S(2.5535900500422257) - q2;
  const S q1 = q[1];  // v1
  const S q3 = q[3];  // v2
  const S q4 = q[4];  // turn
  const S angle[] = {q1, q3, q4, t0};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(u1)
  const S t1 = cosine[0];
  const S t9 = qd0 * t1;
  const S t2 = sine[0];
  const S t10 = qd0 * t2;
  const S t11 = qd0 * qd0;
  const S qd1 = qd[1];  // d(v1)
  const S t12 = qd1 * t10;
  const S t5 = sine[2];
  const S t6 = cosine[2];
  const S t13 = t5 * t9 - qd1 * t6;
  const S t14 = t6 * t9 + qd1 * t5;
  const S t15 = t6 * t12;
  const S qd4 = qd[4];  // d(turn)
  const S t16 = t15 + qd4 * t13;
  const S t17 = qd4 + t10;
  const S t18 = S(0.52) * (t9 * t10) + (t2 * t11 + S(9.81) * t1);
  const S t19 = S(9.81) * t2 - t1 * t11 - S(0.52) * (qd1 * qd1 + t9 * t9);
  const S t20 = qd1 * t9;
  const S t21 = t5 * t12;
  const S t22 = qd4 * t14 - t21;
  const S qd3 = qd[3];  // d(v2)
  const S t23 = qd3 + t13;
  const S t24 = t6 * t18 + S(1.04) * t21;
  const S t4 = cosine[1];
  const S t3 = sine[1];
  const S t25 = t14 * t4 + t17 * t3;
  const S t26 = t17 * t4 - t3 * t14;
  const S t27 = qd3 * t25 - (t16 * t3 + t20 * t4);
  const S t28 = t16 * t4 - t3 * t20 - qd3 * t26;
  const S t29 = t5 * t18 - S(1.04) * t15 - S(0.7) * (t28 - t26 * t23);
  const S t7 = cosine[3];
  const S t8 = sine[3];
  const S t30 = S(0.06) * t7 - S(0.04286) * t8;
  const S t31 = t30 * t8;
  const S t32 = S(0.04754890082042664) * t7 + S(0.030508510792387603) * t8;
  const S t33 = t23 * t8 - t26 * t7;
  const S t34 = t26 * t8 + t23 * t7;
  const S t35 = S(0.11105097928429086) * t7 + (t31 + S(0.55786));
  const S t36 = S(0.05552548964214543) * t8 + (S(0.03) - t7 * t30);
  const S t37 = S(0.7) * (t25 * t25 + t23 * t23) - (t19 * t4 - t3 * t24);
  const S t38 = t24 * t4 + t3 * t19 + S(0.7) * (t26 * t25 - t22);
  const S qd2 = qd[2];  // d(u2)
  const S t39 = qd2 + t25;
  const S t40 = t27 * t8 - t7 * t22 - qd2 * t33;
  const S t41 = t7 * t27 + t8 * t22 - qd2 * t34;
  const S t42 = t33 * t34;
  const S t43 = t33 * t39;
  const S t44 = t33 * t33;
  const S t45 = t39 * t34;
  const S t46 = t34 * t34;
  const S t47 = t39 * t39;
  const S t48 = t32 + S(0.0616);
  const S t49 = t3 * t48;
  const S t50 = t49 + t49 - (t35 + S(1.00948)) * t4;
  const S t51 = t45 - t41;
  const S t52 = t45 + t41;
  const S t53 = t43 - t40;
  const S t54 = t43 + t40;
  const S t55 = t28 + t42;
  const S t56 = t28 - t42;
  const S t57 = t4 * t50;
  const S t58 = t48 - t3 * t50;
  const S t59 = t35 + S(1.078) + t57;
  const S t60 = S(0.04754890082042664) * t8 - S(0.030508510792387603) * t7;
  const S t61 = S(0.07932212806020776) * t7;
  const S t62 = t61 + S(1.54);
  const S t63 = t29 * t8 + t7 * t37;
  const S t64 = t8 * t37 - t29 * t7;
  const S t65 = t3 * t36 + t60 * t4;
  const S t66 = t36 * t4 - t3 * t60;
  M[19] = t66;
  M[23] = t66;
  const S t67 = t3 * t62 + S(0.088) * t4;
  const S t68 = t62 * t4 - S(0.088) * t3;
  const S t69 = S(2.2) * t63 - (S(0.088) * t54 - S(0.07932212806020776) * (t46 + t47));
  const S t70 = S(0.55786) * t53 - (S(0.04754890082042664) * (t44 - t47) + (S(0.030508510792387603) * t56 + S(0.03) * t51) + S(0.06852) * t54) + (S(0.088) * t63 - S(0.07932212806020776) * t38);
  const S t71 = S(0.06852) * t52 - (S(0.515) * t51 + (S(0.030508510792387603) * (t46 - t47) - (S(0.03) * t53 + S(0.04754890082042664) * t55))) + S(0.088) * t64;
  const S t72 = S(-0.55786) * t55 - (S(0.03) * (t44 - t46) + (S(0.030508510792387603) * t54 + S(0.04754890082042664) * t52)) - S(0.515) * t56 - S(0.07932212806020776) * t64;
  c[2] = t72;
  const S t73 = S(0.07932212806020776) * t55 + S(0.088) * t52 + S(2.2) * t64;
  const S t74 = S(2.2) * t38 + (S(0.088) * (t44 + t46) - S(0.07932212806020776) * t53);
  const S t75 = S(0.515) - t31;
  const S t76 = S(0.07932212806020776) * t8;
  const S t77 = t8 * t69 - t7 * t73;
  const S t78 = t74 * t4 + t3 * (t7 * t69 + t73 * t8);
  const S t79 = S(0.7) * t77 + t72;
  const S t80 = t6 * t65;
  const S t81 = t80 + t80 + t5 * (t75 - t59);
  const S t82 = t5 * t76 + t6 * t67;
  const S t83 = t5 * t81;
  const S t84 = S(0.05552548964214543) * t7 + S(1.07286);
  const S t85 = t5 * t66 + t6 * t58 + S(0.52) * t82;
  const S t86 = t5 * t58 - t66 * t6 - S(0.52) * (t76 * t6 - t5 * t67);
  M[9] = t86;
  M[21] = t86;
  const S t87 = t59 + t83;
  const S t88 = t76 * t3;
  const S t89 = S(1.04) * t68 - t57 + S(0.6634);
  const S t90 = t7 * t71 - t70 * t8;
  const S t91 = S(0.7) * t74 - (t71 * t8 + t7 * t70);
  const S t92 = t79 * t4 + t3 * t90;
  const S t93 = t4 * t90 - t3 * t79;
  const S t94 = t3 * t32 - t84 * t4;
  const S t95 = t32 * t4 + t3 * t84;
  M[14] = t95;
  M[22] = t95;
  const S t96 = t2 * t85;
  const S t97 = t2 * t82 + (t68 + S(1.144)) * t1;
  M[0] = t75 - t83 + (t87 - t1 * (t1 * (t87 - t89) - (t96 + t96)) + (t97 + t97) + S(2.2));
  const S t99 = t35 + S(1.14652);
  M[18] = t99;
  const S t100 = t5 * t68;
  const S t101 = t66 * t2 + (t5 * t99 - t80 + S(0.52) * t100) * t1 + t100;
  M[3] = t101;
  M[15] = t101;
  const S t102 = t6 * (S(-0.52) * t68 - t99) - t5 * t65;
  M[8] = t102;
  M[16] = t102;
  const S t103 = t6 * t61 + t5 * t88;
  const S t104 = t103 - (t1 * (t6 * t94 + t5 * t60 - S(0.52) * t103) - t2 * t95);
  M[2] = t104;
  M[10] = t104;
  const S t105 = S(0.52) * (t5 * t61 - t6 * t88) - (t5 * t94 - t6 * t60);
  M[7] = t105;
  M[11] = t105;
  const S t106 = t6 * t77 - t5 * t78;
  c[1] = S(0.52) * (t6 * t78 + t5 * t77) + (t5 * t92 + t6 * t91);
  c[0] = t106 + ((S(0.52) * t106 + (t6 * t92 - t5 * t91)) * t1 - t2 * t93);
  const S t109 = t86 * t2 - (t65 - t6 * t81) * t1;
  M[1] = t109;
  M[5] = t109;
  const S t110 = t75 + t59;
  M[24] = t110;
  const S t111 = t82 + (t2 * t110 + t85 * t1);
  M[4] = t111;
  M[20] = t111;
  M[6] = t87 + t89;
  c[3] = -t91;
  c[4] = -t93;
  const S t115 = -t60;
  M[13] = t115;
  M[17] = t115;
  M[12] = S(1.07286);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(u1)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(v1)
  qdot[1] = qd1;
  const S qd2 = qd[2];  // d(u2)
  qdot[2] = qd2;
  const S qd3 = qd[3];  // d(v2)
  qdot[3] = qd3;
  const S qd4 = qd[4];  // d(turn)
  qdot[4] = qd4;
}

// energy: 68 multiplications, 43 additions, 8 sin/cos/tan (reduced formulation; relative error 2.4e-15 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  S sine[4], cosine[4];
  sines_and_cosines(4, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(u1)
  const S t0 = cosine[0];
  const S t8 = qd0 * t0;
  const S t9 = qd0 - t8;
  const S t1 = sine[0];
  const S qd4 = qd[4];  // d(turn)
  const S t10 = qd4 + qd0 * t1;
  const S qd1 = qd[1];  // d(v1)
  const S t6 = sine[3];
  const S t11 = qd1 * t6;
  const S t7 = cosine[3];
  const S t12 = qd1 * t7;
  const S t13 = t7 * t8 + t11;
  const S t14 = t6 * t8 - t12;
  const S t15 = S(1.52) * t14 + (t6 * t9 + t12);
  const S qd3 = qd[3];  // d(v2)
  const S t16 = qd3 + t14;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t17 = t10 * t4 - t5 * t13;
  const S t18 = t13 * t4 + t10 * t5;
  const S t19 = S(0.7) * t18 - (t11 - t7 * t9 - S(1.52) * t13);
  const S t20 = t7 * t0;
  const S t21 = t6 * t0;
  const S t22 = t5 * t20 - t1 * t4;
  const S t23 = t5 * t15;
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t24 = S(0.02) * (t22 * t2 + t21 * t3) + S(0.03) * (t2 * t21 - t22 * t3) + S(0.04) * (t20 * t4 + t5 * t1);
  const S t25 = S(0.7) * t16 + t15 * t4;
  const S t26 = t2 * t16 + t17 * t3;
  const S t27 = t16 * t3 - t2 * t17;
  const S qd2 = qd[2];  // d(u2)
  const S t28 = qd2 + t18;
  e[1] = S(-21.582) * (S(0.7) * t22 - S(0.52) * t1 + t24);
  const S t30 = t2 * t23 - t3 * t19;
  const S t31 = t3 * t23 + t2 * t19;
  const S t32 = (S(1.07286) * t28 - (S(0.02264) * t26 + S(0.05176) * t27)) * t28;
  const S t33 = S(0.5) * (t26 * (S(0.02264) * t28 - (S(0.6244) * t26 - S(0.03132) * t27)) + t27 * (S(0.03132) * t26 - S(0.5855) * t27 + S(0.05176) * t28) - t32);
  const S t34 = S(1.1) * (t25 * t25 + (t30 * t30 + t31 * t31));
  e[0] = (S(0.044) * t26 - S(0.066) * t27) * t25 + (t30 * (S(0.066) * t28 - S(0.088) * t26) + (S(0.044) * t28 - S(0.088) * t27) * t31) + t34 - t33;
}

// body_poses: 44 multiplications, 21 additions, 10 sin/cos/tan (reduced formulation; relative error 1.4e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t2 = sine[1];
  const S t0 = cosine[0];
  const S t10 = t2 * t0;
  const S t1 = sine[0];
  const S t11 = t2 * t1;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  const S t12 = t9 * t10 - t8 * t1;
  const S t13 = t8 * t0 + t11 * t9;
  const S t14 = t8 * t10 + t9 * t1;
  const S t15 = t9 * t0 - t8 * t11;
  const S t3 = cosine[1];
  const S t16 = t9 * t3;
  const S t17 = t0 * t3;
  const S t18 = t1 * t3;
  const S t19 = t8 * t3;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t20 = t6 * t13 + t18 * t7;
  const S t21 = t6 * t12 + t7 * t17;
  W[3] = t0 + (S(0.7) * t21 + S(0.52) * t17);
  W[2] = t12 * t7 - t6 * t17;
  W[7] = t1 + S(0.52) * t18 + S(0.7) * t20;
  W[6] = t13 * t7 - t6 * t18;
  const S t26 = t6 * t16 - t2 * t7;
  W[10] = -(t16 * t7 + t6 * t2);
  W[11] = S(0.52) * t2 - S(0.7) * t26;
  const S t4 = sine[2];
  const S t5 = cosine[2];
  W[4] = -(t4 * t15 + t5 * t20);
  W[5] = t5 * t15 - t4 * t20;
  W[1] = -(t14 * t5 + t4 * t21);
  W[0] = t4 * t14 - t5 * t21;
  W[8] = t26 * t5 - t4 * t19;
  W[9] = t26 * t4 + t19 * t5;
}

}  // namespace alembert::mechanisms::tori_mated

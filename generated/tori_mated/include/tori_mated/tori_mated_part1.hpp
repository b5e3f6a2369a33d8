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

// inverse_dynamics: 128 multiplications, 96 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t1 = sine[0];
  const S t9 = qd0 * t1;
  const S qd1 = qd[1];  // d(v1)
  const S t10 = t9 * qd1;
  const S qdd0 = qdd[0];  // dd(u1)
  const S t2 = cosine[0];
  const S t11 = t10 - qdd0 * t2;
  const S t12 = qdd0 - S(0.52) * (t10 + t11);
  const S t5 = cosine[2];
  const S t13 = qd0 * t2;
  const S qdd1 = qdd[1];  // dd(v1)
  const S t14 = qd0 * qd0;
  const S t15 = S(0.52) * (qdd1 + t9 * t13) + (t1 * t14 + S(9.81) * t2);
  const S t6 = sine[2];
  const S qdd4 = qdd[4];  // dd(turn)
  const S t16 = qdd4 + (qdd0 * t1 + qd1 * t13);
  const S t3 = sine[1];
  const S t17 = t6 * t13 - t5 * qd1;
  const S qd4 = qd[4];  // d(turn)
  const S t18 = t5 * t11 - t6 * qdd1 + qd4 * t17;
  const S t4 = cosine[1];
  const S t19 = t9 + qd4;
  const S t20 = t5 * t13 + qd1 * t6;
  const S t21 = t4 * t19 - t3 * t20;
  const S qd3 = qd[3];  // d(v2)
  const S t22 = t3 * t16 - t4 * t18 + t21 * qd3;
  const S t23 = t17 + qd3;
  const S t24 = t5 * t12 + t6 * t15 + S(0.7) * (t22 + t21 * t23);
  const S t7 = sine[3];
  const S t25 = S(9.81) * t1 - t2 * t14 - S(0.52) * (qd1 * qd1 + t13 * t13);
  const S t26 = t5 * t15 - t12 * t6;
  const S t27 = t4 * t20 + t3 * t19;
  const S t28 = t4 * t25 - t3 * t26 - S(0.7) * (t27 * t27 + t23 * t23);
  const S t8 = cosine[3];
  const S t29 = t7 * t24 - t8 * t28;
  const S qd2 = qd[2];  // d(u2)
  const S t30 = t27 + qd2;
  const S t31 = t30 * t30;
  const S t32 = t7 * t21 + t23 * t8;
  const S t33 = t32 * t32;
  const S t34 = qd3 * t27 - (t3 * t18 + t16 * t4);
  const S qdd3 = qdd[3];  // dd(v2)
  const S t35 = qdd3 + (qd4 * t20 - (t5 * qdd1 + t11 * t6));
  const S t36 = t7 * t23 - t21 * t8;
  const S t37 = t7 * t34 - t8 * t35 - qd2 * t36;
  const S t38 = t30 * t36;
  const S t39 = t37 + t38;
  const S t40 = S(2.2) * t29 + (S(0.07932212806020777) * (t31 + t33) - S(0.088) * t39);
  const S t41 = t30 * t32;
  const S t42 = qd2 * t32 - (t8 * t34 + t7 * t35);
  const S t43 = t41 - t42;
  const S qdd2 = qdd[2];  // dd(u2)
  const S t44 = t22 + qdd2;
  const S t45 = t32 * t36;
  const S t46 = t44 - t45;
  const S t47 = t24 * t8 + t7 * t28;
  const S t48 = S(0.088) * t43 - S(0.07932212806020777) * t46 - S(2.2) * t47;
  const S t49 = t7 * t40 - t8 * t48;
  const S t50 = S(0.7) * (t35 - t21 * t27) - (t4 * t26 + t3 * t25);
  const S t51 = t36 * t36;
  const S t52 = t37 - t38;
  const S t53 = S(2.2) * t50 - (S(0.088) * (t33 + t51) + S(0.07932212806020777) * t52);
  const S t54 = t3 * (t8 * t40 + t7 * t48) - t4 * t53;
  const S t55 = t5 * t49 - t6 * t54;
  const S t56 = t41 + t42;
  const S t57 = t44 + t45;
  const S t58 = S(0.07932212806020777) * t50 + S(0.088) * t29 - (S(0.5578600000000001) * t52 - (S(0.04754890082042665) * (t31 - t51) - (S(0.029999999999999943) * t56 - S(0.030508510792387606) * t57) - S(0.06852000000000014) * t39));
  const S t59 = S(0.088) * t47 - (S(0.030508510792387606) * (t31 - t33) - (S(0.029999999999999916) * t52 + S(0.04754890082042665) * t46) - S(0.5150000000000001) * t56 + S(0.06852000000000014) * t43);
  const S t60 = t7 * t58 + t8 * t59;
  const S t61 = S(0.5150000000000001) * t57 + (S(0.5578600000000001) * t46 - (S(0.030508510792387606) * t39 + S(0.04754890082042665) * t43 - S(0.029999999999999916) * (t33 - t51))) + S(0.07932212806020777) * t47;
  tau[2] = t61;
  const S t62 = S(0.7) * t49 + t61;
  const S t63 = t3 * t60 - t4 * t62;
  const S t64 = t7 * t59 - t8 * t58 - S(0.7) * t53;
  const S t65 = t3 * t62 + t4 * t60;
  tau[4] = t65;
  tau[0] = t55 - (t2 * (t5 * t63 + t6 * t64 - S(0.52) * t55) - t1 * t65);
  tau[1] = S(0.52) * (t5 * t54 + t6 * t49) - (t6 * t63 - t5 * t64);
  tau[3] = -t64;
}

// mass_matrix: 74 multiplications, 67 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t3 = sine[1];
  const S t7 = cosine[3];
  const S t9 = S(0.07932212806020777) * t7;
  const S t10 = t9 + S(1.54);
  const S t4 = cosine[1];
  const S t11 = S(0.088) * t3 - t10 * t4;
  const S t1 = cosine[0];
  const S t8 = sine[3];
  const S t12 = S(0.07932212806020777) * t8;
  const S t5 = sine[2];
  const S t13 = S(0.088) * t4 + t3 * t10;
  const S t6 = cosine[2];
  const S t14 = t5 * t12 + t6 * t13;
  const S t2 = sine[0];
  const S t15 = (S(1.1440000000000001) - t11) * t1 + t2 * t14;
  const S t16 = S(0.05999999999999983) * t7 - S(0.04286000000000001) * t8;
  const S t17 = t8 * t16;
  const S t18 = S(0.11105097928429088) * t7 + (t17 + S(0.5578600000000001));
  const S t19 = S(0.030508510792387606) * t8 + S(0.04754890082042665) * t7;
  const S t20 = t19 + S(0.061599999999999995);
  const S t21 = t3 * t20;
  const S t22 = t4 * (t18 + S(1.0094799999999997)) - (t21 + t21);
  const S t23 = t4 * t22;
  const S t24 = t23 - (t18 + S(1.0779999999999998));
  const S t25 = S(0.030508510792387606) * t7 - S(0.04754890082042665) * t8;
  M[13] = t25;
  M[17] = t25;
  const S t26 = S(0.029999999999999916) - t7 * t16 + S(0.05552548964214544) * t8;
  const S t27 = t4 * t25 - t3 * t26;
  const S t28 = t6 * t27;
  const S t29 = S(0.5150000000000001) - t17;
  const S t30 = t28 + t28 - t5 * (t24 + t29);
  const S t31 = t5 * t30;
  const S t32 = t24 + t31;
  const S t33 = t4 * t26 + t3 * t25;
  M[19] = t33;
  M[23] = t33;
  const S t34 = t20 + t3 * t22;
  const S t35 = S(0.52) * t14 + (t5 * t33 + t6 * t34);
  const S t36 = t2 * t35;
  const S t37 = t23 - S(1.04) * t11 + S(0.6634000000000002);
  M[0] = t15 + t15 - (t32 - t1 * (t36 + t36 + t1 * (t32 + t37))) + S(2.2) + (t29 + t31);
  const S t39 = S(0.52) * (t5 * t13 - t12 * t6) - (t6 * t33 - t5 * t34);
  M[9] = t39;
  M[21] = t39;
  const S t40 = t1 * (t27 - t6 * t30) + t2 * t39;
  M[1] = t40;
  M[5] = t40;
  const S t41 = t3 * t12;
  const S t42 = t5 * t41 + t9 * t6;
  const S t43 = S(0.05552548964214544) * t7 + S(1.0728600000000004);
  const S t44 = t4 * t43 - t3 * t19;
  const S t45 = t3 * t43 + t4 * t19;
  M[14] = t45;
  M[22] = t45;
  const S t46 = t42 + (t1 * (t5 * t25 + t6 * t44 + S(0.52) * t42) + t2 * t45);
  M[2] = t46;
  M[10] = t46;
  const S t47 = t11 * t5;
  const S t48 = t18 + S(1.14652);
  M[18] = t48;
  const S t49 = t2 * t33 - t1 * (S(0.52) * t47 - (t28 + t5 * t48)) - t47;
  M[3] = t49;
  M[15] = t49;
  const S t50 = t24 - t29;
  const S t51 = t14 + (t1 * t35 - t2 * t50);
  M[4] = t51;
  M[20] = t51;
  M[6] = t37 - t32;
  const S t53 = t5 * t44 - t6 * t25 - S(0.52) * (t6 * t41 - t9 * t5);
  M[7] = t53;
  M[11] = t53;
  const S t54 = t5 * t27 - t6 * (t48 - S(0.52) * t11);
  M[8] = t54;
  M[16] = t54;
  M[24] = -t50;
  M[12] = S(1.0728600000000004);
}

// bias: 123 multiplications, 86 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t5 = sine[2];
  const S qd1 = qd[1];  // d(v1)
  const S qd0 = qd[0];  // d(u1)
  const S t1 = cosine[0];
  const S t9 = qd0 * t1;
  const S t6 = cosine[2];
  const S t10 = t5 * qd1 + t9 * t6;
  const S t4 = sine[1];
  const S t2 = sine[0];
  const S t11 = qd0 * t2;
  const S qd4 = qd[4];  // d(turn)
  const S t12 = qd4 + t11;
  const S t3 = cosine[1];
  const S t13 = t4 * t10 - t3 * t12;
  const S t14 = t3 * t10 + t4 * t12;
  const S t15 = qd1 * t11;
  const S t16 = t5 * t15;
  const S t17 = t16 - t10 * qd4;
  const S t18 = qd0 * qd0;
  const S t19 = t2 * t18 + S(9.81) * t1 + S(0.52) * (t9 * t11);
  const S t20 = S(1.04) * t16 + t6 * t19;
  const S t21 = t1 * t18 - S(9.81) * t2 + S(0.52) * (qd1 * qd1 + t9 * t9);
  const S t22 = S(0.7) * (t13 * t14 - t17) - (t3 * t20 - t4 * t21);
  const S t7 = cosine[3];
  const S t23 = t5 * t9 - qd1 * t6;
  const S qd3 = qd[3];  // d(v2)
  const S t24 = qd3 + t23;
  const S t8 = sine[3];
  const S t25 = t13 * t7 + t8 * t24;
  const S qd2 = qd[2];  // d(u2)
  const S t26 = t14 + qd2;
  const S t27 = t25 * t26;
  const S t28 = qd1 * t9;
  const S t29 = t6 * t15;
  const S t30 = qd4 * t23 + t29;
  const S t31 = t3 * t28 + t4 * t30 - t14 * qd3;
  const S t32 = t17 * t7 - t8 * t31 - t25 * qd2;
  const S t33 = t27 - t32;
  const S t34 = t7 * t24 - t13 * t8;
  const S t35 = t34 * t34;
  const S t36 = t25 * t25;
  const S t37 = S(2.2) * t22 + (S(0.07932212806020777) * t33 - S(0.088) * (t35 + t36));
  const S t38 = t4 * t28 - t3 * t30 - t13 * qd3;
  const S t39 = t5 * t19 - S(1.04) * t29 - S(0.7) * (t13 * t24 - t38);
  const S t40 = t3 * t21 + t4 * t20 + S(0.7) * (t14 * t14 + t24 * t24);
  const S t41 = t8 * t39 + t7 * t40;
  const S t42 = t26 * t26;
  const S t43 = t27 + t32;
  const S t44 = S(2.2) * t41 + (S(0.07932212806020777) * (t35 + t42) - S(0.088) * t43);
  const S t45 = t7 * t39 - t8 * t40;
  const S t46 = t7 * t31 + t17 * t8 + qd2 * t34;
  const S t47 = t26 * t34;
  const S t48 = t46 - t47;
  const S t49 = t25 * t34;
  const S t50 = t38 - t49;
  const S t51 = S(2.2) * t45 + (S(0.088) * t48 + S(0.07932212806020777) * t50);
  const S t52 = t3 * t37 - t4 * (t7 * t44 - t8 * t51);
  const S t53 = t7 * t51 + t8 * t44;
  const S t54 = t5 * t52 + t6 * t53;
  const S t55 = t46 + t47;
  const S t56 = S(0.088) * t45 + (S(0.06852000000000014) * t48 + (S(0.5150000000000001) * t55 + (S(0.030508510792387606) * (t35 - t42) - (S(0.029999999999999916) * t33 - S(0.04754890082042665) * t50))));
  const S t57 = t38 + t49;
  const S t58 = S(0.5578600000000001) * t33 + (S(0.030508510792387606) * t57 - S(0.029999999999999943) * t55 - S(0.04754890082042665) * (t36 - t42) - S(0.06852000000000014) * t43) + (S(0.07932212806020777) * t22 + S(0.088) * t41);
  const S t59 = t7 * t56 + t8 * t58;
  const S t60 = S(0.5150000000000001) * t57 + (S(0.5578600000000001) * t50 + (S(0.029999999999999916) * (t35 - t36) - (S(0.030508510792387606) * t43 - S(0.04754890082042665) * t48))) + S(0.07932212806020777) * t45;
  c[2] = t60;
  const S t61 = t60 + S(0.7) * t53;
  const S t62 = t3 * t59 + t4 * t61;
  c[4] = t62;
  const S t63 = t3 * t61 - t4 * t59;
  const S t64 = t7 * t58 - t8 * t56 + S(0.7) * t37;
  c[3] = t64;
  c[0] = t54 + (t2 * t62 + t1 * (t6 * t63 + t5 * t64 + S(0.52) * t54));
  c[1] = t5 * t63 - t6 * t64 + S(0.52) * (t5 * t53 - t6 * t52);
}

// mass_matrix_and_bias: 197 multiplications, 153 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t7 = sine[3];
  const S t8 = cosine[3];
  const S t9 = S(0.04286000000000001) * t7 - S(0.05999999999999983) * t8;
  const S t10 = t7 * t9;
  const S t11 = t10 + S(0.5150000000000001);
  const S t12 = S(0.030508510792387606) * t7 + S(0.04754890082042665) * t8;
  const S t13 = t12 + S(0.061599999999999995);
  const S t4 = sine[1];
  const S t14 = t4 * t13;
  const S t15 = S(0.5578600000000001) - t10 + S(0.11105097928429088) * t8;
  const S t3 = cosine[1];
  const S t16 = t14 + t14 - t3 * (t15 + S(1.0094799999999997));
  const S t17 = t3 * t16;
  const S t18 = t17 + (t15 + S(1.0779999999999998));
  const S t5 = sine[2];
  const S t19 = t8 * t9 + S(0.029999999999999916) + S(0.05552548964214544) * t7;
  const S t20 = S(0.030508510792387606) * t8 - S(0.04754890082042665) * t7;
  M[13] = t20;
  M[17] = t20;
  const S t21 = t4 * t19 - t3 * t20;
  const S t6 = cosine[2];
  const S t22 = t21 * t6;
  const S t23 = t5 * (t11 - t18) + (t22 + t22);
  const S t24 = t5 * t23;
  const S t25 = S(0.07932212806020777) * t8;
  const S t26 = t25 + S(1.54);
  const S t27 = t3 * t26 - S(0.088) * t4;
  const S t1 = cosine[0];
  const S t28 = S(0.088) * t3 + t4 * t26;
  const S t29 = S(0.07932212806020777) * t7;
  const S t30 = t6 * t28 + t5 * t29;
  const S t2 = sine[0];
  const S t31 = t1 * (t27 + S(1.1440000000000001)) + t30 * t2;
  const S t32 = t18 + t24;
  const S t33 = S(0.6634000000000002) - (t17 - S(1.04) * t27);
  const S t34 = t3 * t19 + t4 * t20;
  M[19] = t34;
  M[23] = t34;
  const S t35 = t13 - t4 * t16;
  const S t36 = t5 * t34 + t6 * t35 + S(0.52) * t30;
  const S t37 = t2 * t36;
  M[0] = t11 - t24 + (t31 + t31 + (t32 - t1 * (t1 * (t32 - t33) - (t37 + t37))) + S(2.2));
  const S t39 = t5 * t35 - t6 * t34 - S(0.52) * (t6 * t29 - t5 * t28);
  M[9] = t39;
  M[21] = t39;
  const S t40 = t2 * t39 - t1 * (t21 - t6 * t23);
  M[1] = t40;
  M[5] = t40;
  const S t41 = t4 * t29;
  const S t42 = t6 * t25 + t5 * t41;
  const S t43 = S(0.05552548964214544) * t8 + S(1.0728600000000004);
  const S t44 = t4 * t12 - t3 * t43;
  const S t45 = t3 * t12 + t4 * t43;
  M[14] = t45;
  M[22] = t45;
  const S t46 = t42 + (t1 * (t5 * t20 - t6 * t44 + S(0.52) * t42) + t2 * t45);
  M[2] = t46;
  M[10] = t46;
  const S t47 = t5 * t27;
  const S t48 = t15 + S(1.14652);
  M[18] = t48;
  const S t49 = t47 + (t1 * (S(0.52) * t47 - (t22 - t5 * t48)) + t2 * t34);
  M[3] = t49;
  M[15] = t49;
  const S t50 = t11 + t18;
  M[24] = t50;
  const S t51 = t30 + (t1 * t36 + t2 * t50);
  M[4] = t51;
  M[20] = t51;
  M[6] = t32 + t33;
  const S t53 = -(S(0.52) * (t6 * t41 - t5 * t25) + (t5 * t44 + t20 * t6));
  M[7] = t53;
  M[11] = t53;
  const S t54 = -(t6 * (t48 + S(0.52) * t27) + t5 * t21);
  M[8] = t54;
  M[16] = t54;
  const S qd1 = qd[1];  // d(v1)
  const S qd0 = qd[0];  // d(u1)
  const S t55 = t1 * qd0;
  const S t56 = t5 * qd1 + t6 * t55;
  const S t57 = t2 * qd0;
  const S qd4 = qd[4];  // d(turn)
  const S t58 = qd4 + t57;
  const S t59 = t4 * t56 - t3 * t58;
  const S t60 = t3 * t56 + t4 * t58;
  const S t61 = qd1 * t57;
  const S t62 = t5 * t61;
  const S t63 = t62 - t56 * qd4;
  const S t64 = qd0 * qd0;
  const S t65 = t2 * t64 + S(9.81) * t1 + S(0.52) * (t55 * t57);
  const S t66 = S(1.04) * t62 + t6 * t65;
  const S t67 = t1 * t64 - S(9.81) * t2 + S(0.52) * (qd1 * qd1 + t55 * t55);
  const S t68 = S(0.7) * (t59 * t60 - t63) - (t3 * t66 - t4 * t67);
  const S t69 = t5 * t55 - t6 * qd1;
  const S qd3 = qd[3];  // d(v2)
  const S t70 = qd3 + t69;
  const S t71 = t8 * t59 + t7 * t70;
  const S qd2 = qd[2];  // d(u2)
  const S t72 = t60 + qd2;
  const S t73 = t71 * t72;
  const S t74 = qd1 * t55;
  const S t75 = t6 * t61;
  const S t76 = qd4 * t69 + t75;
  const S t77 = t3 * t74 + t4 * t76 - t60 * qd3;
  const S t78 = t8 * t63 - t7 * t77 - t71 * qd2;
  const S t79 = t73 - t78;
  const S t80 = t8 * t70 - t7 * t59;
  const S t81 = t80 * t80;
  const S t82 = t71 * t71;
  const S t83 = S(2.2) * t68 + (S(0.07932212806020777) * t79 - S(0.088) * (t81 + t82));
  const S t84 = t4 * t74 - t3 * t76 - t59 * qd3;
  const S t85 = t5 * t65 - S(1.04) * t75 - S(0.7) * (t59 * t70 - t84);
  const S t86 = t3 * t67 + t4 * t66 + S(0.7) * (t60 * t60 + t70 * t70);
  const S t87 = t7 * t85 + t8 * t86;
  const S t88 = t72 * t72;
  const S t89 = t73 + t78;
  const S t90 = S(2.2) * t87 + (S(0.07932212806020777) * (t81 + t88) - S(0.088) * t89);
  const S t91 = t8 * t85 - t7 * t86;
  const S t92 = t8 * t77 + t7 * t63 + qd2 * t80;
  const S t93 = t72 * t80;
  const S t94 = t92 - t93;
  const S t95 = t71 * t80;
  const S t96 = t84 - t95;
  const S t97 = S(2.2) * t91 + (S(0.088) * t94 + S(0.07932212806020777) * t96);
  const S t98 = t3 * t83 - t4 * (t8 * t90 - t7 * t97);
  const S t99 = t8 * t97 + t7 * t90;
  const S t100 = t5 * t98 + t6 * t99;
  const S t101 = t92 + t93;
  const S t102 = S(0.088) * t91 + (S(0.06852000000000014) * t94 + (S(0.5150000000000001) * t101 + (S(0.030508510792387606) * (t81 - t88) - (S(0.029999999999999916) * t79 - S(0.04754890082042665) * t96))));
  const S t103 = t84 + t95;
  const S t104 = S(0.5578600000000001) * t79 + (S(0.030508510792387606) * t103 - S(0.029999999999999943) * t101 - S(0.04754890082042665) * (t82 - t88) - S(0.06852000000000014) * t89) + (S(0.07932212806020777) * t68 + S(0.088) * t87);
  const S t105 = t8 * t102 + t7 * t104;
  const S t106 = S(0.5150000000000001) * t103 + (S(0.5578600000000001) * t96 + (S(0.029999999999999916) * (t81 - t82) - (S(0.030508510792387606) * t89 - S(0.04754890082042665) * t94))) + S(0.07932212806020777) * t91;
  c[2] = t106;
  const S t107 = t106 + S(0.7) * t99;
  const S t108 = t3 * t105 + t4 * t107;
  c[4] = t108;
  const S t109 = t3 * t107 - t4 * t105;
  const S t110 = t8 * t104 - t7 * t102 + S(0.7) * t83;
  c[3] = t110;
  c[0] = t100 + (t2 * t108 + t1 * (t6 * t109 + t5 * t110 + S(0.52) * t100));
  c[1] = t5 * t109 - t6 * t110 + S(0.52) * (t5 * t99 - t6 * t98);
  M[12] = S(1.0728600000000004);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
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

// energy: 68 multiplications, 43 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  S sine[4], cosine[4];
  sines_and_cosines(4, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(u1)
  const S t0 = cosine[0];
  const S t8 = qd0 * t0;
  const S t6 = sine[3];
  const S qd1 = qd[1];  // d(v1)
  const S t7 = cosine[3];
  const S t9 = qd1 * t7;
  const S t10 = t6 * t8 - t9;
  const S qd3 = qd[3];  // d(v2)
  const S t11 = qd3 + t10;
  const S t2 = sine[1];
  const S t1 = sine[0];
  const S qd4 = qd[4];  // d(turn)
  const S t12 = qd4 + qd0 * t1;
  const S t4 = cosine[2];
  const S t13 = t6 * qd1;
  const S t14 = t8 * t7 + t13;
  const S t5 = sine[2];
  const S t15 = t12 * t4 - t5 * t14;
  const S t3 = cosine[1];
  const S t16 = t2 * t11 + t15 * t3;
  const S t17 = t11 * t3 - t2 * t15;
  const S t18 = qd0 - t8;
  const S t19 = S(1.52) * t10 + (t9 + t6 * t18);
  const S t20 = S(0.7) * t11 + t4 * t19;
  const S t21 = t5 * t19;
  const S t22 = t4 * t14 + t12 * t5;
  const S t23 = S(0.7) * t22 - (t13 - t7 * t18 - S(1.52) * t14);
  const S t24 = t2 * t21 - t3 * t23;
  const S qd2 = qd[2];  // d(u2)
  const S t25 = qd2 + t22;
  const S t26 = t3 * t21 + t2 * t23;
  const S t27 = S(1.1) * (t20 * t20 + (t24 * t24 + t26 * t26));
  const S t28 = t25 * (S(1.07286) * t25 - (S(0.02264) * t16 + S(0.05176) * t17));
  const S t29 = S(0.5) * (t16 * (S(0.02264) * t25 - (S(0.6244) * t16 - S(0.03132) * t17)) + t17 * (S(0.03132) * t16 - S(0.5855) * t17 + S(0.05176) * t25) - t28);
  e[0] = (S(0.044) * t16 - S(0.066) * t17) * t20 + (t24 * (S(0.066) * t25 - S(0.088) * t16) + (S(0.044) * t25 - S(0.088) * t17) * t26) + t27 - t29;
  const S t31 = t0 * t7;
  const S t32 = t5 * t31 - t1 * t4;
  const S t33 = t6 * t0;
  const S t34 = S(0.02) * (t2 * t32 + t3 * t33) + S(0.03) * (t2 * t33 - t3 * t32) + S(0.04) * (t4 * t31 + t1 * t5);
  e[1] = S(-21.582) * (S(0.7) * t32 - S(0.52) * t1 + t34);
}

// body_poses: 44 multiplications, 21 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t2 = sine[1];
  const S t0 = cosine[0];
  const S t10 = t2 * t0;
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t1 = sine[0];
  const S t11 = t8 * t10 + t9 * t1;
  const S t4 = sine[2];
  const S t12 = t10 * t9 - t8 * t1;
  const S t6 = sine[3];
  const S t3 = cosine[1];
  const S t13 = t0 * t3;
  const S t7 = cosine[3];
  const S t14 = t6 * t12 + t7 * t13;
  const S t5 = cosine[2];
  W[0] = t4 * t11 - t5 * t14;
  W[1] = -(t11 * t5 + t4 * t14);
  W[2] = t12 * t7 - t6 * t13;
  W[3] = t0 + (S(0.7) * t14 + S(0.52) * t13);
  const S t19 = t2 * t1;
  const S t20 = t0 * t9 - t8 * t19;
  const S t21 = t8 * t0 + t9 * t19;
  const S t22 = t1 * t3;
  const S t23 = t6 * t21 + t7 * t22;
  W[4] = -(t4 * t20 + t5 * t23);
  W[5] = t5 * t20 - t4 * t23;
  W[6] = t7 * t21 - t6 * t22;
  W[7] = S(0.7) * t23 + (t1 + S(0.52) * t22);
  const S t28 = t9 * t3;
  const S t29 = t6 * t28 - t2 * t7;
  const S t30 = t8 * t3;
  W[8] = t5 * t29 - t4 * t30;
  W[9] = t4 * t29 + t5 * t30;
  W[10] = -(t7 * t28 + t2 * t6);
  W[11] = S(0.52) * t2 - S(0.7) * t29;
}

}  // namespace alembert::mechanisms::tori_mated

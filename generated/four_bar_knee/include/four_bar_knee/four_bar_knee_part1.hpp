// four_bar_knee: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "four_bar_knee". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "four_bar_knee_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::four_bar_knee {

// inverse_dynamics: 116 multiplications, 75 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation; relative error 5e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t3 = cosine[1];
  const S t4 = S(0.001536) * t3;
  const S t5 = S(0.0016) - t4;
  const S t6 = sqrt(t5);
  const S t7 = S(1.0) / t6;
  const S t8 = t7 * (S(0.002356) - t4);
  const S t9 = S(1.0) / t5;
  const S t10 = S(216.26297577854672) * t8;
  const S t11 = S(1.0) - t10 * t8;
  const S t12 = S(0.032) * t3;
  const S t13 = S(0.024) - t12;
  const S t14 = acos(S(14.705882352941176) * t8);
  const S t2 = sine[1];
  const S t15 = t7 * t2;
  const S t16 = S(0.032) * t2;
  const S t17 = atan2(t16, t13);
  const S t18 = t14 - t17;
  const S t19 = S(0.5) * t7;
  const S t20 = t7 * t8;
  const S t21 = S(0.000768) * t15;
  const S t22 = sqrt(t11);
  const S t23 = S(0.02258823529411765) / t22;
  const S t24 = t20 * t21;
  const S t25 = t7 - t19 * t20;
  const S t26 = S(0.001536) * t15 - t24;
  const S t27 = cos(t18);
  const S t28 = sin(t18);
  const S t29 = t9 * t21;
  const S t30 = t13 * t9;
  const S t31 = t9 * t2;
  const S t32 = t31 * t2;
  const S t33 = t25 * t2;
  const S t34 = (t10 * (t33 * t26) / t11 - ((t29 - (t29 * t8 - (t26 - t24) * t7) * t19) * t2 - t25 * t3)) * t23;
  const S t35 = S(0.001024) * (t31 * (t3 + (t3 - S(0.001536) * t32))) + (t30 - t3 * ((S(0.032) - S(0.001536) * t30) * t9)) * t16 - t34;
  const S t36 = S(0.001024) * t32 - t30 * t12 - t33 * t23;
  const S t37 = S(0.024) - S(0.034) * t27 - t12;
  const S t38 = t16 + S(0.034) * t28;
  const S t39 = S(1.0) / (t38 * t38 + t37 * t37);
  const S t40 = t36 * t28;
  const S t41 = t36 * t27;
  const S t42 = S(0.034) * t41 + t12;
  const S t43 = S(0.034) * t40 + t16;
  const S t44 = t38 * t42 + t43 * t37;
  const S t45 = t44 + t44;
  const S t46 = t39 * t38;
  const S t47 = t39 * t37;
  const S t48 = t47 * (S(0.034) * (t40 * t36 - t35 * t27) + t16);
  const S t49 = t39 * (t43 * (t46 * t45 - t42) + t42 * (t43 - t47 * t45)) - t46 * (S(0.034) * (t41 * t36 + t35 * t28) + t12) - t48;
  const S t50 = t46 * t43 - t47 * t42;
  const S t51 = atan2(t38, t37);
  const S t52 = t51 + S(1.5392278703071185);
  const S qd0 = qd[0];  // d(hip)
  const S t53 = qd0 * qd0;
  const S qd1 = qd[1];  // d(q)
  const S t54 = qd1 * qd1;
  const S t55 = t54 + t53;
  const S qdd1 = qdd[1];  // dd(q)
  const S qdd0 = qdd[0];  // dd(hip)
  const S t56 = qdd0 - (qdd1 * t50 - t49 * t54);
  const S t57 = qdd1 - qdd0;
  const S t58 = cos(t52);
  const S t59 = sin(t52);
  const S t60 = qd0 - qd1 * t50;
  const S t61 = qd1 * (S(0.064) * qd0);
  const S t0 = cosine[0];
  const S t62 = t61 * t2 + (S(9.81) * t0 + (S(0.41) * t53 - (S(0.032) * (t55 * t2 - t57 * t3) - S(0.012) * qdd0)));
  const S t1 = sine[0];
  const S t63 = S(0.41) * qdd0 - S(0.012) * t53 + S(9.81) * t1 + S(0.032) * (t57 * t2 + t3 * t55) - t3 * t61;
  const S t64 = t58 * t0 - t1 * t59;
  const S t65 = t0 * t59 + t58 * t1;
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S t66 = S(0.6463220249999222) * (t60 * t60) + (f0 * t64 - f2 * t65);
  const S t67 = f2 * t64 + f0 * t65;
  const S t68 = S(0.6463220249999222) * t56 + t67;
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t69 = S(0.1738624) * t56 - S(0.6463220249999222) * (t58 * t62 - t63 * t59) - (f4 - S(0.19009471323527125) * t67);
  const S t70 = S(3.4) * t62 + (t66 * t59 - t58 * t68);
  const S t71 = t58 * t66 + t68 * t59 + S(3.4) * t63;
  const S t72 = S(0.032) * (t3 * t70 + t2 * t71);
  tau[0] = S(0.012) * t70 + S(0.41) * t71 + (t69 - t72) - (S(0.282528) * t0 - S(12.71376) * t1 - S(0.3563952) * qdd0);
  tau[1] = t72 - t69 * t50;
}

// mass_matrix: 46 multiplications, 33 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation; relative error 2.9e-15 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q1 = q[1];  // q
  const S t0 = cos(q1);
  const S t1 = S(0.001536) * t0;
  const S t2 = S(0.0016) - t1;
  const S t3 = sqrt(t2);
  const S t4 = S(1.0) / t3;
  const S t5 = t4 * (S(0.002356) - t1);
  const S t6 = sqrt(S(1.0) - S(216.26297577854672) * t5 * t5);
  const S t7 = sin(q1);
  const S t8 = S(0.032) * t0;
  const S t9 = S(0.024) - t8;
  const S t10 = S(0.02258823529411765) / t6 * (t4 - t4 * (t4 * (S(0.5) * t5))) * t7 + (t9 * t8 - t7 * (S(0.001024) * t7)) / t2;
  const S t11 = acos(S(14.705882352941176) * t5);
  const S t12 = S(0.032) * t7;
  const S t13 = atan2(t12, t9);
  const S t14 = t11 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = S(0.034) * t16;
  const S t18 = S(0.034) * t15;
  const S t19 = S(0.024) - t17 - t8;
  const S t20 = t12 + t18;
  const S t21 = ((t18 * t10 - t12) * t20 - (t17 * t10 - t8) * t19) / (t20 * t20 + t19 * t19);
  const S t22 = atan2(t20, t19);
  const S t23 = t22 + S(1.5392278703071185);
  const S t24 = cos(t23);
  const S t25 = sin(t23);
  const S t26 = S(0.012) - t8;
  const S t27 = S(0.41) - t12;
  const S t28 = S(0.1738624) - S(0.6463220249999222) * (t24 * t26 - t27 * t25);
  const S t29 = S(0.6463220249999222) * t24;
  const S t30 = t29 - S(3.4) * t26;
  const S t31 = S(0.6463220249999222) * t25;
  const S t32 = (t29 * t21 - S(0.1088) * t0) * t8 - (t21 * t31 + S(0.1088) * t7) * t12;
  M[3] = t21 * (S(0.1738624) * t21 - S(0.6463220249999222) * (t24 * t8 - t12 * t25)) - t32;
  const S t34 = S(3.4) * t27 + t31;
  const S t35 = t30 * t8 - t12 * t34;
  M[0] = S(0.3563952) - (S(0.012) * t30 - S(0.41) * t34 - (t28 + t35));
  const S t37 = t28 * t21 - t35;
  M[1] = t37;
  M[2] = t37;
}

// bias: 107 multiplications, 66 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation; relative error 7.1e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t3 = cosine[1];
  const S t4 = S(0.001536) * t3;
  const S t5 = S(0.0016) - t4;
  const S t6 = sqrt(t5);
  const S t7 = S(1.0) / t6;
  const S t8 = t7 * (S(0.002356) - t4);
  const S t9 = S(1.0) / t5;
  const S t10 = S(216.26297577854672) * t8;
  const S t11 = S(1.0) - t10 * t8;
  const S t12 = S(0.032) * t3;
  const S t13 = S(0.024) - t12;
  const S t14 = acos(S(14.705882352941176) * t8);
  const S t2 = sine[1];
  const S t15 = t7 * t2;
  const S t16 = S(0.032) * t2;
  const S t17 = atan2(t16, t13);
  const S t18 = t14 - t17;
  const S t19 = S(0.5) * t7;
  const S t20 = t7 * t8;
  const S t21 = S(0.000768) * t15;
  const S t22 = sqrt(t11);
  const S t23 = S(0.02258823529411765) / t22;
  const S t24 = t20 * t21;
  const S t25 = t7 - t19 * t20;
  const S t26 = S(0.001536) * t15 - t24;
  const S t27 = cos(t18);
  const S t28 = sin(t18);
  const S t29 = t9 * t21;
  const S t30 = t13 * t9;
  const S t31 = t9 * t2;
  const S t32 = t31 * t2;
  const S t33 = t25 * t2;
  const S t34 = (t10 * (t33 * t26) / t11 - ((t29 - (t29 * t8 - (t26 - t24) * t7) * t19) * t2 - t25 * t3)) * t23;
  const S t35 = S(0.001024) * (t31 * (t3 + (t3 - S(0.001536) * t32))) + (t30 - t3 * ((S(0.032) - S(0.001536) * t30) * t9)) * t16 - t34;
  const S t36 = S(0.001024) * t32 - t30 * t12 - t33 * t23;
  const S t37 = S(0.024) - S(0.034) * t27 - t12;
  const S t38 = t16 + S(0.034) * t28;
  const S t39 = S(1.0) / (t38 * t38 + t37 * t37);
  const S t40 = t36 * t28;
  const S t41 = t36 * t27;
  const S t42 = S(0.034) * t41 + t12;
  const S t43 = S(0.034) * t40 + t16;
  const S t44 = t38 * t42 + t43 * t37;
  const S t45 = t44 + t44;
  const S t46 = t39 * t38;
  const S t47 = t39 * t37;
  const S t48 = t47 * (S(0.034) * (t40 * t36 - t35 * t27) + t16);
  const S t49 = t39 * (t43 * (t46 * t45 - t42) + t42 * (t43 - t47 * t45)) - t46 * (S(0.034) * (t41 * t36 + t35 * t28) + t12) - t48;
  const S t50 = t46 * t43 - t47 * t42;
  const S t51 = atan2(t38, t37);
  const S t52 = t51 + S(1.5392278703071185);
  const S t53 = cos(t52);
  const S t54 = sin(t52);
  const S qd1 = qd[1];  // d(q)
  const S t55 = qd1 * qd1;
  const S t56 = t49 * t55;
  const S qd0 = qd[0];  // d(hip)
  const S t57 = qd0 * qd0;
  const S t58 = qd0 * (S(0.064) * qd1) - S(0.032) * (t55 + t57);
  const S t59 = qd0 - qd1 * t50;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t60 = t53 * t0 - t1 * t54;
  const S t61 = t0 * t54 + t53 * t1;
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S t62 = S(0.6463220249999222) * (t59 * t59) + (f0 * t60 - f2 * t61);
  const S t63 = f2 * t60 + f0 * t61;
  const S t64 = t63 + S(0.6463220249999222) * t56;
  const S t65 = t58 * t3 - S(9.81) * t1 + S(0.012) * t57;
  const S t66 = S(9.81) * t0 + t58 * t2 + S(0.41) * t57;
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t67 = S(0.1738624) * t56 - S(0.6463220249999222) * (t65 * t54 + t53 * t66) - (f4 - S(0.19009471323527125) * t63);
  const S t68 = t53 * t62 + t64 * t54 - S(3.4) * t65;
  const S t69 = S(3.4) * t66 + (t62 * t54 - t53 * t64);
  const S t70 = S(0.032) * (t2 * t68 + t69 * t3);
  c[0] = S(0.41) * t68 + S(0.012) * t69 - (t70 - t67) - (S(0.282528) * t0 - S(12.71376) * t1);
  c[1] = t70 - t67 * t50;
}

// mass_matrix_and_bias: 131 multiplications, 84 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation; relative error 2.9e-15 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t3 = cosine[1];
  const S t4 = S(0.001536) * t3;
  const S t5 = S(0.0016) - t4;
  const S t6 = sqrt(t5);
  const S t7 = S(1.0) / t6;
  const S t8 = t7 * (S(0.002356) - t4);
  const S t9 = S(1.0) / t5;
  const S t10 = S(216.26297577854672) * t8;
  const S t11 = S(1.0) - t10 * t8;
  const S t12 = S(0.032) * t3;
  const S t13 = S(0.024) - t12;
  const S t14 = acos(S(14.705882352941176) * t8);
  const S t2 = sine[1];
  const S t15 = t7 * t2;
  const S t16 = S(0.032) * t2;
  const S t17 = atan2(t16, t13);
  const S t18 = t14 - t17;
  const S t19 = t7 * t8;
  const S t20 = S(0.000768) * t15;
  const S t21 = sqrt(t11);
  const S t22 = S(0.02258823529411765) / t21;
  const S t23 = t19 * t20;
  const S t24 = S(0.001536) * t15 - t23;
  const S t25 = S(0.5) * t7;
  const S t26 = t7 - t25 * t19;
  const S t27 = cos(t18);
  const S t28 = sin(t18);
  const S t29 = t9 * t20;
  const S t30 = t13 * t9;
  const S t31 = t9 * t2;
  const S t32 = t31 * t2;
  const S t33 = S(0.032) * (t3 * (t9 * t16 - S(0.001536) * (t30 * t31)) - t30 * t2) - S(0.001024) * (t31 * (t3 + (t3 - S(0.001536) * t32)));
  const S t34 = S(0.024) - S(0.034) * t27 - t12;
  const S t35 = t16 + S(0.034) * t28;
  const S t36 = t26 * t2;
  const S t37 = S(0.001024) * t32 - t30 * t12 - t36 * t22;
  const S t38 = ((t29 - (t29 * t8 - (t24 - t23) * t7) * t25) * t2 - t26 * t3 - t36 * (t10 * t24) / t11) * t22 - t33;
  const S t39 = S(1.0) / (t35 * t35 + t34 * t34);
  const S t40 = t37 * t28;
  const S t41 = t37 * t27;
  const S t42 = S(0.034) * t41 + t12;
  const S t43 = S(0.034) * t40 + t16;
  const S t44 = t35 * t42 + t43 * t34;
  const S t45 = t44 + t44;
  const S t46 = t39 * t35;
  const S t47 = t39 * t34;
  const S t48 = t39 * (t43 * (t46 * t45 - t42) + t42 * (t43 - t47 * t45)) - t46 * (S(0.034) * (t38 * t28 + t41 * t37) + t12);
  const S t49 = t46 * t43 - t47 * t42;
  const S t50 = atan2(t35, t34);
  const S t51 = t50 + S(1.5392278703071185);
  const S t52 = cos(t51);
  const S t53 = sin(t51);
  const S qd1 = qd[1];  // d(q)
  const S t54 = qd1 * qd1;
  const S t55 = (t47 * (t16 - S(0.034) * (t38 * t27 - t40 * t37)) - t48) * t54;
  const S qd0 = qd[0];  // d(hip)
  const S t56 = qd0 * qd0;
  const S t57 = qd0 * (S(0.064) * qd1) - S(0.032) * (t54 + t56);
  const S t58 = qd0 - qd1 * t49;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t59 = t52 * t0 - t1 * t53;
  const S t60 = t0 * t53 + t52 * t1;
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S t61 = S(0.6463220249999222) * (t58 * t58) + (f0 * t59 - f2 * t60);
  const S t62 = f2 * t59 + f0 * t60;
  const S t63 = S(9.81) * t0 + t57 * t2 + S(0.41) * t56;
  const S t64 = t57 * t3 - S(9.81) * t1 + S(0.012) * t56;
  const S t65 = t62 - S(0.6463220249999222) * t55;
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t66 = S(0.6463220249999222) * (t64 * t53 + t52 * t63) + S(0.1738624) * t55 + (f4 - S(0.19009471323527125) * t62);
  const S t67 = S(3.4) * t63 - (t52 * t65 - t61 * t53);
  const S t68 = t52 * t61 + t65 * t53 - S(3.4) * t64;
  const S t69 = S(0.41) - t16;
  const S t70 = S(0.012) - t12;
  const S t71 = S(0.6463220249999222) * (t52 * t70 - t69 * t53) - S(0.1738624);
  const S t72 = S(0.6463220249999222) * t52;
  const S t73 = t72 - S(3.4) * t70;
  const S t74 = S(0.6463220249999222) * t53;
  const S t75 = (t74 * t49 - S(0.1088) * t2) * t16 - (t72 * t49 + S(0.1088) * t3) * t12;
  M[3] = t49 * (S(0.6463220249999222) * (t52 * t12 - t16 * t53) + S(0.1738624) * t49) - t75;
  const S t77 = S(3.4) * t69 + t74;
  const S t78 = t73 * t12 - t16 * t77;
  const S t79 = t67 * t12 + t16 * t68;
  c[0] = S(0.012) * t67 + S(0.41) * t68 - (t79 + t66) - (S(0.282528) * t0 - S(12.71376) * t1);
  M[0] = S(0.3563952) - (S(0.012) * t73 - S(0.41) * t77 - (t78 - t71));
  const S t82 = t71 * t49 - t78;
  M[1] = t82;
  M[2] = t82;
  c[1] = t49 * t66 + t79;
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(hip)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q)
  qdot[1] = qd1;
}

// energy: 55 multiplications, 34 additions, 5 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation; relative error 4.3e-15 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t2 = cosine[1];
  const S t4 = S(0.001536) * t2;
  const S t5 = S(0.0016) - t4;
  const S t6 = sqrt(t5);
  const S t7 = S(1.0) / t6;
  const S t8 = t7 * (S(0.002356) - t4);
  const S t9 = sqrt(S(1.0) - S(216.26297577854672) * t8 * t8);
  const S t10 = S(0.032) * t2;
  const S t11 = S(0.024) - t10;
  const S t3 = sine[1];
  const S t12 = S(0.02258823529411765) / t9 * (t7 - t7 * (t7 * (S(0.5) * t8))) * t3 + (t11 * t10 - t3 * (S(0.001024) * t3)) / t5;
  const S t13 = S(0.032) * t3;
  const S t14 = acos(S(14.705882352941176) * t8);
  const S t15 = atan2(t13, t11);
  const S t16 = t14 - t15;
  const S t17 = cos(t16);
  const S t18 = sin(t16);
  const S t19 = S(0.034) * t17;
  const S t20 = S(0.034) * t18;
  const S t21 = S(0.024) - t19 - t10;
  const S t22 = t13 + t20;
  const S t23 = t22 * t22 + t21 * t21;
  const S qd1 = qd[1];  // d(q)
  const S qd0 = qd[0];  // d(hip)
  const S t24 = qd0 + qd1 * (((t20 * t12 - t13) * t22 - (t19 * t12 - t10) * t21) / t23);
  const S t25 = sqrt(t23);
  const S t26 = S(1.0) / t25;
  const S t27 = S(0.012) - t10;
  const S t28 = qd0 * t27 + qd1 * t10;
  const S t29 = S(0.41) - t13;
  const S t30 = qd0 * t29 + qd1 * t13;
  const S t31 = t26 * t22;
  const S t32 = t26 * t21;
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t33 = S(33.354) * (S(0.006) * (t0 * t32 + t1 * t31) - (S(0.19) * (t0 * t31 - t1 * t32) - (t29 * t1 - t0 * t27)));
  e[1] = S(-70.632) * (S(0.18) * t1 + S(0.004) * t0) - t33;
  const S t35 = t28 * t31 + t30 * t32;
  const S t36 = t28 * t32 - t30 * t31;
  e[0] = S(1.7) * (t35 * t35 + t36 * t36) + (S(0.646) * t35 - S(0.0204) * t36 + S(0.0869312) * t24) * t24 + S(0.1781976) * (qd0 * qd0);
}

// body_poses: 18 multiplications, 14 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation; relative error 3.3e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  W[0] = cosine[0];
  W[10] = cosine[0];
  W[2] = sine[0];
  const S t2 = cosine[1];
  const S t4 = S(0.001536) * t2;
  const S t5 = sqrt(S(0.0016) - t4);
  const S t6 = acos(S(14.705882352941176) * ((S(0.002356) - t4) / t5));
  const S t7 = S(0.032) * t2;
  const S t3 = sine[1];
  const S t8 = S(0.032) * t3;
  const S t9 = atan2(t8, S(0.024) - t7);
  const S t10 = t6 - t9;
  const S t11 = cos(t10);
  const S t12 = sin(t10);
  const S t13 = S(0.024) - S(0.034) * t11 - t7;
  const S t14 = S(0.034) * t12 + t8;
  const S t15 = sqrt(t13 * t13 + t14 * t14);
  const S t16 = S(1.0) / t15;
  const S t17 = t16 * t13;
  const S t18 = t16 * t14;
  const S t19 = S(0.41) - t8;
  const S t20 = S(0.012) - t7;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  W[15] = -(t0 * t20 + t19 * t1);
  W[23] = t1 * t20 - t19 * t0;
  const S t23 = t1 * t17 + t18 * t0;
  W[14] = t23;
  const S t24 = t17 * t0 - t1 * t18;
  W[12] = t24;
  W[22] = t24;
  W[8] = -t1;
  W[20] = -t23;
  W[5] = S(1.0);
  W[17] = S(1.0);
  W[1] = S(0.0);
  W[3] = S(0.0);
  W[4] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[13] = S(0.0);
  W[16] = S(0.0);
  W[18] = S(0.0);
  W[19] = S(0.0);
  W[21] = S(0.0);
}

// frame_poses: 20 multiplications, 16 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation; relative error 3.3e-16 where it was measured).
template <class S>
void frame_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* F) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t2 = cosine[1];
  const S t4 = S(0.001536) * t2;
  const S t5 = sqrt(S(0.0016) - t4);
  const S t6 = acos(S(14.705882352941176) * ((S(0.002356) - t4) / t5));
  const S t7 = S(0.032) * t2;
  const S t3 = sine[1];
  const S t8 = S(0.032) * t3;
  const S t9 = atan2(t8, S(0.024) - t7);
  const S t10 = t6 - t9;
  const S t11 = cos(t10);
  const S t12 = sin(t10);
  const S t13 = S(0.024) - S(0.034) * t11 - t7;
  const S t14 = S(0.034) * t12 + t8;
  const S t15 = sqrt(t13 * t13 + t14 * t14);
  const S t16 = S(1.0) / t15;
  const S t17 = t16 * t13;
  const S t18 = t16 * t14;
  const S t19 = t8 - S(0.41);
  const S t20 = S(0.012) - t7;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t21 = t17 * t0 - t1 * t18;
  F[0] = t21;
  F[10] = t21;
  const S t22 = t1 * t17 + t18 * t0;
  F[2] = t22;
  F[11] = t19 * t0 - (S(0.42) * t21 - t1 * t20);
  F[3] = t19 * t1 - S(0.42) * t22 - t0 * t20;
  F[8] = -t22;
  F[5] = S(1.0);
  F[1] = S(0.0);
  F[4] = S(0.0);
  F[6] = S(0.0);
  F[7] = S(0.0);
  F[9] = S(0.0);
}

// frame_jacobians: 54 multiplications, 32 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation; relative error 9.5e-16 where it was measured).
template <class S>
void frame_jacobians([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* J) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t3 = cosine[1];
  const S t4 = S(0.001536) * t3;
  const S t5 = S(0.0016) - t4;
  const S t6 = sqrt(t5);
  const S t7 = S(1.0) / t6;
  const S t8 = t7 * (S(0.002356) - t4);
  const S t9 = sqrt(S(1.0) - S(216.26297577854672) * t8 * t8);
  const S t10 = S(0.032) * t3;
  const S t11 = S(0.024) - t10;
  const S t2 = sine[1];
  const S t12 = S(0.02258823529411765) / t9 * (t7 - t7 * (t7 * (S(0.5) * t8))) * t2 + (t11 * t10 - t2 * (S(0.001024) * t2)) / t5;
  const S t13 = acos(S(14.705882352941176) * t8);
  const S t14 = S(0.032) * t2;
  const S t15 = atan2(t14, t11);
  const S t16 = t13 - t15;
  const S t17 = cos(t16);
  const S t18 = sin(t16);
  const S t19 = S(0.034) * t17;
  const S t20 = S(0.034) * t18;
  const S t21 = S(0.024) - t19 - t10;
  const S t22 = t14 + t20;
  const S t23 = t20 * t12 - t14;
  const S t24 = t19 * t12 - t10;
  const S t25 = sqrt(t22 * t22 + t21 * t21);
  const S t26 = S(1.0) / t25;
  const S t27 = t26 * (t22 * t24 + t23 * t21);
  const S t28 = t26 * t22;
  const S t29 = t26 * t21;
  const S t30 = t26 * (t27 * t28 - t24);
  const S t31 = (t27 * t29 - t23) * t26;
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t32 = S(0.032) * (t0 * t3 - t2 * t1);
  const S t33 = S(0.032) * (t0 * t2 + t3 * t1);
  const S t34 = t0 * t30 - t31 * t1;
  const S t35 = t0 * t31 + t1 * t30;
  const S t36 = t0 * t29 + t1 * t28;
  const S t37 = t0 * t28 - t1 * t29;
  J[6] = S(0.42) * t37 - (t32 + (S(0.41) * t1 - S(0.012) * t0));
  J[10] = S(0.42) * t36 - (t33 - (S(0.41) * t0 + S(0.012) * t1));
  J[3] = t34 * t36 - t35 * t37;
  J[7] = t32 - S(0.42) * t35;
  J[11] = t33 + S(0.42) * t34;
  J[2] = S(1.0);
  J[0] = S(0.0);
  J[1] = S(0.0);
  J[4] = S(0.0);
  J[5] = S(0.0);
  J[8] = S(0.0);
  J[9] = S(0.0);
}

}  // namespace alembert::mechanisms::four_bar_knee

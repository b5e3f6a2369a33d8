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

// inverse_dynamics: 118 multiplications, 77 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S qd1 = qd[1];  // d(q)
  const S qd0 = qd[0];  // d(hip)
  const S t4 = qd0 * (S(0.064) * qd1);
  const S t2 = sine[1];
  const S t0 = cosine[0];
  const S t5 = qd0 * qd0;
  const S qdd0 = qdd[0];  // dd(hip)
  const S qdd1 = qdd[1];  // dd(q)
  const S t6 = qdd0 - qdd1;
  const S t3 = cosine[1];
  const S t7 = qd1 * qd1;
  const S t8 = t5 + t7;
  const S t9 = t2 * t4 + (S(9.81) * t0 + (S(0.41) * t5 + (S(0.012) * qdd0 - S(0.032) * (t3 * t6 + t2 * t8))));
  const S t10 = S(0.032) * t2;
  const S t11 = S(0.001536) * t3;
  const S t12 = S(0.0016) - t11;
  const S t13 = sqrt(t12);
  const S t14 = S(1.0) / t13;
  const S t15 = (S(0.002356) - t11) * t14;
  const S t16 = acos(S(14.705882352941176) * t15);
  const S t17 = S(0.032) * t3;
  const S t18 = S(0.024) - t17;
  const S t19 = atan2(t10, t18);
  const S t20 = t16 - t19;
  const S t21 = sin(t20);
  const S t22 = cos(t20);
  const S t23 = t10 + S(0.034) * t21;
  const S t24 = t17 - (S(0.024) - S(0.034) * t22);
  const S t25 = atan2(t23, -t24);
  const S t26 = t25 + S(1.5392278703071185);
  const S t27 = cos(t26);
  const S t28 = sin(t26);
  const S t29 = S(1.0) / (t23 * t23 + t24 * t24);
  const S t30 = t24 * t29;
  const S t31 = S(1.0) / t12;
  const S t32 = t18 * t31;
  const S t33 = t2 * t31;
  const S t34 = t2 * t33;
  const S t35 = S(216.26297577854672) * t15;
  const S t36 = sqrt(S(1.0) - t15 * t35);
  const S t37 = S(0.02258823529411765) / t36;
  const S t38 = t14 * t15;
  const S t39 = S(0.5) * t14;
  const S t40 = t14 - t38 * t39;
  const S t41 = t2 * t14;
  const S t42 = S(0.000768) * t41;
  const S t43 = t31 * t42;
  const S t44 = t38 * t42;
  const S t45 = t44 - S(0.001536) * t41;
  const S t46 = t2 * t40;
  const S t47 = t37 * (t3 * t40 - t2 * (t43 - t39 * (t15 * t43 + t14 * (t44 + t45))) - t35 * (t45 * t46) / (t36 * t36));
  const S t48 = t10 * (t32 - t3 * (t31 * (S(0.032) - S(0.001536) * t32))) + (t33 * (S(0.001024) * (t3 + (t3 - S(0.001536) * t34))) - t47);
  const S t49 = S(0.001024) * t34 - t17 * t32 - t37 * t46;
  const S t50 = t21 * t49;
  const S t51 = t23 * t29;
  const S t52 = t22 * t49;
  const S t53 = t17 + S(0.034) * t52;
  const S t54 = t10 + S(0.034) * t50;
  const S t55 = t23 * t53;
  const S t56 = t24 * t54;
  const S t57 = t55 + t55 - (t56 + t56);
  const S t58 = t51 * (t17 + S(0.034) * (t21 * t48 + t49 * t52)) - t29 * (t53 * (t54 + t30 * t57) - t54 * (t53 - t51 * t57));
  const S t59 = t51 * t54 + t30 * t53;
  const S t60 = qdd0 + (t7 * (t30 * (t10 - S(0.034) * (t22 * t48 - t49 * t50)) - t58) - qdd1 * t59);
  const S t1 = sine[0];
  const S t61 = t0 * t27 - t1 * t28;
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S t62 = t27 * t1 + t0 * t28;
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S t63 = f2 * t61 + f0 * t62;
  const S t64 = S(0.6463220249999222) * t60 + t63;
  const S t65 = qd0 - qd1 * t59;
  const S t66 = t61 * f0 - f2 * t62;
  const S t67 = S(0.6463220249999222) * (t65 * t65) + t66;
  const S t68 = S(3.4) * t9 - (t27 * t64 - t28 * t67);
  const S t69 = t4 * t3 - (S(0.41) * qdd0 - S(0.012) * t5 + S(9.81) * t1 + S(0.032) * (t3 * t8 - t2 * t6));
  const S t70 = S(3.4) * t69 - (t28 * t64 + t27 * t67);
  const S t71 = S(0.032) * (t3 * t68 - t2 * t70);
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t72 = S(0.1738624) * t60 - S(0.6463220249999222) * (t28 * t69 + t9 * t27) - (f4 - (S(1.0408340855860843e-17) * t66 + S(0.19009471323527125) * t63));
  tau[0] = S(0.012) * t68 - S(0.41) * t70 - (t71 - t72) + (S(0.3563952000000001) * qdd0 - (S(0.282528) * t0 - S(12.71376) * t1));
  tau[1] = t71 - t59 * t72;
}

// mass_matrix: 46 multiplications, 33 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q1 = q[1];  // q
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = S(0.032) * t0;
  const S t3 = S(0.001536) * t1;
  const S t4 = S(0.0016) - t3;
  const S t5 = sqrt(t4);
  const S t6 = S(1.0) / t5;
  const S t7 = (S(0.002356) - t3) * t6;
  const S t8 = acos(S(14.705882352941176) * t7);
  const S t9 = S(0.032) * t1;
  const S t10 = S(0.024) - t9;
  const S t11 = atan2(t2, t10);
  const S t12 = t8 - t11;
  const S t13 = sin(t12);
  const S t14 = cos(t12);
  const S t15 = S(0.034) * t13;
  const S t16 = t2 + t15;
  const S t17 = S(0.034) * t14;
  const S t18 = t9 - (S(0.024) - t17);
  const S t19 = atan2(t16, -t18);
  const S t20 = t19 + S(1.5392278703071185);
  const S t21 = sin(t20);
  const S t22 = cos(t20);
  const S t23 = S(0.6463220249999222) * t21;
  const S t24 = S(0.41) - t2;
  const S t25 = t23 + S(3.4) * t24;
  const S t26 = S(0.6463220249999222) * t22;
  const S t27 = S(0.012) - t9;
  const S t28 = t26 - S(3.4) * t27;
  const S t29 = S(0.6463220249999222) * (t21 * t24 - t22 * t27) + S(0.1738624);
  const S t30 = t2 * t25 - t9 * t28;
  M[0] = S(0.41) * t25 - S(0.012) * t28 + (t29 - t30) + S(0.3563952000000001);
  const S t32 = sqrt(S(1.0) - t7 * (S(216.26297577854672) * t7));
  const S t33 = t0 * ((t6 - t6 * (t6 * (S(0.5) * t7))) * (S(0.02258823529411765) / t32)) - (t0 * (S(0.001024) * t0) - t9 * t10) / t4;
  const S t34 = (t16 * (t2 - t15 * t33) + t18 * (t9 - t17 * t33)) / (t16 * t16 + t18 * t18);
  const S t35 = t30 - t29 * t34;
  M[1] = t35;
  M[2] = t35;
  const S t36 = t2 * (t23 * t34 - S(0.1088) * t0) - t9 * (t26 * t34 + S(0.1088) * t1);
  M[3] = t34 * (S(0.1738624) * t34 + S(0.6463220249999222) * (t9 * t22 - t2 * t21)) - t36;
}

// bias: 109 multiplications, 68 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S t2 = sine[1];
  const S t4 = S(0.032) * t2;
  const S t3 = cosine[1];
  const S t5 = S(0.001536) * t3;
  const S t6 = S(0.0016) - t5;
  const S t7 = sqrt(t6);
  const S t8 = S(1.0) / t7;
  const S t9 = (S(0.002356) - t5) * t8;
  const S t10 = acos(S(14.705882352941176) * t9);
  const S t11 = S(0.032) * t3;
  const S t12 = S(0.024) - t11;
  const S t13 = atan2(t4, t12);
  const S t14 = t10 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = t4 + S(0.034) * t15;
  const S t18 = t11 - (S(0.024) - S(0.034) * t16);
  const S t19 = atan2(t17, -t18);
  const S t20 = t19 + S(1.5392278703071185);
  const S t21 = cos(t20);
  const S t22 = sin(t20);
  const S t23 = S(1.0) / t6;
  const S t24 = t2 * t23;
  const S t25 = t2 * t24;
  const S t26 = t12 * t23;
  const S t27 = t8 * t9;
  const S t28 = S(0.5) * t8;
  const S t29 = t8 - t27 * t28;
  const S t30 = t2 * t29;
  const S t31 = S(216.26297577854672) * t9;
  const S t32 = sqrt(S(1.0) - t9 * t31);
  const S t33 = S(0.02258823529411765) / t32;
  const S t34 = S(0.001024) * t25 - t11 * t26 - t30 * t33;
  const S t35 = t15 * t34;
  const S t36 = t4 + S(0.034) * t35;
  const S t37 = S(1.0) / (t17 * t17 + t18 * t18);
  const S t38 = t17 * t37;
  const S t39 = t16 * t34;
  const S t40 = t11 + S(0.034) * t39;
  const S t41 = t18 * t37;
  const S t42 = t36 * t38 + t40 * t41;
  const S qd1 = qd[1];  // d(q)
  const S qd0 = qd[0];  // d(hip)
  const S t43 = qd0 - qd1 * t42;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t44 = t0 * t21 - t1 * t22;
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S t45 = t1 * t21 + t0 * t22;
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S t46 = f0 * t44 - f2 * t45;
  const S t47 = t43 * (S(0.6463220249999222) * t43) + t46;
  const S t48 = qd1 * qd1;
  const S t49 = t2 * t8;
  const S t50 = S(0.000768) * t49;
  const S t51 = t23 * t50;
  const S t52 = t27 * t50;
  const S t53 = t52 - S(0.001536) * t49;
  const S t54 = t33 * (t3 * t29 - t2 * (t51 - t28 * (t9 * t51 + t8 * (t52 + t53))) - t30 * (t31 * t53) / (t32 * t32));
  const S t55 = t4 * (t26 - t3 * (t23 * (S(0.032) - S(0.001536) * t26))) + (t24 * (S(0.001024) * (t3 + (t3 - S(0.001536) * t25))) - t54);
  const S t56 = t17 * t40;
  const S t57 = t18 * t36;
  const S t58 = t56 + t56 - (t57 + t57);
  const S t59 = t38 * (t11 + S(0.034) * (t15 * t55 + t34 * t39)) - t37 * (t40 * (t36 + t41 * t58) - t36 * (t40 - t38 * t58));
  const S t60 = t48 * (t41 * (t4 - S(0.034) * (t16 * t55 - t34 * t35)) - t59);
  const S t61 = t44 * f2 + f0 * t45;
  const S t62 = S(0.6463220249999222) * t60 + t61;
  const S t63 = qd0 * qd0;
  const S t64 = qd0 * (S(0.064) * qd1) - S(0.032) * (t48 + t63);
  const S t65 = S(0.012) * t63 - (S(9.81) * t1 - t3 * t64);
  const S t66 = t21 * t47 + t22 * t62 - S(3.4) * t65;
  const S t67 = S(0.41) * t63 + (S(9.81) * t0 + t2 * t64);
  const S t68 = S(3.4) * t67 - (t21 * t62 - t22 * t47);
  const S t69 = S(0.032) * (t3 * t68 + t2 * t66);
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t70 = S(0.1738624) * t60 - S(0.6463220249999222) * (t22 * t65 + t21 * t67) - (f4 - (S(1.0408340855860843e-17) * t46 + S(0.19009471323527125) * t61));
  c[0] = S(0.41) * t66 + S(0.012) * t68 - (t69 - t70) - (S(0.282528) * t0 - S(12.71376) * t1);
  c[1] = t69 - t42 * t70;
}

// mass_matrix_and_bias: 133 multiplications, 86 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S t2 = sine[1];
  const S t4 = S(0.032) * t2;
  const S t3 = cosine[1];
  const S t5 = S(0.001536) * t3;
  const S t6 = S(0.0016) - t5;
  const S t7 = sqrt(t6);
  const S t8 = S(1.0) / t7;
  const S t9 = (S(0.002356) - t5) * t8;
  const S t10 = acos(S(14.705882352941176) * t9);
  const S t11 = S(0.032) * t3;
  const S t12 = S(0.024) - t11;
  const S t13 = atan2(t4, t12);
  const S t14 = t10 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = t4 + S(0.034) * t15;
  const S t18 = t11 - (S(0.024) - S(0.034) * t16);
  const S t19 = atan2(t17, -t18);
  const S t20 = t19 + S(1.5392278703071185);
  const S t21 = sin(t20);
  const S t22 = cos(t20);
  const S t23 = S(0.6463220249999222) * t21;
  const S t24 = S(0.41) - t4;
  const S t25 = t23 + S(3.4) * t24;
  const S t26 = S(0.6463220249999222) * t22;
  const S t27 = S(0.012) - t11;
  const S t28 = t26 - S(3.4) * t27;
  const S t29 = S(0.6463220249999222) * (t21 * t24 - t22 * t27) + S(0.1738624);
  const S t30 = t4 * t25 - t11 * t28;
  M[0] = S(0.41) * t25 - S(0.012) * t28 + (t29 - t30) + S(0.3563952000000001);
  const S t32 = S(1.0) / t6;
  const S t33 = t2 * t32;
  const S t34 = t2 * t33;
  const S t35 = t12 * t32;
  const S t36 = t8 * t9;
  const S t37 = S(0.5) * t8;
  const S t38 = t8 - t36 * t37;
  const S t39 = t2 * t38;
  const S t40 = S(216.26297577854672) * t9;
  const S t41 = sqrt(S(1.0) - t9 * t40);
  const S t42 = S(0.02258823529411765) / t41;
  const S t43 = S(0.001024) * t34 - t11 * t35 - t39 * t42;
  const S t44 = t15 * t43;
  const S t45 = t4 + S(0.034) * t44;
  const S t46 = S(1.0) / (t17 * t17 + t18 * t18);
  const S t47 = t17 * t46;
  const S t48 = t16 * t43;
  const S t49 = t11 + S(0.034) * t48;
  const S t50 = t18 * t46;
  const S t51 = t45 * t47 + t49 * t50;
  const S t52 = t30 - t29 * t51;
  M[1] = t52;
  M[2] = t52;
  const S t53 = t4 * (t23 * t51 - S(0.1088) * t2) - t11 * (t26 * t51 + S(0.1088) * t3);
  M[3] = t51 * (S(0.1738624) * t51 + S(0.6463220249999222) * (t11 * t22 - t4 * t21)) - t53;
  const S qd1 = qd[1];  // d(q)
  const S qd0 = qd[0];  // d(hip)
  const S t55 = qd0 - t51 * qd1;
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t56 = t22 * t0 - t21 * t1;
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S t57 = t22 * t1 + t21 * t0;
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S t58 = f0 * t56 - f2 * t57;
  const S t59 = S(0.6463220249999222) * (t55 * t55) + t58;
  const S t60 = qd1 * qd1;
  const S t61 = t2 * t8;
  const S t62 = S(0.000768) * t61;
  const S t63 = t32 * t62;
  const S t64 = t36 * t62;
  const S t65 = S(0.001536) * t61 - t64;
  const S t66 = t42 * (t3 * t38 - t2 * (t63 - t37 * (t9 * t63 + t8 * (t64 - t65))) + t39 * (t40 * t65) / (t41 * t41));
  const S t67 = S(0.032) * (t3 * (t4 * t32 - S(0.001536) * (t33 * t35)) - t2 * t35) - (S(0.001024) * (t33 * (t3 + (t3 - S(0.001536) * t34))) - t66);
  const S t68 = t17 * t49;
  const S t69 = t18 * t45;
  const S t70 = t68 + t68 - (t69 + t69);
  const S t71 = t47 * (t11 - S(0.034) * (t15 * t67 - t43 * t48)) - t46 * (t49 * (t45 + t50 * t70) - t45 * (t49 - t47 * t70));
  const S t72 = t60 * (t50 * (t4 + S(0.034) * (t16 * t67 + t43 * t44)) - t71);
  const S t73 = t56 * f2 + f0 * t57;
  const S t74 = S(0.6463220249999222) * t72 + t73;
  const S t75 = qd0 * qd0;
  const S t76 = qd0 * (S(0.064) * qd1) - S(0.032) * (t60 + t75);
  const S t77 = S(0.012) * t75 - (S(9.81) * t1 - t3 * t76);
  const S t78 = t22 * t59 + t21 * t74 - S(3.4) * t77;
  const S t79 = S(0.41) * t75 + (S(9.81) * t0 + t2 * t76);
  const S t80 = S(3.4) * t79 - (t22 * t74 - t21 * t59);
  const S t81 = t11 * t80 + t4 * t78;
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t82 = S(0.1738624) * t72 - S(0.6463220249999222) * (t21 * t77 + t22 * t79) - (f4 - (S(1.0408340855860843e-17) * t58 + S(0.19009471323527125) * t73));
  c[0] = S(0.41) * t78 + S(0.012) * t80 - (t81 - t82) - (S(0.282528) * t0 - S(12.71376) * t1);
  c[1] = t81 - t51 * t82;
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(hip)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q)
  qdot[1] = qd1;
}

// energy: 55 multiplications, 34 additions, 5 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S qd0 = qd[0];  // d(hip)
  const S t2 = sine[1];
  const S t4 = S(0.032) * t2;
  const S t3 = cosine[1];
  const S t5 = S(0.001536) * t3;
  const S t6 = S(0.0016) - t5;
  const S t7 = sqrt(t6);
  const S t8 = S(1.0) / t7;
  const S t9 = (S(0.002356) - t5) * t8;
  const S t10 = acos(S(14.705882352941176) * t9);
  const S t11 = S(0.032) * t3;
  const S t12 = S(0.024) - t11;
  const S t13 = atan2(t4, t12);
  const S t14 = t10 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = S(0.034) * t15;
  const S t18 = t4 + t17;
  const S t19 = S(0.034) * t16;
  const S t20 = t11 - (S(0.024) - t19);
  const S t21 = t18 * t18 + t20 * t20;
  const S t22 = sqrt(t21);
  const S t23 = S(1.0) / t22;
  const S t24 = t18 * t23;
  const S qd1 = qd[1];  // d(q)
  const S t25 = S(0.41) - t4;
  const S t26 = t4 * qd1 + qd0 * t25;
  const S t27 = t20 * t23;
  const S t28 = S(0.012) - t11;
  const S t29 = t11 * qd1 + qd0 * t28;
  const S t30 = t24 * t26 + t27 * t29;
  const S t31 = t24 * t29 - t26 * t27;
  const S t32 = sqrt(S(1.0) - t9 * (S(216.26297577854672) * t9));
  const S t33 = t2 * ((t8 - t8 * (t8 * (S(0.5) * t9))) * (S(0.02258823529411765) / t32)) - (t2 * (S(0.001024) * t2) - t11 * t12) / t6;
  const S t34 = qd0 - qd1 * ((t18 * (t4 - t17 * t33) + t20 * (t11 - t19 * t33)) / t21);
  e[0] = qd0 * (S(0.1781976) * qd0) + (S(1.7) * (t30 * t30 + t31 * t31) + t34 * (S(0.646) * t31 + S(0.0204) * t30 + S(0.0869312) * t34));
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t36 = S(70.632) * (S(0.18) * t0 + S(0.004) * t1);
  e[1] = S(-33.354) * (S(0.006) * (t24 * t0 - t27 * t1) - (S(0.19) * (t27 * t0 + t24 * t1) + (t28 * t1 - t25 * t0))) - t36;
}

// body_poses: 18 multiplications, 14 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation).
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
  const S t1 = sine[0];
  W[8] = -t1;
  const S t2 = cosine[1];
  const S t5 = S(0.032) * t2;
  const S t6 = S(0.001536) * t2;
  const S t7 = sqrt(S(0.0016) - t6);
  const S t8 = acos(S(14.705882352941176) * ((S(0.002356) - t6) / t7));
  const S t3 = sine[1];
  const S t9 = S(0.032) * t3;
  const S t10 = atan2(t9, S(0.024) - t5);
  const S t11 = t8 - t10;
  const S t12 = cos(t11);
  const S t13 = sin(t11);
  const S t14 = t5 - (S(0.024) - S(0.034) * t12);
  const S t15 = t9 + S(0.034) * t13;
  const S t16 = sqrt(t15 * t15 + t14 * t14);
  const S t17 = S(1.0) / t16;
  const S t18 = t14 * t17;
  const S t0 = cosine[0];
  const S t19 = t15 * t17;
  const S t20 = -(t0 * t18 + t1 * t19);
  W[12] = t20;
  W[22] = t20;
  const S t21 = t0 * t19 - t1 * t18;
  W[14] = t21;
  const S t22 = S(0.41) - t9;
  const S t23 = S(0.012) - t5;
  W[15] = -(t1 * t22 + t0 * t23);
  W[20] = -t21;
  W[23] = t1 * t23 - t0 * t22;
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
  W[5] = S(1.0);
  W[17] = S(1.0);
}

// frame_poses: 23 multiplications, 18 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation).
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
  const S t4 = S(0.032) * t2;
  const S t5 = S(0.001536) * t2;
  const S t6 = sqrt(S(0.0016) - t5);
  const S t7 = acos(S(14.705882352941176) * ((S(0.002356) - t5) / t6));
  const S t3 = sine[1];
  const S t8 = S(0.032) * t3;
  const S t9 = atan2(t8, S(0.024) - t4);
  const S t10 = t7 - t9;
  const S t11 = cos(t10);
  const S t12 = sin(t10);
  const S t13 = t4 - (S(0.024) - S(0.034) * t11);
  const S t14 = t8 + S(0.034) * t12;
  const S t15 = sqrt(t14 * t14 + t13 * t13);
  const S t16 = S(1.0) / t15;
  const S t17 = t13 * t16;
  const S t0 = cosine[0];
  const S t18 = t14 * t16;
  const S t1 = sine[0];
  const S t19 = t17 * t0 + t1 * t18;
  const S t20 = -t19;
  F[0] = t20;
  F[10] = t20;
  const S t21 = t0 * t18 - t17 * t1;
  F[2] = t21;
  F[3] = t0 * (t4 - S(0.012)) - (S(0.42) * t21 + t1 * (S(0.41) - t8));
  F[8] = -t21;
  F[11] = S(0.42) * t19 + (S(0.012) * t1 - (S(0.41) * t0 + S(0.032) * (t2 * t1 - t3 * t0)));
  F[5] = S(1.0);
  F[1] = S(0.0);
  F[4] = S(0.0);
  F[6] = S(0.0);
  F[7] = S(0.0);
  F[9] = S(0.0);
}

// frame_jacobians: 55 multiplications, 34 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S t3 = sine[1];
  const S t4 = S(0.032) * t3;
  const S t2 = cosine[1];
  const S t5 = S(0.001536) * t2;
  const S t6 = S(0.0016) - t5;
  const S t7 = sqrt(t6);
  const S t8 = S(1.0) / t7;
  const S t9 = (S(0.002356) - t5) * t8;
  const S t10 = acos(S(14.705882352941176) * t9);
  const S t11 = S(0.032) * t2;
  const S t12 = S(0.024) - t11;
  const S t13 = atan2(t4, t12);
  const S t14 = t10 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = S(0.034) * t15;
  const S t18 = t4 + t17;
  const S t19 = S(0.034) * t16;
  const S t20 = t11 - (S(0.024) - t19);
  const S t21 = sqrt(t18 * t18 + t20 * t20);
  const S t22 = S(1.0) / t21;
  const S t23 = t18 * t22;
  const S t0 = cosine[0];
  const S t24 = t20 * t22;
  const S t1 = sine[0];
  const S t25 = t0 * t23 - t24 * t1;
  const S t26 = sqrt(S(1.0) - t9 * (S(216.26297577854672) * t9));
  const S t27 = t3 * ((t8 - t8 * (t8 * (S(0.5) * t9))) * (S(0.02258823529411765) / t26)) - (t3 * (S(0.001024) * t3) - t11 * t12) / t6;
  const S t28 = t11 - t19 * t27;
  const S t29 = t18 * t28;
  const S t30 = t4 - t17 * t27;
  const S t31 = t20 * t30;
  const S t32 = t22 * (S(0.5) * (t29 + t29 - (t31 + t31)));
  const S t33 = t22 * (t28 - t23 * t32);
  const S t34 = t22 * (t30 + t24 * t32);
  const S t35 = t1 * t33 - t0 * t34;
  const S t36 = t24 * t0 + t1 * t23;
  const S t37 = t1 * t34 + t0 * t33;
  J[3] = t25 * t35 - t36 * t37;
  const S t39 = S(0.032) * (t2 * t1 - t3 * t0);
  J[6] = S(0.42) * t36 - (t39 + (S(0.41) * t0 - S(0.012) * t1));
  J[7] = t39 - S(0.42) * t37;
  const S t42 = S(0.032) * (t2 * t0 + t3 * t1);
  J[10] = S(0.42) * t25 + (S(0.41) * t1 + S(0.012) * t0 - t42);
  J[11] = t42 - S(-0.42) * t35;
  J[0] = S(0.0);
  J[1] = S(0.0);
  J[4] = S(0.0);
  J[5] = S(0.0);
  J[8] = S(0.0);
  J[9] = S(0.0);
  J[2] = S(1.0);
}

}  // namespace alembert::mechanisms::four_bar_knee

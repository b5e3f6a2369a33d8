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

// inverse_dynamics: 125 multiplications, 77 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  const S qdd0 = qdd[0];  // dd(hip)
  const S qdd1 = qdd[1];  // dd(q)
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = S(0.032) * t2;
  const S t5 = S(0.032) * t3;
  const S t6 = S(0.024) - t5;
  const S t7 = atan2(t4, t6);
  const S t8 = S(0.001536) * t3;
  const S t9 = S(0.0016) - t8;
  const S t10 = sqrt(t9);
  const S t11 = S(1.0) / t10;
  const S t12 = t11 * (S(0.002356) - t8);
  const S t13 = acos(S(14.705882352941176) * t12);
  const S t14 = t7 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = t4 - S(0.034) * t15;
  const S t18 = t5 - (S(0.024) - S(0.034) * t16);
  const S t19 = atan2(-t17, -t18);
  const S t20 = S(1.5392278703071185) - t19;
  const S t21 = sin(t20);
  const S t22 = cos(t20);
  const S t23 = S(1.0) / (t17 * t17 + t18 * t18);
  const S t24 = t18 * t23;
  const S t25 = S(1.0) / t9;
  const S t26 = t6 * t25;
  const S t27 = t2 * t25;
  const S t28 = t2 * t27;
  const S t29 = S(0.5) * t11;
  const S t30 = t11 * t12;
  const S t31 = t11 - t29 * t30;
  const S t32 = t2 * t31;
  const S t33 = S(1.0) - S(216.26297577854672) * (t12 * t12);
  const S t34 = sqrt(t33);
  const S t35 = S(0.02258823529411765) / t34;
  const S t36 = S(0.032) * (t3 * t26) - S(0.001024) * t28 + t32 * t35;
  const S t37 = t16 * t36;
  const S t38 = t5 - S(0.034) * t37;
  const S t39 = t15 * t36;
  const S t40 = t4 + S(0.034) * t39;
  const S t41 = t17 * t23;
  const S t42 = t24 * t38 + t40 * t41;
  const S t43 = qd0 - qd1 * t42;
  const S t44 = t21 * t0 + t1 * t22;
  const S t45 = t21 * t1 - t0 * t22;
  const S t46 = f2 * t44 + f0 * t45;
  const S t47 = S(0.6463220249999222) * (t43 * t43) - t46;
  const S t48 = t2 * (S(0.000768) * t11);
  const S t49 = t30 * t48;
  const S t50 = t2 * (S(0.001536) * t11) - t49;
  const S t51 = t25 * t48;
  const S t52 = S(0.001024) * (t3 * t27 + t2 * (t25 * (t3 - S(0.001536) * t28)));
  const S t53 = t35 * (S(216.26297577854672) * (t12 * t32 * t50 / t33) - (t2 * (t51 - t29 * (t11 * (t49 - t50) + t12 * t51)) - t3 * t31)) - t52;
  const S t54 = t53 - S(0.032) * (t2 * (t26 - t3 * (t25 * (S(0.032) - S(0.001536) * t26))));
  const S t55 = t17 * t38;
  const S t56 = t18 * t40;
  const S t57 = t55 + t55 - (t56 + t56);
  const S t58 = t41 * (t5 + S(0.034) * (t15 * t54 + t36 * t37)) - t23 * (t38 * (t40 + t24 * t57) - t40 * (t38 - t41 * t57));
  const S t59 = qd1 * qd1;
  const S t60 = qdd0 - (t42 * qdd1 - (t24 * (t4 - S(0.034) * (t36 * t39 - t16 * t54)) - t58) * t59);
  const S t61 = f2 * t45 - t44 * f0;
  const S t62 = S(0.6463220249999222) * t60 - t61;
  const S t63 = qd0 * qd0;
  const S t64 = qdd0 - qdd1;
  const S t65 = t59 + t63;
  const S t66 = S(9.81) * t0 + (S(0.41) * t63 + (S(0.012) * qdd0 - S(0.032) * (t3 * t64 + t2 * t65))) + S(0.064) * (qd0 * (t2 * qd1));
  const S t67 = t21 * t47 - t22 * t62 + S(3.4) * t66;
  const S t68 = S(0.032) * (t3 * t65 - t2 * t64) + (S(9.81) * t1 + (S(0.41) * qdd0 - S(0.012) * t63)) - S(0.064) * (qd0 * (t3 * qd1));
  const S t69 = S(3.4) * t68 + (t22 * t47 + t21 * t62);
  const S t70 = S(0.032) * (t2 * t69 + t3 * t67);
  const S t71 = S(0.1738624) * t60 + S(0.6463220249999222) * (t21 * t68 - t22 * t66) - (f4 + (S(1.0408340855860843e-17) * t46 + S(0.19009471323527125) * t61));
  tau[0] = S(0.012) * t67 + S(0.41) * t69 - (t70 - t71) + (S(0.3563952000000001) * qdd0 + (S(12.71376) * t1 - S(0.282528) * t0));
  tau[1] = t70 - t42 * t71;
}

// mass_matrix: 53 multiplications, 33 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S t15 = t2 + S(0.034) * t13;
  const S t16 = t9 - (S(0.024) - S(0.034) * t14);
  const S t17 = atan2(t15, -t16);
  const S t18 = t17 + S(1.5392278703071185);
  const S t19 = sin(t18);
  const S t20 = cos(t18);
  const S t21 = S(0.41) - t2;
  const S t22 = S(0.6463220249999222) * t19 + S(3.4) * t21;
  const S t23 = S(0.012) - t9;
  const S t24 = S(0.6463220249999222) * t20 - S(3.4) * t23;
  const S t25 = S(0.6463220249999222) * (t19 * t21 - t20 * t23) + S(0.1738624);
  const S t26 = S(0.032) * (t0 * t22 - t1 * t24);
  M[0] = S(0.41) * t22 - S(0.012) * t24 + (t25 - t26) + S(0.3563952000000001);
  const S t28 = sqrt(S(1.0) - S(216.26297577854672) * (t7 * t7));
  const S t29 = t0 * (t6 - t6 * t7 * (S(0.5) * t6)) * (S(0.02258823529411765) / t28) - (S(0.001024) * (t0 * t0) - S(0.032) * (t1 * t10)) / t4;
  const S t30 = (t15 * (t2 - S(0.034) * (t13 * t29)) + t16 * (t9 - S(0.034) * (t14 * t29))) / (t15 * t15 + t16 * t16);
  const S t31 = t26 - t25 * t30;
  M[1] = t31;
  M[2] = t31;
  const S t32 = S(0.032) * (t0 * (S(0.6463220249999222) * (t19 * t30) - S(0.1088) * t0) - t1 * (S(0.6463220249999222) * (t20 * t30) + S(0.1088) * t1));
  M[3] = t30 * (S(0.1738624) * t30 + S(0.02068230479999751) * (t1 * t20 - t0 * t19)) - t32;
}

// bias: 114 multiplications, 68 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = qd0 * qd0;
  const S t5 = qd1 * qd1;
  const S t6 = S(0.032) * (t4 + t5) - S(0.064) * (qd0 * qd1);
  const S t7 = S(9.81) * t0 - t6 * t2 + S(0.41) * t4;
  const S t8 = S(0.032) * t2;
  const S t9 = S(0.032) * t3;
  const S t10 = S(0.024) - t9;
  const S t11 = atan2(t8, t10);
  const S t12 = S(0.001536) * t3;
  const S t13 = S(0.0016) - t12;
  const S t14 = sqrt(t13);
  const S t15 = S(1.0) / t14;
  const S t16 = t15 * (S(0.002356) - t12);
  const S t17 = acos(S(14.705882352941176) * t16);
  const S t18 = t11 - t17;
  const S t19 = sin(t18);
  const S t20 = cos(t18);
  const S t21 = t8 - S(0.034) * t19;
  const S t22 = t9 - (S(0.024) - S(0.034) * t20);
  const S t23 = atan2(-t21, -t22);
  const S t24 = S(1.5392278703071185) - t23;
  const S t25 = cos(t24);
  const S t26 = sin(t24);
  const S t27 = S(9.81) * t1 + t6 * t3 - S(0.012) * t4;
  const S t28 = S(1.0) / t13;
  const S t29 = t10 * t28;
  const S t30 = t2 * t28;
  const S t31 = t2 * t30;
  const S t32 = S(0.5) * t15;
  const S t33 = t15 * t16;
  const S t34 = t15 - t32 * t33;
  const S t35 = t2 * t34;
  const S t36 = S(1.0) - S(216.26297577854672) * (t16 * t16);
  const S t37 = sqrt(t36);
  const S t38 = S(0.02258823529411765) / t37;
  const S t39 = S(0.032) * (t3 * t29) - S(0.001024) * t31 + t35 * t38;
  const S t40 = t19 * t39;
  const S t41 = t2 * (S(0.000768) * t15);
  const S t42 = t33 * t41;
  const S t43 = t2 * (S(0.001536) * t15) - t42;
  const S t44 = t28 * t41;
  const S t45 = S(0.001024) * (t3 * t30 + t2 * (t28 * (t3 - S(0.001536) * t31)));
  const S t46 = t38 * (S(216.26297577854672) * (t16 * t35 * t43 / t36) - (t2 * (t44 - t32 * (t15 * (t42 - t43) + t16 * t44)) - t3 * t34)) - t45;
  const S t47 = t46 - S(0.032) * (t2 * (t29 - t3 * (t28 * (S(0.032) - S(0.001536) * t29))));
  const S t48 = S(1.0) / (t21 * t21 + t22 * t22);
  const S t49 = t22 * t48;
  const S t50 = t21 * t48;
  const S t51 = t20 * t39;
  const S t52 = t9 - S(0.034) * t51;
  const S t53 = t8 + S(0.034) * t40;
  const S t54 = t21 * t52;
  const S t55 = t22 * t53;
  const S t56 = t54 + t54 - (t55 + t55);
  const S t57 = t50 * (t9 + S(0.034) * (t19 * t47 + t39 * t51)) - t48 * (t52 * (t53 + t49 * t56) - t53 * (t52 - t50 * t56));
  const S t58 = t5 * ((t8 - S(0.034) * (t39 * t40 - t20 * t47)) * t49 - t57);
  const S t59 = t0 * t26 + t25 * t1;
  const S t60 = t1 * t26 - t0 * t25;
  const S t61 = f2 * t59 + f0 * t60;
  const S t62 = f2 * t60 - t59 * f0;
  const S t63 = S(0.6463220249999222) * (t7 * t25 - t27 * t26) - S(0.1738624) * t58 + (f4 + (S(1.0408340855860843e-17) * t61 + S(0.19009471323527125) * t62));
  const S t64 = t62 - S(0.6463220249999222) * t58;
  const S t65 = t49 * t52 + t50 * t53;
  const S t66 = qd0 - qd1 * t65;
  const S t67 = t61 - S(0.6463220249999222) * (t66 * t66);
  const S t68 = t25 * t64 - t26 * t67 + S(3.4) * t7;
  const S t69 = t25 * t67 + t26 * t64 - S(3.4) * t27;
  const S t70 = S(0.032) * (t3 * t68 - t2 * t69);
  c[0] = S(12.71376) * t1 - S(0.282528) * t0 - (t63 + t70 + (S(0.41) * t69 - S(0.012) * t68));
  c[1] = t70 + t63 * t65;
}

// mass_matrix_and_bias: 141 multiplications, 86 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = S(0.032) * t2;
  const S t5 = S(0.032) * t3;
  const S t6 = S(0.024) - t5;
  const S t7 = atan2(t4, t6);
  const S t8 = S(0.001536) * t3;
  const S t9 = S(0.0016) - t8;
  const S t10 = sqrt(t9);
  const S t11 = S(1.0) / t10;
  const S t12 = t11 * (S(0.002356) - t8);
  const S t13 = acos(S(14.705882352941176) * t12);
  const S t14 = t7 - t13;
  const S t15 = sin(t14);
  const S t16 = cos(t14);
  const S t17 = t4 - S(0.034) * t15;
  const S t18 = t5 - (S(0.024) - S(0.034) * t16);
  const S t19 = atan2(-t17, -t18);
  const S t20 = S(1.5392278703071185) - t19;
  const S t21 = cos(t20);
  const S t22 = sin(t20);
  const S t23 = S(0.012) - t5;
  const S t24 = S(0.6463220249999222) * t21 - S(3.4) * t23;
  const S t25 = S(0.41) - t4;
  const S t26 = S(0.6463220249999222) * t22 + S(3.4) * t25;
  const S t27 = S(0.032) * (t2 * t26 - t3 * t24);
  const S t28 = S(0.1738624) - S(0.6463220249999222) * (t21 * t23 - t22 * t25);
  M[0] = S(0.3563952000000001) - (S(0.012) * t24 - S(0.41) * t26 + (t27 - t28));
  const S t30 = S(1.0) / (t17 * t17 + t18 * t18);
  const S t31 = t18 * t30;
  const S t32 = S(1.0) / t9;
  const S t33 = t6 * t32;
  const S t34 = t2 * t32;
  const S t35 = t2 * t34;
  const S t36 = S(0.5) * t11;
  const S t37 = t11 * t12;
  const S t38 = t11 - t36 * t37;
  const S t39 = t2 * t38;
  const S t40 = S(1.0) - S(216.26297577854672) * (t12 * t12);
  const S t41 = sqrt(t40);
  const S t42 = S(0.02258823529411765) / t41;
  const S t43 = S(0.032) * (t3 * t33) - S(0.001024) * t35 + t39 * t42;
  const S t44 = t16 * t43;
  const S t45 = t5 - S(0.034) * t44;
  const S t46 = t15 * t43;
  const S t47 = t4 + S(0.034) * t46;
  const S t48 = t17 * t30;
  const S t49 = t31 * t45 + t47 * t48;
  const S t50 = t27 - t28 * t49;
  M[1] = t50;
  M[2] = t50;
  const S t51 = t49 * (S(0.1738624) * t49 - S(0.02068230479999751) * (t2 * t22 - t3 * t21));
  M[3] = S(0.032) * (t3 * (S(0.6463220249999222) * (t21 * t49) + S(0.1088) * t3) + t2 * (S(0.1088) * t2 - S(0.6463220249999222) * (t22 * t49))) + t51;
  const S t53 = qd0 * qd0;
  const S t54 = qd1 * qd1;
  const S t55 = S(0.032) * (t53 + t54) - S(0.064) * (qd0 * qd1);
  const S t56 = S(9.81) * t0 - t2 * t55 + S(0.41) * t53;
  const S t57 = S(9.81) * t1 + t3 * t55 - S(0.012) * t53;
  const S t58 = t2 * (S(0.000768) * t11);
  const S t59 = t37 * t58;
  const S t60 = t2 * (S(0.001536) * t11) - t59;
  const S t61 = t32 * t58;
  const S t62 = S(0.001024) * (t3 * t34 + t2 * (t32 * (t3 - S(0.001536) * t35)));
  const S t63 = t42 * (S(216.26297577854672) * (t12 * t39 * t60 / t40) - (t2 * (t61 - t36 * (t11 * (t59 - t60) + t12 * t61)) - t3 * t38)) - t62;
  const S t64 = t63 - S(0.032) * (t2 * (t33 - t3 * (t32 * (S(0.032) - S(0.001536) * t33))));
  const S t65 = t17 * t45;
  const S t66 = t18 * t47;
  const S t67 = t65 + t65 - (t66 + t66);
  const S t68 = t48 * (t5 + S(0.034) * (t15 * t64 + t43 * t44)) - t30 * (t45 * (t47 + t31 * t67) - t47 * (t45 - t48 * t67));
  const S t69 = t54 * (t31 * (t4 - S(0.034) * (t43 * t46 - t16 * t64)) - t68);
  const S t70 = t22 * t0 + t21 * t1;
  const S t71 = t22 * t1 - t21 * t0;
  const S t72 = f2 * t70 + f0 * t71;
  const S t73 = f2 * t71 - t70 * f0;
  const S t74 = S(0.6463220249999222) * (t21 * t56 - t22 * t57) - S(0.1738624) * t69 + (f4 + (S(1.0408340855860843e-17) * t72 + S(0.19009471323527125) * t73));
  const S t75 = t73 - S(0.6463220249999222) * t69;
  const S t76 = qd0 - t49 * qd1;
  const S t77 = t72 - S(0.6463220249999222) * (t76 * t76);
  const S t78 = t21 * t75 - t22 * t77 + S(3.4) * t56;
  const S t79 = t21 * t77 + t22 * t75 - S(3.4) * t57;
  const S t80 = S(0.032) * (t3 * t78 - t2 * t79);
  c[0] = S(12.71376) * t1 - S(0.282528) * t0 - (t74 + t80 + (S(0.41) * t79 - S(0.012) * t78));
  c[1] = t80 + t49 * t74;
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  qdot[0] = qd0;
  qdot[1] = qd1;
}

// energy: 63 multiplications, 35 additions, 5 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using detail::sines_and_cosines;
  using ::std::sqrt;
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = S(0.032) * t2;
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
  const S t19 = t17 * t17 + t18 * t18;
  const S t20 = sqrt(t19);
  const S t21 = S(1.0) / t20;
  const S t22 = t17 * t21;
  const S t23 = qd0 - qd1;
  const S t24 = S(0.41) * qd0 - t2 * (S(0.032) * t23);
  const S t25 = t18 * t21;
  const S t26 = S(0.012) * qd0 - S(0.032) * (t3 * t23);
  const S t27 = t22 * t24 + t25 * t26;
  const S t28 = t22 * t26 - t24 * t25;
  const S t29 = sqrt(S(1.0) - S(216.26297577854672) * (t9 * t9));
  const S t30 = t2 * (t8 - t8 * t9 * (S(0.5) * t8)) * (S(0.02258823529411765) / t29) - (S(0.001024) * (t2 * t2) - S(0.032) * (t3 * t12)) / t6;
  const S t31 = qd0 - qd1 * ((t17 * (t4 - S(0.034) * (t15 * t30)) + t18 * (t11 - S(0.034) * (t16 * t30))) / t19);
  e[0] = S(0.1781976) * (qd0 * qd0) + (S(1.7) * (t27 * t27 + t28 * t28) + t31 * (S(0.646) * t28 + S(0.0204) * t27 + S(0.0869312) * t31));
  const S t33 = S(0.19) * (t25 * t0 + t22 * t1) + (S(0.012) * t1 - (S(0.41) * t0 + S(0.032) * (t3 * t1 - t2 * t0)));
  e[1] = S(-33.354) * (S(0.006) * (t22 * t0 - t25 * t1) - t33) - S(70.632) * (S(0.18) * t0 + S(0.004) * t1);
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
  const S t0 = cosine[0];
  W[0] = t0;
  W[10] = t0;
  const S t1 = sine[0];
  W[2] = t1;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  W[8] = -t1;
  const S t5 = S(0.032) * t2;
  const S t6 = S(0.001536) * t2;
  const S t7 = sqrt(S(0.0016) - t6);
  const S t8 = acos(S(14.705882352941176) * ((S(0.002356) - t6) / t7));
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
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = S(0.032) * t2;
  const S t5 = S(0.001536) * t2;
  const S t6 = sqrt(S(0.0016) - t5);
  const S t7 = acos(S(14.705882352941176) * ((S(0.002356) - t5) / t6));
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
  const S t18 = t14 * t16;
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

// frame_jacobians: 58 multiplications, 34 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
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
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = S(0.032) * t3;
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
  const S t17 = t4 + S(0.034) * t15;
  const S t18 = t11 - (S(0.024) - S(0.034) * t16);
  const S t19 = sqrt(t17 * t17 + t18 * t18);
  const S t20 = S(1.0) / t19;
  const S t21 = t17 * t20;
  const S t22 = t18 * t20;
  const S t23 = t0 * t21 - t22 * t1;
  const S t24 = sqrt(S(1.0) - S(216.26297577854672) * (t9 * t9));
  const S t25 = t3 * (t8 - t8 * t9 * (S(0.5) * t8)) * (S(0.02258823529411765) / t24) - (S(0.001024) * (t3 * t3) - S(0.032) * (t2 * t12)) / t6;
  const S t26 = t11 - S(0.034) * (t16 * t25);
  const S t27 = t17 * t26;
  const S t28 = t4 - S(0.034) * (t15 * t25);
  const S t29 = t18 * t28;
  const S t30 = (t27 + t27 - (t29 + t29)) * (S(0.5) * t20);
  const S t31 = t20 * (t26 - t21 * t30);
  const S t32 = t20 * (t28 + t22 * t30);
  const S t33 = t1 * t31 - t0 * t32;
  const S t34 = t22 * t0 + t1 * t21;
  const S t35 = t1 * t32 + t0 * t31;
  J[3] = t23 * t33 - t34 * t35;
  const S t37 = S(0.032) * (t2 * t1 - t3 * t0);
  J[6] = S(0.42) * t34 - (t37 + (S(0.41) * t0 - S(0.012) * t1));
  J[7] = t37 - S(0.42) * t35;
  const S t40 = S(0.032) * (t2 * t0 + t3 * t1);
  J[10] = S(0.42) * t23 + (S(0.41) * t1 + S(0.012) * t0 - t40);
  J[11] = t40 - S(-0.42) * t33;
  J[0] = S(0.0);
  J[1] = S(0.0);
  J[4] = S(0.0);
  J[5] = S(0.0);
  J[8] = S(0.0);
  J[9] = S(0.0);
  J[2] = S(1.0);
}

}  // namespace alembert::mechanisms::four_bar_knee

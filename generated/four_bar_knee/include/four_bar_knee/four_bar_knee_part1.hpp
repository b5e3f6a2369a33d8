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

// inverse_dynamics: 132 multiplications, 81 additions, 6 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  const S qdd0 = qdd[0];  // dd(hip)
  const S qdd1 = qdd[1];  // dd(q)
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = S(0.032) * t0;
  const S t3 = S(0.032) * t1;
  const S t4 = S(0.024) - t3;
  const S t5 = atan2(t2, t4);
  const S t6 = S(0.001536) * t1;
  const S t7 = S(0.0016) - t6;
  const S t8 = sqrt(t7);
  const S t9 = S(1.0) / t8;
  const S t10 = t9 * (S(0.002356) - t6);
  const S t11 = acos(S(14.705882352941176) * t10);
  const S t12 = t5 - t11;
  const S t13 = sin(t12);
  const S t14 = cos(t12);
  const S t15 = t2 - S(0.034) * t13;
  const S t16 = t3 - (S(0.024) - S(0.034) * t14);
  const S t17 = t15 * t15 + t16 * t16;
  const S t18 = sqrt(t17);
  const S t19 = S(1.0) / t18;
  const S t20 = t15 * t19;
  const S t21 = S(1.0) / t17;
  const S t22 = t16 * t21;
  const S t23 = S(1.0) / t7;
  const S t24 = t4 * t23;
  const S t25 = t0 * t23;
  const S t26 = t0 * t25;
  const S t27 = S(0.5) * t9;
  const S t28 = t9 * t10;
  const S t29 = t9 - t27 * t28;
  const S t30 = t0 * t29;
  const S t31 = S(1.0) - S(216.26297577854672) * (t10 * t10);
  const S t32 = sqrt(t31);
  const S t33 = S(0.02258823529411765) / t32;
  const S t34 = S(0.032) * (t1 * t24) - S(0.001024) * t26 + t30 * t33;
  const S t35 = t14 * t34;
  const S t36 = t3 - S(0.034) * t35;
  const S t37 = t13 * t34;
  const S t38 = t2 + S(0.034) * t37;
  const S t39 = t15 * t21;
  const S t40 = t22 * t36 + t38 * t39;
  const S t41 = t0 * (S(0.000768) * t9);
  const S t42 = t28 * t41;
  const S t43 = t0 * (S(0.001536) * t9) - t42;
  const S t44 = t23 * t41;
  const S t45 = S(0.001024) * (t1 * t25 + t0 * (t23 * (t1 - S(0.001536) * t26)));
  const S t46 = t33 * (S(216.26297577854672) * (t10 * t30 * t43 / t31) - (t0 * (t44 - t27 * (t9 * (t42 - t43) + t10 * t44)) - t1 * t29)) - t45;
  const S t47 = t46 - S(0.032) * (t0 * (t24 - t1 * (t23 * (S(0.032) - S(0.001536) * t24))));
  const S t48 = t15 * t36;
  const S t49 = t16 * t38;
  const S t50 = t48 + t48 - (t49 + t49);
  const S t51 = t39 * (t3 + S(0.034) * (t13 * t47 + t34 * t35)) - t21 * (t36 * (t38 + t22 * t50) - t38 * (t36 - t39 * t50));
  const S t52 = qd1 * qd1;
  const S t53 = qdd0 - (qdd1 * t40 - (t22 * (t2 - S(0.034) * (t34 * t37 - t14 * t47)) - t51) * t52);
  const S t54 = qd0 - t40 * qd1;
  const S t55 = t54 * t54;
  const S t56 = qd0 * qd0;
  const S t57 = t52 + t56;
  const S t58 = qdd0 - qdd1;
  const S t59 = sin(q0);
  const S t60 = cos(q0);
  const S t61 = S(0.032) * (t1 * t57 - t0 * t58) + (S(9.81) * t59 + (S(0.41) * qdd0 - S(0.012) * t56)) - S(0.064) * (qd0 * (t1 * qd1));
  const S t62 = t16 * t19;
  const S t63 = S(9.81) * t60 + (S(0.41) * t56 + (S(0.012) * qdd0 - S(0.032) * (t1 * t58 + t0 * t57))) + S(0.064) * (qd0 * (t0 * qd1));
  const S t64 = t20 * t61 + t62 * t63;
  const S t65 = t62 * t60 + t20 * t59;
  const S t66 = t20 * t60 - t59 * t62;
  const S t67 = f2 * t65 - f0 * t66;
  const S t68 = S(0.0204) * t53 - S(0.646) * t55 + S(3.4) * t64 - t67;
  const S t69 = f2 * t66 + t65 * f0;
  const S t70 = t61 * t62 - t20 * t63;
  const S t71 = t69 - (S(0.0204) * t55 + S(0.646) * t53 - S(3.4) * t70);
  const S t72 = t20 * t68 + t62 * t71;
  const S t73 = t62 * t68 - t20 * t71;
  const S t74 = S(0.032) * (t1 * t73 + t0 * t72);
  const S t75 = f4 + (S(0.006) * t67 + S(0.19) * t69) - (S(0.1738624) * t53 - (S(0.646) * t70 - S(0.0204) * t64));
  tau[0] = S(0.41) * t72 + S(0.012) * t73 - (t74 + t75) + (S(12.71376) * t59 - S(0.282528) * t60 + S(0.3563952) * qdd0);
  tau[1] = t74 + t40 * t75;
}

// mass_matrix: 52 multiplications, 37 additions, 5 divisions, 4 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q1 = q[1];  // q
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(0.032) * t0;
  const S t3 = S(0.032) * t1;
  const S t4 = S(0.024) - t2;
  const S t5 = atan2(t3, t4);
  const S t6 = S(0.001536) * t0;
  const S t7 = S(0.0016) - t6;
  const S t8 = sqrt(t7);
  const S t9 = S(1.0) / t8;
  const S t10 = t9 * (S(0.002356) - t6);
  const S t11 = acos(S(14.705882352941176) * t10);
  const S t12 = t5 - t11;
  const S t13 = cos(t12);
  const S t14 = sin(t12);
  const S t15 = t2 - (S(0.024) - S(0.034) * t13);
  const S t16 = t3 - S(0.034) * t14;
  const S t17 = t16 * t16 + t15 * t15;
  const S t18 = sqrt(t17);
  const S t19 = S(1.0) / t18;
  const S t20 = t15 * t19;
  const S t21 = t16 * t19;
  const S t22 = S(0.0204) * t20 + S(0.646) * t21;
  const S t23 = S(0.0204) * t21 - S(0.646) * t20;
  const S t24 = S(0.82) * (S(0.697) - (S(0.1088) * t1 - t23)) - S(0.064) * (t1 * (t23 - S(0.0544) * t1) + t0 * (t22 - S(0.0544) * t0));
  M[0] = S(0.024) * (S(0.0204) - (S(0.1088) * t0 - t22)) + t24 + S(0.5302576000000001);
  const S t26 = sqrt(S(1.0) - S(216.26297577854672) * (t10 * t10));
  const S t27 = (S(0.032) * (t0 * t4) - S(0.001024) * (t1 * t1)) / t7 + t1 * (t9 - S(0.5) * t9 * (t9 * t10)) * (S(0.02258823529411765) / t26);
  const S t28 = (t16 * (t3 + S(0.034) * (t14 * t27)) + t15 * (t2 - S(0.034) * (t13 * t27))) / t17;
  const S t29 = t1 * t23 + t0 * t22;
  const S t30 = S(0.032) * t29;
  const S t31 = t28 * (S(-0.012) * t22 - S(0.41) * t23 - (S(0.1738624) - t30)) - (S(0.0034816) - t30 - (S(0.0013056) * t0 + S(0.044608) * t1));
  M[1] = t31;
  M[2] = t31;
  M[3] = S(0.0034816) - t28 * (S(0.064) * t29 - S(0.1738624) * t28);
}

// bias: 121 multiplications, 72 additions, 6 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t0 = sin(q0);
  const S t1 = cos(q0);
  const S t2 = cos(q1);
  const S t3 = sin(q1);
  const S t4 = S(0.032) * t2;
  const S t5 = S(0.032) * t3;
  const S t6 = S(0.024) - t4;
  const S t7 = atan2(t5, t6);
  const S t8 = S(0.001536) * t2;
  const S t9 = S(0.0016) - t8;
  const S t10 = sqrt(t9);
  const S t11 = S(1.0) / t10;
  const S t12 = t11 * (S(0.002356) - t8);
  const S t13 = acos(S(14.705882352941176) * t12);
  const S t14 = t7 - t13;
  const S t15 = cos(t14);
  const S t16 = sin(t14);
  const S t17 = t4 - (S(0.024) - S(0.034) * t15);
  const S t18 = t5 - S(0.034) * t16;
  const S t19 = t18 * t18 + t17 * t17;
  const S t20 = sqrt(t19);
  const S t21 = S(1.0) / t20;
  const S t22 = t17 * t21;
  const S t23 = qd0 * qd0;
  const S t24 = qd1 * qd1;
  const S t25 = S(0.032) * (t23 + t24) - S(0.064) * (qd0 * qd1);
  const S t26 = S(9.81) * t1 - t3 * t25 + S(0.41) * t23;
  const S t27 = t18 * t21;
  const S t28 = S(9.81) * t0 + t2 * t25 - S(0.012) * t23;
  const S t29 = t26 * t27 - t22 * t28;
  const S t30 = S(1.0) / t19;
  const S t31 = t17 * t30;
  const S t32 = S(1.0) / t9;
  const S t33 = t6 * t32;
  const S t34 = t3 * t32;
  const S t35 = t3 * t34;
  const S t36 = S(0.5) * t11;
  const S t37 = t11 * t12;
  const S t38 = t11 - t36 * t37;
  const S t39 = t3 * t38;
  const S t40 = S(1.0) - S(216.26297577854672) * (t12 * t12);
  const S t41 = sqrt(t40);
  const S t42 = S(0.02258823529411765) / t41;
  const S t43 = S(0.032) * (t2 * t33) - S(0.001024) * t35 + t39 * t42;
  const S t44 = t15 * t43;
  const S t45 = t4 - S(0.034) * t44;
  const S t46 = t16 * t43;
  const S t47 = t5 + S(0.034) * t46;
  const S t48 = t18 * t30;
  const S t49 = t31 * t45 + t47 * t48;
  const S t50 = qd0 - qd1 * t49;
  const S t51 = t50 * t50;
  const S t52 = t3 * (S(0.000768) * t11);
  const S t53 = t37 * t52;
  const S t54 = t3 * (S(0.001536) * t11) - t53;
  const S t55 = t32 * t52;
  const S t56 = S(0.001024) * (t2 * t34 + t3 * (t32 * (t2 - S(0.001536) * t35)));
  const S t57 = t42 * (S(216.26297577854672) * (t12 * t39 * t54 / t40) - (t3 * (t55 - t36 * (t11 * (t53 - t54) + t12 * t55)) - t2 * t38)) - t56;
  const S t58 = t57 - S(0.032) * (t3 * (t33 - t2 * (t32 * (S(0.032) - S(0.001536) * t33))));
  const S t59 = t18 * t45;
  const S t60 = t17 * t47;
  const S t61 = t59 + t59 - (t60 + t60);
  const S t62 = t48 * (t4 + S(0.034) * (t16 * t58 + t43 * t44)) - t30 * (t45 * (t47 + t31 * t61) - t47 * (t45 - t48 * t61));
  const S t63 = t24 * (t31 * (t5 - S(0.034) * (t43 * t46 - t15 * t58)) - t62);
  const S t64 = t1 * t27 - t0 * t22;
  const S t65 = t1 * t22 + t0 * t27;
  const S t66 = f2 * t64 + f0 * t65;
  const S t67 = S(3.4) * t29 + (S(0.0204) * t51 + S(0.646) * t63) - t66;
  const S t68 = t27 * t28 + t22 * t26;
  const S t69 = f2 * t65 - t64 * f0;
  const S t70 = S(3.4) * t68 + (S(0.0204) * t63 - S(0.646) * t51) - t69;
  const S t71 = t22 * t67 - t27 * t70;
  const S t72 = t22 * t70 + t27 * t67;
  const S t73 = f4 + (S(0.006) * t69 + S(0.19) * t66) - (S(0.646) * t29 + S(0.0204) * t68 + S(0.1738624) * t63);
  const S t74 = S(0.032) * (t3 * t71 - t2 * t72);
  c[0] = S(12.71376) * t0 - S(0.282528) * t1 - (S(0.41) * t71 - S(0.012) * t72 + (t73 - t74));
  c[1] = t49 * t73 - t74;
}

// mass_matrix_and_bias: 145 multiplications, 94 additions, 6 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
  const S f0 = in.wrenches[0];  // wrench(shank).fx
  const S f2 = in.wrenches[2];  // wrench(shank).fz
  const S f4 = in.wrenches[4];  // wrench(shank).ty
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(0.032) * t0;
  const S t3 = S(0.032) * t1;
  const S t4 = S(0.024) - t2;
  const S t5 = atan2(t3, t4);
  const S t6 = S(0.001536) * t0;
  const S t7 = S(0.0016) - t6;
  const S t8 = sqrt(t7);
  const S t9 = S(1.0) / t8;
  const S t10 = t9 * (S(0.002356) - t6);
  const S t11 = acos(S(14.705882352941176) * t10);
  const S t12 = t5 - t11;
  const S t13 = cos(t12);
  const S t14 = sin(t12);
  const S t15 = t2 - (S(0.024) - S(0.034) * t13);
  const S t16 = t3 - S(0.034) * t14;
  const S t17 = t16 * t16 + t15 * t15;
  const S t18 = sqrt(t17);
  const S t19 = S(1.0) / t18;
  const S t20 = t15 * t19;
  const S t21 = t16 * t19;
  const S t22 = S(0.0204) * t20 + S(0.646) * t21;
  const S t23 = S(0.0204) * t21 - S(0.646) * t20;
  const S t24 = S(0.82) * (S(0.697) - (S(0.1088) * t1 - t23)) - S(0.064) * (t1 * (t23 - S(0.0544) * t1) + t0 * (t22 - S(0.0544) * t0));
  M[0] = S(0.024) * (S(0.0204) - (S(0.1088) * t0 - t22)) + t24 + S(0.5302576000000001);
  const S t26 = S(1.0) / t17;
  const S t27 = t15 * t26;
  const S t28 = S(1.0) / t7;
  const S t29 = t4 * t28;
  const S t30 = t1 * t28;
  const S t31 = t1 * t30;
  const S t32 = S(0.5) * t9;
  const S t33 = t9 * t10;
  const S t34 = t9 - t32 * t33;
  const S t35 = t1 * t34;
  const S t36 = S(1.0) - S(216.26297577854672) * (t10 * t10);
  const S t37 = sqrt(t36);
  const S t38 = S(0.02258823529411765) / t37;
  const S t39 = S(0.032) * (t0 * t29) - S(0.001024) * t31 + t35 * t38;
  const S t40 = t13 * t39;
  const S t41 = t2 - S(0.034) * t40;
  const S t42 = t14 * t39;
  const S t43 = t3 + S(0.034) * t42;
  const S t44 = t16 * t26;
  const S t45 = t27 * t41 + t43 * t44;
  const S t46 = t1 * t23 + t0 * t22;
  const S t47 = S(0.032) * t46;
  const S t48 = t45 * (S(-0.012) * t22 - S(0.41) * t23 - (S(0.1738624) - t47)) - (S(0.0034816) - t47 - (S(0.0013056) * t0 + S(0.044608) * t1));
  M[1] = t48;
  M[2] = t48;
  M[3] = t45 * (S(0.1738624) * t45 - S(0.064) * t46) + S(0.0034816);
  const S t50 = sin(q0);
  const S t51 = cos(q0);
  const S t52 = qd0 * qd0;
  const S t53 = qd1 * qd1;
  const S t54 = S(0.032) * (t52 + t53) - S(0.064) * (qd0 * qd1);
  const S t55 = S(9.81) * t51 - t1 * t54 + S(0.41) * t52;
  const S t56 = S(9.81) * t50 + t0 * t54 - S(0.012) * t52;
  const S t57 = t21 * t55 - t20 * t56;
  const S t58 = qd0 - t45 * qd1;
  const S t59 = t58 * t58;
  const S t60 = t1 * (S(0.000768) * t9);
  const S t61 = t33 * t60;
  const S t62 = t1 * (S(0.001536) * t9) - t61;
  const S t63 = t28 * t60;
  const S t64 = S(0.001024) * (t0 * t30 + t1 * (t28 * (t0 - S(0.001536) * t31)));
  const S t65 = t38 * (S(216.26297577854672) * (t10 * t35 * t62 / t36) - (t1 * (t63 - t32 * (t9 * (t61 - t62) + t10 * t63)) - t0 * t34)) - t64;
  const S t66 = t65 - S(0.032) * (t1 * (t29 - t0 * (t28 * (S(0.032) - S(0.001536) * t29))));
  const S t67 = t16 * t41;
  const S t68 = t15 * t43;
  const S t69 = t67 + t67 - (t68 + t68);
  const S t70 = t44 * (t2 + S(0.034) * (t14 * t66 + t39 * t40)) - t26 * (t41 * (t43 + t27 * t69) - t43 * (t41 - t44 * t69));
  const S t71 = t53 * (t27 * (t3 - S(0.034) * (t39 * t42 - t13 * t66)) - t70);
  const S t72 = t21 * t51 - t20 * t50;
  const S t73 = t20 * t51 + t21 * t50;
  const S t74 = f2 * t72 + f0 * t73;
  const S t75 = S(3.4) * t57 + (S(0.0204) * t59 + S(0.646) * t71) - t74;
  const S t76 = t21 * t56 + t20 * t55;
  const S t77 = f2 * t73 - t72 * f0;
  const S t78 = S(3.4) * t76 + (S(0.0204) * t71 - S(0.646) * t59) - t77;
  const S t79 = t20 * t75 - t21 * t78;
  const S t80 = t20 * t78 + t21 * t75;
  const S t81 = f4 + (S(0.006) * t77 + S(0.19) * t74) - (S(0.646) * t57 + S(0.0204) * t76 + S(0.1738624) * t71);
  const S t82 = S(0.032) * (t1 * t79 - t0 * t80);
  c[0] = S(12.71376) * t50 - S(0.282528) * t51 - (S(0.41) * t79 - S(0.012) * t80 + (t81 - t82));
  c[1] = t45 * t81 - t82;
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
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S qd0 = qd[0];  // d(hip)
  const S qd1 = qd[1];  // d(q)
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
  const S t17 = t15 * t15 + t16 * t16;
  const S t18 = sqrt(t17);
  const S t19 = S(1.0) / t18;
  const S t20 = t15 * t19;
  const S t21 = qd0 - qd1;
  const S t22 = S(0.41) * qd0 - t0 * (S(0.032) * t21);
  const S t23 = t16 * t19;
  const S t24 = S(0.012) * qd0 - S(0.032) * (t1 * t21);
  const S t25 = t20 * t22 + t23 * t24;
  const S t26 = t20 * t24 - t22 * t23;
  const S t27 = sqrt(S(1.0) - S(216.26297577854672) * (t7 * t7));
  const S t28 = t0 * (t6 - t6 * t7 * (S(0.5) * t6)) * (S(0.02258823529411765) / t27) - (S(0.001024) * (t0 * t0) - S(0.032) * (t1 * t10)) / t4;
  const S t29 = qd0 - qd1 * ((t15 * (t2 - S(0.034) * (t13 * t28)) + t16 * (t9 - S(0.034) * (t14 * t28))) / t17);
  e[0] = S(0.1781976) * (qd0 * qd0) + (S(1.7) * (t25 * t25 + t26 * t26) + t29 * (S(0.646) * t26 + S(0.0204) * t25 + S(0.0869312) * t29));
  const S t31 = cos(q0);
  const S t32 = sin(q0);
  const S t33 = S(0.19) * (t23 * t31 + t20 * t32) + (S(0.012) * t32 - (S(0.41) * t31 + S(0.032) * (t1 * t32 - t0 * t31)));
  e[1] = S(-33.354) * (S(0.006) * (t20 * t31 - t23 * t32) - t33) - S(70.632) * (S(0.18) * t31 + S(0.004) * t32);
}

// body_poses: 18 multiplications, 14 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::acos;
  using ::std::atan2;
  using ::std::cos;
  using ::std::sin;
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S t0 = cos(q0);
  W[0] = t0;
  W[10] = t0;
  const S t1 = sin(q0);
  W[2] = t1;
  W[8] = -t1;
  const S t3 = cos(q1);
  const S t4 = sin(q1);
  const S t5 = S(0.032) * t3;
  const S t6 = S(0.001536) * t3;
  const S t7 = sqrt(S(0.0016) - t6);
  const S t8 = acos(S(14.705882352941176) * ((S(0.002356) - t6) / t7));
  const S t9 = S(0.032) * t4;
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
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(0.032) * t0;
  const S t3 = S(0.001536) * t0;
  const S t4 = sqrt(S(0.0016) - t3);
  const S t5 = acos(S(14.705882352941176) * ((S(0.002356) - t3) / t4));
  const S t6 = S(0.032) * t1;
  const S t7 = atan2(t6, S(0.024) - t2);
  const S t8 = t5 - t7;
  const S t9 = cos(t8);
  const S t10 = sin(t8);
  const S t11 = t2 - (S(0.024) - S(0.034) * t9);
  const S t12 = t6 + S(0.034) * t10;
  const S t13 = sqrt(t12 * t12 + t11 * t11);
  const S t14 = S(1.0) / t13;
  const S t15 = t11 * t14;
  const S t16 = cos(q0);
  const S t17 = sin(q0);
  const S t18 = t12 * t14;
  const S t19 = t15 * t16 + t17 * t18;
  const S t20 = -t19;
  F[0] = t20;
  F[10] = t20;
  const S t21 = t16 * t18 - t15 * t17;
  F[2] = t21;
  F[3] = t16 * (t2 - S(0.012)) - (S(0.42) * t21 + t17 * (S(0.41) - t6));
  F[8] = -t21;
  F[11] = S(0.42) * t19 + (S(0.012) * t17 - (S(0.41) * t16 + S(0.032) * (t0 * t17 - t1 * t16)));
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
  using ::std::sqrt;
  const S q0 = q[0];  // hip
  const S q1 = q[1];  // q
  const S t0 = cos(q0);
  const S t1 = sin(q0);
  const S t2 = sin(q1);
  const S t3 = cos(q1);
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
  const S t19 = sqrt(t17 * t17 + t18 * t18);
  const S t20 = S(1.0) / t19;
  const S t21 = t17 * t20;
  const S t22 = t18 * t20;
  const S t23 = t0 * t21 - t22 * t1;
  const S t24 = sqrt(S(1.0) - S(216.26297577854672) * (t9 * t9));
  const S t25 = t2 * (t8 - t8 * t9 * (S(0.5) * t8)) * (S(0.02258823529411765) / t24) - (S(0.001024) * (t2 * t2) - S(0.032) * (t3 * t12)) / t6;
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
  const S t37 = S(0.032) * (t3 * t1 - t2 * t0);
  J[6] = S(0.42) * t34 - (t37 + (S(0.41) * t0 - S(0.012) * t1));
  J[7] = t37 - S(0.42) * t35;
  const S t40 = S(0.032) * (t3 * t0 + t2 * t1);
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

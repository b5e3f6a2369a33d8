// free_body: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "free_body". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "free_body_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::free_body {

// inverse_dynamics: 90 multiplications, 115 additions (reduced formulation; relative error 3e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  const S q3 = q[3];  // turn.x
  const S t0 = q3 * q3;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S q4 = q[4];  // turn.y
  const S t4 = q4 * q4;
  const S t5 = t1 + t4;
  const S t6 = t0 + t4;
  const S t7 = S(1.0) - (t5 + t5);
  const S t8 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t9 = q5 * q6;
  const S t10 = t8 - t9;
  const S t11 = t8 + t9;
  const S t12 = q4 * q5;
  const S t13 = q3 * q5;
  const S t14 = q3 * q6;
  const S t15 = q4 * q6;
  const S t16 = S(1.0) - (t6 + t6);
  const S t17 = t13 - t15;
  const S t18 = t13 + t15;
  const S t19 = t12 + t14;
  const S t20 = t12 - t14;
  const S qdd1 = qdd[1];  // dd(y)
  const S t21 = qdd1 * t11;
  const S qdd0 = qdd[0];  // dd(x)
  const S t22 = t10 * qdd0;
  const S t23 = qdd0 * t18;
  const S t24 = qdd1 * t20;
  const S qdd2 = qdd[2];  // dd(z)
  const S t25 = qdd2 + S(9.81);
  const S t26 = t25 * t16 + (t24 + t24 + (t23 + t23));
  const S t27 = t19 * t25;
  const S t28 = t27 + t27 + (t22 + t22 + qdd1 * t3);
  const S t29 = t25 * t17;
  const S t30 = qdd0 * t7 + (t21 + t21) + (t29 + t29);
  const S qd5 = qd[5];  // d(turn).z
  const S t31 = qd5 * qd5;
  const S qd3 = qd[3];  // d(turn).x
  const S t32 = qd3 * qd3;
  const S qd4 = qd[4];  // d(turn).y
  const S t33 = qd4 * qd3;
  const S t34 = qd3 * qd5;
  const S t35 = qd4 * qd5;
  const S t36 = qd4 * qd4;
  const S qdd5 = qdd[5];  // dd(turn).z
  const S t37 = qdd5 + t33;
  const S t38 = qdd5 - t33;
  const S qdd3 = qdd[3];  // dd(turn).x
  const S t39 = qdd3 - t35;
  const S t40 = qdd3 + t35;
  const S qdd4 = qdd[4];  // dd(turn).y
  const S t41 = qdd4 + t34;
  const S t42 = qdd4 - t34;
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t43 = f2 * t17;
  const S t44 = t19 * f2;
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t45 = t10 * f0;
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S t46 = t45 + t45 + t3 * f1 + (t44 + t44);
  const S t47 = f1 * t11;
  const S t48 = t47 + t47 + f0 * t7 + (t43 + t43);
  const S t49 = f0 * t18;
  const S t50 = f1 * t20;
  const S t51 = f2 * t16 + (t50 + t50 + (t49 + t49));
  const S t52 = S(3.7) * t30 + (S(0.111) * t38 - S(0.185) * (t31 + t36) + S(0.296) * t41) - t48;
  const S t53 = S(3.7) * t28 + (S(0.185) * t37 + S(0.111) * (t31 + t32) - S(0.296) * t39) - t46;
  const S t54 = S(3.7) * t26 - (S(0.296) * (t32 + t36) + (S(0.185) * t42 + S(0.111) * t40)) - t51;
  const S t55 = S(0.296) * t28 + S(0.111) * t26 - (S(0.10368) * t39 + (S(0.23333) * t40 + (S(0.02655) * t42 - S(0.0488) * t37 - S(0.02488) * (t31 - t36))));
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S t56 = t11 * f4;
  const S t57 = t20 * f4;
  const S t58 = t11 * t52;
  const S t59 = t20 * t54;
  tau[1] = t59 + t59 + (t3 * t53 + (t58 + t58));
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S t61 = t10 * f3;
  const S t62 = t10 * t53;
  const S t63 = t18 * f3;
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t64 = S(0.05) * t46 + S(0.03) * t48 + (t16 * f5 + (t57 + t57 + (t63 + t63)));
  const S t65 = t19 * t53;
  const S t66 = t19 * f5;
  const S t67 = t3 * f4 + (t61 + t61) + (t66 + t66) + (S(0.08) * t48 - S(0.05) * t51);
  const S t68 = t17 * f5;
  tau[3] = S(0.08) * t46 + S(0.03) * t51 - (t68 + t68 + (t56 + t56 + t7 * f3)) - t55;
  const S t70 = t17 * t52;
  tau[2] = t16 * t54 + (t70 + t70 + (t65 + t65));
  const S t72 = t18 * t54;
  tau[0] = t62 + t62 + t7 * t52 + (t72 + t72);
  tau[4] = S(0.296) * t30 - S(0.185) * t26 + (S(0.19925) * t42 + (S(0.02488) * t38 + S(0.02655) * t40 - S(0.0488) * (t31 - t32) + S(0.10368) * t41)) - t67;
  tau[5] = S(0.185) * t28 + S(0.111) * t30 + (S(0.23333) * t38 + (S(0.19925) * t37 + (S(0.02655) * (t32 - t36) - (S(0.0488) * t39 - S(0.02488) * t41)))) - t64;
}

// mass_matrix: 27 multiplications, 24 additions (reduced formulation; relative error 6.9e-17 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S q3 = q[3];  // turn.x
  const S t4 = q3 * q3;
  const S t5 = t1 + t4;
  const S t6 = t0 + t4;
  const S t7 = S(1.0) - (t6 + t6);
  const S t8 = S(1.0) - (t5 + t5);
  const S t9 = q4 * q3;
  const S t10 = q5 * q3;
  const S q6 = q[6];  // turn.w
  const S t11 = q6 * q3;
  const S t12 = q6 * q5;
  const S t13 = q6 * q4;
  const S t14 = q5 * q4;
  const S t15 = t11 - t14;
  const S t16 = t11 + t14;
  const S t17 = t13 + t10;
  const S t18 = t13 - t10;
  const S t19 = t12 - t9;
  const S t20 = t12 + t9;
  const S t21 = S(0.37) * t15 + S(0.592) * t20;
  M[10] = t21;
  M[25] = t21;
  const S t22 = S(0.222) * t15 - S(0.296) * t8;
  M[9] = t22;
  M[19] = t22;
  const S t23 = S(0.185) * t8 + S(0.222) * t20;
  M[11] = t23;
  M[31] = t23;
  const S t24 = S(0.592) * t19 - S(0.222) * t17;
  M[3] = t24;
  M[18] = t24;
  const S t25 = S(0.296) * t3 - S(0.37) * t17;
  M[4] = t25;
  M[24] = t25;
  const S t26 = S(0.111) * t3 - S(0.37) * t19;
  M[5] = t26;
  M[30] = t26;
  const S t27 = S(-0.185) * t7 - S(0.592) * t18;
  M[16] = t27;
  M[26] = t27;
  const S t28 = S(-0.111) * t7 - S(0.592) * t16;
  M[15] = t28;
  M[20] = t28;
  const S t29 = S(0.37) * t16 - S(0.222) * t18;
  M[17] = t29;
  M[32] = t29;
  M[0] = S(3.7);
  M[7] = S(3.7);
  M[14] = S(3.7);
  M[1] = S(0.0);
  M[2] = S(0.0);
  M[6] = S(0.0);
  M[8] = S(0.0);
  M[12] = S(0.0);
  M[13] = S(0.0);
  M[21] = S(0.33701);
  M[22] = S(0.02655);
  M[27] = S(0.02655);
  M[23] = S(-0.0488);
  M[33] = S(-0.0488);
  M[28] = S(0.30293);
  M[29] = S(0.02488);
  M[34] = S(0.02488);
  M[35] = S(0.43258);
}

// bias: 75 multiplications, 91 additions (reduced formulation; relative error 1.7e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  const S q3 = q[3];  // turn.x
  const S t0 = q3 * q3;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S q4 = q[4];  // turn.y
  const S t4 = q4 * q4;
  const S t5 = t4 + t1;
  const S t6 = S(1.0) - (t5 + t5);
  const S t7 = t4 + t0;
  const S t8 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t9 = q6 * q5;
  const S t10 = t9 - t8;
  const S t11 = t9 + t8;
  const S t12 = q6 * q3;
  const S t13 = q4 * q6;
  const S t14 = q4 * q5;
  const S t15 = q3 * q5;
  const S t16 = t13 - t15;
  const S t17 = t13 + t15;
  const S t18 = t12 + t14;
  const S t19 = t12 - t14;
  const S t20 = S(1.0) - (t7 + t7);
  const S qd3 = qd[3];  // d(turn).x
  const S t21 = qd3 * qd3;
  const S qd5 = qd[5];  // d(turn).z
  const S t22 = qd5 * qd5;
  const S qd4 = qd[4];  // d(turn).y
  const S t23 = qd4 * qd4;
  const S t24 = qd4 * qd3;
  const S t25 = qd4 * qd5;
  const S t26 = qd3 * qd5;
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S t27 = f1 * t11;
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t28 = f0 * t10;
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t29 = f2 * t18;
  const S t30 = t29 + t29 + (f1 * t3 - (t28 + t28));
  const S t31 = t30 - (S(0.296) * t25 + (S(0.111) * (t21 + t22) + S(0.185) * t24));
  const S t32 = f1 * t19;
  const S t33 = f2 * t16;
  const S t34 = t33 + t33 - (f0 * t6 + (t27 + t27));
  const S t35 = t17 * f0;
  const S t36 = t35 + t35 - (t32 + t32) + f2 * t20;
  const S t37 = S(0.111) * t24 + S(0.185) * (t23 + t22) - S(0.296) * t26 - t34;
  const S t38 = S(0.296) * (t23 + t21) - (S(0.185) * t26 - S(0.111) * t25) + t36;
  const S t39 = S(5.80752) * t16 + S(1.81485) * t20 + (S(0.02488) * t24 - S(0.02655) * t25 - S(0.0488) * (t21 - t22) + S(0.09557) * t26);
  const S t40 = S(0.12965) * t25 + (S(0.02488) * (t23 - t22) - (S(0.0488) * t24 + S(0.02655) * t26)) - (S(1.08891) * t20 + S(5.80752) * t18);
  const S t41 = S(2.17782) * t16 - S(3.6297) * t18 - (S(0.02488) * t26 + S(0.0488) * t25 - S(0.02655) * (t23 - t21) - S(0.03408) * t24);
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S t42 = t17 * f3;
  const S t43 = t10 * f3;
  const S t44 = t16 * t37;
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t45 = t16 * f5;
  const S t46 = t18 * f5;
  const S f4 = in.wrenches[4];  // wrench(body).ty
  c[4] = S(0.05) * t36 + S(0.08) * t34 + (t43 + t43 - t3 * f4 - (t46 + t46)) - t39;
  const S t48 = t18 * t31;
  const S t49 = t10 * t31;
  c[2] = S(36.297) - (t20 * t38 + (t48 + t48 - (t44 + t44)));
  const S t51 = t11 * f4;
  c[3] = S(0.03) * t36 + S(0.08) * t30 + (t45 + t45 - (t51 + t51 + t6 * f3)) + t40;
  const S t53 = t19 * f4;
  c[5] = S(0.03) * t34 - S(0.05) * t30 - (t20 * f5 - (t53 + t53 - (t42 + t42))) - t41;
  const S t55 = t11 * t37;
  const S t56 = t19 * t38;
  c[1] = t56 + t56 - (t55 + t55 + t3 * t31);
  const S t58 = t17 * t38;
  c[0] = t49 + t49 - t6 * t37 - (t58 + t58);
}

// mass_matrix_and_bias: 93 multiplications, 100 additions (reduced formulation; relative error 1.7e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S q3 = q[3];  // turn.x
  const S t4 = q3 * q3;
  const S t5 = t1 + t4;
  const S t6 = S(1.0) - (t5 + t5);
  const S t7 = t0 + t4;
  const S t8 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t9 = q6 * q5;
  const S t10 = t9 - t8;
  const S t11 = t9 + t8;
  const S t12 = q6 * q4;
  const S t13 = q6 * q3;
  const S t14 = q5 * q3;
  const S t15 = q5 * q4;
  const S t16 = t13 + t15;
  const S t17 = t13 - t15;
  const S t18 = t12 - t14;
  const S t19 = t12 + t14;
  const S t20 = S(1.0) - (t7 + t7);
  const S qd3 = qd[3];  // d(turn).x
  const S t21 = qd3 * qd3;
  const S qd5 = qd[5];  // d(turn).z
  const S t22 = qd5 * qd5;
  const S qd4 = qd[4];  // d(turn).y
  const S t23 = qd4 * qd4;
  const S t24 = qd4 * qd3;
  const S t25 = qd4 * qd5;
  const S t26 = qd3 * qd5;
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S t27 = t11 * f1;
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t28 = t10 * f0;
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t29 = t18 * f2;
  const S t30 = t29 + t29 - (t3 * f0 + (t27 + t27));
  const S t31 = S(0.111) * t24 + S(0.185) * (t23 + t22) - S(0.296) * t26 - t30;
  const S t32 = t19 * f0;
  const S t33 = t16 * f2;
  const S t34 = t33 + t33 + (t6 * f1 - (t28 + t28));
  const S t35 = t17 * f1;
  const S t36 = t32 + t32 - (t35 + t35) + t20 * f2;
  const S t37 = t34 - (S(0.296) * t25 + (S(0.111) * (t21 + t22) + S(0.185) * t24));
  const S t38 = S(0.296) * (t23 + t21) - (S(0.185) * t26 - S(0.111) * t25) + t36;
  const S t39 = S(0.12965) * t25 + (S(0.02488) * (t23 - t22) - (S(0.0488) * t24 + S(0.02655) * t26)) - (S(1.08891) * t20 + S(5.80752) * t16);
  const S t40 = S(5.80752) * t18 + S(1.81485) * t20 + (S(0.02488) * t24 - S(0.02655) * t25 - S(0.0488) * (t21 - t22) + S(0.09557) * t26);
  const S t41 = S(2.17782) * t18 - S(3.6297) * t16 - (S(0.02488) * t26 + S(0.0488) * t25 - S(0.02655) * (t23 - t21) - S(0.03408) * t24);
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S t42 = t17 * f4;
  const S t43 = t11 * f4;
  const S t44 = t16 * t37;
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t45 = t16 * f5;
  const S t46 = t18 * f5;
  const S t47 = t18 * t31;
  c[2] = S(36.297) - (t20 * t38 + (t44 + t44 - (t47 + t47)));
  const S f3 = in.wrenches[3];  // wrench(body).tx
  c[3] = S(0.03) * t36 + S(0.08) * t34 + (t46 + t46 - (t43 + t43 + t3 * f3)) + t39;
  const S t50 = t10 * f3;
  const S t51 = t19 * f3;
  c[5] = S(0.03) * t30 - S(0.05) * t34 - (t20 * f5 - (t42 + t42 - (t51 + t51))) - t41;
  c[4] = S(0.05) * t36 + S(0.08) * t30 + (t50 + t50 - t6 * f4 - (t45 + t45)) - t40;
  const S t54 = t10 * t37;
  const S t55 = t11 * t31;
  const S t56 = t19 * t38;
  c[0] = t54 + t54 - t3 * t31 - (t56 + t56);
  const S t58 = t17 * t38;
  c[1] = t58 + t58 - (t55 + t55 + t6 * t37);
  const S t60 = S(0.222) * t17 - S(0.296) * t6;
  M[9] = t60;
  M[19] = t60;
  const S t61 = S(0.37) * t17 + S(0.592) * t11;
  M[10] = t61;
  M[25] = t61;
  const S t62 = S(0.185) * t6 + S(0.222) * t11;
  M[11] = t62;
  M[31] = t62;
  const S t63 = S(0.296) * t3 - S(0.37) * t19;
  M[4] = t63;
  M[24] = t63;
  const S t64 = S(0.592) * t10 - S(0.222) * t19;
  M[3] = t64;
  M[18] = t64;
  const S t65 = S(0.111) * t3 - S(0.37) * t10;
  M[5] = t65;
  M[30] = t65;
  const S t66 = S(-0.111) * t20 - S(0.592) * t16;
  M[15] = t66;
  M[20] = t66;
  const S t67 = S(-0.185) * t20 - S(0.592) * t18;
  M[16] = t67;
  M[26] = t67;
  const S t68 = S(0.37) * t16 - S(0.222) * t18;
  M[17] = t68;
  M[32] = t68;
  M[29] = S(0.02488);
  M[34] = S(0.02488);
  M[22] = S(0.02655);
  M[27] = S(0.02655);
  M[0] = S(3.7);
  M[7] = S(3.7);
  M[14] = S(3.7);
  M[1] = S(0.0);
  M[2] = S(0.0);
  M[6] = S(0.0);
  M[8] = S(0.0);
  M[12] = S(0.0);
  M[13] = S(0.0);
  M[21] = S(0.33701);
  M[23] = S(-0.0488);
  M[33] = S(-0.0488);
  M[28] = S(0.30293);
  M[35] = S(0.43258);
}

// coordinate_rates: 15 multiplications, 8 additions (reduced formulation; relative error 1e-16 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd4 = qd[4];  // d(turn).y
  const S t0 = S(0.5) * qd4;
  const S qd3 = qd[3];  // d(turn).x
  const S t1 = S(0.5) * qd3;
  const S qd5 = qd[5];  // d(turn).z
  const S t2 = S(0.5) * qd5;
  const S q5 = q[5];  // turn.z
  const S q3 = q[3];  // turn.x
  const S q4 = q[4];  // turn.y
  qdot[6] = -(q5 * t2 + (t1 * q3 + t0 * q4));
  const S q6 = q[6];  // turn.w
  qdot[3] = q4 * t2 - (q5 * t0 - q6 * t1);
  qdot[4] = t0 * q6 + q5 * t1 - t2 * q3;
  qdot[5] = q6 * t2 + (t0 * q3 - t1 * q4);
  const S qd0 = qd[0];  // d(x)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(y)
  qdot[1] = qd1;
  const S qd2 = qd[2];  // d(z)
  qdot[2] = qd2;
}

// energy: 48 multiplications, 47 additions (reduced formulation; relative error 2.5e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q3 = q[3];  // turn.x
  const S t1 = q3 * q3;
  const S t2 = q4 * q3;
  const S q5 = q[5];  // turn.z
  const S t3 = q5 * q5;
  const S t4 = t0 + t3;
  const S t5 = t1 + t3;
  const S t6 = t0 + t1;
  const S q6 = q[6];  // turn.w
  const S t7 = q6 * q5;
  const S t8 = q4 * q6;
  const S t9 = q6 * q3;
  const S t10 = q3 * q5;
  const S t11 = q4 * q5;
  const S t12 = S(1.0) - (t6 + t6);
  const S qd1 = qd[1];  // d(y)
  const S t13 = qd1 * (t7 + t2);
  const S qd0 = qd[0];  // d(x)
  const S t14 = qd0 * (t7 - t2);
  const S t15 = qd0 * (t8 + t10);
  const S t16 = t8 - t10;
  const S t17 = qd1 * (t9 - t11);
  const S t18 = t9 + t11;
  const S qd2 = qd[2];  // d(z)
  const S t19 = t15 + t15 - (t17 + t17) + qd2 * t12;
  const S t20 = qd2 * t16;
  const S t21 = t13 + t13 + qd0 * (S(1.0) - (t4 + t4)) - (t20 + t20);
  const S t22 = qd2 * t18;
  const S t23 = t14 + t14 - qd1 * (S(1.0) - (t5 + t5)) - (t22 + t22);
  const S q2 = q[2];  // z
  e[1] = S(36.297) * (q2 - (S(0.06) * t18 + S(0.1) * t16 - S(0.08) * t12));
  const S qd4 = qd[4];  // d(turn).y
  const S qd5 = qd[5];  // d(turn).z
  const S qd3 = qd[3];  // d(turn).x
  const S t25 = t21 * (S(0.296) * qd4 + S(0.111) * qd5) + t23 * (S(0.296) * qd3 - S(0.185) * qd5) - t19 * (S(0.185) * qd4 + S(0.111) * qd3);
  const S t26 = S(1.85) * (t19 * t19 + (t21 * t21 + t23 * t23)) + t25;
  const S t27 = qd5 * (S(0.43258) * qd5 - (S(0.0488) * qd3 - S(0.02488) * qd4));
  e[0] = S(0.5) * (qd4 * (S(0.02655) * qd3 + S(0.30293) * qd4 + S(0.02488) * qd5) + qd3 * (S(0.33701) * qd3 + S(0.02655) * qd4 - S(0.0488) * qd5) + t27) + t26;
}

// body_poses: 9 multiplications, 21 additions (reduced formulation; relative error 2.9e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  W[0] = S(1.0) - (t2 + t2);
  const S t4 = q4 * q5;
  const S q3 = q[3];  // turn.x
  const S t5 = q3 * q3;
  const S t6 = t1 + t5;
  const S t7 = t0 + t5;
  W[10] = S(1.0) - (t7 + t7);
  W[5] = S(1.0) - (t6 + t6);
  const S t10 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t11 = q4 * q6;
  const S t12 = q5 * q6;
  const S t13 = q5 * q3;
  const S t14 = q6 * q3;
  const S t15 = t4 - t14;
  const S t16 = t14 + t4;
  W[9] = t16 + t16;
  W[6] = t15 + t15;
  const S t19 = t11 + t13;
  const S t20 = t13 - t11;
  W[8] = t20 + t20;
  W[2] = t19 + t19;
  const S t23 = t10 - t12;
  const S t24 = t12 + t10;
  W[4] = t24 + t24;
  W[1] = t23 + t23;
  const S q0 = q[0];  // x
  W[3] = q0;
  const S q1 = q[1];  // y
  W[7] = q1;
  const S q2 = q[2];  // z
  W[11] = q2;
}

// frame_poses: 15 multiplications, 27 additions (reduced formulation; relative error 2.9e-16 where it was measured).
template <class S>
void frame_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* F) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  F[0] = t3;
  const S q3 = q[3];  // turn.x
  const S t4 = q3 * q3;
  const S t5 = t0 + t4;
  const S t6 = S(1.0) - (t5 + t5);
  F[10] = t6;
  const S t7 = t1 + t4;
  const S t8 = q4 * q3;
  const S t9 = q5 * q3;
  const S q6 = q[6];  // turn.w
  const S t10 = q6 * q3;
  const S t11 = q5 * q6;
  const S t12 = q4 * q6;
  const S t13 = q4 * q5;
  const S t14 = t13 - t10;
  const S t15 = t10 + t13;
  const S t16 = t12 + t9;
  const S t17 = t9 - t12;
  const S t18 = t11 + t8;
  const S t19 = t8 - t11;
  const S q2 = q[2];  // z
  F[11] = q2 - (S(-0.8) * t17 - S(0.1) * t6);
  const S q0 = q[0];  // x
  F[3] = q0 + (S(0.4) * t3 + S(0.2) * t16);
  F[5] = S(1.0) - (t7 + t7);
  F[2] = t16 + t16;
  F[8] = t17 + t17;
  F[1] = t19 + t19;
  F[9] = t15 + t15;
  const S q1 = q[1];  // y
  F[7] = q1 - (S(-0.2) * t14 - S(0.8) * t18);
  F[4] = t18 + t18;
  F[6] = t14 + t14;
}

// frame_jacobians: 48 multiplications, 41 additions (reduced formulation; relative error 4.5e-16 where it was measured).
template <class S>
void frame_jacobians([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* J) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q3 = q[3];  // turn.x
  const S t1 = q3 * q3;
  const S t2 = t0 + t1;
  const S q5 = q[5];  // turn.z
  const S t3 = q5 * q5;
  const S t4 = t1 + t3;
  const S t5 = S(1.0) - (t4 + t4);
  const S t6 = t0 - t1;
  const S t7 = t0 + t3;
  const S t8 = S(1.0) - (t7 + t7);
  const S t9 = q4 * q5;
  const S t10 = q3 * q5;
  const S t11 = q3 * q4;
  const S t12 = S(1.0) - (t2 + t2);
  const S q6 = q[6];  // turn.w
  const S t13 = q6 * q6;
  const S t14 = t13 - t2 + t3;
  const S t15 = t13 - t3;
  const S t16 = q3 * q6;
  J[28] = q6 * (S(0.8) * q3 + S(0.2) * q5) - q4 * (S(0.8) * q5 - S(0.2) * q3);
  const S t18 = q6 * q4;
  const S t19 = q6 * q5;
  const S t20 = t19 + t11;
  const S t21 = t19 - t11;
  const S t22 = t18 - t10;
  const S t23 = t18 + t10;
  const S t24 = t16 - t9;
  const S t25 = t16 + t9;
  const S t26 = t6 - t15;
  const S t27 = t6 + t15;
  const S t28 = t23 * t27;
  J[15] = t24 * (S(4.0) * t21) - (t28 + t28);
  const S t30 = t12 * t21;
  const S t31 = t24 * t8;
  const S t32 = t25 * t26;
  const S t33 = S(4.0) * t25;
  J[9] = t33 * t23 + (t30 + t30);
  const S t35 = S(4.0) * t22;
  J[10] = t35 * t23 - t12 * t26;
  J[11] = t35 * t21 + (t32 + t32);
  J[22] = S(-0.8) * t23 - S(0.1) * t26;
  const S t39 = t14 * t20;
  J[4] = t24 * t35 - (t39 + t39);
  const S t41 = S(4.0) * t20;
  J[16] = t31 + t31 + t23 * t41;
  J[17] = t27 * t8 + t21 * t41;
  J[3] = t24 * t33 + t14 * t5;
  const S t45 = t5 * t22;
  J[5] = t33 * t20 + (t45 + t45);
  J[34] = S(-0.4) * t14 - S(0.2) * t22;
  J[21] = S(0.2) * t21;
  J[23] = S(-0.8) * t21;
  J[27] = S(-0.1) * t27;
  J[29] = S(0.4) * t27;
  J[33] = S(-0.2) * t25;
  J[35] = S(0.8) * t25;
  J[18] = S(1.0);
  J[25] = S(1.0);
  J[32] = S(1.0);
  J[0] = S(0.0);
  J[1] = S(0.0);
  J[2] = S(0.0);
  J[6] = S(0.0);
  J[7] = S(0.0);
  J[8] = S(0.0);
  J[12] = S(0.0);
  J[13] = S(0.0);
  J[14] = S(0.0);
  J[19] = S(0.0);
  J[20] = S(0.0);
  J[24] = S(0.0);
  J[26] = S(0.0);
  J[30] = S(0.0);
  J[31] = S(0.0);
}

}  // namespace alembert::mechanisms::free_body

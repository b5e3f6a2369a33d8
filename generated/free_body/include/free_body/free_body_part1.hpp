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

// inverse_dynamics: 90 multiplications, 115 additions (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  const S q4 = q[4];  // turn.y
  const S q3 = q[3];  // turn.x
  const S t0 = q4 * q3;
  const S q5 = q[5];  // turn.z
  const S q6 = q[6];  // turn.w
  const S t1 = q5 * q6;
  const S t2 = t0 - t1;
  const S t3 = q4 * q5;
  const S t4 = q3 * q6;
  const S t5 = t3 + t4;
  const S qdd2 = qdd[2];  // dd(z)
  const S t6 = qdd2 + S(9.81);
  const S t7 = t5 * t6;
  const S qdd0 = qdd[0];  // dd(x)
  const S t8 = t2 * qdd0;
  const S t9 = q3 * q3;
  const S t10 = q5 * q5;
  const S t11 = t9 + t10;
  const S t12 = S(1.0) - (t11 + t11);
  const S qdd1 = qdd[1];  // dd(y)
  const S t13 = t7 + t7 + (t8 + t8 + qdd1 * t12);
  const S qd4 = qd[4];  // d(turn).y
  const S qd3 = qd[3];  // d(turn).x
  const S t14 = qd4 * qd3;
  const S qdd5 = qdd[5];  // dd(turn).z
  const S t15 = qdd5 + t14;
  const S qd5 = qd[5];  // d(turn).z
  const S t16 = qd5 * qd5;
  const S t17 = qd3 * qd3;
  const S t18 = qd4 * qd5;
  const S qdd3 = qdd[3];  // dd(turn).x
  const S t19 = qdd3 - t18;
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t20 = t2 * f0;
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t21 = t5 * f2;
  const S t22 = t20 + t20 + t12 * f1 + (t21 + t21);
  const S t23 = S(3.7) * t13 + (S(0.185) * t15 + S(0.111) * (t16 + t17) - S(0.296) * t19) - t22;
  const S t24 = t2 * t23;
  const S t25 = q4 * q4;
  const S t26 = t10 + t25;
  const S t27 = S(1.0) - (t26 + t26);
  const S t28 = t0 + t1;
  const S t29 = qdd1 * t28;
  const S t30 = q3 * q5;
  const S t31 = q4 * q6;
  const S t32 = t30 - t31;
  const S t33 = t6 * t32;
  const S t34 = qdd0 * t27 + (t29 + t29) + (t33 + t33);
  const S t35 = qdd5 - t14;
  const S t36 = qd4 * qd4;
  const S t37 = qd3 * qd5;
  const S qdd4 = qdd[4];  // dd(turn).y
  const S t38 = qdd4 + t37;
  const S t39 = f1 * t28;
  const S t40 = f2 * t32;
  const S t41 = t39 + t39 + f0 * t27 + (t40 + t40);
  const S t42 = S(3.7) * t34 + (S(0.111) * t35 - S(0.185) * (t16 + t36) + S(0.296) * t38) - t41;
  const S t43 = t30 + t31;
  const S t44 = t9 + t25;
  const S t45 = S(1.0) - (t44 + t44);
  const S t46 = t3 - t4;
  const S t47 = qdd1 * t46;
  const S t48 = qdd0 * t43;
  const S t49 = t6 * t45 + (t47 + t47 + (t48 + t48));
  const S t50 = qdd4 - t37;
  const S t51 = qdd3 + t18;
  const S t52 = f1 * t46;
  const S t53 = f0 * t43;
  const S t54 = f2 * t45 + (t52 + t52 + (t53 + t53));
  const S t55 = S(3.7) * t49 - (S(0.296) * (t17 + t36) + (S(0.185) * t50 + S(0.111) * t51)) - t54;
  const S t56 = t43 * t55;
  tau[0] = t24 + t24 + t27 * t42 + (t56 + t56);
  const S t58 = t46 * t55;
  const S t59 = t28 * t42;
  tau[1] = t58 + t58 + (t12 * t23 + (t59 + t59));
  const S t61 = t32 * t42;
  const S t62 = t5 * t23;
  tau[2] = t45 * t55 + (t61 + t61 + (t62 + t62));
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t64 = t32 * f5;
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S t65 = t28 * f4;
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S t66 = S(0.296) * t13 + S(0.111) * t49 - (S(0.10368) * t19 + (S(0.23333) * t51 + (S(0.02655) * t50 - S(0.0488) * t15 - S(0.02488) * (t16 - t36))));
  tau[3] = S(0.08) * t22 + S(0.03) * t54 - (t64 + t64 + (t65 + t65 + t27 * f3)) - t66;
  const S t68 = t2 * f3;
  const S t69 = t5 * f5;
  const S t70 = t12 * f4 + (t68 + t68) + (t69 + t69) + (S(0.08) * t41 - S(0.05) * t54);
  tau[4] = S(0.296) * t34 - S(0.185) * t49 + (S(0.19925) * t50 + (S(0.02488) * t35 + S(0.02655) * t51 - S(0.0488) * (t16 - t17) + S(0.10368) * t38)) - t70;
  const S t72 = t46 * f4;
  const S t73 = t43 * f3;
  const S t74 = S(0.05) * t22 + S(0.03) * t41 + (t45 * f5 + (t72 + t72 + (t73 + t73)));
  tau[5] = S(0.185) * t13 + S(0.111) * t34 + (S(0.23333) * t35 + (S(0.19925) * t15 + (S(0.02655) * (t17 - t36) - (S(0.0488) * t19 - S(0.02488) * t38)))) - t74;
}

// mass_matrix: 27 multiplications, 24 additions (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  const S q6 = q[6];  // turn.w
  const S q5 = q[5];  // turn.z
  const S t0 = q6 * q5;
  const S q4 = q[4];  // turn.y
  const S q3 = q[3];  // turn.x
  const S t1 = q4 * q3;
  const S t2 = t0 - t1;
  const S t3 = q6 * q4;
  const S t4 = q5 * q3;
  const S t5 = t3 + t4;
  const S t6 = S(0.592) * t2 - S(0.222) * t5;
  M[3] = t6;
  M[18] = t6;
  const S t7 = q4 * q4;
  const S t8 = q5 * q5;
  const S t9 = t7 + t8;
  const S t10 = S(1.0) - (t9 + t9);
  const S t11 = S(0.296) * t10 - S(0.37) * t5;
  M[4] = t11;
  M[24] = t11;
  const S t12 = S(0.111) * t10 - S(0.37) * t2;
  M[5] = t12;
  M[30] = t12;
  const S t13 = q6 * q3;
  const S t14 = q5 * q4;
  const S t15 = t13 - t14;
  const S t16 = q3 * q3;
  const S t17 = t8 + t16;
  const S t18 = S(1.0) - (t17 + t17);
  const S t19 = S(0.222) * t15 - S(0.296) * t18;
  M[9] = t19;
  M[19] = t19;
  const S t20 = t0 + t1;
  const S t21 = S(0.37) * t15 + S(0.592) * t20;
  M[10] = t21;
  M[25] = t21;
  const S t22 = S(0.185) * t18 + S(0.222) * t20;
  M[11] = t22;
  M[31] = t22;
  const S t23 = t7 + t16;
  const S t24 = S(1.0) - (t23 + t23);
  const S t25 = t13 + t14;
  const S t26 = S(-0.111) * t24 - S(0.592) * t25;
  M[15] = t26;
  M[20] = t26;
  const S t27 = t3 - t4;
  const S t28 = S(-0.185) * t24 - S(0.592) * t27;
  M[16] = t28;
  M[26] = t28;
  const S t29 = S(0.37) * t25 - S(0.222) * t27;
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

// bias: 75 multiplications, 91 additions (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  const S q6 = q[6];  // turn.w
  const S q5 = q[5];  // turn.z
  const S t0 = q6 * q5;
  const S q4 = q[4];  // turn.y
  const S q3 = q[3];  // turn.x
  const S t1 = q4 * q3;
  const S t2 = t0 - t1;
  const S t3 = q6 * q3;
  const S t4 = q4 * q5;
  const S t5 = t3 + t4;
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t6 = f2 * t5;
  const S t7 = q3 * q3;
  const S t8 = q5 * q5;
  const S t9 = t7 + t8;
  const S t10 = S(1.0) - (t9 + t9);
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t11 = f0 * t2;
  const S t12 = t6 + t6 + (f1 * t10 - (t11 + t11));
  const S qd4 = qd[4];  // d(turn).y
  const S qd5 = qd[5];  // d(turn).z
  const S t13 = qd4 * qd5;
  const S qd3 = qd[3];  // d(turn).x
  const S t14 = qd3 * qd3;
  const S t15 = qd5 * qd5;
  const S t16 = qd4 * qd3;
  const S t17 = t12 - (S(0.296) * t13 + (S(0.111) * (t14 + t15) + S(0.185) * t16));
  const S t18 = t2 * t17;
  const S t19 = q4 * q4;
  const S t20 = t19 + t8;
  const S t21 = S(1.0) - (t20 + t20);
  const S t22 = qd4 * qd4;
  const S t23 = qd3 * qd5;
  const S t24 = q4 * q6;
  const S t25 = q3 * q5;
  const S t26 = t24 - t25;
  const S t27 = f2 * t26;
  const S t28 = t0 + t1;
  const S t29 = f1 * t28;
  const S t30 = t27 + t27 - (f0 * t21 + (t29 + t29));
  const S t31 = S(0.111) * t16 + S(0.185) * (t22 + t15) - S(0.296) * t23 - t30;
  const S t32 = t24 + t25;
  const S t33 = t32 * f0;
  const S t34 = t3 - t4;
  const S t35 = f1 * t34;
  const S t36 = t19 + t7;
  const S t37 = S(1.0) - (t36 + t36);
  const S t38 = t33 + t33 - (t35 + t35) + f2 * t37;
  const S t39 = S(0.296) * (t22 + t14) - (S(0.185) * t23 - S(0.111) * t13) + t38;
  const S t40 = t32 * t39;
  c[0] = t18 + t18 - t21 * t31 - (t40 + t40);
  const S t42 = t34 * t39;
  const S t43 = t28 * t31;
  c[1] = t42 + t42 - (t43 + t43 + t10 * t17);
  const S t45 = t5 * t17;
  const S t46 = t26 * t31;
  c[2] = S(36.297) - (t37 * t39 + (t45 + t45 - (t46 + t46)));
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t48 = t26 * f5;
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S t49 = t28 * f4;
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S t50 = S(0.12965) * t13 + (S(0.02488) * (t22 - t15) - (S(0.0488) * t16 + S(0.02655) * t23)) - (S(1.08891) * t37 + S(5.80752) * t5);
  c[3] = S(0.03) * t38 + S(0.08) * t12 + (t48 + t48 - (t49 + t49 + t21 * f3)) + t50;
  const S t52 = t2 * f3;
  const S t53 = t5 * f5;
  const S t54 = S(5.80752) * t26 + S(1.81485) * t37 + (S(0.02488) * t16 - S(0.02655) * t13 - S(0.0488) * (t14 - t15) + S(0.09557) * t23);
  c[4] = S(0.05) * t38 + S(0.08) * t30 + (t52 + t52 - t10 * f4 - (t53 + t53)) - t54;
  const S t56 = t34 * f4;
  const S t57 = t32 * f3;
  const S t58 = S(2.17782) * t26 - S(3.6297) * t5 - (S(0.02488) * t23 + S(0.0488) * t13 - S(0.02655) * (t22 - t14) - S(0.03408) * t16);
  c[5] = S(0.03) * t30 - S(0.05) * t12 - (t37 * f5 - (t56 + t56 - (t57 + t57))) - t58;
}

// mass_matrix_and_bias: 93 multiplications, 100 additions (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  const S q6 = q[6];  // turn.w
  const S q5 = q[5];  // turn.z
  const S t0 = q6 * q5;
  const S q4 = q[4];  // turn.y
  const S q3 = q[3];  // turn.x
  const S t1 = q4 * q3;
  const S t2 = t0 - t1;
  const S t3 = q6 * q4;
  const S t4 = q5 * q3;
  const S t5 = t3 + t4;
  const S t6 = S(0.592) * t2 - S(0.222) * t5;
  M[3] = t6;
  M[18] = t6;
  const S t7 = q4 * q4;
  const S t8 = q5 * q5;
  const S t9 = t7 + t8;
  const S t10 = S(1.0) - (t9 + t9);
  const S t11 = S(0.296) * t10 - S(0.37) * t5;
  M[4] = t11;
  M[24] = t11;
  const S t12 = S(0.111) * t10 - S(0.37) * t2;
  M[5] = t12;
  M[30] = t12;
  const S t13 = q6 * q3;
  const S t14 = q5 * q4;
  const S t15 = t13 - t14;
  const S t16 = q3 * q3;
  const S t17 = t8 + t16;
  const S t18 = S(1.0) - (t17 + t17);
  const S t19 = S(0.222) * t15 - S(0.296) * t18;
  M[9] = t19;
  M[19] = t19;
  const S t20 = t0 + t1;
  const S t21 = S(0.37) * t15 + S(0.592) * t20;
  M[10] = t21;
  M[25] = t21;
  const S t22 = S(0.185) * t18 + S(0.222) * t20;
  M[11] = t22;
  M[31] = t22;
  const S t23 = t7 + t16;
  const S t24 = S(1.0) - (t23 + t23);
  const S t25 = t13 + t14;
  const S t26 = S(-0.111) * t24 - S(0.592) * t25;
  M[15] = t26;
  M[20] = t26;
  const S t27 = t3 - t4;
  const S t28 = S(-0.185) * t24 - S(0.592) * t27;
  M[16] = t28;
  M[26] = t28;
  const S t29 = S(0.37) * t25 - S(0.222) * t27;
  M[17] = t29;
  M[32] = t29;
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t30 = t25 * f2;
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t31 = t2 * f0;
  const S t32 = t30 + t30 + (t18 * f1 - (t31 + t31));
  const S qd4 = qd[4];  // d(turn).y
  const S qd5 = qd[5];  // d(turn).z
  const S t33 = qd4 * qd5;
  const S qd3 = qd[3];  // d(turn).x
  const S t34 = qd3 * qd3;
  const S t35 = qd5 * qd5;
  const S t36 = qd4 * qd3;
  const S t37 = t32 - (S(0.296) * t33 + (S(0.111) * (t34 + t35) + S(0.185) * t36));
  const S t38 = t2 * t37;
  const S t39 = qd4 * qd4;
  const S t40 = qd3 * qd5;
  const S t41 = t27 * f2;
  const S t42 = t20 * f1;
  const S t43 = t41 + t41 - (t10 * f0 + (t42 + t42));
  const S t44 = S(0.111) * t36 + S(0.185) * (t39 + t35) - S(0.296) * t40 - t43;
  const S t45 = t5 * f0;
  const S t46 = t15 * f1;
  const S t47 = t45 + t45 - (t46 + t46) + t24 * f2;
  const S t48 = S(0.296) * (t39 + t34) - (S(0.185) * t40 - S(0.111) * t33) + t47;
  const S t49 = t5 * t48;
  c[0] = t38 + t38 - t10 * t44 - (t49 + t49);
  const S t51 = t15 * t48;
  const S t52 = t20 * t44;
  c[1] = t51 + t51 - (t52 + t52 + t18 * t37);
  const S t54 = t25 * t37;
  const S t55 = t27 * t44;
  c[2] = S(36.297) - (t24 * t48 + (t54 + t54 - (t55 + t55)));
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t57 = t27 * f5;
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S t58 = t20 * f4;
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S t59 = S(0.12965) * t33 + (S(0.02488) * (t39 - t35) - (S(0.0488) * t36 + S(0.02655) * t40)) - (S(1.08891) * t24 + S(5.80752) * t25);
  c[3] = S(0.03) * t47 + S(0.08) * t32 + (t57 + t57 - (t58 + t58 + t10 * f3)) + t59;
  const S t61 = t2 * f3;
  const S t62 = t25 * f5;
  const S t63 = S(5.80752) * t27 + S(1.81485) * t24 + (S(0.02488) * t36 - S(0.02655) * t33 - S(0.0488) * (t34 - t35) + S(0.09557) * t40);
  c[4] = S(0.05) * t47 + S(0.08) * t43 + (t61 + t61 - t18 * f4 - (t62 + t62)) - t63;
  const S t65 = t15 * f4;
  const S t66 = t5 * f3;
  const S t67 = S(2.17782) * t27 - S(3.6297) * t25 - (S(0.02488) * t40 + S(0.0488) * t33 - S(0.02655) * (t39 - t34) - S(0.03408) * t36);
  c[5] = S(0.03) * t43 - S(0.05) * t32 - (t24 * f5 - (t65 + t65 - (t66 + t66))) - t67;
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

// coordinate_rates: 15 multiplications, 8 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd5 = qd[5];  // d(turn).z
  const S t0 = S(0.5) * qd5;
  const S q4 = q[4];  // turn.y
  const S qd4 = qd[4];  // d(turn).y
  const S t1 = S(0.5) * qd4;
  const S q5 = q[5];  // turn.z
  const S qd3 = qd[3];  // d(turn).x
  const S t2 = S(0.5) * qd3;
  const S q6 = q[6];  // turn.w
  qdot[3] = q4 * t0 - (q5 * t1 - q6 * t2);
  const S q3 = q[3];  // turn.x
  qdot[4] = t1 * q6 + q5 * t2 - t0 * q3;
  qdot[5] = q6 * t0 + (t1 * q3 - t2 * q4);
  qdot[6] = -(q5 * t0 + (t2 * q3 + t1 * q4));
  const S qd0 = qd[0];  // d(x)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(y)
  qdot[1] = qd1;
  const S qd2 = qd[2];  // d(z)
  qdot[2] = qd2;
}

// energy: 48 multiplications, 47 additions (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  const S qd3 = qd[3];  // d(turn).x
  const S qd4 = qd[4];  // d(turn).y
  const S qd5 = qd[5];  // d(turn).z
  const S t0 = qd5 * (S(0.43258) * qd5 - (S(0.0488) * qd3 - S(0.02488) * qd4));
  const S q4 = q[4];  // turn.y
  const S q6 = q[6];  // turn.w
  const S t1 = q4 * q6;
  const S q3 = q[3];  // turn.x
  const S q5 = q[5];  // turn.z
  const S t2 = q3 * q5;
  const S qd0 = qd[0];  // d(x)
  const S t3 = qd0 * (t1 + t2);
  const S t4 = q6 * q3;
  const S t5 = q4 * q5;
  const S qd1 = qd[1];  // d(y)
  const S t6 = qd1 * (t4 - t5);
  const S t7 = q4 * q4;
  const S t8 = q3 * q3;
  const S t9 = t7 + t8;
  const S t10 = S(1.0) - (t9 + t9);
  const S qd2 = qd[2];  // d(z)
  const S t11 = t3 + t3 - (t6 + t6) + qd2 * t10;
  const S t12 = q6 * q5;
  const S t13 = q4 * q3;
  const S t14 = qd1 * (t12 + t13);
  const S t15 = q5 * q5;
  const S t16 = t7 + t15;
  const S t17 = t1 - t2;
  const S t18 = qd2 * t17;
  const S t19 = t14 + t14 + qd0 * (S(1.0) - (t16 + t16)) - (t18 + t18);
  const S t20 = qd0 * (t12 - t13);
  const S t21 = t8 + t15;
  const S t22 = t4 + t5;
  const S t23 = qd2 * t22;
  const S t24 = t20 + t20 - qd1 * (S(1.0) - (t21 + t21)) - (t23 + t23);
  const S t25 = t19 * (S(0.296) * qd4 + S(0.111) * qd5) + t24 * (S(0.296) * qd3 - S(0.185) * qd5) - t11 * (S(0.185) * qd4 + S(0.111) * qd3);
  const S t26 = S(1.85) * (t11 * t11 + (t19 * t19 + t24 * t24)) + t25;
  e[0] = S(0.5) * (qd4 * (S(0.02655) * qd3 + S(0.30293) * qd4 + S(0.02488) * qd5) + qd3 * (S(0.33701) * qd3 + S(0.02655) * qd4 - S(0.0488) * qd5) + t0) + t26;
  const S q2 = q[2];  // z
  e[1] = S(36.297) * (q2 - (S(0.06) * t22 + S(0.1) * t17 - S(0.08) * t10));
}

// body_poses: 9 multiplications, 21 additions (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  W[0] = S(1.0) - (t2 + t2);
  const S q3 = q[3];  // turn.x
  const S t4 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t5 = q5 * q6;
  const S t6 = t4 - t5;
  W[1] = t6 + t6;
  const S t8 = q4 * q6;
  const S t9 = q5 * q3;
  const S t10 = t8 + t9;
  W[2] = t10 + t10;
  const S t12 = t5 + t4;
  W[4] = t12 + t12;
  const S t14 = q3 * q3;
  const S t15 = t1 + t14;
  W[5] = S(1.0) - (t15 + t15);
  const S t17 = q4 * q5;
  const S t18 = q6 * q3;
  const S t19 = t17 - t18;
  W[6] = t19 + t19;
  const S t21 = t9 - t8;
  W[8] = t21 + t21;
  const S t23 = t18 + t17;
  W[9] = t23 + t23;
  const S t25 = t0 + t14;
  W[10] = S(1.0) - (t25 + t25);
  const S q0 = q[0];  // x
  W[3] = q0;
  const S q1 = q[1];  // y
  W[7] = q1;
  const S q2 = q[2];  // z
  W[11] = q2;
}

// frame_poses: 15 multiplications, 27 additions (reduced formulation).
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
  const S t4 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t5 = q5 * q6;
  const S t6 = t4 - t5;
  F[1] = t6 + t6;
  const S t8 = q4 * q6;
  const S t9 = q5 * q3;
  const S t10 = t8 + t9;
  F[2] = t10 + t10;
  const S q0 = q[0];  // x
  F[3] = q0 + (S(0.4) * t3 + S(0.2) * t10);
  const S t13 = t5 + t4;
  F[4] = t13 + t13;
  const S t15 = q3 * q3;
  const S t16 = t1 + t15;
  F[5] = S(1.0) - (t16 + t16);
  const S t18 = q4 * q5;
  const S t19 = q6 * q3;
  const S t20 = t18 - t19;
  F[6] = t20 + t20;
  const S q1 = q[1];  // y
  F[7] = q1 - (S(-0.2) * t20 - S(0.8) * t13);
  const S t23 = t9 - t8;
  F[8] = t23 + t23;
  const S t25 = t19 + t18;
  F[9] = t25 + t25;
  const S t27 = t0 + t15;
  const S t28 = S(1.0) - (t27 + t27);
  F[10] = t28;
  const S q2 = q[2];  // z
  F[11] = q2 - (S(-0.8) * t23 - S(0.1) * t28);
}

// frame_jacobians: 48 multiplications, 41 additions (reduced formulation).
template <class S>
void frame_jacobians([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* J) {
  const S q3 = q[3];  // turn.x
  const S q6 = q[6];  // turn.w
  const S t0 = q3 * q6;
  const S q4 = q[4];  // turn.y
  const S q5 = q[5];  // turn.z
  const S t1 = q4 * q5;
  const S t2 = t0 - t1;
  const S t3 = t0 + t1;
  const S t4 = S(4.0) * t3;
  const S t5 = q6 * q6;
  const S t6 = q4 * q4;
  const S t7 = q3 * q3;
  const S t8 = t6 + t7;
  const S t9 = q5 * q5;
  const S t10 = t5 - t8 + t9;
  const S t11 = t7 + t9;
  const S t12 = S(1.0) - (t11 + t11);
  J[3] = t2 * t4 + t10 * t12;
  const S t14 = q6 * q4;
  const S t15 = q3 * q5;
  const S t16 = t14 - t15;
  const S t17 = S(4.0) * t16;
  const S t18 = q6 * q5;
  const S t19 = q3 * q4;
  const S t20 = t18 + t19;
  const S t21 = t10 * t20;
  J[4] = t2 * t17 - (t21 + t21);
  const S t23 = t12 * t16;
  J[5] = t4 * t20 + (t23 + t23);
  const S t25 = t14 + t15;
  const S t26 = S(1.0) - (t8 + t8);
  const S t27 = t18 - t19;
  const S t28 = t26 * t27;
  J[9] = t4 * t25 + (t28 + t28);
  const S t30 = t6 - t7;
  const S t31 = t5 - t9;
  const S t32 = t30 - t31;
  J[10] = t17 * t25 - t26 * t32;
  const S t34 = t3 * t32;
  J[11] = t17 * t27 + (t34 + t34);
  const S t36 = t30 + t31;
  const S t37 = t25 * t36;
  J[15] = t2 * (S(4.0) * t27) - (t37 + t37);
  const S t39 = t6 + t9;
  const S t40 = S(1.0) - (t39 + t39);
  const S t41 = t2 * t40;
  const S t42 = S(4.0) * t20;
  J[16] = t41 + t41 + t25 * t42;
  J[17] = t36 * t40 + t27 * t42;
  J[21] = S(0.2) * t27;
  J[22] = S(-0.8) * t25 - S(0.1) * t32;
  J[23] = S(-0.8) * t27;
  J[27] = S(-0.1) * t36;
  J[28] = q6 * (S(0.8) * q3 + S(0.2) * q5) - q4 * (S(0.8) * q5 - S(0.2) * q3);
  J[29] = S(0.4) * t36;
  J[33] = S(-0.2) * t3;
  J[34] = S(-0.4) * t10 - S(0.2) * t16;
  J[35] = S(0.8) * t3;
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
  J[18] = S(1.0);
  J[25] = S(1.0);
  J[32] = S(1.0);
}

}  // namespace alembert::mechanisms::free_body

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

// inverse_dynamics: 90 multiplications, 97 additions (reduced formulation; relative error 3e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q5 * q5;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S q3 = q[3];  // turn.x
  const S t4 = q3 * q3;
  const S t5 = t4 + t1;
  const S t6 = t0 + t4;
  const S t7 = S(1.0) - (t5 + t5);
  const S t8 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t9 = q6 * q5;
  const S t10 = t9 + t8;
  const S t11 = t9 - t8;
  const S t12 = t11 + t11;
  const S t13 = t10 + t10;
  const S t14 = q4 * q6;
  const S t15 = q3 * q6;
  const S t16 = q3 * q5;
  const S t17 = q4 * q5;
  const S t18 = S(1.0) - (t6 + t6);
  const S t19 = t15 + t17;
  const S t20 = t15 - t17;
  const S t21 = t20 + t20;
  const S t22 = t19 + t19;
  const S t23 = t14 - t16;
  const S t24 = t14 + t16;
  const S t25 = t24 + t24;
  const S t26 = t23 + t23;
  const S qd5 = qd[5];  // d(turn).z
  const S t27 = qd5 * qd5;
  const S qd4 = qd[4];  // d(turn).y
  const S t28 = qd4 * qd4;
  const S qd3 = qd[3];  // d(turn).x
  const S t29 = qd3 * qd4;
  const S t30 = qd5 * qd4;
  const S t31 = qd5 * qd3;
  const S t32 = qd3 * qd3;
  const S qdd5 = qdd[5];  // dd(turn).z
  const S t33 = qdd5 - t29;
  const S t34 = qdd5 + t29;
  const S qdd2 = qdd[2];  // dd(z)
  const S t35 = qdd2 + S(9.81);
  const S qdd4 = qdd[4];  // dd(turn).y
  const S t36 = qdd4 + t31;
  const S t37 = qdd4 - t31;
  const S qdd3 = qdd[3];  // dd(turn).x
  const S t38 = qdd3 - t30;
  const S t39 = qdd3 + t30;
  const S qdd1 = qdd[1];  // dd(y)
  const S qdd0 = qdd[0];  // dd(x)
  const S t40 = qdd1 * t13 + qdd0 * t3 - t26 * t35;
  const S t41 = t35 * t22 - (qdd0 * t12 - qdd1 * t7);
  const S t42 = t35 * t18 - (qdd1 * t21 - qdd0 * t25);
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t43 = f1 * t7 - f0 * t12 + f2 * t22;
  const S t44 = f0 * t3 + f1 * t13 - f2 * t26;
  const S t45 = f2 * t18 - (f1 * t21 - f0 * t25);
  const S t46 = S(0.296) * t36 + (S(0.111) * t33 - S(0.185) * (t27 + t28)) + S(3.7) * t40 - t44;
  const S t47 = t43 - (S(0.111) * (t27 + t32) + S(0.185) * t34 - S(0.296) * t38 + S(3.7) * t41);
  const S t48 = t45 + (S(0.296) * (t28 + t32) + (S(0.185) * t37 + S(0.111) * t39) - S(3.7) * t42);
  const S t49 = S(0.10368) * t38 + (S(0.23333) * t39 - (S(0.02488) * (t27 - t28) - (S(0.02655) * t37 - S(0.0488) * t34))) - (S(0.296) * t41 + S(0.111) * t42);
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S f3 = in.wrenches[3];  // wrench(body).tx
  tau[3] = f5 * t26 - (f4 * t13 + f3 * t3) + (S(0.08) * t43 + S(0.03) * t45) + t49;
  const S t51 = f5 * t22 - (f3 * t12 - f4 * t7) - (S(0.05) * t45 - S(0.08) * t44);
  const S t52 = S(0.03) * t44 + S(0.05) * t43 + (f3 * t25 - f4 * t21 + f5 * t18);
  tau[4] = S(0.19925) * t37 + (S(0.10368) * t36 + (S(0.02655) * t39 + S(0.02488) * t33 - S(0.0488) * (t27 - t32))) - (S(0.185) * t42 - S(0.296) * t40) - t51;
  tau[5] = S(0.185) * t41 + S(0.111) * t40 + (S(0.19925) * t34 - (S(0.02655) * (t28 - t32) + (S(0.0488) * t38 - S(0.02488) * t36)) + S(0.23333) * t33) - t52;
  tau[2] = -(t18 * t48 + (t47 * t22 + t26 * t46));
  tau[0] = t3 * t46 + t12 * t47 - t25 * t48;
  tau[1] = t13 * t46 - t7 * t47 + t21 * t48;
}

// mass_matrix: 27 multiplications, 24 additions (reduced formulation; relative error 2e-16 where it was measured).
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
  const S t5 = t4 + t1;
  const S t6 = t0 + t4;
  const S t7 = S(1.0) - (t6 + t6);
  const S t8 = S(1.0) - (t5 + t5);
  const S t9 = q4 * q3;
  const S t10 = q3 * q5;
  const S q6 = q[6];  // turn.w
  const S t11 = q3 * q6;
  const S t12 = q6 * q5;
  const S t13 = q4 * q6;
  const S t14 = q4 * q5;
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

// bias: 75 multiplications, 79 additions (reduced formulation; relative error 1.7e-16 where it was measured).
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
  const S t6 = t4 + t0;
  const S t7 = S(1.0) - (t5 + t5);
  const S t8 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t9 = q6 * q5;
  const S t10 = t9 - t8;
  const S t11 = t9 + t8;
  const S t12 = t11 + t11;
  const S t13 = t10 + t10;
  const S t14 = q3 * q6;
  const S t15 = q4 * q6;
  const S t16 = q4 * q5;
  const S t17 = q3 * q5;
  const S t18 = S(1.0) - (t6 + t6);
  const S t19 = t15 - t17;
  const S t20 = t15 + t17;
  const S t21 = t20 + t20;
  const S t22 = t14 + t16;
  const S t23 = t14 - t16;
  const S t24 = t23 + t23;
  const S qd5 = qd[5];  // d(turn).z
  const S t25 = qd5 * qd5;
  const S qd3 = qd[3];  // d(turn).x
  const S t26 = qd3 * qd3;
  const S qd4 = qd[4];  // d(turn).y
  const S t27 = qd4 * qd4;
  const S t28 = qd3 * qd4;
  const S t29 = qd5 * qd4;
  const S t30 = qd5 * qd3;
  const S t31 = t22 + t22;
  const S t32 = t19 + t19;
  const S t33 = S(5.80752) * t19 + S(1.81485) * t18 + (S(0.02488) * t28 - S(0.02655) * t29 + S(0.0488) * (t25 - t26) + S(0.09557) * t30);
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S t34 = f1 * t3 - f0 * t13 + f2 * t31;
  const S t35 = t34 - (S(0.296) * t29 + (S(0.111) * (t25 + t26) + S(0.185) * t28));
  const S t36 = f0 * t7 + f1 * t12 - f2 * t32;
  const S t37 = f2 * t18 - (f1 * t24 - f0 * t21);
  const S t38 = t36 + (S(0.111) * t28 + S(0.185) * (t25 + t27) - S(0.296) * t30);
  const S t39 = S(0.296) * (t27 + t26) - (S(0.185) * t30 - S(0.111) * t29) + t37;
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S t40 = S(0.03) * t36 + S(0.05) * t34 + (f3 * t21 - f4 * t24 + f5 * t18);
  c[5] = -(S(2.17782) * t19 - S(3.6297) * t22 - (S(0.02488) * t30 + S(0.0488) * t29 - S(0.02655) * (t27 - t26) - S(0.03408) * t28) + t40);
  const S t42 = f5 * t32 - (f4 * t12 + f3 * t7) + (S(0.08) * t34 + S(0.03) * t37);
  c[3] = S(0.12965) * t29 - (S(0.02488) * (t25 - t27) + (S(0.0488) * t28 + S(0.02655) * t30)) - (S(1.08891) * t18 + S(5.80752) * t22) + t42;
  c[4] = S(0.05) * t37 - S(0.08) * t36 - (f5 * t31 - (f3 * t13 - f4 * t3)) - t33;
  c[2] = t32 * t38 - t35 * t31 - t18 * t39 + S(36.297);
  c[0] = t35 * t13 - t7 * t38 - t21 * t39;
  c[1] = t24 * t39 - (t35 * t3 + t12 * t38);
}

// mass_matrix_and_bias: 93 multiplications, 88 additions (reduced formulation; relative error 2e-16 where it was measured).
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
  const S t5 = t4 + t1;
  const S t6 = t0 + t4;
  const S t7 = S(1.0) - (t5 + t5);
  const S t8 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t9 = q6 * q5;
  const S t10 = t9 - t8;
  const S t11 = t9 + t8;
  const S t12 = q4 * q6;
  const S t13 = q3 * q6;
  const S t14 = q3 * q5;
  const S t15 = q4 * q5;
  const S t16 = S(1.0) - (t6 + t6);
  const S t17 = t13 - t15;
  const S t18 = t13 + t15;
  const S t19 = t12 + t14;
  const S t20 = t12 - t14;
  const S t21 = t11 + t11;
  const S t22 = t10 + t10;
  const S qd5 = qd[5];  // d(turn).z
  const S t23 = qd5 * qd5;
  const S qd3 = qd[3];  // d(turn).x
  const S t24 = qd3 * qd3;
  const S qd4 = qd[4];  // d(turn).y
  const S t25 = qd4 * qd4;
  const S t26 = qd3 * qd4;
  const S t27 = qd5 * qd4;
  const S t28 = qd5 * qd3;
  const S t29 = t20 + t20;
  const S t30 = t19 + t19;
  const S t31 = t18 + t18;
  const S t32 = t17 + t17;
  const S t33 = S(5.80752) * t20 + S(1.81485) * t16 + (S(0.02488) * t26 - S(0.02655) * t27 + S(0.0488) * (t23 - t24) + S(0.09557) * t28);
  const S f2 = in.wrenches[2];  // wrench(body).fz
  const S f1 = in.wrenches[1];  // wrench(body).fy
  const S f0 = in.wrenches[0];  // wrench(body).fx
  const S t34 = f2 * t16 - (f1 * t32 - f0 * t30);
  const S t35 = S(0.296) * (t25 + t24) - (S(0.185) * t28 - S(0.111) * t27) + t34;
  const S t36 = f1 * t7 - f0 * t22 + f2 * t31;
  const S t37 = f0 * t3 + f1 * t21 - f2 * t29;
  const S t38 = t37 + (S(0.111) * t26 + S(0.185) * (t23 + t25) - S(0.296) * t28);
  const S t39 = t36 - (S(0.296) * t27 + (S(0.111) * (t23 + t24) + S(0.185) * t26));
  c[2] = t29 * t38 - t39 * t31 - t16 * t35 + S(36.297);
  const S f5 = in.wrenches[5];  // wrench(body).tz
  const S f4 = in.wrenches[4];  // wrench(body).ty
  const S f3 = in.wrenches[3];  // wrench(body).tx
  const S t41 = f5 * t29 - (f4 * t21 + f3 * t3) + (S(0.08) * t36 + S(0.03) * t34);
  const S t42 = S(0.03) * t37 + S(0.05) * t36 + (f3 * t30 - f4 * t32 + f5 * t16);
  c[4] = S(0.05) * t34 - S(0.08) * t37 - (f5 * t31 - (f3 * t22 - f4 * t7)) - t33;
  c[0] = t39 * t22 - t3 * t38 - t30 * t35;
  c[1] = t32 * t35 - (t39 * t7 + t21 * t38);
  c[5] = -(S(2.17782) * t20 - S(3.6297) * t18 - (S(0.02488) * t28 + S(0.0488) * t27 - S(0.02655) * (t25 - t24) - S(0.03408) * t26) + t42);
  c[3] = S(0.12965) * t27 - (S(0.02488) * (t23 - t25) + (S(0.0488) * t26 + S(0.02655) * t28)) - (S(1.08891) * t16 + S(5.80752) * t18) + t41;
  const S t48 = S(-0.111) * t16 - S(0.592) * t18;
  M[15] = t48;
  M[20] = t48;
  const S t49 = S(-0.185) * t16 - S(0.592) * t20;
  M[16] = t49;
  M[26] = t49;
  const S t50 = S(0.37) * t18 - S(0.222) * t20;
  M[17] = t50;
  M[32] = t50;
  const S t51 = S(0.222) * t17 - S(0.296) * t7;
  M[9] = t51;
  M[19] = t51;
  const S t52 = S(0.37) * t17 + S(0.592) * t11;
  M[10] = t52;
  M[25] = t52;
  const S t53 = S(0.185) * t7 + S(0.222) * t11;
  M[11] = t53;
  M[31] = t53;
  const S t54 = S(0.296) * t3 - S(0.37) * t19;
  M[4] = t54;
  M[24] = t54;
  const S t55 = S(0.592) * t10 - S(0.222) * t19;
  M[3] = t55;
  M[18] = t55;
  const S t56 = S(0.111) * t3 - S(0.37) * t10;
  M[5] = t56;
  M[30] = t56;
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
  const S q4 = q[4];  // turn.y
  const S q3 = q[3];  // turn.x
  const S q5 = q[5];  // turn.z
  qdot[6] = -(q4 * t0 + q3 * t1 + q5 * t2);
  const S q6 = q[6];  // turn.w
  qdot[3] = q4 * t2 - (q5 * t0 - q6 * t1);
  qdot[4] = q5 * t1 + q6 * t0 - q3 * t2;
  qdot[5] = q6 * t2 - (q4 * t1 - q3 * t0);
  const S qd0 = qd[0];  // d(x)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(y)
  qdot[1] = qd1;
  const S qd2 = qd[2];  // d(z)
  qdot[2] = qd2;
}

// energy: 48 multiplications, 44 additions (reduced formulation; relative error 2.8e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  const S q4 = q[4];  // turn.y
  const S t0 = q4 * q4;
  const S q5 = q[5];  // turn.z
  const S t1 = q4 * q5;
  const S t2 = q5 * q5;
  const S q3 = q[3];  // turn.x
  const S t3 = q3 * q5;
  const S q6 = q[6];  // turn.w
  const S t4 = q6 * q5;
  const S t5 = q3 * q6;
  const S t6 = q4 * q6;
  const S t7 = q4 * q3;
  const S t8 = q3 * q3;
  const S t9 = t8 + t2;
  const S t10 = t0 + t2;
  const S t11 = t0 + t8;
  const S t12 = t6 - t3;
  const S qd1 = qd[1];  // d(y)
  const S qd0 = qd[0];  // d(x)
  const S t13 = qd1 * (t5 - t1) - qd0 * (t6 + t3);
  const S t14 = t5 + t1;
  const S t15 = S(1.0) - (t11 + t11);
  const S qd2 = qd[2];  // d(z)
  const S t16 = qd2 * t14 - qd0 * (t4 - t7);
  const S t17 = qd1 * (t4 + t7) - qd2 * t12;
  const S t18 = qd0 * (S(1.0) - (t10 + t10)) + (t17 + t17);
  const S t19 = qd1 * (S(1.0) - (t9 + t9)) + (t16 + t16);
  const S t20 = qd2 * t15 - (t13 + t13);
  const S q2 = q[2];  // z
  e[1] = S(36.297) * (q2 - (S(0.06) * t14 + S(0.1) * t12 - S(0.08) * t15));
  const S qd4 = qd[4];  // d(turn).y
  const S qd5 = qd[5];  // d(turn).z
  const S qd3 = qd[3];  // d(turn).x
  const S t22 = t18 * (S(0.296) * qd4 + S(0.111) * qd5) - t19 * (S(0.296) * qd3 - S(0.185) * qd5) - t20 * (S(0.185) * qd4 + S(0.111) * qd3);
  const S t23 = qd5 * (S(0.43258) * qd5 - (S(0.0488) * qd3 - S(0.02488) * qd4));
  const S t24 = S(0.5) * (qd4 * (S(0.02655) * qd3 + S(0.30293) * qd4 + S(0.02488) * qd5) + qd3 * (S(0.33701) * qd3 + S(0.02655) * qd4 - S(0.0488) * qd5) + t23);
  e[0] = S(1.85) * (t20 * t20 + (t18 * t18 + t19 * t19)) + t22 + t24;
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
  const S t6 = t5 + t1;
  const S t7 = t0 + t5;
  W[10] = S(1.0) - (t7 + t7);
  W[5] = S(1.0) - (t6 + t6);
  const S t10 = q4 * q3;
  const S q6 = q[6];  // turn.w
  const S t11 = q4 * q6;
  const S t12 = q6 * q5;
  const S t13 = q3 * q5;
  const S t14 = q3 * q6;
  W[6] = S(-2.0) * (t14 - t4);
  const S t16 = t14 + t4;
  W[9] = t16 + t16;
  const S t18 = t11 + t13;
  W[8] = S(-2.0) * (t11 - t13);
  W[2] = t18 + t18;
  W[1] = S(-2.0) * (t12 - t10);
  const S t22 = t12 + t10;
  W[4] = t22 + t22;
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
  const S t7 = t4 + t1;
  const S t8 = q4 * q3;
  const S t9 = q3 * q5;
  const S q6 = q[6];  // turn.w
  const S t10 = q3 * q6;
  const S t11 = q6 * q5;
  const S t12 = q4 * q6;
  const S t13 = q4 * q5;
  const S t14 = t10 - t13;
  const S t15 = t10 + t13;
  const S t16 = t12 + t9;
  const S t17 = t12 - t9;
  const S t18 = t11 + t8;
  F[1] = S(-2.0) * (t11 - t8);
  const S q2 = q[2];  // z
  F[11] = q2 - (S(0.8) * t17 - S(0.1) * t6);
  const S q0 = q[0];  // x
  F[3] = q0 + (S(0.4) * t3 + S(0.2) * t16);
  F[5] = S(1.0) - (t7 + t7);
  F[2] = t16 + t16;
  F[8] = S(-2.0) * t17;
  F[9] = t15 + t15;
  const S q1 = q[1];  // y
  F[7] = q1 - (S(0.2) * t14 - S(0.8) * t18);
  F[4] = t18 + t18;
  F[6] = S(-2.0) * t14;
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
  const S t11 = q4 * q3;
  const S t12 = S(1.0) - (t2 + t2);
  const S q6 = q[6];  // turn.w
  const S t13 = q6 * q6;
  const S t14 = t13 - t2 + t3;
  const S t15 = t13 - t3;
  const S t16 = q3 * q6;
  J[28] = q6 * (S(0.8) * q3 + S(0.2) * q5) - q4 * (S(0.8) * q5 - S(0.2) * q3);
  const S t18 = q4 * q6;
  const S t19 = q6 * q5;
  const S t20 = t19 + t11;
  const S t21 = t19 - t11;
  const S t22 = t18 - t10;
  const S t23 = t18 + t10;
  const S t24 = t16 + t9;
  const S t25 = t16 - t9;
  const S t26 = t6 - t15;
  const S t27 = t6 + t15;
  const S t28 = t27 * t23;
  J[15] = S(4.0) * (t25 * t21) - (t28 + t28);
  const S t30 = t12 * t21;
  const S t31 = S(4.0) * t24;
  J[9] = t23 * t31 + (t30 + t30);
  const S t33 = S(4.0) * t22;
  J[10] = t23 * t33 - t26 * t12;
  J[4] = t33 * t25 - (t20 + t20) * t14;
  J[11] = (t26 + t26) * t24 + t33 * t21;
  J[22] = S(-0.8) * t23 - S(0.1) * t26;
  const S t38 = S(4.0) * t20;
  J[16] = (t8 + t8) * t25 + t38 * t23;
  J[17] = t38 * t21 + t8 * t27;
  J[3] = t14 * t5 + t31 * t25;
  const S t42 = t5 * t22;
  J[5] = t20 * t31 + (t42 + t42);
  J[34] = S(-0.4) * t14 - S(0.2) * t22;
  J[21] = S(0.2) * t21;
  J[23] = S(-0.8) * t21;
  J[27] = S(-0.1) * t27;
  J[29] = S(0.4) * t27;
  J[33] = S(-0.2) * t24;
  J[35] = S(0.8) * t24;
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

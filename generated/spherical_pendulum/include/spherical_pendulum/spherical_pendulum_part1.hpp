// spherical_pendulum: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "spherical_pendulum". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "spherical_pendulum_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::spherical_pendulum {

// inverse_dynamics: 60 multiplications, 75 additions (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  const S qd2 = qd[2];  // d(turn).z
  const S qd1 = qd[1];  // d(turn).y
  const S t0 = qd2 * qd1;
  const S qdd0 = qdd[0];  // dd(turn).x
  const S t1 = qdd0 + t0;
  const S t2 = qd2 * qd2;
  const S t3 = qd1 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t4 = qd1 * qd0;
  const S qdd2 = qdd[2];  // dd(turn).z
  const S t5 = qdd2 + t4;
  const S t6 = qd2 * qd0;
  const S qdd1 = qdd[1];  // dd(turn).y
  const S t7 = qdd1 - t6;
  const S t8 = qdd0 - t0;
  const S q0 = q[0];  // turn.x
  const S q3 = q[3];  // turn.w
  const S t9 = q0 * q3;
  const S q1 = q[1];  // turn.y
  const S q2 = q[2];  // turn.z
  const S t10 = q1 * q2;
  const S t11 = t9 + t10;
  const S t12 = q1 * q1;
  const S t13 = q0 * q0;
  const S t14 = t12 + t13;
  const S t15 = S(1.0) - (t14 + t14);
  const S t16 = q3 * q1;
  const S t17 = q0 * q2;
  const S t18 = t16 - t17;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t19 = f5 * t18;
  const S t20 = q3 * q2;
  const S t21 = q0 * q1;
  const S t22 = t20 + t21;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t23 = f4 * t22;
  const S t24 = q2 * q2;
  const S t25 = t12 + t24;
  const S t26 = S(1.0) - (t25 + t25);
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t27 = t9 - t10;
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t28 = f1 * t27;
  const S t29 = t16 + t17;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t30 = f0 * t29;
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t31 = t28 + t28 - (t30 + t30) - t15 * f2;
  const S t32 = t20 - t21;
  const S t33 = f0 * t32;
  const S t34 = t13 + t24;
  const S t35 = S(1.0) - (t34 + t34);
  const S t36 = t11 * f2;
  const S t37 = t33 + t33 - f1 * t35 - (t36 + t36);
  const S t38 = t19 + t19 - (t23 + t23 + f3 * t26) - (S(0.021) * t31 - S(0.63) * t37);
  tau[0] = S(0.0043969) * t1 + (S(0.010807) * (t2 - t3) + (S(0.006304) * t5 + S(0.0010268) * t7)) + S(0.36451) * t8 + (S(11.12454) * t11 - S(0.185409) * t15) + t38;
  const S t40 = qd0 * qd0;
  const S t41 = qdd2 - t4;
  const S t42 = qdd1 + t6;
  const S t43 = t22 * f1;
  const S t44 = t18 * f2;
  const S t45 = t26 * f0 + (t43 + t43) - (t44 + t44);
  const S t46 = f3 * t32;
  const S t47 = t11 * f5;
  const S t48 = S(0.012) * t31 - S(0.63) * t45 + (f4 * t35 - (t46 + t46) + (t47 + t47));
  tau[1] = S(11.12454) * t18 - S(0.105948) * t15 + (S(0.006304) * (t2 - t40) - (S(0.010807) * t41 - S(0.0010268) * t1) + S(0.36451) * t42 + S(0.0055296) * t7) - t48;
  const S t50 = f3 * t29;
  const S t51 = f4 * t27;
  const S t52 = t15 * f5 + (t50 + t50 - (t51 + t51)) + (S(0.021) * t45 - S(0.012) * t37);
  tau[2] = S(0.0043969) * t41 - (S(0.0010268) * (t3 - t40) - (S(0.006304) * t8 - S(0.010807) * t42) - S(0.0055296) * t5) - (S(0.370818) * t18 - S(0.211896) * t11) - t52;
}

// mass_matrix: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  M[0] = S(0.3689069);
  M[1] = S(0.0010268);
  M[3] = S(0.0010268);
  M[2] = S(0.006304);
  M[6] = S(0.006304);
  M[4] = S(0.3700396);
  M[5] = S(-0.010807);
  M[7] = S(-0.010807);
  M[8] = S(0.0099265);
}

// bias: 57 multiplications, 66 additions (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  const S q1 = q[1];  // turn.y
  const S q3 = q[3];  // turn.w
  const S t0 = q1 * q3;
  const S q0 = q[0];  // turn.x
  const S q2 = q[2];  // turn.z
  const S t1 = q0 * q2;
  const S t2 = t0 - t1;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t3 = f5 * t2;
  const S t4 = q3 * q2;
  const S t5 = q1 * q0;
  const S t6 = t4 + t5;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t7 = f4 * t6;
  const S t8 = q1 * q1;
  const S t9 = q2 * q2;
  const S t10 = t8 + t9;
  const S t11 = S(1.0) - (t10 + t10);
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t12 = q3 * q0;
  const S t13 = q1 * q2;
  const S t14 = t12 - t13;
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t15 = f1 * t14;
  const S t16 = t0 + t1;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t17 = f0 * t16;
  const S t18 = q0 * q0;
  const S t19 = t8 + t18;
  const S t20 = S(1.0) - (t19 + t19);
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t21 = t15 + t15 - (t17 + t17) - f2 * t20;
  const S t22 = t4 - t5;
  const S t23 = f0 * t22;
  const S t24 = t9 + t18;
  const S t25 = S(1.0) - (t24 + t24);
  const S t26 = t12 + t13;
  const S t27 = f2 * t26;
  const S t28 = t23 + t23 - f1 * t25 - (t27 + t27);
  const S qd2 = qd[2];  // d(turn).z
  const S qd1 = qd[1];  // d(turn).y
  const S t29 = qd2 * qd1;
  const S t30 = qd2 * qd2;
  const S t31 = qd1 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t32 = qd2 * qd0;
  const S t33 = qd1 * qd0;
  const S t34 = S(0.3601131) * t29 - (S(0.010807) * (t30 - t31) - (S(0.0010268) * t32 - S(0.006304) * t33)) - (S(11.12454) * t26 - S(0.185409) * t20);
  c[0] = t3 + t3 - (t7 + t7 + f3 * t11) - (S(0.021) * t21 - S(0.63) * t28) - t34;
  const S t36 = qd0 * qd0;
  const S t37 = t6 * f1;
  const S t38 = t2 * f2;
  const S t39 = t11 * f0 + (t37 + t37) - (t38 + t38);
  const S t40 = f3 * t22;
  const S t41 = f5 * t26;
  const S t42 = S(0.012) * t21 - S(0.63) * t39 + (f4 * t25 - (t40 + t40) + (t41 + t41));
  c[1] = S(11.12454) * t2 - S(0.105948) * t20 + (S(0.3589804) * t32 + (S(0.0010268) * t29 + S(0.010807) * t33 + S(0.006304) * (t30 - t36))) - t42;
  const S t44 = f3 * t16;
  const S t45 = f4 * t14;
  const S t46 = f5 * t20 + (t44 + t44 - (t45 + t45)) + (S(0.021) * t39 - S(0.012) * t28);
  c[2] = S(0.0011327) * t33 - (S(0.006304) * t29 + S(0.010807) * t32 + S(0.0010268) * (t31 - t36)) - (S(0.370818) * t2 - S(0.211896) * t26) - t46;
}

// mass_matrix_and_bias: 57 multiplications, 66 additions (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  const S q1 = q[1];  // turn.y
  const S q3 = q[3];  // turn.w
  const S t0 = q1 * q3;
  const S q0 = q[0];  // turn.x
  const S q2 = q[2];  // turn.z
  const S t1 = q0 * q2;
  const S t2 = t0 - t1;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t3 = f5 * t2;
  const S t4 = q3 * q2;
  const S t5 = q1 * q0;
  const S t6 = t4 + t5;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t7 = f4 * t6;
  const S t8 = q1 * q1;
  const S t9 = q2 * q2;
  const S t10 = t8 + t9;
  const S t11 = S(1.0) - (t10 + t10);
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t12 = q3 * q0;
  const S t13 = q1 * q2;
  const S t14 = t12 - t13;
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t15 = f1 * t14;
  const S t16 = t0 + t1;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t17 = f0 * t16;
  const S t18 = q0 * q0;
  const S t19 = t8 + t18;
  const S t20 = S(1.0) - (t19 + t19);
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t21 = t15 + t15 - (t17 + t17) - f2 * t20;
  const S t22 = t4 - t5;
  const S t23 = f0 * t22;
  const S t24 = t9 + t18;
  const S t25 = S(1.0) - (t24 + t24);
  const S t26 = t12 + t13;
  const S t27 = f2 * t26;
  const S t28 = t23 + t23 - f1 * t25 - (t27 + t27);
  const S qd2 = qd[2];  // d(turn).z
  const S qd1 = qd[1];  // d(turn).y
  const S t29 = qd2 * qd1;
  const S t30 = qd2 * qd2;
  const S t31 = qd1 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t32 = qd2 * qd0;
  const S t33 = qd1 * qd0;
  const S t34 = S(0.3601131) * t29 - (S(0.010807) * (t30 - t31) - (S(0.0010268) * t32 - S(0.006304) * t33)) - (S(11.12454) * t26 - S(0.185409) * t20);
  c[0] = t3 + t3 - (t7 + t7 + f3 * t11) - (S(0.021) * t21 - S(0.63) * t28) - t34;
  const S t36 = qd0 * qd0;
  const S t37 = t6 * f1;
  const S t38 = t2 * f2;
  const S t39 = t11 * f0 + (t37 + t37) - (t38 + t38);
  const S t40 = f3 * t22;
  const S t41 = f5 * t26;
  const S t42 = S(0.012) * t21 - S(0.63) * t39 + (f4 * t25 - (t40 + t40) + (t41 + t41));
  c[1] = S(11.12454) * t2 - S(0.105948) * t20 + (S(0.3589804) * t32 + (S(0.0010268) * t29 + S(0.010807) * t33 + S(0.006304) * (t30 - t36))) - t42;
  const S t44 = f3 * t16;
  const S t45 = f4 * t14;
  const S t46 = f5 * t20 + (t44 + t44 - (t45 + t45)) + (S(0.021) * t39 - S(0.012) * t28);
  c[2] = S(0.0011327) * t33 - (S(0.006304) * t29 + S(0.010807) * t32 + S(0.0010268) * (t31 - t36)) - (S(0.370818) * t2 - S(0.211896) * t26) - t46;
  M[0] = S(0.3689069);
  M[1] = S(0.0010268);
  M[3] = S(0.0010268);
  M[2] = S(0.006304);
  M[6] = S(0.006304);
  M[4] = S(0.3700396);
  M[5] = S(-0.010807);
  M[7] = S(-0.010807);
  M[8] = S(0.0099265);
}

// coordinate_rates: 15 multiplications, 8 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd2 = qd[2];  // d(turn).z
  const S t0 = S(0.5) * qd2;
  const S q1 = q[1];  // turn.y
  const S qd1 = qd[1];  // d(turn).y
  const S t1 = S(0.5) * qd1;
  const S q2 = q[2];  // turn.z
  const S qd0 = qd[0];  // d(turn).x
  const S t2 = S(0.5) * qd0;
  const S q3 = q[3];  // turn.w
  qdot[0] = q1 * t0 - (q2 * t1 - q3 * t2);
  const S q0 = q[0];  // turn.x
  qdot[1] = t1 * q3 + q2 * t2 - t0 * q0;
  qdot[2] = q3 * t0 + (t1 * q0 - t2 * q1);
  qdot[3] = -(q2 * t0 + (t2 * q0 + t1 * q1));
}

// energy: 23 multiplications, 15 additions (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  const S qd2 = qd[2];  // d(turn).z
  const S qd0 = qd[0];  // d(turn).x
  const S qd1 = qd[1];  // d(turn).y
  const S t0 = qd2 * (S(0.0099265) * qd2 - (S(0.010807) * qd1 - S(0.006304) * qd0));
  e[0] = S(-0.5) * (qd1 * (S(0.010807) * qd2 - (S(0.0010268) * qd0 + S(0.3700396) * qd1)) - qd0 * (S(0.006304) * qd2 + (S(0.3689069) * qd0 + S(0.0010268) * qd1)) - t0);
  const S q1 = q[1];  // turn.y
  const S q0 = q[0];  // turn.x
  const S t2 = q1 * q1 + q0 * q0;
  const S q3 = q[3];  // turn.w
  const S q2 = q[2];  // turn.z
  e[1] = S(-8.829) * (S(0.63) * (S(1.0) - (t2 + t2)) + (S(0.042) * (q0 * q3 + q1 * q2) + S(0.024) * (q1 * q3 - q0 * q2)));
}

// body_poses: 9 multiplications, 21 additions (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q2 = q[2];  // turn.z
  const S t1 = q2 * q2;
  const S t2 = t0 + t1;
  W[0] = S(1.0) - (t2 + t2);
  const S q0 = q[0];  // turn.x
  const S t4 = q1 * q0;
  const S q3 = q[3];  // turn.w
  const S t5 = q2 * q3;
  const S t6 = t4 - t5;
  W[1] = t6 + t6;
  const S t8 = q1 * q3;
  const S t9 = q2 * q0;
  const S t10 = t8 + t9;
  W[2] = t10 + t10;
  const S t12 = t5 + t4;
  W[4] = t12 + t12;
  const S t14 = q0 * q0;
  const S t15 = t1 + t14;
  W[5] = S(1.0) - (t15 + t15);
  const S t17 = q1 * q2;
  const S t18 = q3 * q0;
  const S t19 = t17 - t18;
  W[6] = t19 + t19;
  const S t21 = t9 - t8;
  W[8] = t21 + t21;
  const S t23 = t18 + t17;
  W[9] = t23 + t23;
  const S t25 = t0 + t14;
  W[10] = S(1.0) - (t25 + t25);
  W[3] = S(0.0);
  W[7] = S(0.0);
  W[11] = S(0.0);
}

}  // namespace alembert::mechanisms::spherical_pendulum

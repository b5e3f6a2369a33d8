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

// inverse_dynamics: 60 multiplications, 75 additions (reduced formulation; relative error 6.7e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q0 = q[0];  // turn.x
  const S t1 = q0 * q0;
  const S t2 = q0 * q1;
  const S q2 = q[2];  // turn.z
  const S t3 = q2 * q2;
  const S t4 = q1 * q2;
  const S q3 = q[3];  // turn.w
  const S t5 = q3 * q1;
  const S t6 = q0 * q3;
  const S t7 = q0 * q2;
  const S t8 = q3 * q2;
  const S t9 = t0 + t3;
  const S t10 = t1 + t3;
  const S t11 = t0 + t1;
  const S t12 = S(1.0) - (t10 + t10);
  const S t13 = S(1.0) - (t9 + t9);
  const S t14 = S(1.0) - (t11 + t11);
  const S t15 = t8 + t2;
  const S t16 = t8 - t2;
  const S t17 = t5 + t7;
  const S t18 = t5 - t7;
  const S t19 = t6 - t4;
  const S t20 = t6 + t4;
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t21 = f1 * t19;
  const S t22 = t15 * f1;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t23 = f0 * t17;
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t24 = t21 + t21 - (t23 + t23) - t14 * f2;
  const S t25 = f0 * t16;
  const S t26 = t20 * f2;
  const S t27 = t25 + t25 - f1 * t12 - (t26 + t26);
  const S t28 = t18 * f2;
  const S t29 = t13 * f0 + (t22 + t22) - (t28 + t28);
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t30 = f3 * t16;
  const S t31 = f3 * t17;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t32 = f4 * t15;
  const S t33 = f4 * t19;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t34 = t14 * f5 + (t31 + t31 - (t33 + t33)) + (S(0.021) * t29 - S(0.012) * t27);
  const S qd2 = qd[2];  // d(turn).z
  const S qd1 = qd[1];  // d(turn).y
  const S t35 = qd2 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t36 = qd1 * qd0;
  const S t37 = qd1 * qd1;
  const S t38 = qd2 * qd0;
  const S t39 = qd2 * qd2;
  const S t40 = qd0 * qd0;
  const S qdd1 = qdd[1];  // dd(turn).y
  const S t41 = qdd1 - t38;
  const S t42 = qdd1 + t38;
  const S qdd2 = qdd[2];  // dd(turn).z
  const S t43 = qdd2 + t36;
  const S t44 = qdd2 - t36;
  const S qdd0 = qdd[0];  // dd(turn).x
  const S t45 = qdd0 + t35;
  const S t46 = qdd0 - t35;
  tau[2] = S(0.0043969) * t44 - (S(0.0010268) * (t37 - t40) - (S(0.006304) * t46 - S(0.010807) * t42) - S(0.0055296) * t43) - (S(0.370818) * t18 - S(0.211896) * t20) - t34;
  const S t48 = f5 * t18;
  const S t49 = t20 * f5;
  const S t50 = S(0.012) * t24 - S(0.63) * t29 + (f4 * t12 - (t30 + t30) + (t49 + t49));
  tau[1] = S(11.12454) * t18 - S(0.105948) * t14 + (S(0.006304) * (t39 - t40) - (S(0.010807) * t44 - S(0.0010268) * t45) + S(0.36451) * t42 + S(0.0055296) * t41) - t50;
  const S t52 = t48 + t48 - (t32 + t32 + f3 * t13) - (S(0.021) * t24 - S(0.63) * t27);
  tau[0] = S(0.0043969) * t45 + (S(0.010807) * (t39 - t37) + (S(0.006304) * t43 + S(0.0010268) * t41)) + S(0.36451) * t46 + (S(11.12454) * t20 - S(0.185409) * t14) + t52;
}

// mass_matrix: 0 multiplications, 0 additions (reduced formulation; relative error 6.7e-17 where it was measured).
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

// bias: 57 multiplications, 66 additions (reduced formulation; relative error 1.2e-15 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q2 = q[2];  // turn.z
  const S t1 = q2 * q2;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S t4 = q1 * q2;
  const S q0 = q[0];  // turn.x
  const S t5 = q0 * q0;
  const S t6 = t1 + t5;
  const S t7 = t0 + t5;
  const S t8 = S(1.0) - (t6 + t6);
  const S t9 = q0 * q2;
  const S q3 = q[3];  // turn.w
  const S t10 = q3 * q2;
  const S t11 = q1 * q3;
  const S t12 = q1 * q0;
  const S t13 = q3 * q0;
  const S t14 = S(1.0) - (t7 + t7);
  const S t15 = t13 - t4;
  const S t16 = t13 + t4;
  const S t17 = t10 + t12;
  const S t18 = t10 - t12;
  const S t19 = t11 + t9;
  const S t20 = t11 - t9;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t21 = f0 * t19;
  const S t22 = f0 * t18;
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t23 = t17 * f1;
  const S t24 = f1 * t15;
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t25 = t24 + t24 - (t21 + t21) - f2 * t14;
  const S t26 = f2 * t16;
  const S t27 = t22 + t22 - f1 * t8 - (t26 + t26);
  const S t28 = t20 * f2;
  const S t29 = t3 * f0 + (t23 + t23) - (t28 + t28);
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t30 = f4 * t15;
  const S t31 = f4 * t17;
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t32 = f3 * t18;
  const S t33 = f3 * t19;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t34 = f5 * t14 + (t33 + t33 - (t30 + t30)) + (S(0.021) * t29 - S(0.012) * t27);
  const S qd2 = qd[2];  // d(turn).z
  const S t35 = qd2 * qd2;
  const S qd1 = qd[1];  // d(turn).y
  const S t36 = qd2 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t37 = qd2 * qd0;
  const S t38 = qd1 * qd0;
  const S t39 = qd1 * qd1;
  const S t40 = qd0 * qd0;
  c[2] = S(0.0011327) * t38 - (S(0.006304) * t36 + S(0.010807) * t37 + S(0.0010268) * (t39 - t40)) - (S(0.370818) * t20 - S(0.211896) * t16) - t34;
  const S t42 = S(0.3601131) * t36 - (S(0.010807) * (t35 - t39) - (S(0.0010268) * t37 - S(0.006304) * t38)) - (S(11.12454) * t16 - S(0.185409) * t14);
  const S t43 = f5 * t16;
  const S t44 = S(0.012) * t25 - S(0.63) * t29 + (f4 * t8 - (t32 + t32) + (t43 + t43));
  c[1] = S(11.12454) * t20 - S(0.105948) * t14 + (S(0.3589804) * t37 + (S(0.0010268) * t36 + S(0.010807) * t38 + S(0.006304) * (t35 - t40))) - t44;
  const S t46 = f5 * t20;
  c[0] = t46 + t46 - (t31 + t31 + f3 * t3) - (S(0.021) * t25 - S(0.63) * t27) - t42;
}

// mass_matrix_and_bias: 57 multiplications, 66 additions (reduced formulation; relative error 1.2e-15 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q2 = q[2];  // turn.z
  const S t1 = q2 * q2;
  const S t2 = t0 + t1;
  const S t3 = S(1.0) - (t2 + t2);
  const S t4 = q1 * q2;
  const S q0 = q[0];  // turn.x
  const S t5 = q0 * q0;
  const S t6 = t1 + t5;
  const S t7 = t0 + t5;
  const S t8 = S(1.0) - (t6 + t6);
  const S t9 = q0 * q2;
  const S q3 = q[3];  // turn.w
  const S t10 = q3 * q2;
  const S t11 = q1 * q3;
  const S t12 = q1 * q0;
  const S t13 = q3 * q0;
  const S t14 = S(1.0) - (t7 + t7);
  const S t15 = t13 - t4;
  const S t16 = t13 + t4;
  const S t17 = t10 + t12;
  const S t18 = t10 - t12;
  const S t19 = t11 + t9;
  const S t20 = t11 - t9;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t21 = f0 * t19;
  const S t22 = f0 * t18;
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t23 = t17 * f1;
  const S t24 = f1 * t15;
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t25 = t24 + t24 - (t21 + t21) - f2 * t14;
  const S t26 = f2 * t16;
  const S t27 = t22 + t22 - f1 * t8 - (t26 + t26);
  const S t28 = t20 * f2;
  const S t29 = t3 * f0 + (t23 + t23) - (t28 + t28);
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t30 = f4 * t15;
  const S t31 = f4 * t17;
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t32 = f3 * t18;
  const S t33 = f3 * t19;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t34 = f5 * t14 + (t33 + t33 - (t30 + t30)) + (S(0.021) * t29 - S(0.012) * t27);
  const S qd2 = qd[2];  // d(turn).z
  const S t35 = qd2 * qd2;
  const S qd1 = qd[1];  // d(turn).y
  const S t36 = qd2 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t37 = qd2 * qd0;
  const S t38 = qd1 * qd0;
  const S t39 = qd1 * qd1;
  const S t40 = qd0 * qd0;
  c[2] = S(0.0011327) * t38 - (S(0.006304) * t36 + S(0.010807) * t37 + S(0.0010268) * (t39 - t40)) - (S(0.370818) * t20 - S(0.211896) * t16) - t34;
  const S t42 = S(0.3601131) * t36 - (S(0.010807) * (t35 - t39) - (S(0.0010268) * t37 - S(0.006304) * t38)) - (S(11.12454) * t16 - S(0.185409) * t14);
  const S t43 = f5 * t16;
  const S t44 = S(0.012) * t25 - S(0.63) * t29 + (f4 * t8 - (t32 + t32) + (t43 + t43));
  c[1] = S(11.12454) * t20 - S(0.105948) * t14 + (S(0.3589804) * t37 + (S(0.0010268) * t36 + S(0.010807) * t38 + S(0.006304) * (t35 - t40))) - t44;
  const S t46 = f5 * t20;
  c[0] = t46 + t46 - (t31 + t31 + f3 * t3) - (S(0.021) * t25 - S(0.63) * t27) - t42;
  M[2] = S(0.006304);
  M[6] = S(0.006304);
  M[1] = S(0.0010268);
  M[3] = S(0.0010268);
  M[0] = S(0.3689069);
  M[4] = S(0.3700396);
  M[5] = S(-0.010807);
  M[7] = S(-0.010807);
  M[8] = S(0.0099265);
}

// coordinate_rates: 15 multiplications, 8 additions (reduced formulation; relative error 1.7e-16 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd1 = qd[1];  // d(turn).y
  const S t0 = S(0.5) * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t1 = S(0.5) * qd0;
  const S qd2 = qd[2];  // d(turn).z
  const S t2 = S(0.5) * qd2;
  const S q2 = q[2];  // turn.z
  const S q0 = q[0];  // turn.x
  const S q1 = q[1];  // turn.y
  qdot[3] = -(q2 * t2 + (t1 * q0 + t0 * q1));
  const S q3 = q[3];  // turn.w
  qdot[0] = q1 * t2 - (q2 * t0 - q3 * t1);
  qdot[1] = t0 * q3 + q2 * t1 - t2 * q0;
  qdot[2] = q3 * t2 + (t0 * q0 - t1 * q1);
}

// energy: 23 multiplications, 15 additions (reduced formulation; relative error 3.4e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  const S q1 = q[1];  // turn.y
  const S q0 = q[0];  // turn.x
  const S t0 = q1 * q1 + q0 * q0;
  const S q3 = q[3];  // turn.w
  const S q2 = q[2];  // turn.z
  e[1] = S(-8.829) * (S(0.63) * (S(1.0) - (t0 + t0)) + (S(0.042) * (q0 * q3 + q1 * q2) + S(0.024) * (q1 * q3 - q0 * q2)));
  const S qd2 = qd[2];  // d(turn).z
  const S qd1 = qd[1];  // d(turn).y
  const S qd0 = qd[0];  // d(turn).x
  const S t2 = qd2 * (S(0.0099265) * qd2 - (S(0.010807) * qd1 - S(0.006304) * qd0));
  e[0] = S(-0.5) * (qd1 * (S(0.010807) * qd2 - (S(0.0010268) * qd0 + S(0.3700396) * qd1)) - qd0 * (S(0.006304) * qd2 + (S(0.3689069) * qd0 + S(0.0010268) * qd1)) - t2);
}

// body_poses: 9 multiplications, 21 additions (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q2 = q[2];  // turn.z
  const S t1 = q2 * q2;
  const S t2 = t0 + t1;
  W[0] = S(1.0) - (t2 + t2);
  const S t4 = q1 * q2;
  const S q0 = q[0];  // turn.x
  const S t5 = q0 * q0;
  const S t6 = t1 + t5;
  const S t7 = t0 + t5;
  W[10] = S(1.0) - (t7 + t7);
  W[5] = S(1.0) - (t6 + t6);
  const S t10 = q1 * q0;
  const S q3 = q[3];  // turn.w
  const S t11 = q1 * q3;
  const S t12 = q2 * q3;
  const S t13 = q2 * q0;
  const S t14 = q3 * q0;
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
  W[3] = S(0.0);
  W[7] = S(0.0);
  W[11] = S(0.0);
}

}  // namespace alembert::mechanisms::spherical_pendulum

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

// inverse_dynamics: 60 multiplications, 69 additions (reduced formulation; relative error 3.6e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q3 = q[3];  // turn.w
  const S t1 = q1 * q3;
  const S q0 = q[0];  // turn.x
  const S t2 = q0 * q3;
  const S q2 = q[2];  // turn.z
  const S t3 = q3 * q2;
  const S t4 = q0 * q2;
  const S t5 = q1 * q2;
  const S t6 = q1 * q0;
  const S t7 = q0 * q0;
  const S t8 = q2 * q2;
  const S t9 = t0 + t8;
  const S t10 = t0 + t7;
  const S t11 = S(1.0) - (t10 + t10);
  const S t12 = S(1.0) - (t9 + t9);
  const S t13 = t7 + t8;
  const S t14 = t3 + t6;
  const S t15 = t2 - t5;
  const S t16 = t1 + t4;
  const S t17 = t1 - t4;
  const S t18 = t2 + t5;
  const S t19 = t3 - t6;
  const S t20 = S(1.0) - (t13 + t13);
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t21 = f1 * t14 - f2 * t17;
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S t22 = f0 * t16 - f1 * t15;
  const S t23 = t22 + t22 + f2 * t11;
  const S t24 = t21 + t21 + f0 * t12;
  const S qd2 = qd[2];  // d(turn).z
  const S t25 = qd2 * qd2;
  const S qd1 = qd[1];  // d(turn).y
  const S t26 = qd2 * qd1;
  const S t27 = qd1 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t28 = qd0 * qd1;
  const S t29 = qd0 * qd0;
  const S t30 = qd2 * qd0;
  const S qdd2 = qdd[2];  // dd(turn).z
  const S t31 = qdd2 - t28;
  const S t32 = qdd2 + t28;
  const S qdd0 = qdd[0];  // dd(turn).x
  const S t33 = qdd0 + t26;
  const S t34 = qdd0 - t26;
  const S qdd1 = qdd[1];  // dd(turn).y
  const S t35 = qdd1 - t30;
  const S t36 = qdd1 + t30;
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t37 = f5 * t11 + (S(0.370818) * t17 - (S(0.0043969) * t31 - S(0.0010268) * (t27 - t29) + S(0.006304) * t34 - S(0.010807) * t36 + S(0.0055296) * t32) - S(0.211896) * t18);
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t38 = f5 * t18 - f3 * t19;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S t39 = S(0.010807) * t31 - (S(0.006304) * (t25 - t29) - (S(0.105948) * t11 + (t38 + t38 + (f4 * t20 - (S(0.012) * t23 + S(0.63) * t24)) - S(11.12454) * t17)));
  const S t40 = f4 * t14 - f5 * t17;
  const S t41 = t40 + t40 + (S(0.185409) * t11 - (S(11.12454) * t18 + (S(0.006304) * t32 + (S(0.010807) * (t25 - t27) + S(0.0043969) * t33) + S(0.0010268) * t35 + S(0.36451) * t34)));
  tau[1] = S(0.0055296) * t35 - (t39 - S(0.0010268) * t33 - S(0.36451) * t36);
  const S t43 = f0 * t19 - f2 * t18;
  const S t44 = f1 * t20 - (t43 + t43);
  tau[0] = S(0.021) * t23 - (t41 + f3 * t12) - S(0.63) * t44;
  const S t46 = f4 * t15 - f3 * t16;
  tau[2] = t46 + t46 - t37 - S(0.021) * t24 - S(0.012) * t44;
}

// mass_matrix: 0 multiplications, 0 additions (reduced formulation; relative error 7.6e-17 where it was measured).
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

// bias: 57 multiplications, 60 additions (reduced formulation; relative error 1.5e-15 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q2 = q[2];  // turn.z
  const S t1 = q1 * q2;
  const S t2 = q2 * q2;
  const S q0 = q[0];  // turn.x
  const S t3 = q0 * q2;
  const S q3 = q[3];  // turn.w
  const S t4 = q3 * q2;
  const S t5 = q0 * q3;
  const S t6 = q1 * q3;
  const S t7 = q1 * q0;
  const S t8 = q0 * q0;
  const S t9 = t0 + t8;
  const S t10 = t0 + t2;
  const S t11 = t8 + t2;
  const S t12 = S(1.0) - (t10 + t10);
  const S t13 = S(1.0) - (t9 + t9);
  const S t14 = t4 + t7;
  const S t15 = t4 - t7;
  const S t16 = t6 + t3;
  const S t17 = t6 - t3;
  const S t18 = t5 - t1;
  const S t19 = t5 + t1;
  const S t20 = S(1.0) - (t11 + t11);
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t21 = f0 * t16 - f1 * t18;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t22 = f4 * t18 - f3 * t16;
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t23 = f1 * t14 - f2 * t17;
  const S t24 = t21 + t21 + f2 * t13;
  const S t25 = f0 * t15 - f2 * t19;
  const S t26 = t23 + t23 + f0 * t12;
  const S t27 = f1 * t20 - (t25 + t25);
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t28 = f4 * t14 - f5 * t17;
  const S t29 = f5 * t19 - f3 * t15;
  const S qd2 = qd[2];  // d(turn).z
  const S t30 = qd2 * qd2;
  const S qd1 = qd[1];  // d(turn).y
  const S t31 = qd2 * qd1;
  const S t32 = qd1 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t33 = qd0 * qd1;
  const S t34 = qd2 * qd0;
  const S t35 = S(0.3589804) * t34 - (S(0.105948) * t13 + (t29 + t29 + (f4 * t20 - (S(0.012) * t24 + S(0.63) * t26)) - S(11.12454) * t17)) + S(0.0010268) * t31;
  const S t36 = S(0.0010268) * t34 - (S(0.010807) * (t30 - t32) - (S(0.3601131) * t31 - (S(0.021) * t24 - (t28 + t28 + f3 * t12) - S(0.63) * t27))) - S(0.006304) * t33;
  const S t37 = qd0 * qd0;
  const S t38 = S(0.010807) * t34 - (S(0.0011327) * t33 - (S(0.012) * t27 + (f5 * t13 - (t22 + t22) + S(0.021) * t26)) - S(0.006304) * t31) + S(0.0010268) * (t32 - t37);
  c[1] = S(0.010807) * t33 + t35 + S(0.006304) * (t30 - t37);
  c[0] = S(11.12454) * t19 - t36 - S(0.185409) * t13;
  c[2] = S(0.211896) * t19 - (S(0.370818) * t17 + t38);
}

// mass_matrix_and_bias: 57 multiplications, 60 additions (reduced formulation; relative error 1.5e-15 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  const S q1 = q[1];  // turn.y
  const S t0 = q1 * q1;
  const S q2 = q[2];  // turn.z
  const S t1 = q1 * q2;
  const S t2 = q2 * q2;
  const S q0 = q[0];  // turn.x
  const S t3 = q0 * q2;
  const S q3 = q[3];  // turn.w
  const S t4 = q3 * q2;
  const S t5 = q0 * q3;
  const S t6 = q1 * q3;
  const S t7 = q1 * q0;
  const S t8 = q0 * q0;
  const S t9 = t0 + t8;
  const S t10 = t0 + t2;
  const S t11 = t8 + t2;
  const S t12 = S(1.0) - (t10 + t10);
  const S t13 = S(1.0) - (t9 + t9);
  const S t14 = t4 + t7;
  const S t15 = t4 - t7;
  const S t16 = t6 + t3;
  const S t17 = t6 - t3;
  const S t18 = t5 - t1;
  const S t19 = t5 + t1;
  const S t20 = S(1.0) - (t11 + t11);
  const S f0 = in.wrenches[0];  // wrench(bob).fx
  const S f1 = in.wrenches[1];  // wrench(bob).fy
  const S t21 = f0 * t16 - f1 * t18;
  const S f4 = in.wrenches[4];  // wrench(bob).ty
  const S f3 = in.wrenches[3];  // wrench(bob).tx
  const S t22 = f4 * t18 - f3 * t16;
  const S f2 = in.wrenches[2];  // wrench(bob).fz
  const S t23 = f1 * t14 - f2 * t17;
  const S t24 = t21 + t21 + f2 * t13;
  const S t25 = f0 * t15 - f2 * t19;
  const S t26 = t23 + t23 + f0 * t12;
  const S t27 = f1 * t20 - (t25 + t25);
  const S f5 = in.wrenches[5];  // wrench(bob).tz
  const S t28 = f4 * t14 - f5 * t17;
  const S t29 = f5 * t19 - f3 * t15;
  const S qd2 = qd[2];  // d(turn).z
  const S t30 = qd2 * qd2;
  const S qd1 = qd[1];  // d(turn).y
  const S t31 = qd2 * qd1;
  const S t32 = qd1 * qd1;
  const S qd0 = qd[0];  // d(turn).x
  const S t33 = qd0 * qd1;
  const S t34 = qd2 * qd0;
  const S t35 = S(0.3589804) * t34 - (S(0.105948) * t13 + (t29 + t29 + (f4 * t20 - (S(0.012) * t24 + S(0.63) * t26)) - S(11.12454) * t17)) + S(0.0010268) * t31;
  const S t36 = S(0.0010268) * t34 - (S(0.010807) * (t30 - t32) - (S(0.3601131) * t31 - (S(0.021) * t24 - (t28 + t28 + f3 * t12) - S(0.63) * t27))) - S(0.006304) * t33;
  const S t37 = qd0 * qd0;
  const S t38 = S(0.010807) * t34 - (S(0.0011327) * t33 - (S(0.012) * t27 + (f5 * t13 - (t22 + t22) + S(0.021) * t26)) - S(0.006304) * t31) + S(0.0010268) * (t32 - t37);
  c[1] = S(0.010807) * t33 + t35 + S(0.006304) * (t30 - t37);
  c[0] = S(11.12454) * t19 - t36 - S(0.185409) * t13;
  c[2] = S(0.211896) * t19 - (S(0.370818) * t17 + t38);
  M[1] = S(0.0010268);
  M[3] = S(0.0010268);
  M[2] = S(0.006304);
  M[6] = S(0.006304);
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
  const S q1 = q[1];  // turn.y
  const S q0 = q[0];  // turn.x
  const S q2 = q[2];  // turn.z
  qdot[3] = -(q1 * t0 + q0 * t1 + q2 * t2);
  const S q3 = q[3];  // turn.w
  qdot[0] = q1 * t2 - (q2 * t0 - q3 * t1);
  qdot[1] = q2 * t1 + q3 * t0 - q0 * t2;
  qdot[2] = q3 * t2 - (q1 * t1 - q0 * t0);
}

// energy: 23 multiplications, 15 additions (reduced formulation; relative error 4.7e-15 where it was measured).
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
  const S t6 = t5 + t1;
  const S t7 = t0 + t5;
  W[10] = S(1.0) - (t7 + t7);
  W[5] = S(1.0) - (t6 + t6);
  const S t10 = q1 * q0;
  const S q3 = q[3];  // turn.w
  const S t11 = q1 * q3;
  const S t12 = q3 * q2;
  const S t13 = q0 * q2;
  const S t14 = q0 * q3;
  W[6] = S(-2.0) * (t14 - t4);
  const S t16 = t14 + t4;
  W[9] = t16 + t16;
  const S t18 = t11 + t13;
  W[8] = S(-2.0) * (t11 - t13);
  W[2] = t18 + t18;
  W[1] = S(-2.0) * (t12 - t10);
  const S t22 = t12 + t10;
  W[4] = t22 + t22;
  W[3] = S(0.0);
  W[7] = S(0.0);
  W[11] = S(0.0);
}

}  // namespace alembert::mechanisms::spherical_pendulum

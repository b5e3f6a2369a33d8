// rolling_wheels: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "rolling_wheels". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "rolling_wheels_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::rolling_wheels {

// inverse_dynamics: 64 multiplications, 43 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qdd0 = qdd[0];  // dd(q1)
  const S qdd1 = qdd[1];  // dd(q2)
  const S f0 = in.wrenches[0];  // wrench(wheel).fx
  const S f1 = in.wrenches[1];  // wrench(wheel).fy
  const S f5 = in.wrenches[5];  // wrench(wheel).tz
  const S t0 = cos(q0);
  const S t1 = sin(q0);
  const S t2 = S(4.0) * q0;
  const S t3 = cos(t2);
  const S t4 = sin(t2);
  const S t5 = qd0 * qd0;
  const S t6 = t0 * t5 + qdd0 * t1;
  const S t7 = qdd0 * t0 - t5 * t1 + S(9.81);
  const S t8 = t4 * t6 + t3 * t7;
  const S t9 = sin(q1);
  const S t10 = cos(q1);
  const S t11 = S(5.92) * t5 + qd1 * (S(2.96) * qd0 + S(0.37) * qd1);
  const S t12 = S(1.48) * qdd0 + S(0.37) * qdd1;
  const S t13 = t8 - t9 * t11 + t10 * t12;
  const S t14 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S t15 = cos(t14);
  const S t16 = sin(t14);
  const S t17 = S(3.0833333333333335) * qdd1 + S(4.0) * qdd0;
  const S t18 = S(3.0833333333333335) * qd1 + S(4.0) * qd0;
  const S t19 = t18 * t18;
  const S t20 = S(0.21) * t13 + S(0.0015143315356948757) * (t15 * t17 - t19 * t16);
  const S t21 = f0 * t4 - t3 * f1;
  const S t22 = t20 + (t21 + (S(0.312) * t5 + S(0.12) * qdd0));
  const S t23 = t4 * t7 - t3 * t6;
  const S t24 = t23 - t10 * t11 - t9 * t12;
  const S t25 = S(0.21) * t24 - S(0.0015143315356948757) * (t19 * t15 + t17 * t16);
  const S t26 = f0 * t3 + f1 * t4;
  const S t27 = t25 - (t26 + (S(0.48) * t5 - S(0.078) * qdd0));
  const S t28 = S(0.37) * (t9 * t25 - t10 * t20);
  const S t29 = S(0.0015109200000000002) * t17 - S(0.0015143315356948757) * (t24 * t16 - t15 * t13);
  const S t30 = S(4.0) * (f5 + (S(0.013) * t26 - S(0.02) * t21) - (S(0.267414) * qdd0 + (S(0.03) * t8 + S(0.0195) * t23)) + (t28 - t29));
  tau[0] = t0 * (t3 * t22 + t4 * t27 + S(1.5) * t7) + t1 * (S(1.5) * t6 - (t3 * t27 - t4 * t22)) - t30;
  tau[1] = S(3.0833333333333335) * t29 - t28;
}

// mass_matrix: 41 multiplications, 28 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S t0 = sin(q0);
  const S t1 = cos(q0);
  const S t2 = S(4.0) * q0;
  const S t3 = cos(t2);
  const S t4 = sin(t2);
  const S t5 = t0 * t3 - t4 * t1;
  const S t6 = t3 * t1 + t0 * t4;
  const S t7 = cos(q1);
  const S t8 = sin(q1);
  const S t9 = t6 + S(1.48) * t7;
  const S t10 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S t11 = cos(t10);
  const S t12 = sin(t10);
  const S t13 = t5 + S(1.48) * t8;
  const S t14 = S(0.0015143315356948757) * (t9 * t11 + t13 * t12) + S(0.006043680000000001);
  const S t15 = S(0.006057326142779503) * t12 + S(0.21) * t13;
  const S t16 = S(0.006057326142779503) * t11 + S(0.21) * t9;
  const S t17 = S(0.37) * (t8 * t15 + t7 * t16);
  const S t18 = t16 + S(0.12);
  const S t19 = S(0.078) - t15;
  const S t20 = t1 * (t3 * t18 + t4 * t19 + S(1.5) * t1) - t0 * (t3 * t19 - t4 * t18 - S(1.5) * t0);
  M[0] = S(4.0) * (S(0.267414) - (S(0.0195) * t5 - S(0.03) * t6) + (t14 + t17)) + t20;
  const S t22 = t17 + S(3.0833333333333335) * t14;
  M[1] = t22;
  M[2] = t22;
  const S t23 = S(0.37) * (t7 * (S(0.004669188901725867) * t11 + S(0.0777) * t7) + t8 * (S(0.0777) * t8 + S(0.004669188901725867) * t12));
  M[3] = S(3.0833333333333335) * (S(0.000560302668207104) * (t7 * t11 + t8 * t12) + S(0.004658670000000001)) + t23;
}

// bias: 50 multiplications, 31 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S f0 = in.wrenches[0];  // wrench(wheel).fx
  const S f1 = in.wrenches[1];  // wrench(wheel).fy
  const S f5 = in.wrenches[5];  // wrench(wheel).tz
  const S t0 = sin(q0);
  const S t1 = cos(q0);
  const S t2 = qd0 * qd0;
  const S t3 = t1 * t2;
  const S t4 = S(4.0) * q0;
  const S t5 = cos(t4);
  const S t6 = sin(t4);
  const S t7 = t5 * f0 + f1 * t6;
  const S t8 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S t9 = cos(t8);
  const S t10 = sin(t8);
  const S t11 = S(4.0) * qd0 + S(3.0833333333333335) * qd1;
  const S t12 = t11 * t11;
  const S t13 = S(9.81) - t0 * t2;
  const S t14 = t3 * t5 - t6 * t13;
  const S t15 = S(5.92) * t2 + qd1 * (S(2.96) * qd0 + S(0.37) * qd1);
  const S t16 = cos(q1);
  const S t17 = sin(q1);
  const S t18 = t14 + t15 * t16;
  const S t19 = S(0.0015143315356948757) * (t9 * t12) + S(0.21) * t18;
  const S t20 = t7 + S(0.48) * t2 + t19;
  const S t21 = t5 * f1 - f0 * t6;
  const S t22 = t3 * t6 + t5 * t13;
  const S t23 = t15 * t17 - t22;
  const S t24 = S(0.0015143315356948757) * (t12 * t10) + S(0.21) * t23;
  const S t25 = S(0.312) * t2 - t21 - t24;
  const S t26 = S(0.37) * (t16 * t24 - t19 * t17);
  const S t27 = t9 * t23 - t18 * t10;
  const S t28 = S(4.0) * (f5 + (S(0.013) * t7 + S(0.02) * t21) + (S(0.0195) * t14 - S(0.03) * t22) + (t26 + S(0.0015143315356948757) * t27));
  c[0] = t0 * (S(1.5) * t3 + (t5 * t20 + t6 * t25)) + t1 * (S(1.5) * t13 - (t6 * t20 - t5 * t25)) - t28;
  c[1] = S(-0.004669188901725867) * t27 - t26;
}

// mass_matrix_and_bias: 89 multiplications, 59 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S f0 = in.wrenches[0];  // wrench(wheel).fx
  const S f1 = in.wrenches[1];  // wrench(wheel).fy
  const S f5 = in.wrenches[5];  // wrench(wheel).tz
  const S t0 = sin(q0);
  const S t1 = cos(q0);
  const S t2 = S(4.0) * q0;
  const S t3 = cos(t2);
  const S t4 = sin(t2);
  const S t5 = S(3.0833333333333335) * q1 + S(0.982793723247329);
  const S t6 = sin(t5);
  const S t7 = cos(t5);
  const S t8 = sin(q1);
  const S t9 = cos(q1);
  const S t10 = t1 * t4 - t0 * t3;
  const S t11 = S(1.48) * t8 - t10;
  const S t12 = S(0.006057326142779503) * t6 + S(0.21) * t11;
  const S t13 = S(0.078) - t12;
  const S t14 = t0 * t4 + t3 * t1;
  const S t15 = S(1.48) * t9 + t14;
  const S t16 = S(0.006057326142779503) * t7 + S(0.21) * t15;
  const S t17 = t16 + S(0.12);
  const S t18 = S(0.37) * (t8 * t12 + t9 * t16);
  const S t19 = S(0.0015143315356948757) * (t7 * t15 + t6 * t11) + S(0.006043680000000001);
  const S t20 = S(4.0) * (t18 + t19 + (S(0.0195) * t10 + S(0.03) * t14 + S(0.267414)));
  M[0] = t0 * (S(1.5) * t0 - (t3 * t13 - t4 * t17)) + t1 * (t4 * t13 + t3 * t17 + S(1.5) * t1) + t20;
  const S t22 = t18 + S(3.0833333333333335) * t19;
  M[1] = t22;
  M[2] = t22;
  const S t23 = S(0.37) * (t9 * (S(0.004669188901725867) * t7 + S(0.0777) * t9) + t8 * (S(0.0777) * t8 + S(0.004669188901725867) * t6));
  M[3] = S(3.0833333333333335) * (S(0.000560302668207104) * (t7 * t9 + t6 * t8) + S(0.004658670000000001)) + t23;
  const S t25 = qd0 * qd0;
  const S t26 = t1 * t25;
  const S t27 = t3 * f0 + t4 * f1;
  const S t28 = S(4.0) * qd0 + S(3.0833333333333335) * qd1;
  const S t29 = t28 * t28;
  const S t30 = S(9.81) - t0 * t25;
  const S t31 = t3 * t26 - t4 * t30;
  const S t32 = S(5.92) * t25 + qd1 * (S(2.96) * qd0 + S(0.37) * qd1);
  const S t33 = t31 + t9 * t32;
  const S t34 = S(0.0015143315356948757) * (t7 * t29) + S(0.21) * t33;
  const S t35 = t27 + S(0.48) * t25 + t34;
  const S t36 = t3 * f1 - t4 * f0;
  const S t37 = t4 * t26 + t3 * t30;
  const S t38 = t8 * t32 - t37;
  const S t39 = S(0.0015143315356948757) * (t6 * t29) + S(0.21) * t38;
  const S t40 = S(0.312) * t25 - t36 - t39;
  const S t41 = S(0.37) * (t9 * t39 - t8 * t34);
  const S t42 = t7 * t38 - t6 * t33;
  const S t43 = S(4.0) * (f5 + (S(0.013) * t27 + S(0.02) * t36) + (S(0.0195) * t31 - S(0.03) * t37) + (t41 + S(0.0015143315356948757) * t42));
  c[0] = t0 * (S(1.5) * t26 + (t3 * t35 + t4 * t40)) + t1 * (S(1.5) * t30 - (t4 * t35 - t3 * t40)) - t43;
  c[1] = S(-0.004669188901725867) * t42 - t41;
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  qdot[0] = qd0;
  qdot[1] = qd1;
}

// energy: 42 multiplications, 24 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S t0 = S(4.0) * q0;
  const S t1 = cos(t0);
  const S t2 = sin(t0);
  const S t3 = cos(q0);
  const S t4 = sin(q0);
  const S t5 = qd0 * t3;
  const S t6 = qd0 * t4;
  const S t7 = t1 * t5 + t2 * t6;
  const S t8 = cos(q1);
  const S t9 = sin(q1);
  const S t10 = S(0.37) * qd1 + S(1.48) * qd0;
  const S t11 = t7 + t8 * t10;
  const S t12 = S(3.0833333333333335) * q1;
  const S t13 = sin(t12);
  const S t14 = cos(t12);
  const S t15 = t5 * t2 - t1 * t6;
  const S t16 = t15 - t10 * t9;
  const S t17 = t11 * t13 + t14 * t16;
  const S t18 = t13 * t16 - t11 * t14;
  const S t19 = S(3.0833333333333335) * qd1 + S(4.0) * qd0;
  const S t20 = qd0 * (S(0.12) * t7 + S(0.078) * t15 + S(1.284828) * qd0);
  e[0] = S(0.105) * (t17 * t17 + t18 * t18) - t19 * (S(0.00126) * t17 + S(0.00084) * t18 - S(0.00075546) * t19) + t20;
  const S t22 = S(2.0601) * (S(0.004) * (t1 * t13 + t2 * t14) - (S(0.006) * (t2 * t13 - t1 * t14) - (t4 + S(0.37) * (t1 * t9 + t8 * t2))));
  e[1] = S(14.715) * (t4 + (S(0.02) * t2 - S(0.013) * t1)) + t22;
}

// body_poses: 12 multiplications, 6 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S t0 = S(4.0) * q0;
  const S t1 = cos(t0);
  W[0] = t1;
  W[5] = t1;
  const S t2 = sin(t0);
  W[4] = t2;
  W[1] = -t2;
  const S t4 = cos(q0);
  W[3] = t4;
  const S t5 = sin(q0);
  W[7] = t5;
  const S t6 = S(3.0833333333333335) * q1;
  const S t7 = cos(t6);
  const S t8 = sin(t6);
  const S t9 = t1 * t7 - t2 * t8;
  W[12] = t9;
  W[17] = t9;
  const S t10 = t1 * t8 + t2 * t7;
  W[16] = t10;
  W[13] = -t10;
  const S t12 = sin(q1);
  const S t13 = cos(q1);
  W[15] = t4 - S(0.37) * (t2 * t12 - t1 * t13);
  W[19] = t5 + S(0.37) * (t1 * t12 + t2 * t13);
  W[2] = S(0.0);
  W[6] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[14] = S(0.0);
  W[18] = S(0.0);
  W[20] = S(0.0);
  W[21] = S(0.0);
  W[23] = S(0.0);
  W[10] = S(1.0);
  W[22] = S(1.0);
}

}  // namespace alembert::mechanisms::rolling_wheels

// bead_on_helix: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "bead_on_helix". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "bead_on_helix_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::bead_on_helix {

// inverse_dynamics: 126 multiplications, 86 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // s
  const S q1 = q[1];  // spin
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S qdd0 = qdd[0];  // dd(s)
  const S qdd1 = qdd[1];  // dd(spin)
  const S f0 = in.wrenches[0];  // wrench(bead).fx
  const S f1 = in.wrenches[1];  // wrench(bead).fy
  const S f2 = in.wrenches[2];  // wrench(bead).fz
  const S f3 = in.wrenches[3];  // wrench(bead).tx
  const S f4 = in.wrenches[4];  // wrench(bead).ty
  const S f5 = in.wrenches[5];  // wrench(bead).tz
  const S t0 = qd0 * qd0;
  const S t1 = sin(q1);
  const S t2 = cos(q1);
  const S t3 = qdd1 + S(0.18428853505018536) * qdd0;
  const S t4 = qd0 * t1;
  const S t5 = qd0 * t2;
  const S t6 = S(0.9660377358490566) * (t4 * t5);
  const S t7 = t3 - t6;
  const S t8 = S(0.9660377358490566) * (t5 * t5);
  const S t9 = qd1 + S(0.18428853505018536) * qd0;
  const S t10 = t9 * t9;
  const S t11 = sin(q0);
  const S t12 = cos(q0);
  const S t13 = t2 * t11;
  const S t14 = t1 * t12;
  const S t15 = t13 + S(0.18428853505018536) * t14;
  const S t16 = t2 * t12;
  const S t17 = t1 * t11;
  const S t18 = t16 - S(0.18428853505018536) * t17;
  const S t19 = S(0.9828721869343219) * (t1 * f2) - (f1 * t15 + f0 * t18);
  const S t20 = S(0.00175) * t7 - S(0.00275) * (t8 + t10) - t19;
  const S t21 = t14 + S(0.18428853505018536) * t13;
  const S t22 = t17 - S(0.18428853505018536) * t16;
  const S t23 = f0 * t21 + f1 * t22 + S(0.9828721869343219) * (t2 * f2);
  const S t24 = t3 + t6;
  const S t25 = S(0.9660377358490566) * (t4 * t4);
  const S t26 = t23 - (S(0.00275) * t24 + S(0.00175) * (t10 + t25));
  const S t27 = S(0.00018113207547169812) * t0 + (t1 * t20 - t2 * t26);
  const S t28 = S(0.9828721869343219) * (qdd0 * t2 - t4 * qd1);
  const S t29 = S(0.9828721869343219) * (t4 * t9);
  const S t30 = t28 - t29;
  const S t31 = S(0.9828721869343219) * (t5 * qd1 + t1 * qdd0);
  const S t32 = S(0.9828721869343219) * (t5 * t9);
  const S t33 = t31 + t32;
  const S t34 = S(0.18428853505018536) * f2 + S(0.9828721869343219) * (f1 * t12 - t11 * f0);
  const S t35 = S(0.00275) * t30 + S(0.00175) * t33 + t34 + S(0.0009660377358490566) * t0;
  const S t36 = S(0.15) * qdd0 + S(9.81);
  const S t37 = S(0.0009828721869343218) * qdd0 + (t1 * t26 + t2 * t20);
  const S t38 = S(0.18428853505018536) * t27 + S(0.9828721869343219) * t35;
  const S t39 = t11 * (t11 * t38 - t12 * t37 - S(0.2) * (t0 * t12 + qdd0 * t11));
  const S t40 = S(0.1474308280401483) * qdd0 - S(0.9828721869343219) * t36;
  const S t41 = S(0.00175) * (S(0.8) * (t0 * t2) - t1 * t40) - (S(0.18428853505018536) * f5 + (S(0.9828721869343219) * (t12 * f4 - t11 * f3) + (S(0.011) * t23 + S(0.007) * t19)));
  const S t42 = S(4.0000000000000015e-06) * (t31 - t32) - (S(1.5000000000000002e-05) * (t28 + t29) + (S(0.00275) * (t2 * t40 + S(0.8) * (t0 * t1)) - t41 - S(0.00021025) * t24));
  const S t43 = S(0.00014225) * t7 - (S(3.025e-05) * (t8 - t25) - t42);
  tau[1] = t43;
  const S t44 = S(0.18428853505018536) * t36 + S(0.7862977495474576) * qdd0;
  const S t45 = S(0.00275) * t44 + (S(1.5000000000000002e-05) * t7 - S(3.025e-05) * t33 - S(4.0000000000000015e-06) * (t10 - t25) - S(0.00021025) * t30);
  const S t46 = S(0.00175) * t44 + (S(1.5000000000000002e-05) * (t8 - t10) - (S(3.025e-05) * t30 + S(4.0000000000000015e-06) * t24) - S(0.00014225) * t33);
  const S t47 = t1 * (S(0.9828721869343219) * (t1 * f5) - (t15 * f4 + t18 * f3) - (S(0.007) * t34 + S(0.004) * t23) + t46);
  const S t48 = S(0.0008) * t0 + S(0.0001120474293105127) * qdd0;
  const S t49 = S(0.9828721869343219) * (t2 * (S(0.9828721869343219) * (t2 * f5) + (t21 * f3 + t22 * f4) - (S(0.011) * t34 - S(0.004) * t19) + t45) + t47 - t48);
  const S t50 = S(0.8) * (t12 * (t11 * t37 + (S(0.2) * (t0 * t11 - qdd0 * t12) + t12 * t38)) + t39) + (S(-0.18428853505018536) * t43 + t49);
  tau[0] = S(0.15) * (S(0.9828721869343219) * t27 - S(0.18428853505018536) * t35 + S(0.25) * t36) - t50;
}

// mass_matrix: 13 multiplications, 9 additions, 2 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // spin
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(1.5e-05) * t0 - S(4e-06) * t1;
  const S t3 = S(6.496170860519034e-05) - S(0.9828721869343219) * t2;
  M[1] = t3;
  M[2] = t3;
  const S t4 = S(1.6) * (S(0.00275) * t0 + S(0.00175) * t1) - (S(0.9828721869343219) * (S(0.9828721869343219) * (S(0.00032425) - t1 * (S(6.8e-05) * t1 - S(6.05e-05) * t0)) - S(0.18428853505018536) * t2) + S(0.18428853505018536) * t3);
  M[0] = S(0.165625) - t4;
  M[3] = S(0.0003525);
}

// bias: 97 multiplications, 67 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // s
  const S q1 = q[1];  // spin
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S f0 = in.wrenches[0];  // wrench(bead).fx
  const S f1 = in.wrenches[1];  // wrench(bead).fy
  const S f2 = in.wrenches[2];  // wrench(bead).fz
  const S f3 = in.wrenches[3];  // wrench(bead).tx
  const S f4 = in.wrenches[4];  // wrench(bead).ty
  const S f5 = in.wrenches[5];  // wrench(bead).tz
  const S t0 = qd0 * qd0;
  const S t1 = cos(q1);
  const S t2 = sin(q1);
  const S t3 = sin(q0);
  const S t4 = cos(q0);
  const S t5 = t1 * t3;
  const S t6 = t4 * t2;
  const S t7 = S(0.18428853505018536) * t5 + t6;
  const S t8 = t3 * t2;
  const S t9 = t1 * t4;
  const S t10 = t8 - S(0.18428853505018536) * t9;
  const S t11 = f0 * t7 + f1 * t10 + S(0.9828721869343219) * (t1 * f2);
  const S t12 = qd1 + S(0.18428853505018536) * qd0;
  const S t13 = t12 * t12;
  const S t14 = qd0 * t2;
  const S t15 = S(0.9660377358490566) * (t14 * t14);
  const S t16 = qd0 * t1;
  const S t17 = t14 * t16;
  const S t18 = S(0.9660377358490566) * (t16 * t16);
  const S t19 = t5 + S(0.18428853505018536) * t6;
  const S t20 = t9 - S(0.18428853505018536) * t8;
  const S t21 = S(0.9828721869343219) * (t2 * f2) - (f1 * t19 + f0 * t20);
  const S t22 = S(0.00018113207547169812) * t0 - (t1 * (t11 - (S(0.00175) * (t13 + t15) + S(0.0026566037735849058) * t17)) + t2 * (S(0.00275) * (t13 + t18) + S(0.001690566037735849) * t17 + t21));
  const S t23 = S(0.18428853505018536) * f2 + S(0.9828721869343219) * (t4 * f1 - f0 * t3);
  const S t24 = S(0.9828721869343219) * (qd1 * t14);
  const S t25 = S(0.9828721869343219) * (t12 * t14);
  const S t26 = t24 + t25;
  const S t27 = S(0.9828721869343219) * (qd1 * t16);
  const S t28 = S(0.9828721869343219) * (t12 * t16);
  const S t29 = t27 + t28;
  const S t30 = t23 - (S(0.00275) * t26 - S(0.00175) * t29) + S(0.0009660377358490566) * t0;
  const S t31 = S(0.9828721869343219) * (t1 * f5) + (t7 * f3 + t10 * f4) - (S(0.011) * t23 - S(0.004) * t21);
  const S t32 = S(0.9828721869343219) * (t2 * f5) - (t19 * f4 + t20 * f3) - (S(0.007) * t23 + S(0.004) * t11);
  const S t33 = t2 * (S(3.025e-05) * t26 - S(3.864150943396228e-06) * t17 - S(1.5000000000000002e-05) * (t13 - t18) - S(0.00014225) * t29 + S(0.003163773425474057) + t32);
  const S t34 = S(1.5000000000000002e-05) * (t24 - t25) + (S(3.025e-05) * (t15 - t18) - (S(0.18428853505018536) * f5 + (S(0.9828721869343219) * (t4 * f4 - t3 * f3) + (S(0.011) * t11 + S(0.007) * t21))));
  const S t35 = S(0.00275) * (S(9.641976153825699) * t1 - S(0.8) * (t0 * t2)) + (t34 + S(4.0000000000000015e-06) * (t27 - t28) + S(6.569056603773585e-05) * t17);
  const S t36 = S(0.00175) * (S(0.8) * (t0 * t1) + S(9.641976153825699) * t2) + t35;
  c[1] = t36;
  const S t37 = S(0.18428853505018536) * t36;
  const S t38 = S(0.9828721869343219) * (t1 * (S(0.00021025) * t26 - (S(1.4490566037735852e-05) * t17 + S(3.025e-05) * t29 + S(4.0000000000000015e-06) * (t13 - t15)) + S(0.0049716439543163755) + t31) + t33 - S(0.0008) * t0) - t37;
  c[0] = S(0.15) * (S(0.9828721869343219) * t22 - S(0.18428853505018536) * t30 + S(2.4525)) - t38 - S(0.8) * (S(0.9828721869343219) * t30 + S(0.18428853505018536) * t22);
}

// mass_matrix_and_bias: 110 multiplications, 76 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // s
  const S q1 = q[1];  // spin
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S f0 = in.wrenches[0];  // wrench(bead).fx
  const S f1 = in.wrenches[1];  // wrench(bead).fy
  const S f2 = in.wrenches[2];  // wrench(bead).fz
  const S f3 = in.wrenches[3];  // wrench(bead).tx
  const S f4 = in.wrenches[4];  // wrench(bead).ty
  const S f5 = in.wrenches[5];  // wrench(bead).tz
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(1.5e-05) * t0 - S(4e-06) * t1;
  const S t3 = S(6.496170860519034e-05) - S(0.9828721869343219) * t2;
  M[1] = t3;
  M[2] = t3;
  const S t4 = S(1.6) * (S(0.00275) * t0 + S(0.00175) * t1) - (S(0.9828721869343219) * (S(0.9828721869343219) * (S(0.00032425) - t1 * (S(6.8e-05) * t1 - S(6.05e-05) * t0)) - S(0.18428853505018536) * t2) + S(0.18428853505018536) * t3);
  M[0] = S(0.165625) - t4;
  const S t6 = qd0 * qd0;
  const S t7 = sin(q0);
  const S t8 = cos(q0);
  const S t9 = t0 * t7;
  const S t10 = t1 * t8;
  const S t11 = S(0.18428853505018536) * t9 + t10;
  const S t12 = t1 * t7;
  const S t13 = t0 * t8;
  const S t14 = t12 - S(0.18428853505018536) * t13;
  const S t15 = f0 * t11 + f1 * t14 + S(0.9828721869343219) * (t0 * f2);
  const S t16 = qd1 + S(0.18428853505018536) * qd0;
  const S t17 = t16 * t16;
  const S t18 = t1 * qd0;
  const S t19 = S(0.9660377358490566) * (t18 * t18);
  const S t20 = t0 * qd0;
  const S t21 = t18 * t20;
  const S t22 = S(0.9660377358490566) * (t20 * t20);
  const S t23 = t9 + S(0.18428853505018536) * t10;
  const S t24 = t13 - S(0.18428853505018536) * t12;
  const S t25 = S(0.9828721869343219) * (t1 * f2) - (f1 * t23 + f0 * t24);
  const S t26 = S(0.00018113207547169812) * t6 - (t0 * (t15 - (S(0.00175) * (t17 + t19) + S(0.0026566037735849058) * t21)) + t1 * (S(0.00275) * (t17 + t22) + S(0.001690566037735849) * t21 + t25));
  const S t27 = S(0.18428853505018536) * f2 + S(0.9828721869343219) * (t8 * f1 - f0 * t7);
  const S t28 = S(0.9828721869343219) * (qd1 * t18);
  const S t29 = S(0.9828721869343219) * (t16 * t18);
  const S t30 = t28 + t29;
  const S t31 = S(0.9828721869343219) * (qd1 * t20);
  const S t32 = S(0.9828721869343219) * (t16 * t20);
  const S t33 = t31 + t32;
  const S t34 = t27 - (S(0.00275) * t30 - S(0.00175) * t33) + S(0.0009660377358490566) * t6;
  const S t35 = S(0.9828721869343219) * (t0 * f5) + (t11 * f3 + t14 * f4) - (S(0.011) * t27 - S(0.004) * t25);
  const S t36 = S(0.9828721869343219) * (t1 * f5) - (t23 * f4 + t24 * f3) - (S(0.007) * t27 + S(0.004) * t15);
  const S t37 = t1 * (S(3.025e-05) * t30 - S(3.864150943396228e-06) * t21 - S(1.5000000000000002e-05) * (t17 - t22) - S(0.00014225) * t33 + S(0.003163773425474057) + t36);
  const S t38 = S(1.5000000000000002e-05) * (t28 - t29) + (S(3.025e-05) * (t19 - t22) - (S(0.18428853505018536) * f5 + (S(0.9828721869343219) * (t8 * f4 - t7 * f3) + (S(0.011) * t15 + S(0.007) * t25))));
  const S t39 = S(0.00275) * (S(9.641976153825699) * t0 - S(0.8) * (t1 * t6)) + (t38 + S(4.0000000000000015e-06) * (t31 - t32) + S(6.569056603773585e-05) * t21);
  const S t40 = S(0.00175) * (S(0.8) * (t0 * t6) + S(9.641976153825699) * t1) + t39;
  c[1] = t40;
  const S t41 = S(0.18428853505018536) * t40;
  const S t42 = S(0.9828721869343219) * (t0 * (S(0.00021025) * t30 - (S(1.4490566037735852e-05) * t21 + S(3.025e-05) * t33 + S(4.0000000000000015e-06) * (t17 - t19)) + S(0.0049716439543163755) + t35) + t37 - S(0.0008) * t6) - t41;
  c[0] = S(0.15) * (S(0.9828721869343219) * t26 - S(0.18428853505018536) * t34 + S(2.4525)) - t42 - S(0.8) * (S(0.9828721869343219) * t34 + S(0.18428853505018536) * t26);
  M[3] = S(0.0003525);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  qdot[0] = qd0;
  qdot[1] = qd1;
}

// energy: 26 multiplications, 15 additions, 2 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // s
  const S q1 = q[1];  // spin
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = qd0 * t0;
  const S t3 = qd0 * t1;
  const S t4 = qd1 + S(0.18428853505018536) * qd0;
  const S t5 = S(0.9828721869343219) * (t2 * (S(0.00031869630661345385) * t2 + (S(2.9731883654763237e-05) * t3 - S(1.5e-05) * t4)) + t3 * (S(2.9731883654763237e-05) * t2 + (S(0.00025186099790191997) * t3 + S(4e-06) * t4)));
  e[0] = qd0 * (S(0.0828125) * qd0 - S(0.8139410298049853) * (S(0.002702898514069385) * t2 + S(0.0017200263271350633) * t3)) - S(0.5) * (t4 * (S(1.474308280401483e-05) * t2 - (S(0.0003525) * t4 + S(3.9314887477372875e-06) * t3)) - t5);
  e[1] = S(2.4525) * (S(0.15) * q0 + (S(0.01081159405627754) * t1 + S(0.0007371541402007414) - S(0.006880105308540253) * t0));
}

// body_poses: 15 multiplications, 4 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // s
  const S q1 = q[1];  // spin
  const S t0 = sin(q0);
  const S t1 = cos(q0);
  W[0] = S(-0.9828721869343219) * t0;
  const S t3 = sin(q1);
  const S t4 = cos(q1);
  const S t5 = t0 * t3;
  const S t6 = t1 * t4;
  W[1] = S(0.18428853505018536) * t5 - t6;
  const S t8 = t1 * t3;
  const S t9 = t0 * t4;
  W[2] = t8 + S(0.18428853505018536) * t9;
  W[3] = S(0.8) * t1;
  W[4] = S(0.9828721869343219) * t1;
  W[5] = S(-0.18428853505018536) * t8 - t9;
  W[6] = t5 - S(0.18428853505018536) * t6;
  W[7] = S(0.8) * t0;
  W[9] = S(0.9828721869343219) * t3;
  W[10] = S(0.9828721869343219) * t4;
  W[11] = S(0.15) * q0;
  W[8] = S(0.18428853505018536);
}

}  // namespace alembert::mechanisms::bead_on_helix

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

// inverse_dynamics: 110 multiplications, 76 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
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
  const S t0 = q1 + S(5.71645608965608);
  const S angle[] = {q0, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = S(0.18428853505018536) * f2 + S(0.9828721869343219) * (t2 * f1 - f0 * t1);
  const S t6 = S(0.15) * qdd0 + S(9.81);
  const S t7 = S(0.18428853505018536) * t6 + S(0.7862977495474576) * qdd0;
  const S t8 = qd0 * t4;
  const S t9 = qd1 + S(0.18428853505018536) * qd0;
  const S t10 = S(0.9828721869343219) * (t8 * t9);
  const S t11 = S(0.9828721869343219) * (t8 * qd1 - t3 * qdd0);
  const S t12 = t10 + t11;
  const S t13 = qd0 * qd0;
  const S t14 = t5 - (S(0.25) * t7 + (S(0.003259601202601324) * t12 - S(0.0009660377358490566) * t13));
  const S t15 = t4 * t1;
  const S t16 = t3 * t2;
  const S t17 = S(0.18428853505018536) * t15 - t16;
  const S t18 = t3 * t1;
  const S t19 = t4 * t2;
  const S t20 = t18 + S(0.18428853505018536) * t19;
  const S t21 = f0 * t17 - f1 * t20 + S(0.9828721869343219) * (t4 * f2);
  const S t22 = S(0.1474308280401483) * qdd0 - S(0.9828721869343219) * t6;
  const S t23 = S(0.8) * (t3 * t13) - t22 * t4;
  const S t24 = t9 * t9;
  const S t25 = t3 * qd0;
  const S t26 = S(0.9660377358490566) * (t25 * t25);
  const S t27 = t10 - t11;
  const S t28 = t15 - S(0.18428853505018536) * t16;
  const S t29 = t19 + S(0.18428853505018536) * t18;
  const S t30 = f1 * t28 + f0 * t29 + S(0.9828721869343219) * (t3 * f2);
  const S t31 = S(0.8) * (t13 * t4) + t3 * t22;
  const S t32 = qdd1 + S(0.18428853505018536) * qdd0;
  const S t33 = S(0.9660377358490566) * (t8 * t25);
  const S t34 = t32 + t33;
  const S t35 = S(0.9828721869343219) * (t9 * t25);
  const S t36 = S(0.9828721869343219) * (qd1 * t25 + qdd0 * t4);
  const S t37 = t35 - t36;
  const S t38 = t4 * (t21 - (S(0.25) * t23 - (S(0.003259601202601324) * (t24 + t26) - S(0.001) * t27))) + t3 * (t30 + (S(0.25) * t31 - (S(0.003259601202601324) * t34 + S(0.001) * t37)));
  const S t39 = S(0.9660377358490566) * (t8 * t8);
  const S t40 = t32 - t33;
  const S t41 = t35 + t36;
  const S t42 = S(0.004) * t21 - S(0.013038404810405297) * t5 + (f4 * t28 + f3 * t29 + S(0.9828721869343219) * (t3 * f5));
  const S t43 = t3 * (S(0.003259601202601324) * t7 - S(0.001) * t23 + (S(1.1427778333825821e-05) * (t39 - t24) + (S(1.0507420347208973e-05) * t40 + S(1.7988235294117643e-05) * t41) - S(0.00011399999999999995) * t27 + S(0.00021805294117647052) * t12) + t42);
  const S t44 = S(0.001) * t31 - (S(0.00011399999999999995) * t37 - (S(0.00013444705882352938) * t41 + (S(1.0507420347208973e-05) * (t24 - t26) + (S(1.798823529411765e-05) * t12 + S(1.1427778333825821e-05) * t34))));
  const S t45 = S(0.9828721869343219) * (t43 + t4 * (S(2.6020852139652106e-18) * t5 - S(0.004) * t30 + (t17 * f3 - t20 * f4 + S(0.9828721869343219) * (t4 * f5)) - t44) + S(0.8) * t14);
  const S t46 = S(1.0507420347208973e-05) * t27;
  const S t47 = S(1.798823529411765e-05) * (t39 - t26) + (S(0.003259601202601324) * t31 - (S(2.6020852139652106e-18) * t21 - S(0.013038404810405297) * t30 - S(0.9828721869343219) * (t2 * f4 - t1 * f3) - S(0.18428853505018536) * f5)) + t46;
  const S t48 = S(0.00013444705882352938) * t40 - (t47 + S(1.1427778333825821e-05) * t37 - S(0.00021805294117647052) * t34);
  tau[1] = t48;
  tau[0] = S(-0.15) * (S(0.18428853505018536) * t14 + S(0.9828721869343219) * t38) - (t45 - S(0.18428853505018536) * (S(0.8) * t38 + t48));
}

// mass_matrix: 12 multiplications, 9 additions, 2 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // spin
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = S(1.5e-05) * t0 - S(4e-06) * t1;
  M[0] = S(0.0059775) - (S(0.9828721869343219) * (S(0.3685770701003707) * t2 + S(0.9828721869343219) * (S(2.825e-05) - t1 * (S(6.05e-05) * t0 - S(6.8e-05) * t1))) - S(1.6) * (S(0.1) - (S(0.00175) * t1 + S(0.00275) * t0)));
  const S t4 = S(6.496170860519034e-05) - S(0.9828721869343219) * t2;
  M[1] = t4;
  M[2] = t4;
  M[3] = S(0.0003525);
}

// bias: 88 multiplications, 58 additions, 4 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
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
  const S t0 = S(0.5667292175235064) - q1;
  const S angle[] = {q0, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = cosine[0];
  const S t2 = sine[0];
  const S t3 = sine[1];
  const S t4 = cosine[1];
  const S t5 = qd0 * qd0;
  const S t6 = t3 * t1;
  const S t7 = t2 * t4;
  const S t8 = S(0.18428853505018536) * t6 - t7;
  const S t9 = t1 * t4;
  const S t10 = t3 * t2;
  const S t11 = t9 + S(0.18428853505018536) * t10;
  const S t12 = S(0.9828721869343219) * (t3 * f2) - (f1 * t8 - f0 * t11);
  const S t13 = qd0 * t4;
  const S t14 = S(0.9660377358490566) * (t13 * t13);
  const S t15 = qd1 + S(0.18428853505018536) * qd0;
  const S t16 = t15 * t15;
  const S t17 = qd0 * t3;
  const S t18 = t13 * t17;
  const S t19 = t6 - S(0.18428853505018536) * t7;
  const S t20 = t10 + S(0.18428853505018536) * t9;
  const S t21 = S(0.9828721869343219) * (f2 * t4) - (f0 * t19 + f1 * t20);
  const S t22 = S(0.00018113207547169812) * t5 - (t3 * (t12 - S(0.003259601202601324) * (t14 + t16)) + t4 * (S(0.0031488977655318453) * t18 + t21));
  const S t23 = S(0.9828721869343219) * (t15 * t17);
  const S t24 = S(0.9828721869343219) * (qd1 * t17);
  const S t25 = t23 + t24;
  const S t26 = S(0.18428853505018536) * f2 + S(0.9828721869343219) * (f1 * t1 - t2 * f0);
  const S t27 = S(0.003259601202601324) * t25 + t26 + S(0.0009660377358490566) * t5;
  const S t28 = S(0.9660377358490566) * (t17 * t17);
  const S t29 = S(0.9828721869343219) * (t13 * t15);
  const S t30 = S(0.9828721869343219) * (t13 * qd1);
  const S t31 = S(1.7988235294117636e-05) * (t14 - t28) + (S(1.0507420347208976e-05) * (t23 - t24) - (S(8.076643729189792e-05) * t18 + S(1.1427778333825823e-05) * (t29 - t30))) + S(0.003259601202601324) * (S(0.8) * (t5 * t3) + S(9.641976153825699) * t4);
  const S t32 = t31 - S(0.013038404810405297) * t21 - S(0.9828721869343219) * (t1 * f4 - t2 * f3) - S(0.18428853505018536) * f5;
  c[1] = t32;
  const S t33 = t29 + t30;
  const S t34 = S(0.004) * t21 - (t8 * f4 - t11 * f3 - S(0.9828721869343219) * (t3 * f5));
  const S t35 = S(0.013038404810405297) * t26 + S(0.004) * t12 - (S(0.9828721869343219) * (t4 * f5) - (t20 * f4 + t19 * f3));
  const S t36 = t4 * (S(1.0150564561832067e-05) * t18 + S(1.7988235294117623e-05) * t33 - S(1.1427778333825823e-05) * (t16 - t28) - S(0.00021805294117647063) * t25 + S(0.0058929369499619135) - t35);
  const S t37 = S(-0.18428853505018536) * t32 - S(0.9828721869343219) * (S(0.0008) * t5 + (t3 * (S(1.7988235294117636e-05) * t25 + S(1.1039665107394003e-05) * t18 + S(1.0507420347208976e-05) * (t14 - t16) - S(0.00013444705882352943) * t33 - t34) - t36));
  c[0] = S(0.15) * (S(0.9828721869343219) * t22 - S(0.18428853505018536) * t27 + S(2.4525)) - (S(0.8) * (S(0.18428853505018536) * t22 + S(0.9828721869343219) * t27) + t37);
}

// mass_matrix_and_bias: 101 multiplications, 67 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
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
  const S t0 = S(0.5667292175235064) - q1;
  const S angle[] = {q0, q1, t0};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t1 = cosine[0];
  const S t2 = sine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = sine[2];
  const S t6 = cosine[2];
  const S t7 = S(1.5e-05) * t3 - S(4e-06) * t4;
  const S t8 = S(6.496170860519034e-05) - S(0.9828721869343219) * t7;
  M[1] = t8;
  M[2] = t8;
  const S t9 = S(1.6) * (S(0.00275) * t3 + S(0.00175) * t4) - (S(0.9828721869343219) * (S(0.9828721869343219) * (S(0.00032425) - t4 * (S(6.8e-05) * t4 - S(6.05e-05) * t3)) - S(0.18428853505018536) * t7) + S(0.18428853505018536) * t8);
  M[0] = S(0.165625) - t9;
  const S t11 = qd0 * qd0;
  const S t12 = t5 * t1;
  const S t13 = t2 * t6;
  const S t14 = S(0.18428853505018536) * t12 - t13;
  const S t15 = t1 * t6;
  const S t16 = t5 * t2;
  const S t17 = t15 + S(0.18428853505018536) * t16;
  const S t18 = S(0.9828721869343219) * (t5 * f2) - (f1 * t14 - f0 * t17);
  const S t19 = qd0 * t6;
  const S t20 = S(0.9660377358490566) * (t19 * t19);
  const S t21 = qd1 + S(0.18428853505018536) * qd0;
  const S t22 = t21 * t21;
  const S t23 = qd0 * t5;
  const S t24 = t19 * t23;
  const S t25 = t12 - S(0.18428853505018536) * t13;
  const S t26 = t16 + S(0.18428853505018536) * t15;
  const S t27 = S(0.9828721869343219) * (f2 * t6) - (f0 * t25 + f1 * t26);
  const S t28 = S(0.00018113207547169812) * t11 - (t5 * (t18 - S(0.003259601202601324) * (t20 + t22)) + t6 * (S(0.0031488977655318453) * t24 + t27));
  const S t29 = S(0.9828721869343219) * (t21 * t23);
  const S t30 = S(0.9828721869343219) * (qd1 * t23);
  const S t31 = t29 + t30;
  const S t32 = S(0.18428853505018536) * f2 + S(0.9828721869343219) * (f1 * t1 - t2 * f0);
  const S t33 = S(0.003259601202601324) * t31 + t32 + S(0.0009660377358490566) * t11;
  const S t34 = S(0.9660377358490566) * (t23 * t23);
  const S t35 = S(0.9828721869343219) * (t19 * t21);
  const S t36 = S(0.9828721869343219) * (t19 * qd1);
  const S t37 = S(1.7988235294117636e-05) * (t20 - t34) + (S(1.0507420347208976e-05) * (t29 - t30) - (S(8.076643729189792e-05) * t24 + S(1.1427778333825823e-05) * (t35 - t36))) + S(0.003259601202601324) * (S(0.8) * (t11 * t5) + S(9.641976153825699) * t6);
  const S t38 = t37 - S(0.013038404810405297) * t27 - S(0.9828721869343219) * (t1 * f4 - t2 * f3) - S(0.18428853505018536) * f5;
  c[1] = t38;
  const S t39 = t35 + t36;
  const S t40 = S(0.004) * t27 - (t14 * f4 - t17 * f3 - S(0.9828721869343219) * (t5 * f5));
  const S t41 = S(0.013038404810405297) * t32 + S(0.004) * t18 - (S(0.9828721869343219) * (t6 * f5) - (t26 * f4 + t25 * f3));
  const S t42 = t6 * (S(1.0150564561832067e-05) * t24 + S(1.7988235294117623e-05) * t39 - S(1.1427778333825823e-05) * (t22 - t34) - S(0.00021805294117647063) * t31 + S(0.0058929369499619135) - t41);
  const S t43 = S(-0.18428853505018536) * t38 - S(0.9828721869343219) * (S(0.0008) * t11 + (t5 * (S(1.7988235294117636e-05) * t31 + S(1.1039665107394003e-05) * t24 + S(1.0507420347208976e-05) * (t20 - t22) - S(0.00013444705882352943) * t39 - t40) - t42));
  c[0] = S(0.15) * (S(0.9828721869343219) * t28 - S(0.18428853505018536) * t33 + S(2.4525)) - (S(0.8) * (S(0.18428853505018536) * t28 + S(0.9828721869343219) * t33) + t43);
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
  using detail::sines_and_cosines;
  const S q0 = q[0];  // s
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  W[0] = S(-0.9828721869343219) * t0;
  const S t5 = t0 * t3;
  const S t6 = t1 * t2;
  W[1] = S(0.18428853505018536) * t5 - t6;
  const S t8 = t1 * t3;
  const S t9 = t0 * t2;
  W[2] = t8 + S(0.18428853505018536) * t9;
  W[3] = S(0.8) * t1;
  W[4] = S(0.9828721869343219) * t1;
  W[5] = S(-0.18428853505018536) * t8 - t9;
  W[6] = t5 - S(0.18428853505018536) * t6;
  W[7] = S(0.8) * t0;
  W[9] = S(0.9828721869343219) * t3;
  W[10] = S(0.9828721869343219) * t2;
  W[11] = S(0.15) * q0;
  W[8] = S(0.18428853505018536);
}

}  // namespace alembert::mechanisms::bead_on_helix

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

// inverse_dynamics: 96 multiplications, 67 additions, 4 sin/cos/tan (reduced formulation).
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
  const S t5 = qd1 + S(0.18428853505018536) * qd0;
  const S t6 = t5 * t5;
  const S t7 = qd0 * t4;
  const S t8 = S(0.9660377358490566) * t7;
  const S t9 = t7 * t8;
  const S t10 = t3 * qd0;
  const S t11 = S(0.9828721869343219) * (qd1 * t10 + qdd0 * t4);
  const S t12 = S(0.9828721869343219) * t5;
  const S t13 = t12 * t10;
  const S t14 = t11 + t13;
  const S t15 = t10 * t8;
  const S t16 = qdd1 + S(0.18428853505018536) * qdd0;
  const S t17 = t15 - t16;
  const S t18 = S(0.9828721869343219) * (qdd0 * t3 - qd1 * t7);
  const S t19 = t7 * t12;
  const S t20 = t18 - t19;
  const S t21 = S(0.15) * qdd0 + S(9.81);
  const S t22 = S(0.18428853505018536) * t2;
  const S t23 = t1 * t4 - t3 * t22;
  const S t24 = S(0.18428853505018536) * t1;
  const S t25 = t3 * t24 + t2 * t4;
  const S t26 = S(0.9828721869343219) * t3;
  const S t27 = S(0.9828721869343219) * t4;
  const S t28 = t4 * t22 + t1 * t3;
  const S t29 = t2 * t3 - t4 * t24;
  const S t30 = f2 * t27 - (f1 * t28 + f0 * t29);
  const S t31 = S(0.9828721869343219) * t1;
  const S t32 = S(0.9828721869343219) * t2;
  const S t33 = S(0.18428853505018536) * f2 - (f0 * t31 - f1 * t32);
  const S t34 = t23 * f4 + t25 * f3 + t26 * f5 + (S(0.004) * t30 - S(0.013038404810405297) * t33);
  const S t35 = f2 * t26 + (f1 * t23 + f0 * t25);
  const S t36 = t10 * (S(0.9660377358490566) * t10);
  const S t37 = t15 + t16;
  const S t38 = S(1.0507420347208973e-05) * (t36 - t6) - (S(1.1427778333825821e-05) * t37 - S(1.798823529411765e-05) * t20) - S(0.0001344470588235294) * t14;
  const S t39 = t4 * (S(0.004) * t35 - S(2.6020852139652106e-18) * t33 - (t27 * f5 - (t29 * f3 + t28 * f4)) - t38);
  const S t40 = t3 * (S(1.1427778333825821e-05) * (t6 - t9) - (S(1.7988235294117643e-05) * t14 - S(1.0507420347208973e-05) * t17) + S(0.00021805294117647057) * t20 - S(0.003259601202601324) * (S(0.18428853505018536) * t21 + S(0.7862977495474576) * qdd0) - t34) + t39;
  const S t41 = t33 + S(0.003259601202601324) * t20;
  const S t42 = t3 * (t35 - S(0.003259601202601324) * t37) + t4 * (S(0.003259601202601324) * (t36 + t6) + t30);
  const S t43 = S(0.0001344470588235294) * t17 - (S(1.798823529411765e-05) * (t36 - t9) - (S(1.0507420347208973e-05) * (t18 + t19) - S(1.1427778333825821e-05) * (t11 - t13)) + S(0.00021805294117647057) * t37);
  const S t44 = S(0.003259601202601324) * (t3 * (S(0.1474308280401483) * qdd0 - S(0.9828721869343219) * t21) + qd0 * (S(0.8) * t7)) + t43;
  const S t45 = S(-0.18428853505018536) * f5 - (t32 * f4 - t31 * f3) - (S(0.013038404810405297) * t35 - S(2.6020852139652106e-18) * t30) - t44;
  tau[1] = t45;
  tau[0] = S(0.1601101283018868) * qdd0 + (S(0.9828721869343219) * (t40 - S(0.8) * t41) + S(0.18428853505018536) * (S(0.8) * t42 + t45)) - S(0.15) * (S(0.18428853505018536) * t41 + S(0.9828721869343219) * t42 - S(0.25) * t21);
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

// bias: 83 multiplications, 57 additions, 4 sin/cos/tan (reduced formulation).
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
  const S t0 = q1 + S(5.71645608965608);
  const S angle[] = {q0, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = sine[1];
  const S t4 = cosine[1];
  const S t5 = S(0.9828721869343219) * t1;
  const S t6 = S(0.9828721869343219) * t2;
  const S t7 = S(0.18428853505018536) * f2 - (f0 * t5 - f1 * t6);
  const S t8 = qd0 * t3;
  const S t9 = S(0.9828721869343219) * qd1;
  const S t10 = t8 * t9;
  const S t11 = qd1 + S(0.18428853505018536) * qd0;
  const S t12 = S(0.9828721869343219) * t11;
  const S t13 = t8 * t12;
  const S t14 = t10 + t13;
  const S t15 = t7 - S(0.003259601202601324) * t14;
  const S t16 = S(0.9828721869343219) * t3;
  const S t17 = S(0.18428853505018536) * t2;
  const S t18 = t3 * t17 + t1 * t4;
  const S t19 = S(0.18428853505018536) * t1;
  const S t20 = t2 * t4 - t3 * t19;
  const S t21 = f2 * t16 - (f1 * t18 + f0 * t20);
  const S t22 = qd0 * t4;
  const S t23 = t22 * (S(0.9660377358490566) * t22);
  const S t24 = t11 * t11;
  const S t25 = S(0.9828721869343219) * t4;
  const S t26 = t1 * t3 - t4 * t17;
  const S t27 = t4 * t19 + t2 * t3;
  const S t28 = f2 * t25 + (f1 * t26 + f0 * t27);
  const S t29 = t8 * t22;
  const S t30 = t3 * (t21 + S(0.003259601202601324) * (t23 + t24)) + t4 * (t28 - S(0.0031488977655318453) * t29);
  const S t31 = t9 * t22;
  const S t32 = t12 * t22;
  const S t33 = t31 + t32;
  const S t34 = S(0.0001344470588235294) * t33 - (S(1.0507420347208973e-05) * (t23 - t24) - (S(1.1039665107394001e-05) * t29 + S(1.798823529411765e-05) * t14));
  const S t35 = t8 * (S(0.9660377358490566) * t8);
  const S t36 = t26 * f4 + t27 * f3 + t25 * f5 + (S(0.004) * t21 - S(0.013038404810405297) * t7);
  const S t37 = t4 * (S(0.00021805294117647057) * t14 - (S(1.0150564561832064e-05) * t29 - S(1.7988235294117643e-05) * t33 + S(1.1427778333825821e-05) * (t24 - t35)) + S(0.0058929369499619135) + t36);
  const S t38 = S(1.798823529411765e-05) * (t23 - t35) + (S(1.1427778333825821e-05) * (t31 - t32) + S(1.0507420347208973e-05) * (t10 - t13)) + S(8.076643729189789e-05) * t29 - S(0.003259601202601324) * (qd0 * (S(0.8) * t8) - S(9.641976153825699) * t4);
  const S t39 = t38 - (S(0.013038404810405297) * t28 - S(2.6020852139652106e-18) * t21 + (t6 * f4 - t5 * f3 + S(0.18428853505018536) * f5));
  c[1] = t39;
  const S t40 = S(0.18428853505018536) * (t39 + S(0.8) * t30);
  const S t41 = S(0.9828721869343219) * (S(0.8) * t15 - (t3 * (S(0.004) * t28 - S(2.6020852139652106e-18) * t7 - (f5 * t16 - (f3 * t20 + f4 * t18)) + t34) - t37)) - t40;
  c[0] = S(0.15) * (S(2.4525) - (S(0.18428853505018536) * t15 + S(0.9828721869343219) * t30)) - t41;
}

// mass_matrix_and_bias: 95 multiplications, 66 additions, 6 sin/cos/tan (reduced formulation).
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
  const S t0 = q1 + S(5.71645608965608);
  const S angle[] = {q0, q1, t0};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t1 = sine[0];
  const S t2 = cosine[0];
  const S t3 = cosine[1];
  const S t4 = sine[1];
  const S t5 = sine[2];
  const S t6 = cosine[2];
  const S t7 = S(1.5e-05) * t3 - S(4e-06) * t4;
  M[0] = S(0.0059775) - (S(0.9828721869343219) * (S(0.3685770701003707) * t7 + S(0.9828721869343219) * (S(2.825e-05) - t4 * (S(6.05e-05) * t3 - S(6.8e-05) * t4))) - S(1.6) * (S(0.1) - (S(0.00175) * t4 + S(0.00275) * t3)));
  const S t9 = S(6.496170860519034e-05) - S(0.9828721869343219) * t7;
  M[1] = t9;
  M[2] = t9;
  const S t10 = S(0.9828721869343219) * t1;
  const S t11 = S(0.9828721869343219) * t2;
  const S t12 = S(0.18428853505018536) * f2 - (f0 * t10 - f1 * t11);
  const S t13 = qd0 * t5;
  const S t14 = S(0.9828721869343219) * qd1;
  const S t15 = t13 * t14;
  const S t16 = qd1 + S(0.18428853505018536) * qd0;
  const S t17 = S(0.9828721869343219) * t16;
  const S t18 = t13 * t17;
  const S t19 = t15 + t18;
  const S t20 = t12 - S(0.003259601202601324) * t19;
  const S t21 = S(0.9828721869343219) * t5;
  const S t22 = S(0.18428853505018536) * t2;
  const S t23 = t5 * t22 + t1 * t6;
  const S t24 = S(0.18428853505018536) * t1;
  const S t25 = t2 * t6 - t5 * t24;
  const S t26 = f2 * t21 - (f1 * t23 + f0 * t25);
  const S t27 = qd0 * t6;
  const S t28 = t27 * (S(0.9660377358490566) * t27);
  const S t29 = t16 * t16;
  const S t30 = S(0.9828721869343219) * t6;
  const S t31 = t1 * t5 - t6 * t22;
  const S t32 = t6 * t24 + t2 * t5;
  const S t33 = f2 * t30 + (f1 * t31 + f0 * t32);
  const S t34 = t13 * t27;
  const S t35 = t5 * (t26 + S(0.003259601202601324) * (t28 + t29)) + t6 * (t33 - S(0.0031488977655318453) * t34);
  const S t36 = t14 * t27;
  const S t37 = t17 * t27;
  const S t38 = t36 + t37;
  const S t39 = S(0.0001344470588235294) * t38 - (S(1.0507420347208973e-05) * (t28 - t29) - (S(1.1039665107394001e-05) * t34 + S(1.798823529411765e-05) * t19));
  const S t40 = t13 * (S(0.9660377358490566) * t13);
  const S t41 = t31 * f4 + t32 * f3 + t30 * f5 + (S(0.004) * t26 - S(0.013038404810405297) * t12);
  const S t42 = t6 * (S(0.00021805294117647057) * t19 - (S(1.0150564561832064e-05) * t34 - S(1.7988235294117643e-05) * t38 + S(1.1427778333825821e-05) * (t29 - t40)) + S(0.0058929369499619135) + t41);
  const S t43 = S(1.798823529411765e-05) * (t28 - t40) + (S(1.1427778333825821e-05) * (t36 - t37) + S(1.0507420347208973e-05) * (t15 - t18)) + S(8.076643729189789e-05) * t34 - S(0.003259601202601324) * (qd0 * (S(0.8) * t13) - S(9.641976153825699) * t6);
  const S t44 = t43 - (S(0.013038404810405297) * t33 - S(2.6020852139652106e-18) * t26 + (t11 * f4 - t10 * f3 + S(0.18428853505018536) * f5));
  c[1] = t44;
  const S t45 = S(0.18428853505018536) * (t44 + S(0.8) * t35);
  const S t46 = S(0.9828721869343219) * (S(0.8) * t20 - (t5 * (S(0.004) * t33 - S(2.6020852139652106e-18) * t12 - (f5 * t21 - (f3 * t25 + f4 * t23)) + t39) - t42)) - t45;
  c[0] = S(0.15) * (S(2.4525) - (S(0.18428853505018536) * t20 + S(0.9828721869343219) * t35)) - t46;
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

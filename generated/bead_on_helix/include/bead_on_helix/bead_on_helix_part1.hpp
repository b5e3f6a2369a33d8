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

// inverse_dynamics: 94 multiplications, 65 additions, 4 sin/cos/tan (reduced formulation; relative error 3.2e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // spin
  const S t0 = q1 + S(5.71645608965608);
  const S q0 = q[0];  // s
  const S angle[] = {q0, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S t5 = qd1 + S(0.18428853505018536) * qd0;
  const S t4 = cosine[1];
  const S t6 = qd0 * t4;
  const S t3 = sine[1];
  const S t7 = qd0 * t3;
  const S qdd0 = qdd[0];  // dd(s)
  const S t8 = S(0.9828721869343219) * (qd1 * t6 + qdd0 * t3);
  const S t9 = S(0.9828721869343219) * (qd1 * t7 - qdd0 * t4);
  const S t10 = S(0.9660377358490566) * t7;
  const S t11 = S(0.9828721869343219) * t5;
  const S t12 = t5 * t5;
  const S t2 = cosine[0];
  const S t13 = S(0.18428853505018536) * t2;
  const S t1 = sine[0];
  const S t14 = S(0.18428853505018536) * t1;
  const S t15 = t3 * t13 + t1 * t4;
  const S t16 = t1 * t3 - t4 * t13;
  const S t17 = S(0.9828721869343219) * t1;
  const S t18 = t2 * t4 - t3 * t14;
  const S t19 = t4 * t14 + t2 * t3;
  const S t20 = S(0.9828721869343219) * t2;
  const S qdd1 = qdd[1];  // dd(spin)
  const S t21 = qdd1 + S(0.18428853505018536) * qdd0;
  const S t22 = t11 * t6;
  const S t23 = t10 * t6;
  const S t24 = S(0.9660377358490566) * (t6 * t6);
  const S t25 = t10 * t7;
  const S t26 = t11 * t7;
  const S t27 = t23 - t21;
  const S t28 = t23 + t21;
  const S t29 = S(0.15) * qdd0 + S(9.81);
  const S t30 = S(0.9828721869343219) * t3;
  const S t31 = t8 + t22;
  const S t32 = S(1.0507420347208975e-05) * (t26 - t9) - S(1.142777833382582e-05) * (t8 - t22) - S(1.7988235294117646e-05) * (t24 - t25) - S(0.0002180529411764706) * t28 + S(0.0001344470588235294) * t27;
  const S t33 = t26 + t9;
  const S t34 = S(0.003259601202601324) * (S(0.18428853505018536) * t29 + S(0.7862977495474576) * qdd0) + (S(1.142777833382582e-05) * (t25 - t12) - (S(1.0507420347208975e-05) * t27 - S(1.7988235294117646e-05) * t31) + S(0.0002180529411764706) * t33);
  const S t35 = S(0.003259601202601324) * ((S(0.1474308280401483) * qdd0 - S(0.9828721869343219) * t29) * t4 + qd0 * (S(0.8) * t7)) + t32;
  const S t36 = S(0.9828721869343219) * t4;
  const S f2 = in.wrenches[2];  // wrench(bead).fz
  const S f0 = in.wrenches[0];  // wrench(bead).fx
  const S f1 = in.wrenches[1];  // wrench(bead).fy
  const S t37 = S(0.18428853505018536) * f2 - (f0 * t17 - f1 * t20);
  const S t38 = f2 * t30 - (f1 * t15 + f0 * t18);
  const S t39 = f2 * t36 + (f1 * t16 + f0 * t19);
  const S f5 = in.wrenches[5];  // wrench(bead).tz
  const S f4 = in.wrenches[4];  // wrench(bead).ty
  const S f3 = in.wrenches[3];  // wrench(bead).tx
  const S t40 = S(-0.18428853505018536) * f5 - (f4 * t20 - f3 * t17) - S(0.013038404810405297) * t39 - t35;
  tau[1] = t40;
  const S t41 = S(0.004) * t39 - (f5 * t30 - (f3 * t18 + f4 * t15)) - (S(1.0507420347208975e-05) * (t24 - t12) - (S(1.7988235294117646e-05) * t33 + S(1.142777833382582e-05) * t28) - S(0.0001344470588235294) * t31);
  const S t42 = t4 * (t39 - S(0.003259601202601324) * t28) + t3 * (S(0.003259601202601324) * (t24 + t12) + t38);
  const S t43 = t37 - S(0.003259601202601324) * t33;
  const S t44 = S(0.9828721869343219) * (S(0.8) * t43 + (t4 * (f4 * t16 + f3 * t19 + f5 * t36 + (S(0.004) * t38 - S(0.013038404810405297) * t37) + t34) - t3 * t41));
  tau[0] = S(0.16011012830188676) * qdd0 - (t44 - S(0.18428853505018536) * (S(0.8) * t42 + t40)) - S(0.15) * (S(0.18428853505018536) * t43 + S(0.9828721869343219) * t42 - S(0.25) * t29);
}

// mass_matrix: 10 multiplications, 7 additions, 2 sin/cos/tan (reduced formulation; relative error 1.3e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // spin
  const S t0 = q1 + S(5.71645608965608);
  const S t1 = cos(t0);
  const S t2 = sin(t0);
  const S t3 = S(1.142777833382582e-05) * t2 - S(1.0507420347208975e-05) * t1;
  M[0] = S(0.16608762830188678) - (S(0.005215361924162119) * t1 - S(0.9828721869343219) * (S(0.3685770701003707) * t3 - S(0.9828721869343219) * (t2 * (S(3.597647058823529e-05) * t1 + S(8.36058823529412e-05) * t2) + S(0.0001344470588235294))));
  const S t5 = S(0.9828721869343219) * t3 + S(6.496170860519034e-05);
  M[1] = t5;
  M[2] = t5;
  M[3] = S(0.0003525);
}

// bias: 81 multiplications, 55 additions, 4 sin/cos/tan (reduced formulation; relative error 3.5e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // spin
  const S t0 = q1 + S(5.71645608965608);
  const S q0 = q[0];  // s
  const S angle[] = {q0, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S t5 = qd1 + S(0.18428853505018536) * qd0;
  const S t6 = S(0.9828721869343219) * qd1;
  const S t7 = S(0.9828721869343219) * t5;
  const S t8 = t5 * t5;
  const S t2 = cosine[0];
  const S t9 = S(0.18428853505018536) * t2;
  const S t1 = sine[0];
  const S t10 = S(0.18428853505018536) * t1;
  const S t3 = sine[1];
  const S t11 = qd0 * t3;
  const S t4 = cosine[1];
  const S t12 = t3 * t9 + t1 * t4;
  const S t13 = t1 * t3 - t4 * t9;
  const S t14 = S(0.9828721869343219) * t1;
  const S t15 = t2 * t4 - t3 * t10;
  const S t16 = t4 * t10 + t2 * t3;
  const S t17 = S(0.9828721869343219) * t2;
  const S t18 = qd0 * t4;
  const S t19 = t6 * t18;
  const S t20 = t6 * t11;
  const S t21 = S(0.9660377358490566) * t11 * t11;
  const S t22 = t7 * t18;
  const S t23 = t7 * t11;
  const S t24 = t18 * t11;
  const S t25 = S(0.9660377358490566) * (t18 * t18);
  const S t26 = S(8.076643729189792e-05) * t24 + (S(1.142777833382582e-05) * (t19 - t22) - S(1.0507420347208975e-05) * (t23 - t20) + S(1.7988235294117646e-05) * (t25 - t21)) - S(0.003259601202601324) * (qd0 * (S(0.8) * t11) - S(9.641976153825699) * t4);
  const S t27 = t19 + t22;
  const S t28 = t23 + t20;
  const S t29 = S(0.9828721869343219) * t3;
  const S t30 = S(1.142777833382582e-05) * (t21 - t8) + (S(1.7988235294117646e-05) * t27 - S(1.0150564561832065e-05) * t24) + S(0.0002180529411764706) * t28 + S(0.0058929369499619135);
  const S t31 = S(0.9828721869343219) * t4;
  const S f2 = in.wrenches[2];  // wrench(bead).fz
  const S f0 = in.wrenches[0];  // wrench(bead).fx
  const S f1 = in.wrenches[1];  // wrench(bead).fy
  const S t32 = S(0.18428853505018536) * f2 - (f0 * t14 - f1 * t17);
  const S t33 = f2 * t29 - (f1 * t12 + f0 * t15);
  const S t34 = f2 * t31 + (f1 * t13 + f0 * t16);
  const S f5 = in.wrenches[5];  // wrench(bead).tz
  const S f3 = in.wrenches[3];  // wrench(bead).tx
  const S f4 = in.wrenches[4];  // wrench(bead).ty
  const S t35 = S(0.004) * t34 - (f5 * t29 - (f3 * t15 + f4 * t12)) + (S(0.0001344470588235294) * t27 - (S(1.0507420347208975e-05) * (t25 - t8) - (S(1.7988235294117646e-05) * t28 + S(1.1039665107394e-05) * t24)));
  const S t36 = t3 * (S(0.003259601202601324) * (t25 + t8) + t33) - (S(0.0031488977655318453) * t24 - t34) * t4;
  const S t37 = t26 - (S(0.013038404810405297) * t34 + (f4 * t17 - f3 * t14 + S(0.18428853505018536) * f5));
  c[1] = t37;
  const S t38 = S(0.003259601202601324) * t28 - t32;
  const S t39 = S(0.9828721869343219) * (S(0.8) * t38 - (t4 * (f4 * t13 + f3 * t16 + f5 * t31 + (S(0.004) * t33 - S(0.013038404810405297) * t32) + t30) - t3 * t35));
  c[0] = t39 + S(0.18428853505018536) * (t37 + S(0.8) * t36) + S(0.15) * (S(0.18428853505018536) * t38 - S(0.9828721869343219) * t36 + S(2.4525));
}

// mass_matrix_and_bias: 91 multiplications, 62 additions, 4 sin/cos/tan (reduced formulation; relative error 3.5e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // spin
  const S t0 = q1 + S(5.71645608965608);
  const S q0 = q[0];  // s
  const S angle[] = {q0, t0};
  S sine[2], cosine[2];
  sines_and_cosines(2, angle, sine, cosine);
  const S qd0 = qd[0];  // d(s)
  const S qd1 = qd[1];  // d(spin)
  const S t5 = qd1 + S(0.18428853505018536) * qd0;
  const S t6 = S(0.9828721869343219) * qd1;
  const S t7 = S(0.9828721869343219) * t5;
  const S t8 = t5 * t5;
  const S t2 = cosine[0];
  const S t9 = S(0.18428853505018536) * t2;
  const S t1 = sine[0];
  const S t10 = S(0.18428853505018536) * t1;
  const S t4 = sine[1];
  const S t11 = qd0 * t4;
  const S t3 = cosine[1];
  const S t12 = t4 * t9 + t1 * t3;
  const S t13 = t1 * t4 - t3 * t9;
  const S t14 = S(0.9828721869343219) * t1;
  const S t15 = t2 * t3 - t4 * t10;
  const S t16 = t3 * t10 + t2 * t4;
  const S t17 = S(0.9828721869343219) * t2;
  const S t18 = qd0 * t3;
  const S t19 = t6 * t18;
  const S t20 = t6 * t11;
  const S t21 = S(0.9660377358490566) * t11 * t11;
  const S t22 = t7 * t18;
  const S t23 = t7 * t11;
  const S t24 = t18 * t11;
  const S t25 = S(0.9660377358490566) * (t18 * t18);
  const S t26 = S(8.076643729189792e-05) * t24 + (S(1.142777833382582e-05) * (t19 - t22) - S(1.0507420347208975e-05) * (t23 - t20) + S(1.7988235294117646e-05) * (t25 - t21)) - S(0.003259601202601324) * (qd0 * (S(0.8) * t11) - S(9.641976153825699) * t3);
  const S t27 = t19 + t22;
  const S t28 = t23 + t20;
  const S t29 = S(0.9828721869343219) * t4;
  const S t30 = S(1.142777833382582e-05) * (t21 - t8) + (S(1.7988235294117646e-05) * t27 - S(1.0150564561832065e-05) * t24) + S(0.0002180529411764706) * t28 + S(0.0058929369499619135);
  const S t31 = S(0.9828721869343219) * t3;
  const S f2 = in.wrenches[2];  // wrench(bead).fz
  const S f0 = in.wrenches[0];  // wrench(bead).fx
  const S f1 = in.wrenches[1];  // wrench(bead).fy
  const S t32 = S(0.18428853505018536) * f2 - (f0 * t14 - f1 * t17);
  const S t33 = f2 * t29 - (f1 * t12 + f0 * t15);
  const S t34 = f2 * t31 + (f1 * t13 + f0 * t16);
  const S f5 = in.wrenches[5];  // wrench(bead).tz
  const S f3 = in.wrenches[3];  // wrench(bead).tx
  const S f4 = in.wrenches[4];  // wrench(bead).ty
  const S t35 = S(0.004) * t34 - (f5 * t29 - (f3 * t15 + f4 * t12)) + (S(0.0001344470588235294) * t27 - (S(1.0507420347208975e-05) * (t25 - t8) - (S(1.7988235294117646e-05) * t28 + S(1.1039665107394e-05) * t24)));
  const S t36 = t4 * (S(0.003259601202601324) * (t25 + t8) + t33) - (S(0.0031488977655318453) * t24 - t34) * t3;
  const S t37 = t26 - (S(0.013038404810405297) * t34 + (f4 * t17 - f3 * t14 + S(0.18428853505018536) * f5));
  c[1] = t37;
  const S t38 = S(0.003259601202601324) * t28 - t32;
  const S t39 = S(0.9828721869343219) * (S(0.8) * t38 - (t3 * (f4 * t13 + f3 * t16 + f5 * t31 + (S(0.004) * t33 - S(0.013038404810405297) * t32) + t30) - t4 * t35));
  c[0] = t39 + S(0.18428853505018536) * (t37 + S(0.8) * t36) + S(0.15) * (S(0.18428853505018536) * t38 - S(0.9828721869343219) * t36 + S(2.4525));
  const S t41 = S(1.142777833382582e-05) * t4 - S(1.0507420347208975e-05) * t3;
  M[0] = S(0.16608762830188678) - (S(0.005215361924162119) * t3 - S(0.9828721869343219) * (S(0.3685770701003707) * t41 - S(0.9828721869343219) * (t4 * (S(3.597647058823529e-05) * t3 + S(8.36058823529412e-05) * t4) + S(0.0001344470588235294))));
  const S t43 = S(0.9828721869343219) * t41 + S(6.496170860519034e-05);
  M[1] = t43;
  M[2] = t43;
  M[3] = S(0.0003525);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(s)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(spin)
  qdot[1] = qd1;
}

// energy: 26 multiplications, 15 additions, 2 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // spin
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S qd0 = qd[0];  // d(s)
  const S t2 = qd0 * t0;
  const S qd1 = qd[1];  // d(spin)
  const S t3 = qd1 + S(0.18428853505018536) * qd0;
  const S t4 = qd0 * t1;
  const S q0 = q[0];  // s
  e[1] = S(2.4525) * (S(0.15) * q0 + (S(0.01081159405627754) * t0 + S(0.0007371541402007414) - S(0.006880105308540253) * t1));
  const S t6 = t3 * (S(1.474308280401483e-05) * t4 - (S(0.0003525) * t3 + S(3.9314887477372875e-06) * t2));
  const S t7 = S(0.5) * (S(0.9828721869343219) * ((S(0.00025186099790191997) * t2 + S(4e-06) * t3 + S(2.9731883654763237e-05) * t4) * t2 - (S(1.5e-05) * t3 - S(2.9731883654763237e-05) * t2 - S(0.00031869630661345385) * t4) * t4) - t6);
  e[0] = t7 + qd0 * (S(0.0828125) * qd0 - S(0.8139410298049853) * (S(0.002702898514069385) * t4 + S(0.0017200263271350633) * t2));
}

// body_poses: 15 multiplications, 4 additions, 4 sin/cos/tan (reduced formulation; relative error 1.2e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  const S q0 = q[0];  // s
  W[11] = S(0.15) * q0;
  const S t0 = sine[0];
  const S t3 = sine[1];
  const S t5 = t0 * t3;
  const S t2 = cosine[1];
  const S t6 = t0 * t2;
  const S t1 = cosine[0];
  const S t7 = t1 * t2;
  const S t8 = t1 * t3;
  W[9] = S(0.9828721869343219) * t3;
  W[10] = S(0.9828721869343219) * t2;
  W[2] = S(0.18428853505018536) * t6 + t8;
  W[5] = S(-0.18428853505018536) * t8 - t6;
  W[1] = S(0.18428853505018536) * t5 - t7;
  W[6] = t5 - S(0.18428853505018536) * t7;
  W[3] = S(0.8) * t1;
  W[4] = S(0.9828721869343219) * t1;
  W[0] = S(-0.9828721869343219) * t0;
  W[7] = S(0.8) * t0;
  W[8] = S(0.18428853505018536);
}

}  // namespace alembert::mechanisms::bead_on_helix

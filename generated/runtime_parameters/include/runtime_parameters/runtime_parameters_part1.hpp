// runtime_parameters: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "runtime_parameters". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "runtime_parameters_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::runtime_parameters {

// inverse_dynamics: 35 multiplications, 18 additions, 2 sin/cos/tan (reduced formulation; relative error 4.9e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S qd0 = qd[0];  // d(q1)
  const S t2 = qd0 * t1;
  const S t3 = qd0 * t0;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t4 = qdd0 * t0;
  const S t5 = qdd0 * t1;
  const S t6 = t2 * t3;
  const S qd1 = qd[1];  // d(q2)
  const S t7 = qd1 * t2;
  const S p2 = in.parameters[2];  // l
  const S p1 = in.parameters[1];  // m
  const S t8 = p2 * p1;
  const S p3 = in.parameters[3];  // I
  const S t9 = p3 + p2 * t8;
  const S t10 = S(0.025) * p3;
  const S p0 = in.parameters[0];  // g
  const S t11 = S(0.3) * t5 + p0 * t0;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t12 = t0 * (t8 * (qd1 * qd1 + t3 * t3) - p1 * (S(0.3) * t4 - p0 * t1)) - t1 * ((qdd1 - t6) * t8 + p1 * t11);
  const S t13 = t9 - t10;
  const S t14 = S(0.3) * t12 + (t1 * ((qd1 * t3 - t5) * t10) - (S(0.3) * (t8 * (qd0 * qd0)) + ((t7 + t4) * t9 + t7 * t13)) * t0);
  tau[1] = t11 * t8 - (t13 * t6 - qdd1 * t9);
  tau[0] = S(0.01376) * qdd0 - t14;
}

// mass_matrix: 10 multiplications, 4 additions, 2 sin/cos/tan (reduced formulation; relative error 2.2e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S p2 = in.parameters[2];  // l
  const S p1 = in.parameters[1];  // m
  const S t2 = p2 * p1;
  const S p3 = in.parameters[3];  // I
  const S t3 = p3 + p2 * t2;
  M[3] = t3;
  M[0] = S(0.025) * (p3 * (t0 * t0)) + t1 * t1 * t3 + S(0.09) * p1 + S(0.01376);
  const S t5 = S(0.3) * (t0 * t2);
  M[1] = t5;
  M[2] = t5;
}

// bias: 28 multiplications, 11 additions, 2 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S p2 = in.parameters[2];  // l
  const S p1 = in.parameters[1];  // m
  const S t0 = p2 * p1;
  const S p3 = in.parameters[3];  // I
  const S t1 = p3 + p2 * t0;
  const S t2 = S(0.025) * p3;
  const S q1 = q[1];  // q2
  const S t3 = sin(q1);
  const S t4 = cos(q1);
  const S qd0 = qd[0];  // d(q1)
  const S t5 = qd0 * t3;
  const S t6 = qd0 * t4;
  const S t7 = t1 - t2;
  const S t8 = t6 * t5;
  const S p0 = in.parameters[0];  // g
  const S t9 = p0 * t3;
  const S qd1 = qd[1];  // d(q2)
  const S t10 = S(0.3) * (t4 * (t8 * t0 - p1 * t9) + (t0 * (qd1 * qd1 + t5 * t5) + t4 * (p0 * p1)) * t3);
  c[0] = (S(0.3) * (qd0 * (qd0 * t0)) + t6 * (qd1 * (t7 + t1))) * t3 - t4 * (qd1 * t2 * t5) - t10;
  c[1] = t0 * t9 - t7 * t8;
}

// mass_matrix_and_bias: 33 multiplications, 14 additions, 2 sin/cos/tan (reduced formulation; relative error 3.4e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S p2 = in.parameters[2];  // l
  const S p1 = in.parameters[1];  // m
  const S t0 = p2 * p1;
  const S p3 = in.parameters[3];  // I
  const S t1 = p3 + p2 * t0;
  M[3] = t1;
  const S t2 = S(0.025) * p3;
  const S q1 = q[1];  // q2
  const S t3 = sin(q1);
  const S t4 = cos(q1);
  const S qd0 = qd[0];  // d(q1)
  const S t5 = qd0 * t3;
  const S t6 = qd0 * t4;
  const S t7 = t1 - t2;
  const S t8 = t6 * t5;
  const S t9 = t4 * t2;
  const S p0 = in.parameters[0];  // g
  const S t10 = p0 * t3;
  const S t11 = S(0.3) * t0;
  const S qd1 = qd[1];  // d(q2)
  const S t12 = qd1 * t5 * t9 - t3 * (t11 * (qd0 * qd0) + t6 * (qd1 * (t7 + t1)));
  c[0] = S(-0.3) * (t4 * (t8 * t0 - p1 * t10) + (t0 * (qd1 * qd1 + t5 * t5) + p1 * (p0 * t4)) * t3) - t12;
  M[0] = t1 * t3 * t3 + t4 * t9 + S(0.09) * p1 + S(0.01376);
  c[1] = t0 * t10 - t7 * t8;
  const S t16 = t4 * t11;
  M[1] = t16;
  M[2] = t16;
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q2)
  qdot[1] = qd1;
}

// energy: 20 multiplications, 6 additions, 2 sin/cos/tan (reduced formulation; relative error 1.5e-15 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S qd0 = qd[0];  // d(q1)
  const S t2 = qd0 * t1;
  const S t3 = qd0 * t0;
  const S t4 = qd0 * qd0;
  const S p2 = in.parameters[2];  // l
  const S p1 = in.parameters[1];  // m
  const S t5 = p2 * p1;
  const S p3 = in.parameters[3];  // I
  const S qd1 = qd[1];  // d(q2)
  const S t6 = S(0.5) * (S(0.025) * (p3 * t3 * t3) + (p3 + p2 * t5) * (qd1 * qd1 + t2 * t2));
  e[0] = p1 * (S(0.045) * t4 + S(0.3) * (t3 * (p2 * qd1))) + S(0.00688) * t4 + t6;
  const S p0 = in.parameters[0];  // g
  e[1] = -(t0 * (p0 * t5));
}

// body_poses: 6 multiplications, 0 additions, 4 sin/cos/tan (reduced formulation; relative error 1e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[2], cosine[2];
  sines_and_cosines(2, q, sine, cosine);
  W[0] = cosine[0];
  W[5] = cosine[0];
  W[12] = cosine[0];
  W[4] = sine[0];
  W[16] = sine[0];
  W[22] = cosine[1];
  W[21] = sine[1];
  const S t2 = cosine[1];
  const S t1 = sine[0];
  W[13] = -(t2 * t1);
  const S t0 = cosine[0];
  W[17] = t2 * t0;
  const S t3 = sine[1];
  W[18] = -(t0 * t3);
  W[14] = t1 * t3;
  W[15] = S(0.3) * t0;
  W[1] = -t1;
  W[19] = S(0.3) * t1;
  W[2] = S(0.0);
  W[3] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[20] = S(0.0);
  W[23] = S(0.0);
  W[10] = S(1.0);
}

}  // namespace alembert::mechanisms::runtime_parameters

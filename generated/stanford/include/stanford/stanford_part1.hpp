// stanford: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "stanford". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "stanford_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::stanford {

// inverse_dynamics: 135 multiplications, 104 additions, 8 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S angle[] = {q1, q3, q4, q5};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t1 = cosine[0];
  const S t8 = qd0 * t1;
  const S qd1 = qd[1];  // d(q2)
  const S t9 = qd1 * t8;
  const S t0 = sine[0];
  const S t10 = qd0 * t0;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t11 = qdd0 * t0;
  const S t12 = t9 + t11;
  const S t13 = qdd0 * t1;
  const S t14 = qd1 * t10;
  const S t15 = t9 + t12;
  const S t3 = cosine[1];
  const S t2 = sine[1];
  const S t16 = qd1 * t3 + t2 * t10;
  const S t17 = t3 * t10 - qd1 * t2;
  const S t18 = t14 - t13;
  const S qdd1 = qdd[1];  // dd(q2)
  const S qd3 = qd[3];  // d(q4)
  const S t19 = qdd1 * t3 + t2 * t12 + qd3 * t17;
  const S t20 = qdd1 * t2 - t12 * t3 + qd3 * t16;
  const S t21 = qd3 + t8;
  const S t22 = t8 * t10;
  const S t23 = qdd1 - t22;
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t24 = t4 * t16 - t21 * t5;
  const S t25 = t16 * t5 + t4 * t21;
  const S qd5 = qd[5];  // d(q6)
  const S t26 = qd5 + (qd5 - t24);
  const S qdd3 = qdd[3];  // dd(q4)
  const S t27 = qdd3 - t18;
  const S qd4 = qd[4];  // d(q5)
  const S t28 = qd4 - t17;
  const S t29 = qd4 * t24 - (t19 * t5 + t4 * t27);
  const S t30 = t4 * t19 - t27 * t5 + qd4 * t25;
  const S t31 = qd1 * qd1;
  const S t32 = t31 + t10 * t10;
  const S qd2 = qd[2];  // d(q3)
  const S t33 = qd2 + qd2;
  const S q2 = q[2];  // q3
  const S t34 = q2 * t15 - qd0 * (S(0.154) * qd0) + t33 * t10;
  const S t35 = S(9.81) * t0 + S(0.154) * t13 - q2 * t23 - qd1 * t33;
  const S qdd4 = qdd[4];  // dd(q5)
  const S t36 = qdd4 + t20;
  const S qdd2 = qdd[2];  // dd(q3)
  const S t37 = qdd2 - (S(0.154) * t11 - S(9.81) * t1 + q2 * t32);
  const S t38 = t3 * t34 + t2 * t35;
  const S t7 = sine[3];
  const S t6 = cosine[3];
  const S t39 = t29 * t7 - (t36 * t6 + (t25 * t6 - t28 * t7) * t26);
  const S t40 = (t25 * t7 + t6 * t28) * t26 + t36 * t7 + t29 * t6;
  const S t41 = t29 + t24 * t28;
  const S t42 = t25 * t24;
  const S t43 = S(0.00015) * (t40 * t6 + t39 * t7) + (S(0.0278945) * t41 - S(0.0696) * (t2 * t34 - t35 * t3));
  const S t44 = S(0.0273445) * t42 - S(0.0696) * (t38 * t5 + t4 * t37) + S(0.0284445) * t36 - S(0.00015) * (t6 * t39 - t40 * t7);
  tau[4] = t44;
  const S t45 = t36 + t42;
  const S t46 = t25 * t25 + t28 * t28;
  const S t47 = t21 * t21;
  const S t48 = S(0.0696) * t41 + S(0.00972) * (t16 * t16 + t47);
  const S t49 = t16 * t21;
  const S t50 = t19 + t17 * t21;
  const S t51 = t16 * t17;
  const S qdd5 = qdd[5];  // dd(q6)
  const S t52 = S(0.0003) * (qdd5 - t30);
  tau[5] = t52;
  const S t53 = S(0.00055) * (t25 * t28 + t30) - t52;
  const S t54 = S(0.00972) * t37 - (S(0.00103748) * t50 - S(0.00052488) * (t17 * t17 - t47)) - (t4 * t53 - t43 * t5);
  const S t55 = S(1.71582) * t32 + S(6.47) * t37 - S(0.00972) * t50 - S(0.0696) * (t46 * t5 + t4 * t45);
  tau[2] = t55;
  const S t56 = t27 - t51;
  const S t57 = S(0.00972) * t56 - S(0.0696) * (t45 * t5 - t4 * t46);
  const S t58 = S(0.00972) * t38 - (S(0.00063748) * t51 - (S(0.00143748) * t27 + S(0.00052488) * (t20 - t49))) - (t53 * t5 + t4 * t43);
  tau[3] = t58;
  const S t59 = S(0.00052488) * t56 + S(0.0004) * (t20 + t49) + t44;
  const S t60 = q2 * (t2 * t48 - t57 * t3 + (S(1.71582) * t15 - S(6.47) * t34)) + (t59 * t3 + t2 * t54 + S(1.71582) * t34) - S(-0.154) * t55;
  const S t61 = S(6.47) * t35 + S(1.71582) * t23 + (t2 * t57 + t3 * t48);
  tau[1] = S(1.03005) * t0 + (S(0.012495) * t13 + S(1.26317928) * qdd1 - S(1.24717928) * t22) - (q2 * t61 + (t3 * t54 - t2 * t59 - S(1.71582) * t35));
  const S t63 = t0 * (S(1.25517928) * t15 - S(0.012495) * (t31 - t8 * t8) - t60) + t1 * (S(0.154) * t61 + t58 + (S(0.012495) * t23 - S(0.008) * (t18 + t14)));
  tau[0] = t63 + S(0.1608182) * qdd0;
}

// mass_matrix: 50 multiplications, 37 additions, 6 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S angle[] = {q1, q3, q4};
  S sine[3], cosine[3];
  sines_and_cosines(3, angle, sine, cosine);
  const S t5 = cosine[2];
  const S t6 = S(0.0696) * t5;
  const S t7 = S(1.71582) - t6;
  const S q2 = q[2];  // q3
  const S t8 = q2 * (S(3.235) * q2 - t7);
  const S t4 = sine[2];
  const S t9 = S(0.0271945) * t4;
  const S t10 = t4 * t9;
  const S t11 = t9 * t5;
  const S t12 = S(1.28307378) - (t10 - (t8 + t8));
  const S t2 = sine[1];
  const S t13 = t2 * t4;
  const S t14 = t2 * (S(8.748e-05) - t10);
  const S t3 = cosine[1];
  const S t15 = S(-0.0696) * t13 - S(0.00972) * t3;
  M[8] = t15;
  M[13] = t15;
  const S t16 = t2 * t11 - S(0.00052488) * t3 - q2 * t15;
  const S t17 = t4 * t3;
  const S t18 = S(0.00972) * t2 - S(0.0696) * t17;
  const S t19 = t3 * t11 + S(0.00052488) * t2 - q2 * t18;
  M[9] = t19;
  M[19] = t19;
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t20 = t0 * (t14 * t3 + S(-0.154) * t15) + t1 * (S(0.012495) - (S(-0.154) * (t7 - S(6.47) * q2) - t19));
  M[1] = t20;
  M[6] = t20;
  const S t21 = t2 * t14;
  const S t22 = S(0.00918748) - t21;
  const S t23 = t1 * t16;
  M[0] = S(0.1619182) - (((t22 - t12) * t0 - (t23 + t23)) * t0 - (t10 + t21 + S(0.308) * (t18 + S(0.49819)) + t22));
  const S t25 = t10 + S(0.00228748);
  M[21] = t25;
  const S t26 = t1 * (S(0.154) * t18 + t25) + t0 * t16;
  M[3] = t26;
  M[18] = t26;
  M[7] = t22 + t12;
  const S t28 = S(-0.0003) * (t0 * t13 - t1 * t5);
  M[5] = t28;
  M[30] = t28;
  const S t29 = t2 * t5;
  const S t30 = (S(0.0107184) * t4 - (q2 * t6 + S(0.0285945)) * t3) * t0 - t1 * (S(0.0107184) * t29);
  M[4] = t30;
  M[24] = t30;
  const S t31 = S(0.0696) * (q2 * t29) + S(0.0285945) * t2;
  M[10] = t31;
  M[25] = t31;
  const S t32 = t0 * (S(-0.99638) - t18);
  M[2] = t32;
  M[12] = t32;
  const S t33 = S(-0.0696) * t4;
  M[16] = t33;
  M[26] = t33;
  const S t34 = S(0.0003) * t5;
  M[23] = t34;
  M[33] = t34;
  const S t35 = S(-0.0003) * t17;
  M[11] = t35;
  M[31] = t35;
  M[14] = S(6.47);
  M[28] = S(0.0285945);
  M[35] = S(0.0003);
  M[15] = S(0.0);
  M[17] = S(0.0);
  M[20] = S(0.0);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[32] = S(0.0);
  M[34] = S(0.0);
}

// bias: 126 multiplications, 89 additions, 8 sin/cos/tan (reduced formulation; relative error 2.2e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S angle[] = {q1, q3, q4, q5};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t0 = sine[0];
  const S t8 = qd0 * t0;
  const S t1 = cosine[0];
  const S t9 = qd0 * t1;
  const S qd1 = qd[1];  // d(q2)
  const S t10 = qd1 * t9;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t11 = t2 * t8 - qd1 * t3;
  const S t12 = qd1 * t2 + t3 * t8;
  const S qd3 = qd[3];  // d(q4)
  const S t13 = qd3 * t11 + t3 * t10;
  const S t14 = qd3 + t9;
  const S t15 = qd1 * t8;
  const S t16 = t10 * t2 - qd3 * t12;
  const S t17 = t9 * t8;
  const S t5 = sine[2];
  const S t4 = cosine[2];
  const S t18 = t5 * t12 - t14 * t4;
  const S t19 = t12 * t4 + t5 * t14;
  const S qd4 = qd[4];  // d(q5)
  const S t20 = qd4 * t18 + (t5 * t15 - t13 * t4);
  const S t21 = qd4 - t11;
  const S qd5 = qd[5];  // d(q6)
  const S t22 = qd5 + (qd5 - t18);
  const S t23 = t5 * t13 + t15 * t4 + qd4 * t19;
  const S qd2 = qd[2];  // d(q3)
  const S t24 = qd2 * qd1;
  const S t25 = qd1 * qd1;
  const S q2 = q[2];  // q3
  const S t26 = qd2 * t8 + q2 * t10;
  const S t27 = t26 + t26 - S(0.154) * (qd0 * qd0);
  const S t28 = t25 + t8 * t8;
  const S t29 = t24 + t24 - (q2 * t17 + S(9.81) * t0);
  const S t30 = q2 * t28 - S(9.81) * t1;
  const S t31 = t3 * t29 - t2 * t27;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t32 = (t19 * t6 + t7 * t21) * t22 + t7 * t20 - t16 * t6;
  const S t33 = t7 * t16 + t6 * t20 - (t19 * t7 - t21 * t6) * t22;
  const S t34 = t18 * t21 + t20;
  const S t35 = t19 * t18;
  const S t36 = S(0.00015) * (t33 * t6 + t7 * t32) + (S(0.0278945) * t34 - S(0.0696) * (t2 * t29 + t3 * t27));
  const S t37 = S(0.0273445) * t35 - (S(0.0284445) * t16 - (S(0.00015) * (t6 * t32 - t33 * t7) + S(0.0696) * (t5 * t30 + t31 * t4)));
  c[4] = t37;
  const S t38 = t35 - t16;
  const S t39 = t19 * t19 + t21 * t21;
  const S t40 = t14 * t14;
  const S t41 = S(0.0696) * t34 + S(0.00972) * (t12 * t12 + t40);
  const S t42 = t12 * t14;
  const S t43 = t11 * t14 + t13;
  const S t44 = t12 * t11;
  const S t45 = S(-0.0003) * t23;
  c[5] = t45;
  const S t46 = S(0.00055) * (t23 + t19 * t21) - t45;
  const S t47 = t36 * t4 - t5 * t46 - (S(0.00972) * t30 + (S(0.00103748) * t43 - S(0.00052488) * (t11 * t11 - t40)));
  const S t48 = S(-0.00063748) * t44 - (S(0.00143748) * t15 + S(0.00052488) * (t16 + t42)) - S(0.00972) * t31 - (t46 * t4 + t5 * t36);
  c[3] = t48;
  const S t49 = t15 + t44;
  const S t50 = S(0.0004) * (t16 - t42) + S(0.00052488) * t49 - t37;
  const S t51 = S(0.0696) * (t5 * t39 - t38 * t4) - S(0.00972) * t49;
  const S t52 = S(1.71582) * t28 - S(6.47) * t30 - S(0.00972) * t43 - S(0.0696) * (t39 * t4 + t5 * t38);
  c[2] = t52;
  const S t53 = S(0.154) * t52 + (q2 * (t3 * t41 - t2 * t51 + (S(3.43164) * t10 - S(6.47) * t27)) + (S(1.71582) * t27 - (t2 * t50 - t47 * t3)));
  const S t54 = t41 * t2 + t3 * t51 - (S(1.71582) * t17 + S(6.47) * t29);
  c[1] = S(1.03005) * t0 - S(1.24717928) * t17 - (q2 * t54 + (S(1.71582) * t29 + (t3 * t50 + t47 * t2)));
  c[0] = t1 * (S(0.154) * t54 + t48 - (S(0.012495) * t17 + S(0.016) * t15)) - (t53 - (S(2.51035856) * t10 - S(0.012495) * (t25 - t9 * t9))) * t0;
}

// mass_matrix_and_bias: 176 multiplications, 125 additions, 8 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S angle[] = {q1, q3, q4, q5};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t1 = sine[0];
  const S t8 = qd0 * t1;
  const S t0 = cosine[0];
  const S t9 = qd0 * t0;
  const S qd1 = qd[1];  // d(q2)
  const S t10 = qd1 * t9;
  const S t3 = cosine[1];
  const S t2 = sine[1];
  const S t11 = t3 * t8 - qd1 * t2;
  const S t12 = qd1 * t3 + t2 * t8;
  const S qd3 = qd[3];  // d(q4)
  const S t13 = qd3 * t11 + t2 * t10;
  const S t14 = qd3 + t9;
  const S t15 = qd1 * t8;
  const S t16 = t10 * t3 - qd3 * t12;
  const S t17 = t9 * t8;
  const S t5 = cosine[2];
  const S t4 = sine[2];
  const S t18 = t12 * t5 + t4 * t14;
  const S t19 = t4 * t12 - t14 * t5;
  const S qd4 = qd[4];  // d(q5)
  const S t20 = qd4 * t19 + (t4 * t15 - t13 * t5);
  const S t21 = qd4 - t11;
  const S q2 = q[2];  // q3
  const S t22 = q2 + q2;
  const S qd5 = qd[5];  // d(q6)
  const S t23 = qd5 + (qd5 - t19);
  const S t24 = t4 * t13 + t15 * t5 + qd4 * t18;
  const S qd2 = qd[2];  // d(q3)
  const S t25 = qd2 + qd2;
  const S t26 = S(0.154) * (qd0 * qd0) - t10 * t22 - t25 * t8;
  const S t27 = q2 * t17 + S(9.81) * t1 - qd1 * t25;
  const S t28 = qd1 * qd1;
  const S t29 = t28 + t8 * t8;
  const S t30 = q2 * t29 - S(9.81) * t0;
  const S t31 = t2 * t27 - t26 * t3;
  const S t7 = sine[3];
  const S t6 = cosine[3];
  const S t32 = (t18 * t7 + t6 * t21) * t23 + t6 * t20 - t16 * t7;
  const S t33 = t6 * t16 + t7 * t20 - (t18 * t6 - t21 * t7) * t23;
  const S t34 = t19 * t21 + t20;
  const S t35 = t18 * t19;
  const S t36 = S(0.0278945) * t34 + S(0.0696) * (t27 * t3 + t2 * t26) + S(0.00015) * (t33 * t7 + t6 * t32);
  const S t37 = S(0.00015) * (t7 * t32 - t33 * t6) + S(0.0696) * (t4 * t30 - t31 * t5) - S(0.0284445) * t16 + S(0.0273445) * t35;
  c[4] = t37;
  const S t38 = t35 - t16;
  const S t39 = t18 * t18 + t21 * t21;
  const S t40 = t14 * t14;
  const S t41 = S(0.0696) * t34 + S(0.00972) * (t12 * t12 + t40);
  const S t42 = t12 * t14;
  const S t43 = t11 * t14 + t13;
  const S t44 = t12 * t11;
  const S t45 = S(0.0271945) * t4;
  const S t46 = S(0.0696) * t5;
  const S t47 = S(-0.0003) * t24;
  c[5] = t47;
  const S t48 = S(0.00055) * (t24 + t18 * t21) - t47;
  const S t49 = S(0.00972) * t30 + (S(0.00103748) * t43 - S(0.00052488) * (t11 * t11 - t40)) - (t36 * t5 - t4 * t48);
  const S t50 = t15 + t44;
  const S t51 = S(0.00972) * t31 - (S(0.00143748) * t15 + S(0.00052488) * (t16 + t42) + S(0.00063748) * t44) - (t48 * t5 + t4 * t36);
  c[3] = t51;
  const S t52 = t37 - (S(0.0004) * (t16 - t42) + S(0.00052488) * t50);
  const S t53 = S(0.0696) * (t4 * t39 - t38 * t5) - S(0.00972) * t50;
  const S t54 = S(1.71582) * t29 - S(6.47) * t30 - S(0.00972) * t43 - S(0.0696) * (t39 * t5 + t4 * t38);
  c[2] = t54;
  const S t55 = t4 * t45;
  const S t56 = t45 * t5;
  const S t57 = S(1.71582) - t46;
  const S t58 = t2 * t4;
  const S t59 = t2 * (S(8.748e-05) - t55);
  const S t60 = (S(3.235) * q2 - t57) * t22 - t55 + S(1.28307378);
  const S t61 = S(-0.0696) * t58 - S(0.00972) * t3;
  M[8] = t61;
  M[13] = t61;
  const S t62 = t4 * t3;
  const S t63 = t2 * t56 - S(0.00052488) * t3 - q2 * t61;
  const S t64 = t2 * t59;
  const S t65 = S(0.00972) * t2 - S(0.0696) * t62;
  const S t66 = t3 * t56 + S(0.00052488) * t2 - q2 * t65;
  M[9] = t66;
  M[19] = t66;
  const S t67 = t1 * (t59 * t3 + S(-0.154) * t61) + t0 * (S(0.012495) - (S(-0.154) * (t57 - S(6.47) * q2) - t66));
  M[1] = t67;
  M[6] = t67;
  const S t68 = S(0.00918748) - t64;
  const S t69 = t0 * t63;
  M[0] = t55 + t64 + S(0.308) * (t65 + S(0.49819)) + t68 + (t69 + t69 - t1 * (t68 - t60)) * t1 + S(0.1619182);
  const S t71 = t55 + S(0.00228748);
  M[21] = t71;
  const S t72 = t0 * (S(0.154) * t65 + t71) + t1 * t63;
  M[3] = t72;
  M[18] = t72;
  const S t73 = t41 * t3 + t2 * t53 + (S(6.47) * t27 - S(1.71582) * t17);
  const S t74 = S(0.154) * t54 - (S(1.71582) * t26 - (t52 * t3 - t2 * t49) - q2 * (t2 * t41 - t3 * t53 + (S(3.43164) * t10 + S(6.47) * t26)));
  c[1] = S(1.03005) * t1 - S(1.24717928) * t17 + (S(1.71582) * t27 + (t49 * t3 + t2 * t52) - q2 * t73);
  c[0] = t0 * (t51 + S(0.154) * t73 - (S(0.012495) * t17 + S(0.016) * t15)) - (t74 - (S(2.51035856) * t10 - S(0.012495) * (t28 - t9 * t9))) * t1;
  M[7] = t68 + t60;
  const S t78 = t1 * (S(-0.99638) - t65);
  M[2] = t78;
  M[12] = t78;
  const S t79 = t2 * t5;
  const S t80 = (S(0.0107184) * t4 - (q2 * t46 + S(0.0285945)) * t3) * t1 - t0 * (S(0.0107184) * t79);
  M[4] = t80;
  M[24] = t80;
  const S t81 = S(0.0696) * (q2 * t79) + S(0.0285945) * t2;
  M[10] = t81;
  M[25] = t81;
  const S t82 = S(-0.0003) * (t1 * t58 - t0 * t5);
  M[5] = t82;
  M[30] = t82;
  const S t83 = S(0.0003) * t5;
  M[23] = t83;
  M[33] = t83;
  const S t84 = S(-0.0696) * t4;
  M[16] = t84;
  M[26] = t84;
  const S t85 = S(-0.0003) * t62;
  M[11] = t85;
  M[31] = t85;
  M[14] = S(6.47);
  M[28] = S(0.0285945);
  M[35] = S(0.0003);
  M[15] = S(0.0);
  M[17] = S(0.0);
  M[20] = S(0.0);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[32] = S(0.0);
  M[34] = S(0.0);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(q1)
  qdot[0] = qd0;
  const S qd1 = qd[1];  // d(q2)
  qdot[1] = qd1;
  const S qd2 = qd[2];  // d(q3)
  qdot[2] = qd2;
  const S qd3 = qd[3];  // d(q4)
  qdot[3] = qd3;
  const S qd4 = qd[4];  // d(q5)
  qdot[4] = qd4;
  const S qd5 = qd[5];  // d(q6)
  qdot[5] = qd5;
}

// energy: 88 multiplications, 56 additions, 8 sin/cos/tan (reduced formulation; relative error 2.6e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  const S q1 = q[1];  // q2
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S angle[] = {q1, q3, q4, q5};
  S sine[4], cosine[4];
  sines_and_cosines(4, angle, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t0 = sine[0];
  const S t8 = qd0 * t0;
  const S t1 = cosine[0];
  const S t9 = qd0 * t1;
  const S qd3 = qd[3];  // d(q4)
  const S t10 = qd3 + t9;
  const S t2 = cosine[1];
  const S qd1 = qd[1];  // d(q2)
  const S t3 = sine[1];
  const S t11 = t2 * t8 - qd1 * t3;
  const S t12 = qd1 * t2 + t3 * t8;
  const S t13 = t9 * (S(0.012495) * qd1 + S(0.094805) * t9);
  const S t14 = t8 * t8;
  const S t15 = S(1.156425) * (qd1 * qd1 + t14);
  const S t16 = S(0.00523676) * (t12 * t12) - (S(0.00052488) * t10 - S(0.00494928) * t11) * t11 - (S(0.00052488) * t11 - S(0.00108748) * t10) * t10 + t13 + t15;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t17 = t12 * t4 + t5 * t10;
  const S t18 = t5 * t12 - t10 * t4;
  const S qd4 = qd[4];  // d(q5)
  const S t19 = qd4 - t11;
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t20 = t17 * t6 - t19 * t7;
  const S t21 = t17 * t7 + t6 * t19;
  const S qd5 = qd[5];  // d(q6)
  const S t22 = qd5 - t18;
  const S t23 = S(0.02525275) * (t20 * t20 + t21 * t21) + (qd1 * (S(0.012495) * t9 + S(0.102205) * qd1) + t16 + S(0.18101) * t14 + S(0.0003) * (t22 * t22));
  const S q2 = q[2];  // q3
  const S t24 = S(0.154) * t9 - q2 * qd1;
  const S t25 = q2 * t8;
  const S t26 = S(0.5) * (S(0.00314175) * (t17 * t17) + t23 + S(0.0009) * (t18 * t18) + S(0.00334175) * (t19 * t19)) + S(1.6575) * (qd1 * t24 - t8 * t25);
  const S qd2 = qd[2];  // d(q3)
  const S t27 = qd2 - S(0.154) * t8;
  const S t28 = q2 * t1 + S(0.412);
  const S t29 = t1 * t4 - t5 * (t3 * t0);
  const S t30 = t24 * t2 - t3 * t25;
  const S t31 = t2 * t25 + t3 * t24;
  const S t32 = S(6.1803) * (S(0.015) * t29 - t28);
  const S t33 = S(10.5948) * (t28 - (S(0.009) * (t2 * t0) + S(0.054) * t1)) + (S(49.05) * (S(0.412) - S(0.021) * t1) + S(27.552366) - S(41.6925) * (S(0.39) * t1 - t28)) - t32;
  e[1] = t33 + S(5.0031) * (S(0.155) * t29 + t28);
  const S t35 = (S(0.00972) * t10 - S(0.05832) * t11) * t31;
  const S t36 = S(3.235) * (t27 * t27 + (t24 * t24 + t25 * t25)) + t26 + S(0.0370066) * (qd0 * qd0) - t12 * (S(0.00972) * t27 - S(0.05832) * t30) + t35;
  e[0] = t36 - S(0.0696) * ((t31 * t4 + t5 * t27) * t19 + t17 * t30);
}

// body_poses: 43 multiplications, 19 additions, 10 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S angle[] = {q0, q1, q3, q4, q5};
  S sine[5], cosine[5];
  sines_and_cosines(5, angle, sine, cosine);
  W[0] = cosine[0];
  W[5] = cosine[0];
  W[18] = cosine[0];
  W[4] = sine[0];
  W[24] = sine[0];
  W[34] = cosine[1];
  W[46] = cosine[1];
  const S t2 = cosine[1];
  const S t0 = cosine[0];
  const S t10 = t2 * t0;
  W[12] = t10;
  W[25] = t10;
  const S t1 = sine[0];
  const S t11 = t2 * t1;
  W[16] = t11;
  W[29] = t11;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t12 = t1 * t4 + t5 * t10;
  W[36] = t12;
  const S t13 = t5 * t1 - t10 * t4;
  const S t14 = t5 * t11 - t0 * t4;
  W[40] = t14;
  const S t15 = t5 * t0 + t4 * t11;
  W[41] = t15;
  W[54] = t15;
  const S t3 = sine[1];
  const S t16 = t5 * t3;
  const S t17 = t0 * t3;
  W[26] = t17;
  W[38] = t17;
  const S t18 = t4 * t3;
  const S t19 = t1 * t3;
  W[30] = t19;
  W[42] = t19;
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t20 = t12 * t6 - t7 * t17;
  W[48] = t20;
  const S t21 = t6 * t16 + t7 * t2;
  const S t22 = t17 * t6 + t7 * t12;
  W[62] = t22;
  const S t23 = t14 * t6 - t7 * t19;
  W[52] = t23;
  const S t24 = t19 * t6 + t7 * t14;
  W[66] = t24;
  const S t25 = t2 * t6 - t7 * t16;
  W[70] = t25;
  W[44] = -t16;
  W[57] = -t25;
  W[53] = -t24;
  W[49] = -t22;
  const S t30 = -t3;
  W[20] = t30;
  W[33] = t30;
  const S t31 = S(-0.154) * t1;
  W[15] = t31;
  const S q2 = q[2];  // q3
  const S t32 = q2 * t17 + t31;
  W[27] = t32;
  W[39] = t32;
  W[51] = t32;
  W[63] = t32;
  W[13] = -t17;
  const S t34 = -t1;
  W[1] = t34;
  W[14] = t34;
  const S t35 = q2 * t2 + S(0.412);
  W[35] = t35;
  W[47] = t35;
  W[59] = t35;
  W[71] = t35;
  W[21] = -t2;
  const S t37 = S(0.154) * t0;
  W[19] = t37;
  const S t38 = q2 * t19 + t37;
  W[31] = t38;
  W[43] = t38;
  W[55] = t38;
  W[67] = t38;
  W[17] = -t19;
  W[28] = -t0;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  W[68] = -(t9 * t21 + t8 * t18);
  W[61] = -(t13 * t9 + t20 * t8);
  W[60] = t20 * t9 - t13 * t8;
  const S t44 = -t13;
  W[37] = t44;
  W[50] = t44;
  W[69] = t21 * t8 - t9 * t18;
  const S t46 = -t18;
  W[45] = t46;
  W[58] = t46;
  W[56] = -t21;
  W[64] = t15 * t8 + t23 * t9;
  W[65] = t15 * t9 - t23 * t8;
  W[11] = S(0.412);
  W[23] = S(0.412);
  W[2] = S(0.0);
  W[3] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[22] = S(0.0);
  W[32] = S(0.0);
  W[10] = S(1.0);
}

}  // namespace alembert::mechanisms::stanford

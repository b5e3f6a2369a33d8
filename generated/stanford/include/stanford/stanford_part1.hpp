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

// inverse_dynamics: 135 multiplications, 105 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t0 = cosine[0];
  const S qd0 = qd[0];  // d(q1)
  const S t8 = t0 * qd0;
  const S t1 = sine[0];
  const S t9 = qd0 * t1;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t10 = t1 * qdd0;
  const S qd1 = qd[1];  // d(q2)
  const S t11 = t8 * qd1;
  const S t12 = t11 + t10;
  const S t13 = t9 * qd1;
  const S t14 = t0 * qdd0;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t15 = t9 * t2 - qd1 * t3;
  const S t16 = qd1 * t2 + t9 * t3;
  const S qd3 = qd[3];  // d(q4)
  const S t17 = t8 + qd3;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t18 = qdd1 * t2 + t3 * t12 + qd3 * t15;
  const S t19 = qdd1 * t3 - t2 * t12 + qd3 * t16;
  const S t20 = t13 - t14;
  const S t21 = t8 * t9;
  const S t22 = t11 + t12;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t23 = t4 * t16 + t5 * t17;
  const S t24 = t5 * t16 - t4 * t17;
  const S qdd3 = qdd[3];  // dd(q4)
  const S t25 = t20 - qdd3;
  const S qd5 = qd[5];  // d(q6)
  const S t26 = qd5 + (qd5 - t24);
  const S t27 = qdd1 - t21;
  const S qd4 = qd[4];  // d(q5)
  const S t28 = t15 - qd4;
  const S t29 = qd4 * t24 - (t4 * t18 - t5 * t25);
  const S t30 = qd1 * qd1;
  const S qd2 = qd[2];  // d(q3)
  const S t31 = qd1 * qd2;
  const S t32 = t9 * qd2;
  const S t33 = t30 + t9 * t9;
  const S q2 = q[2];  // q3
  const S t34 = t32 + t32 + (q2 * t22 - S(0.154) * (qd0 * qd0));
  const S t35 = t31 + t31 - (S(9.81) * t1 + S(0.154) * t14 - t27 * q2);
  const S qdd4 = qdd[4];  // dd(q5)
  const S t36 = qdd4 + t19;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t37 = t6 * t29 - (t7 * t36 + (t23 * t7 + t28 * t6) * t26);
  const S t38 = t7 * t29 + (t6 * t36 + t26 * (t23 * t6 - t28 * t7));
  const S qdd2 = qdd[2];  // dd(q3)
  const S t39 = qdd2 - (S(0.154) * t10 - S(9.81) * t0 + q2 * t33);
  const S t40 = t29 - t28 * t24;
  const S t41 = t23 * t24;
  const S t42 = t23 * t23 + t28 * t28;
  const S t43 = t36 + t41;
  const S t44 = t3 * t35 - t2 * t34;
  const S t45 = S(0.0273445) * t41 + (S(0.0696) * (t4 * t44 - t5 * t39) + S(0.028444499999999998) * t36) + S(0.00015000000000000083) * (t6 * t38 - t7 * t37);
  tau[4] = t45;
  const S t46 = S(0.0278945) * t40 - (S(0.0696) * (t3 * t34 + t2 * t35) - S(0.00015000000000000083) * (t6 * t37 + t7 * t38));
  const S t47 = t5 * t18 + t4 * t25 + qd4 * t23;
  const S t48 = t18 + t15 * t17;
  const S t49 = t17 * t17;
  const S t50 = t16 * t17;
  const S t51 = S(0.009720000000000005) * (t16 * t16 + t49) + S(0.0696) * t40;
  const S t52 = t15 * t16;
  const S qdd5 = qdd[5];  // dd(q6)
  const S t53 = S(0.00030000000000000165) * (qdd5 - t47);
  tau[5] = t53;
  const S t54 = t53 - S(0.0005499999999999984) * (t47 - t23 * t28);
  const S t55 = t5 * t54 + t4 * t46 + (S(0.009720000000000005) * t39 - (S(0.00052488) * (t49 - t15 * t15) + S(0.0010374799999999995) * t48));
  const S t56 = t25 + t52;
  const S t57 = t4 * t54 - t5 * t46 - (S(0.009720000000000005) * t44 + (S(0.0006374799999999993) * t52 - (S(0.00052488) * (t19 - t50) - S(0.0014374799999999997) * t25)));
  tau[3] = t57;
  const S t58 = S(0.00052488) * t56 - S(0.0004000000000000002) * (t19 + t50) - t45;
  const S t59 = S(0.009720000000000005) * t56 + S(0.0696) * (t4 * t43 - t5 * t42);
  const S t60 = S(1.71582) * t33 + S(6.470000000000001) * t39 - S(0.0696) * (t5 * t43 + t4 * t42) - S(0.009720000000000005) * t48;
  tau[2] = t60;
  const S t61 = S(-0.154) * t60 - (t3 * t55 - t2 * t58 + S(1.71582) * t34 + q2 * (S(1.71582) * t22 - S(6.470000000000001) * t34 + (t2 * t59 + t3 * t51)));
  const S t62 = t2 * t51 - t3 * t59 - (S(6.470000000000001) * t35 - S(1.71582) * t27);
  tau[1] = S(1.03005) * t1 - (S(1.2471792800000001) * t21 - (S(0.012495) * t14 + S(1.2631792800000001) * qdd1)) - (q2 * t62 + (S(1.71582) * t35 + (t3 * t58 + t2 * t55)));
  const S t64 = t0 * (S(0.012495) * t27 - S(0.008000000000000007) * (t13 + t20) + (t57 + S(0.154) * t62)) + t1 * (t61 + (S(1.2551792800000001) * t22 - S(0.012495) * (t30 - t8 * t8)));
  tau[0] = t64 + S(0.16081820000000013) * qdd0;
}

// mass_matrix: 49 multiplications, 37 additions, 6 sin/cos/tan (reduced formulation).
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
  const S t8 = q2 * (t7 - S(3.2350000000000003) * q2);
  const S t4 = sine[2];
  const S t9 = S(0.0271945) * t4;
  const S t10 = t4 * t9;
  const S t11 = t9 * t5;
  const S t12 = S(-0.0696) * t4;
  M[16] = t12;
  M[26] = t12;
  const S t13 = S(1.28307378) - (t10 + (t8 + t8));
  const S t2 = sine[1];
  const S t14 = t2 * (S(8.748000000000002e-05) - t10);
  const S t3 = cosine[1];
  const S t15 = t2 * t12 - S(0.009720000000000005) * t3;
  M[8] = t15;
  M[13] = t15;
  const S t16 = S(0.00052488) * t3 - t2 * t11 + q2 * t15;
  const S t17 = t2 * t14;
  const S t18 = S(0.009187480000000007) - t17;
  const S t19 = t3 * t12 + S(0.009720000000000005) * t2;
  const S t20 = t3 * t11 + S(0.00052488) * t2 - q2 * t19;
  M[9] = t20;
  M[19] = t20;
  const S t1 = cosine[0];
  const S t0 = sine[0];
  const S t21 = t1 * (S(0.154) * (t7 - S(6.470000000000001) * q2) + t20 + S(0.012495)) + t0 * (S(-0.154) * t15 + t14 * t3);
  M[1] = t21;
  M[6] = t21;
  const S t22 = t1 * t16;
  M[0] = t10 + (t17 + (t18 - t0 * (t22 + t22 + t0 * (t18 - t13)) + S(0.308) * (t19 + S(0.49819)))) + S(0.16191820000000012);
  const S t24 = t10 + S(0.002287479999999999);
  M[21] = t24;
  const S t25 = t1 * (t24 - S(-0.154) * t19) - t0 * t16;
  M[3] = t25;
  M[18] = t25;
  M[7] = t18 + t13;
  const S t27 = t2 * t5;
  const S t28 = t0 * (S(0.0107184) * t4 - t3 * (q2 * t6 + S(0.0285945))) - t1 * (S(0.0107184) * t27);
  M[4] = t28;
  M[24] = t28;
  const S t29 = q2 * (S(0.0696) * t27) + S(0.0285945) * t2;
  M[10] = t29;
  M[25] = t29;
  const S t30 = S(0.00030000000000000165) * t4;
  const S t31 = S(0.00030000000000000165) * t5;
  M[23] = t31;
  M[33] = t31;
  const S t32 = t1 * t31 - t2 * (t0 * t30);
  M[5] = t32;
  M[30] = t32;
  const S t33 = t0 * (S(-0.99638) - t19);
  M[2] = t33;
  M[12] = t33;
  const S t34 = -(t3 * t30);
  M[11] = t34;
  M[31] = t34;
  M[14] = S(6.470000000000001);
  M[28] = S(0.0285945);
  M[35] = S(0.00030000000000000165);
  M[15] = S(0.0);
  M[17] = S(0.0);
  M[20] = S(0.0);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[32] = S(0.0);
  M[34] = S(0.0);
}

// bias: 126 multiplications, 90 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t1 = sine[0];
  const S t8 = qd0 * t1;
  const S t0 = cosine[0];
  const S t9 = t0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t10 = t9 * qd1;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t11 = t8 * t2 - qd1 * t3;
  const S t12 = qd1 * t2 + t8 * t3;
  const S qd3 = qd[3];  // d(q4)
  const S t13 = t3 * t10 + qd3 * t11;
  const S t14 = t9 + qd3;
  const S t15 = t8 * qd1;
  const S t16 = t2 * t10 - t12 * qd3;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t17 = t4 * t12 + t5 * t14;
  const S t18 = t12 * t5 - t4 * t14;
  const S qd4 = qd[4];  // d(q5)
  const S t19 = t15 * t5 - t4 * t13 + qd4 * t18;
  const S t20 = qd4 - t11;
  const S qd5 = qd[5];  // d(q6)
  const S t21 = qd5 - (t18 - qd5);
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t22 = t6 * t16 - (t21 * (t17 * t6 + t20 * t7) + t19 * t7);
  const S t23 = (t17 * t7 - t20 * t6) * t21 - (t19 * t6 + t7 * t16);
  const S t24 = t17 * qd4 + (t5 * t13 + t15 * t4);
  const S q2 = q[2];  // q3
  const S t25 = t10 * q2;
  const S t26 = t8 * t9;
  const S qd2 = qd[2];  // d(q3)
  const S t27 = t8 * qd2;
  const S t28 = t27 + t27 - (S(0.154) * (qd0 * qd0) - (t25 + t25));
  const S t29 = qd1 * qd2;
  const S t30 = t26 * q2 + S(9.81) * t1 - (t29 + t29);
  const S t31 = qd1 * qd1;
  const S t32 = t8 * t8 + t31;
  const S t33 = q2 * t32 - S(9.81) * t0;
  const S t34 = t3 * t30 + t2 * t28;
  const S t35 = S(-0.00030000000000000165) * t24;
  c[5] = t35;
  const S t36 = S(0.0005499999999999984) * (t17 * t20 + t24) - t35;
  const S t37 = t17 * t17 + t20 * t20;
  const S t38 = t17 * t18;
  const S t39 = t20 * t18 + t19;
  const S t40 = t16 - t38;
  const S t41 = S(0.0278945) * t39 - (S(0.0696) * (t3 * t28 - t2 * t30) + S(0.00015000000000000083) * (t6 * t23 + t7 * t22));
  const S t42 = S(0.00015000000000000083) * (t7 * t23 - t6 * t22) - (S(0.0696) * (t4 * t34 - t5 * t33) - (S(0.0273445) * t38 - S(0.028444499999999998) * t16));
  c[4] = t42;
  const S t43 = t14 * t14;
  const S t44 = S(0.009720000000000005) * (t43 + t12 * t12) + S(0.0696) * t39;
  const S t45 = t12 * t14;
  const S t46 = t13 + t14 * t11;
  const S t47 = S(0.009720000000000005) * t33 + (S(0.0010374799999999995) * t46 + S(0.00052488) * (t43 - t11 * t11)) + (t5 * t36 - t4 * t41);
  const S t48 = t12 * t11;
  const S t49 = S(0.009720000000000005) * t34 - (S(0.0014374799999999997) * t15 + S(0.00052488) * (t16 + t45) + S(0.0006374799999999993) * t48) - (t4 * t36 + t5 * t41);
  c[3] = t49;
  const S t50 = t15 + t48;
  const S t51 = S(0.0004000000000000002) * (t16 - t45) + S(0.00052488) * t50 - t42;
  const S t52 = S(0.0696) * (t4 * t40 + t5 * t37) - S(0.009720000000000005) * t50;
  const S t53 = S(0.0696) * (t5 * t40 - t4 * t37) - (S(6.470000000000001) * t33 - S(1.71582) * t32) - S(0.009720000000000005) * t46;
  c[2] = t53;
  const S t54 = S(1.71582) * t28 - (t2 * t51 + t3 * t47) - q2 * (t2 * t52 - t3 * t44 - (S(3.43164) * t10 - S(6.470000000000001) * t28)) + S(0.154) * t53;
  const S t55 = S(1.71582) * t26 - S(6.470000000000001) * t30 - (t3 * t52 + t2 * t44);
  c[1] = q2 * t55 + (t2 * t47 - t3 * t51 + S(1.71582) * t30) - (S(1.2471792800000001) * t26 - S(1.03005) * t1);
  c[0] = t1 * (S(2.5103585600000002) * t10 - S(0.012495) * (t31 - t9 * t9) - t54) - t0 * (S(0.012495) * t26 + S(0.016000000000000014) * t15 + (S(0.154) * t55 - t49));
}

// mass_matrix_and_bias: 173 multiplications, 127 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t0 = sine[0];
  const S qd0 = qd[0];  // d(q1)
  const S t8 = t0 * qd0;
  const S t1 = cosine[0];
  const S t9 = t1 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t10 = qd1 * t9;
  const S t3 = cosine[1];
  const S t2 = sine[1];
  const S t11 = t3 * t8 - t2 * qd1;
  const S t12 = t3 * qd1 + t2 * t8;
  const S qd3 = qd[3];  // d(q4)
  const S t13 = t2 * t10 + qd3 * t11;
  const S t14 = qd3 + t9;
  const S t15 = qd1 * t8;
  const S t16 = t3 * t10 - t12 * qd3;
  const S t5 = cosine[2];
  const S t4 = sine[2];
  const S t17 = t5 * t12 + t4 * t14;
  const S t18 = t4 * t12 - t5 * t14;
  const S qd4 = qd[4];  // d(q5)
  const S t19 = t4 * t15 - t5 * t13 + qd4 * t18;
  const S t20 = qd4 - t11;
  const S qd5 = qd[5];  // d(q6)
  const S t21 = qd5 - (t18 - qd5);
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t22 = t6 * t16 - (t21 * (t17 * t6 + t20 * t7) + t19 * t7);
  const S t23 = (t17 * t7 - t20 * t6) * t21 - (t19 * t6 + t7 * t16);
  const S t24 = t17 * qd4 + (t4 * t13 + t5 * t15);
  const S q2 = q[2];  // q3
  const S t25 = q2 * t10;
  const S t26 = t8 * t9;
  const S qd2 = qd[2];  // d(q3)
  const S t27 = t8 * qd2;
  const S t28 = t27 + t27 - (S(0.154) * (qd0 * qd0) - (t25 + t25));
  const S t29 = qd1 * qd2;
  const S t30 = q2 * t26 + S(9.81) * t0 - (t29 + t29);
  const S t31 = qd1 * qd1;
  const S t32 = t31 + t8 * t8;
  const S t33 = S(0.0696) * t5;
  const S t34 = q2 * t32 - S(9.81) * t1;
  const S t35 = S(1.71582) - t33;
  const S t36 = q2 * (S(3.2350000000000003) * q2 - t35);
  const S t37 = t2 * t30 + t3 * t28;
  const S t38 = S(0.0271945) * t4;
  const S t39 = t4 * t38;
  const S t40 = S(0.0696) * t4;
  const S t41 = t38 * t5;
  const S t42 = S(1.28307378) - (t39 - (t36 + t36));
  const S t43 = t2 * (S(8.748000000000002e-05) - t39);
  const S t44 = S(-0.009720000000000005) * t3 - t2 * t40;
  M[8] = t44;
  M[13] = t44;
  const S t45 = t14 * t14;
  const S t46 = t13 + t14 * t11;
  const S t47 = t12 * t14;
  const S t48 = t12 * t11;
  const S t49 = t20 * t18 + t19;
  const S t50 = t17 * t18;
  const S t51 = S(0.009720000000000005) * (t45 + t12 * t12) + S(0.0696) * t49;
  const S t52 = t17 * t17 + t20 * t20;
  const S t53 = S(0.0278945) * t49 - (S(0.0696) * (t2 * t28 - t3 * t30) + S(0.00015000000000000083) * (t6 * t23 + t7 * t22));
  const S t54 = S(0.00015000000000000083) * (t7 * t23 - t6 * t22) - (S(0.0696) * (t5 * t37 - t4 * t34) - (S(0.0273445) * t50 - S(0.028444499999999998) * t16));
  c[4] = t54;
  const S t55 = t16 - t50;
  const S t56 = S(-0.00030000000000000165) * t24;
  c[5] = t56;
  const S t57 = S(0.0005499999999999984) * (t17 * t20 + t24) - t56;
  const S t58 = S(0.009720000000000005) * t34 + (S(0.0010374799999999995) * t46 + S(0.00052488) * (t45 - t11 * t11)) + (t4 * t57 - t5 * t53);
  const S t59 = t5 * t57 + t4 * t53 - (S(0.009720000000000005) * t37 - (S(0.0014374799999999997) * t15 + S(0.00052488) * (t16 + t47) + S(0.0006374799999999993) * t48));
  const S t60 = t15 + t48;
  const S t61 = S(0.0004000000000000002) * (t16 - t47) + S(0.00052488) * t60 - t54;
  const S t62 = t33 * t55 + t40 * t52 - S(0.009720000000000005) * t60;
  const S t63 = t40 * t55 - t33 * t52 - S(0.009720000000000005) * t46 - (S(6.470000000000001) * t34 - S(1.71582) * t32);
  c[2] = t63;
  const S t64 = t2 * t43;
  const S t65 = S(0.009187480000000007) - t64;
  const S t66 = t2 * t41 - S(0.00052488) * t3 - q2 * t44;
  const S t67 = t1 * t66;
  const S t68 = t3 * t40 - S(0.009720000000000005) * t2;
  M[0] = t39 + (t64 + (S(0.308) * (S(0.49819) - t68) + (t65 + t0 * (t67 + t67 - t0 * (t65 - t42))))) + S(0.16191820000000012);
  const S t70 = t3 * t41 + S(0.00052488) * t2 + t68 * q2;
  M[9] = t70;
  M[19] = t70;
  const S t71 = t1 * (t70 + S(0.154) * (t35 - S(6.470000000000001) * q2) + S(0.012495)) + t0 * (S(-0.154) * t44 + t43 * t3);
  M[1] = t71;
  M[6] = t71;
  const S t72 = S(1.71582) * t28 - (t3 * t61 + t2 * t58) - q2 * (t3 * t62 - t2 * t51 - (S(3.43164) * t10 - S(6.470000000000001) * t28)) - S(-0.154) * t63;
  const S t73 = t3 * t51 + t2 * t62 - (S(1.71582) * t26 - S(6.470000000000001) * t30);
  c[1] = t3 * t58 - t2 * t61 + S(1.71582) * t30 - q2 * t73 - (S(1.2471792800000001) * t26 - S(1.03005) * t0);
  c[0] = t0 * (S(2.5103585600000002) * t10 - S(0.012495) * (t31 - t9 * t9) - t72) - t1 * (t59 - S(0.154) * t73 + (S(0.012495) * t26 + S(0.016000000000000014) * t15));
  const S t76 = t39 + S(0.002287479999999999);
  M[21] = t76;
  const S t77 = t0 * t66 - t1 * (S(0.154) * t68 - t76);
  M[3] = t77;
  M[18] = t77;
  const S t78 = t0 * (t68 - S(0.99638));
  M[2] = t78;
  M[12] = t78;
  const S t79 = t2 * t5;
  const S t80 = S(0.00030000000000000165) * t5;
  M[23] = t80;
  M[33] = t80;
  const S t81 = t0 * (S(0.0107184) * t4 - t3 * (q2 * t33 + S(0.0285945))) - t1 * (S(0.0107184) * t79);
  M[4] = t81;
  M[24] = t81;
  const S t82 = S(0.0696) * (q2 * t79) + S(0.0285945) * t2;
  M[10] = t82;
  M[25] = t82;
  const S t83 = S(0.00030000000000000165) * t4;
  const S t84 = t1 * t80 - t2 * (t0 * t83);
  M[5] = t84;
  M[30] = t84;
  const S t85 = -(t3 * t83);
  M[11] = t85;
  M[31] = t85;
  c[3] = -t59;
  M[7] = t65 + t42;
  const S t88 = -t40;
  M[16] = t88;
  M[26] = t88;
  M[14] = S(6.470000000000001);
  M[35] = S(0.00030000000000000165);
  M[28] = S(0.0285945);
  M[15] = S(0.0);
  M[17] = S(0.0);
  M[20] = S(0.0);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[32] = S(0.0);
  M[34] = S(0.0);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
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

// energy: 88 multiplications, 56 additions, 8 sin/cos/tan (reduced formulation).
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
  const S t10 = t9 + qd3;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S qd1 = qd[1];  // d(q2)
  const S t11 = t8 * t2 - t3 * qd1;
  const S t12 = t2 * qd1 + t8 * t3;
  const S t13 = t10 * (S(0.00052488) * t11 - S(0.00108748) * t10) + (t11 * (S(0.00052488) * t10 - S(0.00494928) * t11) - S(0.00523676) * (t12 * t12));
  const S t14 = t8 * t8;
  const S t15 = qd1 * (S(0.012495) * t9 + S(0.102205) * qd1) + (t9 * (S(0.012495) * qd1 + S(0.094805) * t9) - t13 + S(1.156425) * (t14 + qd1 * qd1)) + S(0.18101) * t14;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t16 = t4 * t12 + t5 * t10;
  const S t17 = t5 * t12 - t4 * t10;
  const S qd4 = qd[4];  // d(q5)
  const S t18 = qd4 - t11;
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t19 = t16 * t6 - t18 * t7;
  const S t20 = t16 * t7 + t18 * t6;
  const S qd5 = qd[5];  // d(q6)
  const S t21 = qd5 - t17;
  const S t22 = S(0.00314175) * (t16 * t16) + (S(0.02525275) * (t19 * t19 + t20 * t20) + (S(0.0003) * (t21 * t21) + t15)) + S(0.0009) * (t17 * t17);
  const S q2 = q[2];  // q3
  const S t23 = q2 * qd1 - S(0.154) * t9;
  const S t24 = q2 * t8;
  const S qd2 = qd[2];  // d(q3)
  const S t25 = qd2 - S(0.154) * t8;
  const S t26 = S(1.6575) * (qd1 * t23 + t8 * t24) - S(0.5) * (S(0.00334175) * (t18 * t18) + t22) - S(3.235) * (t25 * t25 + (t24 * t24 + t23 * t23));
  const S t27 = q2 * t1 + S(0.412);
  const S t28 = t5 * (t0 * t3) - t1 * t4;
  const S t29 = S(10.5948) * (t27 - (S(0.054) * t1 + S(0.009) * (t0 * t2))) + (S(41.6925) * (t27 - S(0.39) * t1) + (S(49.05) * (S(0.412) - S(0.021) * t1) + S(27.552366)));
  e[1] = S(6.1803) * (t27 + S(0.015) * t28) + t29 - S(5.0031) * (S(0.155) * t28 - t27);
  const S t31 = t24 * t2 - t3 * t23;
  const S t32 = t2 * t23 + t24 * t3;
  const S t33 = S(0.0696) * ((t31 * t4 + t5 * t25) * t18 - t16 * t32);
  e[0] = t31 * (S(0.00972) * t10 - S(0.05832) * t11) - (t12 * (S(0.00972) * t25 + S(0.05832) * t32) - (S(0.0370066) * (qd0 * qd0) - t26)) - t33;
}

// body_poses: 43 multiplications, 19 additions, 10 sin/cos/tan (reduced formulation).
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
  const S t0 = cosine[0];
  const S t2 = cosine[1];
  const S t10 = t0 * t2;
  W[12] = t10;
  W[25] = t10;
  const S t1 = sine[0];
  const S t11 = t1 * t2;
  W[16] = t11;
  W[29] = t11;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t12 = t1 * t4 + t10 * t5;
  W[36] = t12;
  const S t13 = t1 * t5 - t10 * t4;
  const S t14 = t11 * t5 - t0 * t4;
  W[40] = t14;
  const S t15 = t0 * t5 + t11 * t4;
  W[41] = t15;
  W[54] = t15;
  const S t3 = sine[1];
  const S t16 = t3 * t5;
  const S t17 = t0 * t3;
  W[26] = t17;
  W[38] = t17;
  const S t18 = t3 * t4;
  const S t19 = t1 * t3;
  W[30] = t19;
  W[42] = t19;
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t20 = t12 * t6 - t17 * t7;
  W[48] = t20;
  const S t21 = t16 * t6 + t2 * t7;
  const S t22 = t17 * t6 + t12 * t7;
  W[62] = t22;
  const S t23 = t14 * t6 - t19 * t7;
  W[52] = t23;
  const S t24 = t19 * t6 + t14 * t7;
  W[66] = t24;
  const S t25 = t2 * t6 - t16 * t7;
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
  const S t32 = t31 + t17 * q2;
  W[27] = t32;
  W[39] = t32;
  W[51] = t32;
  W[63] = t32;
  W[13] = -t17;
  const S t34 = -t1;
  W[1] = t34;
  W[14] = t34;
  const S t35 = t2 * q2 + S(0.412);
  W[35] = t35;
  W[47] = t35;
  W[59] = t35;
  W[71] = t35;
  W[21] = -t2;
  const S t37 = S(0.154) * t0;
  W[19] = t37;
  const S t38 = t37 + t19 * q2;
  W[31] = t38;
  W[43] = t38;
  W[55] = t38;
  W[67] = t38;
  W[17] = -t19;
  W[28] = -t0;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  W[68] = -(t21 * t9 + t18 * t8);
  W[61] = -(t13 * t9 + t20 * t8);
  W[60] = t20 * t9 - t13 * t8;
  const S t44 = -t13;
  W[37] = t44;
  W[50] = t44;
  W[69] = t21 * t8 - t18 * t9;
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

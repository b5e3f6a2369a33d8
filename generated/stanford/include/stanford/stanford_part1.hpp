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
  const S t10 = t8 * t9;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t11 = qdd1 - t10;
  const S qd1 = qd[1];  // d(q2)
  const S t12 = t9 * qd1;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t13 = t0 * qdd0;
  const S t14 = t12 - t13;
  const S t2 = cosine[1];
  const S t15 = t8 * qd1;
  const S t16 = t1 * qdd0;
  const S t17 = t15 + t16;
  const S t3 = sine[1];
  const S t18 = t9 * t2 - qd1 * t3;
  const S qd3 = qd[3];  // d(q4)
  const S t19 = qdd1 * t2 + t3 * t17 + qd3 * t18;
  const S t5 = sine[2];
  const S qdd3 = qdd[3];  // dd(q4)
  const S t20 = t14 - qdd3;
  const S t4 = cosine[2];
  const S t21 = qd1 * t2 + t9 * t3;
  const S t22 = t8 + qd3;
  const S t23 = t4 * t21 + t5 * t22;
  const S qd4 = qd[4];  // d(q5)
  const S t24 = t5 * t19 + t4 * t20 + qd4 * t23;
  const S qdd5 = qdd[5];  // dd(q6)
  const S t25 = S(0.00030000000000000165) * (qdd5 - t24);
  tau[5] = t25;
  const S t26 = t18 - qd4;
  const S t27 = t25 - S(0.0005499999999999984) * (t24 - t23 * t26);
  const S t28 = t5 * t21 - t4 * t22;
  const S t29 = qd4 * t28 - (t4 * t19 - t5 * t20);
  const S t30 = t29 - t26 * t28;
  const S qd2 = qd[2];  // d(q3)
  const S t31 = t9 * qd2;
  const S t32 = t15 + t17;
  const S q2 = q[2];  // q3
  const S t33 = t31 + t31 + (q2 * t32 - S(0.154) * (qd0 * qd0));
  const S t34 = qd1 * qd2;
  const S t35 = t34 + t34 - (S(9.81) * t1 + S(0.154) * t13 - t11 * q2);
  const S t6 = sine[3];
  const S t36 = qdd1 * t3 - t2 * t17 + qd3 * t21;
  const S qdd4 = qdd[4];  // dd(q5)
  const S t37 = qdd4 + t36;
  const S t7 = cosine[3];
  const S qd5 = qd[5];  // d(q6)
  const S t38 = qd5 + (qd5 - t28);
  const S t39 = t6 * t29 - (t7 * t37 + (t23 * t7 + t26 * t6) * t38);
  const S t40 = t7 * t29 + (t6 * t37 + t38 * (t23 * t6 - t26 * t7));
  const S t41 = S(0.0278945) * t30 - (S(0.0696) * (t3 * t33 + t2 * t35) - S(0.00015000000000000083) * (t6 * t39 + t7 * t40));
  const S t42 = t3 * t35 - t2 * t33;
  const S t43 = t18 * t21;
  const S t44 = t21 * t22;
  const S t45 = t4 * t27 - t5 * t41 - (S(0.009720000000000005) * t42 + (S(0.0006374799999999993) * t43 - (S(0.00052488) * (t36 - t44) - S(0.0014374799999999997) * t20)));
  tau[3] = t45;
  const S t46 = t22 * t22;
  const S t47 = S(0.009720000000000005) * (t21 * t21 + t46) + S(0.0696) * t30;
  const S t48 = t20 + t43;
  const S t49 = t23 * t28;
  const S t50 = t37 + t49;
  const S t51 = t23 * t23 + t26 * t26;
  const S t52 = S(0.009720000000000005) * t48 + S(0.0696) * (t4 * t50 - t5 * t51);
  const S t53 = t2 * t47 - t3 * t52 - (S(6.470000000000001) * t35 - S(1.71582) * t11);
  const S t54 = qd1 * qd1;
  const S t55 = t54 + t9 * t9;
  const S qdd2 = qdd[2];  // dd(q3)
  const S t56 = qdd2 - (S(0.154) * t16 - S(9.81) * t0 + q2 * t55);
  const S t57 = t19 + t18 * t22;
  const S t58 = S(1.71582) * t55 + S(6.470000000000001) * t56 - S(0.0696) * (t5 * t50 + t4 * t51) - S(0.009720000000000005) * t57;
  tau[2] = t58;
  const S t59 = t5 * t27 + t4 * t41 + (S(0.009720000000000005) * t56 - (S(0.00052488) * (t46 - t18 * t18) + S(0.0010374799999999995) * t57));
  const S t60 = S(0.0273445) * t49 + (S(0.0696) * (t4 * t42 - t5 * t56) + S(0.028444499999999998) * t37) + S(0.00015000000000000083) * (t6 * t40 - t7 * t39);
  tau[4] = t60;
  const S t61 = S(0.00052488) * t48 - S(0.0004000000000000002) * (t36 + t44) - t60;
  const S t62 = S(-0.154) * t58 - (t3 * t59 - t2 * t61 + S(1.71582) * t33 + q2 * (S(1.71582) * t32 - S(6.470000000000001) * t33 + (t2 * t52 + t3 * t47)));
  const S t63 = t0 * (S(0.012495) * t11 - S(0.008000000000000007) * (t12 + t14) + (t45 + S(0.154) * t53)) + t1 * (t62 + (S(1.2551792800000001) * t32 - S(0.012495) * (t54 - t8 * t8)));
  tau[0] = t63 + S(0.16081820000000013) * qdd0;
  tau[1] = S(1.03005) * t1 - (S(1.2471792800000001) * t10 - (S(0.012495) * t13 + S(1.2631792800000001) * qdd1)) - (q2 * t53 + (S(1.71582) * t35 + (t3 * t61 + t2 * t59)));
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
  const S t4 = sine[2];
  const S t6 = S(0.0271945) * t4;
  const S t7 = t4 * t6;
  const S t2 = sine[1];
  const S t8 = t2 * (S(8.748000000000002e-05) - t7);
  const S t9 = t2 * t8;
  const S t10 = S(0.009187480000000007) - t9;
  const S t3 = cosine[1];
  const S t5 = cosine[2];
  const S t11 = t6 * t5;
  const S t12 = S(-0.0696) * t4;
  M[16] = t12;
  M[26] = t12;
  const S t13 = t2 * t12 - S(0.009720000000000005) * t3;
  M[8] = t13;
  M[13] = t13;
  const S q2 = q[2];  // q3
  const S t14 = S(0.00052488) * t3 - t2 * t11 + q2 * t13;
  const S t1 = cosine[0];
  const S t15 = t1 * t14;
  const S t16 = S(0.0696) * t5;
  const S t17 = S(1.71582) - t16;
  const S t18 = q2 * (t17 - S(3.2350000000000003) * q2);
  const S t19 = S(1.28307378) - (t7 + (t18 + t18));
  const S t0 = sine[0];
  const S t20 = t3 * t12 + S(0.009720000000000005) * t2;
  M[0] = t7 + (t9 + (t10 - t0 * (t15 + t15 + t0 * (t10 - t19)) + S(0.308) * (t20 + S(0.49819)))) + S(0.16191820000000012);
  const S t22 = t3 * t11 + S(0.00052488) * t2 - q2 * t20;
  M[9] = t22;
  M[19] = t22;
  const S t23 = t1 * (S(0.154) * (t17 - S(6.470000000000001) * q2) + t22 + S(0.012495)) + t0 * (S(-0.154) * t13 + t8 * t3);
  M[1] = t23;
  M[6] = t23;
  const S t24 = t0 * (S(-0.99638) - t20);
  M[2] = t24;
  M[12] = t24;
  const S t25 = t7 + S(0.002287479999999999);
  M[21] = t25;
  const S t26 = t1 * (t25 - S(-0.154) * t20) - t0 * t14;
  M[3] = t26;
  M[18] = t26;
  const S t27 = t2 * t5;
  const S t28 = t0 * (S(0.0107184) * t4 - t3 * (q2 * t16 + S(0.0285945))) - t1 * (S(0.0107184) * t27);
  M[4] = t28;
  M[24] = t28;
  const S t29 = S(0.00030000000000000165) * t5;
  M[23] = t29;
  M[33] = t29;
  const S t30 = S(0.00030000000000000165) * t4;
  const S t31 = t1 * t29 - t2 * (t0 * t30);
  M[5] = t31;
  M[30] = t31;
  M[7] = t10 + t19;
  const S t33 = q2 * (S(0.0696) * t27) + S(0.0285945) * t2;
  M[10] = t33;
  M[25] = t33;
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
  const S t0 = cosine[0];
  const S qd0 = qd[0];  // d(q1)
  const S t8 = t0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t9 = t8 * qd1;
  const S t10 = qd1 * qd1;
  const S t1 = sine[0];
  const S t11 = qd0 * t1;
  const S qd2 = qd[2];  // d(q3)
  const S t12 = t11 * qd2;
  const S q2 = q[2];  // q3
  const S t13 = t9 * q2;
  const S t14 = t12 + t12 - (S(0.154) * (qd0 * qd0) - (t13 + t13));
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t15 = qd1 * t2 + t11 * t3;
  const S qd3 = qd[3];  // d(q4)
  const S t16 = t2 * t9 - t15 * qd3;
  const S t17 = t8 + qd3;
  const S t18 = t15 * t17;
  const S t19 = t11 * qd1;
  const S t20 = t11 * t2 - qd1 * t3;
  const S t21 = t15 * t20;
  const S t22 = t19 + t21;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t23 = t4 * t15 + t5 * t17;
  const S t7 = cosine[3];
  const S qd4 = qd[4];  // d(q5)
  const S t24 = qd4 - t20;
  const S t6 = sine[3];
  const S t25 = t15 * t5 - t4 * t17;
  const S qd5 = qd[5];  // d(q6)
  const S t26 = qd5 - (t25 - qd5);
  const S t27 = t3 * t9 + qd3 * t20;
  const S t28 = t19 * t5 - t4 * t27 + qd4 * t25;
  const S t29 = (t23 * t7 - t24 * t6) * t26 - (t28 * t6 + t7 * t16);
  const S t30 = t6 * t16 - (t26 * (t23 * t6 + t24 * t7) + t28 * t7);
  const S t31 = t11 * t8;
  const S t32 = qd1 * qd2;
  const S t33 = t31 * q2 + S(9.81) * t1 - (t32 + t32);
  const S t34 = t3 * t33 + t2 * t14;
  const S t35 = t11 * t11 + t10;
  const S t36 = q2 * t35 - S(9.81) * t0;
  const S t37 = t23 * t25;
  const S t38 = S(0.00015000000000000083) * (t7 * t29 - t6 * t30) - (S(0.0696) * (t4 * t34 - t5 * t36) - (S(0.0273445) * t37 - S(0.028444499999999998) * t16));
  c[4] = t38;
  const S t39 = S(0.0004000000000000002) * (t16 - t18) + S(0.00052488) * t22 - t38;
  const S t40 = t27 + t17 * t20;
  const S t41 = t17 * t17;
  const S t42 = t23 * qd4 + (t5 * t27 + t19 * t4);
  const S t43 = S(-0.00030000000000000165) * t42;
  c[5] = t43;
  const S t44 = S(0.0005499999999999984) * (t23 * t24 + t42) - t43;
  const S t45 = t24 * t25 + t28;
  const S t46 = S(0.0278945) * t45 - (S(0.0696) * (t3 * t14 - t2 * t33) + S(0.00015000000000000083) * (t6 * t29 + t7 * t30));
  const S t47 = S(0.009720000000000005) * t36 + (S(0.0010374799999999995) * t40 + S(0.00052488) * (t41 - t20 * t20)) + (t5 * t44 - t4 * t46);
  const S t48 = t16 - t37;
  const S t49 = t23 * t23 + t24 * t24;
  const S t50 = S(0.0696) * (t4 * t48 + t5 * t49) - S(0.009720000000000005) * t22;
  const S t51 = S(0.009720000000000005) * (t41 + t15 * t15) + S(0.0696) * t45;
  const S t52 = S(0.0696) * (t5 * t48 - t4 * t49) - (S(6.470000000000001) * t36 - S(1.71582) * t35) - S(0.009720000000000005) * t40;
  c[2] = t52;
  const S t53 = S(1.71582) * t14 - (t2 * t39 + t3 * t47) - q2 * (t2 * t50 - t3 * t51 - (S(3.43164) * t9 - S(6.470000000000001) * t14)) + S(0.154) * t52;
  const S t54 = S(1.71582) * t31 - S(6.470000000000001) * t33 - (t3 * t50 + t2 * t51);
  const S t55 = S(0.009720000000000005) * t34 - (S(0.0014374799999999997) * t19 + S(0.00052488) * (t16 + t18) + S(0.0006374799999999993) * t21) - (t4 * t44 + t5 * t46);
  c[3] = t55;
  c[0] = t1 * (S(2.5103585600000002) * t9 - S(0.012495) * (t10 - t8 * t8) - t53) - t0 * (S(0.012495) * t31 + S(0.016000000000000014) * t19 + (S(0.154) * t54 - t55));
  c[1] = q2 * t54 + (t2 * t47 - t3 * t39 + S(1.71582) * t33) - (S(1.2471792800000001) * t31 - S(1.03005) * t1);
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
  const S t4 = sine[2];
  const S t8 = S(0.0271945) * t4;
  const S t9 = t4 * t8;
  const S t2 = sine[1];
  const S t10 = t2 * (S(8.748000000000002e-05) - t9);
  const S t11 = t2 * t10;
  const S t12 = S(0.0696) * t4;
  const S t3 = cosine[1];
  const S t13 = t3 * t12 - S(0.009720000000000005) * t2;
  const S t14 = S(0.009187480000000007) - t11;
  const S t5 = cosine[2];
  const S t15 = t8 * t5;
  const S t16 = S(-0.009720000000000005) * t3 - t2 * t12;
  M[8] = t16;
  M[13] = t16;
  const S q2 = q[2];  // q3
  const S t17 = t2 * t15 - S(0.00052488) * t3 - q2 * t16;
  const S t1 = cosine[0];
  const S t18 = t1 * t17;
  const S t19 = S(0.0696) * t5;
  const S t20 = S(1.71582) - t19;
  const S t21 = q2 * (S(3.2350000000000003) * q2 - t20);
  const S t22 = S(1.28307378) - (t9 - (t21 + t21));
  const S t0 = sine[0];
  M[0] = t9 + (t11 + (S(0.308) * (S(0.49819) - t13) + (t14 + t0 * (t18 + t18 - t0 * (t14 - t22))))) + S(0.16191820000000012);
  const S t24 = t3 * t15 + S(0.00052488) * t2 + t13 * q2;
  M[9] = t24;
  M[19] = t24;
  const S t25 = t1 * (t24 + S(0.154) * (t20 - S(6.470000000000001) * q2) + S(0.012495)) + t0 * (S(-0.154) * t16 + t10 * t3);
  M[1] = t25;
  M[6] = t25;
  const S t26 = t0 * (t13 - S(0.99638));
  M[2] = t26;
  M[12] = t26;
  const S t27 = t9 + S(0.002287479999999999);
  M[21] = t27;
  const S t28 = t0 * t17 - t1 * (S(0.154) * t13 - t27);
  M[3] = t28;
  M[18] = t28;
  const S t29 = t2 * t5;
  const S t30 = t0 * (S(0.0107184) * t4 - t3 * (q2 * t19 + S(0.0285945))) - t1 * (S(0.0107184) * t29);
  M[4] = t30;
  M[24] = t30;
  const S t31 = S(0.00030000000000000165) * t5;
  M[23] = t31;
  M[33] = t31;
  const S t32 = S(0.00030000000000000165) * t4;
  const S t33 = t1 * t31 - t2 * (t0 * t32);
  M[5] = t33;
  M[30] = t33;
  M[7] = t14 + t22;
  const S t35 = S(0.0696) * (q2 * t29) + S(0.0285945) * t2;
  M[10] = t35;
  M[25] = t35;
  const S t36 = -(t3 * t32);
  M[11] = t36;
  M[31] = t36;
  const S t37 = -t12;
  M[16] = t37;
  M[26] = t37;
  const S qd0 = qd[0];  // d(q1)
  const S t38 = t1 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t39 = qd1 * t38;
  const S t40 = qd1 * qd1;
  const S t41 = t0 * qd0;
  const S qd2 = qd[2];  // d(q3)
  const S t42 = t41 * qd2;
  const S t43 = q2 * t39;
  const S t44 = t42 + t42 - (S(0.154) * (qd0 * qd0) - (t43 + t43));
  const S t45 = t3 * qd1 + t2 * t41;
  const S qd3 = qd[3];  // d(q4)
  const S t46 = t3 * t39 - t45 * qd3;
  const S t47 = qd3 + t38;
  const S t48 = t45 * t47;
  const S t49 = qd1 * t41;
  const S t50 = t3 * t41 - t2 * qd1;
  const S t51 = t45 * t50;
  const S t52 = t49 + t51;
  const S t53 = t5 * t45 + t4 * t47;
  const S t7 = cosine[3];
  const S qd4 = qd[4];  // d(q5)
  const S t54 = qd4 - t50;
  const S t6 = sine[3];
  const S t55 = t4 * t45 - t5 * t47;
  const S qd5 = qd[5];  // d(q6)
  const S t56 = qd5 - (t55 - qd5);
  const S t57 = t2 * t39 + qd3 * t50;
  const S t58 = t4 * t49 - t5 * t57 + qd4 * t55;
  const S t59 = (t53 * t7 - t54 * t6) * t56 - (t58 * t6 + t7 * t46);
  const S t60 = t6 * t46 - (t56 * (t53 * t6 + t54 * t7) + t58 * t7);
  const S t61 = t41 * t38;
  const S t62 = qd1 * qd2;
  const S t63 = q2 * t61 + S(9.81) * t0 - (t62 + t62);
  const S t64 = t2 * t63 + t3 * t44;
  const S t65 = t40 + t41 * t41;
  const S t66 = q2 * t65 - S(9.81) * t1;
  const S t67 = t53 * t55;
  const S t68 = S(0.00015000000000000083) * (t7 * t59 - t6 * t60) - (S(0.0696) * (t5 * t64 - t4 * t66) - (S(0.0273445) * t67 - S(0.028444499999999998) * t46));
  c[4] = t68;
  const S t69 = S(0.0004000000000000002) * (t46 - t48) + S(0.00052488) * t52 - t68;
  const S t70 = t57 + t47 * t50;
  const S t71 = t47 * t47;
  const S t72 = t53 * qd4 + (t4 * t57 + t5 * t49);
  const S t73 = S(-0.00030000000000000165) * t72;
  c[5] = t73;
  const S t74 = S(0.0005499999999999984) * (t53 * t54 + t72) - t73;
  const S t75 = t54 * t55 + t58;
  const S t76 = S(0.0278945) * t75 - (S(0.0696) * (t2 * t44 - t3 * t63) + S(0.00015000000000000083) * (t6 * t59 + t7 * t60));
  const S t77 = S(0.009720000000000005) * t66 + (S(0.0010374799999999995) * t70 + S(0.00052488) * (t71 - t50 * t50)) + (t4 * t74 - t5 * t76);
  const S t78 = t46 - t67;
  const S t79 = t53 * t53 + t54 * t54;
  const S t80 = t19 * t78 + t12 * t79 - S(0.009720000000000005) * t52;
  const S t81 = S(0.009720000000000005) * (t71 + t45 * t45) + S(0.0696) * t75;
  const S t82 = t12 * t78 - t19 * t79 - S(0.009720000000000005) * t70 - (S(6.470000000000001) * t66 - S(1.71582) * t65);
  c[2] = t82;
  const S t83 = S(1.71582) * t44 - (t3 * t69 + t2 * t77) - q2 * (t3 * t80 - t2 * t81 - (S(3.43164) * t39 - S(6.470000000000001) * t44)) - S(-0.154) * t82;
  const S t84 = t5 * t74 + t4 * t76 - (S(0.009720000000000005) * t64 - (S(0.0014374799999999997) * t49 + S(0.00052488) * (t46 + t48) + S(0.0006374799999999993) * t51));
  const S t85 = t3 * t81 + t2 * t80 - (S(1.71582) * t61 - S(6.470000000000001) * t63);
  c[0] = t0 * (S(2.5103585600000002) * t39 - S(0.012495) * (t40 - t38 * t38) - t83) - t1 * (t84 - S(0.154) * t85 + (S(0.012495) * t61 + S(0.016000000000000014) * t49));
  c[1] = t3 * t77 - t2 * t69 + S(1.71582) * t63 - q2 * t85 - (S(1.2471792800000001) * t61 - S(1.03005) * t0);
  c[3] = -t84;
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
  const S q2 = q[2];  // q3
  const S t9 = q2 * t8;
  const S t2 = cosine[1];
  const S qd1 = qd[1];  // d(q2)
  const S t1 = cosine[0];
  const S t10 = qd0 * t1;
  const S t11 = q2 * qd1 - S(0.154) * t10;
  const S t3 = sine[1];
  const S t12 = t9 * t2 - t3 * t11;
  const S qd3 = qd[3];  // d(q4)
  const S t13 = t10 + qd3;
  const S t14 = t8 * t2 - t3 * qd1;
  const S t15 = t2 * qd1 + t8 * t3;
  const S qd2 = qd[2];  // d(q3)
  const S t16 = qd2 - S(0.154) * t8;
  const S t17 = t2 * t11 + t9 * t3;
  const S qd4 = qd[4];  // d(q5)
  const S t18 = qd4 - t14;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t19 = t4 * t15 + t5 * t13;
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t20 = t19 * t6 - t18 * t7;
  const S t21 = t19 * t7 + t18 * t6;
  const S t22 = t5 * t15 - t4 * t13;
  const S qd5 = qd[5];  // d(q6)
  const S t23 = qd5 - t22;
  const S t24 = t13 * (S(0.00052488) * t14 - S(0.00108748) * t13) + (t14 * (S(0.00052488) * t13 - S(0.00494928) * t14) - S(0.00523676) * (t15 * t15));
  const S t25 = t8 * t8;
  const S t26 = qd1 * (S(0.012495) * t10 + S(0.102205) * qd1) + (t10 * (S(0.012495) * qd1 + S(0.094805) * t10) - t24 + S(1.156425) * (t25 + qd1 * qd1)) + S(0.18101) * t25;
  const S t27 = S(0.00314175) * (t19 * t19) + (S(0.02525275) * (t20 * t20 + t21 * t21) + (S(0.0003) * (t23 * t23) + t26)) + S(0.0009) * (t22 * t22);
  const S t28 = S(1.6575) * (qd1 * t11 + t8 * t9) - S(0.5) * (S(0.00334175) * (t18 * t18) + t27) - S(3.235) * (t16 * t16 + (t9 * t9 + t11 * t11));
  const S t29 = S(0.0696) * ((t12 * t4 + t5 * t16) * t18 - t19 * t17);
  e[0] = t12 * (S(0.00972) * t13 - S(0.05832) * t14) - (t15 * (S(0.00972) * t16 + S(0.05832) * t17) - (S(0.0370066) * (qd0 * qd0) - t28)) - t29;
  const S t31 = q2 * t1 + S(0.412);
  const S t32 = t5 * (t0 * t3) - t1 * t4;
  const S t33 = S(10.5948) * (t31 - (S(0.054) * t1 + S(0.009) * (t0 * t2))) + (S(41.6925) * (t31 - S(0.39) * t1) + (S(49.05) * (S(0.412) - S(0.021) * t1) + S(27.552366)));
  e[1] = S(6.1803) * (t31 + S(0.015) * t32) + t33 - S(5.0031) * (S(0.155) * t32 - t31);
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
  const S t1 = sine[0];
  const S t10 = -t1;
  W[1] = t10;
  W[14] = t10;
  const S t0 = cosine[0];
  const S t2 = cosine[1];
  const S t11 = t0 * t2;
  W[12] = t11;
  W[25] = t11;
  const S t3 = sine[1];
  const S t12 = t0 * t3;
  W[26] = t12;
  W[38] = t12;
  W[13] = -t12;
  const S t14 = S(-0.154) * t1;
  W[15] = t14;
  const S t15 = t1 * t2;
  W[16] = t15;
  W[29] = t15;
  const S t16 = t1 * t3;
  W[30] = t16;
  W[42] = t16;
  W[17] = -t16;
  const S t18 = S(0.154) * t0;
  W[19] = t18;
  const S t19 = -t3;
  W[20] = t19;
  W[33] = t19;
  W[21] = -t2;
  const S q2 = q[2];  // q3
  const S t21 = t14 + t12 * q2;
  W[27] = t21;
  W[39] = t21;
  W[51] = t21;
  W[63] = t21;
  W[28] = -t0;
  const S t23 = t18 + t16 * q2;
  W[31] = t23;
  W[43] = t23;
  W[55] = t23;
  W[67] = t23;
  const S t24 = t2 * q2 + S(0.412);
  W[35] = t24;
  W[47] = t24;
  W[59] = t24;
  W[71] = t24;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t25 = t1 * t4 + t11 * t5;
  W[36] = t25;
  const S t26 = t1 * t5 - t11 * t4;
  const S t27 = -t26;
  W[37] = t27;
  W[50] = t27;
  const S t28 = t15 * t5 - t0 * t4;
  W[40] = t28;
  const S t29 = t0 * t5 + t15 * t4;
  W[41] = t29;
  W[54] = t29;
  const S t30 = t3 * t5;
  W[44] = -t30;
  const S t32 = t3 * t4;
  const S t33 = -t32;
  W[45] = t33;
  W[58] = t33;
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t34 = t25 * t6 - t12 * t7;
  W[48] = t34;
  const S t35 = t12 * t6 + t25 * t7;
  W[62] = t35;
  W[49] = -t35;
  const S t37 = t28 * t6 - t16 * t7;
  W[52] = t37;
  const S t38 = t16 * t6 + t28 * t7;
  W[66] = t38;
  W[53] = -t38;
  const S t40 = t30 * t6 + t2 * t7;
  W[56] = -t40;
  const S t42 = t2 * t6 - t30 * t7;
  W[70] = t42;
  W[57] = -t42;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  W[60] = t34 * t9 - t26 * t8;
  W[61] = -(t26 * t9 + t34 * t8);
  W[64] = t29 * t8 + t37 * t9;
  W[65] = t29 * t9 - t37 * t8;
  W[68] = -(t40 * t9 + t32 * t8);
  W[69] = t40 * t8 - t32 * t9;
  W[2] = S(0.0);
  W[3] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[22] = S(0.0);
  W[32] = S(0.0);
  W[10] = S(1.0);
  W[11] = S(0.412);
  W[23] = S(0.412);
}

}  // namespace alembert::mechanisms::stanford

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
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S q2 = q[2];  // q3
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  const S qdd0 = qdd[0];  // dd(q1)
  const S qdd1 = qdd[1];  // dd(q2)
  const S qdd2 = qdd[2];  // dd(q3)
  const S qdd3 = qdd[3];  // dd(q4)
  const S qdd4 = qdd[4];  // dd(q5)
  const S qdd5 = qdd[5];  // dd(q6)
  const S t0 = cos(q1);
  const S t1 = sin(q1);
  const S t2 = t0 * qd0;
  const S t3 = qd0 * t1;
  const S t4 = t2 * t3;
  const S t5 = qdd1 - t4;
  const S t6 = t3 * qd1;
  const S t7 = t0 * qdd0;
  const S t8 = t6 - t7;
  const S t9 = cos(q4);
  const S t10 = sin(q4);
  const S t11 = cos(q3);
  const S t12 = sin(q3);
  const S t13 = t2 * qd1;
  const S t14 = t1 * qdd0;
  const S t15 = t13 + t14;
  const S t16 = t3 * t11 - qd1 * t12;
  const S t17 = qdd1 * t11 + t12 * t15 + qd3 * t16;
  const S t18 = t8 - qdd3;
  const S t19 = qd1 * t11 + t3 * t12;
  const S t20 = t2 + qd3;
  const S t21 = t9 * t19 + t10 * t20;
  const S t22 = t10 * t17 + t9 * t18 + qd4 * t21;
  const S t23 = S(0.00030000000000000165) * (qdd5 - t22);
  tau[5] = t23;
  const S t24 = t16 - qd4;
  const S t25 = t23 - S(0.0005499999999999984) * (t22 - t21 * t24);
  const S t26 = t10 * t19 - t9 * t20;
  const S t27 = qd4 * t26 - (t9 * t17 - t10 * t18);
  const S t28 = t27 - t24 * t26;
  const S t29 = t3 * qd2;
  const S t30 = t13 + t15;
  const S t31 = t29 + t29 + (q2 * t30 - S(0.154) * (qd0 * qd0));
  const S t32 = qd1 * qd2;
  const S t33 = t32 + t32 - (S(9.81) * t1 + S(0.154) * t7 - t5 * q2);
  const S t34 = sin(q5);
  const S t35 = cos(q5);
  const S t36 = qdd1 * t12 - t11 * t15 + qd3 * t19;
  const S t37 = qdd4 + t36;
  const S t38 = qd5 + (qd5 - t26);
  const S t39 = t34 * t27 - (t35 * t37 + (t21 * t35 + t24 * t34) * t38);
  const S t40 = t35 * t27 + (t34 * t37 + t38 * (t21 * t34 - t24 * t35));
  const S t41 = S(0.0278945) * t28 - (S(0.0696) * (t12 * t31 + t11 * t33) - S(0.00015000000000000083) * (t34 * t39 + t35 * t40));
  const S t42 = t12 * t33 - t11 * t31;
  const S t43 = t16 * t19;
  const S t44 = t19 * t20;
  const S t45 = t9 * t25 - t10 * t41 - (S(0.009720000000000005) * t42 + (S(0.0006374799999999993) * t43 - (S(0.00052488) * (t36 - t44) - S(0.0014374799999999997) * t18)));
  tau[3] = t45;
  const S t46 = t20 * t20;
  const S t47 = S(0.009720000000000005) * (t19 * t19 + t46) + S(0.0696) * t28;
  const S t48 = t18 + t43;
  const S t49 = t21 * t26;
  const S t50 = t37 + t49;
  const S t51 = t21 * t21 + t24 * t24;
  const S t52 = S(0.009720000000000005) * t48 + S(0.0696) * (t9 * t50 - t10 * t51);
  const S t53 = t11 * t47 - t12 * t52 - (S(6.470000000000001) * t33 - S(1.71582) * t5);
  const S t54 = qd1 * qd1;
  const S t55 = t54 + t3 * t3;
  const S t56 = qdd2 - (S(0.154) * t14 - S(9.81) * t0 + q2 * t55);
  const S t57 = t17 + t16 * t20;
  const S t58 = S(1.71582) * t55 + S(6.470000000000001) * t56 - S(0.0696) * (t10 * t50 + t9 * t51) - S(0.009720000000000005) * t57;
  tau[2] = t58;
  const S t59 = t10 * t25 + t9 * t41 + (S(0.009720000000000005) * t56 - (S(0.00052488) * (t46 - t16 * t16) + S(0.0010374799999999995) * t57));
  const S t60 = S(0.0273445) * t49 + (S(0.0696) * (t9 * t42 - t10 * t56) + S(0.028444499999999998) * t37) + S(0.00015000000000000083) * (t34 * t40 - t35 * t39);
  tau[4] = t60;
  const S t61 = S(0.00052488) * t48 - S(0.0004000000000000002) * (t36 + t44) - t60;
  const S t62 = S(-0.154) * t58 - (t12 * t59 - t11 * t61 + S(1.71582) * t31 + q2 * (S(1.71582) * t30 - S(6.470000000000001) * t31 + (t11 * t52 + t12 * t47)));
  const S t63 = t0 * (S(0.012495) * t5 - S(0.008000000000000007) * (t6 + t8) + (t45 + S(0.154) * t53)) + t1 * (t62 + (S(1.2551792800000001) * t30 - S(0.012495) * (t54 - t2 * t2)));
  tau[0] = t63 + S(0.16081820000000013) * qdd0;
  tau[1] = S(1.03005) * t1 - (S(1.2471792800000001) * t4 - (S(0.012495) * t7 + S(1.2631792800000001) * qdd1)) - (q2 * t53 + (S(1.71582) * t33 + (t12 * t61 + t11 * t59)));
}

// mass_matrix: 53 multiplications, 37 additions, 6 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S q2 = q[2];  // q3
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S t0 = sin(q4);
  const S t1 = cos(q4);
  const S t2 = S(0.0271945) * (t0 * t0);
  const S t3 = sin(q3);
  const S t4 = cos(q3);
  const S t5 = t3 * (S(8.748000000000002e-05) - t2);
  const S t6 = t3 * t5;
  const S t7 = S(0.009187480000000007) - t6;
  const S t8 = sin(q1);
  const S t9 = cos(q1);
  const S t10 = t0 * t1;
  const S t11 = t3 * t0;
  const S t12 = S(-0.0696) * t11 - S(0.009720000000000005) * t4;
  M[8] = t12;
  M[13] = t12;
  const S t13 = S(0.00052488) * t4 - S(0.0271945) * (t3 * t10) + q2 * t12;
  const S t14 = t9 * t13;
  const S t15 = S(1.71582) - S(0.0696) * t1;
  const S t16 = q2 * (t15 - S(3.2350000000000003) * q2);
  const S t17 = S(1.28307378) - (t2 + (t16 + t16));
  const S t18 = t0 * t4;
  const S t19 = S(0.0696) * t18 - S(0.009720000000000005) * t3;
  M[0] = t2 + (t6 + (t7 - t8 * (t14 + t14 + t8 * (t7 - t17)) + S(0.308) * (S(0.49819) - t19))) + S(0.16191820000000012);
  const S t21 = q2 * t19 + (S(0.0271945) * (t4 * t10) + S(0.00052488) * t3);
  M[9] = t21;
  M[19] = t21;
  const S t22 = t9 * (S(0.154) * (t15 - S(6.470000000000001) * q2) + t21 + S(0.012495)) + t8 * (S(-0.154) * t12 + t5 * t4);
  M[1] = t22;
  M[6] = t22;
  const S t23 = t8 * (t19 - S(0.99638));
  M[2] = t23;
  M[12] = t23;
  const S t24 = t2 + S(0.002287479999999999);
  M[21] = t24;
  const S t25 = t9 * (t24 - S(0.154) * t19) - t8 * t13;
  M[3] = t25;
  M[18] = t25;
  const S t26 = t3 * t1;
  const S t27 = t8 * (S(0.0107184) * t0 - t4 * (S(0.0696) * (t1 * q2) + S(0.0285945))) - S(0.0107184) * (t9 * t26);
  M[4] = t27;
  M[24] = t27;
  const S t28 = S(-0.00030000000000000165) * (t8 * t11 - t9 * t1);
  M[5] = t28;
  M[30] = t28;
  M[7] = t7 + t17;
  const S t30 = S(0.0696) * (q2 * t26) + S(0.0285945) * t3;
  M[10] = t30;
  M[25] = t30;
  const S t31 = S(-0.00030000000000000165) * t18;
  M[11] = t31;
  M[31] = t31;
  const S t32 = S(-0.0696) * t0;
  M[16] = t32;
  M[26] = t32;
  const S t33 = S(0.00030000000000000165) * t1;
  M[23] = t33;
  M[33] = t33;
  M[14] = S(6.470000000000001);
  M[28] = S(0.0285945);
  M[15] = S(0.0);
  M[17] = S(0.0);
  M[20] = S(0.0);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[32] = S(0.0);
  M[34] = S(0.0);
  M[35] = S(0.00030000000000000165);
}

// bias: 126 multiplications, 90 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S q2 = q[2];  // q3
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = t1 * qd0;
  const S t3 = t2 * qd1;
  const S t4 = qd1 * qd1;
  const S t5 = qd0 * t0;
  const S t6 = t5 * qd2;
  const S t7 = t3 * q2;
  const S t8 = t6 + t6 - (S(0.154) * (qd0 * qd0) - (t7 + t7));
  const S t9 = cos(q3);
  const S t10 = sin(q3);
  const S t11 = qd1 * t9 + t5 * t10;
  const S t12 = t9 * t3 - t11 * qd3;
  const S t13 = t2 + qd3;
  const S t14 = t11 * t13;
  const S t15 = t5 * qd1;
  const S t16 = t5 * t9 - qd1 * t10;
  const S t17 = t11 * t16;
  const S t18 = t15 + t17;
  const S t19 = cos(q5);
  const S t20 = sin(q5);
  const S t21 = cos(q4);
  const S t22 = sin(q4);
  const S t23 = t21 * t11 + t22 * t13;
  const S t24 = qd4 - t16;
  const S t25 = t11 * t22 - t21 * t13;
  const S t26 = qd5 - (t25 - qd5);
  const S t27 = t10 * t3 + qd3 * t16;
  const S t28 = t15 * t22 - t21 * t27 + qd4 * t25;
  const S t29 = (t23 * t19 - t24 * t20) * t26 - (t28 * t20 + t19 * t12);
  const S t30 = t20 * t12 - (t26 * (t23 * t20 + t24 * t19) + t28 * t19);
  const S t31 = t5 * t2;
  const S t32 = qd1 * qd2;
  const S t33 = t31 * q2 + S(9.81) * t0 - (t32 + t32);
  const S t34 = t10 * t33 + t9 * t8;
  const S t35 = t5 * t5 + t4;
  const S t36 = q2 * t35 - S(9.81) * t1;
  const S t37 = t23 * t25;
  const S t38 = S(0.00015000000000000083) * (t19 * t29 - t20 * t30) - (S(0.0696) * (t21 * t34 - t22 * t36) - (S(0.0273445) * t37 - S(0.028444499999999998) * t12));
  c[4] = t38;
  const S t39 = S(0.0004000000000000002) * (t12 - t14) + S(0.00052488) * t18 - t38;
  const S t40 = t27 + t13 * t16;
  const S t41 = t13 * t13;
  const S t42 = t23 * qd4 + (t22 * t27 + t15 * t21);
  const S t43 = S(-0.00030000000000000165) * t42;
  c[5] = t43;
  const S t44 = S(0.0005499999999999984) * (t23 * t24 + t42) - t43;
  const S t45 = t24 * t25 + t28;
  const S t46 = S(0.0278945) * t45 - (S(0.0696) * (t10 * t8 - t9 * t33) + S(0.00015000000000000083) * (t20 * t29 + t19 * t30));
  const S t47 = S(0.009720000000000005) * t36 + (S(0.0010374799999999995) * t40 + S(0.00052488) * (t41 - t16 * t16)) + (t22 * t44 - t21 * t46);
  const S t48 = t12 - t37;
  const S t49 = t23 * t23 + t24 * t24;
  const S t50 = S(0.0696) * (t21 * t48 + t22 * t49) - S(0.009720000000000005) * t18;
  const S t51 = S(0.009720000000000005) * (t41 + t11 * t11) + S(0.0696) * t45;
  const S t52 = S(0.0696) * (t22 * t48 - t21 * t49) - (S(6.470000000000001) * t36 - S(1.71582) * t35) - S(0.009720000000000005) * t40;
  c[2] = t52;
  const S t53 = S(1.71582) * t8 - (t9 * t39 + t10 * t47) - q2 * (t9 * t50 - t10 * t51 - (S(3.43164) * t3 - S(6.470000000000001) * t8)) + S(0.154) * t52;
  const S t54 = S(1.71582) * t31 - S(6.470000000000001) * t33 - (t10 * t50 + t9 * t51);
  const S t55 = S(0.009720000000000005) * t34 - (S(0.0014374799999999997) * t15 + S(0.00052488) * (t12 + t14) + S(0.0006374799999999993) * t17) - (t21 * t44 + t22 * t46);
  c[3] = t55;
  c[0] = t0 * (S(2.5103585600000002) * t3 - S(0.012495) * (t4 - t2 * t2) - t53) - t1 * (S(0.012495) * t31 + S(0.016000000000000014) * t15 + (S(0.154) * t54 - t55));
  c[1] = q2 * t54 + (t9 * t47 - t10 * t39 + S(1.71582) * t33) - (S(1.2471792800000001) * t31 - S(1.03005) * t0);
}

// mass_matrix_and_bias: 179 multiplications, 127 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S q2 = q[2];  // q3
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  const S t0 = sin(q4);
  const S t1 = cos(q4);
  const S t2 = S(0.0271945) * (t0 * t0);
  const S t3 = sin(q3);
  const S t4 = cos(q3);
  const S t5 = t3 * (S(8.748000000000002e-05) - t2);
  const S t6 = t3 * t5;
  const S t7 = t0 * t4;
  const S t8 = S(0.0696) * t7 - S(0.009720000000000005) * t3;
  const S t9 = S(0.009187480000000007) - t6;
  const S t10 = sin(q1);
  const S t11 = cos(q1);
  const S t12 = t0 * t1;
  const S t13 = t0 * t3;
  const S t14 = S(-0.009720000000000005) * t4 - S(0.0696) * t13;
  M[8] = t14;
  M[13] = t14;
  const S t15 = S(0.0271945) * (t3 * t12) - S(0.00052488) * t4 - q2 * t14;
  const S t16 = t11 * t15;
  const S t17 = S(1.71582) - S(0.0696) * t1;
  const S t18 = q2 * (S(3.2350000000000003) * q2 - t17);
  const S t19 = S(1.28307378) - (t2 - (t18 + t18));
  M[0] = t2 + (t6 + (S(0.308) * (S(0.49819) - t8) + (t9 + t10 * (t16 + t16 - t10 * (t9 - t19))))) + S(0.16191820000000012);
  const S t21 = S(0.0271945) * (t4 * t12) + S(0.00052488) * t3 + t8 * q2;
  M[9] = t21;
  M[19] = t21;
  const S t22 = t11 * (t21 + S(0.154) * (t17 - S(6.470000000000001) * q2) + S(0.012495)) + t10 * (S(-0.154) * t14 + t5 * t4);
  M[1] = t22;
  M[6] = t22;
  const S t23 = t10 * (t8 - S(0.99638));
  M[2] = t23;
  M[12] = t23;
  const S t24 = t2 + S(0.002287479999999999);
  M[21] = t24;
  const S t25 = t10 * t15 - t11 * (S(0.154) * t8 - t24);
  M[3] = t25;
  M[18] = t25;
  const S t26 = t3 * t1;
  const S t27 = t10 * (S(0.0107184) * t0 - t4 * (S(0.0696) * (q2 * t1) + S(0.0285945))) - S(0.0107184) * (t11 * t26);
  M[4] = t27;
  M[24] = t27;
  const S t28 = S(0.00030000000000000165) * (t11 * t1 - t10 * t13);
  M[5] = t28;
  M[30] = t28;
  M[7] = t9 + t19;
  const S t30 = S(0.0696) * (q2 * t26) + S(0.0285945) * t3;
  M[10] = t30;
  M[25] = t30;
  const S t31 = S(-0.00030000000000000165) * t7;
  M[11] = t31;
  M[31] = t31;
  const S t32 = S(-0.0696) * t0;
  M[16] = t32;
  M[26] = t32;
  const S t33 = S(0.00030000000000000165) * t1;
  M[23] = t33;
  M[33] = t33;
  const S t34 = t11 * qd0;
  const S t35 = t34 * qd1;
  const S t36 = qd1 * qd1;
  const S t37 = t10 * qd0;
  const S t38 = t37 * qd2;
  const S t39 = q2 * t35;
  const S t40 = t38 + t38 - (S(0.154) * (qd0 * qd0) - (t39 + t39));
  const S t41 = t4 * qd1 + t3 * t37;
  const S t42 = t4 * t35 - t41 * qd3;
  const S t43 = t34 + qd3;
  const S t44 = t41 * t43;
  const S t45 = t37 * qd1;
  const S t46 = t4 * t37 - t3 * qd1;
  const S t47 = t41 * t46;
  const S t48 = t45 + t47;
  const S t49 = cos(q5);
  const S t50 = sin(q5);
  const S t51 = t1 * t41 + t0 * t43;
  const S t52 = qd4 - t46;
  const S t53 = t0 * t41 - t1 * t43;
  const S t54 = qd5 - (t53 - qd5);
  const S t55 = t3 * t35 + qd3 * t46;
  const S t56 = t0 * t45 - t1 * t55 + qd4 * t53;
  const S t57 = (t51 * t49 - t52 * t50) * t54 - (t56 * t50 + t49 * t42);
  const S t58 = t50 * t42 - (t54 * (t51 * t50 + t52 * t49) + t56 * t49);
  const S t59 = t37 * t34;
  const S t60 = qd1 * qd2;
  const S t61 = q2 * t59 + S(9.81) * t10 - (t60 + t60);
  const S t62 = t3 * t61 + t4 * t40;
  const S t63 = t37 * t37 + t36;
  const S t64 = q2 * t63 - S(9.81) * t11;
  const S t65 = t51 * t53;
  const S t66 = S(0.00015000000000000083) * (t49 * t57 - t50 * t58) - (S(0.0696) * (t1 * t62 - t0 * t64) - (S(0.0273445) * t65 - S(0.028444499999999998) * t42));
  c[4] = t66;
  const S t67 = S(0.0004000000000000002) * (t42 - t44) + S(0.00052488) * t48 - t66;
  const S t68 = t55 + t43 * t46;
  const S t69 = t43 * t43;
  const S t70 = t51 * qd4 + (t0 * t55 + t1 * t45);
  const S t71 = S(-0.00030000000000000165) * t70;
  c[5] = t71;
  const S t72 = S(0.0005499999999999984) * (t51 * t52 + t70) - t71;
  const S t73 = t52 * t53 + t56;
  const S t74 = S(0.0278945) * t73 - (S(0.0696) * (t3 * t40 - t4 * t61) + S(0.00015000000000000083) * (t50 * t57 + t49 * t58));
  const S t75 = S(0.009720000000000005) * t64 + (S(0.0010374799999999995) * t68 + S(0.00052488) * (t69 - t46 * t46)) + (t0 * t72 - t1 * t74);
  const S t76 = t42 - t65;
  const S t77 = t51 * t51 + t52 * t52;
  const S t78 = S(0.0696) * (t1 * t76 + t0 * t77) - S(0.009720000000000005) * t48;
  const S t79 = S(0.009720000000000005) * (t69 + t41 * t41) + S(0.0696) * t73;
  const S t80 = S(0.0696) * (t0 * t76 - t1 * t77) - (S(6.470000000000001) * t64 - S(1.71582) * t63) - S(0.009720000000000005) * t68;
  c[2] = t80;
  const S t81 = S(1.71582) * t40 - (t4 * t67 + t3 * t75) - q2 * (t4 * t78 - t3 * t79 - (S(3.43164) * t35 - S(6.470000000000001) * t40)) + S(0.154) * t80;
  const S t82 = S(1.71582) * t59 - S(6.470000000000001) * t61 - (t3 * t78 + t4 * t79);
  const S t83 = S(0.009720000000000005) * t62 - (S(0.0014374799999999997) * t45 + S(0.00052488) * (t42 + t44) + S(0.0006374799999999993) * t47) - (t1 * t72 + t0 * t74);
  c[3] = t83;
  c[0] = t10 * (S(2.5103585600000002) * t35 - S(0.012495) * (t36 - t34 * t34) - t81) - t11 * (S(0.012495) * t59 + S(0.016000000000000014) * t45 + (S(0.154) * t82 - t83));
  c[1] = q2 * t82 + (t4 * t75 - t3 * t67 + S(1.71582) * t61) - (S(1.2471792800000001) * t59 - S(1.03005) * t10);
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
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  qdot[0] = qd0;
  qdot[1] = qd1;
  qdot[2] = qd2;
  qdot[3] = qd3;
  qdot[4] = qd4;
  qdot[5] = qd5;
}

// energy: 88 multiplications, 56 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using ::std::cos;
  using ::std::sin;
  const S q1 = q[1];  // q2
  const S q2 = q[2];  // q3
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  const S t0 = sin(q1);
  const S t1 = cos(q1);
  const S t2 = qd0 * t0;
  const S t3 = q2 * t2;
  const S t4 = cos(q3);
  const S t5 = sin(q3);
  const S t6 = qd0 * t1;
  const S t7 = q2 * qd1 - S(0.154) * t6;
  const S t8 = t3 * t4 - t5 * t7;
  const S t9 = t6 + qd3;
  const S t10 = t2 * t4 - t5 * qd1;
  const S t11 = t4 * qd1 + t2 * t5;
  const S t12 = qd2 - S(0.154) * t2;
  const S t13 = t4 * t7 + t3 * t5;
  const S t14 = qd4 - t10;
  const S t15 = cos(q4);
  const S t16 = sin(q4);
  const S t17 = t15 * t11 + t16 * t9;
  const S t18 = cos(q5);
  const S t19 = sin(q5);
  const S t20 = t17 * t18 - t14 * t19;
  const S t21 = t17 * t19 + t14 * t18;
  const S t22 = t16 * t11 - t15 * t9;
  const S t23 = qd5 - t22;
  const S t24 = t9 * (S(0.00052488) * t10 - S(0.00108748) * t9) + (t10 * (S(0.00052488) * t9 - S(0.00494928) * t10) - S(0.00523676) * (t11 * t11));
  const S t25 = t2 * t2;
  const S t26 = qd1 * (S(0.012495) * t6 + S(0.102205) * qd1) + (t6 * (S(0.012495) * qd1 + S(0.094805) * t6) - t24 + S(1.156425) * (t25 + qd1 * qd1)) + S(0.18101) * t25;
  const S t27 = S(0.00314175) * (t17 * t17) + (S(0.02525275) * (t20 * t20 + t21 * t21) + (S(0.0003) * (t23 * t23) + t26)) + S(0.0009) * (t22 * t22);
  const S t28 = S(1.6575) * (qd1 * t7 + t2 * t3) - S(0.5) * (S(0.00334175) * (t14 * t14) + t27) - S(3.235) * (t12 * t12 + (t3 * t3 + t7 * t7));
  const S t29 = S(0.0696) * ((t8 * t15 + t16 * t12) * t14 - t17 * t13);
  e[0] = t8 * (S(0.00972) * t9 - S(0.05832) * t10) - (t11 * (S(0.00972) * t12 + S(0.05832) * t13) - (S(0.0370066) * (qd0 * qd0) - t28)) - t29;
  const S t31 = q2 * t1 + S(0.412);
  const S t32 = t16 * (t0 * t5) - t1 * t15;
  const S t33 = S(10.5948) * (t31 - (S(0.054) * t1 + S(0.009) * (t0 * t4))) + (S(41.6925) * (t31 - S(0.39) * t1) + (S(49.05) * (S(0.412) - S(0.021) * t1) + S(27.552366)));
  e[1] = S(6.1803) * (t31 + S(0.015) * t32) + t33 - S(5.0031) * (S(0.155) * t32 - t31);
}

// body_poses: 43 multiplications, 19 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using ::std::cos;
  using ::std::sin;
  const S q0 = q[0];  // q1
  const S q1 = q[1];  // q2
  const S q2 = q[2];  // q3
  const S q3 = q[3];  // q4
  const S q4 = q[4];  // q5
  const S q5 = q[5];  // q6
  const S t0 = cos(q0);
  W[0] = t0;
  W[5] = t0;
  W[18] = t0;
  const S t1 = sin(q0);
  W[4] = t1;
  W[24] = t1;
  const S t2 = -t1;
  W[1] = t2;
  W[14] = t2;
  const S t3 = cos(q1);
  W[34] = t3;
  W[46] = t3;
  const S t4 = sin(q1);
  const S t5 = t0 * t3;
  W[12] = t5;
  W[25] = t5;
  const S t6 = t0 * t4;
  W[26] = t6;
  W[38] = t6;
  W[13] = -t6;
  const S t8 = S(-0.154) * t1;
  W[15] = t8;
  const S t9 = t1 * t3;
  W[16] = t9;
  W[29] = t9;
  const S t10 = t1 * t4;
  W[30] = t10;
  W[42] = t10;
  W[17] = -t10;
  const S t12 = S(0.154) * t0;
  W[19] = t12;
  const S t13 = -t4;
  W[20] = t13;
  W[33] = t13;
  W[21] = -t3;
  const S t15 = t8 + t6 * q2;
  W[27] = t15;
  W[39] = t15;
  W[51] = t15;
  W[63] = t15;
  W[28] = -t0;
  const S t17 = t12 + t10 * q2;
  W[31] = t17;
  W[43] = t17;
  W[55] = t17;
  W[67] = t17;
  const S t18 = t3 * q2 + S(0.412);
  W[35] = t18;
  W[47] = t18;
  W[59] = t18;
  W[71] = t18;
  const S t19 = cos(q3);
  const S t20 = sin(q3);
  const S t21 = t1 * t19 + t5 * t20;
  W[36] = t21;
  const S t22 = t1 * t20 - t5 * t19;
  const S t23 = -t22;
  W[37] = t23;
  W[50] = t23;
  const S t24 = t9 * t20 - t0 * t19;
  W[40] = t24;
  const S t25 = t0 * t20 + t9 * t19;
  W[41] = t25;
  W[54] = t25;
  const S t26 = t4 * t20;
  W[44] = -t26;
  const S t28 = t4 * t19;
  const S t29 = -t28;
  W[45] = t29;
  W[58] = t29;
  const S t30 = cos(q4);
  const S t31 = sin(q4);
  const S t32 = t21 * t30 - t6 * t31;
  W[48] = t32;
  const S t33 = t6 * t30 + t21 * t31;
  W[62] = t33;
  W[49] = -t33;
  const S t35 = t24 * t30 - t10 * t31;
  W[52] = t35;
  const S t36 = t10 * t30 + t24 * t31;
  W[66] = t36;
  W[53] = -t36;
  const S t38 = t26 * t30 + t3 * t31;
  W[56] = -t38;
  const S t40 = t3 * t30 - t26 * t31;
  W[70] = t40;
  W[57] = -t40;
  const S t42 = cos(q5);
  const S t43 = sin(q5);
  W[60] = t32 * t42 - t22 * t43;
  W[61] = -(t22 * t42 + t32 * t43);
  W[64] = t25 * t43 + t35 * t42;
  W[65] = t25 * t42 - t35 * t43;
  W[68] = -(t38 * t42 + t28 * t43);
  W[69] = t38 * t43 - t28 * t42;
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

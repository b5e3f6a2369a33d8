// puma560: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "puma560_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::puma560 {

// inverse_dynamics: 185 multiplications, 149 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S qd0 = qd[0];  // d(q1)
  const S t10 = t0 * qd0;
  const S t1 = sine[0];
  const S t11 = qd0 * t1;
  const S t12 = t10 * t11;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t13 = qdd1 - t12;
  const S qd2 = qd[2];  // d(q3)
  const S qd1 = qd[1];  // d(q2)
  const S t14 = qd2 + qd1;
  const S t5 = cosine[2];
  const S t3 = sine[1];
  const S t2 = cosine[1];
  const S t15 = t10 * t3 + t11 * t2;
  const S t4 = sine[2];
  const S t16 = t14 * t5 + t4 * t15;
  const S qd4 = qd[4];  // d(q5)
  const S t17 = qd4 + t16;
  const S t18 = t4 * t14 - t5 * t15;
  const S t6 = sine[3];
  const S t19 = t10 * t2 - t11 * t3;
  const S qd3 = qd[3];  // d(q4)
  const S t20 = qd3 + t19;
  const S t7 = cosine[3];
  const S t21 = t6 * t18 + t20 * t7;
  const S qdd2 = qdd[2];  // dd(q3)
  const S t22 = qdd1 + qdd2;
  const S t23 = t11 * qd1;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t24 = t0 * qdd0;
  const S t25 = t23 - t24;
  const S t26 = t10 * qd1;
  const S t27 = t1 * qdd0;
  const S t28 = t26 + t27;
  const S t29 = t3 * t25 - t2 * t28 - qd2 * t19;
  const S t30 = t16 * qd3 + (t4 * t22 + t5 * t29);
  const S t31 = t3 * t28 + t2 * t25 + qd2 * t15;
  const S qdd3 = qdd[3];  // dd(q4)
  const S t32 = qdd3 - t31;
  const S t33 = qd4 * t21 - (t7 * t30 - t6 * t32);
  const S t34 = t17 * t21 + t33;
  const S t35 = S(0.00288) * t34;
  const S t36 = t18 * qd3 - (t5 * t22 - t4 * t29);
  const S qdd4 = qdd[4];  // dd(q5)
  const S t37 = qdd4 - t36;
  const S t38 = t6 * t20 - t18 * t7;
  const S t39 = t21 * t38;
  const S t40 = t37 - t39;
  const S t41 = t17 * t17 + t38 * t38;
  const S t42 = S(0.00288) * (t7 * t40 - t6 * t41);
  const S t43 = t15 * t19;
  const S t44 = t22 - t43;
  const S t45 = S(0.2435) * t24 + S(9.81) * t1;
  const S t46 = qd1 * qd1;
  const S t47 = t10 * t10;
  const S t48 = S(0.0934) * t24 - (t45 + S(0.4318) * (t46 + t47));
  const S t49 = qdd1 + t12;
  const S t50 = S(9.81) * t0 - (S(0.4318) * t49 + S(0.1501) * t27);
  const S t51 = t14 * t14;
  const S t52 = t19 * t19;
  const S t53 = t2 * t48 - t3 * t50 + S(0.0203) * (t51 + t52);
  const S t54 = S(0.4331) * t44 + t53;
  const S t55 = t4 * t35 - t5 * t42 - S(1.9898291387670286) * t54;
  const S t56 = t55 + S(0.7398291387670295) * t53;
  const S t57 = t22 + t43;
  const S t58 = S(0.0203) * t57 + (t2 * t50 + t3 * t48);
  const S t59 = t15 * t15;
  const S t60 = t58 - S(0.4331) * (t51 + t59);
  const S t61 = S(0.7398291387670295) * t58 - (S(1.9898291387670286) * t60 - S(0.00288) * (t6 * t40 + t7 * t41));
  const S t62 = t2 * t56 + t3 * t61 - S(7.540157480314961) * t48;
  const S t63 = S(7.540157480314961) * t50 + (t3 * t56 - t2 * t61);
  const S t64 = t11 * t11;
  const S t65 = t26 + t28;
  const S t66 = t23 + t25;
  const S t67 = t14 * t15;
  const S t68 = t31 + t67;
  const S t69 = qd0 * qd0;
  const S t70 = S(0.4318) * t66 + S(0.1501) * t69;
  const S t71 = S(0.0203) * t68 - t70;
  const S t72 = t29 - t14 * t19;
  const S t73 = t71 - S(0.4331) * t72;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S qd5 = qd[5];  // d(q6)
  const S t74 = qd5 + (t21 + qd5);
  const S t75 = t37 * t8 + (t33 * t9 + (t38 * t8 - t17 * t9) * t74);
  const S t76 = t33 * t8 - (t37 * t9 + t74 * (t38 * t9 + t17 * t8));
  const S t77 = S(0.0006221600000000001) * t37 - S(0.00022216) * t39 + S(0.00288) * (t7 * (t5 * t54 + t4 * t73) - t6 * t60) + S(1.9999999999999998e-05) * (t8 * t75 - t9 * t76);
  tau[4] = t77;
  const S t78 = S(0.0006499999999999839) * (t36 + t18 * t20) - t77;
  const S t79 = qd4 * t38 - (t7 * t32 + t6 * t30);
  const S qdd5 = qdd[5];  // dd(q6)
  const S t80 = S(-3.9999999999999996e-05) * (t79 - qdd5);
  tau[5] = t80;
  const S t81 = S(0.00020000000000000004) * (t17 * t38 + t79) - t80;
  const S t82 = S(0.00042216000000000004) * t34 - (S(0.00288) * (t4 * t54 - t5 * t73) - S(1.9999999999999998e-05) * (t9 * t75 + t8 * t76));
  const S t83 = t6 * t81 + t7 * t82 - S(0.000749999999999984) * (t30 + t16 * t20);
  const S t84 = S(1.9898291387670286) * t73 + (t5 * t35 + t4 * t42);
  const S t85 = S(0.006820800000000002) * t68 + (t4 * t78 - t5 * t83 - S(0.4331) * t84 - S(0.004703999999999991) * (t51 - t52)) - S(0.067553278) * t72;
  const S t86 = t31 - t67;
  const S t87 = t6 * t82 - t7 * t81 - (t16 * (S(0.00010000000000000005) * t18) - S(0.001399999999999968) * t32);
  tau[3] = t87;
  const S t88 = t84 - S(0.7398291387670295) * t71;
  const S t89 = S(0.006249999999999985) * t68 + (S(0.006820800000000002) * t72 + S(0.004703999999999991) * t44) - S(6.938893903907228e-18) * t86 - t87 + S(0.0203) * t88;
  const S t90 = S(0.0934) * t62 + (t3 * t85 + t2 * t89) - S(0.4318) * (t88 - S(7.540157480314961) * t70);
  const S t91 = t2 * t85 - t3 * t89 - S(0.0934) * t63 - (S(0.001670399999999999) * (t46 - t47) + (S(0.12059663999999992) * t49 + S(0.0070992) * t66) + S(0.07312640000000004) * t65 + S(0.0254214) * t69);
  const S t92 = t0 * (S(0.001670399999999999) * t13 + S(0.0070992) * t65 - S(0.12059663999999992) * (t46 - t64) + S(0.03605184000000006) * t66 + t90) + t1 * t91;
  tau[0] = S(0.2435) * (t0 * (S(0.1044) * t13 + t62) - t1 * (t63 + S(0.1044) * (t46 + t64))) - t92 + S(1.2736872145669291) * qdd0;
  const S t94 = S(-0.0203) * t61 - (t5 * t78 + t4 * t83 + S(0.4331) * t55 - (S(0.006249999999999985) * t57 - (S(0.006820800000000002) * (t52 - t59) - S(0.004703999999999991) * t86 + S(0.067553278) * t44)));
  tau[2] = t94;
  tau[1] = S(0.03605184000000006) * t49 - (S(0.001670399999999999) * t24 - S(0.12059663999999992) * t27 - S(0.0070992) * (t47 - t64)) + S(0.07312640000000004) * t13 + S(0.1044) * t45 - (S(0.4318) * t63 - t94);
}

// mass_matrix: 92 multiplications, 76 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  S sine[4], cosine[4];
  sines_and_cosines(4, q + 1, sine, cosine);
  const S t6 = sine[3];
  const S t8 = S(0.00020216) * t6;
  const S t9 = t6 * t8;
  const S t4 = sine[2];
  const S t10 = t4 * (t9 + S(0.0001));
  const S t11 = t4 * t10;
  const S t5 = cosine[2];
  const S t12 = t6 * t5;
  const S t13 = S(0.007635112499999984) - (t11 - (t9 - S(0.000116928) * t12));
  const S t7 = cosine[3];
  const S t14 = t8 * t7;
  const S t15 = S(0.001247328) * t12 + t5 * t14;
  const S t16 = S(5.8464e-05) * t7 - t15 + S(0.010673638499999999);
  const S t3 = cosine[1];
  const S t17 = t3 * t16;
  const S t18 = S(0.3061122965) - (t9 - S(0.002494656) * t7);
  const S t2 = sine[1];
  const S t19 = t17 + t17 + t2 * (t13 - t18);
  const S t20 = t2 * t19;
  const S t21 = S(0.00288) * t7 + S(0.8617950000000001);
  const S t22 = S(0.025374999999999998) - S(0.00288) * t12;
  const S t23 = t2 * t21 - t3 * t22;
  const S t24 = t13 - t20 + S(0.8636) * t23 + S(1.674987602);
  const S t25 = t2 * t22 + t3 * t21;
  const S t1 = cosine[0];
  const S t26 = t1 * (S(0.0070992) - (t16 - t3 * t19 + S(0.4318) * t25));
  const S t27 = t18 + t20 + S(0.07312640000000004);
  const S t0 = sine[0];
  const S t28 = t4 * t6;
  M[0] = t11 + (t24 - t0 * (t26 + t26 + t0 * (t24 - t27))) + S(0.000864576) * t28 + S(1.4724995505);
  const S t30 = S(5.8464e-05) * t28 - t10 * t5;
  const S t31 = S(-0.001247328) * t28 - t4 * t14;
  M[15] = t31;
  M[20] = t31;
  const S t32 = S(0.00470400000000001) - t31;
  const S t33 = t3 * t30 - t2 * t32;
  const S t34 = t3 * t32 + t2 * t30;
  const S t35 = t1 * (S(0.2435) * (S(0.1044) - t25) - (S(0.001670399999999999) - (S(0.0934) * t25 - t34)));
  const S t36 = t0 * (S(0.2435) * (t23 + S(3.79559)) - (t33 + S(0.0934) * t23 - S(0.001243584) * t28 + S(0.233911466))) + t35;
  M[1] = t36;
  M[6] = t36;
  const S t37 = t0 * (S(0.1501) * t23 - t33) - t1 * (t34 + S(0.1501) * t25);
  M[2] = t37;
  M[12] = t37;
  const S t38 = t9 + S(0.001639999999999968);
  M[21] = t38;
  const S t39 = S(5.8464e-05) * t12 - t38;
  const S t40 = t2 * t28;
  const S t41 = t1 * (t2 * t15 - (t3 * (t39 - S(0.00043228799999999996) * t28) - S(0.001243584) * t12)) - t0 * (S(0.00043228799999999996) * t40 - (t2 * t39 + t3 * t15));
  M[3] = t41;
  M[18] = t41;
  const S t42 = t5 * t7;
  const S t43 = t6 * t3 + t2 * t42;
  const S t44 = t4 * t7;
  const S t45 = S(0.001247328) * t44 + S(0.0006421600000000001) * t4;
  const S t46 = t1 * (S(0.00043228799999999996) * (t3 * t42 - t6 * t2) - t2 * t45 - t44 * (S(0.001243584) - S(5.8464e-05) * t3));
  const S t47 = t0 * (S(0.00043228799999999996) * t43 + (t3 * t45 + t2 * (S(5.8464e-05) * t44))) - t46;
  M[4] = t47;
  M[24] = t47;
  const S t48 = S(3.9999999999999996e-05) * t7;
  M[23] = t48;
  M[33] = t48;
  const S t49 = S(3.9999999999999996e-05) * t6;
  const S t50 = t5 * t49;
  const S t51 = t1 * (t3 * t48 - t2 * t50) - t0 * (t2 * t48 + t3 * t50);
  M[5] = t51;
  M[30] = t51;
  M[7] = t24 + t27;
  const S t53 = t13 + t18;
  M[14] = t53;
  const S t54 = S(0.4318) * t23 + t53;
  M[8] = t54;
  M[13] = t54;
  const S t55 = t31 + S(-0.001243584) * t40;
  M[9] = t55;
  M[19] = t55;
  const S t56 = S(0.001247328) * t42 + S(0.0006421600000000001) * t5 - S(5.8464e-05) * t6;
  M[16] = t56;
  M[26] = t56;
  const S t57 = S(0.001243584) * t43 + t56;
  M[10] = t57;
  M[25] = t57;
  const S t58 = t4 * t49;
  M[11] = t58;
  M[17] = t58;
  M[31] = t58;
  M[32] = t58;
  M[28] = S(0.0006421600000000001);
  M[35] = S(3.9999999999999996e-05);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[34] = S(0.0);
}

// bias: 165 multiplications, 118 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t10 = qd0 * qd0;
  const S t0 = cosine[0];
  const S t11 = t0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t12 = t11 * qd1;
  const S t1 = sine[0];
  const S t13 = qd0 * t1;
  const S t14 = t13 * qd1;
  const S t15 = t11 * t13;
  const S t16 = qd1 * qd1;
  const S t17 = t11 * t11;
  const S t18 = S(9.81) * t0 - S(0.4318) * t15;
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t19 = t11 * t2 + t13 * t3;
  const S t20 = t11 * t3 - t13 * t2;
  const S t21 = t19 * t20;
  const S t22 = S(9.81) * t1 + S(0.4318) * (t16 + t17);
  const S t23 = S(0.0203) * t21 + (t3 * t18 - t2 * t22);
  const S t24 = t19 * t19;
  const S qd2 = qd[2];  // d(q3)
  const S t25 = qd1 + qd2;
  const S t26 = t25 * t25;
  const S t27 = t23 - S(0.4331) * (t24 + t26);
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t28 = t25 * t4 + t19 * t5;
  const S qd4 = qd[4];  // d(q5)
  const S t29 = qd4 + t28;
  const S qd3 = qd[3];  // d(q4)
  const S t30 = t20 + qd3;
  const S t7 = sine[3];
  const S t31 = t25 * t5 - t19 * t4;
  const S t6 = cosine[3];
  const S t32 = t7 * t30 - t6 * t31;
  const S t33 = t29 * t29 + t32 * t32;
  const S t34 = t20 * t25;
  const S t35 = qd3 * t31 - t5 * t34;
  const S t36 = t7 * t31 + t6 * t30;
  const S t37 = t32 * t36;
  const S t38 = t35 + t37;
  const S t39 = S(0.7398291387670295) * t23 - (S(1.9898291387670286) * t27 - S(0.00288) * (t6 * t33 - t7 * t38));
  const S t40 = t20 * t20;
  const S t41 = t2 * t18 + t3 * t22 - S(0.0203) * (t26 + t40);
  const S t42 = t41 + S(0.4331) * t21;
  const S t43 = S(0.00288) * (t6 * t38 + t7 * t33);
  const S t44 = t4 * t34 - t28 * qd3;
  const S t45 = t19 * t25;
  const S t46 = qd4 * t36 + (t6 * t44 - t7 * t45);
  const S t47 = t46 + t29 * t36;
  const S t48 = S(0.00288) * t47;
  const S t49 = S(1.9898291387670286) * t42 + (t4 * t43 + t5 * t48);
  const S t50 = S(0.7398291387670295) * t41 - t49;
  const S t51 = S(7.540157480314961) * t18 - (t3 * t39 + t2 * t50);
  const S t52 = S(0.8636) * t14 + S(0.1501) * t10;
  const S t53 = t52 - S(0.0406) * t45;
  const S t54 = t53 - S(0.8662) * t34;
  const S t55 = t5 * t43 - t4 * t48 + S(1.9898291387670286) * t54;
  const S t56 = qd4 * t32 + (t7 * t44 + t6 * t45);
  const S t57 = S(-3.9999999999999996e-05) * t56;
  c[5] = t57;
  const S t58 = S(0.00020000000000000004) * (t29 * t32 + t56) - t57;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S qd5 = qd[5];  // d(q6)
  const S t59 = qd5 + (t36 + qd5);
  const S t60 = t46 * t8 + (t35 * t9 - (t32 * t9 + t29 * t8) * t59);
  const S t61 = t35 * t8 - (t46 * t9 + t59 * (t32 * t8 - t29 * t9));
  const S t62 = S(0.00288) * (t4 * t54 - t5 * t42) - (S(0.00042216000000000004) * t47 + S(1.9999999999999998e-05) * (t8 * t60 - t9 * t61));
  const S t63 = S(0.000749999999999984) * (t44 - t28 * t30) + (t7 * t58 - t6 * t62);
  const S t64 = S(-1.9999999999999998e-05) * (t8 * t61 + t9 * t60) - S(0.00288) * (t27 * t7 + t6 * (t5 * t54 + t4 * t42)) - S(0.0006221600000000001) * t35 - S(0.00022216) * t37;
  c[4] = t64;
  const S t65 = S(0.0006499999999999839) * (t35 + t30 * t31) - t64;
  const S t66 = S(0.013641600000000004) * t45 - S(0.004703999999999991) * (t26 - t40) + S(0.135106556) * t34 + (S(0.4331) * t55 - (t4 * t63 - t5 * t65));
  const S t67 = t55 - S(0.7398291387670295) * t53;
  const S t68 = t28 * (S(0.00010000000000000005) * t31) + S(0.001399999999999968) * t45 + (t6 * t58 + t7 * t62);
  const S t69 = S(0.0203) * t67 - (S(0.01249999999999997) * t45 - (S(0.013641600000000004) * t34 + S(0.004703999999999991) * t21) + t68);
  const S t70 = S(0.0254214) * t10 + (S(0.14625280000000007) * t12 + (S(0.0141984) * t14 + S(0.12059663999999992) * t15 + S(0.001670399999999999) * (t16 - t17))) + (S(0.0934) * t51 - (t3 * t66 + t2 * t69));
  const S t71 = t2 * t39 - t3 * t50 + S(7.540157480314961) * t22;
  const S t72 = t13 * t13;
  const S t73 = S(0.07210368000000011) * t14 - (S(0.001670399999999999) * t15 - S(0.0141984) * t12 + S(0.12059663999999992) * (t16 - t72));
  const S t74 = S(0.2435) * (t0 * (S(0.1044) * t15 - t71) + t1 * (t51 + S(0.1044) * (t16 + t72)));
  c[0] = t1 * t70 - t0 * (S(0.4318) * (S(7.540157480314961) * t52 + t67) - (t3 * t69 - t2 * t66 - S(0.0934) * t71) + t73) - t74;
  const S t76 = S(0.006820800000000002) * (t24 - t40) + S(0.07380327799999997) * t21 - (S(0.4331) * t49 + (t4 * t65 + t5 * t63)) - S(0.0203) * t39;
  c[2] = t76;
  c[1] = S(1.024164) * t1 - (S(0.03707455999999998) * t15 - S(0.0070992) * (t17 - t72)) - (S(0.4318) * t51 - t76);
  c[3] = -t68;
}

// mass_matrix_and_bias: 257 multiplications, 194 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t6 = sine[3];
  const S t10 = S(0.00020216) * t6;
  const S t11 = t6 * t10;
  const S t4 = sine[2];
  const S t12 = t4 * (t11 + S(0.0001));
  const S t13 = t4 * t12;
  const S t5 = cosine[2];
  const S t14 = t6 * t5;
  const S t15 = S(0.007635112499999984) - (t13 - (t11 - S(0.000116928) * t14));
  const S t7 = cosine[3];
  const S t16 = t10 * t7;
  const S t17 = S(0.001247328) * t14 + t5 * t16;
  const S t18 = S(5.8464e-05) * t7 - t17 + S(0.010673638499999999);
  const S t3 = cosine[1];
  const S t19 = t3 * t18;
  const S t20 = S(0.3061122965) - (t11 - S(0.002494656) * t7);
  const S t2 = sine[1];
  const S t21 = t19 + t19 + t2 * (t15 - t20);
  const S t22 = t2 * t21;
  const S t23 = S(0.00288) * t7 + S(0.8617950000000001);
  const S t24 = S(0.025374999999999998) - S(0.00288) * t14;
  const S t25 = t2 * t23 - t3 * t24;
  const S t26 = t15 - t22 + S(0.8636) * t25 + S(1.674987602);
  const S t27 = t2 * t24 + t3 * t23;
  const S t1 = cosine[0];
  const S t28 = t1 * (S(0.0070992) - (t18 - t3 * t21 + S(0.4318) * t27));
  const S t29 = t20 + t22 + S(0.07312640000000004);
  const S t0 = sine[0];
  const S t30 = t4 * t6;
  M[0] = t13 + (t26 - t0 * (t28 + t28 + t0 * (t26 - t29))) + S(0.000864576) * t30 + S(1.4724995505);
  const S t32 = S(5.8464e-05) * t30 - t12 * t5;
  const S t33 = S(-0.001247328) * t30 - t4 * t16;
  M[15] = t33;
  M[20] = t33;
  const S t34 = S(0.00470400000000001) - t33;
  const S t35 = t3 * t32 - t2 * t34;
  const S t36 = t3 * t34 + t2 * t32;
  const S t37 = t1 * (S(0.2435) * (S(0.1044) - t27) - (S(0.001670399999999999) - (S(0.0934) * t27 - t36)));
  const S t38 = t0 * (S(0.2435) * (t25 + S(3.79559)) - (t35 + S(0.0934) * t25 - S(0.001243584) * t30 + S(0.233911466))) + t37;
  M[1] = t38;
  M[6] = t38;
  const S t39 = t0 * (S(0.1501) * t25 - t35) - t1 * (t36 + S(0.1501) * t27);
  M[2] = t39;
  M[12] = t39;
  const S t40 = t11 + S(0.001639999999999968);
  M[21] = t40;
  const S t41 = S(5.8464e-05) * t14 - t40;
  const S t42 = t2 * t30;
  const S t43 = t1 * (t2 * t17 - (t3 * (t41 - S(0.00043228799999999996) * t30) - S(0.001243584) * t14)) - t0 * (S(0.00043228799999999996) * t42 - (t2 * t41 + t3 * t17));
  M[3] = t43;
  M[18] = t43;
  const S t44 = t5 * t7;
  const S t45 = t6 * t3 + t2 * t44;
  const S t46 = t4 * t7;
  const S t47 = S(0.001247328) * t46 + S(0.0006421600000000001) * t4;
  const S t48 = t1 * (S(0.00043228799999999996) * (t3 * t44 - t6 * t2) - t2 * t47 - t46 * (S(0.001243584) - S(5.8464e-05) * t3));
  const S t49 = t0 * (S(0.00043228799999999996) * t45 + (t3 * t47 + t2 * (S(5.8464e-05) * t46))) - t48;
  M[4] = t49;
  M[24] = t49;
  const S t50 = S(3.9999999999999996e-05) * t7;
  M[23] = t50;
  M[33] = t50;
  const S t51 = S(3.9999999999999996e-05) * t6;
  const S t52 = t5 * t51;
  const S t53 = t1 * (t3 * t50 - t2 * t52) - t0 * (t2 * t50 + t3 * t52);
  M[5] = t53;
  M[30] = t53;
  M[7] = t26 + t29;
  const S t55 = t15 + t20;
  M[14] = t55;
  const S t56 = S(0.4318) * t25 + t55;
  M[8] = t56;
  M[13] = t56;
  const S t57 = t33 + S(-0.001243584) * t42;
  M[9] = t57;
  M[19] = t57;
  const S t58 = S(0.001247328) * t44 + S(0.0006421600000000001) * t5 - S(5.8464e-05) * t6;
  M[16] = t58;
  M[26] = t58;
  const S t59 = S(0.001243584) * t45 + t58;
  M[10] = t59;
  M[25] = t59;
  const S t60 = t4 * t51;
  M[11] = t60;
  M[17] = t60;
  M[31] = t60;
  M[32] = t60;
  const S qd1 = qd[1];  // d(q2)
  const S t61 = qd1 * qd1;
  const S qd0 = qd[0];  // d(q1)
  const S t62 = t1 * qd0;
  const S t63 = t62 * t62;
  const S t64 = S(9.81) * t0 + S(0.4318) * (t61 + t63);
  const S t65 = t0 * qd0;
  const S t66 = t65 * t62;
  const S t67 = S(0.4318) * t66 - S(9.81) * t1;
  const S qd2 = qd[2];  // d(q3)
  const S t68 = qd1 + qd2;
  const S t69 = t68 * t68;
  const S t70 = t3 * t62 - t2 * t65;
  const S t71 = t70 * t70;
  const S t72 = t2 * t67 - t3 * t64 + S(0.0203) * (t69 + t71);
  const S t73 = t2 * t62 + t3 * t65;
  const S t74 = t73 * t70;
  const S t75 = t72 - S(0.4331) * t74;
  const S qd3 = qd[3];  // d(q4)
  const S t76 = t70 + qd3;
  const S t77 = t5 * t73 - t4 * t68;
  const S t78 = t6 * t76 + t7 * t77;
  const S t79 = t5 * t68 + t4 * t73;
  const S qd4 = qd[4];  // d(q5)
  const S t80 = qd4 + t79;
  const S t81 = t78 * t78 + t80 * t80;
  const S t82 = t68 * t70;
  const S t83 = t4 * t82 + qd3 * t77;
  const S t84 = t7 * t76 - t6 * t77;
  const S t85 = t78 * t84;
  const S t86 = t83 - t85;
  const S t87 = t6 * t81 - t7 * t86;
  const S t88 = t68 * t73;
  const S t89 = qd3 * t79 - t5 * t82;
  const S t90 = qd4 * t84 - (t6 * t88 + t7 * t89);
  const S t91 = t80 * t84 + t90;
  const S t92 = S(1.9898291387670286) * t75 - S(0.00288) * (t5 * t87 + t4 * t91);
  const S t93 = S(0.7398291387670295) * t72 - t92;
  const S t94 = t2 * t64 + t3 * t67 - S(0.0203) * t74;
  const S t95 = t73 * t73;
  const S t96 = t94 + S(0.4331) * (t69 + t95);
  const S t97 = S(0.7398291387670295) * t94 - (S(0.00288) * (t7 * t81 + t6 * t86) + S(1.9898291387670286) * t96);
  const S t98 = S(7.540157480314961) * t64 + (t3 * t93 - t2 * t97);
  const S t99 = S(7.540157480314961) * t67 - (t3 * t97 + t2 * t93);
  const S t100 = t65 * t65;
  const S t101 = qd0 * qd0;
  const S t102 = qd1 * t65;
  const S t103 = S(0.1501) * t101 + S(0.8636) * t102;
  const S t104 = t103 - S(0.0406) * t88;
  const S t105 = t104 - S(0.8662) * t82;
  const S t106 = S(1.9898291387670286) * t105 + S(0.00288) * (t4 * t87 - t5 * t91);
  const S t107 = S(0.7398291387670295) * t104 - t106;
  const S t108 = t6 * t89 - t7 * t88 - t78 * qd4;
  const S t109 = S(3.9999999999999996e-05) * t108;
  c[5] = t109;
  const S t110 = t109 + S(0.00020000000000000004) * (t108 - t78 * t80);
  const S qd5 = qd[5];  // d(q6)
  const S t111 = qd5 + (t84 + qd5);
  const S t9 = sine[4];
  const S t8 = cosine[4];
  const S t112 = t111 * (t78 * t9 + t80 * t8) + t83 * t9 - t90 * t8;
  const S t113 = t83 * t8 + (t90 * t9 - t111 * (t80 * t9 - t78 * t8));
  const S t114 = S(0.00288) * (t4 * t75 + t5 * t105) + (S(1.9999999999999998e-05) * (t8 * t112 - t9 * t113) - S(0.00042216000000000004) * t91);
  const S t115 = S(0.0001) * (t77 * t79) - S(0.001399999999999968) * t88 + (t7 * t110 - t6 * t114);
  c[3] = t115;
  const S t116 = t115 + (S(0.004703999999999991) * t74 + S(0.013641600000000004) * t82 - S(0.01249999999999997) * t88) - S(0.0203) * t107;
  const S t117 = t7 * t114 + t6 * t110 + S(0.000749999999999984) * (t89 + t76 * t79);
  const S t118 = S(0.0006221600000000001) * t83 + (S(1.9999999999999998e-05) * (t9 * t112 + t8 * t113) + S(0.00288) * (t6 * t96 + t7 * (t5 * t75 - t4 * t105))) - S(0.00022216) * t85;
  c[4] = t118;
  const S t119 = S(0.0006499999999999839) * (t83 + t76 * t77) + t118;
  const S t120 = S(0.135106556) * t82 - (S(0.004703999999999991) * (t69 - t71) - S(0.013641600000000004) * t88) + (t5 * t117 - t4 * t119 + S(0.4331) * t106);
  const S t121 = qd1 * t62;
  const S t122 = S(0.001670399999999999) * t66 - S(0.0141984) * t121 + S(0.12059663999999992) * (t61 - t100) - S(0.07210368000000011) * t102;
  const S t123 = t2 * t116 + t3 * t120 + S(0.0934) * t99 - (S(0.12059663999999992) * t66 + S(0.0141984) * t102 + S(0.001670399999999999) * (t61 - t63) + S(0.14625280000000007) * t121 + S(0.0254214) * t101);
  const S t124 = t1 * (S(0.4318) * (S(7.540157480314961) * t103 - t107) + (S(0.0934) * t98 - (t3 * t116 - t2 * t120)) - t122) + t0 * t123;
  c[0] = S(0.2435) * (t1 * (t98 - S(0.1044) * t66) + t0 * (t99 - S(0.1044) * (t61 + t100))) - t124;
  const S t126 = S(0.0203) * t97 - (S(0.006820800000000002) * (t71 - t95) - S(0.07380327799999997) * t74 - (S(0.4331) * t92 + (t4 * t117 + t5 * t119)));
  c[2] = t126;
  c[1] = S(0.4318) * t99 + t126 + (S(1.024164) * t0 + (S(0.0070992) * (t63 - t100) - S(0.03707455999999998) * t66));
  M[28] = S(0.0006421600000000001);
  M[35] = S(3.9999999999999996e-05);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
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

// energy: 126 multiplications, 80 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S qd2 = qd[2];  // d(q3)
  const S qd1 = qd[1];  // d(q2)
  const S t10 = qd2 + qd1;
  const S t5 = sine[2];
  const S qd0 = qd[0];  // d(q1)
  const S t0 = cosine[0];
  const S t11 = qd0 * t0;
  const S t3 = sine[1];
  const S t12 = t11 * t3;
  const S t1 = sine[0];
  const S t13 = qd0 * t1;
  const S t2 = cosine[1];
  const S t14 = t12 + t2 * t13;
  const S t4 = cosine[2];
  const S t15 = t5 * t10 - t14 * t4;
  const S t16 = t11 * t2;
  const S t17 = t16 - t3 * t13;
  const S t18 = S(0.0203) * t17 - S(0.4318) * t11;
  const S t19 = S(0.2435) * t13 + S(0.4318) * qd1;
  const S t20 = S(0.2435) * t16 - t3 * t19;
  const S t21 = S(0.0934) * t17 - t20;
  const S t22 = t4 * t18 + t5 * t21;
  const S t23 = S(0.4331) * t15 + t22;
  const S t8 = cosine[4];
  const S t24 = S(0.2435) * t12 + t2 * t19;
  const S t25 = S(0.0203) * t10 - (t24 - S(0.0934) * t14);
  const S t6 = sine[3];
  const S t26 = t4 * t21 - t5 * t18;
  const S t27 = t10 * t4 + t5 * t14;
  const S t28 = t26 + S(0.4331) * t27;
  const S t7 = cosine[3];
  const S t29 = t6 * t25 - t28 * t7;
  const S t9 = sine[4];
  const S qd3 = qd[3];  // d(q4)
  const S t30 = t17 + qd3;
  const S t31 = t6 * t30 - t15 * t7;
  const S qd4 = qd[4];  // d(q5)
  const S t32 = t27 + qd4;
  const S t33 = t31 * t8 - t32 * t9;
  const S t34 = t31 * t9 + t32 * t8;
  const S t35 = t6 * t28 + t25 * t7;
  const S t36 = t15 * t6 + t7 * t30;
  const S qd5 = qd[5];  // d(q6)
  const S t37 = t36 + qd5;
  const S t38 = qd1 * (S(0.620084) * qd1 + (S(0.269178) * t13 + S(0.023751) * t11));
  const S t39 = t10 * (S(0.08952) * t10 + S(0.0266784) * t17) + (S(0.119780928) * (t14 * t14) + t17 * (S(0.042760928) * t17 + S(0.0266784) * t10));
  const S t40 = S(0.0013) * (t30 * t30) + S(0.1424126242) * (t15 * t15 + t27 * t27) + t39;
  const S t41 = t11 * (S(1.50501635) * t11 - S(0.0070992) * t13 + S(0.023751) * qd1) - t13 * (S(0.0070992) * t11 - S(1.03118515) * t13 - S(0.269178) * qd1) + t38 + t40;
  const S t42 = S(4e-05) * (t37 * t37) + S(0.00024216) * (t33 * t33 + t34 * t34) + (S(0.0004) * (t32 * t32) + S(0.0003) * (t31 * t31 + t36 * t36) + t41);
  const S t43 = S(0.21500000000000002) * (t23 * t23 + (t35 * t35 + t29 * t29)) + S(0.5) * t42 + S(0.339562) * (t26 * t27 + t15 * t22);
  const S t44 = S(0.175) * (qd0 * qd0) + (S(0.41) * (t22 * t22 + t26 * t26 + t25 * t25) + t43);
  const S t45 = S(2.4) * (S(0.18645124) * (t11 * t11) + (t24 * t24 + t20 * t20)) + t44 + t14 * (S(0.1450848) * t11 - S(0.38112) * t24);
  e[0] = S(-0.00288) * ((t23 * t8 - t29 * t9) * t33 + (t23 * t9 + t29 * t8) * t34) - (t20 * (S(0.336) * t10 + S(0.38112) * t17) - t45);
  const S t47 = t0 * t2 - t3 * t1;
  const S t48 = t2 * t1 + t0 * t3;
  const S t49 = S(0.4318) * t1;
  const S t50 = S(0.0203) * t48 - t49;
  const S t51 = t50 + S(0.4331) * t47;
  const S t52 = S(47.088) * (t49 - S(0.07) * t47) + S(170.694) * (S(0.068) * t1 + S(0.006) * t0) - S(8.0442) * (t50 + S(0.4141) * t47) - S(3.3354) * t51;
  e[1] = S(0.8829) * (S(0.032) * (t7 * t47 - t6 * (t4 * t48)) + t51) - t52;
}

// body_poses: 63 multiplications, 30 additions, 12 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[6], cosine[6];
  sines_and_cosines(6, q, sine, cosine);
  W[0] = cosine[0];
  W[5] = cosine[0];
  W[18] = cosine[0];
  W[30] = cosine[0];
  W[4] = sine[0];
  const S t1 = sine[0];
  const S t12 = -t1;
  W[1] = t12;
  W[14] = t12;
  W[26] = t12;
  const S t0 = cosine[0];
  const S t2 = cosine[1];
  const S t13 = t0 * t2;
  W[12] = t13;
  const S t3 = sine[1];
  const S t14 = t0 * t3;
  W[13] = -t14;
  W[15] = S(-0.2435) * t1;
  const S t17 = t1 * t2;
  W[16] = t17;
  const S t18 = t1 * t3;
  W[17] = -t18;
  W[19] = S(0.2435) * t0;
  W[20] = -t3;
  W[21] = -t2;
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t23 = t14 * t4 - t13 * t5;
  W[24] = -t23;
  const S t25 = t14 * t5 + t13 * t4;
  W[38] = t25;
  W[25] = -t25;
  const S t27 = S(0.4318) * t13 - S(0.1501) * t1;
  W[27] = t27;
  const S t28 = t17 * t5 - t18 * t4;
  W[28] = t28;
  const S t29 = t18 * t5 + t17 * t4;
  W[42] = t29;
  W[29] = -t29;
  const S t31 = S(0.1501) * t0 + S(0.4318) * t17;
  W[31] = t31;
  const S t32 = t3 * t5 + t2 * t4;
  W[32] = -t32;
  const S t34 = t3 * t4 - t2 * t5;
  W[33] = t34;
  const S t35 = S(-0.4318) * t3;
  W[35] = t35;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t36 = t1 * t6 + t23 * t7;
  W[36] = -t36;
  const S t38 = t23 * t6 - t1 * t7;
  W[37] = t38;
  W[50] = t38;
  const S t39 = t27 + S(0.0203) * t23 + S(0.4331) * t25;
  W[39] = t39;
  W[51] = t39;
  W[63] = t39;
  const S t40 = t0 * t6 + t28 * t7;
  W[40] = t40;
  const S t41 = t0 * t7 - t28 * t6;
  W[41] = t41;
  W[54] = t41;
  const S t42 = t31 - S(0.0203) * t28 + S(0.4331) * t29;
  W[43] = t42;
  W[55] = t42;
  W[67] = t42;
  const S t43 = t32 * t7;
  W[44] = -t43;
  const S t45 = t32 * t6;
  W[45] = t45;
  W[58] = t45;
  W[46] = -t34;
  const S t47 = t35 + S(0.0203) * t32 - S(0.4331) * t34;
  W[47] = t47;
  W[59] = t47;
  W[71] = t47;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t48 = t36 * t8 + t25 * t9;
  W[48] = -t48;
  const S t50 = t36 * t9 - t25 * t8;
  W[49] = t50;
  const S t51 = t29 * t9 - t40 * t8;
  W[52] = -t51;
  const S t53 = t40 * t9 + t29 * t8;
  W[66] = t53;
  W[53] = -t53;
  const S t55 = t34 * t9 - t43 * t8;
  W[56] = t55;
  const S t56 = t34 * t8 + t43 * t9;
  W[57] = t56;
  const S t11 = sine[5];
  const S t10 = cosine[5];
  W[60] = t38 * t11 - t48 * t10;
  W[61] = t38 * t10 + t48 * t11;
  W[62] = -t50;
  W[64] = t41 * t11 - t51 * t10;
  W[65] = t51 * t11 + t41 * t10;
  W[68] = t45 * t11 + t55 * t10;
  W[69] = t45 * t10 - t55 * t11;
  W[70] = -t56;
  W[2] = S(0.0);
  W[3] = S(0.0);
  W[6] = S(0.0);
  W[7] = S(0.0);
  W[8] = S(0.0);
  W[9] = S(0.0);
  W[11] = S(0.0);
  W[22] = S(0.0);
  W[23] = S(0.0);
  W[34] = S(0.0);
  W[10] = S(1.0);
}

// frame_poses: 64 multiplications, 33 additions, 12 sin/cos/tan (reduced formulation).
template <class S>
void frame_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* F) {
  using detail::sines_and_cosines;
  S sine[6], cosine[6];
  sines_and_cosines(6, q, sine, cosine);
  const S t0 = sine[0];
  const S t6 = cosine[3];
  const S t1 = cosine[0];
  const S t2 = sine[1];
  const S t12 = t1 * t2;
  const S t4 = sine[2];
  const S t3 = cosine[1];
  const S t13 = t1 * t3;
  const S t5 = cosine[2];
  const S t14 = t12 * t4 - t5 * t13;
  const S t7 = sine[3];
  const S t15 = t0 * t6 - t7 * t14;
  const S t10 = sine[5];
  const S t16 = t12 * t5 + t4 * t13;
  const S t8 = sine[4];
  const S t17 = t0 * t7 + t6 * t14;
  const S t9 = cosine[4];
  const S t18 = t8 * t16 + t17 * t9;
  const S t11 = cosine[5];
  F[0] = -(t10 * t15 + t11 * t18);
  F[1] = t10 * t18 - t15 * t11;
  const S t21 = t16 * t9 - t8 * t17;
  F[2] = t21;
  F[3] = S(0.0203) * t14 - (S(0.1501) * t0 - S(0.4318) * t13) + S(0.4331) * t16 - S(-0.0562) * t21;
  const S t23 = t0 * t2;
  const S t24 = t0 * t3;
  const S t25 = t4 * t23 - t5 * t24;
  const S t26 = t7 * t25 + t6 * t1;
  const S t27 = t4 * t24 + t5 * t23;
  const S t28 = t7 * t1 - t6 * t25;
  const S t29 = t8 * t27 - t9 * t28;
  F[4] = t10 * t26 - t11 * t29;
  F[5] = t10 * t29 + t11 * t26;
  const S t32 = t8 * t28 + t9 * t27;
  F[6] = t32;
  F[7] = S(0.4331) * t27 + (S(0.0203) * t25 + (S(0.1501) * t1 + S(0.4318) * t24)) + S(0.0562) * t32;
  const S t34 = t2 * t5 + t4 * t3;
  const S t35 = t7 * t34;
  const S t36 = t6 * t34;
  const S t37 = t5 * t3 - t2 * t4;
  const S t38 = t9 * t36 + t8 * t37;
  F[8] = t10 * t35 - t11 * t38;
  F[9] = t11 * t35 + t10 * t38;
  const S t41 = t9 * t37 - t8 * t36;
  F[10] = t41;
  F[11] = S(0.0203) * t34 - S(0.4318) * t2 + S(0.4331) * t37 + S(0.0562) * t41;
}

// frame_jacobians: 59 multiplications, 24 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void frame_jacobians([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* J) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  J[7] = cosine[0];
  J[8] = cosine[0];
  const S t0 = sine[0];
  const S t10 = -t0;
  J[1] = t10;
  J[2] = t10;
  const S t4 = cosine[2];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t5 = sine[2];
  const S t11 = t4 * t2 + t3 * t5;
  const S t1 = cosine[0];
  J[3] = t1 * t11;
  const S t6 = sine[3];
  const S t13 = t1 * t6;
  const S t14 = t4 * t3 - t2 * t5;
  J[15] = t14;
  const S t7 = cosine[3];
  const S t15 = t13 * t14 + t0 * t7;
  J[4] = -t15;
  const S t8 = sine[4];
  const S t17 = t7 * t8;
  const S t9 = cosine[4];
  const S t18 = t11 * t9;
  const S t19 = t14 * t17 + t18;
  const S t20 = t6 * t8;
  J[5] = t1 * t19 - t0 * t20;
  J[9] = t0 * t11;
  const S t23 = t0 * t6;
  const S t24 = t1 * t7 - t14 * t23;
  J[10] = t24;
  J[11] = t1 * t20 + t0 * t19;
  J[16] = t11 * t6;
  const S t27 = t14 * t9;
  const S t28 = t11 * t8;
  J[17] = t27 - t7 * t28;
  const S t30 = S(0.0562) * t9 + S(0.4331);
  const S t31 = S(0.0203) - S(0.0562) * t17;
  const S t32 = t4 * t30 + t5 * t31;
  const S t33 = t2 * t32;
  const S t34 = t4 * t31 - t5 * t30;
  const S t35 = S(0.4318) - t34;
  const S t36 = t33 + t3 * t35;
  const S t37 = S(0.0562) * t20;
  const S t38 = t37 + S(0.1501);
  J[18] = -(t0 * t36 + t1 * t38);
  const S t40 = t3 * t32;
  const S t41 = t40 - t2 * t35;
  J[19] = t1 * t41;
  const S t43 = t40 + t2 * t34;
  J[20] = t1 * t43;
  const S t45 = S(0.0562) * t8;
  J[21] = -(t15 * t45);
  const S t47 = t28 - t7 * t27;
  J[22] = S(-0.0562) * (t9 * t23 + t1 * t47);
  J[24] = t1 * t36 - t0 * t38;
  J[25] = t0 * t41;
  J[26] = t0 * t43;
  J[27] = t24 * t45;
  J[28] = S(-0.0562) * (t0 * t47 - t13 * t9);
  J[31] = -t36;
  J[32] = t3 * t34 - t33;
  J[33] = t11 * t37;
  J[34] = S(-0.0562) * (t7 * t18 + t14 * t8);
  J[0] = S(0.0);
  J[6] = S(0.0);
  J[13] = S(0.0);
  J[14] = S(0.0);
  J[23] = S(0.0);
  J[29] = S(0.0);
  J[30] = S(0.0);
  J[35] = S(0.0);
  J[12] = S(1.0);
}

}  // namespace alembert::mechanisms::puma560

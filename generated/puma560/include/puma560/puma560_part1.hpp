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

// inverse_dynamics: 190 multiplications, 154 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
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
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t10 = t0 * qdd0;
  const S t11 = qd1 * qd1;
  const S t12 = t0 * qd0;
  const S t13 = t12 * t12;
  const S t14 = S(0.2435) * t10 + S(9.81) * t1 + S(0.4318) * (t11 + t13);
  const S t15 = S(0.0934) * t10 - t14;
  const S t16 = qdd0 * t1;
  const S t17 = t1 * qd0;
  const S t18 = t12 * t17;
  const S t19 = qdd1 + t18;
  const S t20 = S(0.4318) * t19 + (S(0.2435) * t16 - S(9.81) * t0);
  const S t21 = S(0.0934) * t16 - t20;
  const S t22 = t12 * t3 - t2 * t17;
  const S t23 = t12 * t2 + t3 * t17;
  const S t24 = t22 * t23;
  const S t25 = qdd1 + qdd2;
  const S t26 = t24 + t25;
  const S t27 = t3 * t21 + t15 * t2 + S(0.0203) * t26;
  const S t28 = qd1 + qd2;
  const S t29 = t28 * t28;
  const S t30 = t23 * t23;
  const S t31 = t27 - S(0.4331) * (t29 + t30);
  const S t32 = t22 + qd3;
  const S t33 = t23 * t4 - t28 * t5;
  const S t34 = t7 * t32 + t6 * t33;
  const S t35 = t28 * t4 + t23 * t5;
  const S t36 = qd4 + t35;
  const S t37 = t34 * t34 + t36 * t36;
  const S t38 = qd1 * t17;
  const S t39 = t10 - t38;
  const S t40 = qd1 * t12;
  const S t41 = t16 + t40;
  const S t42 = t2 * t39 + t3 * t41 + t22 * qd2;
  const S t43 = t25 * t4 + t5 * t42 + qd3 * t33;
  const S t44 = qdd4 + t43;
  const S t45 = t6 * t32 - t7 * t33;
  const S t46 = t34 * t45;
  const S t47 = t44 - t46;
  const S t48 = S(1.9898291387670286) * t31 - S(0.00288) * (t6 * t37 + t7 * t47) - S(0.7398291387670295) * t27;
  const S t49 = t22 * t22;
  const S t50 = t2 * t21 - t15 * t3 - S(0.0203) * (t29 + t49);
  const S t51 = t24 - t25;
  const S t52 = t50 + S(0.4331) * t51;
  const S t53 = qd3 * t35 - (t4 * t42 - t25 * t5);
  const S t54 = t3 * t39 - t2 * t41 - t23 * qd2;
  const S t55 = qdd3 + t54;
  const S t56 = t6 * t53 - t7 * t55 - qd4 * t45;
  const S t57 = t36 * t45 - t56;
  const S t58 = t7 * t37 - t6 * t47;
  const S t59 = S(1.9898291387670286) * t52 + S(0.00288) * (t5 * t57 + t4 * t58);
  const S t60 = S(0.7398291387670295) * t50 - t59;
  const S t61 = S(4.549919910974728) * t15 + (t2 * t48 + t3 * t60);
  const S t62 = t22 * t28;
  const S t63 = t42 + t62;
  const S t64 = t23 * t28;
  const S t65 = t54 - t64;
  const S t66 = qd0 * qd0;
  const S t67 = t38 - t39;
  const S t68 = S(0.4318) * t67;
  const S t69 = S(0.1501) * t66 + t68;
  const S t70 = t69 + S(0.0203) * t65;
  const S t71 = t70 - S(0.4331) * t63;
  const S t72 = S(1.9898291387670286) * t71 - S(0.00288) * (t4 * t57 - t5 * t58);
  const S t73 = qd5 + (t45 + qd5);
  const S t74 = t44 * t8 - (t56 * t9 + t73 * (t36 * t9 - t34 * t8));
  const S t75 = t44 * t9 + t73 * (t34 * t9 + t36 * t8) + t56 * t8;
  const S t76 = S(1.9999999999999998e-05) * (t8 * t74 + t9 * t75) + (S(0.0006221600000000001) * t44 - S(0.00022216) * t46 - S(0.00288) * (t31 * t7 + t6 * (t4 * t52 + t5 * t71)));
  tau[4] = t76;
  const S t77 = S(0.0006499999999999839) * (t43 + t32 * t33) + t76;
  const S t78 = S(0.00042216000000000004) * t57 + (S(1.9999999999999998e-05) * (t9 * t74 - t8 * t75) + S(0.00288) * (t5 * t52 - t4 * t71));
  const S t79 = t7 * t53 + t6 * t55 - t34 * qd4;
  const S t80 = S(3.9999999999999996e-05) * (qdd5 + t79);
  tau[5] = t80;
  const S t81 = t80 + S(0.00020000000000000004) * (t79 - t34 * t36);
  const S t82 = t6 * t78 - t7 * t81 - S(0.000749999999999984) * (t53 + t32 * t35);
  const S t83 = S(0.067553278) * t63 + (S(6.938893903907228e-18) * (t42 - t62) - (S(0.004703999999999991) * (t29 - t49) + S(0.006820800000000002) * t65)) + (S(0.4331) * t72 - (t5 * t77 + t4 * t82));
  const S t84 = t72 - S(0.7398291387670295) * t70;
  const S t85 = t6 * t81 + t7 * t78 + (S(0.00010000000000000005) * (t33 * t35) + S(0.001399999999999968) * t55);
  tau[3] = t85;
  const S t86 = t54 + t64;
  const S t87 = S(0.0203) * t84 + (t85 + (S(0.006249999999999985) * t65 + (S(0.004703999999999991) * t51 + S(0.006820800000000002) * t63) - S(6.938893903907228e-18) * t86));
  const S t88 = qdd1 - t18;
  const S t89 = t40 + t41;
  const S t90 = t68 + S(0.2435) * t66;
  const S t91 = S(0.4318) * (t84 + S(4.549919910974728) * t69 + (S(2.9902375693402323) * t90 + S(0.1044) * t89));
  const S t92 = S(4.549919910974728) * t21 - (t2 * t60 - t3 * t48);
  const S t93 = t1 * (t3 * t83 + t2 * t87 - S(0.0934) * t92 - (S(0.1044) * t90 - (S(0.03798072) * t67 - S(0.001670399999999999) * (t11 - t13) - S(0.07312640000000004) * t89)));
  const S t94 = t17 * t17;
  const S t95 = t92 - (S(2.9902375693402323) * t20 - S(0.1044) * (t11 + t94));
  const S t96 = S(0.2435) * (t1 * t95 + t0 * (t61 - (S(2.9902375693402323) * t14 + S(0.1044) * t88)) - S(3.335114173228347) * qdd0);
  const S t97 = S(0.3516590822047245) * qdd0;
  tau[0] = t0 * (S(0.0934) * t61 - (t2 * t83 - t3 * t87) - (S(0.001670399999999999) * t88 - S(0.03798072) * t89 + S(0.03605183999999939) * t67) - t91) - t93 - t96 + t97;
  const S t99 = S(0.0203) * t48 + (S(0.067553278) * t51 + (S(0.006820800000000002) * (t30 - t49) - S(0.004703999999999991) * t86) + S(0.006249999999999985) * t26 + (t4 * t77 - t5 * t82 - S(0.4331) * t59));
  tau[2] = t99;
  tau[1] = t99 + (S(0.1044) * t14 + (S(0.07312640000000004) * t88 + (S(0.03605183999999939) * t19 - (S(0.001670399999999999) * t10 + S(0.03798072) * (t13 - t94))))) - S(0.4318) * t95;
}

// mass_matrix: 93 multiplications, 80 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  S sine[4], cosine[4];
  sines_and_cosines(4, q + 1, sine, cosine);
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = S(0.00288) * t6;
  const S t9 = t8 + S(0.861795);
  const S t10 = t7 * t4;
  const S t11 = S(0.00288) * t10;
  const S t12 = S(0.025375) - t11;
  const S t13 = t2 * t9 + t12 * t3;
  const S t14 = t7 * (S(0.00020216) * t6 + S(0.001247328));
  const S t15 = t4 * t14;
  const S t16 = t8 + S(0.525795);
  const S t17 = t15 - S(0.0203) * t16;
  const S t18 = S(0.00020216) * (t7 * t7);
  const S t19 = t5 * (t18 + S(0.0001));
  const S t20 = t5 * t19;
  const S t21 = S(0.0406) * (S(0.0126875) - t11) + (t18 - t20) + S(0.0071200000000000005);
  const S t22 = S(0.2254547842) - (t18 - S(0.8662) * (t8 + S(0.0931165)));
  const S t23 = t2 * t17;
  const S t24 = t3 * (t21 - t22) - (t23 + t23);
  const S t25 = t1 * (S(0.0070992) - (S(0.4318) * t13 - (t17 + t2 * t24)));
  const S t26 = t2 * t12 - t9 * t3;
  const S t27 = S(1.306195) - t26;
  const S t28 = t3 * t24;
  const S t29 = S(0.8636) * t27 + (t21 - t28) + S(0.5469576);
  const S t30 = t22 + t28 + S(0.0731264);
  const S t31 = t7 * t5;
  const S t32 = S(0.00288) * t31;
  const S t33 = t32 + S(0.2387175);
  M[0] = S(1.345339678) - (t0 * (t25 + t25 + t0 * (t29 - t30)) - (t29 + (t20 + (S(0.487) * t33 + S(0.1868) * (S(0.058375) - t32)))));
  const S t35 = t14 * t5;
  const S t36 = S(0.0266784) - (t35 + S(-0.0934) * t16);
  const S t37 = S(0.0934) * t12 - (S(5.8464e-05) * t31 - t4 * t19);
  const S t38 = t3 * t36 - t2 * t37;
  const S t39 = t2 * t36 + t3 * t37 - S(0.2435) * t13;
  const S t40 = t0 * (S(0.269178) - (t38 - (S(0.4318) * t33 + S(0.2435) * t27))) + t1 * (t39 + S(0.023751));
  M[1] = t40;
  M[6] = t40;
  const S t41 = t1 * t39 - t0 * (t38 + S(0.2435) * t26);
  M[2] = t41;
  M[12] = t41;
  const S t42 = t18 + S(0.00164);
  M[21] = t42;
  const S t43 = S(5.8464e-05) * t10 - t42 + S(0.000268992) * t31;
  const S t44 = t3 * t31;
  const S t45 = t1 * (t3 * t15 + (S(0.001243584) * t10 - t2 * (t43 - S(0.00070128) * t31))) - t0 * (S(0.00070128) * t44 - (t2 * t15 + t3 * t43));
  M[3] = t45;
  M[18] = t45;
  const S t46 = t6 * t5;
  const S t47 = t6 * t4;
  const S t48 = S(0.000268992) * t47 - S(5.8464e-05) * t46;
  const S t49 = S(0.001247328) * t6 + S(0.00064216);
  const S t50 = S(0.000268992) * t7 - t5 * t49;
  const S t51 = t3 * t47 + t2 * t7;
  const S t52 = t0 * (t3 * t48 + t2 * t50 - S(0.00070128) * t51);
  const S t53 = t1 * (S(0.001243584) * t46 + S(0.00070128) * (t7 * t3 - t2 * t47) + (t2 * t48 - t3 * t50)) - t52;
  M[4] = t53;
  M[24] = t53;
  const S t54 = S(-4e-05) * (t0 * (t2 * t10 + t6 * t3) + t1 * (t10 * t3 - t2 * t6));
  M[5] = t54;
  M[30] = t54;
  M[7] = t29 + t30;
  const S t56 = t21 + t22;
  M[14] = t56;
  const S t57 = t56 - S(0.4318) * t26;
  M[8] = t57;
  M[13] = t57;
  const S t58 = S(-0.001243584) * t44 - t35;
  M[9] = t58;
  M[19] = t58;
  const S t59 = t4 * t49 - S(5.8464e-05) * t7;
  M[16] = t59;
  M[26] = t59;
  const S t60 = t59 + S(0.001243584) * t51;
  M[10] = t60;
  M[25] = t60;
  const S t61 = S(4e-05) * t31;
  M[11] = t61;
  M[17] = t61;
  M[31] = t61;
  M[32] = t61;
  const S t62 = -t35;
  M[15] = t62;
  M[20] = t62;
  const S t63 = S(4e-05) * t6;
  M[23] = t63;
  M[33] = t63;
  M[28] = S(0.00064216);
  M[35] = S(4e-05);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[34] = S(0.0);
}

// bias: 168 multiplications, 120 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t10 = t0 * qd0;
  const S t11 = qd0 * t1;
  const S t12 = t2 * t10 + t11 * t3;
  const S t13 = t10 * t3 - t2 * t11;
  const S t14 = t12 * t13;
  const S t15 = t10 * t11;
  const S t16 = S(0.4318) * t15 - S(9.81) * t0;
  const S t17 = qd1 * qd1;
  const S t18 = t10 * t10;
  const S t19 = S(9.81) * t1 + S(0.4318) * (t17 + t18);
  const S t20 = qd1 + qd2;
  const S t21 = t20 * t20;
  const S t22 = t13 * t13;
  const S t23 = t2 * t16 - t3 * t19 + S(0.0203) * (t21 + t22);
  const S t24 = S(0.4331) * t14 - t23;
  const S t25 = t13 + qd3;
  const S t26 = t12 * t4 - t20 * t5;
  const S t27 = t25 * t7 + t6 * t26;
  const S t28 = t20 * t4 + t12 * t5;
  const S t29 = qd4 + t28;
  const S t30 = t27 * t27 + t29 * t29;
  const S t31 = t20 * t13;
  const S t32 = t31 * t5 + qd3 * t26;
  const S t33 = t6 * t25 - t26 * t7;
  const S t34 = t33 * t27;
  const S t35 = t32 - t34;
  const S t36 = t7 * t30 - t6 * t35;
  const S t37 = t20 * t12;
  const S t38 = qd3 * t28 - t31 * t4;
  const S t39 = t33 * qd4 - (t37 * t7 + t6 * t38);
  const S t40 = t33 * t29 + t39;
  const S t41 = S(1.9898291387670286) * t24 + S(0.00288) * (t4 * t36 + t5 * t40);
  const S t42 = t41 + S(0.7398291387670295) * t23;
  const S t43 = t2 * t19 + t3 * t16 - S(0.0203) * t14;
  const S t44 = t12 * t12;
  const S t45 = t43 + S(0.4331) * (t21 + t44);
  const S t46 = S(0.7398291387670295) * t43 - (S(0.00288) * (t6 * t30 + t7 * t35) + S(1.9898291387670286) * t45);
  const S t47 = t3 * t42 - t2 * t46 + S(4.549919910974728) * t19;
  const S t48 = t2 * t42 + t3 * t46 - S(4.549919910974728) * t16;
  const S t49 = t11 * t11;
  const S t50 = t48 + (S(0.1044) * (t17 + t49) - S(2.9902375693402323) * t16);
  const S t51 = qd0 * qd0;
  const S t52 = qd1 * t11;
  const S t53 = S(0.8636) * t52;
  const S t54 = S(0.1501) * t51 + t53;
  const S t55 = S(0.0406) * t37 - t54;
  const S t56 = t55 + S(0.8662) * t31;
  const S t57 = S(1.9898291387670286) * t56 + S(0.00288) * (t4 * t40 - t5 * t36);
  const S t58 = S(0.7398291387670295) * t55 - t57;
  const S t59 = qd1 * t10;
  const S t60 = t53 + S(0.2435) * t51;
  const S t61 = t7 * t38 - t37 * t6 - qd4 * t27;
  const S t62 = S(3.9999999999999996e-05) * t61;
  c[5] = t62;
  const S t63 = t62 + S(0.00020000000000000004) * (t61 - t29 * t27);
  const S t64 = qd5 + (t33 + qd5);
  const S t65 = t64 * (t27 * t9 + t29 * t8) + t32 * t9 - t39 * t8;
  const S t66 = t32 * t8 + (t39 * t9 - t64 * (t29 * t9 - t27 * t8));
  const S t67 = S(0.00288) * (t5 * t24 + t56 * t4) - (S(1.9999999999999998e-05) * (t8 * t65 - t9 * t66) - S(0.00042216000000000004) * t40);
  const S t68 = t6 * t63 + t7 * t67 + (S(0.00010000000000000005) * (t26 * t28) - S(0.001399999999999968) * t37);
  c[3] = t68;
  const S t69 = t68 + (S(0.004703999999999991) * t14 + S(0.013641600000000004) * t31 - S(0.01249999999999997) * t37) + S(0.0203) * t58;
  const S t70 = t6 * t67 - t7 * t63 - S(0.000749999999999984) * (t38 + t25 * t28);
  const S t71 = S(0.0006221600000000001) * t32 + (S(1.9999999999999998e-05) * (t9 * t65 + t8 * t66) + S(0.00288) * (t7 * t45 - t6 * (t4 * t24 - t56 * t5))) - S(0.00022216) * t34;
  c[4] = t71;
  const S t72 = S(0.0006499999999999839) * (t32 + t25 * t26) + t71;
  const S t73 = S(0.135106556) * t31 - (S(0.004703999999999991) * (t21 - t22) - S(0.013641600000000004) * t37) - (t4 * t70 + t5 * t72 + S(0.4331) * t57);
  const S t74 = S(0.001670399999999999) * t15 + S(0.07596144) * t59 - S(0.07210367999999878) * t52 - (S(0.0934) * t47 - (t3 * t69 - t2 * t73));
  const S t75 = t1 * (t2 * t69 + t3 * t73 - S(0.0934) * t48 - (S(0.1044) * t60 + (S(0.14625280000000007) * t59 - (S(0.07596144) * t52 - S(0.001670399999999999) * (t17 - t18)))));
  const S t76 = t0 * (S(0.4318) * (t58 + S(4.549919910974728) * t54 + (S(0.2088) * t59 + S(2.9902375693402323) * t60)) - t74) + t75;
  c[0] = S(0.2435) * (t0 * (t47 + (S(2.9902375693402323) * t19 - S(0.1044) * t15)) - t1 * t50) - t76;
  const S t78 = S(0.0203) * t46 - (S(0.006820800000000002) * (t22 - t44) - S(0.07380327799999997) * t14 + (S(0.4331) * t41 + (t5 * t70 - t4 * t72)));
  c[2] = t78;
  c[1] = S(0.1044) * t19 - (S(0.037074560000000645) * t15 + S(0.03798072) * (t18 - t49)) + t78 - S(0.4318) * t50;
}

// mass_matrix_and_bias: 261 multiplications, 200 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t10 = S(0.00020216) * (t6 * t6);
  const S t11 = t4 * (t10 + S(0.0001));
  const S t12 = t4 * t11;
  const S t13 = t4 * t6;
  const S t14 = S(0.00288) * t13;
  const S t15 = t14 + S(0.2387175);
  const S t16 = t6 * t5;
  const S t17 = S(0.00288) * t16;
  const S t18 = S(0.0406) * (S(0.0126875) - t17) + (t10 - t12) + S(0.0071200000000000005);
  const S t19 = S(0.00288) * t7;
  const S t20 = S(0.2254547842) - (t10 - S(0.8662) * (t19 + S(0.0931165)));
  const S t21 = t6 * (S(0.00020216) * t7 + S(0.001247328));
  const S t22 = t5 * t21;
  const S t23 = t19 + S(0.525795);
  const S t24 = t22 - S(0.0203) * t23;
  const S t25 = t3 * t24;
  const S t26 = t2 * (t18 - t20) - (t25 + t25);
  const S t27 = t2 * t26;
  const S t28 = S(0.025375) - t17;
  const S t29 = t19 + S(0.861795);
  const S t30 = t3 * t28 - t2 * t29;
  const S t31 = S(1.306195) - t30;
  const S t32 = t18 - t27 + S(0.8636) * t31 + S(0.5469576);
  const S t33 = t2 * t28 + t3 * t29;
  const S t34 = (S(0.0070992) - (S(0.4318) * t33 - (t24 + t3 * t26))) * t1;
  const S t35 = t20 + t27 + S(0.0731264);
  M[0] = t12 + (S(0.487) * t15 + S(0.1868) * (S(0.058375) - t14)) + t32 - t0 * (t34 + t34 + t0 * (t32 - t35)) + S(1.345339678);
  const S t37 = t4 * t21;
  const S t38 = S(0.0934) * t23 - t37 + S(0.0266784);
  const S t39 = S(5.8464e-05) * t13 - t11 * t5 - S(0.0934) * t28;
  const S t40 = t3 * t38 - t2 * t39 - S(0.2435) * t33;
  const S t41 = t2 * t38 + t3 * t39;
  const S t42 = t1 * (t40 + S(0.023751)) + t0 * (S(0.269178) - (t41 - (S(0.4318) * t15 + S(0.2435) * t31)));
  M[1] = t42;
  M[6] = t42;
  const S t43 = t1 * t40 - t0 * (t41 + S(0.2435) * t30);
  M[2] = t43;
  M[12] = t43;
  const S t44 = t10 + S(0.00164);
  M[21] = t44;
  const S t45 = S(5.8464e-05) * t16 - t44;
  const S t46 = t13 * t2;
  const S t47 = t0 * (S(0.00070128) * t46 - (t3 * t22 + t2 * (S(0.000268992) * t13 + t45)));
  const S t48 = t1 * (t2 * t22 - (t3 * (t45 - S(0.000432288) * t13) - S(0.001243584) * t16)) - t47;
  M[3] = t48;
  M[18] = t48;
  const S t49 = S(0.001247328) * t7 + S(0.00064216);
  const S t50 = t4 * t49 - S(0.000268992) * t6;
  const S t51 = t4 * t7;
  const S t52 = t5 * t7;
  const S t53 = S(5.8464e-05) * t51 - S(0.000268992) * t52;
  const S t54 = t6 * t3 + t2 * t52;
  const S t55 = t1 * (t3 * t53 - t2 * t50 - (S(0.001243584) * t51 - S(0.00070128) * (t3 * t52 - t6 * t2)));
  const S t56 = t0 * (t3 * t50 + t2 * t53 + S(0.00070128) * t54) - t55;
  M[4] = t56;
  M[24] = t56;
  const S t57 = S(-4e-05) * (t1 * (t16 * t2 - t7 * t3) + t0 * (t2 * t7 + t16 * t3));
  M[5] = t57;
  M[30] = t57;
  M[7] = t32 + t35;
  const S t59 = t18 + t20;
  M[14] = t59;
  const S t60 = t59 - S(0.4318) * t30;
  M[8] = t60;
  M[13] = t60;
  const S t61 = S(-0.001243584) * t46 - t37;
  M[9] = t61;
  M[19] = t61;
  const S t62 = t5 * t49 - S(5.8464e-05) * t6;
  M[16] = t62;
  M[26] = t62;
  const S t63 = S(0.001243584) * t54 + t62;
  M[10] = t63;
  M[25] = t63;
  const S t64 = S(4e-05) * t13;
  M[11] = t64;
  M[17] = t64;
  M[31] = t64;
  M[32] = t64;
  const S t65 = -t37;
  M[15] = t65;
  M[20] = t65;
  const S t66 = S(4e-05) * t7;
  M[23] = t66;
  M[33] = t66;
  const S t67 = t1 * qd0;
  const S t68 = t0 * qd0;
  const S t69 = t2 * t67 + t3 * t68;
  const S t70 = t3 * t67 - t2 * t68;
  const S t71 = t69 * t70;
  const S t72 = t67 * t68;
  const S t73 = S(0.4318) * t72 - S(9.81) * t1;
  const S t74 = qd1 * qd1;
  const S t75 = t67 * t67;
  const S t76 = S(9.81) * t0 + S(0.4318) * (t74 + t75);
  const S t77 = qd1 + qd2;
  const S t78 = t77 * t77;
  const S t79 = t70 * t70;
  const S t80 = t2 * t73 - t3 * t76 + S(0.0203) * (t78 + t79);
  const S t81 = S(0.4331) * t71 - t80;
  const S t82 = t70 + qd3;
  const S t83 = t5 * t69 - t4 * t77;
  const S t84 = t6 * t82 + t7 * t83;
  const S t85 = t5 * t77 + t4 * t69;
  const S t86 = qd4 + t85;
  const S t87 = t84 * t84 + t86 * t86;
  const S t88 = t77 * t70;
  const S t89 = t4 * t88 + qd3 * t83;
  const S t90 = t7 * t82 - t6 * t83;
  const S t91 = t90 * t84;
  const S t92 = t89 - t91;
  const S t93 = t6 * t87 - t7 * t92;
  const S t94 = t77 * t69;
  const S t95 = qd3 * t85 - t5 * t88;
  const S t96 = t90 * qd4 - (t6 * t94 + t7 * t95);
  const S t97 = t90 * t86 + t96;
  const S t98 = S(1.9898291387670286) * t81 + S(0.00288) * (t5 * t93 + t4 * t97);
  const S t99 = t98 + S(0.7398291387670295) * t80;
  const S t100 = t2 * t76 + t3 * t73 - S(0.0203) * t71;
  const S t101 = t69 * t69;
  const S t102 = t100 + S(0.4331) * (t78 + t101);
  const S t103 = S(0.7398291387670295) * t100 - (S(0.00288) * (t7 * t87 + t6 * t92) + S(1.9898291387670286) * t102);
  const S t104 = t3 * t99 - t2 * t103 + S(4.549919910974728) * t76;
  const S t105 = t2 * t99 + t3 * t103 - S(4.549919910974728) * t73;
  const S t106 = t68 * t68;
  const S t107 = t105 + (S(0.1044) * (t74 + t106) - S(2.9902375693402323) * t73);
  const S t108 = qd0 * qd0;
  const S t109 = qd1 * t68;
  const S t110 = S(0.8636) * t109;
  const S t111 = S(0.1501) * t108 + t110;
  const S t112 = S(0.0406) * t94 - t111;
  const S t113 = t112 + S(0.8662) * t88;
  const S t114 = S(1.9898291387670286) * t113 + S(0.00288) * (t5 * t97 - t4 * t93);
  const S t115 = S(0.7398291387670295) * t112 - t114;
  const S t116 = qd1 * t67;
  const S t117 = t110 + S(0.2435) * t108;
  const S t118 = t6 * t95 - t7 * t94 - qd4 * t84;
  const S t119 = S(3.9999999999999996e-05) * t118;
  c[5] = t119;
  const S t120 = t119 + S(0.00020000000000000004) * (t118 - t86 * t84);
  const S t121 = qd5 + (t90 + qd5);
  const S t122 = t121 * (t84 * t9 + t86 * t8) + t89 * t9 - t96 * t8;
  const S t123 = t89 * t8 + (t96 * t9 - t121 * (t86 * t9 - t84 * t8));
  const S t124 = S(0.00288) * (t4 * t81 + t5 * t113) - (S(1.9999999999999998e-05) * (t8 * t122 - t9 * t123) - S(0.00042216000000000004) * t97);
  const S t125 = t7 * t120 + t6 * t124 + (S(0.00010000000000000005) * (t83 * t85) - S(0.001399999999999968) * t94);
  c[3] = t125;
  const S t126 = t125 + (S(0.004703999999999991) * t71 + S(0.013641600000000004) * t88 - S(0.01249999999999997) * t94) + S(0.0203) * t115;
  const S t127 = t7 * t124 - t6 * t120 - S(0.000749999999999984) * (t95 + t82 * t85);
  const S t128 = S(0.0006221600000000001) * t89 + (S(1.9999999999999998e-05) * (t9 * t122 + t8 * t123) + S(0.00288) * (t6 * t102 - t7 * (t5 * t81 - t4 * t113))) - S(0.00022216) * t91;
  c[4] = t128;
  const S t129 = S(0.0006499999999999839) * (t89 + t82 * t83) + t128;
  const S t130 = S(0.135106556) * t88 - (S(0.004703999999999991) * (t78 - t79) - S(0.013641600000000004) * t94) - (t5 * t127 + t4 * t129 + S(0.4331) * t114);
  const S t131 = S(0.001670399999999999) * t72 + S(0.07596144) * t116 - S(0.07210367999999878) * t109 - (S(0.0934) * t104 - (t3 * t126 - t2 * t130));
  const S t132 = t0 * (t2 * t126 + t3 * t130 - S(0.0934) * t105 - (S(0.1044) * t117 + (S(0.14625280000000007) * t116 - (S(0.07596144) * t109 - S(0.001670399999999999) * (t74 - t75)))));
  const S t133 = t1 * (S(0.4318) * (t115 + S(4.549919910974728) * t111 + (S(0.2088) * t116 + S(2.9902375693402323) * t117)) - t131) + t132;
  c[0] = S(0.2435) * (t1 * (t104 + (S(2.9902375693402323) * t76 - S(0.1044) * t72)) - t0 * t107) - t133;
  const S t135 = S(0.0203) * t103 - (S(0.006820800000000002) * (t79 - t101) - S(0.07380327799999997) * t71 + (S(0.4331) * t98 + (t4 * t127 - t5 * t129)));
  c[2] = t135;
  c[1] = S(0.1044) * t76 - (S(0.037074560000000645) * t72 + S(0.03798072) * (t75 - t106)) + t135 - S(0.4318) * t107;
  M[28] = S(0.00064216);
  M[35] = S(4e-05);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
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

// energy: 126 multiplications, 80 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(q1)
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S qd3 = qd[3];  // d(q4)
  const S qd4 = qd[4];  // d(q5)
  const S qd5 = qd[5];  // d(q6)
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t10 = qd2 + qd1;
  const S t11 = qd0 * t0;
  const S t12 = t11 * t3;
  const S t13 = qd0 * t1;
  const S t14 = t12 + t2 * t13;
  const S t15 = t5 * t10 - t14 * t4;
  const S t16 = t11 * t2;
  const S t17 = t16 - t3 * t13;
  const S t18 = S(0.0203) * t17 - S(0.4318) * t11;
  const S t19 = S(0.2435) * t13 + S(0.4318) * qd1;
  const S t20 = S(0.2435) * t16 - t3 * t19;
  const S t21 = S(0.0934) * t17 - t20;
  const S t22 = t4 * t18 + t5 * t21;
  const S t23 = S(0.4331) * t15 + t22;
  const S t24 = S(0.2435) * t12 + t2 * t19;
  const S t25 = S(0.0203) * t10 - (t24 - S(0.0934) * t14);
  const S t26 = t4 * t21 - t5 * t18;
  const S t27 = t10 * t4 + t5 * t14;
  const S t28 = t26 + S(0.4331) * t27;
  const S t29 = t6 * t25 - t28 * t7;
  const S t30 = t17 + qd3;
  const S t31 = t6 * t30 - t15 * t7;
  const S t32 = t27 + qd4;
  const S t33 = t31 * t8 - t32 * t9;
  const S t34 = t31 * t9 + t32 * t8;
  const S t35 = t6 * t28 + t25 * t7;
  const S t36 = t15 * t6 + t7 * t30;
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
  const S t0 = cosine[0];
  W[0] = t0;
  W[5] = t0;
  W[18] = t0;
  W[30] = t0;
  const S t1 = sine[0];
  W[4] = t1;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t10 = cosine[5];
  const S t11 = sine[5];
  const S t12 = -t1;
  W[1] = t12;
  W[14] = t12;
  W[26] = t12;
  const S t13 = t0 * t2;
  W[12] = t13;
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
  const S t1 = cosine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = sine[5];
  const S t11 = cosine[5];
  const S t12 = t1 * t2;
  const S t13 = t1 * t3;
  const S t14 = t12 * t4 - t5 * t13;
  const S t15 = t0 * t6 - t7 * t14;
  const S t16 = t12 * t5 + t4 * t13;
  const S t17 = t0 * t7 + t6 * t14;
  const S t18 = t8 * t16 + t17 * t9;
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

// frame_jacobians: 63 multiplications, 24 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void frame_jacobians([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* J) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t0 = sine[0];
  const S t1 = cosine[0];
  J[7] = t1;
  J[8] = t1;
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = -t0;
  J[1] = t10;
  J[2] = t10;
  const S t11 = t4 * t2 + t3 * t5;
  J[3] = t1 * t11;
  const S t13 = t1 * t6;
  const S t14 = t4 * t3 - t2 * t5;
  J[15] = t14;
  const S t15 = t13 * t14 + t0 * t7;
  J[4] = -t15;
  const S t17 = t7 * t8;
  const S t18 = t14 * t17 + t11 * t9;
  const S t19 = t6 * t8;
  J[5] = t1 * t18 - t0 * t19;
  J[9] = t0 * t11;
  const S t22 = t0 * t6;
  const S t23 = t1 * t7 - t14 * t22;
  J[10] = t23;
  J[11] = t1 * t19 + t0 * t18;
  J[16] = t11 * t6;
  const S t26 = t11 * t8;
  J[17] = t14 * t9 - t7 * t26;
  const S t28 = S(0.0562) * t9 + S(0.4331);
  const S t29 = S(0.0203) - S(0.0562) * t17;
  const S t30 = t4 * t28 + t5 * t29;
  const S t31 = t2 * t30;
  const S t32 = t4 * t29 - t5 * t28;
  const S t33 = S(0.4318) - t32;
  const S t34 = t31 + t3 * t33;
  const S t35 = S(0.0562) * t19 + S(0.1501);
  J[18] = -(t0 * t34 + t1 * t35);
  const S t37 = t3 * t30;
  const S t38 = t37 - t2 * t33;
  J[19] = t1 * t38;
  const S t40 = t37 + t2 * t32;
  J[20] = t1 * t40;
  J[21] = S(-0.0562) * (t15 * t8);
  const S t43 = t26 - t9 * (t14 * t7);
  J[22] = S(-0.0562) * (t9 * t22 + t1 * t43);
  J[24] = t1 * t34 - t0 * t35;
  J[25] = t0 * t38;
  J[26] = t0 * t40;
  J[27] = S(0.0562) * (t8 * t23);
  J[28] = S(-0.0562) * (t0 * t43 - t13 * t9);
  J[31] = -t34;
  J[32] = t3 * t32 - t31;
  J[33] = S(0.0562) * (t11 * t19);
  J[34] = S(-0.0562) * (t9 * (t11 * t7) + t14 * t8);
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

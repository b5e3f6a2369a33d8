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

// inverse_dynamics: 184 multiplications, 148 additions, 10 sin/cos/tan (reduced formulation; relative error 3.5e-16 where it was measured).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t1 = sine[0];
  const S t10 = qd0 * t1;
  const S t0 = cosine[0];
  const S t11 = qd0 * t0;
  const S qd1 = qd[1];  // d(q2)
  const S t12 = qd1 * t11;
  const S t13 = qd1 * t10;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t14 = qdd0 * t0;
  const S t15 = qdd0 * t1;
  const S t16 = t12 + t15;
  const S t17 = t13 - t14;
  const S t3 = cosine[1];
  const S t2 = sine[1];
  const S t18 = t11 * t3 - t10 * t2;
  const S t19 = t11 * t2 + t3 * t10;
  const S qd2 = qd[2];  // d(q3)
  const S t20 = t17 * t2 - t3 * t16 - qd2 * t18;
  const S t21 = qd2 + qd1;
  const S t22 = qd1 * qd1;
  const S t23 = t16 * t2 + t17 * t3 + qd2 * t19;
  const S t24 = t11 * t10;
  const S t25 = t11 * t11;
  const S t26 = t17 + t13;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t27 = t21 * t4 + t5 * t19;
  const S t28 = t5 * t21 - t19 * t4;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t29 = qdd1 + t24;
  const S qdd2 = qdd[2];  // dd(q3)
  const S t30 = qdd2 + qdd1;
  const S qd3 = qd[3];  // d(q4)
  const S t31 = qd3 * t27 + (t5 * t30 + t20 * t4);
  const S t32 = qd3 + t18;
  const S t33 = qd3 * t28 - (t30 * t4 - t5 * t20);
  const S t34 = S(0.2435) * t14 + S(9.81) * t1;
  const S t35 = S(0.0934) * t14 - (t34 + S(0.4318) * (t22 + t25));
  const S t36 = t18 * t18;
  const S t37 = t20 - t21 * t18;
  const S t38 = t21 * t21;
  const S t39 = t19 * t21;
  const S t40 = t19 * t18;
  const S t41 = S(0.4318) * t29 + S(0.1501) * t15 - S(9.81) * t0;
  const S qdd3 = qdd[3];  // dd(q4)
  const S t42 = qdd3 - t23;
  const S t43 = t39 + t23;
  const S t44 = t19 * t19;
  const S t45 = qd0 * qd0;
  const S t46 = S(0.4318) * t26 + S(0.1501) * t45;
  const S t47 = S(0.0203) * t43 - t46;
  const S qd4 = qd[4];  // d(q5)
  const S t48 = qd4 + t27;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t49 = t6 * t28 + t32 * t7;
  const S t50 = t6 * t32 - t28 * t7;
  const S t51 = qd4 * t49 - (t31 * t7 - t6 * t42);
  const S qd5 = qd[5];  // d(q6)
  const S t52 = qd5 + (qd5 + t49);
  const S t53 = qd4 * t50 - (t42 * t7 + t6 * t31);
  const S t54 = t47 - S(0.4331) * t37;
  const S qdd4 = qdd[4];  // dd(q5)
  const S t55 = qdd4 - t33;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t56 = t52 * (t50 * t8 - t48 * t9) + t9 * t51 + t55 * t8;
  const S t57 = t8 * t51 - (t55 * t9 + t52 * (t50 * t9 + t8 * t48));
  const S t58 = t48 * t49 + t51;
  const S t59 = t30 - t40;
  const S t60 = t30 + t40;
  const S t61 = t50 * t49;
  const S t62 = t48 * t48 + t50 * t50;
  const S t63 = S(0.0203) * t60 + (t35 * t2 - t3 * t41);
  const S t64 = S(0.0203) * (t38 + t36) + (t3 * t35 + t41 * t2);
  const S t65 = t64 + S(0.4331) * t59;
  const S t66 = t63 - S(0.4331) * (t44 + t38);
  const S t67 = t55 - t61;
  const S t68 = S(0.00062216) * t55 - S(0.00022216) * t61 - S(0.00288) * (t6 * t66 - (t65 * t4 + t5 * t54) * t7) - S(2e-05) * (t9 * t57 - t56 * t8);
  tau[4] = t68;
  const S t69 = S(0.00288) * (t5 * t65 - t4 * t54) - S(0.00042216) * t58 - S(2e-05) * (t56 * t9 + t8 * t57);
  const S t70 = t6 * t62 - t67 * t7;
  const S t71 = S(0.7398291387670284) * t63 + S(0.00288) * (t62 * t7 + t6 * t67) - S(1.9898291387670284) * t66;
  const S t72 = S(1.9898291387670284) * t54 + S(0.00288) * (t4 * t58 - t5 * t70);
  const S t73 = S(1.9898291387670284) * t65 - S(0.00288) * (t70 * t4 + t5 * t58);
  const S qdd5 = qdd[5];  // dd(q6)
  const S t74 = S(4e-05) * (qdd5 - t53);
  tau[5] = t74;
  const S t75 = S(0.0002) * (t50 * t48 + t53) - t74;
  const S t76 = S(0.00065) * (t28 * t32 + t33) - t68;
  const S t77 = t69 * t7 - t6 * t75 + S(0.00075) * (t31 + t27 * t32);
  const S t78 = S(0.0014) * t42 - S(0.0001) * (t27 * t28) - (t6 * t69 + t75 * t7);
  tau[3] = t78;
  const S t79 = S(0.067553278) * t37 - (S(0.0068208) * t43 - S(0.004704) * (t38 - t36)) + (S(0.4331) * t72 - (t5 * t76 + t4 * t77));
  const S t80 = t72 - S(0.7398291387670284) * t47;
  const S t81 = S(0.004704) * t59 + S(0.0068208) * t37 + S(0.00625) * t43 - t78 + S(0.0203) * t80;
  const S t82 = S(0.7398291387670284) * t64 - t73;
  const S t83 = t3 * t82 + t71 * t2 - S(7.540157480314961) * t35;
  const S t84 = t3 * t71 - t82 * t2 + S(7.540157480314961) * t41;
  const S t85 = S(0.4318) * (S(7.540157480314961) * t46 - t80) + (t3 * t81 - t79 * t2 + S(0.0934) * t83);
  const S t86 = t10 * t10;
  const S t87 = qdd1 - t24;
  const S t88 = t12 + t16;
  const S t89 = S(0.0731264) * t88 + (S(0.12059664) * t29 + S(0.0070992) * t26 + S(0.0016704) * (t22 - t25)) + S(0.0254214) * t45 + (t3 * t79 + t81 * t2 - S(0.0934) * t84);
  const S t90 = S(0.2435) * (t0 * (t83 + S(0.1044) * t87) + (t84 - S(0.1044) * (t22 + t86)) * t1);
  tau[0] = t0 * (S(0.12059664) * (t22 - t86) - (S(0.0016704) * t87 + S(0.0070992) * t88) - S(0.03605184) * t26 - t85) + t89 * t1 + t90 + S(1.2736872145669291) * qdd0;
  const S t92 = S(0.0203) * t71;
  const S t93 = S(0.067553278) * t59 - (S(0.0068208) * (t44 - t36) - S(0.004704) * (t39 - t23)) - S(0.00625) * t60 - (S(0.4331) * t73 + (t5 * t77 - t4 * t76)) + t92;
  tau[1] = S(0.0731264) * t87 + (S(0.03605184) * t29 + (S(0.12059664) * t15 - S(0.0016704) * t14 + S(0.0070992) * (t25 - t86))) + S(0.1044) * t34 - (t93 - S(0.4318) * t84);
  tau[2] = -t93;
}

// mass_matrix: 91 multiplications, 76 additions, 8 sin/cos/tan (reduced formulation; relative error 1.9e-16 where it was measured).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  S sine[4], cosine[4];
  sines_and_cosines(4, q + 1, sine, cosine);
  const S t6 = sine[3];
  const S t8 = S(0.00020216) * t6;
  const S t9 = t6 * t8;
  const S t7 = cosine[3];
  const S t10 = t8 * t7;
  const S t5 = sine[2];
  const S t11 = t5 * (t9 + S(0.0001));
  const S t4 = cosine[2];
  const S t12 = t6 * t4;
  const S t13 = t4 * t10 + S(0.001247328) * t12;
  const S t14 = t5 * t11;
  const S t15 = S(0.0076351125) - (S(0.000116928) * t12 + (t14 - t9));
  const S t16 = S(0.002494656) * t7 - t9 + S(0.3061122965);
  const S t17 = S(5.8464e-05) * t7 - t13 + S(0.0106736385);
  const S t18 = S(0.00288) * t7 + S(0.861795);
  const S t19 = S(0.025375) - S(0.00288) * t12;
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t20 = t2 * (t17 + t17) - (t16 - t15) * t3;
  const S t21 = t2 * t19 - t18 * t3;
  const S t22 = t18 * t2 + t19 * t3;
  const S t1 = cosine[0];
  const S t23 = t1 * (S(0.0070992) - (S(0.4318) * t22 + (t17 - t2 * t20)));
  const S t24 = t20 * t3;
  const S t25 = S(1.674987602) - (S(0.8636) * t21 + (t24 - t15));
  const S t26 = t16 + t24 + S(0.0731264);
  const S t27 = t5 * t6;
  const S t28 = S(-0.001247328) * t27 - t5 * t10;
  M[15] = t28;
  M[20] = t28;
  const S t29 = S(0.004704) - t28;
  const S t30 = t11 * t4 - S(5.8464e-05) * t27;
  const S t0 = sine[0];
  M[0] = t25 - ((t25 - t26) * t0 + (t23 + t23)) * t0 + t14 + S(0.000864576) * t27 + S(1.4724995505);
  const S t32 = t30 * t2 + t29 * t3;
  const S t33 = t30 * t3 - t2 * t29;
  const S t34 = t4 * t7;
  const S t35 = t5 * t7;
  const S t36 = S(0.001247328) * t35 + S(0.00064216) * t5;
  const S t37 = t34 * t3 + t6 * t2;
  const S t38 = t1 * (S(0.000432288) * (t2 * t34 - t6 * t3) - t36 * t3 - (S(0.001243584) - S(5.8464e-05) * t2) * t35);
  const S t39 = t0 * (S(5.8464e-05) * t35 * t3 + S(0.000432288) * t37 + t2 * t36) - t38;
  M[4] = t39;
  M[24] = t39;
  const S t40 = S(0.001247328) * t34 + S(0.00064216) * t4 - S(5.8464e-05) * t6;
  M[16] = t40;
  M[26] = t40;
  const S t41 = t27 * t3;
  const S t42 = t9 + S(0.00164);
  M[21] = t42;
  const S t43 = t42 - S(5.8464e-05) * t12;
  const S t44 = t1 * (t13 * t3 + S(0.001243584) * t12 + t2 * (t43 + S(0.000432288) * t27)) - t0 * (S(0.000432288) * t41 + t43 * t3 - t2 * t13);
  M[3] = t44;
  M[18] = t44;
  const S t45 = S(4e-05) * (t1 * (t2 * t7 - t12 * t3) - t0 * (t12 * t2 + t3 * t7));
  M[5] = t45;
  M[30] = t45;
  const S t46 = t1 * (S(0.0016704) - (S(0.0934) * t22 + t33) - S(0.2435) * (S(0.1044) - t22));
  const S t47 = (t32 - S(0.1501) * t21) * t0 + t1 * (t33 - S(0.1501) * t22);
  M[2] = t47;
  M[12] = t47;
  const S t48 = t0 * (S(0.2435) * (S(3.79559) - t21) - (S(0.233911466) - (S(0.001243584) * t27 + (t32 + S(0.0934) * t21)))) - t46;
  M[1] = t48;
  M[6] = t48;
  const S t49 = t40 + S(0.001243584) * t37;
  M[10] = t49;
  M[25] = t49;
  const S t50 = t28 + S(-0.001243584) * t41;
  M[9] = t50;
  M[19] = t50;
  const S t51 = S(4e-05) * t27;
  M[11] = t51;
  M[17] = t51;
  M[31] = t51;
  M[32] = t51;
  const S t52 = S(4e-05) * t7;
  M[23] = t52;
  M[33] = t52;
  const S t53 = t16 + t15;
  M[14] = t53;
  const S t54 = t53 - S(0.4318) * t21;
  M[8] = t54;
  M[13] = t54;
  M[7] = t25 + t26;
  M[28] = S(0.00064216);
  M[35] = S(4e-05);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[34] = S(0.0);
}

// bias: 165 multiplications, 118 additions, 10 sin/cos/tan (reduced formulation; relative error 6.9e-16 where it was measured).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t0 = cosine[0];
  const S t10 = qd0 * t0;
  const S t1 = sine[0];
  const S t11 = qd0 * t1;
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t12 = t10 * t2 + t3 * t11;
  const S t13 = t10 * t3 - t11 * t2;
  const S t14 = t10 * t10;
  const S qd2 = qd[2];  // d(q3)
  const S qd1 = qd[1];  // d(q2)
  const S t15 = qd2 + qd1;
  const S t16 = qd1 * qd1;
  const S t17 = t15 * t13;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t18 = t15 * t4 + t5 * t12;
  const S t19 = t5 * t15 - t12 * t4;
  const S t20 = t10 * t11;
  const S qd3 = qd[3];  // d(q4)
  const S t21 = t17 * t4 - qd3 * t18;
  const S t22 = qd3 + t13;
  const S t23 = t12 * t15;
  const S t24 = t15 * t15;
  const S t25 = qd3 * t19 - t5 * t17;
  const S t26 = S(9.81) * t0 - S(0.4318) * t20;
  const S t27 = t13 * t13;
  const S t28 = t12 * t13;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t29 = t6 * t22 - t19 * t7;
  const S t30 = t6 * t19 + t22 * t7;
  const S t31 = S(9.81) * t1 + S(0.4318) * (t16 + t14);
  const S t32 = qd0 * qd0;
  const S qd5 = qd[5];  // d(q6)
  const S t33 = qd5 + (qd5 + t30);
  const S qd4 = qd[4];  // d(q5)
  const S t34 = qd4 + t18;
  const S t35 = qd4 * t30 + (t21 * t7 - t6 * t23);
  const S t36 = qd1 * t11;
  const S t37 = S(0.8636) * t36 + S(0.1501) * t32;
  const S t38 = S(0.0406) * t23 - t37;
  const S t39 = qd4 * t29 + (t21 * t6 + t23 * t7);
  const S t40 = t38 + S(0.8662) * t17;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  const S t41 = t33 * (t29 * t9 - t34 * t8) + t35 * t8 - t9 * t25;
  const S t42 = t33 * (t29 * t8 + t9 * t34) - t25 * t8 - t35 * t9;
  const S t43 = t35 + t34 * t30;
  const S t44 = t29 * t30;
  const S t45 = t12 * t12;
  const S t46 = t34 * t34 + t29 * t29;
  const S t47 = t26 * t2 + t3 * t31 - S(0.0203) * (t24 + t27);
  const S t48 = t47 + S(0.4331) * t28;
  const S t49 = S(0.0203) * t28 + (t3 * t26 - t31 * t2);
  const S t50 = S(0.4331) * (t45 + t24) - t49;
  const S t51 = t25 + t44;
  const S t52 = S(-4e-05) * t39;
  c[5] = t52;
  const S t53 = S(0.0002) * (t29 * t34 + t39) - t52;
  const S t54 = t51 * t7 + t6 * t46;
  const S t55 = S(1.9898291387670284) * t50 + S(0.7398291387670284) * t49 + S(0.00288) * (t46 * t7 - t6 * t51);
  const S t56 = S(0.00288) * (t6 * t50 + (t5 * t40 - t4 * t48) * t7) - (S(0.00062216) * t25 - S(2e-05) * (t42 * t8 + t9 * t41) + S(0.00022216) * t44);
  c[4] = t56;
  const S t57 = S(0.00042216) * t43 + S(0.00288) * (t4 * t40 + t5 * t48) + S(2e-05) * (t8 * t41 - t9 * t42);
  const S t58 = S(0.00065) * (t19 * t22 + t25) - t56;
  const S t59 = S(0.00288) * (t4 * t54 + t5 * t43) + S(1.9898291387670284) * t48;
  const S t60 = S(0.00288) * (t4 * t43 - t5 * t54) + S(1.9898291387670284) * t40;
  const S t61 = S(0.00075) * (t21 - t18 * t22) + (t6 * t53 + t57 * t7);
  const S t62 = t6 * t57 - t53 * t7 - (S(0.0001) * (t18 * t19) + S(0.0014) * t23);
  c[3] = t62;
  const S t63 = t60 - S(0.7398291387670284) * t38;
  const S t64 = S(0.0203) * t63 + (S(0.0125) * t23 - (S(0.004704) * t28 + S(0.0136416) * t17) - t62);
  const S t65 = S(0.004704) * (t24 - t27) - S(0.0136416) * t23 - S(0.135106556) * t17 + (t4 * t61 - t5 * t58 + S(0.4331) * t60);
  const S t66 = S(-0.0203) * t55 - (S(0.4331) * t59 + (t5 * t61 + t4 * t58) - (S(0.0068208) * (t45 - t27) + S(0.073803278) * t28));
  c[2] = t66;
  const S t67 = S(0.7398291387670284) * t47 - t59;
  const S t68 = t55 * t2 - t3 * t67 + S(7.540157480314961) * t31;
  const S t69 = S(7.540157480314961) * t26 - (t67 * t2 + t3 * t55);
  const S t70 = S(0.0934) * t68 + (t3 * t64 - t65 * t2) + S(0.4318) * (S(7.540157480314961) * t37 - t63);
  const S t71 = t11 * t11;
  const S t72 = qd1 * t10;
  const S t73 = S(0.0934) * t69 + (t3 * t65 + t64 * t2) + (S(0.0016704) * (t16 - t14) + (S(0.0141984) * t36 + S(0.12059664) * t20) + S(0.1462528) * t72 + S(0.0254214) * t32);
  const S t74 = t0 * (S(0.07210368) * t36 - (S(0.12059664) * (t16 - t71) - (S(0.0141984) * t72 - S(0.0016704) * t20)) + t70) - t1 * t73;
  c[0] = S(0.2435) * ((t68 - S(0.1044) * t20) * t0 - (t69 + S(0.1044) * (t16 + t71)) * t1) - t74;
  c[1] = t66 - S(0.4318) * t69 - (S(0.03707456) * t20 - S(0.0070992) * (t14 - t71) - S(1.024164) * t1);
}

// mass_matrix_and_bias: 256 multiplications, 194 additions, 10 sin/cos/tan (reduced formulation; relative error 6.9e-16 where it was measured).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t1 = cosine[0];
  const S t10 = qd0 * t1;
  const S t0 = sine[0];
  const S t11 = qd0 * t0;
  const S t3 = sine[1];
  const S t2 = cosine[1];
  const S t12 = t10 * t3 + t2 * t11;
  const S t13 = t10 * t2 - t11 * t3;
  const S t14 = t10 * t10;
  const S qd2 = qd[2];  // d(q3)
  const S qd1 = qd[1];  // d(q2)
  const S t15 = qd2 + qd1;
  const S t16 = qd1 * qd1;
  const S t17 = t15 * t13;
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t18 = t15 * t4 + t5 * t12;
  const S t19 = t5 * t15 - t12 * t4;
  const S t20 = t10 * t11;
  const S qd3 = qd[3];  // d(q4)
  const S t21 = t17 * t4 - qd3 * t18;
  const S t22 = qd3 + t13;
  const S t23 = t12 * t15;
  const S t24 = t15 * t15;
  const S t25 = qd3 * t19 - t5 * t17;
  const S t26 = S(9.81) * t1 - S(0.4318) * t20;
  const S t27 = t13 * t13;
  const S t28 = t12 * t13;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t29 = t6 * t22 - t19 * t7;
  const S t30 = t6 * t19 + t22 * t7;
  const S t31 = S(9.81) * t0 + S(0.4318) * (t16 + t14);
  const S t32 = qd0 * qd0;
  const S qd5 = qd[5];  // d(q6)
  const S t33 = qd5 + (qd5 + t30);
  const S t34 = S(0.00020216) * t6;
  const S qd4 = qd[4];  // d(q5)
  const S t35 = qd4 + t18;
  const S t36 = qd4 * t30 + (t21 * t7 - t6 * t23);
  const S t37 = qd1 * t11;
  const S t38 = S(0.8636) * t37 + S(0.1501) * t32;
  const S t39 = S(0.0406) * t23 - t38;
  const S t40 = qd4 * t29 + (t21 * t6 + t23 * t7);
  const S t41 = t6 * t34;
  const S t42 = t34 * t7;
  const S t43 = t39 + S(0.8662) * t17;
  const S t44 = t5 * (t41 + S(0.0001));
  const S t45 = t12 * t12;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  const S t46 = t33 * (t29 * t9 - t35 * t8) + t36 * t8 - t9 * t25;
  const S t47 = t33 * (t29 * t8 + t9 * t35) - t25 * t8 - t36 * t9;
  const S t48 = t36 + t35 * t30;
  const S t49 = t29 * t30;
  const S t50 = t35 * t35 + t29 * t29;
  const S t51 = t5 * t44;
  const S t52 = t26 * t3 + t2 * t31 - S(0.0203) * (t24 + t27);
  const S t53 = t52 + S(0.4331) * t28;
  const S t54 = S(0.0203) * t28 + (t2 * t26 - t31 * t3);
  const S t55 = S(0.4331) * (t45 + t24) - t54;
  const S t56 = t6 * t4;
  const S t57 = t4 * t42 + S(0.001247328) * t56;
  const S t58 = S(5.8464e-05) * t7 - t57 + S(0.0106736385);
  const S t59 = S(0.002494656) * t7 - t41 + S(0.3061122965);
  const S t60 = S(0.0076351125) - (S(0.000116928) * t56 + (t51 - t41));
  const S t61 = t25 + t49;
  const S t62 = t61 * t7 + t6 * t50;
  const S t63 = S(1.9898291387670284) * t55 + S(0.7398291387670284) * t54 + S(0.00288) * (t50 * t7 - t6 * t61);
  const S t64 = S(0.00288) * (t6 * t55 + (t5 * t43 - t4 * t53) * t7) - (S(0.00062216) * t25 - S(2e-05) * (t47 * t8 + t9 * t46) + S(0.00022216) * t49);
  c[4] = t64;
  const S t65 = S(0.00042216) * t48 + S(0.00288) * (t4 * t43 + t5 * t53) + S(2e-05) * (t8 * t46 - t9 * t47);
  const S t66 = S(0.00065) * (t19 * t22 + t25) - t64;
  const S t67 = S(0.00288) * (t4 * t62 + t5 * t48) + S(1.9898291387670284) * t53;
  const S t68 = S(0.00288) * (t4 * t48 - t5 * t62) + S(1.9898291387670284) * t43;
  const S t69 = S(-4e-05) * t40;
  c[5] = t69;
  const S t70 = S(0.0002) * (t29 * t35 + t40) - t69;
  const S t71 = S(0.00075) * (t21 - t18 * t22) + (t6 * t70 + t65 * t7);
  const S t72 = t6 * t65 - t70 * t7 - (S(0.0001) * (t18 * t19) + S(0.0014) * t23);
  c[3] = t72;
  const S t73 = S(0.00288) * t7 + S(0.861795);
  const S t74 = S(0.025375) - S(0.00288) * t56;
  const S t75 = t5 * t6;
  const S t76 = t2 * t74 - t73 * t3;
  const S t77 = t73 * t2 + t74 * t3;
  const S t78 = t2 * (t58 + t58) - (t59 - t60) * t3;
  const S t79 = t1 * (S(0.0070992) - (S(0.4318) * t77 + (t58 - t2 * t78)));
  const S t80 = t78 * t3;
  const S t81 = S(1.674987602) - (S(0.8636) * t76 + (t80 - t60));
  const S t82 = t59 + t80 + S(0.0731264);
  const S t83 = S(-0.001247328) * t75 - t5 * t42;
  M[15] = t83;
  M[20] = t83;
  const S t84 = S(0.7398291387670284) * t52 - t67;
  const S t85 = t68 - S(0.7398291387670284) * t39;
  const S t86 = S(0.0203) * t85 + (S(0.0125) * t23 - (S(0.004704) * t28 + S(0.0136416) * t17) - t72);
  const S t87 = S(0.004704) * (t24 - t27) - S(0.0136416) * t23 - S(0.135106556) * t17 + (t4 * t71 - t5 * t66 + S(0.4331) * t68);
  const S t88 = S(-0.0203) * t63 - (S(0.4331) * t67 + (t5 * t71 + t4 * t66) - (S(0.0068208) * (t45 - t27) + S(0.073803278) * t28));
  c[2] = t88;
  const S t89 = t44 * t4 - S(5.8464e-05) * t75;
  const S t90 = S(0.004704) - t83;
  const S t91 = t63 * t3 - t2 * t84 + S(7.540157480314961) * t31;
  const S t92 = S(7.540157480314961) * t26 - (t84 * t3 + t2 * t63);
  const S t93 = S(0.0934) * t91 + (t2 * t86 - t87 * t3) + S(0.4318) * (S(7.540157480314961) * t38 - t85);
  const S t94 = t89 * t2 + t90 * t3;
  const S t95 = t89 * t3 - t2 * t90;
  const S t96 = t11 * t11;
  const S t97 = t4 * t7;
  const S t98 = t5 * t7;
  const S t99 = S(0.001247328) * t98 + S(0.00064216) * t5;
  const S t100 = qd1 * t10;
  const S t101 = S(0.0934) * t92 + (t2 * t87 + t86 * t3) + (S(0.0016704) * (t16 - t14) + (S(0.0141984) * t37 + S(0.12059664) * t20) + S(0.1462528) * t100 + S(0.0254214) * t32);
  const S t102 = t1 * (S(0.07210368) * t37 - (S(0.12059664) * (t16 - t96) - (S(0.0141984) * t100 - S(0.0016704) * t20)) + t93) - t0 * t101;
  c[0] = S(0.2435) * ((t91 - S(0.1044) * t20) * t1 - (t92 + S(0.1044) * (t16 + t96)) * t0) - t102;
  c[1] = t88 - S(0.4318) * t92 - (S(0.03707456) * t20 - S(0.0070992) * (t14 - t96) - S(1.024164) * t0);
  const S t105 = t1 * (S(0.000432288) * (t2 * t97 - t6 * t3) - t99 * t3 - (S(0.001243584) - S(5.8464e-05) * t2) * t98);
  const S t106 = t97 * t3 + t6 * t2;
  const S t107 = t0 * (S(5.8464e-05) * t98 * t3 + S(0.000432288) * t106 + t2 * t99) - t105;
  M[4] = t107;
  M[24] = t107;
  const S t108 = S(0.001247328) * t97 + S(0.00064216) * t4 - S(5.8464e-05) * t6;
  M[16] = t108;
  M[26] = t108;
  const S t109 = t41 + S(0.00164);
  M[21] = t109;
  const S t110 = t109 - S(5.8464e-05) * t56;
  const S t111 = t75 * t3;
  const S t112 = t1 * (t57 * t3 + S(0.001243584) * t56 + t2 * (t110 + S(0.000432288) * t75)) - t0 * (S(0.000432288) * t111 + t110 * t3 - t2 * t57);
  M[3] = t112;
  M[18] = t112;
  const S t113 = S(4e-05) * (t1 * (t2 * t7 - t56 * t3) - t0 * (t56 * t2 + t3 * t7));
  M[5] = t113;
  M[30] = t113;
  const S t114 = t108 + S(0.001243584) * t106;
  M[10] = t114;
  M[25] = t114;
  M[0] = t81 - ((t81 - t82) * t0 + (t79 + t79)) * t0 + t51 + S(0.000864576) * t75 + S(1.4724995505);
  const S t116 = t1 * (S(0.0016704) - (S(0.0934) * t77 + t95) - S(0.2435) * (S(0.1044) - t77));
  const S t117 = (t94 - S(0.1501) * t76) * t0 + t1 * (t95 - S(0.1501) * t77);
  M[2] = t117;
  M[12] = t117;
  const S t118 = t0 * (S(0.2435) * (S(3.79559) - t76) - (S(0.233911466) - (S(0.001243584) * t75 + (t94 + S(0.0934) * t76)))) - t116;
  M[1] = t118;
  M[6] = t118;
  M[7] = t81 + t82;
  const S t120 = t83 + S(-0.001243584) * t111;
  M[9] = t120;
  M[19] = t120;
  const S t121 = S(4e-05) * t75;
  M[11] = t121;
  M[17] = t121;
  M[31] = t121;
  M[32] = t121;
  const S t122 = S(4e-05) * t7;
  M[23] = t122;
  M[33] = t122;
  const S t123 = t59 + t60;
  M[14] = t123;
  const S t124 = t123 - S(0.4318) * t76;
  M[8] = t124;
  M[13] = t124;
  M[28] = S(0.00064216);
  M[35] = S(4e-05);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
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

// energy: 126 multiplications, 80 additions, 10 sin/cos/tan (reduced formulation; relative error 9.7e-16 where it was measured).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S qd0 = qd[0];  // d(q1)
  const S t0 = cosine[0];
  const S t10 = qd0 * t0;
  const S t1 = sine[0];
  const S t11 = qd0 * t1;
  const S qd1 = qd[1];  // d(q2)
  const S t12 = S(0.2435) * t11 + S(0.4318) * qd1;
  const S t2 = sine[1];
  const S t13 = t10 * t2;
  const S t3 = cosine[1];
  const S t14 = t13 + t3 * t11;
  const S t15 = t10 * t3;
  const S t16 = t15 - t11 * t2;
  const S t17 = S(0.2435) * t15 - t12 * t2;
  const S t18 = S(0.2435) * t13 + t3 * t12;
  const S qd2 = qd[2];  // d(q3)
  const S t19 = qd2 + qd1;
  const S t20 = S(0.0934) * t16 - t17;
  const S t21 = S(0.0203) * t16 - S(0.4318) * t10;
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t22 = t4 * t19 - t14 * t5;
  const S t23 = t19 * t5 + t4 * t14;
  const S qd3 = qd[3];  // d(q4)
  const S t24 = qd3 + t16;
  const S t25 = S(0.0013) * (t24 * t24) + S(0.1424126242) * (t22 * t22 + t23 * t23);
  const S t26 = t20 * t5 - t4 * t21;
  const S t27 = t5 * t21 + t4 * t20;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t28 = t6 * t24 - t22 * t7;
  const S t29 = t6 * t22 + t24 * t7;
  const S qd4 = qd[4];  // d(q5)
  const S t30 = qd4 + t23;
  const S t31 = S(0.0203) * t19 - (t18 - S(0.0934) * t14);
  const S t32 = t26 + S(0.4331) * t23;
  const S t33 = S(0.0003) * (t29 * t29 + t28 * t28) + S(0.0004) * (t30 * t30);
  const S qd5 = qd[5];  // d(q6)
  const S t34 = qd5 + t29;
  const S t9 = sine[4];
  const S t8 = cosine[4];
  const S t35 = t28 * t9 + t8 * t30;
  const S t36 = t28 * t8 - t30 * t9;
  const S t37 = qd1 * (S(0.620084) * qd1 + (S(0.269178) * t11 + S(0.023751) * t10));
  const S t38 = t10 * (S(1.50501635) * t10 - S(0.0070992) * t11 + S(0.023751) * qd1) - (S(0.0070992) * t10 - S(1.03118515) * t11 - S(0.269178) * qd1) * t11 + t37;
  const S t39 = t19 * (S(0.08952) * t19 + S(0.0266784) * t16) + (S(0.119780928) * (t14 * t14) + (S(0.042760928) * t16 + S(0.0266784) * t19) * t16) + t25 + t38 + t33;
  const S t40 = t6 * t32 + t31 * t7;
  const S t41 = t6 * t31 - t32 * t7;
  const S t42 = S(0.4331) * t22 + t27;
  const S t43 = S(0.5) * (S(4e-05) * (t34 * t34) + S(0.00024216) * (t35 * t35 + t36 * t36) + t39) + S(0.215) * (t42 * t42 + (t40 * t40 + t41 * t41));
  const S t44 = S(0.00288) * ((t8 * t42 - t41 * t9) * t36 + (t9 * t42 + t41 * t8) * t35);
  const S t45 = S(2.4) * (S(0.18645124) * (t10 * t10) + (t18 * t18 + t17 * t17));
  const S t46 = t43 + S(0.339562) * (t22 * t27 + t23 * t26) + S(0.41) * (t27 * t27 + t26 * t26 + t31 * t31) + S(0.175) * (qd0 * qd0) + t45;
  e[0] = t46 - t14 * (S(0.38112) * t18 - S(0.1450848) * t10) - (S(0.336) * t19 + S(0.38112) * t16) * t17 - t44;
  const S t48 = S(0.4318) * t1;
  const S t49 = t0 * t3 - t1 * t2;
  const S t50 = t3 * t1 + t0 * t2;
  const S t51 = S(0.0203) * t50 - t48;
  const S t52 = t51 + S(0.4331) * t49;
  const S t53 = S(47.088) * (t48 - S(0.07) * t49) + S(170.694) * (S(0.068) * t1 + S(0.006) * t0) - S(8.0442) * (S(0.4141) * t49 + t51) - S(3.3354) * t52;
  e[1] = S(0.8829) * (S(0.032) * (t49 * t7 - t6 * (t50 * t5)) + t52) - t53;
}

// body_poses: 63 multiplications, 30 additions, 12 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
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
  const S t2 = cosine[1];
  const S t0 = cosine[0];
  const S t12 = t2 * t0;
  W[12] = t12;
  const S t3 = sine[1];
  const S t13 = t0 * t3;
  const S t1 = sine[0];
  const S t14 = t1 * t3;
  const S t15 = t2 * t1;
  W[16] = t15;
  const S t5 = cosine[2];
  const S t4 = sine[2];
  const S t16 = t5 * t12 - t13 * t4;
  W[24] = t16;
  const S t17 = t14 * t4 - t5 * t15;
  const S t18 = t5 * t13 + t12 * t4;
  W[38] = t18;
  const S t19 = t5 * t3 + t2 * t4;
  const S t20 = t15 * t4 + t5 * t14;
  W[42] = t20;
  const S t21 = t2 * t5 - t3 * t4;
  W[46] = t21;
  const S t22 = S(0.1501) * t0 + S(0.4318) * t15;
  W[31] = t22;
  const S t23 = S(0.4318) * t12 - S(0.1501) * t1;
  W[27] = t23;
  const S t7 = cosine[3];
  const S t6 = sine[3];
  const S t24 = t7 * t16 - t6 * t1;
  W[36] = t24;
  const S t25 = t6 * t0 - t7 * t17;
  W[40] = t25;
  const S t26 = t1 * t7 + t6 * t16;
  const S t27 = S(-0.0203) * t16 + t23 + S(0.4331) * t18;
  W[39] = t27;
  W[51] = t27;
  W[63] = t27;
  const S t28 = S(0.4331) * t20 + (S(0.0203) * t17 + t22);
  W[43] = t28;
  W[55] = t28;
  W[67] = t28;
  const S t29 = t19 * t7;
  const S t30 = t6 * t17 + t0 * t7;
  W[41] = t30;
  W[54] = t30;
  const S t31 = t6 * t19;
  W[45] = t31;
  W[58] = t31;
  const S t9 = cosine[4];
  const S t8 = sine[4];
  const S t32 = t24 * t9 - t8 * t18;
  W[48] = t32;
  const S t33 = t8 * t24 + t18 * t9;
  W[62] = t33;
  const S t34 = t8 * t20 - t25 * t9;
  const S t35 = t8 * t25 + t20 * t9;
  W[66] = t35;
  const S t36 = t9 * t29 + t8 * t21;
  const S t37 = t21 * t9 - t8 * t29;
  W[70] = t37;
  W[44] = -t29;
  W[57] = -t37;
  W[29] = -t20;
  W[53] = -t35;
  W[25] = -t18;
  W[49] = -t33;
  W[28] = -t17;
  const S t45 = S(-0.4318) * t3;
  W[35] = t45;
  const S t46 = S(0.0203) * t19 + t45 + S(0.4331) * t21;
  W[47] = t46;
  W[59] = t46;
  W[71] = t46;
  W[32] = -t19;
  W[33] = -t21;
  W[20] = -t3;
  W[56] = -t36;
  W[52] = -t34;
  const S t11 = cosine[5];
  const S t10 = sine[5];
  W[61] = -(t11 * t26 + t10 * t32);
  W[60] = t11 * t32 - t10 * t26;
  const S t54 = -t26;
  W[37] = t54;
  W[50] = t54;
  W[64] = t30 * t10 - t11 * t34;
  W[65] = t34 * t10 + t30 * t11;
  W[68] = t31 * t10 - t11 * t36;
  W[69] = t31 * t11 + t36 * t10;
  const S t59 = -t1;
  W[1] = t59;
  W[14] = t59;
  W[26] = t59;
  W[15] = S(-0.2435) * t1;
  W[13] = -t13;
  W[17] = -t14;
  W[19] = S(0.2435) * t0;
  W[21] = -t2;
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

// frame_poses: 64 multiplications, 33 additions, 12 sin/cos/tan (reduced formulation; relative error 2.5e-16 where it was measured).
template <class S>
void frame_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* F) {
  using detail::sines_and_cosines;
  S sine[6], cosine[6];
  sines_and_cosines(6, q, sine, cosine);
  const S t1 = cosine[0];
  const S t2 = sine[1];
  const S t12 = t1 * t2;
  const S t3 = cosine[1];
  const S t13 = t3 * t1;
  const S t0 = sine[0];
  const S t14 = t3 * t0;
  const S t15 = t0 * t2;
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t16 = t12 * t4 - t5 * t13;
  const S t17 = t5 * t12 + t13 * t4;
  const S t18 = t15 * t4 - t5 * t14;
  const S t19 = t14 * t4 + t5 * t15;
  const S t20 = t5 * t2 + t3 * t4;
  const S t21 = t3 * t5 - t2 * t4;
  const S t7 = sine[3];
  const S t6 = cosine[3];
  const S t22 = t7 * t0 + t6 * t16;
  const S t23 = t7 * t1 - t6 * t18;
  const S t24 = t0 * t6 - t7 * t16;
  const S t25 = t20 * t6;
  const S t26 = t7 * t18 + t1 * t6;
  const S t27 = t7 * t20;
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t28 = t8 * t17 + t22 * t9;
  const S t29 = t17 * t9 - t8 * t22;
  F[2] = t29;
  F[3] = S(0.0203) * t16 - (S(0.1501) * t0 - S(0.4318) * t13) + S(0.4331) * t17 - S(-0.0562) * t29;
  const S t31 = t8 * t19 - t23 * t9;
  const S t32 = t8 * t23 + t19 * t9;
  F[6] = t32;
  F[7] = S(0.4331) * t19 + (S(0.0203) * t18 + (S(0.1501) * t1 + S(0.4318) * t14)) + S(0.0562) * t32;
  const S t34 = t9 * t25 + t8 * t21;
  const S t35 = t21 * t9 - t8 * t25;
  F[10] = t35;
  F[11] = S(0.0203) * t20 - S(0.4318) * t2 + S(0.4331) * t21 + S(0.0562) * t35;
  const S t10 = sine[5];
  const S t11 = cosine[5];
  F[0] = -(t10 * t24 + t11 * t28);
  F[1] = t10 * t28 - t11 * t24;
  F[4] = t26 * t10 - t11 * t31;
  F[5] = t31 * t10 + t26 * t11;
  F[8] = t27 * t10 - t11 * t34;
  F[9] = t27 * t11 + t34 * t10;
}

// frame_jacobians: 59 multiplications, 24 additions, 10 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
template <class S>
void frame_jacobians([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* J) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  J[7] = cosine[0];
  J[8] = cosine[0];
  const S t8 = sine[4];
  const S t7 = cosine[3];
  const S t10 = t8 * t7;
  const S t11 = S(0.0203) - S(0.0562) * t10;
  const S t9 = cosine[4];
  const S t12 = S(0.0562) * t9 + S(0.4331);
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t13 = t4 * t11 - t12 * t5;
  const S t14 = t4 * t12 + t11 * t5;
  const S t3 = cosine[1];
  const S t2 = sine[1];
  const S t15 = t3 * t4 - t2 * t5;
  J[15] = t15;
  const S t16 = t4 * t2 + t3 * t5;
  const S t17 = t15 * t9;
  const S t18 = S(0.4318) - t13;
  const S t6 = sine[3];
  const S t19 = t6 * t8;
  const S t20 = t8 * t16;
  const S t21 = t17 * t7 - t20;
  J[17] = t17 - t20 * t7;
  const S t23 = S(0.0562) * t19;
  const S t24 = t14 * t2;
  const S t25 = t24 + t3 * t18;
  const S t26 = t3 * t14;
  J[32] = t3 * t13 - t24;
  const S t28 = t26 + t13 * t2;
  const S t29 = t26 - t18 * t2;
  const S t1 = cosine[0];
  const S t30 = t6 * t1;
  const S t31 = t23 + S(0.1501);
  const S t0 = sine[0];
  const S t32 = t30 * t15 + t0 * t7;
  const S t33 = t6 * t0;
  J[28] = S(0.0562) * (t30 * t9 + t21 * t0);
  J[22] = S(-0.0562) * (t33 * t9 - t21 * t1);
  const S t36 = t16 * t9;
  const S t37 = t1 * t7 - t15 * t33;
  J[10] = t37;
  J[34] = S(-0.0562) * (t7 * t36 + t8 * t15);
  const S t39 = t10 * t15 + t36;
  const S t40 = S(0.0562) * t8;
  J[18] = -(t25 * t0 + t31 * t1);
  J[24] = t25 * t1 - t0 * t31;
  J[31] = -t25;
  J[27] = t40 * t37;
  J[21] = -(t40 * t32);
  J[4] = -t32;
  J[16] = t6 * t16;
  J[33] = t16 * t23;
  J[5] = t1 * t39 - t0 * t19;
  J[11] = t1 * t19 + t0 * t39;
  const S t51 = -t0;
  J[1] = t51;
  J[2] = t51;
  J[9] = t0 * t16;
  J[3] = t16 * t1;
  J[19] = t29 * t1;
  J[20] = t1 * t28;
  J[26] = t0 * t28;
  J[25] = t0 * t29;
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

// tori_mated: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "tori_mated". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Definitions, part 1 of 1.
#pragma once

#include <cmath>

#include "tori_mated_raw.hpp"

#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::tori_mated {

// inverse_dynamics: 215 multiplications, 158 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void inverse_dynamics([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const S* qdd,
                      [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* tau) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(u1)
  const S qd1 = qd[1];  // d(v1)
  const S qd2 = qd[2];  // d(u2)
  const S qd3 = qd[3];  // d(v2)
  const S qd4 = qd[4];  // d(turn)
  const S qdd0 = qdd[0];  // dd(u1)
  const S qdd1 = qdd[1];  // dd(v1)
  const S qdd2 = qdd[2];  // dd(u2)
  const S qdd3 = qdd[3];  // dd(v2)
  const S qdd4 = qdd[4];  // dd(turn)
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = S(0.22) * t7 + S(0.7);
  const S t11 = t4 * t10;
  const S t12 = t6 * t5;
  const S t13 = S(0.3) * t2 + S(1.0);
  const S t14 = t13 * t1;
  const S t15 = qd1 * qd1;
  const S t16 = t2 * t0;
  const S t17 = t0 * t3;
  const S t18 = t13 * t0;
  const S t19 = qd0 * qd0;
  const S t20 = qd0 * qd1;
  const S t21 = t1 * t3;
  const S t22 = qdd0 * t14 - (S(0.3) * (t15 * t16 + qdd1 * t17) + t18 * t19) - S(0.6) * (t20 * t21);
  const S t23 = t2 * t1;
  const S t24 = t18 * qdd0 + (S(0.3) * (qdd1 * t21 + t23 * t15) - S(0.6) * (t20 * t17)) + t14 * t19;
  const S t25 = t1 * t22 + t0 * t24;
  const S t26 = S(0.3) * (t2 * qdd1 - t3 * t15) + S(9.81);
  const S t27 = t21 * t24 - t17 * t22 + t2 * t26;
  const S t28 = t8 * t25 - t9 * t27;
  const S t29 = t7 * t5;
  const S t30 = t23 * t24 - t16 * t22 - t3 * t26;
  const S t31 = t10 * t5;
  const S t32 = qd2 * qd2;
  const S t33 = qd4 + qd0 * t3;
  const S t34 = t4 * t7;
  const S t35 = t6 * t4;
  const S t36 = t2 * qd0;
  const S t37 = qd1 * t8 + t36 * t9;
  const S t38 = t8 * t36 - qd1 * t9;
  const S t39 = t33 * t34 - (t35 * t37 + t5 * t38);
  const S t40 = t5 * qd3;
  const S t41 = t39 - t40;
  const S t42 = t41 * t41;
  const S t43 = t7 * t37 + t6 * t33;
  const S t44 = qd2 + t43;
  const S t45 = t44 * t44;
  const S t46 = t42 + t45;
  const S t47 = qd3 * qd3;
  const S t48 = t4 * qd3;
  const S t49 = t33 * t29 - (t37 * t12 - t4 * t38);
  const S t50 = qdd4 + (t3 * qdd0 + t2 * t20);
  const S t51 = t3 * t20 - t2 * qdd0;
  const S t52 = qd4 * t38 + (t9 * t51 - t8 * qdd1);
  const S t53 = qdd3 - (t9 * qdd1 + t8 * t51 - qd4 * t37);
  const S t54 = qd3 * qd2;
  const S t55 = t43 * t48 - (qd2 * t49 + (t34 * t50 + (t35 * t52 - t5 * t53))) - t4 * t54;
  const S t56 = t48 + t49;
  const S t57 = t44 * t56;
  const S t58 = t55 + t57;
  const S t59 = S(0.22) * (t35 * qd3) - qd2 * t31;
  const S t60 = t44 * t59;
  const S t61 = t7 * qd3;
  const S t62 = qdd2 + (t39 * t48 + t40 * t49 - (t7 * t52 - t6 * t50));
  const S t63 = t41 * t56;
  const S t64 = t62 + t63;
  const S t65 = S(0.22) * (t12 * qdd3 + (t29 * t47 - t6 * t58)) + (t60 + (t60 + S(0.44) * (t41 * t61 - t35 * t54))) + t11 * (qdd2 - t64);
  const S t66 = t9 * t25 + t8 * t27;
  const S t67 = t12 * t28 - (t29 * t30 + (t31 * (t32 + t46) + t65)) + t4 * t66;
  const S t68 = S(2.2) * t67 - (S(0.088) * t58 - (S(0.044) * t64 + S(0.066) * t46));
  const S t69 = t41 * t44;
  const S t70 = t5 * t54 - (t40 * t43 - (t50 * t29 + (t12 * t52 + t4 * t53)) + t39 * qd2);
  const S t71 = t69 + t70;
  const S t72 = t62 - t63;
  const S t73 = t56 * t56;
  const S t74 = t73 + t45;
  const S t75 = S(0.22) * (qd3 * t12) + t11 * qd2;
  const S t76 = t44 * t75;
  const S t77 = t31 * (qdd2 - t72) - (t11 * (t32 + t74) - (S(0.44) * (t56 * t61 - t54 * t12) + (t76 + t76)));
  const S t78 = t34 * t30 - (t35 * t28 - (S(0.22) * (t35 * qdd3 - t6 * t71 + t34 * t47) - t77) - t5 * t66);
  const S t79 = S(2.2) * t78 + (S(0.088) * t71 + (S(0.044) * t74 - S(0.066) * t72));
  const S t80 = S(0.044) * t67 - S(0.066) * t78 + (S(0.55588) * t64 - (S(0.05176) * t58 + S(0.02264) * t71 + S(0.03132) * (t73 - t42) - S(0.51698) * t72));
  tau[2] = t80;
  const S t81 = t11 * t68 + t31 * t79 + t80;
  const S t82 = t69 - t70;
  const S t83 = t55 - t57;
  const S t84 = t73 + t42;
  const S t85 = t41 * t75;
  const S t86 = t56 * t59;
  const S t87 = t11 * t82 - (t31 * t83 + (t6 * (t30 + S(0.22) * (t47 + t84)) + (t85 + (t85 - (t86 + t86))) - t7 * (S(0.22) * qdd3 - t28)));
  const S t88 = S(2.2) * t87 + (S(0.088) * t84 + (S(0.044) * t82 + S(0.066) * t83));
  const S t89 = S(0.06852) * t71 - (S(0.05176) * (t42 - t45) + (S(0.03132) * t83 + S(0.02264) * t72) + S(0.55588) * t82) + (S(0.088) * t78 - S(0.044) * t87);
  const S t90 = S(0.22) * (t6 * t79) + t11 * t88 - t89;
  const S t91 = S(0.088) * t67 - S(0.066) * t87 - (S(0.51698) * t83 + (S(0.03132) * t82 - S(0.05176) * t64 + S(0.02264) * (t73 - t45) + S(0.06852) * t58));
  const S t92 = t31 * t88 - S(0.22) * (t6 * t68) + t91;
  const S t93 = t6 * t81 - (t29 * t90 - t34 * t92);
  tau[4] = t93;
  const S t94 = t35 * t92 - t12 * t90 - t7 * t81;
  const S t95 = t4 * t90 + t5 * t92;
  const S t96 = t6 * t88 + (t29 * t68 - t34 * t79);
  const S t97 = t5 * t79 + t4 * t68;
  const S t98 = t12 * t68 - t35 * t79 - t7 * t88;
  const S t99 = t9 * t97 + t8 * t98;
  const S t100 = t8 * t97 - t9 * t98;
  const S t101 = t18 * (t23 * t96 - (t0 * t99 + t21 * t100)) - t14 * (t16 * t96 + (t1 * t99 - t17 * t100));
  tau[0] = t3 * t93 - t2 * (t9 * t94 + t8 * t95) - t101;
  tau[1] = S(0.3) * t100 - (t8 * t94 - t9 * t95);
  tau[3] = S(-0.22) * t98 - t95;
}

// mass_matrix: 219 multiplications, 144 additions, 8 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M) {
  using detail::sines_and_cosines;
  S sine[4], cosine[4];
  sines_and_cosines(4, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = sine[1];
  const S t3 = cosine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = S(0.22) * t4 + S(0.7);
  const S t9 = t2 * t8;
  const S t10 = S(0.3) * t0 + S(1.0);
  const S t11 = t6 * t10;
  const S t12 = t5 * t3;
  const S t13 = t0 * t7;
  const S t14 = t0 * t6;
  const S t15 = t4 * t3;
  const S t16 = t12 * t13 - t2 * t14 - t15 * t1;
  const S t17 = t8 * t3;
  const S t18 = t2 * t4;
  const S t19 = t2 * t5;
  const S t20 = t1 * t18 - (t13 * t19 + t3 * t14);
  const S t21 = t4 * t11 - (t9 * t16 + t17 * t20);
  const S t22 = S(2.2) * t21 + (S(0.066) * t20 - S(0.044) * t16);
  const S t23 = t4 * t13 + t5 * t1;
  const S t24 = t10 * t7;
  const S t25 = S(0.22) * (t5 * t16) + t17 * t23 + (t3 * t24 - t11 * t19);
  const S t26 = S(0.066) * t23 + S(0.088) * t16 - S(2.2) * t25;
  const S t27 = t9 * t22 + S(0.22) * (t5 * t26) + (S(0.044) * t21 + S(0.088) * t25 + (S(0.03132) * t20 - S(0.02264) * t23 - S(0.6244) * t16));
  const S t28 = t11 * t12 + t2 * t24 + (t9 * t23 - S(0.22) * (t5 * t20));
  const S t29 = S(2.2) * t28 + (S(0.044) * t23 + S(0.088) * t20);
  const S t30 = S(0.22) * (t5 * t29) + t17 * t22 - (S(0.066) * t21 + S(0.088) * t28 - (S(0.03132) * t16 - S(0.05176) * t23 - S(0.5855) * t20));
  const S t31 = t2 * t27 + t3 * t30;
  const S t32 = S(0.02264) * t16 + S(0.05176) * t20 + S(1.07286) * t23 - (S(0.066) * t25 - S(0.044) * t28);
  M[2] = t32;
  M[10] = t32;
  const S t33 = t17 * t26 - t9 * t29 - t32;
  const S t34 = t12 * t27 - t19 * t30 + t4 * t33;
  const S t35 = t18 * t30 - t15 * t27 + t5 * t33;
  const S t36 = t19 * t26 + t12 * t29 + t4 * t22;
  const S t37 = t2 * t29 - t3 * t26;
  M[0] = t0 * (t6 * t31 - t7 * t34) - (t1 * t35 - t10 * (t6 * t36 + t7 * t37));
  const S t39 = S(-0.3) * (t7 * t36 - t6 * t37) - t6 * t34 - t7 * t31;
  M[1] = t39;
  M[5] = t39;
  const S t40 = t31 - S(0.22) * t36;
  M[3] = t40;
  M[15] = t40;
  const S t41 = -t35;
  M[4] = t41;
  M[20] = t41;
  const S t42 = t2 * t7 + t6 * t12;
  const S t43 = t6 * t19 - t3 * t7;
  const S t44 = t9 * t42 - t17 * t43 + S(0.3) * (t4 * t7);
  const S t45 = S(2.2) * t44 + (S(0.066) * t43 + S(0.044) * t42);
  const S t46 = t6 * t4;
  const S t47 = t9 * t46 + (S(0.22) * (t5 * t43) + S(0.3) * (t6 * t2 - t12 * t7));
  const S t48 = S(0.088) * t43 - S(0.044) * t46 - S(2.2) * t47;
  const S t49 = t17 * t45 + S(0.22) * (t5 * t48) + (S(0.05176) * t46 - S(0.03132) * t42 - S(0.5855) * t43 + (S(0.088) * t47 - S(0.066) * t44));
  const S t50 = S(0.22) * (t5 * t42) + S(0.3) * (t6 * t3 + t7 * t19) + t17 * t46;
  const S t51 = S(0.088) * t42 + S(0.066) * t46 - S(2.2) * t50;
  const S t52 = S(0.22) * (t5 * t51) - t9 * t45 - (S(0.6244) * t42 + (S(0.03132) * t43 + S(0.02264) * t46) - (S(0.088) * t50 - S(0.044) * t44));
  const S t53 = t3 * t49 - t2 * t52;
  const S t54 = S(1.07286) * t46 - (S(0.05176) * t43 - S(0.02264) * t42) - (S(0.066) * t50 - S(0.044) * t47);
  M[7] = t54;
  M[11] = t54;
  const S t55 = t54 - (t17 * t51 + t9 * t48);
  const S t56 = t4 * t45 + (t12 * t48 - t19 * t51);
  M[6] = t7 * t53 - t6 * (t19 * t49 + t12 * t52 - t4 * t55) - S(0.3) * (t6 * (t2 * t48 + t3 * t51) - t7 * t56);
  const S t58 = S(0.22) * t56 - t53;
  M[8] = t58;
  M[16] = t58;
  const S t59 = t15 * t52 + t18 * t49 + t5 * t55;
  M[9] = t59;
  M[21] = t59;
  const S t60 = S(-0.05176) * t3 - S(0.02264) * t2;
  M[13] = t60;
  M[17] = t60;
  const S t61 = t5 * (S(1.07286) - (S(0.066) * t17 - S(0.044) * t9)) - (t15 * (S(0.02264) - S(0.01452) * t5) - t18 * (S(0.05176) - S(0.00968) * t5));
  M[14] = t61;
  M[22] = t61;
  const S t62 = S(0.044) * t2 - S(0.066) * t3 + S(1.54);
  const S t63 = t17 * t62 - S(0.01936) * t12 - (S(0.03132) * t2 - S(0.5855) * t3 + S(0.0462));
  const S t64 = t9 * t62 - S(0.01936) * t19 + (S(0.6244) * t2 - S(0.03132) * t3 + S(0.0308));
  M[18] = t3 * t63 + t2 * t64 - (S(0.22) * (t4 * t62) - S(0.01936) * t5);
  const S t66 = t15 * t64 - t18 * t63 + t5 * t60;
  M[19] = t66;
  M[23] = t66;
  const S t67 = S(0.044) * t15 + S(0.066) * t18;
  const S t68 = t5 * (t17 - S(0.22) * t15);
  const S t69 = S(2.2) * t68 - (S(0.066) * t5 - S(0.088) * t15);
  const S t70 = t5 * (t9 - S(0.22) * t18);
  const S t71 = S(2.2) * t70 + (S(0.088) * t18 + S(0.044) * t5);
  const S t72 = t18 * (t5 * (S(0.05176) - S(0.22) * t71) - t17 * t67 + S(0.088) * t70 + S(0.5855) * t18 + S(0.03132) * t15);
  const S t73 = t5 * (t61 + (t17 * t69 + t9 * t71));
  M[24] = t15 * (t9 * t67 + (S(0.088) * t68 + (S(0.03132) * t18 + S(0.6244) * t15 - t5 * (S(0.22) * t69 + S(0.02264))))) + t72 + t73;
  M[12] = S(1.07286);
}

// bias: 203 multiplications, 141 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
          [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(u1)
  const S qd1 = qd[1];  // d(v1)
  const S qd2 = qd[2];  // d(u2)
  const S qd3 = qd[3];  // d(v2)
  const S qd4 = qd[4];  // d(turn)
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t0 = sine[0];
  const S t1 = cosine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = t5 * t6;
  const S t11 = S(0.22) * t6 + S(0.7);
  const S t12 = t4 * t11;
  const S t13 = t5 * qd3;
  const S t14 = qd4 + t3 * qd0;
  const S t15 = t4 * t6;
  const S t16 = t2 * qd0;
  const S t17 = t8 * qd1 + t16 * t9;
  const S t18 = t4 * t7;
  const S t19 = t8 * t16 - qd1 * t9;
  const S t20 = t14 * t15 - (t17 * t18 - t5 * t19);
  const S t21 = t13 + t20;
  const S t22 = t6 * t17 + t14 * t7;
  const S t23 = qd2 + t22;
  const S t24 = t21 * t23;
  const S t25 = qd0 * qd1;
  const S t26 = t2 * t25;
  const S t27 = t5 * t7;
  const S t28 = t3 * t25;
  const S t29 = qd4 * t19 + t9 * t28;
  const S t30 = qd4 * t17 - t8 * t28;
  const S t31 = qd3 * qd2;
  const S t32 = t20 * qd2 - t13 * t22 + (t10 * t26 + (t27 * t29 - t4 * t30)) + t5 * t31;
  const S t33 = t24 + t32;
  const S t34 = t14 * t10 - (t27 * t17 + t4 * t19);
  const S t35 = t4 * qd3;
  const S t36 = t34 - t35;
  const S t37 = t5 * t11;
  const S t38 = S(0.22) * (qd3 * t18) + t37 * qd2;
  const S t39 = t36 * t38;
  const S t40 = S(0.22) * (t27 * qd3) - t12 * qd2;
  const S t41 = t21 * t40;
  const S t42 = qd1 * qd1;
  const S t43 = S(9.81) - S(0.3) * (t3 * t42);
  const S t44 = t0 * t2;
  const S t45 = t1 * t3;
  const S t46 = S(0.3) * t2 + S(1.0);
  const S t47 = t0 * t46;
  const S t48 = qd0 * qd0;
  const S t49 = S(0.3) * (t44 * t42) + (S(0.6) * (t45 * t25) + t47 * t48);
  const S t50 = t2 * t1;
  const S t51 = t46 * t1;
  const S t52 = t0 * t3;
  const S t53 = t48 * t51 - S(0.6) * (t25 * t52) + S(0.3) * (t42 * t50);
  const S t54 = t3 * t43 - (t44 * t49 + t50 * t53);
  const S t55 = qd3 * qd3;
  const S t56 = S(0.22) * t55;
  const S t57 = t21 * t21;
  const S t58 = t36 * t36;
  const S t59 = t57 + t58;
  const S t60 = t4 * t31 - (t35 * t22 + t34 * qd2 - (t15 * t26 + (t5 * t30 + t18 * t29)));
  const S t61 = t36 * t23;
  const S t62 = t60 - t61;
  const S t63 = t1 * t49 - t0 * t53;
  const S t64 = t49 * t52 + t45 * t53 + t2 * t43;
  const S t65 = t8 * t63 + t9 * t64;
  const S t66 = t12 * t33 - (t39 + (t39 - (t41 + (t41 + t7 * (t54 - (t56 + S(0.22) * t59))))) + t37 * t62) + t6 * t65;
  const S t67 = S(2.2) * t66 + (S(0.088) * t59 - (S(0.044) * t62 + S(0.066) * t33));
  const S t68 = t24 - t32;
  const S t69 = t23 * t23;
  const S t70 = t69 + t58;
  const S t71 = t36 * t21;
  const S t72 = t6 * t29 - t7 * t26 - (t34 * t13 + t35 * t20);
  const S t73 = t71 - t72;
  const S t74 = t23 * t40;
  const S t75 = t6 * qd3;
  const S t76 = t9 * t63 - t8 * t64;
  const S t77 = qd2 * qd2;
  const S t78 = t5 * t76 + (t18 * t65 - (t37 * t73 - S(0.22) * (t15 * t55 - t7 * t68) - t12 * (t77 + t70) + t15 * t54));
  const S t79 = t74 + (t74 + (S(0.44) * (t36 * t75 - t27 * t31) + t78));
  const S t80 = S(0.088) * t68 - (S(0.066) * t70 + S(0.044) * t73) + S(2.2) * t79;
  const S t81 = S(0.51698) * t33 + (S(0.02264) * (t69 - t57) + (S(0.05176) * t73 + S(0.03132) * t62) - S(0.06852) * t68) - (S(0.088) * t79 + S(0.066) * t66);
  const S t82 = t12 * t67 + S(0.22) * (t7 * t80) + t81;
  const S t83 = t71 + t72;
  const S t84 = t69 + t57;
  const S t85 = t23 * t38;
  const S t86 = t60 + t61;
  const S t87 = t27 * t65 - (S(0.44) * (t21 * t75 - t18 * t31) + (t85 + t85)) - t4 * t76 + t10 * (t56 - t54) - S(0.22) * (t7 * t86);
  const S t88 = t83 * t12 - (t37 * (t77 + t84) + t87);
  const S t89 = S(2.2) * t88 - (S(0.044) * t84 + S(0.066) * t83 + S(0.088) * t86);
  const S t90 = S(0.22) * (t7 * t89) - t37 * t67;
  const S t91 = S(0.044) * t66 + S(0.088) * t88 - (S(0.06852) * t86 + (S(0.55588) * t62 + (S(0.05176) * (t69 - t58) + (S(0.02264) * t83 + S(0.03132) * t33)))) - t90;
  const S t92 = S(0.55588) * t73 - (S(0.51698) * t83 + (S(0.05176) * t68 + S(0.02264) * t86 + S(0.03132) * (t57 - t58))) - (S(0.044) * t79 - S(0.066) * t88);
  c[2] = t92;
  const S t93 = t37 * t80 + t12 * t89 - t92;
  const S t94 = t10 * t82 - t15 * t91 - t7 * t93;
  c[4] = t94;
  const S t95 = t27 * t82 - t18 * t91 + t6 * t93;
  const S t96 = t5 * t91 + t4 * t82;
  const S t97 = t4 * t89 + t5 * t80;
  const S t98 = t6 * t67 - (t27 * t89 - t18 * t80);
  const S t99 = t8 * t97 - t9 * t98;
  const S t100 = t9 * t97 + t8 * t98;
  const S t101 = t15 * t80 - t10 * t89 - t7 * t67;
  const S t102 = t47 * (t45 * t99 + t0 * t100 - t50 * t101) - t51 * (t52 * t99 - t1 * t100 - t44 * t101);
  c[0] = t3 * t94 - t2 * (t9 * t95 + t8 * t96) - t102;
  c[1] = t9 * t96 - t8 * t95 - S(0.3) * t99;
  c[3] = S(0.22) * t98 - t96;
}

// mass_matrix_and_bias: 424 multiplications, 290 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void mass_matrix_and_bias([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd,
                          [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* M, [[maybe_unused]] S* c) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(u1)
  const S qd1 = qd[1];  // d(v1)
  const S qd2 = qd[2];  // d(u2)
  const S qd3 = qd[3];  // d(v2)
  const S qd4 = qd[4];  // d(turn)
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = S(0.22) * t6 + S(0.7);
  const S t11 = t4 * t10;
  const S t12 = S(0.3) * t2 + S(1.0);
  const S t13 = t8 * t12;
  const S t14 = t7 * t5;
  const S t15 = t2 * t9;
  const S t16 = t2 * t8;
  const S t17 = t6 * t5;
  const S t18 = t14 * t15 - t4 * t16 - t17 * t3;
  const S t19 = t10 * t5;
  const S t20 = t4 * t6;
  const S t21 = t4 * t7;
  const S t22 = t3 * t20 - (t15 * t21 + t5 * t16);
  const S t23 = t6 * t13 - (t11 * t18 + t19 * t22);
  const S t24 = S(2.2) * t23 + (S(0.066) * t22 - S(0.044) * t18);
  const S t25 = t6 * t15 + t7 * t3;
  const S t26 = t12 * t9;
  const S t27 = S(0.22) * (t7 * t18) + t19 * t25 + (t5 * t26 - t13 * t21);
  const S t28 = S(0.066) * t25 + S(0.088) * t18 - S(2.2) * t27;
  const S t29 = t11 * t24 + S(0.22) * (t7 * t28) + (S(0.044) * t23 + S(0.088) * t27 + (S(0.03132) * t22 - S(0.02264) * t25 - S(0.6244) * t18));
  const S t30 = t13 * t14 + t4 * t26 + (t11 * t25 - S(0.22) * (t7 * t22));
  const S t31 = S(2.2) * t30 + (S(0.044) * t25 + S(0.088) * t22);
  const S t32 = S(0.22) * (t7 * t31) + t19 * t24 - (S(0.066) * t23 + S(0.088) * t30 - (S(0.03132) * t18 - S(0.05176) * t25 - S(0.5855) * t22));
  const S t33 = t4 * t29 + t5 * t32;
  const S t34 = S(0.02264) * t18 + S(0.05176) * t22 + S(1.07286) * t25 - (S(0.066) * t27 - S(0.044) * t30);
  M[2] = t34;
  M[10] = t34;
  const S t35 = t19 * t28 - t11 * t31 - t34;
  const S t36 = t14 * t29 - t21 * t32 + t6 * t35;
  const S t37 = t20 * t32 - t17 * t29 + t7 * t35;
  const S t38 = t12 * t0;
  const S t39 = t2 * t1;
  const S t40 = t17 * t31 + t20 * t28 - t7 * t24;
  const S t41 = t3 * t1;
  const S t42 = t21 * t28 + t14 * t31 + t6 * t24;
  const S t43 = t4 * t31 - t5 * t28;
  const S t44 = t9 * t42 - t8 * t43;
  const S t45 = t8 * t42 + t9 * t43;
  const S t46 = t12 * t1;
  const S t47 = t2 * t0;
  const S t48 = t3 * t0;
  const S t49 = t38 * (t39 * t40 + (t41 * t44 + t0 * t45)) - t46 * (t40 * t47 - (t1 * t45 - t44 * t48));
  M[0] = t2 * (t8 * t33 - t9 * t36) - t3 * t37 + t49;
  const S t51 = S(-0.3) * t44 - t8 * t36 - t9 * t33;
  M[1] = t51;
  M[5] = t51;
  const S t52 = t33 - S(0.22) * t42;
  M[3] = t52;
  M[15] = t52;
  const S t53 = -t37;
  M[4] = t53;
  M[20] = t53;
  const S t54 = t4 * t9 + t8 * t14;
  const S t55 = t8 * t21 - t5 * t9;
  const S t56 = t11 * t54 - t19 * t55 + S(0.3) * (t6 * t9);
  const S t57 = S(2.2) * t56 + (S(0.066) * t55 + S(0.044) * t54);
  const S t58 = t8 * t6;
  const S t59 = t11 * t58 + (S(0.22) * (t7 * t55) + S(0.3) * (t8 * t4 - t14 * t9));
  const S t60 = S(0.088) * t55 - S(0.044) * t58 - S(2.2) * t59;
  const S t61 = t19 * t57 + S(0.22) * (t7 * t60) + (S(0.05176) * t58 - S(0.03132) * t54 - S(0.5855) * t55 + (S(0.088) * t59 - S(0.066) * t56));
  const S t62 = S(0.22) * (t7 * t54) + S(0.3) * (t8 * t5 + t9 * t21) + t19 * t58;
  const S t63 = S(0.088) * t54 + S(0.066) * t58 - S(2.2) * t62;
  const S t64 = S(0.22) * (t7 * t63) - t11 * t57 - (S(0.6244) * t54 + (S(0.03132) * t55 + S(0.02264) * t58) - (S(0.088) * t62 - S(0.044) * t56));
  const S t65 = t5 * t61 - t4 * t64;
  const S t66 = S(1.07286) * t58 - (S(0.05176) * t55 - S(0.02264) * t54) - (S(0.066) * t62 - S(0.044) * t59);
  M[7] = t66;
  M[11] = t66;
  const S t67 = t66 - (t19 * t63 + t11 * t60);
  const S t68 = t6 * t57 + (t14 * t60 - t21 * t63);
  M[6] = t9 * t65 - t8 * (t21 * t61 + t14 * t64 - t6 * t67) - S(0.3) * (t8 * (t4 * t60 + t5 * t63) - t9 * t68);
  const S t70 = S(0.22) * t68 - t65;
  M[8] = t70;
  M[16] = t70;
  const S t71 = t17 * t64 + t20 * t61 + t7 * t67;
  M[9] = t71;
  M[21] = t71;
  const S t72 = S(-0.05176) * t5 - S(0.02264) * t4;
  M[13] = t72;
  M[17] = t72;
  const S t73 = t7 * (S(1.07286) - (S(0.066) * t19 - S(0.044) * t11)) - (t17 * (S(0.02264) - S(0.01452) * t7) - t20 * (S(0.05176) - S(0.00968) * t7));
  M[14] = t73;
  M[22] = t73;
  const S t74 = S(0.044) * t4 - S(0.066) * t5 + S(1.54);
  const S t75 = t19 * t74 - S(0.01936) * t14 - (S(0.03132) * t4 - S(0.5855) * t5 + S(0.0462));
  const S t76 = t11 * t74 - S(0.01936) * t21 + (S(0.6244) * t4 - S(0.03132) * t5 + S(0.0308));
  M[18] = t5 * t75 + t4 * t76 - (S(0.22) * (t6 * t74) - S(0.01936) * t7);
  const S t78 = t17 * t76 - t20 * t75 + t7 * t72;
  M[19] = t78;
  M[23] = t78;
  const S t79 = S(0.044) * t17 + S(0.066) * t20;
  const S t80 = t7 * (t19 - S(0.22) * t17);
  const S t81 = S(2.2) * t80 - (S(0.066) * t7 - S(0.088) * t17);
  const S t82 = t7 * (t11 - S(0.22) * t20);
  const S t83 = S(2.2) * t82 + (S(0.088) * t20 + S(0.044) * t7);
  const S t84 = t20 * (t7 * (S(0.05176) - S(0.22) * t83) - t19 * t79 + S(0.088) * t82 + S(0.5855) * t20 + S(0.03132) * t17);
  const S t85 = t7 * (t73 + (t19 * t81 + t11 * t83));
  M[24] = t17 * (t11 * t79 + (S(0.088) * t80 + (S(0.03132) * t20 + S(0.6244) * t17 - t7 * (S(0.22) * t81 + S(0.02264))))) + t84 + t85;
  const S t87 = t4 * qd3;
  const S t88 = qd4 + t3 * qd0;
  const S t89 = t2 * qd0;
  const S t90 = t8 * qd1 + t9 * t89;
  const S t91 = t8 * t89 - t9 * qd1;
  const S t92 = t17 * t88 - (t14 * t90 - t4 * t91);
  const S t93 = t87 + t92;
  const S t94 = t6 * t90 + t7 * t88;
  const S t95 = qd2 + t94;
  const S t96 = t93 * t95;
  const S t97 = qd0 * qd1;
  const S t98 = t2 * t97;
  const S t99 = t3 * t97;
  const S t100 = qd4 * t91 + t9 * t99;
  const S t101 = qd4 * t90 - t8 * t99;
  const S t102 = qd3 * qd2;
  const S t103 = t92 * qd2 - t87 * t94 + (t20 * t98 + (t21 * t100 - t5 * t101)) + t4 * t102;
  const S t104 = t96 + t103;
  const S t105 = t20 * t88 - (t21 * t90 + t5 * t91);
  const S t106 = t5 * qd3;
  const S t107 = t105 - t106;
  const S t108 = S(0.22) * (t14 * qd3) + t11 * qd2;
  const S t109 = t107 * t108;
  const S t110 = S(0.22) * (t21 * qd3) - t19 * qd2;
  const S t111 = t93 * t110;
  const S t112 = qd1 * qd1;
  const S t113 = S(9.81) - S(0.3) * (t3 * t112);
  const S t114 = qd0 * qd0;
  const S t115 = S(0.3) * (t39 * t112) + (S(0.6) * (t48 * t97) + t46 * t114);
  const S t116 = t38 * t114 - S(0.6) * (t41 * t97) + S(0.3) * (t47 * t112);
  const S t117 = t3 * t113 - (t39 * t115 + t47 * t116);
  const S t118 = qd3 * qd3;
  const S t119 = S(0.22) * t118;
  const S t120 = t93 * t93;
  const S t121 = t107 * t107;
  const S t122 = t120 + t121;
  const S t123 = t5 * t102 - (t106 * t94 + t105 * qd2 - (t17 * t98 + (t4 * t101 + t14 * t100)));
  const S t124 = t107 * t95;
  const S t125 = t123 - t124;
  const S t126 = t0 * t115 - t1 * t116;
  const S t127 = t41 * t115 + t48 * t116 + t2 * t113;
  const S t128 = t8 * t126 + t9 * t127;
  const S t129 = t19 * t104 - (t109 + (t109 - (t111 + (t111 + t7 * (t117 - (t119 + S(0.22) * t122))))) + t11 * t125) + t6 * t128;
  const S t130 = S(2.2) * t129 + (S(0.088) * t122 - (S(0.044) * t125 + S(0.066) * t104));
  const S t131 = t96 - t103;
  const S t132 = t95 * t95;
  const S t133 = t132 + t121;
  const S t134 = t107 * t93;
  const S t135 = t6 * t100 - t7 * t98 - (t105 * t87 + t106 * t92);
  const S t136 = t134 - t135;
  const S t137 = t95 * t110;
  const S t138 = t6 * qd3;
  const S t139 = t9 * t126 - t8 * t127;
  const S t140 = qd2 * qd2;
  const S t141 = t4 * t139 + (t14 * t128 - (t11 * t136 - S(0.22) * (t17 * t118 - t7 * t131) - t19 * (t140 + t133) + t17 * t117));
  const S t142 = t137 + (t137 + (S(0.44) * (t107 * t138 - t21 * t102) + t141));
  const S t143 = S(0.088) * t131 - (S(0.066) * t133 + S(0.044) * t136) + S(2.2) * t142;
  const S t144 = S(0.51698) * t104 + (S(0.02264) * (t132 - t120) + (S(0.05176) * t136 + S(0.03132) * t125) - S(0.06852) * t131) - (S(0.088) * t142 + S(0.066) * t129);
  const S t145 = t19 * t130 + S(0.22) * (t7 * t143) + t144;
  const S t146 = t134 + t135;
  const S t147 = t132 + t120;
  const S t148 = t95 * t108;
  const S t149 = t123 + t124;
  const S t150 = t21 * t128 - (S(0.44) * (t93 * t138 - t14 * t102) + (t148 + t148)) - t5 * t139 + t20 * (t119 - t117) - S(0.22) * (t7 * t149);
  const S t151 = t19 * t146 - (t11 * (t140 + t147) + t150);
  const S t152 = S(2.2) * t151 - (S(0.044) * t147 + S(0.066) * t146 + S(0.088) * t149);
  const S t153 = S(0.22) * (t7 * t152) - t11 * t130;
  const S t154 = S(0.044) * t129 + S(0.088) * t151 - (S(0.06852) * t149 + (S(0.55588) * t125 + (S(0.05176) * (t132 - t121) + (S(0.02264) * t146 + S(0.03132) * t104)))) - t153;
  const S t155 = S(0.55588) * t136 - (S(0.51698) * t146 + (S(0.05176) * t131 + S(0.02264) * t149 + S(0.03132) * (t120 - t121))) - (S(0.044) * t142 - S(0.066) * t151);
  c[2] = t155;
  const S t156 = t11 * t143 + t19 * t152 - t155;
  const S t157 = t20 * t145 - t17 * t154 - t7 * t156;
  c[4] = t157;
  const S t158 = t21 * t145 - t14 * t154 + t6 * t156;
  const S t159 = t4 * t154 + t5 * t145;
  const S t160 = t5 * t152 + t4 * t143;
  const S t161 = t6 * t130 - (t21 * t152 - t14 * t143);
  const S t162 = t8 * t160 - t9 * t161;
  const S t163 = t9 * t160 + t8 * t161;
  const S t164 = t17 * t143 - t20 * t152 - t7 * t130;
  const S t165 = t46 * (t48 * t162 + t1 * t163 - t47 * t164) - t38 * (t41 * t162 - t0 * t163 - t39 * t164);
  c[0] = t3 * t157 - t2 * (t9 * t158 + t8 * t159) - t165;
  c[1] = t9 * t159 - t8 * t158 - S(0.3) * t162;
  c[3] = S(0.22) * t161 - t159;
  M[12] = S(1.07286);
}

// coordinate_rates: 0 multiplications, 0 additions (reduced formulation).
template <class S>
void coordinate_rates([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] S* qdot) {
  const S qd0 = qd[0];  // d(u1)
  const S qd1 = qd[1];  // d(v1)
  const S qd2 = qd[2];  // d(u2)
  const S qd3 = qd[3];  // d(v2)
  const S qd4 = qd[4];  // d(turn)
  qdot[0] = qd0;
  qdot[1] = qd1;
  qdot[2] = qd2;
  qdot[3] = qd3;
  qdot[4] = qd4;
}

// energy: 100 multiplications, 57 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void energy([[maybe_unused]] const S* q, [[maybe_unused]] const S* qd, [[maybe_unused]] const Inputs<S>& in,
            [[maybe_unused]] S* e) {
  using detail::sines_and_cosines;
  const S qd0 = qd[0];  // d(u1)
  const S qd1 = qd[1];  // d(v1)
  const S qd2 = qd[2];  // d(u2)
  const S qd3 = qd[3];  // d(v2)
  const S qd4 = qd[4];  // d(turn)
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = t3 * t0;
  const S t11 = S(0.3) * t2 + S(1.0);
  const S t12 = S(0.3) * (qd1 * t10) + qd0 * (t11 * t1);
  const S t13 = t3 * t1;
  const S t14 = S(0.3) * (qd1 * t13) - qd0 * (t0 * t11);
  const S t15 = S(0.3) * (t2 * (qd1 * t2)) + (t10 * t12 + t13 * t14);
  const S t16 = t0 * t14 - t1 * t12;
  const S t17 = t8 * t15 - t9 * t16;
  const S t18 = t7 * t5;
  const S t19 = t8 * t16 + t9 * t15;
  const S t20 = S(0.22) * qd3 + t19;
  const S t21 = qd4 + qd0 * t3;
  const S t22 = t6 * t4;
  const S t23 = qd0 * t2;
  const S t24 = qd3 + (t8 * t23 - qd1 * t9);
  const S t25 = t8 * qd1 + t23 * t9;
  const S t26 = t7 * t4;
  const S t27 = t21 * t22 + (t5 * t24 - t25 * t26);
  const S t28 = t6 * t25 + t21 * t7;
  const S t29 = S(0.22) * t6 + S(0.7);
  const S t30 = t4 * t29;
  const S t31 = t4 * t17 + t18 * t20 - S(0.22) * (t7 * t27) + t28 * t30;
  const S t32 = t6 * t5;
  const S t33 = t25 * t18 + (t4 * t24 - t21 * t32);
  const S t34 = t5 * t29;
  const S t35 = t26 * t19 - (t5 * t17 - (S(0.22) * (qd3 * t26 - t7 * t33) - t28 * t34));
  const S t36 = t6 * t20 - (t27 * t34 + t33 * t30);
  const S t37 = qd2 + t28;
  const S t38 = t35 * (S(0.044) * t37 - S(0.088) * t33) + t31 * (S(0.066) * t37 - S(0.088) * t27) + t36 * (S(0.044) * t27 - S(0.066) * t33);
  const S t39 = t33 * (S(0.03132) * t27 - S(0.5855) * t33 + S(0.05176) * t37) + t27 * (S(0.02264) * t37 - (S(0.6244) * t27 - S(0.03132) * t33));
  e[0] = S(1.1) * (t31 * t31 + t35 * t35 + t36 * t36) - t38 - S(0.5) * (t37 * (S(0.02264) * t27 + S(0.05176) * t33 - S(1.07286) * t37) + t39);
  const S t41 = t2 * t9;
  const S t42 = t8 * t2;
  const S t43 = (t6 * t41 + t3 * t7) * (S(0.04) - S(0.22) * t7);
  const S t44 = (S(0.03) - t30) * (t26 * t41 - t5 * t42 - t3 * t22) + (t34 + S(0.02)) * (t3 * t32 - (t18 * t41 + t4 * t42)) - t43;
  e[1] = S(21.582) * (t44 + S(0.3) * t3);
}

// body_poses: 61 multiplications, 30 additions, 10 sin/cos/tan (reduced formulation).
template <class S>
void body_poses([[maybe_unused]] const S* q, [[maybe_unused]] const Inputs<S>& in, [[maybe_unused]] S* W) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = cosine[2];
  const S t5 = sine[2];
  const S t6 = cosine[3];
  const S t7 = sine[3];
  const S t8 = sine[4];
  const S t9 = cosine[4];
  const S t10 = t4 * t6;
  const S t11 = t0 * t2;
  const S t12 = t0 * t3;
  const S t13 = t8 * t12 + t9 * t1;
  const S t14 = t12 * t9 - t8 * t1;
  const S t15 = t4 * t7;
  const S t16 = t10 * t11 - (t5 * t13 - t14 * t15);
  W[0] = -t16;
  const S t18 = t5 * t7;
  const S t19 = t6 * t5;
  const S t20 = t4 * t13 + t14 * t18 + t11 * t19;
  W[1] = -t20;
  const S t22 = t6 * t14 - t11 * t7;
  W[2] = t22;
  const S t23 = S(0.3) * t2 + S(1.0);
  const S t24 = S(0.22) * t6 + S(0.7);
  const S t25 = t5 * t24;
  const S t26 = t4 * t24;
  W[3] = t0 * t23 - (S(0.22) * (t7 * t22) - (t20 * t25 + t16 * t26));
  const S t28 = t3 * t1;
  const S t29 = t0 * t8 + t9 * t28;
  const S t30 = t0 * t9 - t8 * t28;
  const S t31 = t2 * t1;
  const S t32 = t15 * t29 + t5 * t30 + t10 * t31;
  W[4] = -t32;
  const S t34 = t4 * t30 - t18 * t29 - t19 * t31;
  W[5] = t34;
  const S t35 = t7 * t31 - t6 * t29;
  W[6] = -t35;
  W[7] = t1 * t23 + (t26 * t32 - t25 * t34 + S(0.22) * (t7 * t35));
  const S t38 = t2 * t8;
  const S t39 = t2 * t9;
  const S t40 = t10 * t3 + (t5 * t38 - t15 * t39);
  W[8] = -t40;
  const S t42 = t18 * t39 + t4 * t38 - t3 * t19;
  W[9] = t42;
  const S t43 = t6 * t39 + t3 * t7;
  W[10] = -t43;
  W[11] = S(0.22) * (t7 * t43) - (t25 * t42 - t26 * t40) + S(0.3) * t3;
}

}  // namespace alembert::mechanisms::tori_mated

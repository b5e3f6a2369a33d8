// puma560: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over several packs of states, whose arrays follow each other. Each is cut into blocks, and a block is done for
// all packs before the next one begins: then its code, and what it hands over, are in the nearest caches.
#pragma once

#include <cmath>

#include "puma560_raw.hpp"

#if defined(__GNUC__) || defined(_MSC_VER)
#define ALEMBERT_RESTRICT __restrict
#else
#define ALEMBERT_RESTRICT
#endif
#ifndef ALEMBERT_NOINLINE
#if defined(_MSC_VER)
#define ALEMBERT_NOINLINE __declspec(noinline)
#else
#define ALEMBERT_NOINLINE __attribute__((noinline))
#endif
#endif

namespace alembert::mechanisms::puma560::detail {

// inverse_dynamics in one block.
template <class S>
ALEMBERT_NOINLINE void inverse_dynamics_pack_block1([[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] const S* ALEMBERT_RESTRICT qdd,
    [[maybe_unused]] S* ALEMBERT_RESTRICT tau, [[maybe_unused]] S* ALEMBERT_RESTRICT w,
    [[maybe_unused]] const Inputs<S>& in) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = cosine[0];
  const S t1 = sine[0];
  const S t2 = cosine[1];
  const S t3 = sine[1];
  const S t4 = sine[2];
  const S t5 = cosine[2];
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S qd0 = qd[0];  // d(q1)
  const S t10 = t0 * qd0;
  const S t11 = qd0 * t1;
  const S t12 = t10 * t11;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t13 = qdd1 - t12;
  const S qd2 = qd[2];  // d(q3)
  const S qd1 = qd[1];  // d(q2)
  const S t14 = qd2 + qd1;
  const S t15 = t10 * t3 + t11 * t2;
  const S t16 = t14 * t5 + t4 * t15;
  const S qd4 = qd[4];  // d(q5)
  const S t17 = qd4 + t16;
  const S t18 = t4 * t14 - t5 * t15;
  const S t19 = t10 * t2 - t11 * t3;
  const S qd3 = qd[3];  // d(q4)
  const S t20 = qd3 + t19;
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

/// A pack has 1 values in w. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void inverse_dynamics_packs(int packs, const S* q, const S* qd, const S* qdd, S* tau, S* w,
    const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    inverse_dynamics_pack_block1<S>(q + 6 * k, qd + 6 * k, qdd + 6 * k, tau + 6 * k, w + 1 * k, inputs[k]);
}

// mass_matrix_and_bias in one block.
template <class S>
ALEMBERT_NOINLINE void mass_matrix_and_bias_pack_block1([[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] S* ALEMBERT_RESTRICT M,
    [[maybe_unused]] S* ALEMBERT_RESTRICT c, [[maybe_unused]] S* ALEMBERT_RESTRICT w,
    [[maybe_unused]] const Inputs<S>& in) {
  using detail::sines_and_cosines;
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
  const S t10 = S(0.00020216) * t6;
  const S t11 = t6 * t10;
  const S t12 = t4 * (t11 + S(0.0001));
  const S t13 = t4 * t12;
  const S t14 = t6 * t5;
  const S t15 = S(0.007635112499999984) - (t13 - (t11 - S(0.000116928) * t14));
  const S t16 = t10 * t7;
  const S t17 = S(0.001247328) * t14 + t5 * t16;
  const S t18 = S(5.8464e-05) * t7 - t17 + S(0.010673638499999999);
  const S t19 = t3 * t18;
  const S t20 = S(0.3061122965) - (t11 - S(0.002494656) * t7);
  const S t21 = t19 + t19 + t2 * (t15 - t20);
  const S t22 = t2 * t21;
  const S t23 = S(0.00288) * t7 + S(0.8617950000000001);
  const S t24 = S(0.025374999999999998) - S(0.00288) * t14;
  const S t25 = t2 * t23 - t3 * t24;
  const S t26 = t15 - t22 + S(0.8636) * t25 + S(1.674987602);
  const S t27 = t2 * t24 + t3 * t23;
  const S t28 = t1 * (S(0.0070992) - (t18 - t3 * t21 + S(0.4318) * t27));
  const S t29 = t20 + t22 + S(0.07312640000000004);
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

/// A pack has 1 values in w. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void mass_matrix_and_bias_packs(int packs, const S* q, const S* qd, S* M, S* c, S* w, const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    mass_matrix_and_bias_pack_block1<S>(q + 6 * k, qd + 6 * k, M + 36 * k, c + 6 * k, w + 1 * k, inputs[k]);
}

}  // namespace alembert::mechanisms::puma560::detail

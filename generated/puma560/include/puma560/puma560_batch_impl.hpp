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
  const S qd1 = qd[1];  // d(q2)
  const S t10 = qd1 * qd1;
  const S qd2 = qd[2];  // d(q3)
  const S t11 = qd2 + qd1;
  const S t12 = t11 * t11;
  const S qd0 = qd[0];  // d(q1)
  const S t13 = qd0 * qd0;
  const S t0 = cosine[0];
  const S t14 = t0 * qd0;
  const S t1 = sine[0];
  const S t15 = qd0 * t1;
  const S t16 = t14 * t15;
  const S t17 = t15 * qd1;
  const S t18 = t14 * qd1;
  const S t19 = t14 * t14;
  const S t20 = t15 * t15;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t21 = qdd1 - t16;
  const S t22 = qdd1 + t16;
  const S qdd2 = qdd[2];  // dd(q3)
  const S t23 = qdd1 + qdd2;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t24 = t1 * qdd0;
  const S t25 = t0 * qdd0;
  const S t26 = t17 - t25;
  const S t27 = t17 + t26;
  const S t28 = S(0.2435) * t25 + S(9.81) * t1;
  const S t29 = S(9.81) * t0 - (S(0.4318) * t22 + S(0.1501) * t24);
  const S t30 = t18 + t24;
  const S t31 = t18 + t30;
  const S t32 = S(0.4318) * t27 + S(0.1501) * t13;
  const S t33 = S(0.0934) * t25 - (t28 + S(0.4318) * (t10 + t19));
  const S t3 = sine[1];
  const S t2 = cosine[1];
  const S t34 = t14 * t3 + t15 * t2;
  const S t35 = t14 * t2 - t15 * t3;
  const S t36 = t34 * t35;
  const S t37 = t35 * t35;
  const S t38 = t34 * t34;
  const S t39 = t11 * t34;
  const S qd3 = qd[3];  // d(q4)
  const S t40 = qd3 + t35;
  const S t41 = t23 - t36;
  const S t42 = t23 + t36;
  const S t43 = S(0.0203) * t42 + (t2 * t29 + t3 * t33);
  const S t44 = t43 - S(0.4331) * (t12 + t38);
  const S t45 = t2 * t33 - t3 * t29 + S(0.0203) * (t12 + t37);
  const S t46 = S(0.4331) * t41 + t45;
  const S t47 = t3 * t26 - t2 * t30 - qd2 * t35;
  const S t48 = t3 * t30 + t2 * t26 + qd2 * t34;
  const S t49 = t47 - t11 * t35;
  const S qdd3 = qdd[3];  // dd(q4)
  const S t50 = qdd3 - t48;
  const S t51 = t48 + t39;
  const S t52 = t48 - t39;
  const S t53 = S(0.0203) * t51 - t32;
  const S t54 = t53 - S(0.4331) * t49;
  const S t5 = cosine[2];
  const S t4 = sine[2];
  const S t55 = t11 * t5 + t4 * t34;
  const S t56 = t4 * t11 - t5 * t34;
  const S qd4 = qd[4];  // d(q5)
  const S t57 = qd4 + t55;
  const S t58 = t55 * qd3 + (t4 * t23 + t5 * t47);
  const S t59 = t56 * qd3 - (t5 * t23 - t4 * t47);
  const S qdd4 = qdd[4];  // dd(q5)
  const S t60 = qdd4 - t59;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t61 = t6 * t56 + t40 * t7;
  const S t62 = t6 * t40 - t56 * t7;
  const S t63 = t61 * t62;
  const S t64 = t60 - t63;
  const S t65 = t57 * t57 + t62 * t62;
  const S t66 = S(0.00288) * (t7 * t64 - t6 * t65);
  const S t67 = S(0.7398291387670295) * t43 - (S(1.9898291387670286) * t44 - S(0.00288) * (t6 * t64 + t7 * t65));
  const S qd5 = qd[5];  // d(q6)
  const S t68 = qd5 + (t61 + qd5);
  const S t69 = qd4 * t61 - (t7 * t58 - t6 * t50);
  const S t70 = t57 * t61 + t69;
  const S t71 = qd4 * t62 - (t7 * t50 + t6 * t58);
  const S t72 = S(0.00288) * t70;
  const S qdd5 = qdd[5];  // dd(q6)
  const S t73 = S(-3.9999999999999996e-05) * (t71 - qdd5);
  tau[5] = t73;
  const S t74 = S(0.00020000000000000004) * (t57 * t62 + t71) - t73;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t75 = t60 * t8 + (t69 * t9 + (t62 * t8 - t57 * t9) * t68);
  const S t76 = t69 * t8 - (t60 * t9 + t68 * (t62 * t9 + t57 * t8));
  const S t77 = S(0.00042216000000000004) * t70 - (S(0.00288) * (t4 * t46 - t5 * t54) - S(1.9999999999999998e-05) * (t9 * t75 + t8 * t76));
  const S t78 = S(0.0006221600000000001) * t60 - S(0.00022216) * t63 + S(0.00288) * (t7 * (t5 * t46 + t4 * t54) - t6 * t44) + S(1.9999999999999998e-05) * (t8 * t75 - t9 * t76);
  tau[4] = t78;
  const S t79 = t4 * t72 - t5 * t66 - S(1.9898291387670286) * t46;
  const S t80 = S(1.9898291387670286) * t54 + (t5 * t72 + t4 * t66);
  const S t81 = t6 * t74 + t7 * t77 - S(0.000749999999999984) * (t58 + t55 * t40);
  const S t82 = t6 * t77 - t7 * t74 - (t55 * (S(0.00010000000000000005) * t56) - S(0.001399999999999968) * t50);
  tau[3] = t82;
  const S t83 = S(0.0006499999999999839) * (t59 + t56 * t40) - t78;
  const S t84 = t80 - S(0.7398291387670295) * t53;
  const S t85 = t79 + S(0.7398291387670295) * t45;
  const S t86 = S(0.006820800000000002) * t51 + (t4 * t83 - t5 * t81 - S(0.4331) * t80 - S(0.004703999999999991) * (t12 - t37)) - S(0.067553278) * t49;
  const S t87 = S(-0.0203) * t67 - (t5 * t83 + t4 * t81 + S(0.4331) * t79 - (S(0.006249999999999985) * t42 - (S(0.006820800000000002) * (t37 - t38) - S(0.004703999999999991) * t52 + S(0.067553278) * t41)));
  tau[2] = t87;
  const S t88 = S(0.006249999999999985) * t51 + (S(0.006820800000000002) * t49 + S(0.004703999999999991) * t41) - S(6.938893903907228e-18) * t52 - t82 + S(0.0203) * t84;
  const S t89 = t2 * t85 + t3 * t67 - S(7.540157480314961) * t33;
  const S t90 = S(7.540157480314961) * t29 + (t3 * t85 - t2 * t67);
  const S t91 = S(0.0934) * t89 + (t3 * t86 + t2 * t88) - S(0.4318) * (t84 - S(7.540157480314961) * t32);
  const S t92 = t2 * t86 - t3 * t88 - S(0.0934) * t90 - (S(0.001670399999999999) * (t10 - t19) + (S(0.12059663999999992) * t22 + S(0.0070992) * t27) + S(0.07312640000000004) * t31 + S(0.0254214) * t13);
  const S t93 = t0 * (S(0.001670399999999999) * t21 + S(0.0070992) * t31 - S(0.12059663999999992) * (t10 - t20) + S(0.03605184000000006) * t27 + t91) + t1 * t92;
  tau[0] = S(0.2435) * (t0 * (S(0.1044) * t21 + t89) - t1 * (t90 + S(0.1044) * (t10 + t20))) - t93 + S(1.2736872145669291) * qdd0;
  tau[1] = S(0.03605184000000006) * t22 - (S(0.001670399999999999) * t25 - S(0.12059663999999992) * t24 - S(0.0070992) * (t19 - t20)) + S(0.07312640000000004) * t21 + S(0.1044) * t28 - (S(0.4318) * t90 - t87);
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
  const S t6 = sine[3];
  const S t10 = S(0.00020216) * t6;
  const S t11 = t6 * t10;
  const S t7 = cosine[3];
  const S t12 = t10 * t7;
  const S t13 = S(0.3061122965) - (t11 - S(0.002494656) * t7);
  const S t14 = S(0.00288) * t7 + S(0.8617950000000001);
  const S t15 = S(3.9999999999999996e-05) * t7;
  M[23] = t15;
  M[33] = t15;
  const S t16 = t11 + S(0.001639999999999968);
  M[21] = t16;
  const S t17 = S(3.9999999999999996e-05) * t6;
  const S t5 = cosine[2];
  const S t18 = t6 * t5;
  const S t19 = S(5.8464e-05) * t18 - t16;
  const S t20 = S(0.001247328) * t18 + t5 * t12;
  const S t21 = S(5.8464e-05) * t7 - t20 + S(0.010673638499999999);
  const S t22 = t5 * t7;
  const S t23 = t5 * t17;
  const S t4 = sine[2];
  const S t24 = t4 * t17;
  M[11] = t24;
  M[17] = t24;
  M[31] = t24;
  M[32] = t24;
  const S t25 = t4 * (t11 + S(0.0001));
  const S t26 = t4 * t25;
  const S t27 = S(0.007635112499999984) - (t26 - (t11 - S(0.000116928) * t18));
  const S t28 = S(0.025374999999999998) - S(0.00288) * t18;
  const S t29 = t4 * t6;
  const S t30 = S(5.8464e-05) * t29 - t25 * t5;
  const S t31 = S(-0.001247328) * t29 - t4 * t12;
  M[15] = t31;
  M[20] = t31;
  const S t32 = S(0.00470400000000001) - t31;
  const S t33 = t4 * t7;
  const S t34 = S(0.001247328) * t33 + S(0.0006421600000000001) * t4;
  const S t2 = sine[1];
  const S t35 = t2 * t29;
  const S t36 = t31 + S(-0.001243584) * t35;
  M[9] = t36;
  M[19] = t36;
  const S t3 = cosine[1];
  const S t1 = cosine[0];
  const S t0 = sine[0];
  const S t37 = t1 * (t2 * t20 - (t3 * (t19 - S(0.00043228799999999996) * t29) - S(0.001243584) * t18)) - t0 * (S(0.00043228799999999996) * t35 - (t2 * t19 + t3 * t20));
  M[3] = t37;
  M[18] = t37;
  const S t38 = t3 * t30 - t2 * t32;
  const S t39 = t3 * t32 + t2 * t30;
  const S t40 = t3 * t21;
  const S t41 = t40 + t40 + t2 * (t27 - t13);
  const S t42 = t2 * t41;
  const S t43 = t13 + t42 + S(0.07312640000000004);
  const S t44 = t27 + t13;
  M[14] = t44;
  const S qd0 = qd[0];  // d(q1)
  const S t45 = t1 * qd0;
  const S t46 = t45 * t45;
  const S t47 = t0 * qd0;
  const S t48 = qd0 * qd0;
  const S t49 = t47 * t45;
  const S t50 = S(0.4318) * t49 - S(9.81) * t1;
  const S t51 = t47 * t47;
  const S t52 = t3 * t45 - t2 * t47;
  const S t53 = t52 * t52;
  const S t54 = t2 * t45 + t3 * t47;
  const S qd1 = qd[1];  // d(q2)
  const S t55 = qd1 * t47;
  const S t56 = qd1 * t45;
  const S t57 = qd1 * qd1;
  const S qd2 = qd[2];  // d(q3)
  const S t58 = qd1 + qd2;
  const S t59 = t58 * t58;
  const S t60 = t58 * t52;
  const S t61 = t54 * t52;
  const S qd3 = qd[3];  // d(q4)
  const S t62 = t52 + qd3;
  const S t63 = t58 * t54;
  const S t64 = t54 * t54;
  const S t65 = S(0.1501) * t48 + S(0.8636) * t55;
  const S t66 = t65 - S(0.0406) * t63;
  const S t67 = t66 - S(0.8662) * t60;
  const S t68 = t5 * t54 - t4 * t58;
  const S t69 = t5 * t58 + t4 * t54;
  const S t70 = t4 * t60 + qd3 * t68;
  const S t71 = qd3 * t69 - t5 * t60;
  const S qd4 = qd[4];  // d(q5)
  const S t72 = qd4 + t69;
  const S t73 = S(0.001247328) * t22 + S(0.0006421600000000001) * t5 - S(5.8464e-05) * t6;
  M[16] = t73;
  M[26] = t73;
  const S t74 = t6 * t3 + t2 * t22;
  const S t75 = S(0.001243584) * t74 + t73;
  M[10] = t75;
  M[25] = t75;
  const S t76 = t1 * (S(0.00043228799999999996) * (t3 * t22 - t6 * t2) - t2 * t34 - t33 * (S(0.001243584) - S(5.8464e-05) * t3));
  const S t77 = t0 * (S(0.00043228799999999996) * t74 + (t3 * t34 + t2 * (S(5.8464e-05) * t33))) - t76;
  M[4] = t77;
  M[24] = t77;
  const S t78 = t2 * t14 - t3 * t28;
  const S t79 = t2 * t28 + t3 * t14;
  const S t80 = t1 * (S(0.2435) * (S(0.1044) - t79) - (S(0.001670399999999999) - (S(0.0934) * t79 - t39)));
  const S t81 = t0 * (S(0.1501) * t78 - t38) - t1 * (t39 + S(0.1501) * t79);
  M[2] = t81;
  M[12] = t81;
  const S t82 = t0 * (S(0.2435) * (t78 + S(3.79559)) - (t38 + S(0.0934) * t78 - S(0.001243584) * t29 + S(0.233911466))) + t80;
  M[1] = t82;
  M[6] = t82;
  const S t83 = t1 * (S(0.0070992) - (t21 - t3 * t41 + S(0.4318) * t79));
  const S t84 = S(0.4318) * t78 + t44;
  M[8] = t84;
  M[13] = t84;
  const S t85 = t27 - t42 + S(0.8636) * t78 + S(1.674987602);
  M[0] = t26 + (t85 - t0 * (t83 + t83 + t0 * (t85 - t43))) + S(0.000864576) * t29 + S(1.4724995505);
  M[7] = t85 + t43;
  const S t88 = t1 * (t3 * t15 - t2 * t23) - t0 * (t2 * t15 + t3 * t23);
  M[5] = t88;
  M[30] = t88;
  const S t89 = S(9.81) * t0 + S(0.4318) * (t57 + t46);
  const S t90 = t2 * t89 + t3 * t50 - S(0.0203) * t61;
  const S t91 = t2 * t50 - t3 * t89 + S(0.0203) * (t59 + t53);
  const S t92 = t91 - S(0.4331) * t61;
  const S t93 = t90 + S(0.4331) * (t59 + t64);
  const S t94 = S(0.001670399999999999) * t49 - S(0.0141984) * t56 + S(0.12059663999999992) * (t57 - t51) - S(0.07210368000000011) * t55;
  const S t95 = t6 * t62 + t7 * t68;
  const S t96 = t7 * t62 - t6 * t68;
  const S t97 = t95 * t96;
  const S t98 = t95 * t95 + t72 * t72;
  const S t99 = t70 - t97;
  const S t100 = t6 * t98 - t7 * t99;
  const S t101 = S(0.7398291387670295) * t90 - (S(0.00288) * (t7 * t98 + t6 * t99) + S(1.9898291387670286) * t93);
  const S qd5 = qd[5];  // d(q6)
  const S t102 = qd5 + (t96 + qd5);
  const S t103 = qd4 * t96 - (t6 * t63 + t7 * t71);
  const S t104 = t72 * t96 + t103;
  const S t105 = t6 * t71 - t7 * t63 - t95 * qd4;
  const S t106 = S(3.9999999999999996e-05) * t105;
  c[5] = t106;
  const S t107 = t106 + S(0.00020000000000000004) * (t105 - t95 * t72);
  const S t9 = sine[4];
  const S t8 = cosine[4];
  const S t108 = t102 * (t95 * t9 + t72 * t8) + t70 * t9 - t103 * t8;
  const S t109 = t70 * t8 + (t103 * t9 - t102 * (t72 * t9 - t95 * t8));
  const S t110 = S(0.00288) * (t4 * t92 + t5 * t67) + (S(1.9999999999999998e-05) * (t8 * t108 - t9 * t109) - S(0.00042216000000000004) * t104);
  const S t111 = S(0.0006221600000000001) * t70 + (S(1.9999999999999998e-05) * (t9 * t108 + t8 * t109) + S(0.00288) * (t6 * t93 + t7 * (t5 * t92 - t4 * t67))) - S(0.00022216) * t97;
  c[4] = t111;
  const S t112 = S(0.0006499999999999839) * (t70 + t62 * t68) + t111;
  const S t113 = t7 * t110 + t6 * t107 + S(0.000749999999999984) * (t71 + t62 * t69);
  const S t114 = S(0.0001) * (t68 * t69) - S(0.001399999999999968) * t63 + (t7 * t107 - t6 * t110);
  c[3] = t114;
  const S t115 = S(1.9898291387670286) * t92 - S(0.00288) * (t5 * t100 + t4 * t104);
  const S t116 = S(1.9898291387670286) * t67 + S(0.00288) * (t4 * t100 - t5 * t104);
  const S t117 = S(0.7398291387670295) * t66 - t116;
  const S t118 = t114 + (S(0.004703999999999991) * t61 + S(0.013641600000000004) * t60 - S(0.01249999999999997) * t63) - S(0.0203) * t117;
  const S t119 = S(0.135106556) * t60 - (S(0.004703999999999991) * (t59 - t53) - S(0.013641600000000004) * t63) + (t5 * t113 - t4 * t112 + S(0.4331) * t116);
  const S t120 = S(0.0203) * t101 - (S(0.006820800000000002) * (t53 - t64) - S(0.07380327799999997) * t61 - (S(0.4331) * t115 + (t4 * t113 + t5 * t112)));
  c[2] = t120;
  const S t121 = S(0.7398291387670295) * t91 - t115;
  const S t122 = S(7.540157480314961) * t89 + (t3 * t121 - t2 * t101);
  const S t123 = S(7.540157480314961) * t50 - (t3 * t101 + t2 * t121);
  c[1] = S(0.4318) * t123 + t120 + (S(1.024164) * t0 + (S(0.0070992) * (t46 - t51) - S(0.03707455999999998) * t49));
  const S t125 = t2 * t118 + t3 * t119 + S(0.0934) * t123 - (S(0.12059663999999992) * t49 + S(0.0141984) * t55 + S(0.001670399999999999) * (t57 - t46) + S(0.14625280000000007) * t56 + S(0.0254214) * t48);
  const S t126 = t1 * (S(0.4318) * (S(7.540157480314961) * t65 - t117) + (S(0.0934) * t122 - (t3 * t118 - t2 * t119)) - t94) + t0 * t125;
  c[0] = S(0.2435) * (t1 * (t122 - S(0.1044) * t49) + t0 * (t123 - S(0.1044) * (t57 + t51))) - t126;
  M[35] = S(3.9999999999999996e-05);
  M[28] = S(0.0006421600000000001);
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

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
  const S t52 = S(0.0203) * t51 - t32;
  const S t53 = t52 - S(0.4331) * t49;
  const S t5 = cosine[2];
  const S t4 = sine[2];
  const S t54 = t11 * t5 + t4 * t34;
  const S t55 = t4 * t11 - t5 * t34;
  const S qd4 = qd[4];  // d(q5)
  const S t56 = qd4 + t54;
  const S t57 = t54 * qd3 + (t4 * t23 + t5 * t47);
  const S t58 = t55 * qd3 - (t5 * t23 - t4 * t47);
  const S qdd4 = qdd[4];  // dd(q5)
  const S t59 = qdd4 - t58;
  const S t6 = sine[3];
  const S t7 = cosine[3];
  const S t60 = t6 * t55 + t40 * t7;
  const S t61 = t6 * t40 - t55 * t7;
  const S t62 = t60 * t61;
  const S t63 = t59 - t62;
  const S t64 = t56 * t56 + t61 * t61;
  const S t65 = S(0.00288) * (t7 * t63 - t6 * t64);
  const S t66 = S(0.7398291387670295) * t43 - (S(1.9898291387670286) * t44 - S(0.00288) * (t6 * t63 + t7 * t64));
  const S qd5 = qd[5];  // d(q6)
  const S t67 = qd5 + (t60 + qd5);
  const S t68 = qd4 * t60 - (t7 * t57 - t6 * t50);
  const S t69 = t56 * t60 + t68;
  const S t70 = qd4 * t61 - (t7 * t50 + t6 * t57);
  const S t71 = S(0.00288) * t69;
  const S qdd5 = qdd[5];  // dd(q6)
  const S t72 = S(-3.9999999999999996e-05) * (t70 - qdd5);
  tau[5] = t72;
  const S t73 = S(0.00020000000000000004) * (t56 * t61 + t70) - t72;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t74 = t59 * t8 + (t68 * t9 + (t61 * t8 - t56 * t9) * t67);
  const S t75 = t68 * t8 - (t59 * t9 + t67 * (t61 * t9 + t56 * t8));
  const S t76 = S(0.00042216000000000004) * t69 - (S(0.00288) * (t4 * t46 - t5 * t53) - S(1.9999999999999998e-05) * (t9 * t74 + t8 * t75));
  const S t77 = S(0.0006221600000000001) * t59 - S(0.00022216) * t62 + S(0.00288) * (t7 * (t5 * t46 + t4 * t53) - t6 * t44) + S(1.9999999999999998e-05) * (t8 * t74 - t9 * t75);
  tau[4] = t77;
  const S t78 = t4 * t71 - t5 * t65 - S(1.9898291387670286) * t46;
  const S t79 = S(1.9898291387670286) * t53 + (t5 * t71 + t4 * t65);
  const S t80 = t6 * t73 + t7 * t76 - S(0.000749999999999984) * (t57 + t54 * t40);
  const S t81 = t6 * t76 - t7 * t73 - (t54 * (S(0.00010000000000000005) * t55) - S(0.001399999999999968) * t50);
  tau[3] = t81;
  const S t82 = S(0.0006499999999999839) * (t58 + t55 * t40) - t77;
  const S t83 = t79 - S(0.7398291387670295) * t52;
  const S t84 = S(0.006249999999999985) * t51 + (S(0.006820800000000002) * t49 + S(0.004703999999999991) * t41) - t81 + S(0.0203) * t83;
  const S t85 = S(0.004703999999999991) * (t12 - t37) - S(0.006820800000000002) * t51 + S(0.067553278) * t49 - (t4 * t82 - t5 * t80 - S(0.4331) * t79);
  const S t86 = t5 * t82 + t4 * t80 + S(0.4331) * t78 - (S(0.006249999999999985) * t42 - (S(0.006820800000000002) * (t37 - t38) - S(0.004703999999999991) * (t48 - t39) + S(0.067553278) * t41));
  const S t87 = t78 + S(0.7398291387670295) * t45;
  const S t88 = S(-0.0203) * t66 - t86;
  tau[2] = t88;
  const S t89 = t2 * t87 + t3 * t66 - S(7.540157480314961) * t33;
  const S t90 = S(7.540157480314961) * t29 + (t3 * t87 - t2 * t66);
  const S t91 = S(0.4318) * (t83 - S(7.540157480314961) * t32) - (S(0.0934) * t89 - (t3 * t85 - t2 * t84));
  const S t92 = S(0.001670399999999999) * (t10 - t19) + (S(0.1205966399999999) * t22 + S(0.0070992) * t27) + S(0.07312640000000004) * t31 + S(0.0254214) * t13 + (t3 * t84 + t2 * t85 + S(0.0934) * t90);
  const S t93 = t0 * (S(0.03605184000000006) * t27 - (S(0.1205966399999999) * (t10 - t20) - (S(0.001670399999999999) * t21 + S(0.0070992) * t31)) - t91) - t1 * t92;
  tau[0] = S(0.2435) * (t0 * (S(0.1044) * t21 + t89) - t1 * (t90 + S(0.1044) * (t10 + t20))) - t93 + S(1.2736872145669291) * qdd0;
  tau[1] = S(0.1044) * t28 + (S(0.03605184000000006) * t22 - (S(0.001670399999999999) * t25 - S(0.1205966399999999) * t24 - S(0.0070992) * (t19 - t20)) + S(0.07312640000000004) * t21) - (S(0.4318) * t90 - t88);
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
  const S t13 = S(0.00288) * t7 + S(0.8617950000000001);
  const S t14 = S(0.3061122965) - (t11 - S(0.002494656) * t7);
  const S t15 = t11 + S(0.001639999999999968);
  M[21] = t15;
  const S t16 = S(3.9999999999999996e-05) * t7;
  M[23] = t16;
  M[33] = t16;
  const S t17 = S(3.9999999999999996e-05) * t6;
  const S t4 = sine[2];
  const S t18 = t6 * t4;
  const S t19 = t4 * (t11 + S(0.0001));
  const S t20 = t4 * t19;
  const S t5 = cosine[2];
  const S t21 = S(5.8464e-05) * t18 - t19 * t5;
  const S t22 = t6 * t5;
  const S t23 = S(0.007635112499999984) - (t20 - (t11 - S(0.000116928) * t22));
  const S t24 = t15 - S(5.8464e-05) * t22;
  const S t25 = S(0.025374999999999998) - S(0.00288) * t22;
  const S t26 = t23 + t14;
  M[14] = t26;
  const S t27 = t5 * t7;
  const S t28 = t4 * t7;
  const S t29 = S(0.0006421600000000001) * t4 + S(0.001247328) * t28;
  const S t30 = S(0.001247328) * t27 + S(0.0006421600000000001) * t5 - S(5.8464e-05) * t6;
  M[16] = t30;
  M[26] = t30;
  const S t31 = S(0.001247328) * t22 + t5 * t12;
  const S t32 = S(-0.001247328) * t18 - t4 * t12;
  M[15] = t32;
  M[20] = t32;
  const S t33 = S(0.00470400000000001) - t32;
  const S t34 = S(0.010673638499999999) - (t31 - S(5.8464e-05) * t7);
  const S t2 = cosine[1];
  const S t35 = t2 * t34;
  const S t3 = sine[1];
  const S t36 = t35 + t35 + t3 * (t23 - t14);
  const S t37 = t3 * t36;
  const S t38 = t14 + t37 + S(0.07312640000000004);
  const S t39 = t18 * t3;
  const S t40 = t32 + S(-0.001243584) * t39;
  M[9] = t40;
  M[19] = t40;
  const S t1 = cosine[0];
  const S t0 = sine[0];
  const S t41 = t1 * (t3 * t31 + (S(0.001243584) * t22 + t2 * (t24 + S(0.00043228799999999996) * t18))) + t0 * (t2 * t31 - t3 * t24 - S(0.00043228799999999996) * t39);
  M[3] = t41;
  M[18] = t41;
  const S qd0 = qd[0];  // d(q1)
  const S t42 = t1 * qd0;
  const S t43 = qd0 * qd0;
  const S t44 = t0 * qd0;
  const S t45 = t42 * t44;
  const S t46 = t42 * t42;
  const S t47 = t3 * t42 + t2 * t44;
  const S t48 = t2 * t42 - t3 * t44;
  const S qd1 = qd[1];  // d(q2)
  const S t49 = qd1 * t42;
  const S t50 = qd1 * qd1;
  const S t51 = qd1 * t44;
  const S t52 = t44 * t44;
  const S qd2 = qd[2];  // d(q3)
  const S t53 = qd1 + qd2;
  const S t54 = t53 * t53;
  const S t55 = t48 * t53;
  const S t56 = t47 * t48;
  const S t57 = t47 * t47;
  const S t58 = t47 * t53;
  const S t59 = t48 * t48;
  const S qd3 = qd[3];  // d(q4)
  const S t60 = t48 + qd3;
  const S t61 = S(0.07210368000000011) * t51 - (S(0.001670399999999999) * t45 - S(0.0141984) * t49 + S(0.1205966399999999) * (t50 - t52));
  const S t62 = S(9.81) * t1 - S(0.4318) * t45;
  const S t63 = S(0.8636) * t51 + S(0.1501) * t43;
  const S t64 = S(0.0406) * t58 - t63;
  const S t65 = t64 + S(0.8662) * t55;
  const S t66 = S(9.81) * t0 + S(0.4318) * (t50 + t46);
  const S t67 = t5 * t17;
  const S t68 = t4 * t17;
  M[11] = t68;
  M[17] = t68;
  M[31] = t68;
  M[32] = t68;
  const S t69 = t5 * t53 + t4 * t47;
  const S t70 = t4 * t53 - t5 * t47;
  const S t71 = qd3 * t70 - t4 * t55;
  const S t72 = t5 * t55 - t69 * qd3;
  const S qd4 = qd[4];  // d(q5)
  const S t73 = qd4 + t69;
  const S t74 = -(t1 * (t3 * t67 - t2 * t16) + t0 * (t2 * t67 + t3 * t16));
  M[5] = t74;
  M[30] = t74;
  const S t75 = t25 * t2 - t13 * t3;
  const S t76 = t25 * t3 + t2 * t13;
  const S t77 = t26 - S(0.4318) * t75;
  M[8] = t77;
  M[13] = t77;
  const S t78 = S(1.674987602) - (S(0.8636) * t75 - (t23 - t37));
  M[7] = t78 + t38;
  const S t80 = t3 * t33 - t2 * t21 + S(0.0934) * t75;
  const S t81 = t2 * t33 + t3 * t21 - S(0.0934) * t76;
  const S t82 = t0 * (t80 - S(0.2435) * t75) - t1 * (t81 + S(0.2435) * t76);
  M[2] = t82;
  M[12] = t82;
  const S t83 = t1 * (S(0.2435) * (S(0.1044) - t76) - (t81 + S(0.001670399999999999))) - t0 * (S(0.233911466) - (t80 + S(0.001243584) * t18) - S(0.2435) * (S(3.79559) - t75));
  M[1] = t83;
  M[6] = t83;
  const S t84 = t1 * (S(0.0070992) - (S(0.4318) * t76 + (t34 - t2 * t36)));
  M[0] = S(0.000864576) * t18 + (t20 + (t78 - t0 * (t0 * (t78 - t38) + (t84 + t84)))) + S(1.4724995505);
  const S t86 = t3 * t27 + t6 * t2;
  const S t87 = t1 * (t28 * (S(0.001243584) - S(5.8464e-05) * t2) + (t3 * t29 + S(0.00043228799999999996) * (t6 * t3 - t2 * t27)));
  const S t88 = t0 * (t3 * (S(5.8464e-05) * t28) + t2 * t29 + S(0.00043228799999999996) * t86) + t87;
  M[4] = t88;
  M[24] = t88;
  const S t89 = S(0.001243584) * t86 + t30;
  M[10] = t89;
  M[25] = t89;
  const S t90 = S(0.0203) * t56 + (t2 * t62 - t3 * t66);
  const S t91 = t90 - S(0.4331) * (t57 + t54);
  const S t92 = t3 * t62 + t2 * t66 - S(0.0203) * (t54 + t59);
  const S t93 = t92 + S(0.4331) * t56;
  const S t94 = t6 * t60 - t7 * t70;
  const S t95 = t6 * t70 + t7 * t60;
  const S t96 = t94 * t95;
  const S t97 = t73 * t73 + t94 * t94;
  const S t98 = t71 + t96;
  const S t99 = S(0.00288) * (t7 * t98 + t6 * t97);
  const S t100 = S(0.7398291387670295) * t90 - (S(1.9898291387670286) * t91 - S(0.00288) * (t7 * t97 - t6 * t98));
  const S qd5 = qd[5];  // d(q6)
  const S t101 = qd5 + (t95 + qd5);
  const S t102 = qd4 * t95 + (t7 * t72 - t6 * t58);
  const S t103 = t102 + t73 * t95;
  const S t104 = qd4 * t94 + (t6 * t72 + t7 * t58);
  const S t105 = S(-3.9999999999999996e-05) * t104;
  c[5] = t105;
  const S t106 = S(0.00020000000000000004) * (t73 * t94 + t104) - t105;
  const S t107 = S(0.00288) * t103;
  const S t8 = cosine[4];
  const S t9 = sine[4];
  const S t108 = t102 * t8 + (t71 * t9 - (t94 * t9 + t73 * t8) * t101);
  const S t109 = t71 * t8 - (t102 * t9 + t101 * (t94 * t8 - t73 * t9));
  const S t110 = S(0.00288) * (t5 * t65 + t4 * t93) + (S(0.00042216000000000004) * t103 + S(1.9999999999999998e-05) * (t8 * t108 - t9 * t109));
  const S t111 = S(-1.9999999999999998e-05) * (t8 * t109 + t9 * t108) - S(0.00288) * (t6 * t91 - t7 * (t4 * t65 - t5 * t93)) - S(0.0006221600000000001) * t71 - S(0.00022216) * t96;
  c[4] = t111;
  const S t112 = S(0.0006499999999999839) * (t71 + t60 * t70) - t111;
  const S t113 = S(0.000749999999999984) * (t72 - t69 * t60) + (t6 * t106 + t7 * t110);
  const S t114 = t6 * t110 - t7 * t106 - (t69 * (S(0.00010000000000000005) * t70) + S(0.001399999999999968) * t58);
  c[3] = t114;
  const S t115 = S(1.9898291387670286) * t93 + (t5 * t99 + t4 * t107);
  const S t116 = t4 * t99 - t5 * t107 - S(1.9898291387670286) * t65;
  const S t117 = t116 + S(0.7398291387670295) * t64;
  const S t118 = S(0.0203) * t117 - (S(0.01249999999999997) * t58 - (S(0.013641600000000004) * t55 + S(0.004703999999999991) * t56) - t114);
  const S t119 = S(0.013641600000000004) * t58 - S(0.004703999999999991) * (t54 - t59) + S(0.135106556) * t55 + (S(0.4331) * t116 - (t5 * t113 - t4 * t112));
  const S t120 = S(0.006820800000000002) * (t57 - t59) + S(0.07380327799999997) * t56 - (S(0.4331) * t115 + (t5 * t112 + t4 * t113)) - S(0.0203) * t100;
  c[2] = t120;
  const S t121 = S(0.7398291387670295) * t92 - t115;
  const S t122 = S(7.540157480314961) * t62 - (t2 * t100 + t3 * t121);
  const S t123 = t3 * t100 - t2 * t121 + S(7.540157480314961) * t66;
  c[1] = S(1.024164) * t0 - (S(0.03707455999999998) * t45 - S(0.0070992) * (t46 - t52)) - (S(0.4318) * t122 - t120);
  const S t125 = S(0.2435) * (t1 * (t123 - S(0.1044) * t45) - t0 * (t122 + S(0.1044) * (t50 + t52)));
  const S t126 = S(0.0254214) * t43 + (S(0.14625280000000007) * t49 + (S(0.001670399999999999) * (t50 - t46) + (S(0.0141984) * t51 + S(0.1205966399999999) * t45))) + (S(0.0934) * t122 - (t2 * t119 + t3 * t118));
  c[0] = t0 * t126 - t1 * (S(0.4318) * (t117 + S(7.540157480314961) * t63) - (t2 * t118 - t3 * t119 - S(0.0934) * t123) + t61) + t125;
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

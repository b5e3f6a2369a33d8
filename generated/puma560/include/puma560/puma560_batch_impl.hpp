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
// Registers do not hold everything. What stands behind this is read from memory again: without it, compilers would keep
// values in registers that are needed for others, and others in memory.
#ifndef ALEMBERT_FROM_MEMORY
#if defined(__GNUC__)
#define ALEMBERT_FROM_MEMORY __asm__ volatile("" : : : "memory")
#else
#define ALEMBERT_FROM_MEMORY static_cast<void>(0)
#endif
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
  const S qd0 = qd[0];  // d(q1)
  const S t10 = t0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S t11 = qd1 * qd1;
  const S qd2 = qd[2];  // d(q3)
  const S t12 = qd2 + qd1;
  w[0] = t12;
  const S t1 = sine[0];
  const S t13 = qd0 * t1;
  const S t2 = cosine[1];
  const S t14 = t13 * t2;
  const S t3 = sine[1];
  const S t15 = t13 * t3;
  const S t16 = t10 * t2 - t15;
  w[1] = t16;
  const S t17 = t10 * t3 + t14;
  w[2] = t17;
  const S t4 = sine[2];
  const S t18 = t4 * t17;
  const S t19 = t17 * t17;
  const S t20 = t16 * t16;
  const S t21 = qd[3] + t16;
  w[3] = t21;
  const S t5 = cosine[2];
  const S t22 = t12 * t5 + t18;
  w[4] = t22;
  const S t23 = t5 * t17;
  const S t24 = t12 * t12;
  const S t25 = t20 - t19;
  w[5] = t25;
  const S t26 = t24 - t20;
  w[6] = t26;
  const S t27 = t4 * t12 - t23;
  const S t7 = cosine[3];
  const S t28 = t21 * t7;
  const S t29 = qd[4] + t22;
  w[7] = t29;
  const S t30 = t27 * t7;
  const S t6 = sine[3];
  const S t31 = t6 * t27 + t28;
  w[8] = t31;
  const S t32 = t6 * t21 - t30;
  w[9] = t32;
  const S t33 = t24 + t20;
  w[10] = t33;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t34 = t0 * qdd0;
  const S t35 = t1 * qdd0;
  const S t36 = t24 + t19;
  w[11] = t36;
  const S t37 = S(0.1205966399999999) * t35;
  const S t38 = S(0.001670399999999999) * t34 - t37;
  const S t9 = sine[4];
  const S t39 = t29 * t9;
  const S t8 = cosine[4];
  const S t40 = t29 * t8;
  const S t41 = t32 * t9 + t40;
  w[12] = t41;
  const S t42 = t32 * t8 - t39;
  w[13] = t42;
  const S t43 = t10 * t13;
  const S t44 = t10 * t10;
  const S t45 = t13 * t13;
  const S t46 = t10 * qd1;
  const S t47 = t11 + t44;
  const S t48 = S(9.81) * t1;
  const S t49 = t11 - t45;
  w[14] = t49;
  const S t50 = S(0.2435) * t34 + t48;
  w[15] = t50;
  const S t51 = t11 - t44;
  const S t52 = t13 * qd1;
  const S t53 = t44 - t45;
  const S t54 = t11 + t45;
  w[16] = t54;
  const S t55 = t50 + S(0.4318) * t47;
  const S t56 = S(0.0934) * t34 - t55;
  w[17] = t56;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t57 = qdd1 + t43;
  const S t58 = t38 - S(0.0070992) * t53;
  const S t59 = S(0.03605184000000006) * t57 - t58;
  w[18] = t59;
  const S t60 = qdd1 - t43;
  w[19] = t60;
  const S t61 = t52 - t34;
  const S t62 = t52 + t61;
  w[20] = t62;
  ALEMBERT_FROM_MEMORY;
  const S t2_2 = cosine[1];
  const S t63 = t2_2 * t61;
  const S t64 = t46 + t35;
  const S t65 = S(0.1501) * t35;
  const S t66 = S(0.0070992) * t62;
  const S t67 = qd[0] * qd[0];
  const S t68 = t2_2 * t64;
  const S t69 = t46 + t64;
  const S t3_2 = sine[1];
  const S t70 = t3_2 * t64 + t63;
  const S t71 = S(0.1205966399999999) * t57 + t66;
  const S t72 = t3_2 * t61 - t68;
  const S t73 = S(0.001670399999999999) * t51 + t71;
  const S t74 = qdd1 + qdd[2];
  const S qd2_2 = qd[2];  // d(q3)
  const S t17_2 = w[2];
  const S t75 = t70 + qd2_2 * t17_2;
  const S t76 = S(0.4318) * t57 + t65;
  const S t16_2 = w[1];
  const S t77 = t72 - qd2_2 * t16_2;
  const S t78 = S(0.00010000000000000005) * t27;
  const S t79 = t73 + S(0.07312640000000004) * t69;
  const S t0_2 = cosine[0];
  const S t80 = S(9.81) * t0_2 - t76;
  w[1] = t80;
  const S t81 = t79 + S(0.0254214) * t67;
  w[2] = t81;
  const S t12_2 = w[0];
  const S t82 = t77 - t12_2 * t16_2;
  w[21] = t82;
  const S t83 = t17_2 * t16_2;
  const S t84 = t12_2 * t17_2;
  const S t85 = t3_2 * t56;
  const S t86 = t3_2 * t80;
  const S t87 = t2_2 * t56 - t86;
  const S t88 = t87 + S(0.0203) * w[10];
  w[0] = t88;
  const S t89 = t2_2 * t80 + t85;
  const S t5_2 = cosine[2];
  const S t90 = t5_2 * t77;
  const S t4_2 = sine[2];
  const S t91 = t4_2 * t77;
  const S t92 = t75 - t84;
  w[10] = t92;
  const S t93 = qdd[3] - t75;
  const S t94 = t4_2 * t74 + t90;
  const S t95 = S(0.001399999999999968) * t93;
  const S t96 = t5_2 * t74 - t91;
  const S t97 = S(0.0070992) * t69;
  w[22] = t97;
  const S t22_2 = w[4];
  const S t98 = t22_2 * t78 - t95;
  w[23] = t98;
  const S qd3 = qd[3];  // d(q4)
  const S t99 = t22_2 * qd3 + t94;
  const S t21_2 = w[3];
  const S t100 = t99 + t22_2 * t21_2;
  w[4] = t100;
  const S t101 = t27 * qd3 - t96;
  const S t102 = t74 + t83;
  w[3] = t102;
  const S t103 = t74 - t83;
  w[24] = t103;
  const S t104 = S(0.004703999999999991) * t103;
  const S t105 = S(0.0203) * t102 + t89;
  w[25] = t105;
  const S t6_2 = sine[3];
  const S t106 = t6_2 * t93;
  const S t31_2 = w[8];
  const S t32_2 = w[9];
  const S t107 = t31_2 * t32_2;
  const S t108 = S(0.1501) * t67;
  const S t109 = t101 + t27 * t21_2;
  w[9] = t109;
  const S t7_2 = cosine[3];
  const S t110 = t7_2 * t99 - t106;
  const S t111 = t75 + t84;
  const S t112 = qdd[4] - t101;
  const S t113 = t112 - t107;
  const S t114 = t32_2 * t32_2;
  ALEMBERT_FROM_MEMORY;
  const S t82_2 = w[21];
  const S t115 = S(0.006820800000000002) * t82_2 + t104;
  const S t116 = t6_2 * t99;
  const S t29_2 = w[7];
  const S t117 = t29_2 * t29_2 + t114;
  const S t62_2 = w[20];
  const S t118 = S(0.4318) * t62_2 + t108;
  w[26] = t118;
  const S t119 = S(0.006249999999999985) * t111 + t115;
  w[27] = t119;
  const S t120 = t7_2 * t93 + t116;
  const S qd5 = qd[5];  // d(q6)
  const S t121 = t31_2 + qd5;
  const S qd4 = qd[4];  // d(q5)
  const S t122 = qd4 * t31_2 - t110;
  const S t123 = qd5 + t121;
  const S t124 = w[13] * t123;
  const S t125 = t123 * w[12];
  const S t126 = S(0.00022216) * t107;
  const S t127 = qd4 * t32_2 - t120;
  const S t128 = t7_2 * t117;
  const S t129 = t6_2 * t113 + t128;
  const S t130 = S(0.0006221600000000001) * t112 - t126;
  w[12] = t130;
  const S t9_2 = sine[4];
  const S t131 = t112 * t9_2 + t125;
  const S t132 = t6_2 * t117;
  const S t133 = t122 * t9_2 + t124;
  const S t134 = t7_2 * t113 - t132;
  const S t8_2 = cosine[4];
  const S t135 = t122 * t8_2 - t131;
  const S t136 = S(0.00288) * t129;
  w[13] = t136;
  ALEMBERT_FROM_MEMORY;
  const S t29_3 = w[7];
  const S t137 = t29_3 * t32_2 + t127;
  const S t138 = t112 * t8_2 + t133;
  const S t139 = t9_2 * t135;
  const S t140 = t127 - qdd[5];
  const S t141 = S(0.0203) * t111 - t118;
  const S t142 = S(0.4331) * w[24] + w[0];
  const S t143 = t8_2 * t138 - t139;
  const S t144 = S(0.00288) * t134;
  const S t145 = t29_3 * w[8] + t122;
  const S t146 = t8_2 * t135;
  const S t147 = t9_2 * t138 + t146;
  const S t148 = S(0.006820800000000002) * t111;
  const S t149 = S(0.00288) * t145;
  const S t150 = S(-3.9999999999999996e-05) * t140;
  tau[5] = t150;
  const S t151 = S(1.9999999999999998e-05) * t147;
  const S t152 = S(0.00020000000000000004) * t137 - t150;
  const S t4_3 = sine[2];
  const S t153 = t4_3 * t144;
  const S t82_3 = w[21];
  const S t154 = t141 - S(0.4331) * t82_3;
  const S t5_3 = cosine[2];
  const S t155 = t5_3 * t149 + t153;
  const S t156 = t5_3 * t144;
  const S t157 = t4_3 * t149 - t156;
  const S t158 = t5_3 * t154;
  const S t159 = t4_3 * t142 - t158;
  const S t160 = t4_3 * t154;
  const S t161 = S(1.9898291387670286) * t154 + t155;
  const S t162 = S(0.00288) * t159 - t151;
  const S t105_2 = w[25];
  const S t163 = t105_2 - S(0.4331) * w[11];
  const S t164 = t6_2 * t163;
  const S t165 = t5_3 * t142 + t160;
  const S t7_3 = cosine[3];
  const S t166 = t7_3 * t165 - t164;
  const S t167 = S(0.00042216000000000004) * t145 - t162;
  const S t168 = w[12] + S(0.00288) * t166;
  const S t169 = t168 + S(1.9999999999999998e-05) * t143;
  tau[4] = t169;
  const S t170 = t157 - S(1.9898291387670286) * t142;
  const S t171 = t7_3 * t167;
  const S t172 = t161 - S(0.7398291387670295) * t141;
  const S t173 = S(0.004703999999999991) * w[6] - t148;
  const S t174 = t7_3 * t152;
  const S t175 = S(1.9898291387670286) * t163 - w[13];
  const S t176 = t6_2 * t152 + t171;
  const S t177 = S(0.0006499999999999839) * w[9] - t169;
  const S t178 = t176 - S(0.000749999999999984) * w[4];
  const S t179 = t5_3 * t178;
  const S t180 = t6_2 * t167 - t174;
  ALEMBERT_FROM_MEMORY;
  const S t4_4 = sine[2];
  const S t181 = t4_4 * t177 - t179;
  const S t182 = S(0.7398291387670295) * w[25] - t175;
  const S t183 = t4_4 * t178;
  const S t184 = t180 - w[23];
  tau[3] = t184;
  const S t185 = t170 + S(0.7398291387670295) * w[0];
  const S t186 = t181 - S(0.4331) * t161;
  const S t187 = t173 + S(0.067553278) * w[21];
  const S t188 = t5_3 * t177 + t183;
  const S t189 = S(0.004703999999999991) * w[10];
  const S t190 = w[27] - t184;
  const S t191 = t187 - t186;
  const S t192 = t190 + S(0.0203) * t172;
  const S t2_3 = cosine[1];
  const S t193 = t2_3 * t182;
  const S t3_3 = sine[1];
  const S t194 = t3_3 * t182;
  const S t195 = t3_3 * t185 - t193;
  const S t196 = t2_3 * t185 + t194;
  const S t197 = t188 + S(0.4331) * t170;
  const S t198 = t172 - S(7.540157480314961) * w[26];
  const S t199 = S(0.006820800000000002) * w[5] - t189;
  const S t200 = S(7.540157480314961) * w[1] + t195;
  const S t60_2 = w[19];
  const S t201 = w[18] + S(0.07312640000000004) * t60_2;
  const S t202 = t199 + S(0.067553278) * w[24];
  const S t203 = t2_3 * t191;
  const S t204 = t3_3 * t192 + t203;
  const S t205 = t200 + S(0.1044) * w[16];
  const S t206 = t196 - S(7.540157480314961) * w[17];
  const S t207 = S(0.006249999999999985) * w[3] - t202;
  const S t208 = t2_3 * t192;
  const S t209 = t204 + S(0.0934) * t200;
  const S t210 = t3_3 * t191 - t208;
  const S t1_2 = sine[0];
  const S t211 = t1_2 * t205;
  const S t212 = t197 - t207;
  const S t213 = S(0.1044) * t60_2 + t206;
  const S t214 = S(-0.0203) * t182 - t212;
  tau[2] = t214;
  const S t215 = S(0.001670399999999999) * t60_2 + w[22];
  const S t216 = w[2] + t209;
  const S t217 = S(0.1205966399999999) * w[14] - t215;
  const S t218 = S(0.03605184000000006) * w[20] - t217;
  const S t219 = S(0.4318) * t200 - t214;
  const S t220 = S(0.0934) * t206 - t210;
  const S t221 = S(0.1044) * w[15] + t201;
  const S t222 = S(0.4318) * t198 - t220;
  const S t223 = t1_2 * t216;
  const S t224 = t218 - t222;
  tau[1] = t221 - t219;
  const S t0_3 = cosine[0];
  const S t226 = t0_3 * t213 - t211;
  const S t227 = t0_3 * t224 - t223;
  const S t228 = S(0.2435) * t226 - t227;
  tau[0] = t228 + S(1.2736872145669291) * qdd[0];
}

/// All packs together have 28 values in w. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void inverse_dynamics_packs(int packs, const S* q, const S* qd, const S* qdd, S* tau, S* w,
    const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    inverse_dynamics_pack_block1<S>(q + 6 * k, qd + 6 * k, qdd + 6 * k, tau + 6 * k, w, inputs[k]);
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
  const S t10 = S(3.9999999999999996e-05) * t6;
  const S t11 = S(0.00020216) * t6;
  const S t12 = t6 * t11;
  const S t13 = t12 + S(0.001639999999999968);
  M[21] = t13;
  const S t5 = cosine[2];
  const S t14 = t6 * t5;
  w[0] = t14;
  const S t7 = cosine[3];
  const S t15 = t11 * t7;
  w[1] = t15;
  const S t16 = t12 - S(0.000116928) * t14;
  const S t4 = sine[2];
  const S t17 = t4 * t10;
  M[11] = t17;
  M[17] = t17;
  M[31] = t17;
  M[32] = t17;
  const S t18 = t6 * t4;
  w[2] = t18;
  const S t19 = t12 + S(0.0001);
  const S t20 = t5 * t7;
  const S t21 = t4 * t19;
  w[3] = t21;
  const S t22 = t4 * t21;
  w[4] = t22;
  const S t23 = t13 - S(5.8464e-05) * t14;
  const S t24 = S(3.9999999999999996e-05) * t7;
  M[23] = t24;
  M[33] = t24;
  const S t25 = t23 + S(0.00043228799999999996) * t18;
  const S t26 = t22 - t16;
  const S t2 = cosine[1];
  const S t27 = t2 * t25;
  const S t28 = t4 * t7;
  const S t29 = t12 - S(0.002494656) * t7;
  const S t30 = S(0.3061122965) - t29;
  w[5] = t30;
  const S t31 = S(0.00288) * t7 + S(0.8617950000000001);
  const S t32 = S(0.001243584) * t14 + t27;
  w[6] = t32;
  const S t33 = t4 * t15;
  w[7] = t33;
  const S t34 = t5 * t10;
  const S t35 = S(0.001247328) * t28;
  const S t3 = sine[1];
  const S t36 = t3 * t23;
  w[8] = t36;
  const S t37 = S(0.025374999999999998) - S(0.00288) * t14;
  const S t38 = S(0.007635112499999984) - t26;
  w[9] = t38;
  const S t39 = S(0.0006421600000000001) * t4 + t35;
  const S t40 = t2 * t24;
  const S t41 = t38 - t30;
  w[10] = t41;
  const S t42 = t2 * t31;
  const S t43 = S(0.0006421600000000001) * t5;
  const S t44 = t31 * t3;
  const S t45 = t37 * t3 + t42;
  w[11] = t45;
  const S t46 = t2 * t20;
  const S t47 = t38 + t30;
  M[14] = t47;
  ALEMBERT_FROM_MEMORY;
  const S t6_2 = sine[3];
  const S t48 = t6_2 * t3 - t46;
  const S t49 = t3 * t24;
  const S t50 = t37 * t2 - t44;
  w[12] = t50;
  const S t51 = t2 * t34 + t49;
  const S t52 = S(0.00043228799999999996) * t48;
  const S t53 = t3 * t34 - t40;
  const S t54 = t3 * t39 + t52;
  const S t55 = S(0.001247328) * t20 + t43;
  const S t0 = sine[0];
  const S t56 = t0 * t51;
  const S t1 = cosine[0];
  const S t57 = t1 * t53 + t56;
  const S t58 = t47 - S(0.4318) * t50;
  M[8] = t58;
  M[13] = t58;
  const S t59 = S(0.001243584) - S(5.8464e-05) * t2;
  const S t60 = t2 * t39;
  const S t61 = S(5.8464e-05) * t28;
  const S t62 = t6_2 * t2;
  const S t63 = t28 * t59 + t54;
  const S qd0 = qd[0];  // d(q1)
  const S t64 = t1 * qd0;
  const S t65 = -t57;
  M[5] = t65;
  M[30] = t65;
  const S t66 = t3 * t61 + t60;
  const S t67 = t3 * t20 + t62;
  const S t68 = t0 * qd0;
  const S t69 = t68 * t68;
  const S t70 = t64 * t64;
  const S t71 = t70 - t69;
  w[13] = t71;
  const S t72 = t55 - S(5.8464e-05) * t6_2;
  M[16] = t72;
  M[26] = t72;
  const S t73 = t66 + S(0.00043228799999999996) * t67;
  const S t74 = t1 * t63;
  const S t75 = t0 * t73 + t74;
  M[4] = t75;
  M[24] = t75;
  const S qd1 = qd[1];  // d(q2)
  const S t76 = qd1 * qd1;
  const S t77 = t64 * t68;
  w[14] = t77;
  const S t78 = S(0.001243584) * t67 + t72;
  M[10] = t78;
  M[25] = t78;
  const S t79 = S(0.4318) * t77;
  const S t80 = t2 * t68;
  const S t81 = t76 + t70;
  const S t82 = S(9.81) * t1 - t79;
  w[15] = t82;
  const S t83 = qd1 * t68;
  const S t84 = t76 + t69;
  w[16] = t84;
  const S t85 = S(0.1205966399999999) * t77;
  const S t86 = t3 * t68;
  const S t87 = t2 * t64 - t86;
  const S t88 = t76 - t70;
  const S t89 = S(0.4318) * t81;
  const S t90 = t3 * t64 + t80;
  const S t91 = S(0.0141984) * t83 + t85;
  const S t92 = S(9.81) * t0 + t89;
  w[17] = t92;
  const S t93 = qd1 * t64;
  const S t94 = S(0.001670399999999999) * t88 + t91;
  const S t95 = t90 * t87;
  const S t96 = t76 - t69;
  const S t97 = qd1 + qd[2];
  const S t98 = t2 * t92;
  const S t99 = S(0.0141984) * t93;
  const S t100 = t3 * t92;
  const S t101 = t2 * t82 - t100;
  const S t102 = S(0.14625280000000007) * t93 + t94;
  const S t103 = S(0.07380327799999997) * t95;
  const S t104 = t3 * t82 + t98;
  const S t105 = t90 * t90;
  const S t106 = S(0.0203) * t95 + t101;
  w[18] = t106;
  ALEMBERT_FROM_MEMORY;
  const S t77_2 = w[14];
  const S t107 = S(0.001670399999999999) * t77_2 - t99;
  const S t108 = qd[0] * qd[0];
  const S t109 = t107 + S(0.1205966399999999) * t96;
  const S t110 = S(0.0254214) * t108 + t102;
  w[19] = t110;
  const S t111 = S(0.07210368000000011) * t83 - t109;
  w[20] = t111;
  const S t112 = t97 * t97;
  const S t113 = t105 + t112;
  const S t114 = t87 * t87;
  const S t115 = t105 - t114;
  const S t116 = S(0.1501) * t108;
  const S t117 = S(0.006820800000000002) * t115 + t103;
  w[21] = t117;
  const S t118 = t112 + t114;
  const S t119 = t104 - S(0.0203) * t118;
  w[22] = t119;
  const S t120 = t106 - S(0.4331) * t113;
  w[23] = t120;
  const S t121 = t90 * t97;
  const S t5_2 = cosine[2];
  const S t122 = t5_2 * t90;
  const S t123 = t112 - t114;
  const S t124 = S(0.004703999999999991) * t95;
  const S t125 = S(0.8636) * t83 + t116;
  w[24] = t125;
  const S t4_2 = sine[2];
  const S t126 = t4_2 * t90;
  const S t127 = t87 * t97;
  const S t128 = t4_2 * t97 - t122;
  const S t129 = t119 + S(0.4331) * t95;
  w[25] = t129;
  const S t130 = S(0.0406) * t121 - t125;
  w[26] = t130;
  const S t131 = S(0.004703999999999991) * t123;
  const S t132 = t5_2 * t97 + t126;
  const S t133 = S(0.013641600000000004) * t127 + t124;
  const S t134 = S(0.01249999999999997) * t121 - t133;
  w[27] = t134;
  const S t135 = t4_2 * t127;
  const S t136 = t130 + S(0.8662) * t127;
  w[28] = t136;
  const S t137 = S(0.013641600000000004) * t121 - t131;
  const S t138 = t5_2 * t129;
  const S t139 = t4_2 * t136 - t138;
  const S t140 = t4_2 * t129;
  const S t141 = t137 + S(0.135106556) * t127;
  w[29] = t141;
  const S qd3 = qd[3];  // d(q4)
  const S t142 = t132 * qd3;
  const S t143 = qd3 * t128 - t135;
  const S t144 = t5_2 * t127 - t142;
  const S t7_2 = cosine[3];
  const S t145 = t7_2 * t121;
  const S t146 = t5_2 * t136 + t140;
  w[30] = t146;
  const S t147 = S(0.00010000000000000005) * t128;
  const S t6_3 = sine[3];
  const S t148 = t6_3 * t121;
  const S t149 = S(0.001399999999999968) * t121;
  const S t150 = t7_2 * t139;
  const S t151 = t132 * t147 + t149;
  w[31] = t151;
  const S t152 = t87 + qd3;
  const S qd4 = qd[4];  // d(q5)
  const S t153 = qd4 + t132;
  const S t154 = t144 - t132 * t152;
  w[32] = t154;
  const S t155 = t7_2 * t152;
  const S t156 = t6_3 * t120 - t150;
  const S t157 = t6_3 * t128 + t155;
  const S t158 = t7_2 * t128;
  const S t159 = t6_3 * t144 + t145;
  const S t160 = t7_2 * t144 - t148;
  const S qd5 = qd[5];  // d(q6)
  const S t161 = t157 + qd5;
  const S t162 = qd5 + t161;
  const S t163 = qd4 * t157 + t160;
  const S t9 = sine[4];
  const S t164 = t153 * t9;
  const S t165 = t6_3 * t152 - t158;
  const S t166 = qd4 * t165 + t159;
  const S t8 = cosine[4];
  const S t167 = t153 * t8;
  const S t168 = t165 * t8 - t164;
  const S t169 = t165 * t9 + t167;
  const S t170 = t162 * t168;
  const S t171 = t169 * t162;
  const S t172 = t163 + t153 * t157;
  const S t173 = t143 * t9 - t171;
  const S t174 = t143 + t152 * t128;
  const S t175 = t153 * t165 + t166;
  const S t176 = t165 * t157;
  const S t177 = t163 * t8 + t173;
  const S t178 = t163 * t9 + t170;
  const S t179 = S(-3.9999999999999996e-05) * t166;
  c[5] = t179;
  const S t180 = t143 * t8 - t178;
  const S t181 = S(0.00020000000000000004) * t175 - t179;
  const S t182 = S(0.00288) * t172;
  const S t183 = t9 * t177;
  const S t184 = S(0.00288) * t156;
  const S t185 = t9 * t180;
  const S t186 = t165 * t165;
  const S t187 = t8 * t177 - t185;
  const S t188 = t153 * t153 + t186;
  const S t189 = t8 * t180 + t183;
  ALEMBERT_FROM_MEMORY;
  const S t6_4 = sine[3];
  const S t190 = t6_4 * t188;
  const S t191 = S(-1.9999999999999998e-05) * t189 - t184;
  const S t192 = S(1.9999999999999998e-05) * t187;
  const S t5_3 = cosine[2];
  const S t193 = t5_3 * w[1];
  const S t194 = S(0.00042216000000000004) * t172 + t192;
  const S t195 = t191 - S(0.0006221600000000001) * t143;
  const S t196 = t143 + t176;
  const S t197 = t6_4 * t196;
  const S t7_3 = cosine[3];
  const S t198 = t7_3 * t188 - t197;
  const S t199 = S(0.00288) * w[30] + t194;
  const S t200 = S(0.00288) * t198;
  const S t201 = t7_3 * t196 + t190;
  const S t202 = t7_3 * t199;
  const S t203 = w[3] * t5_3;
  const S t204 = t6_4 * t181 + t202;
  const S t205 = t7_3 * t181;
  const S t206 = S(0.001247328) * w[0] + t193;
  w[1] = t206;
  const S t207 = t195 - S(0.00022216) * t176;
  c[4] = t207;
  const S t208 = t6_4 * t199 - t205;
  const S t209 = t206 - S(5.8464e-05) * t7_3;
  const S t4_3 = sine[2];
  const S t210 = t4_3 * t182;
  const S t211 = S(0.0006499999999999839) * t174 - t207;
  const S t212 = t208 - w[31];
  c[3] = t212;
  const S t213 = S(0.00288) * t201;
  const S t214 = t5_3 * t182;
  const S t215 = t5_3 * t213 + t210;
  const S t216 = S(0.000749999999999984) * w[32] + t204;
  const S t217 = S(1.9898291387670286) * w[23] - t200;
  const S t218 = S(0.7398291387670295) * w[18] - t217;
  const S t219 = t4_3 * t216;
  const S t220 = t4_3 * t213 - t214;
  const S t221 = S(1.9898291387670286) * w[25] + t215;
  const S t222 = t4_3 * t211;
  const S t223 = S(0.7398291387670295) * w[22] - t221;
  const S t224 = t220 - S(1.9898291387670286) * w[28];
  const S t225 = w[27] - t212;
  const S t18_2 = w[2];
  const S t226 = S(-0.001247328) * t18_2 - w[7];
  M[15] = t226;
  M[20] = t226;
  const S t227 = t5_3 * t216 - t222;
  const S t228 = S(0.4331) * t224 - t227;
  const S t229 = t5_3 * t211 + t219;
  const S t3_2 = sine[1];
  const S t230 = t18_2 * t3_2;
  w[0] = t230;
  const S t231 = w[29] + t228;
  const S t232 = t226 + S(-0.001243584) * t230;
  M[9] = t232;
  M[19] = t232;
  const S t233 = t224 + S(0.7398291387670295) * w[26];
  const S t234 = S(0.010673638499999999) - t209;
  const S t235 = t3_2 * t223;
  const S t236 = S(0.4331) * t221 + t229;
  const S t237 = w[21] - t236;
  const S t2_2 = cosine[1];
  const S t238 = t2_2 * t223;
  const S t239 = t3_2 * t218 - t238;
  const S t240 = S(5.8464e-05) * t18_2 - t203;
  const S t241 = S(0.0203) * t233 - t225;
  const S t242 = t3_2 * t241;
  const S t243 = t2_2 * t234;
  const S t244 = t2_2 * t231 + t242;
  const S t245 = t239 + S(7.540157480314961) * w[17];
  const S t246 = t2_2 * t218 + t235;
  const S t247 = S(7.540157480314961) * w[15] - t246;
  const S t248 = t243 + t243;
  const S t249 = t3_2 * t231;
  const S t250 = t237 - S(0.0203) * t218;
  c[2] = t250;
  const S t251 = t2_2 * t241 - t249;
  const S t252 = t248 + t3_2 * w[10];
  const S t253 = t251 - S(0.0934) * t245;
  const S t254 = S(0.00470400000000001) - t226;
  const S t255 = t2_2 * t240;
  const S t256 = S(0.0070992) * w[13];
  const S t257 = t3_2 * t240;
  const S t258 = t3_2 * t254 - t255;
  const S t259 = t2_2 * t254 + t257;
  const S t260 = S(0.4318) * t247 - t250;
  const S t261 = t234 - t2_2 * t252;
  const S t50_2 = w[12];
  const S t262 = t258 + S(0.0934) * t50_2;
  const S t263 = S(0.0934) * t247 - t244;
  const S t264 = t233 + S(7.540157480314961) * w[24];
  const S t265 = S(0.4318) * t264 - t253;
  const S t266 = t247 + S(0.1044) * w[16];
  const S t77_3 = w[14];
  const S t267 = S(0.03707455999999998) * t77_3 - t256;
  const S t268 = t245 - S(0.1044) * t77_3;
  const S t269 = t3_2 * t252;
  const S t0_2 = sine[0];
  const S t270 = S(1.024164) * t0_2 - t267;
  const S t45_2 = w[11];
  const S t271 = t259 - S(0.0934) * t45_2;
  const S t272 = S(0.4318) * t45_2 + t261;
  c[1] = t270 - t260;
  const S t274 = t262 - S(0.2435) * t50_2;
  const S t275 = w[9] - t269;
  const S t276 = S(0.0070992) - t272;
  const S t277 = t0_2 * t266;
  const S t1_2 = cosine[0];
  const S t278 = t1_2 * t268 - t277;
  ALEMBERT_FROM_MEMORY;
  const S t18_3 = w[2];
  const S t279 = t262 + S(0.001243584) * t18_3;
  const S t280 = w[5] + t269;
  const S t281 = t280 + S(0.07312640000000004);
  const S t282 = S(0.233911466) - t279;
  const S t283 = t1_2 * t276;
  const S t284 = S(0.8636) * t50_2 - t275;
  const S t285 = t283 + t283;
  const S t286 = S(1.674987602) - t284;
  const S t287 = t265 + w[20];
  M[7] = t286 + t281;
  const S t289 = S(3.79559) - t50_2;
  const S t290 = t286 - t281;
  const S t291 = w[19] + t263;
  const S t292 = t0_2 * t290 + t285;
  const S t293 = t271 + S(0.2435) * t45_2;
  const S t294 = t271 + S(0.001670399999999999);
  const S t295 = t1_2 * t293;
  const S t296 = t286 - t0_2 * t292;
  const S t297 = t282 - S(0.2435) * t289;
  const S t298 = S(0.1044) - t45_2;
  const S t299 = t0_2 * t297;
  const S t300 = S(0.2435) * t298 - t294;
  const S t301 = S(0.2435) * t278;
  const S t302 = w[4] + t296;
  const S t303 = S(0.000864576) * t18_3 + t302;
  const S t304 = t0_2 * t274 - t295;
  M[2] = t304;
  M[12] = t304;
  M[0] = t303 + S(1.4724995505);
  const S t306 = t1_2 * t287;
  const S t307 = t0_2 * t291 - t306;
  const S t308 = t1_2 * t300 - t299;
  M[1] = t308;
  M[6] = t308;
  c[0] = t307 + t301;
  const S t206_2 = w[1];
  const S t310 = cosine[1] * t206_2 - w[8];
  const S t311 = sine[1] * t206_2 + w[6];
  const S t312 = t310 - S(0.00043228799999999996) * w[0];
  const S t313 = t0_2 * t312;
  const S t314 = t1_2 * t311 + t313;
  M[3] = t314;
  M[18] = t314;
  M[35] = S(3.9999999999999996e-05);
  M[28] = S(0.0006421600000000001);
  M[22] = S(0.0);
  M[27] = S(0.0);
  M[29] = S(0.0);
  M[34] = S(0.0);
}

/// All packs together have 33 values in w. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void mass_matrix_and_bias_packs(int packs, const S* q, const S* qd, S* M, S* c, S* w, const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    mass_matrix_and_bias_pack_block1<S>(q + 6 * k, qd + 6 * k, M + 36 * k, c + 6 * k, w, inputs[k]);
}

}  // namespace alembert::mechanisms::puma560::detail

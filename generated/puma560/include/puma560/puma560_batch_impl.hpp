// puma560: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over several packs of states, whose arrays follow each other. Each is cut into blocks, and a block is done for
// all packs before the next one begins: then its code, and what it hands over, are in the nearest caches.
#pragma once

#include <cmath>
#include <cstdint>

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
    [[maybe_unused]] S* ALEMBERT_RESTRICT tau, [[maybe_unused]] S* ALEMBERT_RESTRICT kept,
    [[maybe_unused]] const Inputs<S>& in) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t0 = sine[0];
  const S t10 = S(9.81) * t0;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t11 = qdd0 * t0;
  const S qd0 = qd[0];  // d(q1)
  const S t12 = qd0 * t0;
  const S t13 = qd0 * qd0;
  kept[0] = t13;
  const S t1 = cosine[0];
  const S t14 = qdd0 * t1;
  kept[1] = t14;
  const S t15 = S(0.2435) * t14 + t10;
  kept[2] = t15;
  const S t3 = cosine[1];
  const S t16 = t3 * t12;
  const S t2 = sine[1];
  const S t17 = t12 * t2;
  const S t18 = qd0 * t1;
  const S qd1 = qd[1];  // d(q2)
  const S t19 = qd1 * t18;
  const S t20 = t19 + t11;
  const S t21 = S(0.1501) * t13;
  const S t22 = t18 * t3 - t17;
  const S t23 = qd1 * t12;
  const S t24 = S(0.0016704) * t14;
  const S t25 = t19 + t20;
  kept[3] = t25;
  const S t26 = t23 - t14;
  const S t27 = S(0.12059664) * t11 - t24;
  const S t28 = t26 + t23;
  kept[4] = t28;
  const S t29 = qd1 * qd1;
  const S t30 = S(0.4318) * t28 + t21;
  kept[5] = t30;
  const S t31 = t3 * t20;
  const S t32 = S(0.0070992) * t28;
  kept[6] = t32;
  const S t33 = t12 * t12;
  const S t34 = t29 + t33;
  kept[7] = t34;
  const S t35 = t26 * t3;
  const S t36 = t18 * t2 + t16;
  const S t37 = t20 * t2 + t35;
  const S t38 = t29 - t33;
  kept[8] = t38;
  const S qd2 = qd[2];  // d(q3)
  const S t39 = qd2 + qd1;
  const S t40 = t26 * t2 - t31;
  const S t41 = t18 * t18;
  const S t42 = S(0.1501) * t11;
  const S t43 = t37 + qd2 * t36;
  const S t44 = t40 - qd2 * t22;
  const S t45 = t36 * t39;
  const S t46 = t41 - t33;
  const S t47 = t45 - t43;
  const S t48 = t18 * t12;
  const S t49 = t29 + t41;
  const S t50 = t27 + S(0.0070992) * t46;
  const S t51 = t29 - t41;
  const S t52 = t45 + t43;
  kept[9] = t52;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t53 = qdd1 - t48;
  kept[10] = t53;
  const S t54 = t36 * t36;
  const S t55 = qdd1 + t48;
  const S t56 = t44 - t39 * t22;
  kept[11] = t56;
  const S t57 = S(0.4318) * t55 + t42;
  const S t58 = qdd[3] - t43;
  kept[12] = t58;
  const S t59 = t39 * t39;
  ALEMBERT_FROM_MEMORY;
  const S t1_2 = cosine[0];
  const S t60 = t57 - S(9.81) * t1_2;
  kept[13] = t60;
  const S t61 = t22 * t22;
  const S t62 = t54 + t59;
  kept[14] = t62;
  const S t63 = S(0.03605184) * t55 + t50;
  const S t64 = S(0.12059664) * t55 + kept[6];
  const S t65 = t64 + S(0.0016704) * t51;
  const S t66 = S(0.0731264) * t53 + t63;
  const S t15_2 = kept[2];
  const S t67 = t15_2 + S(0.4318) * t49;
  const S t68 = t66 + S(0.1044) * t15_2;
  kept[2] = t68;
  const S t69 = t59 + t61;
  const S t70 = qdd[2] + qdd1;
  const S t71 = S(0.004704) * t47;
  const S t72 = t54 - t61;
  const S t5 = sine[2];
  const S t73 = t5 * t44;
  const S t74 = t59 - t61;
  const S t75 = S(0.0068208) * t72 - t71;
  kept[6] = t75;
  const S t4 = cosine[2];
  const S t76 = t44 * t4;
  const S t77 = S(0.0934) * kept[1] - t67;
  kept[15] = t77;
  const S t78 = t5 * t70 + t76;
  const S t79 = t36 * t4;
  const S t80 = t36 * t22;
  const S t81 = t5 * t36;
  const S t82 = t70 * t4 - t73;
  const S t83 = t39 * t4 + t81;
  const S t84 = t5 * t39 - t79;
  ALEMBERT_FROM_MEMORY;
  const S t3_2 = cosine[1];
  const S t60_2 = kept[13];
  const S t85 = t3_2 * t60_2;
  const S t2_2 = sine[1];
  const S t86 = t77 * t2_2 - t85;
  kept[1] = t86;
  const S t87 = t60_2 * t2_2;
  const S t25_2 = kept[3];
  const S t88 = S(0.0731264) * t25_2 + t65;
  kept[16] = t88;
  const S t89 = t3_2 * t77 + t87;
  const S t90 = S(0.004704) * t74;
  const S t91 = S(0.0070992) * t25_2;
  const S t92 = t70 + t80;
  kept[3] = t92;
  const S qd3 = qd[3];  // d(q4)
  const S t93 = qd3 + t22;
  const S t94 = qd3 * t84 - t82;
  const S t95 = S(0.0203) * t69 + t89;
  kept[17] = t95;
  const S t96 = t70 - t80;
  const S t97 = qd3 * t83 + t78;
  const S t56_2 = kept[11];
  const S t98 = S(0.0068208) * t56_2;
  const S t99 = S(0.004704) * t96 + t98;
  const S t100 = S(0.0001) * t84;
  const S t101 = t95 + S(0.4331) * t96;
  kept[18] = t101;
  const S t7 = cosine[3];
  const S t102 = t93 * t7;
  const S t52_2 = kept[9];
  const S t103 = t99 + S(0.00625) * t52_2;
  kept[19] = t103;
  const S t104 = S(0.0068208) * t52_2 - t90;
  const S t105 = S(0.067553278) * t96 - kept[6];
  const S t106 = S(0.067553278) * t56_2 - t104;
  kept[6] = t106;
  const S t107 = t84 * t93 + t94;
  kept[9] = t107;
  const S t108 = t105 - S(0.00625) * t92;
  kept[20] = t108;
  const S t109 = t83 * t100;
  const S t6 = sine[3];
  const S t110 = t6 * t84 + t102;
  const S t53_2 = kept[10];
  const S t111 = S(0.0016704) * t53_2 + t91;
  const S t58_2 = kept[12];
  const S t112 = S(0.0014) * t58_2 - t109;
  kept[21] = t112;
  const S t113 = t97 + t83 * t93;
  kept[12] = t113;
  const S t114 = t84 * t7;
  const S t115 = t6 * t93 - t114;
  const S t116 = qdd[4] - t94;
  const S t117 = t6 * t58_2;
  const S t118 = t115 * t110;
  const S t119 = t6 * t97;
  const S t120 = S(0.12059664) * kept[8] - t111;
  kept[22] = t120;
  const S qd4 = qd[4];  // d(q5)
  const S t121 = qd4 + t83;
  const S t122 = t97 * t7 - t117;
  const S t123 = t116 - t118;
  const S t124 = qd4 * t110 - t122;
  const S t125 = t58_2 * t7 + t119;
  const S t126 = S(0.00022216) * t118;
  const S t127 = t115 * t115;
  const S t128 = t123 * t7;
  const S t129 = S(0.00062216) * t116 - t126;
  kept[8] = t129;
  const S t130 = qd4 * t115 - t125;
  const S qd5 = qd[5];  // d(q6)
  const S t131 = qd5 + t110;
  const S t132 = S(0.0203) * t52_2 - kept[5];
  const S t133 = qd5 + t131;
  const S t134 = t121 * t121 + t127;
  const S t135 = t6 * t134 - t128;
  const S t136 = t121 * t110 + t124;
  const S t137 = t6 * t123;
  const S t138 = t134 * t7 + t137;
  const S t8 = cosine[4];
  const S t139 = t8 * t121;
  const S t9 = sine[4];
  const S t140 = t121 * t9;
  const S t141 = t115 * t121 + t130;
  const S t142 = qdd[5] - t130;
  const S t143 = S(4e-05) * t142;
  tau[5] = t143;
  const S t144 = t115 * t8 - t140;
  const S t145 = t115 * t9 + t139;
  const S t146 = t9 * t124;
  const S t147 = S(0.0002) * t141 - t143;
  const S t148 = t133 * t144 + t146;
  const S t149 = S(0.00042216) * t136;
  const S t150 = t133 * t145;
  const S t151 = t148 + t116 * t8;
  const S t152 = t116 * t9 + t150;
  const S t153 = S(0.00288) * t135;
  ALEMBERT_FROM_MEMORY;
  const S t154 = t132 - S(0.4331) * kept[11];
  const S t155 = S(0.00288) * t138;
  const S t156 = t8 * t124 - t152;
  const S t157 = S(0.00288) * t136;
  const S t158 = t151 * t8;
  const S t159 = t8 * t156;
  const S t4_2 = cosine[2];
  const S t160 = t4_2 * t154;
  const S t161 = t9 * t156 - t158;
  const S t162 = t151 * t9 + t159;
  const S t5_2 = sine[2];
  const S t163 = t5_2 * t153;
  const S t164 = t153 * t4_2;
  const S t101_2 = kept[18];
  const S t165 = t5_2 * t101_2 - t160;
  const S t166 = t5_2 * t157 + t164;
  const S t167 = t5_2 * t154;
  const S t168 = t101_2 * t4_2 + t167;
  const S t169 = S(0.00288) * t165 - t149;
  const S t170 = t169 - S(2e-05) * t162;
  const S t171 = t157 * t4_2 - t163;
  const S t172 = S(1.9898291387670284) * t154 + t171;
  const S t6_2 = sine[3];
  const S t173 = t6_2 * t147;
  const S t7_2 = cosine[3];
  const S t174 = t170 * t7_2 - t173;
  const S t175 = S(0.0203) * kept[3] + kept[1];
  const S t176 = S(1.9898291387670284) * t101_2 - t166;
  const S t177 = S(0.7398291387670284) * t175 + t155;
  const S t178 = t174 + S(0.00075) * kept[12];
  const S t179 = t175 - S(0.4331) * kept[14];
  const S t180 = t172 - S(0.7398291387670284) * t132;
  const S t181 = S(0.7398291387670284) * kept[17] - t176;
  const S t182 = t147 * t7_2;
  const S t183 = t168 * t7_2;
  const S t184 = t6_2 * t179 - t183;
  const S t185 = kept[8] - S(0.00288) * t184;
  const S t186 = t185 - S(2e-05) * t161;
  tau[4] = t186;
  const S t187 = t6_2 * t170 + t182;
  const S t188 = kept[21] - t187;
  tau[3] = t188;
  const S t189 = t4_2 * t178;
  const S t190 = S(0.00065) * kept[9] - t186;
  ALEMBERT_FROM_MEMORY;
  const S t5_3 = sine[2];
  const S t191 = t5_3 * t190 + t189;
  const S t192 = t4_2 * t190;
  const S t2_3 = sine[1];
  const S t193 = t181 * t2_3;
  const S t194 = t177 - S(1.9898291387670284) * t179;
  const S t195 = kept[19] - t188;
  const S t196 = t191 - S(0.4331) * t172;
  const S t3_3 = cosine[1];
  const S t197 = t3_3 * t194 - t193;
  const S t198 = kept[6] - t196;
  const S t199 = kept[22] - S(0.03605184) * kept[4];
  const S t200 = t194 * t2_3;
  const S t201 = t3_3 * t181 + t200;
  const S t202 = t5_3 * t178 - t192;
  const S t203 = S(0.4331) * t176 + t202;
  const S t204 = S(0.0203) * t180 + t195;
  const S t205 = t201 - S(7.540157480314961) * kept[15];
  const S t206 = t3_3 * t204;
  const S t207 = t198 * t2_3 - t206;
  const S t208 = t197 + S(7.540157480314961) * kept[13];
  const S t209 = t3_3 * t198;
  const S t210 = S(0.0934) * t205 - t207;
  const S t211 = t204 * t2_3 + t209;
  const S t212 = kept[20] - t203;
  const S t213 = S(-0.0203) * t194 - t212;
  tau[2] = t213;
  const S t214 = S(0.4318) * t208 + t213;
  tau[1] = kept[2] + t214;
  const S t216 = S(7.540157480314961) * kept[5] - t180;
  const S t217 = t210 + S(0.4318) * t216;
  const S t218 = kept[16] + S(0.0254214) * kept[0];
  const S t219 = S(0.1044) * kept[10] + t205;
  const S t220 = t211 - S(0.0934) * t208;
  const S t221 = t208 - S(0.1044) * kept[7];
  const S t222 = t217 - t199;
  const S t0_2 = sine[0];
  const S t223 = t221 * t0_2;
  const S t1_3 = cosine[0];
  const S t224 = t1_3 * t222;
  const S t225 = t218 + t220;
  const S t226 = t1_3 * t219 + t223;
  const S t227 = S(0.2435) * t226;
  const S t228 = t0_2 * t225 - t224;
  const S t229 = t228 + t227;
  tau[0] = S(1.2736872145669291) * qdd[0] + t229;
}

/// All packs together have 23 values in kept. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void inverse_dynamics_packs(int packs, const S* q, const S* qd, const S* qdd, S* tau, S* kept,
    const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    inverse_dynamics_pack_block1<S>(q + 6 * k, qd + 6 * k, qdd + 6 * k, tau + 6 * k, kept, inputs[k]);
}

// mass_matrix_and_bias in one block.
/// Which of the 19 values of a pack the entries of M are.
constexpr ::std::uint16_t mass_matrix_and_bias_M_rows[] = {
    0, 1, 2, 3, 4, 5, 1, 6, 7, 8, 9, 10, 2, 7, 11, 12, 13, 10, 3, 8, 12, 14, 15, 16, 4, 9, 13, 15, 17, 15, 5, 10, 10,
    16, 15, 18};
template <class S>
ALEMBERT_NOINLINE void mass_matrix_and_bias_pack_block1([[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] S* ALEMBERT_RESTRICT M,
    [[maybe_unused]] S* ALEMBERT_RESTRICT c, [[maybe_unused]] S* ALEMBERT_RESTRICT kept,
    [[maybe_unused]] const Inputs<S>& in) {
  using detail::sines_and_cosines;
  S sine[5], cosine[5];
  sines_and_cosines(5, q + 1, sine, cosine);
  const S t6 = sine[3];
  const S t4 = cosine[2];
  const S t10 = t6 * t4;
  const S t11 = S(0.025375) - S(0.00288) * t10;
  const S t3 = sine[1];
  const S t7 = cosine[3];
  const S t12 = t3 * t7;
  const S t13 = t4 * t7;
  const S t2 = cosine[1];
  const S t14 = t10 * t2 + t12;
  const S t15 = S(0.00064216) * t4;
  const S t16 = t6 * t3;
  const S t17 = t10 * t3;
  const S t18 = S(0.00288) * t7 + S(0.861795);
  const S t19 = t11 * t3;
  const S t20 = t18 * t2 + t19;
  kept[0] = t20;
  const S t21 = t6 * t2;
  const S t22 = t13 * t3 + t21;
  const S t23 = S(0.001247328) * t13 + t15;
  const S t24 = t18 * t3;
  const S t25 = S(0.000432288) * t22;
  const S t26 = t2 * t11 - t24;
  kept[1] = t26;
  const S t5 = sine[2];
  const S t27 = S(0.00064216) * t5;
  const S t28 = t23 - S(5.8464e-05) * t6;
  M[13] = t28;
  const S t29 = t2 * t13 - t16;
  const S t30 = S(0.001243584) - S(5.8464e-05) * t2;
  const S t31 = t2 * t7 - t17;
  const S t32 = t5 * t7;
  M[9] = t28 + S(0.001243584) * t22;
  const S t34 = S(0.001247328) * t32 + t27;
  const S t35 = S(5.8464e-05) * t32;
  const S t36 = t35 * t3 + t25;
  const S t37 = t34 * t3;
  const S t38 = t36 + t2 * t34;
  const S t0 = sine[0];
  const S t39 = t0 * t14;
  const S t40 = S(0.000432288) * t29 - t37;
  const S t41 = S(0.001247328) * t10;
  const S t42 = t40 - t30 * t32;
  const S t43 = S(0.00020216) * t6;
  const S t44 = t6 * t43;
  const S t45 = t43 * t7;
  ALEMBERT_FROM_MEMORY;
  const S t4_2 = cosine[2];
  const S t46 = t4_2 * t45 + t41;
  const S t1 = cosine[0];
  const S t47 = t1 * t31 - t39;
  M[5] = S(4e-05) * t47;
  const S t5_2 = sine[2];
  const S t49 = t5_2 * t6;
  const S t50 = t44 + S(0.0001);
  const S t51 = t5_2 * t50;
  const S t52 = t5_2 * t45;
  const S t53 = t1 * t42;
  const S t54 = t5_2 * t51;
  kept[2] = t54;
  const S t55 = t54 - t44;
  const S t56 = S(0.002494656) * t7 - t44;
  M[4] = t0 * t38 - t53;
  const S t58 = S(0.001243584) * t10;
  const S t59 = S(5.8464e-05) * t49;
  const S t60 = S(-0.001247328) * t49 - t52;
  M[12] = t60;
  const S t61 = S(0.000116928) * t10 + t55;
  const S t62 = t44 + S(0.00164);
  M[14] = t62;
  const S t63 = t51 * t4_2 - t59;
  const S t64 = t49 * t3;
  const S t65 = t56 + S(0.3061122965);
  const S t66 = S(0.0076351125) - t61;
  M[16] = S(4e-05) * t7;
  M[8] = t60 + S(-0.001243584) * t64;
  const S t69 = t46 * t3 + t58;
  const S t70 = t62 - S(5.8464e-05) * t10;
  const S t71 = t70 + S(0.000432288) * t49;
  const S t2_2 = cosine[1];
  const S t72 = t69 + t2_2 * t71;
  const S t73 = t65 - t66;
  const S t74 = S(5.8464e-05) * t7 - t46;
  const S t75 = t70 * t3;
  const S t76 = t73 * t3;
  const S t77 = S(0.004704) - t60;
  const S t78 = S(0.000432288) * t64 + t75;
  const S t79 = t77 * t3;
  const S t80 = t2_2 * t77;
  const S t81 = t74 + S(0.0106736385);
  const S t82 = t63 * t2_2 + t79;
  const S t83 = t63 * t3 - t80;
  const S t84 = t78 - t2_2 * t46;
  const S t85 = t81 + t81;
  const S t86 = t2_2 * t85 - t76;
  const S t87 = t0 * t84;
  const S t20_2 = kept[0];
  const S t88 = S(0.0934) * t20_2 + t83;
  const S t89 = t86 * t3;
  const S t90 = t81 - t2_2 * t86;
  const S t26_2 = kept[1];
  const S t91 = t82 + S(0.0934) * t26_2;
  const S t92 = t65 + t66;
  M[11] = t92;
  const S t93 = t89 - t66;
  M[7] = t92 - S(0.4318) * t26_2;
  const S t95 = S(0.4318) * t20_2 + t90;
  ALEMBERT_FROM_MEMORY;
  const S t1_2 = cosine[0];
  M[3] = t1_2 * t72 - t87;
  const S t97 = S(0.8636) * t26_2 + t93;
  const S t98 = S(1.674987602) - t97;
  const S t99 = S(0.001243584) * t49 + t91;
  const S t100 = S(0.0070992) - t95;
  const S t101 = S(0.2435) * t26_2 - t91;
  const S t102 = t65 + t89;
  M[10] = S(4e-05) * t49;
  const S t104 = t1_2 * t100;
  const S t105 = S(3.79559) - t26_2;
  const S t106 = t88 - S(0.2435) * t20_2;
  const S t107 = t104 + t104;
  const S t108 = S(0.1044) - t20_2;
  const S t109 = S(0.0016704) - t88;
  const S t110 = t109 - S(0.2435) * t108;
  const S t111 = S(0.233911466) - t99;
  const S t112 = t101 * t0;
  const S qd0 = qd[0];  // d(q1)
  const S t113 = qd0 * qd0;
  kept[0] = t113;
  M[2] = t106 * t1_2 - t112;
  const S t115 = t102 + S(0.0731264);
  const S t116 = t98 - t115;
  const S t117 = qd0 * t1_2;
  const S t118 = qd0 * t0;
  const S t119 = S(0.2435) * t105 - t111;
  const S t120 = t1_2 * t110;
  const S t121 = t118 * t3;
  M[1] = t0 * t119 - t120;
  M[6] = t98 + t115;
  const S t2_3 = cosine[1];
  const S t124 = t2_3 * t118;
  const S t125 = t116 * t0 + t107;
  const S qd1 = qd[1];  // d(q2)
  const S t126 = qd1 * t118;
  kept[1] = t126;
  const S t127 = t118 * t118;
  kept[3] = t127;
  const S t128 = t117 * t3 + t124;
  const S t129 = qd[2] + qd1;
  const S t130 = t117 * t117;
  const S t131 = t117 * t118;
  kept[4] = t131;
  const S t132 = t130 - t127;
  const S t133 = t98 - t125 * t0;
  const S t134 = qd1 * t117;
  kept[5] = t134;
  const S t135 = t133 + kept[2];
  const S t136 = t117 * t2_3 - t121;
  const S t4_3 = cosine[2];
  const S t137 = t128 * t4_3;
  const S t138 = qd1 * qd1;
  kept[2] = t138;
  const S t139 = t138 - t130;
  kept[6] = t139;
  const S t140 = t138 + t130;
  const S t5_3 = sine[2];
  const S t141 = t5_3 * t129 - t137;
  const S t142 = t129 * t136;
  const S t143 = t135 + S(0.000864576) * t49;
  const S t144 = S(0.4318) * t131;
  const S t145 = t5_3 * t128;
  const S t146 = S(9.81) * t1_2 - t144;
  kept[7] = t146;
  const S t147 = t128 * t136;
  kept[8] = t147;
  const S t148 = t129 * t4_3 + t145;
  const S qd3 = qd[3];  // d(q4)
  const S t149 = qd3 * t148;
  const S t150 = S(0.4318) * t140;
  const S t151 = t142 * t4_3 - t149;
  const S t152 = t5_3 * t142;
  const S t153 = t128 * t128;
  const S t154 = qd3 * t141 - t152;
  const S t155 = S(0.0070992) * t132;
  const S t156 = t128 * t129;
  const S t157 = t129 * t129;
  const S t158 = S(9.81) * t0 + t150;
  kept[9] = t158;
  const S t159 = qd3 + t136;
  const S t160 = t136 * t136;
  const S t161 = t153 - t160;
  const S t162 = t151 - t148 * t159;
  kept[10] = t162;
  M[0] = t143 + S(1.4724995505);
  const S t164 = t153 + t157;
  kept[11] = t164;
  ALEMBERT_FROM_MEMORY;
  const S t131_2 = kept[4];
  const S t165 = S(0.03707456) * t131_2 - t155;
  kept[12] = t165;
  const S t166 = t157 + t160;
  kept[13] = t166;
  const S t7_2 = cosine[3];
  const S t167 = t156 * t7_2;
  const S t168 = S(0.0136416) * t156;
  const S t6_2 = sine[3];
  const S t169 = t151 * t6_2 + t167;
  const S t170 = t141 * t159 + t154;
  kept[14] = t170;
  const S t171 = t157 - t160;
  const S t172 = S(0.0136416) * t142;
  const S t173 = S(0.004704) * t171 - t168;
  const S t174 = t6_2 * t156;
  const S t175 = t173 - S(0.135106556) * t142;
  kept[15] = t175;
  const S t176 = t151 * t7_2 - t174;
  const S t177 = t159 * t7_2;
  const S t178 = t141 * t7_2;
  const S t179 = t148 * t141;
  const S t180 = t6_2 * t141 + t177;
  const S t181 = S(0.0014) * t156;
  const S t182 = t6_2 * t159 - t178;
  const S qd4 = qd[4];  // d(q5)
  const S t183 = qd4 + t148;
  const S t184 = qd4 * t182 + t169;
  const S t147_2 = kept[8];
  const S t185 = S(0.004704) * t147_2 + t172;
  const S t186 = S(0.0001) * t179 + t181;
  kept[16] = t186;
  const S t187 = t182 * t183 + t184;
  const S t188 = qd4 * t180 + t176;
  const S qd5 = qd[5];  // d(q6)
  const S t189 = qd5 + t180;
  const S t190 = S(0.073803278) * t147_2;
  const S t191 = S(-4e-05) * t184;
  c[5] = t191;
  const S t192 = S(0.0068208) * t161 + t190;
  kept[17] = t192;
  const S t8 = sine[4];
  const S t193 = t154 * t8;
  const S t194 = S(0.0002) * t187 - t191;
  kept[18] = t194;
  const S t195 = t183 * t8;
  const S t196 = qd5 + t189;
  const S t9 = cosine[4];
  const S t197 = t182 * t9 - t195;
  const S t198 = t9 * t183;
  const S t199 = t182 * t8 + t198;
  const S t200 = t196 * t199 - t193;
  const S t201 = S(0.0125) * t156 - t185;
  kept[19] = t201;
  const S t202 = t188 * t8;
  const S t203 = t182 * t180;
  const S t204 = t182 * t182;
  const S t205 = t188 + t183 * t180;
  const S t206 = t200 - t188 * t9;
  const S t113_2 = kept[0];
  const S t207 = S(0.1501) * t113_2;
  const S t208 = t196 * t197 + t202;
  const S t209 = t9 * t206;
  const S t210 = t183 * t183 + t204;
  const S t211 = t208 - t9 * t154;
  const S t126_2 = kept[1];
  const S t212 = S(0.8636) * t126_2 + t207;
  kept[20] = t212;
  const S t213 = S(0.0406) * t156 - t212;
  kept[21] = t213;
  const S t214 = t154 + t203;
  const S t215 = t8 * t211 - t209;
  const S t216 = t9 * t211;
  const S t217 = t213 + S(0.8662) * t142;
  const S t2_4 = cosine[1];
  const S t158_2 = kept[9];
  const S t218 = t2_4 * t158_2;
  const S t219 = t206 * t8 + t216;
  const S t220 = S(2e-05) * t219;
  const S t221 = S(0.00062216) * t154 - t220;
  ALEMBERT_FROM_MEMORY;
  const S t131_3 = kept[4];
  const S t222 = S(0.12059664) * t131_3;
  const S t223 = S(0.0141984) * t126_2 + t222;
  const S t6_3 = sine[3];
  const S t224 = t6_3 * t214;
  const S t225 = S(0.0016704) * kept[6] + t223;
  kept[22] = t225;
  const S t146_2 = kept[7];
  const S t3_2 = sine[1];
  const S t226 = t146_2 * t3_2 + t218;
  const S t227 = t6_3 * t210;
  const S t7_3 = cosine[3];
  const S t228 = t214 * t7_3 + t227;
  const S t229 = t158_2 * t3_2;
  const S t230 = t210 * t7_3 - t224;
  const S t231 = t221 + S(0.00022216) * t203;
  const S t232 = S(0.00288) * t228;
  const S t233 = t2_4 * t146_2 - t229;
  const S t4_4 = cosine[2];
  const S t234 = t4_4 * t232;
  const S t235 = t226 - S(0.0203) * kept[13];
  const S t236 = S(0.00288) * t205;
  const S t5_4 = sine[2];
  const S t237 = t5_4 * t236 + t234;
  const S t238 = t5_4 * t232;
  const S t239 = t236 * t4_4 - t238;
  const S t147_3 = kept[8];
  const S t240 = S(0.0203) * t147_3 + t233;
  const S t241 = t235 + S(0.4331) * t147_3;
  const S t242 = t237 + S(1.9898291387670284) * t241;
  const S t243 = t5_4 * t241;
  const S t244 = t4_4 * t217 + t243;
  const S t245 = S(0.00288) * t244;
  const S t246 = S(0.00042216) * t205 + t245;
  const S t247 = S(0.7398291387670284) * t240;
  const S t248 = t4_4 * t241;
  const S t249 = t246 + S(2e-05) * t215;
  const S t250 = t5_4 * t217 - t248;
  const S t251 = t250 * t7_3;
  const S t252 = S(0.4331) * kept[11] - t240;
  const S t253 = S(1.9898291387670284) * t252 + t247;
  ALEMBERT_FROM_MEMORY;
  const S t6_4 = sine[3];
  const S t254 = t6_4 * t252 + t251;
  const S t255 = t242 - S(0.7398291387670284) * t235;
  const S t256 = S(0.00288) * t254 - t231;
  c[4] = t256;
  const S t257 = S(0.00065) * kept[14] - t256;
  const S t194_2 = kept[18];
  const S t258 = t194_2 * t7_3;
  const S t259 = t253 + S(0.00288) * t230;
  const S t260 = t249 * t7_3;
  const S t261 = t239 + S(1.9898291387670284) * t217;
  const S t134_2 = kept[5];
  const S t262 = kept[22] + S(0.1462528) * t134_2;
  const S t263 = t6_4 * t249 - t258;
  const S t264 = t6_4 * t194_2 + t260;
  const S t265 = S(0.00075) * kept[10] + t264;
  const S t266 = t5_4 * t257;
  const S t267 = t263 - kept[16];
  c[3] = t267;
  const S t268 = t4_4 * t257;
  const S t269 = t4_4 * t265 - t266;
  const S t270 = t5_4 * t265 + t268;
  const S t271 = S(0.4331) * t242 + t270;
  const S t131_4 = kept[4];
  const S t272 = S(0.0016704) * t131_4;
  const S t273 = kept[17] - t271;
  const S t274 = S(0.4331) * t261 + t269;
  const S t275 = S(0.0141984) * t134_2 - t272;
  const S t2_5 = cosine[1];
  const S t276 = t2_5 * t255;
  const S t277 = kept[15] + t274;
  const S t278 = t2_5 * t259;
  const S t279 = t261 - S(0.7398291387670284) * kept[21];
  const S t3_3 = sine[1];
  const S t280 = t255 * t3_3 - t278;
  const S t281 = t259 * t3_3 + t276;
  const S t282 = t277 * t3_3;
  const S t283 = kept[19] - t267;
  const S t284 = t283 + S(0.0203) * t279;
  const S t285 = t281 + S(7.540157480314961) * kept[9];
  const S t286 = t280 + S(7.540157480314961) * kept[7];
  const S t287 = t2_5 * t284 - t282;
  const S t288 = t287 + S(0.0934) * t285;
  const S t289 = t273 - S(0.0203) * t259;
  c[2] = t289;
  const S t290 = t2_5 * t277;
  const S t291 = t284 * t3_3 + t290;
  const S t138_2 = kept[2];
  const S t127_2 = kept[3];
  const S t292 = t138_2 - t127_2;
  const S t293 = t279 - S(7.540157480314961) * kept[20];
  const S t294 = S(0.12059664) * t292 - t275;
  const S t295 = t285 - S(0.1044) * t131_4;
  const S t0_2 = sine[0];
  const S t296 = kept[12] - S(1.024164) * t0_2;
  const S t297 = S(0.07210368) * kept[1] - t294;
  const S t298 = t262 + S(0.0254214) * kept[0];
  const S t299 = t138_2 + t127_2;
  const S t1_3 = cosine[0];
  const S t300 = t1_3 * t295;
  const S t301 = t289 - S(0.4318) * t286;
  const S t302 = S(0.4318) * t293 - t288;
  const S t303 = t286 + S(0.1044) * t299;
  const S t304 = S(0.0934) * t286 + t291;
  c[1] = t301 - t296;
  const S t306 = t304 + t298;
  const S t307 = t297 - t302;
  const S t308 = t1_3 * t307;
  const S t309 = t303 * t0_2 - t300;
  const S t310 = t0_2 * t306 - t308;
  const S t311 = S(0.2435) * t309;
  c[0] = t310 - t311;
  M[17] = S(0.00064216);
  M[18] = S(4e-05);
  M[15] = S(0.0);
}

/// All packs together have 23 values in kept. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void mass_matrix_and_bias_packs(int packs, const S* q, const S* qd, S* M, S* c, S* kept,
    const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    mass_matrix_and_bias_pack_block1<S>(q + 6 * k, qd + 6 * k, M + 19 * k, c + 6 * k, kept, inputs[k]);
}

}  // namespace alembert::mechanisms::puma560::detail

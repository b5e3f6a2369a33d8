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
  const S t1 = sine[0];
  const S t10 = S(9.81) * t1;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t11 = qdd0 * t1;
  const S qd0 = qd[0];  // d(q1)
  const S t0 = cosine[0];
  const S t12 = qd0 * t0;
  const S qd1 = qd[1];  // d(q2)
  const S t13 = qd1 * t12;
  const S t14 = t13 + t11;
  const S t15 = qd0 * t1;
  const S t16 = t13 + t14;
  kept[0] = t16;
  const S t17 = t12 * t12;
  const S t18 = qd1 * qd1;
  kept[1] = t18;
  const S t19 = qdd0 * t0;
  const S t20 = S(0.2435) * t19 + t10;
  kept[2] = t20;
  const S t21 = t18 + t17;
  const S t22 = qd1 * t15;
  const S t23 = t20 + S(0.4318) * t21;
  const S t24 = S(0.0016704) * t19;
  const S t25 = qd0 * qd0;
  kept[3] = t25;
  const S t26 = S(0.1501) * t25;
  const S t27 = t22 - t19;
  const S t28 = S(0.0934) * t19 - t23;
  kept[4] = t28;
  const S t29 = S(0.1501) * t11;
  kept[5] = t29;
  const S t30 = t27 + t22;
  kept[6] = t30;
  const S t3 = cosine[1];
  const S t31 = t27 * t3;
  const S t32 = S(0.4318) * t30 + t26;
  kept[7] = t32;
  const S t33 = t18 - t17;
  kept[8] = t33;
  const S t2 = sine[1];
  const S t34 = t15 * t2;
  const S t35 = t14 * t2 + t31;
  const S t36 = t3 * t14;
  const S t37 = t3 * t15;
  const S t38 = t27 * t2 - t36;
  const S t39 = S(0.12059664) * t11 - t24;
  const S qd2 = qd[2];  // d(q3)
  const S t40 = qd2 + qd1;
  const S t41 = t12 * t2 + t37;
  const S t42 = t35 + qd2 * t41;
  const S t43 = t12 * t15;
  const S t44 = t12 * t3 - t34;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t45 = qdd1 + t43;
  const S t46 = t15 * t15;
  kept[9] = t46;
  const S t47 = t40 * t40;
  const S t48 = t17 - t46;
  const S t49 = t38 - qd2 * t44;
  const S t50 = qdd1 - t43;
  kept[10] = t50;
  const S t51 = t44 * t44;
  const S t52 = t39 + S(0.0070992) * t48;
  const S t53 = t47 + t51;
  kept[11] = t53;
  const S t54 = t41 * t41;
  const S t55 = t41 * t40;
  const S t56 = S(0.03605184) * t45 + t52;
  kept[12] = t56;
  const S t57 = t47 - t51;
  const S t58 = S(0.004704) * t57;
  const S t59 = t54 + t47;
  kept[13] = t59;
  const S t60 = t49 - t40 * t44;
  const S t61 = t55 + t42;
  kept[14] = t61;
  const S t62 = t54 - t51;
  const S t63 = t55 - t42;
  const S t64 = S(0.004704) * t63;
  const S t65 = S(0.0068208) * t62 - t64;
  const S t66 = S(0.0203) * t61 - t32;
  kept[15] = t66;
  const S t67 = S(0.0068208) * t61 - t58;
  const S t4 = cosine[2];
  const S t68 = t41 * t4;
  const S t69 = qdd[2] + qdd1;
  const S t70 = t66 - S(0.4331) * t60;
  kept[16] = t70;
  const S t5 = sine[2];
  const S t71 = t5 * t41;
  const S t72 = S(0.067553278) * t60 - t67;
  kept[17] = t72;
  const S t73 = t5 * t40 - t68;
  const S t74 = qdd[3] - t42;
  kept[18] = t74;
  const S t75 = t40 * t4 + t71;
  const S t76 = t5 * t49;
  const S t77 = t41 * t44;
  const S t78 = t69 * t4 - t76;
  const S t79 = t75 * t73;
  const S t80 = t49 * t4;
  const S t81 = t5 * t69 + t80;
  const S t82 = t69 + t77;
  ALEMBERT_FROM_MEMORY;
  const S t83 = S(0.0070992) * kept[6];
  const S t84 = S(0.0001) * t79;
  kept[19] = t84;
  const S t85 = t69 - t77;
  const S t86 = S(0.0068208) * t60;
  const S qd3 = qd[3];  // d(q4)
  const S t87 = qd3 + t44;
  const S t88 = S(0.12059664) * t45 + t83;
  const S t89 = S(0.067553278) * t85 - t65;
  const S t90 = S(0.4318) * t45 + kept[5];
  const S t91 = t89 - S(0.00625) * t82;
  kept[5] = t91;
  const S t92 = qd3 * t75 + t81;
  const S t93 = t92 + t75 * t87;
  kept[20] = t93;
  const S t94 = qd3 * t73 - t78;
  const S t95 = t88 + S(0.0016704) * kept[8];
  kept[21] = t95;
  const S t6 = sine[3];
  const S t96 = t6 * t92;
  const S t7 = cosine[3];
  const S t97 = t73 * t7;
  const S t98 = S(0.004704) * t85 + t86;
  kept[8] = t98;
  const S t99 = t73 * t87 + t94;
  kept[22] = t99;
  const S t100 = t74 * t7 + t96;
  const S t101 = t87 * t7;
  const S t0_2 = cosine[0];
  const S t102 = t90 - S(9.81) * t0_2;
  kept[23] = t102;
  const S t103 = t6 * t73 + t101;
  const S t104 = t6 * t74;
  const S t105 = t6 * t87 - t97;
  const S qd5 = qd[5];  // d(q6)
  const S t106 = qd5 + t103;
  const S t107 = qd5 + t106;
  const S t108 = t92 * t7 - t104;
  const S t2_2 = sine[1];
  const S t109 = t102 * t2_2;
  const S t3_2 = cosine[1];
  const S t110 = t3_2 * t102;
  const S qd4 = qd[4];  // d(q5)
  const S t111 = qd4 + t75;
  const S t112 = qd4 * t103 - t108;
  const S t28_2 = kept[4];
  const S t113 = t28_2 * t2_2 - t110;
  const S t114 = qd4 * t105 - t100;
  const S t115 = t3_2 * t28_2 + t109;
  const S t116 = qdd[4] - t94;
  const S t117 = S(0.0203) * t82 + t113;
  kept[24] = t117;
  const S t118 = qdd[5] - t114;
  const S t119 = S(0.0203) * kept[11] + t115;
  kept[25] = t119;
  const S t9 = sine[4];
  const S t120 = t9 * t112;
  const S t8 = cosine[4];
  const S t121 = t8 * t111;
  const S t122 = t105 * t111 + t114;
  const S t123 = t119 + S(0.4331) * t85;
  const S t124 = t105 * t9 + t121;
  const S t125 = t107 * t124;
  const S t126 = t111 * t9;
  const S t127 = t116 * t9 + t125;
  const S t128 = t105 * t8 - t126;
  const S t129 = t107 * t128 + t120;
  const S t130 = t105 * t103;
  const S t131 = S(0.00022216) * t130;
  const S t132 = t111 * t103 + t112;
  const S t133 = t116 - t130;
  const S t134 = t105 * t105;
  const S t135 = t8 * t112 - t127;
  const S t136 = S(0.00062216) * t116 - t131;
  kept[11] = t136;
  const S t137 = S(4e-05) * t118;
  tau[5] = t137;
  const S t138 = t8 * t135;
  const S t139 = S(0.0002) * t122 - t137;
  const S t140 = t111 * t111 + t134;
  const S t141 = t129 + t116 * t8;
  const S t142 = t141 * t8;
  const S t5_2 = sine[2];
  const S t70_2 = kept[16];
  const S t143 = t5_2 * t70_2;
  const S t4_2 = cosine[2];
  const S t144 = t4_2 * t70_2;
  const S t145 = t141 * t9 + t138;
  const S t146 = t5_2 * t123 - t144;
  const S t147 = S(0.00042216) * t132;
  const S t148 = t123 * t4_2 + t143;
  const S t149 = t9 * t135 - t142;
  const S t150 = S(0.00288) * t146 - t147;
  ALEMBERT_FROM_MEMORY;
  const S t6_2 = sine[3];
  const S t151 = t6_2 * t133;
  const S t7_2 = cosine[3];
  const S t152 = t140 * t7_2 + t151;
  const S t153 = S(0.00288) * t152;
  const S t154 = t148 * t7_2;
  const S t155 = t133 * t7_2;
  const S t156 = t6_2 * t140 - t155;
  const S t157 = t150 - S(2e-05) * t145;
  const S t158 = t6_2 * t139;
  const S t159 = t139 * t7_2;
  const S t160 = t157 * t7_2 - t158;
  const S t161 = t5_2 * t132;
  const S t162 = t6_2 * t157 + t159;
  const S t163 = t160 + S(0.00075) * kept[20];
  const S t164 = t156 * t4_2 + t161;
  const S t165 = t5_2 * t156;
  const S t117_2 = kept[24];
  const S t166 = t117_2 - S(0.4331) * kept[13];
  const S t167 = S(0.7398291387670284) * t117_2 + t153;
  const S t168 = S(0.00288) * t164;
  const S t169 = t167 - S(1.9898291387670284) * t166;
  const S t170 = t6_2 * t166 - t154;
  const S t171 = kept[11] - S(0.00288) * t170;
  const S t172 = t171 - S(2e-05) * t149;
  tau[4] = t172;
  const S t173 = S(0.00065) * kept[22] - t172;
  const S t174 = S(0.0203) * t169;
  const S t175 = t4_2 * t132 - t165;
  const S t176 = S(0.0014) * kept[18] - kept[19];
  const S t177 = S(1.9898291387670284) * t123 - t168;
  const S t178 = S(0.7398291387670284) * kept[25] - t177;
  const S t179 = t4_2 * t173;
  const S t180 = t176 - t162;
  tau[3] = t180;
  const S t18_2 = kept[1];
  const S t46_2 = kept[9];
  const S t181 = t18_2 - t46_2;
  const S t182 = t4_2 * t163;
  const S t183 = S(0.00288) * t175;
  const S t184 = t5_2 * t163 - t179;
  const S t185 = S(0.4331) * t177 + t184;
  const S t186 = t5_2 * t173 + t182;
  const S t187 = kept[5] - t185;
  const S t188 = t187 + t174;
  const S t189 = S(1.9898291387670284) * kept[16] + t183;
  const S t2_3 = sine[1];
  const S t190 = t169 * t2_3;
  const S t191 = kept[8] + S(0.00625) * kept[14];
  const S t192 = t189 - S(0.7398291387670284) * kept[15];
  const S t193 = t191 - t180;
  const S t194 = t178 * t2_3;
  const S t195 = t18_2 + t46_2;
  const S t16_2 = kept[0];
  const S t196 = S(0.0070992) * t16_2;
  const S t197 = t193 + S(0.0203) * t192;
  tau[2] = -t188;
  const S t199 = S(0.4331) * t189 - t186;
  const S t200 = kept[17] + t199;
  const S t3_3 = cosine[1];
  const S t201 = t3_3 * t169 - t194;
  const S t50_2 = kept[10];
  const S t202 = S(0.0016704) * t50_2 + t196;
  const S t203 = S(7.540157480314961) * kept[7] - t192;
  const S t204 = t3_3 * t178 + t190;
  const S t205 = t201 + S(7.540157480314961) * kept[23];
  const S t206 = t204 - S(7.540157480314961) * kept[4];
  const S t207 = t206 + S(0.1044) * t50_2;
  const S t208 = t205 - S(0.1044) * t195;
  const S t209 = S(0.12059664) * t181 - t202;
  const S t210 = t197 * t2_3;
  const S t211 = t200 * t2_3;
  const S t212 = S(0.0731264) * t50_2 + kept[12];
  const S t213 = t209 - S(0.03605184) * kept[6];
  const S t214 = t3_3 * t200 + t210;
  const S t215 = t3_3 * t197 - t211;
  const S t216 = t212 + S(0.1044) * kept[2];
  const S t217 = t214 - S(0.0934) * t205;
  const S t1_2 = sine[0];
  const S t218 = t208 * t1_2;
  const S t219 = S(0.0731264) * t16_2 + kept[21];
  const S t220 = t215 + S(0.0934) * t206;
  const S t0_3 = cosine[0];
  const S t221 = t0_3 * t207 + t218;
  const S t222 = t219 + S(0.0254214) * kept[3];
  const S t223 = t188 - S(0.4318) * t205;
  const S t224 = t222 + t217;
  tau[1] = t216 - t223;
  const S t226 = S(0.2435) * t221;
  const S t227 = t224 * t1_2;
  const S t228 = S(0.4318) * t203 + t220;
  const S t229 = t213 - t228;
  const S t230 = t0_3 * t229 + t227;
  const S t231 = t230 + t226;
  tau[0] = t231 + S(1.2736872145669291) * qdd[0];
}

/// All packs together have 26 values in kept. Inside a loop, compilers would put the constants of a block into memory.
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
  const S t5 = sine[2];
  const S t7 = cosine[3];
  const S t10 = t5 * t7;
  const S t6 = sine[3];
  const S t3 = sine[1];
  const S t11 = t6 * t3;
  const S t4 = cosine[2];
  const S t12 = S(0.00064216) * t4;
  const S t13 = S(0.00064216) * t5;
  const S t14 = t4 * t7;
  const S t15 = S(0.00020216) * t6;
  const S t16 = S(0.001247328) * t10 + t13;
  const S t17 = S(0.001247328) * t14 + t12;
  const S t2 = cosine[1];
  const S t18 = t6 * t2;
  const S t19 = t15 * t7;
  const S t20 = t14 * t3 + t18;
  const S t21 = t2 * t14 - t11;
  const S t22 = t16 * t3;
  const S t23 = t5 * t19;
  kept[0] = t23;
  const S t24 = t17 - S(5.8464e-05) * t6;
  M[13] = t24;
  M[9] = t24 + S(0.001243584) * t20;
  const S t26 = t6 * t4;
  const S t27 = S(0.000432288) * t21 - t22;
  const S t28 = t6 * t15;
  const S t29 = t28 + S(0.0001);
  const S t30 = t5 * t29;
  kept[1] = t30;
  const S t31 = S(0.001243584) - S(5.8464e-05) * t2;
  const S t32 = t27 - t31 * t10;
  const S t33 = S(0.000432288) * t20;
  const S t34 = S(5.8464e-05) * t10;
  const S t1 = cosine[0];
  const S t35 = t1 * t32;
  const S t36 = t5 * t6;
  const S t37 = t34 * t3 + t33;
  const S t38 = t5 * t30;
  kept[2] = t38;
  const S t39 = t3 * t7;
  const S t40 = t26 * t2 + t39;
  const S t41 = t37 + t2 * t16;
  const S t0 = sine[0];
  M[4] = t0 * t41 - t35;
  const S t43 = t38 - t28;
  const S t44 = S(0.000116928) * t26 + t43;
  const S t45 = t26 * t3;
  const S t46 = t0 * t40;
  const S t47 = t2 * t7 - t45;
  const S t48 = t28 + S(0.00164);
  M[14] = t48;
  const S t49 = t48 - S(5.8464e-05) * t26;
  const S t50 = S(0.00288) * t7 + S(0.861795);
  const S t51 = S(0.001243584) * t26;
  const S t52 = t1 * t47 - t46;
  const S t53 = t36 * t3;
  const S t54 = S(0.001247328) * t26;
  ALEMBERT_FROM_MEMORY;
  const S t4_2 = cosine[2];
  const S t55 = t4_2 * t19 + t54;
  const S t56 = t49 * t3;
  const S t57 = t55 * t3 + t51;
  const S t58 = S(0.0076351125) - t44;
  M[5] = S(4e-05) * t52;
  const S t60 = S(0.002494656) * t7 - t28;
  const S t61 = t50 * t3;
  const S t62 = t49 + S(0.000432288) * t36;
  const S t63 = S(0.025375) - S(0.00288) * t26;
  const S t64 = t2 * t63 - t61;
  const S t65 = t57 + t2 * t62;
  const S t66 = S(5.8464e-05) * t7 - t55;
  const S t67 = t63 * t3;
  const S t68 = t50 * t2 + t67;
  const S t69 = t60 + S(0.3061122965);
  const S t70 = S(0.000432288) * t53 + t56;
  const S t71 = t70 - t2 * t55;
  const S t72 = t69 + t58;
  M[11] = t72;
  M[7] = t72 - S(0.4318) * t64;
  const S t74 = S(-0.001247328) * t36 - kept[0];
  M[12] = t74;
  const S t75 = t66 + S(0.0106736385);
  M[8] = t74 + S(-0.001243584) * t53;
  const S t77 = S(0.004704) - t74;
  const S t78 = t75 + t75;
  M[10] = S(4e-05) * t36;
  const S t80 = S(5.8464e-05) * t36;
  const S t81 = t69 - t58;
  const S t82 = t81 * t3;
  const S t83 = t2 * t78 - t82;
  const S t84 = t75 - t2 * t83;
  const S t85 = t2 * t77;
  ALEMBERT_FROM_MEMORY;
  const S t4_3 = cosine[2];
  const S t86 = kept[1] * t4_3 - t80;
  const S t87 = S(0.4318) * t68 + t84;
  const S t88 = t77 * t3;
  const S t89 = sine[0] * t71;
  const S t90 = t83 * t3;
  const S t1_2 = cosine[0];
  M[3] = t1_2 * t65 - t89;
  const S t92 = t69 + t90;
  const S t93 = t86 * t3 - t85;
  const S t94 = t93 - S(0.1501) * t68;
  const S t95 = t86 * t2 + t88;
  const S t96 = t1_2 * t94;
  const S t97 = t95 + S(0.0934) * t64;
  const S t98 = S(0.001243584) * t36 + t97;
  const S t99 = S(0.0070992) - t87;
  const S t100 = t1_2 * t99;
  const S t101 = S(0.0934) * t68 + t93;
  const S t102 = t100 + t100;
  const S t103 = t95 - S(0.1501) * t64;
  const S t104 = t92 + S(0.0731264);
  const S t105 = t90 - t58;
  const S t106 = S(0.0016704) - t101;
  const S t107 = S(0.1044) - t68;
  const S t108 = S(0.8636) * t64 + t105;
  const S t109 = t106 - S(0.2435) * t107;
  const S qd0 = qd[0];  // d(q1)
  const S t110 = qd0 * t1_2;
  ALEMBERT_FROM_MEMORY;
  const S t0_2 = sine[0];
  M[2] = t103 * t0_2 + t96;
  const S t112 = S(1.674987602) - t108;
  const S t113 = t1_2 * t109;
  const S t114 = S(3.79559) - t64;
  const S t115 = S(0.233911466) - t98;
  const S t116 = qd0 * t0_2;
  M[6] = t112 + t104;
  const S t118 = S(0.2435) * t114 - t115;
  const S t119 = qd0 * qd0;
  kept[0] = t119;
  const S t120 = t110 * t116;
  kept[1] = t120;
  M[1] = t0_2 * t118 - t113;
  const S t122 = S(0.12059664) * t120;
  const S t123 = t112 - t104;
  const S t124 = t110 * t110;
  const S t125 = S(0.4318) * t120;
  const S t126 = S(9.81) * t1_2 - t125;
  kept[3] = t126;
  const S qd1 = qd[1];  // d(q2)
  const S t127 = qd1 * t116;
  kept[4] = t127;
  const S t128 = t123 * t0_2 + t102;
  const S t129 = t112 - t128 * t0_2;
  const S t130 = t129 + kept[2];
  const S t131 = t2 * t116;
  const S t132 = t130 + S(0.000864576) * t36;
  const S t133 = t116 * t116;
  M[0] = t132 + S(1.4724995505);
  const S t135 = qd1 * qd1;
  const S t136 = qd1 * t110;
  kept[2] = t136;
  const S t137 = t135 + t124;
  const S t138 = t116 * t3;
  const S t139 = S(0.1501) * t119;
  const S t140 = qd[2] + qd1;
  const S t141 = t110 * t3 + t131;
  const S t142 = S(0.8636) * t127 + t139;
  kept[5] = t142;
  const S t143 = t135 - t133;
  kept[6] = t143;
  const S t144 = S(0.4318) * t137;
  const S t145 = t110 * t2 - t138;
  const S t146 = S(0.0141984) * t127 + t122;
  const S t147 = t135 + t133;
  kept[7] = t147;
  const S t148 = S(9.81) * t0_2 + t144;
  kept[8] = t148;
  const S t149 = t141 * t140;
  const S t150 = t135 - t124;
  const S t151 = t140 * t140;
  const S t152 = S(0.0016704) * t150 + t146;
  kept[9] = t152;
  const S t153 = S(0.0406) * t149 - t142;
  kept[10] = t153;
  const S t154 = t124 - t133;
  const S t155 = t148 * t3;
  const S t156 = S(0.0070992) * t154;
  kept[11] = t156;
  const S t157 = t2 * t148;
  const S t158 = t141 * t145;
  const S t159 = t141 * t141;
  const S t4_4 = cosine[2];
  const S t160 = t141 * t4_4;
  const S t5_2 = sine[2];
  const S t161 = t5_2 * t140 - t160;
  ALEMBERT_FROM_MEMORY;
  const S t126_2 = kept[3];
  const S t162 = t2 * t126_2 - t155;
  const S t163 = t126_2 * t3 + t157;
  const S t164 = t5_2 * t141;
  const S t165 = S(0.0203) * t158 + t162;
  const S t166 = t140 * t4_4 + t164;
  const S t167 = t140 * t145;
  kept[12] = t167;
  const S t168 = t5_2 * t167;
  const S qd3 = qd[3];  // d(q4)
  const S t169 = qd3 * t166;
  const S t170 = t167 * t4_4 - t169;
  const S t171 = t159 + t151;
  const S t172 = S(0.073803278) * t158;
  kept[13] = t172;
  const S t173 = qd3 * t161 - t168;
  const S t174 = qd3 + t145;
  const S t175 = t145 * t145;
  const S t176 = S(0.4331) * t171 - t165;
  kept[14] = t176;
  const S t177 = S(0.0136416) * t167;
  const S t178 = t159 - t175;
  kept[15] = t178;
  const S t179 = S(0.0136416) * t149;
  const S t180 = t161 * t174 + t173;
  kept[16] = t180;
  const S t181 = S(0.004704) * t158 + t177;
  const S t182 = S(0.0125) * t149 - t181;
  kept[17] = t182;
  const S t183 = t151 + t175;
  const S t184 = t163 - S(0.0203) * t183;
  kept[18] = t184;
  const S t185 = t170 - t166 * t174;
  kept[19] = t185;
  const S t186 = t184 + S(0.4331) * t158;
  kept[20] = t186;
  const S t7_2 = cosine[3];
  const S t187 = t161 * t7_2;
  const S t6_2 = sine[3];
  const S t188 = t6_2 * t174 - t187;
  const S t189 = t151 - t175;
  const S t190 = S(0.7398291387670284) * t165;
  const S t191 = S(1.9898291387670284) * t176 + t190;
  const S t192 = S(0.004704) * t189 - t179;
  kept[21] = t192;
  const S t193 = t6_2 * t149;
  const S qd4 = qd[4];  // d(q5)
  const S t194 = qd4 + t166;
  const S t195 = t188 * t188;
  const S t196 = t149 * t7_2;
  const S t197 = t174 * t7_2;
  const S t198 = S(0.0014) * t149;
  const S t199 = t6_2 * t161 + t197;
  const S t200 = t194 * t194 + t195;
  const S t201 = t166 * t161;
  const S t202 = t170 * t7_2 - t193;
  const S t203 = S(0.0001) * t201 + t198;
  kept[22] = t203;
  const S t204 = t170 * t6_2 + t196;
  const S t205 = t188 * t199;
  const S t206 = t173 + t205;
  const S t207 = t6_2 * t200;
  const S t208 = t6_2 * t206;
  const S t209 = t206 * t7_2 + t207;
  const S t210 = t200 * t7_2 - t208;
  const S qd5 = qd[5];  // d(q6)
  const S t211 = qd5 + t199;
  ALEMBERT_FROM_MEMORY;
  const S qd4_2 = qd[4];  // d(q5)
  const S t212 = qd4_2 * t199 + t202;
  const S t213 = t191 + S(0.00288) * t210;
  kept[23] = t213;
  const S t8 = sine[4];
  const S t214 = t194 * t8;
  const S t215 = qd5 + t211;
  const S t216 = t212 + t194 * t199;
  const S t9 = cosine[4];
  const S t217 = t188 * t9 - t214;
  const S t218 = qd4_2 * t188 + t204;
  const S t219 = t212 * t8;
  const S t220 = t215 * t217 + t219;
  const S t221 = t173 * t8;
  const S t222 = t220 - t9 * t173;
  const S t223 = t9 * t194;
  const S t224 = t188 * t8 + t223;
  const S t225 = t215 * t224 - t221;
  const S t226 = t188 * t194 + t218;
  const S t227 = S(-4e-05) * t218;
  c[5] = t227;
  const S t5_3 = sine[2];
  const S t228 = t5_3 * t216;
  const S t229 = t225 - t212 * t9;
  const S t230 = t9 * t229;
  const S t231 = t9 * t222;
  const S t232 = t229 * t8 + t231;
  const S t233 = S(0.0002) * t226 - t227;
  const S t186_2 = kept[20];
  const S t234 = t5_3 * t186_2;
  const S t235 = t5_3 * t209;
  const S t236 = S(2e-05) * t232;
  const S t237 = S(0.00062216) * t173 - t236;
  const S t238 = t237 + S(0.00022216) * t205;
  const S t167_2 = kept[12];
  const S t239 = kept[21] - S(0.135106556) * t167_2;
  const S t240 = t8 * t222 - t230;
  const S t153_2 = kept[10];
  const S t241 = t153_2 + S(0.8662) * t167_2;
  const S t242 = S(1.9898291387670284) * t186_2;
  const S t4_5 = cosine[2];
  const S t243 = t4_5 * t209 + t228;
  const S t244 = t4_5 * t216 - t235;
  const S t245 = S(0.00288) * t243 + t242;
  const S t246 = t4_5 * t241 + t234;
  const S t247 = S(0.00288) * t246;
  const S t248 = S(0.00042216) * t216 + t247;
  const S t7_3 = cosine[3];
  const S t249 = t233 * t7_3;
  const S t250 = t4_5 * t186_2;
  const S t251 = t5_3 * t241 - t250;
  M[16] = S(4e-05) * t7_3;
  const S t253 = S(1.9898291387670284) * t241;
  const S t254 = t248 + S(2e-05) * t240;
  const S t255 = S(0.7398291387670284) * kept[18] - t245;
  const S t256 = t251 * t7_3;
  const S t257 = S(0.00288) * t244 + t253;
  const S t258 = t254 * t7_3;
  const S t6_3 = sine[3];
  const S t259 = t6_3 * t233 + t258;
  const S t260 = t6_3 * kept[14] + t256;
  const S t261 = t6_3 * t254 - t249;
  const S t262 = t261 - kept[22];
  c[3] = t262;
  const S t263 = S(0.00075) * kept[19] + t259;
  const S t264 = S(0.00288) * t260 - t238;
  c[4] = t264;
  const S t265 = S(0.00065) * kept[16] - t264;
  const S t266 = t4_5 * t265;
  const S t267 = t5_3 * t265;
  const S t2_2 = cosine[1];
  const S t268 = t2_2 * t255;
  const S t269 = kept[17] - t262;
  const S t270 = t4_5 * t263 - t267;
  const S t271 = t257 - S(0.7398291387670284) * t153_2;
  const S t272 = t5_3 * t263 + t266;
  const S t273 = t270 + S(0.4331) * t257;
  ALEMBERT_FROM_MEMORY;
  const S t213_2 = kept[23];
  const S t274 = t2_2 * t213_2;
  const S t275 = t239 + t273;
  const S t276 = S(0.0203) * t271 + t269;
  const S t120_2 = kept[1];
  const S t277 = S(0.0016704) * t120_2;
  const S t136_2 = kept[2];
  const S t278 = kept[9] + S(0.1462528) * t136_2;
  const S t279 = S(0.4331) * t245 + t272;
  const S t280 = S(0.0141984) * t136_2 - t277;
  const S t3_2 = sine[1];
  const S t281 = t276 * t3_2;
  const S t282 = t255 * t3_2 + t274;
  const S t283 = S(0.0068208) * kept[15] + kept[13];
  const S t284 = t213_2 * t3_2 - t268;
  const S t285 = S(7.540157480314961) * kept[5] - t271;
  const S t286 = t278 + S(0.0254214) * kept[0];
  const S t287 = t275 * t3_2;
  const S t288 = S(7.540157480314961) * kept[3] - t282;
  const S t289 = t2_2 * t276 - t287;
  const S t290 = t279 - t283;
  const S t291 = t2_2 * t275 + t281;
  const S t292 = t288 + S(0.1044) * kept[7];
  const S t293 = t284 + S(7.540157480314961) * kept[8];
  const S t294 = S(0.12059664) * kept[6] - t280;
  const S t295 = S(0.0934) * t288 + t291;
  const S t296 = t295 + t286;
  const S t297 = S(-0.0203) * t213_2 - t290;
  c[2] = t297;
  const S t0_3 = sine[0];
  const S t298 = t292 * t0_3;
  const S t299 = S(0.07210368) * kept[4] - t294;
  const S t300 = S(0.0934) * t293 + t289;
  const S t301 = t293 - S(0.1044) * t120_2;
  const S t302 = t300 + S(0.4318) * t285;
  const S t303 = t0_3 * t296;
  const S t304 = S(0.03707456) * t120_2 - kept[11];
  const S t305 = t304 - S(1.024164) * t0_3;
  const S t306 = t299 + t302;
  const S t307 = t297 - S(0.4318) * t288;
  c[1] = t307 - t305;
  const S t1_3 = cosine[0];
  const S t309 = t1_3 * t306 - t303;
  const S t310 = t301 * t1_3 - t298;
  c[0] = S(0.2435) * t310 - t309;
  M[17] = S(0.00064216);
  M[18] = S(4e-05);
  M[15] = S(0.0);
}

/// All packs together have 24 values in kept. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void mass_matrix_and_bias_packs(int packs, const S* q, const S* qd, S* M, S* c, S* kept,
    const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    mass_matrix_and_bias_pack_block1<S>(q + 6 * k, qd + 6 * k, M + 19 * k, c + 6 * k, kept, inputs[k]);
}

}  // namespace alembert::mechanisms::puma560::detail

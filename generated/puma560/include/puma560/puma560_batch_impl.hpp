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
  const S qd0 = qd[0];  // d(q1)
  const S t10 = t0 * qd0;
  const S qd1 = qd[1];  // d(q2)
  const S qd2 = qd[2];  // d(q3)
  const S t11 = qd1 + qd2;
  kept[0] = t11;
  const S t1 = cosine[0];
  const S t12 = t1 * qd0;
  const S t3 = cosine[1];
  const S t13 = t10 * t3;
  const S qdd0 = qdd[0];  // dd(q1)
  const S t14 = t0 * qdd0;
  const S t2 = sine[1];
  const S t15 = t10 * t2;
  const S t16 = t12 * t2 + t13;
  const S qdd1 = qdd[1];  // dd(q2)
  const S t17 = qdd1 + qdd[2];
  kept[1] = t17;
  const S t18 = t12 * t3 - t15;
  kept[2] = t18;
  const S t19 = t18 * t16;
  const S t20 = t17 - t19;
  kept[3] = t20;
  const S t21 = t11 * t11;
  const S t22 = S(9.81) * t0;
  const S t23 = t12 * qd1;
  const S t24 = t18 * t18;
  const S t25 = t1 * qdd0;
  const S t26 = t16 * t16;
  const S t27 = t17 + t19;
  kept[4] = t27;
  const S t28 = t21 + t24;
  kept[5] = t28;
  const S t29 = t12 * t10;
  const S t30 = qdd1 - t29;
  kept[6] = t30;
  const S t31 = t12 * t12;
  const S t32 = t24 - t26;
  kept[7] = t32;
  const S t33 = t21 + t26;
  kept[8] = t33;
  const S t34 = qdd1 + t29;
  const S t35 = t14 + t23;
  const S t36 = S(0.2435) * t25 + t22;
  const S t37 = t10 * qd1;
  const S t38 = t21 - t24;
  kept[9] = t38;
  const S t39 = S(0.0016704) * t25;
  const S t40 = t10 * t10;
  const S t41 = t31 - t40;
  const S t42 = t23 + t35;
  const S t43 = S(0.12059664) * t14 - t39;
  const S t44 = t43 + S(0.0070992) * t41;
  const S t45 = t25 - t37;
  const S t46 = qd1 * qd1;
  const S t47 = t37 - t45;
  kept[10] = t47;
  const S t48 = S(0.0070992) * t47;
  const S t49 = S(0.1501) * t14;
  const S t50 = S(0.03605184) * t34 + t44;
  const S t51 = S(0.0731264) * t30 + t50;
  const S t52 = S(0.4318) * t34 + t49;
  const S t53 = S(0.12059664) * t34 + t48;
  const S t54 = t46 - t31;
  const S t55 = t46 + t31;
  const S t56 = t51 + S(0.1044) * t36;
  kept[11] = t56;
  const S t57 = t36 + S(0.4318) * t55;
  ALEMBERT_FROM_MEMORY;
  const S t58 = qd[0] * qd[0];
  kept[12] = t58;
  const S t59 = S(0.0934) * t25 - t57;
  kept[13] = t59;
  const S t60 = t46 + t40;
  kept[14] = t60;
  const S t61 = S(0.0070992) * t42;
  const S t62 = S(0.0016704) * t30 + t61;
  const S t3_2 = cosine[1];
  const S t63 = t3_2 * t35;
  const S t64 = t53 + S(0.0016704) * t54;
  const S t2_2 = sine[1];
  const S t65 = t2_2 * t45 + t63;
  const S t66 = t3_2 * t45;
  const S t67 = t2_2 * t35 - t66;
  const S t68 = t46 - t40;
  const S t11_2 = kept[0];
  const S t69 = t11_2 * t16;
  const S qd2_2 = qd[2];  // d(q3)
  const S t18_2 = kept[2];
  const S t70 = t65 + qd2_2 * t18_2;
  const S t71 = t67 + qd2_2 * t16;
  const S t72 = S(0.12059664) * t68 - t62;
  const S t5 = cosine[2];
  const S t73 = t5 * t16;
  const S t74 = t71 - t69;
  const S t47_2 = kept[10];
  const S t75 = t72 - S(0.03605184) * t47_2;
  kept[0] = t75;
  const S t76 = S(0.0731264) * t42 + t64;
  kept[2] = t76;
  const S t77 = S(0.1501) * t58;
  const S t78 = S(0.4318) * t47_2 + t77;
  kept[10] = t78;
  const S t4 = sine[2];
  const S t79 = t11_2 * t4 - t73;
  const S t1_2 = cosine[0];
  const S t80 = S(9.81) * t1_2 - t52;
  kept[15] = t80;
  const S qd3 = qd[3];  // d(q4)
  const S t81 = t18_2 + qd3;
  const S t82 = t4 * t16;
  const S t83 = t70 + t11_2 * t18_2;
  kept[16] = t83;
  const S t84 = t4 * t70;
  const S t17_2 = kept[1];
  const S t85 = t5 * t17_2 + t84;
  const S t86 = t79 * qd3 - t85;
  const S t87 = t11_2 * t5 + t82;
  const S t88 = t5 * t70;
  const S t89 = t4 * t17_2 - t88;
  const S t90 = qdd[3] - t71;
  const S t7 = cosine[3];
  const S t91 = t81 * t7;
  const S t92 = t87 * qd3 + t89;
  const S t93 = t79 * t7;
  const S t6 = sine[3];
  const S t94 = t6 * t79 + t91;
  const S t95 = t86 + t79 * t81;
  kept[1] = t95;
  const S t96 = S(0.0001) * t79;
  const S t97 = t71 + t69;
  kept[17] = t97;
  const S t98 = t6 * t81 - t93;
  const S t99 = t6 * t92;
  const S t100 = t87 * t96;
  const S t101 = t7 * t90 + t99;
  const S t102 = t92 + t87 * t81;
  kept[18] = t102;
  const S t103 = S(0.004704) * t74;
  kept[19] = t103;
  ALEMBERT_FROM_MEMORY;
  const S t2_3 = sine[1];
  const S t104 = t80 * t2_3;
  const S t105 = qdd[4] - t86;
  const S t106 = S(0.0014) * t90 - t100;
  kept[20] = t106;
  const S t107 = t6 * t90;
  const S t108 = t98 * t98;
  const S t109 = t7 * t92 - t107;
  const S t59_2 = kept[13];
  const S t110 = t2_3 * t59_2;
  const S t3_3 = cosine[1];
  const S t111 = t3_3 * t59_2 - t104;
  const S t112 = t80 * t3_3 + t110;
  const S qd4 = qd[4];  // d(q5)
  const S t113 = qd4 + t87;
  const S t114 = t94 * t98;
  const S t115 = qd4 * t98 - t101;
  const S t116 = t113 * t113 + t108;
  const S t117 = S(0.00022216) * t114;
  const S t118 = t105 - t114;
  const S t27_2 = kept[4];
  const S t119 = S(0.0203) * t27_2 + t112;
  const S t120 = qd4 * t94 - t109;
  const S t121 = t7 * t116;
  const S t122 = S(0.00062216) * t105 - t117;
  kept[21] = t122;
  const S t123 = t115 - qdd[5];
  const S t124 = t6 * t116;
  const S t125 = t113 * t98 + t115;
  const S t126 = t7 * t118 - t124;
  const S t127 = t119 - S(0.4331) * kept[8];
  const S t128 = S(-4e-05) * t123;
  tau[5] = t128;
  const S t129 = S(0.0002) * t125 - t128;
  kept[8] = t129;
  const S t130 = t113 * t94 + t120;
  const S qd5 = qd[5];  // d(q6)
  const S t131 = t94 + qd5;
  const S t132 = t111 + S(0.0203) * kept[5];
  kept[22] = t132;
  const S t133 = t6 * t118 + t121;
  const S t134 = S(0.00288) * t133;
  const S t135 = t6 * t127;
  const S t136 = S(0.7398291387670284) * t119 + t134;
  const S t9 = sine[4];
  const S t137 = t113 * t9;
  const S t138 = qd5 + t131;
  const S t8 = cosine[4];
  const S t139 = t98 * t8 - t137;
  const S t140 = S(1.9898291387670284) * t127 - t136;
  kept[5] = t140;
  const S t78_2 = kept[10];
  const S t97_2 = kept[17];
  const S t141 = S(0.0203) * t97_2 - t78_2;
  const S t142 = t113 * t8;
  const S t143 = t98 * t9 + t142;
  const S t144 = t143 * t138;
  const S t145 = t138 * t139;
  const S t146 = t120 * t9 + t145;
  const S t147 = S(0.00288) * t130;
  const S t148 = t105 * t9 + t144;
  const S t149 = t105 * t8 + t146;
  const S t83_2 = kept[16];
  const S t150 = t141 + S(0.4331) * t83_2;
  const S t151 = t9 * t149;
  const S t152 = t120 * t8 - t148;
  const S t20_2 = kept[3];
  const S t153 = t132 + S(0.4331) * t20_2;
  const S t154 = S(0.00288) * t126;
  const S t155 = t9 * t152;
  const S t156 = S(0.00042216) * t130;
  const S t157 = t8 * t149 - t155;
  const S t158 = t8 * t152 + t151;
  const S t159 = S(0.0068208) * t83_2;
  const S t5_2 = cosine[2];
  const S t160 = t5_2 * t154;
  const S t161 = S(0.004704) * t20_2 - t159;
  const S t4_2 = sine[2];
  const S t162 = t4_2 * t154;
  const S t163 = t4_2 * t150;
  const S t164 = t5_2 * t153 + t163;
  const S t7_2 = cosine[3];
  const S t165 = t7_2 * t164 - t135;
  const S t166 = t5_2 * t147 + t162;
  const S t167 = t166 + S(1.9898291387670284) * t150;
  ALEMBERT_FROM_MEMORY;
  const S t168 = kept[21] + S(0.00288) * t165;
  const S t169 = t167 - S(0.7398291387670284) * t141;
  const S t170 = t5_2 * t150;
  const S t171 = t4_2 * t147 - t160;
  const S t172 = t4_2 * t153 - t170;
  const S t173 = S(0.00288) * t172 - t156;
  const S t129_2 = kept[8];
  const S t174 = t7_2 * t129_2;
  const S t175 = t171 - S(1.9898291387670284) * t153;
  const S t6_2 = sine[3];
  const S t176 = t6_2 * t129_2;
  const S t177 = t173 - S(2e-05) * t158;
  const S t178 = t168 + S(2e-05) * t157;
  tau[4] = t178;
  const S t179 = t6_2 * t177 + t174;
  const S t180 = t178 - S(0.00065) * kept[1];
  const S t97_3 = kept[17];
  const S t181 = t161 + S(0.00625) * t97_3;
  const S t182 = kept[20] - t179;
  tau[3] = t182;
  const S t183 = t7_2 * t177 - t176;
  const S t184 = t183 + S(0.00075) * kept[18];
  const S t185 = t5_2 * t184;
  const S t186 = t5_2 * t180;
  const S t187 = S(0.004704) * kept[9];
  const S t188 = t4_2 * t184 + t186;
  const S t189 = t4_2 * t180 - t185;
  const S t3_4 = cosine[1];
  const S t140_2 = kept[5];
  const S t190 = t3_4 * t140_2;
  const S t191 = S(0.0068208) * kept[7] - kept[19];
  const S t192 = S(0.4331) * t167 + t189;
  const S t193 = S(0.0068208) * t97_3 - t187;
  const S t194 = t188 - S(0.4331) * t175;
  const S t195 = S(0.067553278) * kept[3] + t191;
  const S t196 = S(0.7398291387670284) * kept[22] + t175;
  const S t197 = t181 - t182;
  const S t2_4 = sine[1];
  const S t198 = t2_4 * t196 + t190;
  const S t199 = S(0.067553278) * kept[16] + t193;
  const S t200 = t195 - S(0.00625) * kept[4];
  const S t201 = t199 - t192;
  const S t202 = t2_4 * t201;
  const S t203 = t200 - t194;
  const S t204 = t3_4 * t196;
  const S t205 = S(0.0203) * t140_2 - t203;
  tau[2] = t205;
  const S t206 = t2_4 * t140_2 - t204;
  const S t207 = S(7.540157480314961) * kept[15] + t198;
  const S t208 = t206 + S(7.540157480314961) * kept[13];
  const S t209 = t169 - S(7.540157480314961) * kept[10];
  const S t210 = t3_4 * t201;
  const S t211 = S(0.0203) * t169 + t197;
  const S t212 = t2_4 * t211 - t210;
  const S t213 = t3_4 * t211 + t202;
  const S t214 = t212 + S(0.0934) * t207;
  const S t215 = kept[2] + S(0.0254214) * kept[12];
  const S t216 = S(0.4318) * t207 - t205;
  const S t217 = t215 + t214;
  tau[1] = kept[11] - t216;
  const S t219 = t213 - S(0.0934) * t208;
  const S t220 = S(0.4318) * t209 - t219;
  const S t221 = t220 + kept[0];
  const S t1_3 = cosine[0];
  const S t222 = t1_3 * t221;
  const S t0_2 = sine[0];
  const S t223 = t0_2 * t217 + t222;
  const S t224 = t207 + S(0.1044) * kept[14];
  const S t225 = S(0.1044) * kept[6] - t208;
  const S t226 = t1_3 * t225;
  const S t227 = t0_2 * t224 - t226;
  const S t228 = S(0.2435) * t227 - t223;
  tau[0] = S(1.2736872145669291) * qdd[0] - t228;
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
  const S t10 = S(0.00020216) * t6;
  const S t11 = t6 * t10;
  const S t12 = t11 + S(0.0001);
  const S t4 = sine[2];
  const S t13 = t4 * t12;
  const S t7 = cosine[3];
  const S t14 = t11 - S(0.002494656) * t7;
  const S t15 = t4 * t13;
  kept[0] = t15;
  const S t16 = S(0.3061122965) - t14;
  kept[1] = t16;
  const S t17 = t11 - t15;
  const S t18 = t10 * t7;
  const S t5 = cosine[2];
  const S t19 = t6 * t5;
  const S t20 = t5 * t18;
  const S t21 = t6 * t4;
  kept[2] = t21;
  const S t22 = S(0.00064216) * t5;
  const S t23 = t5 * t7;
  const S t24 = S(0.001243584) * t19;
  const S t25 = t11 + S(0.00164);
  M[14] = t25;
  const S t26 = S(5.8464e-05) * t19 - t25;
  kept[3] = t26;
  const S t27 = t13 * t5;
  const S t28 = S(0.001247328) * t19 + t20;
  kept[4] = t28;
  const S t29 = t28 - S(5.8464e-05) * t7;
  const S t30 = t4 * t18;
  const S t3 = sine[1];
  const S t31 = t21 * t3;
  M[16] = S(4e-05) * t7;
  const S t33 = t3 * t28 + t24;
  kept[5] = t33;
  const S t34 = S(-0.001247328) * t21 - t30;
  M[12] = t34;
  M[8] = t34 + S(-0.001243584) * t31;
  const S t36 = S(0.0106736385) - t29;
  kept[6] = t36;
  const S t37 = S(5.8464e-05) * t21 - t27;
  const S t2 = cosine[1];
  const S t38 = t2 * t37;
  const S t39 = S(0.004704) - t34;
  const S t40 = t3 * t39 - t38;
  const S t41 = S(0.00043228799999999996) * t31;
  kept[7] = t41;
  const S t42 = S(0.000116928) * t19 - t17;
  kept[8] = t42;
  const S t43 = t2 * t36;
  kept[9] = t43;
  const S t44 = S(0.001247328) * t23 + t22;
  const S t45 = t44 - S(5.8464e-05) * t6;
  M[13] = t45;
  const S t46 = S(0.00288) * t7 + S(0.861795);
  const S t47 = t3 * t37;
  const S t48 = S(0.025375) - S(0.00288) * t19;
  const S t49 = t2 * t23;
  const S t50 = t2 * t39 + t47;
  const S t51 = t48 * t3;
  const S t52 = t2 * t46 + t51;
  kept[10] = t52;
  const S t53 = t46 * t3;
  const S t54 = t6 * t3 - t49;
  const S t55 = t6 * t2;
  const S t56 = t50 - S(0.0934) * t52;
  const S t57 = t2 * t48 - t53;
  kept[11] = t57;
  const S t58 = t56 + S(0.2435) * t52;
  const S t59 = S(0.1044) - t52;
  const S t60 = t3 * t23 + t55;
  const S t61 = S(3.79559) - t57;
  const S t62 = t40 + S(0.0934) * t57;
  const S t63 = t62 + S(0.001243584) * t21;
  const S t64 = S(0.233911466) - t63;
  const S t65 = t62 - S(0.2435) * t57;
  const S t66 = S(0.00043228799999999996) * t54;
  const S t67 = t64 - S(0.2435) * t61;
  const S t1 = cosine[0];
  const S t68 = t1 * t58;
  const S t0 = sine[0];
  M[2] = t0 * t65 - t68;
  const S t70 = t56 + S(0.0016704);
  M[9] = t45 + S(0.001243584) * t60;
  const S t72 = S(0.00043228799999999996) * t60;
  const S t73 = t2 * t7;
  ALEMBERT_FROM_MEMORY;
  const S t4_2 = sine[2];
  const S t74 = S(0.00064216) * t4_2;
  const S t75 = S(0.2435) * t59 - t70;
  const S t76 = t0 * t67;
  M[1] = t1 * t75 - t76;
  const S t78 = t4_2 * t7;
  const S t79 = S(5.8464e-05) * t78;
  const S t80 = S(0.001247328) * t78 + t74;
  const S t81 = t7 * t3;
  const S t82 = t3 * t79 + t72;
  const S t83 = S(0.001243584) - S(5.8464e-05) * t2;
  const S t84 = t2 * t19 + t81;
  const S t85 = t3 * t80 + t66;
  const S t86 = t19 * t3 - t73;
  const S qd0 = qd[0];  // d(q1)
  const S t87 = t0 * qd0;
  const S t88 = t3 * t87;
  const S t89 = t1 * qd0;
  const S t90 = t2 * t80 + t82;
  const S t91 = t2 * t87;
  const S t92 = t3 * t89 + t91;
  const S t93 = t92 * t92;
  const S t94 = t78 * t83 + t85;
  const S t95 = t1 * t86;
  const S t96 = t89 * t87;
  kept[12] = t96;
  const S t97 = t1 * t94;
  M[4] = t0 * t90 + t97;
  const S t99 = t2 * t89 - t88;
  const S t100 = t0 * t84 + t95;
  const S t101 = t92 * t99;
  kept[13] = t101;
  const S t102 = S(0.4318) * t96;
  const S t103 = S(0.073803278) * t101;
  const S t104 = t87 * t87;
  const S qd1 = qd[1];  // d(q2)
  const S t105 = qd1 * qd1;
  const S t106 = qd1 * t87;
  const S t107 = S(9.81) * t1 - t102;
  kept[14] = t107;
  M[5] = S(-4e-05) * t100;
  const S t109 = t99 * t99;
  const S t110 = S(0.0016704) * t96;
  const S t111 = t109 - t93;
  const S t112 = S(0.0068208) * t111 - t103;
  kept[15] = t112;
  const S t113 = qd1 * t89;
  const S t114 = t105 - t104;
  const S t115 = t89 * t89;
  const S t116 = S(0.12059664) * t96;
  const S t117 = S(0.0141984) * t106 + t116;
  const S t118 = S(0.0141984) * t113 - t110;
  const S t119 = S(0.12059664) * t114 - t118;
  const S t120 = t105 - t115;
  const S t121 = S(0.0016704) * t120 + t117;
  const S t122 = t105 + t104;
  kept[16] = t122;
  ALEMBERT_FROM_MEMORY;
  const S t123 = qd[0] * qd[0];
  const S t124 = t105 + t115;
  const S t125 = t121 + S(0.1462528) * t113;
  const S t126 = S(0.4318) * t124;
  const S t127 = S(0.1501) * t123;
  const S t128 = qd[2] + qd1;
  const S t129 = t115 - t104;
  const S t130 = t128 * t128;
  const S t131 = S(0.07210368) * t106 - t119;
  kept[17] = t131;
  const S t132 = t125 + S(0.0254214) * t123;
  kept[18] = t132;
  const S t4_3 = sine[2];
  const S t133 = t4_3 * t92;
  const S t134 = t128 * t92;
  const S t135 = S(0.8636) * t106 + t127;
  kept[19] = t135;
  const S t136 = S(0.0070992) * t129;
  const S t137 = t128 * t99;
  const S t138 = S(0.0406) * t134 - t135;
  kept[20] = t138;
  const S t139 = t138 + S(0.8662) * t137;
  kept[21] = t139;
  const S t5_2 = cosine[2];
  const S t140 = t5_2 * t128 + t133;
  const S t141 = t130 + t109;
  kept[22] = t141;
  const S t142 = t130 + t93;
  kept[23] = t142;
  const S t143 = S(0.0136416) * t134;
  const S t144 = t130 - t109;
  const S t145 = t5_2 * t92;
  const S t146 = S(9.81) * t0 + t126;
  kept[24] = t146;
  const S t147 = S(0.004704) * t144 - t143;
  const S t148 = t4_3 * t128 - t145;
  const S t7_2 = cosine[3];
  const S t149 = t7_2 * t148;
  const S t150 = t147 - S(0.135106556) * t137;
  kept[25] = t150;
  const S qd3 = qd[3];  // d(q4)
  const S t151 = qd3 + t99;
  const S t152 = t4_3 * t137;
  const S t96_2 = kept[12];
  const S t153 = S(0.03707456) * t96_2 - t136;
  const S t154 = S(1.024164) * t0 - t153;
  kept[26] = t154;
  const S t155 = t140 * qd3;
  const S t156 = t7_2 * t151;
  const S t157 = t5_2 * t137 - t155;
  const S t6_2 = sine[3];
  const S t158 = t6_2 * t151 - t149;
  const S t159 = S(0.0136416) * t137;
  const S t160 = S(0.0014) * t134;
  const S t161 = t148 * qd3 - t152;
  const S t162 = t7_2 * t134;
  const S t163 = t157 - t140 * t151;
  kept[27] = t163;
  const S t164 = t6_2 * t134;
  const S t101_2 = kept[13];
  const S t165 = S(0.004704) * t101_2 + t159;
  const S t166 = t161 + t148 * t151;
  kept[28] = t166;
  const S t167 = t140 * t148;
  const S t168 = t7_2 * t157 - t164;
  const S t169 = t6_2 * t148 + t156;
  const S t170 = t6_2 * t157 + t162;
  const S t171 = t158 * t169;
  kept[29] = t171;
  const S t172 = S(0.0125) * t134 - t165;
  kept[30] = t172;
  const S qd4 = qd[4];  // d(q5)
  const S t173 = t158 * qd4 + t170;
  const S t174 = t140 + qd4;
  const S t175 = qd4 * t169 + t168;
  const S t176 = t158 * t174 + t173;
  const S t177 = t161 + t171;
  const S t8 = cosine[4];
  const S t178 = t174 * t8;
  const S t179 = S(-4e-05) * t173;
  c[5] = t179;
  const S t180 = S(0.0001) * t167 + t160;
  kept[31] = t180;
  const S t181 = t158 * t158;
  const S t182 = t174 * t174 + t181;
  const S t183 = t6_2 * t177;
  const S t184 = t6_2 * t182;
  const S t185 = t7_2 * t177 + t184;
  const S t186 = S(0.0002) * t176 - t179;
  kept[32] = t186;
  const S t187 = t7_2 * t182 - t183;
  kept[33] = t187;
  const S t9 = sine[4];
  const S t188 = t158 * t9 + t178;
  const S t189 = S(0.0076351125) - kept[8];
  const S t16_2 = kept[1];
  const S t190 = t189 - t16_2;
  const S t191 = t174 * t9;
  const S t192 = t158 * t8 - t191;
  const S qd5 = qd[5];  // d(q6)
  const S t193 = t169 + qd5;
  const S t194 = qd5 + t193;
  const S t195 = kept[9] + kept[9];
  const S t196 = t194 * t192;
  const S t197 = t188 * t194;
  const S t198 = t9 * t161 - t197;
  const S t199 = t175 * t8 + t198;
  const S t3_2 = sine[1];
  const S t200 = t3_2 * t190 + t195;
  const S t201 = t175 + t174 * t169;
  const S t202 = t175 * t9 + t196;
  const S t203 = t9 * t199;
  const S t204 = t8 * t161 - t202;
  const S t205 = t8 * t204 + t203;
  const S t206 = S(0.00288) * t185;
  const S t207 = t9 * t204;
  const S t208 = t8 * t199 - t207;
  const S t209 = t3_2 * t200;
  const S t210 = t16_2 + t209;
  ALEMBERT_FROM_MEMORY;
  const S t2_2 = cosine[1];
  const S t146_2 = kept[24];
  const S t211 = t2_2 * t146_2;
  const S t212 = t189 + t16_2;
  M[11] = t212;
  const S t213 = t3_2 * kept[3] - kept[7];
  kept[1] = t213;
  const S t214 = t189 - t209;
  const S t57_2 = kept[11];
  const S t215 = S(0.8636) * t57_2 - t214;
  M[7] = t212 - S(0.4318) * t57_2;
  const S t217 = t3_2 * t146_2;
  const S t218 = S(2e-05) * t205;
  const S t219 = t210 + S(0.0731264);
  const S t220 = kept[6] - t2_2 * t200;
  const S t221 = S(1.674987602) - t215;
  const S t222 = t220 + S(0.4318) * kept[10];
  const S t223 = t221 - t219;
  const S t224 = S(0.0070992) - t222;
  const S t107_2 = kept[14];
  const S t225 = t2_2 * t107_2 - t217;
  const S t226 = S(0.00288) * t201;
  const S t227 = t3_2 * t107_2 + t211;
  const S t228 = cosine[0] * t224;
  const S t229 = S(0.00062216) * t161 + t218;
  const S t230 = t228 + t228;
  const S t5_3 = cosine[2];
  const S t231 = t5_3 * t226;
  const S t0_2 = sine[0];
  const S t232 = t0_2 * t223 + t230;
  const S t233 = t227 - S(0.0203) * kept[22];
  M[6] = t221 + t219;
  const S t235 = t221 - t0_2 * t232;
  const S t101_3 = kept[13];
  const S t236 = S(0.0203) * t101_3 + t225;
  const S t237 = t233 + S(0.4331) * t101_3;
  const S t4_4 = sine[2];
  const S t238 = t4_4 * t237;
  const S t139_2 = kept[21];
  const S t239 = t5_3 * t139_2 + t238;
  const S t240 = t4_4 * t226;
  const S t241 = t4_4 * t206 - t231;
  const S t242 = t5_3 * t206 + t240;
  const S t243 = S(0.00288) * t239;
  const S t244 = S(1.9898291387670284) * t237 + t242;
  const S t245 = S(0.00042216) * t201 + t243;
  const S t246 = t245 + S(2e-05) * t208;
  const S t247 = t241 - S(1.9898291387670284) * t139_2;
  const S t248 = S(0.4331) * kept[23] - t236;
  const S t249 = t5_3 * t237;
  const S t250 = t4_4 * t139_2 - t249;
  const S t7_3 = cosine[3];
  const S t251 = t7_3 * t246;
  const S t252 = t7_3 * t250;
  const S t186_2 = kept[32];
  const S t253 = t7_3 * t186_2;
  const S t6_3 = sine[3];
  const S t254 = t6_3 * t186_2 + t251;
  const S t255 = t6_3 * t246 - t253;
  const S t256 = t6_3 * t248 + t252;
  const S t257 = S(0.00022216) * kept[29] + t229;
  const S t258 = S(0.00288) * t256 - t257;
  c[4] = t258;
  const S t259 = kept[0] + t235;
  const S t260 = t258 - S(0.00065) * kept[28];
  const S t261 = t254 + S(0.00075) * kept[27];
  const S t262 = t4_4 * t261;
  const S t263 = S(0.7398291387670284) * t233 - t244;
  const S t264 = t4_4 * t260;
  const S t265 = t5_3 * t260 - t262;
  const S t266 = t255 - kept[31];
  c[3] = t266;
  ALEMBERT_FROM_MEMORY;
  const S t2_3 = cosine[1];
  const S t267 = t2_3 * t263;
  const S t268 = t265 - S(0.4331) * t244;
  const S t269 = t5_3 * t261 + t264;
  const S t270 = t268 - kept[15];
  const S t271 = S(0.7398291387670284) * kept[20] + t247;
  const S t272 = t269 - S(0.4331) * t247;
  const S t273 = kept[25] + t272;
  const S t21_2 = kept[2];
  M[10] = S(4e-05) * t21_2;
  const S t275 = S(1.9898291387670284) * t248;
  const S t3_3 = sine[1];
  const S t276 = t3_3 * t273;
  const S t277 = kept[30] - t266;
  const S t278 = S(0.7398291387670284) * t236 + t275;
  const S t279 = kept[3] - S(0.00043228799999999996) * t21_2;
  const S t280 = t278 + S(0.00288) * kept[33];
  const S t281 = t2_3 * t273;
  const S t282 = t3_3 * t280 - t267;
  const S t283 = t277 - S(0.0203) * t271;
  const S t284 = t2_3 * t283 - t276;
  const S t285 = kept[5] - t2_3 * t279;
  const S t286 = t282 + S(7.540157480314961) * kept[24];
  const S t287 = t2_3 * t280;
  const S t288 = t3_3 * t263 + t287;
  const S t289 = t286 - S(0.1044) * kept[12];
  const S t290 = t288 - S(7.540157480314961) * kept[14];
  const S t291 = t284 + S(0.0934) * t286;
  const S t292 = t2_3 * kept[4] + kept[1];
  const S t293 = t290 - S(0.1044) * kept[16];
  const S t294 = S(0.0203) * t280 - t270;
  const S t295 = t3_3 * t283 + t281;
  const S t296 = S(0.000864576) * t21_2 + t259;
  const S t297 = t271 + S(7.540157480314961) * kept[19];
  M[0] = t296 + S(1.4724995505);
  const S t299 = S(0.4318) * t297 + t291;
  const S t1_2 = cosine[0];
  const S t300 = t1_2 * t289;
  const S t301 = kept[17] + t299;
  const S t302 = t295 - S(0.0934) * t290;
  const S t303 = t1_2 * t301;
  c[2] = -t294;
  const S t305 = t302 + kept[18];
  const S t0_3 = sine[0];
  const S t306 = t0_3 * t305 - t303;
  const S t307 = t0_3 * t292;
  const S t308 = t294 - S(0.4318) * t290;
  M[3] = t1_2 * t285 + t307;
  const S t310 = t0_3 * t293 + t300;
  const S t311 = S(0.2435) * t310;
  c[0] = t306 + t311;
  c[1] = kept[26] - t308;
  M[17] = S(0.00064216);
  M[18] = S(4e-05);
  M[15] = S(0.0);
}

/// All packs together have 34 values in kept. Inside a loop, compilers would put the constants of a block into memory.
template <class S>
inline void mass_matrix_and_bias_packs(int packs, const S* q, const S* qd, S* M, S* c, S* kept,
    const Inputs<S>* inputs) {
  for (int k = 0; k < packs; ++k)
    mass_matrix_and_bias_pack_block1<S>(q + 6 * k, qd + 6 * k, M + 19 * k, c + 6 * k, kept, inputs[k]);
}

}  // namespace alembert::mechanisms::puma560::detail

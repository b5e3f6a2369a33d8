// chain6r: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "chain6r". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over several packs of states, whose arrays follow each other. Each is cut into blocks, and a block is done for
// all packs before the next one begins: then its code, and what it hands over, are in the nearest caches.
#pragma once

#include <cmath>

#include "chain6r_raw.hpp"

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

namespace alembert::mechanisms::chain6r::detail {

// inverse_dynamics in 1 blocks.
template <class S>
ALEMBERT_NOINLINE void inverse_dynamics_packs_block1(int packs, [[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] const S* ALEMBERT_RESTRICT qdd,
    [[maybe_unused]] S* ALEMBERT_RESTRICT tau, [[maybe_unused]] const Inputs<S>* ALEMBERT_RESTRICT inputs,
    [[maybe_unused]] S* ALEMBERT_RESTRICT w) {
  using detail::sines_and_cosines;
  for (; packs > 0; --packs, q += 6, qd += 6, qdd += 6, tau += 6, ++inputs, w += 1) {
    [[maybe_unused]] const Inputs<S>& in = *inputs;
    const S q5 = q[5];  // q6
    const S t0 = S(1.037952439175508) - q5;
    const S q1 = q[1];  // q2
    const S q2 = q[2];  // q3
    const S q3 = q[3];  // q4
    const S q4 = q[4];  // q5
    const S angle[] = {q1, q2, q3, q4, t0};
    S sine[5], cosine[5];
    sines_and_cosines(5, angle, sine, cosine);
    const S t1 = sine[0];
    const S t2 = cosine[0];
    const S t3 = sine[1];
    const S t4 = cosine[1];
    const S t5 = sine[2];
    const S t6 = cosine[2];
    const S t7 = cosine[3];
    const S t8 = sine[3];
    const S t9 = sine[4];
    const S t10 = cosine[4];
    const S qdd0 = qdd[0];  // dd(q1)
    const S qd0 = qd[0];  // d(q1)
    const S t11 = qd0 * t2;
    const S qd1 = qd[1];  // d(q2)
    const S t12 = S(0.8087360605531302) * (qd1 * t11 + qdd0 * t1);
    const S t13 = qd1 + S(0.588171730331375) * qd0;
    const S t14 = S(0.8044781165221552) * t13 - S(0.48037489671056854) * t11;
    const S t15 = S(0.6506104627573298) * t11 + S(0.5939822893293754) * t13;
    const S t16 = t14 * t15;
    const S t17 = t12 - t16;
    const S t18 = qd0 * qd0;
    const S t19 = S(5.769964674550788) - S(0.3081284390707426) * qdd0 - S(0.31721619758491315) * t18;
    const S t20 = S(0.3922369893682681) * qdd0 - S(0.381) * t18;
    const S t21 = S(0.23070270873670343) * t18 + (S(0.22409342925625386) * qdd0 + S(7.933700754026208));
    const S t22 = t1 * t20 - t2 * t21;
    const S t23 = t1 * qd0;
    const S t24 = qdd0 * t2 - qd1 * t23;
    const S qdd1 = qdd[1];  // dd(q2)
    const S t25 = qdd1 + S(0.588171730331375) * qdd0;
    const S t26 = S(0.4803748967105686) * t24 - S(0.8044781165221552) * t25;
    const S t27 = t15 * t23;
    const S t28 = t26 - S(0.8087360605531302) * t27;
    const S t29 = S(0.7383448687171558) * t19 - t22 - S(1.042912147352232) * t28;
    const S t30 = S(0.38534298650678417) * t17 - t29;
    const S t31 = S(0.8044781165221552) * t3;
    const S qd2 = qd[2];  // d(q3)
    const S t32 = t14 + qd2;
    const S t33 = S(0.8087360605531302) * t23;
    const S t34 = t15 * t4 - t3 * t33;
    const S t35 = S(0.805664471353141) * t32 - S(0.5923721462047856) * t34;
    const S t36 = t35 * t35;
    const S t37 = S(0.5923721462047856) * t32 + S(0.805664471353141) * t34;
    const S t38 = t37 * t37;
    const S t39 = t14 * t14;
    const S t40 = t15 * t15;
    const S t41 = t1 * t21 + t2 * t20 - S(0.839) * (t39 + t40);
    const S t42 = t14 * t33;
    const S t43 = S(0.6506104627573298) * t24 + S(0.5939822893293754) * t25;
    const S t44 = t42 + t43;
    const S t45 = t41 + S(0.31) * t44;
    const S t46 = S(0.29) * (t36 + t38) - (t4 * t45 - t30 * t31);
    const S qd3 = qd[3];  // d(q4)
    const S t47 = t35 + qd3;
    const S t48 = t4 * t33 + t15 * t3;
    const S t49 = t5 * t48 - t37 * t6;
    const S t50 = S(0.8472551110134161) * t47 + S(0.5311861979208834) * t49;
    const S t51 = S(0.5311861979208834) * t47 - S(0.8472551110134161) * t49;
    const S t52 = t50 * t51;
    const S t53 = t12 * t3 - t4 * t43 + qd2 * t48;
    const S qdd2 = qdd[2];  // dd(q3)
    const S t54 = t26 - qdd2;
    const S t55 = S(0.805664471353141) * t53 + S(0.5923721462047856) * t54;
    const S t56 = qd2 * t34 + (t3 * t43 + t12 * t4);
    const S t57 = qd3 * t49 + (t5 * t55 - t6 * t56);
    const S t58 = t52 + t57;
    const S t59 = t48 * t6 + t37 * t5;
    const S t60 = t51 * t59;
    const S t61 = qd3 * t59 + (t6 * t55 + t5 * t56);
    const S t62 = S(0.5923721462047856) * t53 - S(0.805664471353141) * t54;
    const S qdd3 = qdd[3];  // dd(q4)
    const S t63 = qdd3 + t62;
    const S t64 = S(0.5311861979208834) * t61 + S(0.8472551110134161) * t63;
    const S t65 = t60 + t64;
    const S t66 = t48 * t48;
    const S t67 = t35 * t48;
    const S t68 = t55 + t67;
    const S t69 = S(0.8044781165221552) * t4;
    const S t70 = t30 * t69 + t3 * t45;
    const S t71 = t23 * (S(0.6540540156389962) * t23);
    const S t72 = t42 - t43;
    const S t73 = S(1.042912147352232) * t72 + (t19 + S(0.7383448687171558) * t22);
    const S t74 = S(0.38534298650678417) * (t40 + t71) - t73;
    const S t75 = S(0.4474345853456771) * t68 + (S(0.9139578814050588) * t70 - t74);
    const S t76 = S(0.8454970785152796) * (t38 + t66) - t75;
    const S t77 = t55 - t67;
    const S t78 = t46 + S(0.548) * t77;
    const S t79 = t35 * t37;
    const S t80 = t56 - t79;
    const S t81 = t37 * t48;
    const S t82 = t62 + t81;
    const S t83 = t70 + S(0.5914998680016632) * t74 - S(0.35995133248576183) * t82;
    const S t84 = S(0.6801838972489569) * t80 + t83;
    const S t85 = S(0.805664471353141) * t84;
    const S t86 = t5 * t78 - t6 * t85;
    const S t87 = S(0.3517240511462447) * t65 - (S(0.4063507183397911) * t76 - t86);
    const S t88 = S(0.9229805637461859) * t58 + t87;
    const S t89 = S(0.8472551110134161) * t7;
    const S qdd4 = qdd[4];  // dd(q5)
    const S t90 = t64 + qdd4;
    const S t91 = S(0.5311861979208834) * t63 - S(0.8472551110134161) * t61;
    const S t92 = t59 * t7 + t51 * t8;
    const S qd4 = qd[4];  // d(q5)
    const S t93 = t57 * t8 + t7 * t91 - qd4 * t92;
    const S t94 = S(0.9286646355765102) * t90 - S(0.3709204694129827) * t93;
    const S t95 = t51 * t7 - t59 * t8;
    const S t96 = t50 + qd4;
    const S t97 = S(0.9286646355765102) * t95 + S(0.3709204694129827) * t96;
    const S t98 = t92 * t97;
    const S t99 = t94 + t98;
    const S t100 = t50 * t59;
    const S t101 = t91 - t100;
    const S t102 = S(0.5426672585542128) * t101 + (t76 + S(0.9673065698240312) * t86);
    const S t103 = t51 * t51;
    const S t104 = t59 * t59;
    const S t105 = t102 + S(1.4240462959375653) * (t103 + t104);
    const S t106 = t91 + t100;
    const S t107 = t50 * t50;
    const S t108 = S(0.298) * (t103 + t107) + (t5 * t85 + t6 * t78);
    const S t109 = S(0.782) * t106 - t108;
    const S t110 = t8 * t109 - t88 * t89;
    const S t111 = S(0.21933328225876517) * t105 + t110;
    const S t112 = S(0.5610206096375856) * t99 - t111;
    const S t113 = S(0.9286646355765102) * t96 - S(0.3709204694129827) * t95;
    const S qd5 = qd[5];  // d(q6)
    const S t114 = qd5 + t113;
    const S t115 = t114 * t114;
    const S t116 = t92 * t9 + t97 * t10;
    const S t117 = t116 * t116;
    const S t118 = t115 + t117;
    const S t119 = S(0.9286646355765102) * t9;
    const S t120 = S(0.9286646355765102) * t10;
    const S t121 = t97 * t9 - t92 * t10;
    const S t122 = t116 * t121;
    const S qdd5 = qdd[5];  // dd(q6)
    const S t123 = t94 + qdd5;
    const S t124 = t122 - t123;
    const S t125 = S(2.0103112683343562) * t112 + S(0.5578117245092649) * (t118 * t119 - t120 * t124);
    const S t126 = t97 * t113;
    const S t127 = qd4 * t95 + (t8 * t91 - t57 * t7);
    const S t128 = t126 - t127;
    const S t129 = t125 - S(2.726968712472971) * t128;
    const S t130 = S(0.3709204694129827) * t90 + S(0.9286646355765102) * t93;
    const S t131 = qd5 * t121 + (t9 * t127 + t10 * t130);
    const S t132 = t114 * t121;
    const S t133 = t131 + t132;
    const S t134 = t92 * t113;
    const S t135 = t130 - t134;
    const S t136 = S(1.0216359604847038) * t135 + (t105 - S(0.7273429751097309) * t110);
    const S t137 = S(0.28446522999390667) * t133 + S(0.6062176771268533) * t136;
    const S t138 = t97 * t97;
    const S t139 = t92 * t92;
    const S t140 = t137 - S(1.4974860994599004) * (t138 + t139);
    const S t141 = t129 + S(0.7273429751097309) * t140;
    const S t142 = S(0.8472551110134161) * t8;
    const S t143 = t113 * t113;
    const S t144 = t88 * t142 + t7 * t109;
    const S t145 = S(0.521) * (t138 + t143) - t144;
    const S t146 = t130 + t134;
    const S t147 = S(2.3310172744721687) * t145 + (S(2.936440786054142) * t146 + S(0.5578117245092649) * (t9 * t124 + t10 * t118));
    const S t148 = S(6.134005213997661) * t88 + (t89 * t141 - t142 * t147);
    const S t149 = t148 - S(3.931878268516937) * t87;
    const S t150 = S(1.6517220172784755) * t102 - (S(2.5768019186113977) * t105 + (t140 - S(0.21933328225876517) * t129));
    const S t151 = t149 - S(0.9673065698240312) * t150;
    const S t152 = t7 * t147 + t8 * t141 - S(8.545072386871544) * t109;
    const S t153 = t152 - S(5.477364829128948) * t108;
    const S t154 = t5 * t151 + t6 * t153 - S(1.8347127580804645) * t78;
    const S t155 = S(8.197229305176045) * t46 + t154;
    const S t156 = S(1.1909033187725369) * t84 - S(0.805664471353141) * (t5 * t153 - t6 * t151);
    const S t157 = t156 - S(5.320782526463204) * t83;
    const S t158 = S(3.4435308520237036) * t75 + (S(0.7707348119519144) * t76 + (t150 + S(0.4063507183397911) * t149));
    const S t159 = t157 - S(0.9139578814050588) * t158;
    const S t160 = S(3.4249850813773137) * t30 + (t31 * t155 - t69 * t159);
    const S t161 = t56 + t79;
    const S t162 = t121 * t121;
    const S t163 = t114 * t116;
    const S t164 = qd5 * t116 + (t10 * t127 - t9 * t130);
    const S t165 = t122 + t123;
    const S t166 = S(0.007799848827756481) * (t117 - t162) - (S(0.002412705769599087) * (t131 - t132) + S(0.06340355585360308) * (t163 - t164)) + S(0.15119204837669592) * t124 - S(0.027700080589956953) * t165;
    const S t167 = S(0.28446522999390667) * (t9 * t145 - t112 * t120) + t166;
    const S t168 = S(0.22450019424978354) * t98 - (S(0.05851404887456145) * t128 + S(0.010388859360985173) * (t138 - t139) + S(0.24829267605364228) * t94) + (t167 - S(0.2861016535503581) * t125);
    const S t169 = t126 + t127;
    const S t170 = t163 + t164;
    const S t171 = S(0.12432889190526168) * (t115 - t162) - (S(0.015294829268292676) * t170 + S(0.00473110744009856) * t165) - S(0.2964745365853657) * t133 - S(0.28446522999390667) * t136;
    const S t172 = S(0.00473110744009856) * (t115 - t117) - (S(0.015294829268292676) * t133 + S(0.12432889190526168) * t124) - S(0.054317463414634115) * t170;
    const S t173 = S(2.726968712472971) * t144 - (S(0.1702899688739026) * t146 + (S(0.10655590097203183) * (t139 - t143) - S(0.018918435667554002) * t169) + S(0.021663424286411097) * t135) - (S(0.9487571869353855) * t137 - (t120 * t171 - t119 * t172));
    const S t174 = S(0.7273429751097309) * t168 - t173;
    const S t175 = S(2.726968712472971) * t111 - (S(0.4635529732847989) * t169 - (S(0.020371655108638375) * t135 + S(0.11474099140846737) * t99) - S(0.18337079108023474) * t128) + (t10 * t172 + t9 * t171);
    const S t176 = t52 - t57;
    const S t177 = S(0.4597776083896958) * t150 + (S(0.6625534968124914) * t152 - (t89 * t174 - t142 * t175) + (S(0.07035287305215757) * (t104 - t107) + S(0.0600462989503283) * t176 - S(2.039139880011506) * t106 - S(0.19006372234750632) * t101));
    const S t178 = t168 + S(0.21933328225876517) * t173;
    const S t179 = S(0.19314555206597184) * t149 + (S(0.18082974846630914) * t64 + (S(0.03891837436335415) * (t103 - t104) - S(0.045598471493577875) * t58) + S(0.0655458393224338) * t60 - t178);
    const S t180 = t177 + S(0.9673065698240312) * t179;
    const S t181 = S(2.4067601995017256) * t58 - (S(0.08303623328752484) * t65 - S(0.07087156886962401) * t101 + S(0.10496779015187885) * t176) + (t7 * t175 + t8 * t174 + S(0.9229805637461859) * t148);
    const S t182 = S(1.354160905705215) * t80 + (S(0.3805944736706004) * t161 + (S(0.14681941086255584) * t68 - S(0.30377309971416566) * t82)) - (S(0.6801838972489569) * t156 - (t5 * t180 - t6 * t181));
    const S t183 = t179 - S(0.4063507183397911) * t177;
    const S t184 = t183 + (S(0.25981813514630525) * t62 - (S(0.19688732566135583) * t80 - S(0.09515945021828555) * (t38 - t66)) - S(0.2335384402252793) * t81) + S(0.233298653791425) * t157;
    const S t185 = S(0.44150413030152125) * t154 + (S(0.016333380847347253) * t68 + (S(0.24473919379251827) * (t36 - t66) + (S(1.0909993302220828) * t77 + S(0.11828718303696069) * t161))) + S(0.805664471353141) * (t6 * t180 + t5 * t181);
    const S t186 = S(0.3604821486676368) * t158 + t185;
    const S t187 = S(0.9139578814050588) * t184 + t186;
    const S t188 = t12 + t16;
    const S t189 = t158 + S(0.5914998680016632) * t157 - S(3.4249850813773137) * t74 - S(3.471839671679194) * t73;
    const S t190 = t3 * t159 + t4 * t155 - S(5.292126470619502) * t45;
    const S t191 = S(0.839) * t189 + (S(0.46999542314703946) * t72 - (S(0.07388032527886275) * (t39 - t71) - S(0.062257240931197284) * t188 + S(0.0034811001465595076) * t44) + (t69 * t187 - t31 * t182 + S(0.2493882161218681) * t190));
    const S t192 = t184 - S(0.5914998680016632) * t186;
    const S t193 = t160 + S(3.471839671679194) * t29;
    const S t194 = t192 - (S(0.616879839118648) * t26 - (S(0.062257240931197506) * (t40 - t71) + S(0.07388032527886275) * t17) - S(0.2613115230644122) * t27) - S(0.839) * t193;
    const S t195 = t2 * (t191 + S(0.7383448687171558) * t194);
    const S t196 = t190 + S(5.3645239881896805) * t41;
    const S t197 = t193 + S(0.7383448687171558) * t189;
    const S t198 = S(0.485) * (t2 * t196 - t1 * t197);
    const S t199 = t1 * (S(0.38534298650678417) * t160 + (t4 * t182 + t3 * t187) + (S(0.004327153312272403) * t17 + (S(0.07738835855516146) * t72 - S(0.09183633931306323) * t28 + S(0.18258348232840138) * t188))) - t195 - t198;
    const S t200 = t194 - S(0.7383448687171558) * t191;
    tau[1] = t200;
    tau[0] = S(0.8191587312311255) * qdd0 + (S(0.8087360605531302) * (t199 - S(0.381) * (t189 - S(0.7383448687171558) * t193)) - S(0.588171730331375) * (S(0.381) * (t2 * t197 + t1 * t196) - t200));
    tau[2] = S(1.2430418919573683) * t192;
    tau[3] = S(1.5428778805023349) * t183;
    tau[4] = S(-1.8210310689738687) * t178;
    tau[5] = S(-1.9609135517940572) * t167;
  }
}

/// All blocks; a pack has 1 values in w.
template <class S>
void inverse_dynamics_packs(int packs, [[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] const S* ALEMBERT_RESTRICT qdd,
    [[maybe_unused]] S* ALEMBERT_RESTRICT tau, [[maybe_unused]] const Inputs<S>* ALEMBERT_RESTRICT inputs,
    [[maybe_unused]] S* ALEMBERT_RESTRICT w) {
  inverse_dynamics_packs_block1<S>(packs, q, qd, qdd, tau, inputs, w);
}

// mass_matrix_and_bias in 3 blocks.
template <class S>
ALEMBERT_NOINLINE void mass_matrix_and_bias_packs_block1(int packs, [[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] S* ALEMBERT_RESTRICT M,
    [[maybe_unused]] S* ALEMBERT_RESTRICT c, [[maybe_unused]] const Inputs<S>* ALEMBERT_RESTRICT inputs,
    [[maybe_unused]] S* ALEMBERT_RESTRICT w) {
  using detail::sines_and_cosines;
  for (; packs > 0; --packs, q += 6, qd += 6, M += 36, c += 6, ++inputs, w += 86) {
    [[maybe_unused]] const Inputs<S>& in = *inputs;
    const S q5 = q[5];  // q6
    const S t0 = S(1.037952439175508) - q5;
    const S q1 = q[1];  // q2
    const S q2 = q[2];  // q3
    const S q3 = q[3];  // q4
    const S q4 = q[4];  // q5
    const S angle[] = {q1, q2, q3, q4, t0};
    S sine[5], cosine[5];
    sines_and_cosines(5, angle, sine, cosine);
    const S t1 = sine[0];
    w[0] = t1;
    const S t2 = cosine[0];
    w[1] = t2;
    const S t3 = sine[1];
    w[2] = t3;
    const S t4 = cosine[1];
    w[3] = t4;
    const S t5 = sine[2];
    w[4] = t5;
    const S t6 = cosine[2];
    w[5] = t6;
    const S t7 = sine[3];
    w[6] = t7;
    const S t8 = cosine[3];
    w[7] = t8;
    const S t9 = sine[4];
    w[8] = t9;
    const S t10 = cosine[4];
    w[9] = t10;
    const S t11 = S(0.03058965853658535) * t10 + S(0.2421570731707316) * t9;
    const S t12 = t9 * t11;
    const S t13 = t12 + S(0.054317463414634115);
    const S t14 = S(0.00473110744009856) * t10 + S(0.12432889190526168) * t9;
    w[10] = t14;
    const S t15 = S(1.8573292711530205) * t14 - S(0.3709204694129827) * t13;
    const S t16 = S(0.3709204694129827) * t15;
    const S t17 = t13 + t16 + S(0.42500494979743564);
    const S t18 = S(0.12432889190526168) * t10 - S(0.00473110744009856) * t9;
    w[11] = t18;
    const S t19 = S(0.015294829268292676) - t10 * t11 - S(0.290619908469327) * t9;
    const S t20 = S(0.3709204694129827) * t18 - S(0.9286646355765102) * t19 + S(0.023641346726585723);
    const S t21 = t8 * t20;
    const S t22 = S(0.9525356965853659) - (t12 - S(0.581239816938654) * t10);
    const S t23 = t21 + t21 + t7 * (t17 - t22);
    const S t24 = t7 * t23;
    const S t25 = t17 - t24;
    const S t26 = S(0.5578117245092649) * t10 + S(1.2144599999999999);
    const S t27 = S(1.08918599476663) - S(0.5180200218617012) * t9;
    const S t28 = t7 * t26 + t8 * t27;
    const S t29 = S(0.3709204694129827) * t19 + S(0.9286646355765102) * t18 + S(0.11411216484764738);
    const S t30 = t14 - S(0.9286646355765102) * t15 + S(0.09651175692929806);
    const S t31 = S(0.782) * t28 + (t7 * t29 + t8 * t30);
    const S t32 = t16 + S(0.32359752239730155) * t9;
    const S t33 = S(1.6945102220268322) * t31 + S(0.5311861979208834) * (t25 + t32);
    const S t34 = S(0.5311861979208834) * t33;
    const S t35 = t25 - t34 + S(1.4902889476962993);
    const S t36 = t20 - t8 * t23 + S(0.298) * t28;
    const S t37 = t7 * t27 - t8 * t26;
    w[12] = t37;
    const S t38 = S(0.782) * t37 - (t8 * t29 - t7 * t30);
    w[13] = t38;
    const S t39 = S(0.06165732843631448) * t9 + t38;
    const S t40 = S(0.8104868845510949) - (S(0.8472551110134161) * t36 + S(0.5311861979208834) * t39);
    const S t41 = t6 * t40;
    const S t42 = t22 + t24 - S(0.596) * t37 + S(0.7037571599999999);
    const S t43 = t41 + t41 + t5 * (t35 - t42);
    const S t44 = t5 * t43;
    const S t45 = t35 - t44;
    const S t46 = S(1.426167937307199) - (S(0.8472551110134161) * t39 - S(0.5311861979208834) * t36);
    const S t47 = t31 - S(0.8472551110134161) * t33 + S(2.209621476835416);
    const S t48 = S(1.6088199999999997) - t37;
    const S t49 = S(3.069264713258708) - (S(0.10990443579209751) * t9 + S(0.8472551110134161) * t28);
    const S t50 = t5 * t48 - t6 * t49;
    const S t51 = t5 * t46 - t6 * t47 + S(0.548) * t50;
    const S t52 = S(0.17530029076879292) * t9 - S(0.5311861979208834) * t28;
    const S t53 = t32 - t34 + S(1.096) * t52;
    const S t54 = S(1.611328942706282) * t51 + S(0.5923721462047856) * (t45 + t53);
    const S t55 = S(0.5923721462047856) * t54;
    const S t56 = t45 - t55 + S(4.254143795423817);
    const S t57 = t6 * t48 + t5 * t49;
    w[14] = t57;
    const S t58 = S(0.58) * t57 + (t42 + t44) + S(1.0093935799999993);
    const S t59 = S(0.548) * t57 + (t5 * t47 + t6 * t46);
    const S t60 = S(0.29) * t52 - t59;
    const S t61 = S(0.29) * t50 + (t40 - t6 * t43);
    const S t62 = S(1.2381717465857929) - (S(0.5923721462047856) * t60 + S(0.805664471353141) * t61);
    const S t63 = t4 * t62;
    const S t64 = t3 * (t56 - t58) + (t63 + t63);
    const S t65 = t3 * t64;
    const S t66 = t56 - t65;
    const S t67 = t57 + S(3.41076);
    const S t68 = S(4.0569386433992864) - (S(0.805664471353141) * t50 + S(0.5923721462047856) * t52);
    const S t69 = t3 * t67 - t4 * t68;
    w[15] = t69;
    const S t70 = S(0.5923721462047856) * t61 - S(0.805664471353141) * t60 + S(1.9318436963178551);
    const S t71 = t51 - S(0.805664471353141) * t54 + S(5.268277866481175);
    const S t72 = t3 * t70 - t4 * t71;
    w[16] = t72;
    const S t73 = S(0.31) * t69 + t72;
    const S t74 = S(0.805664471353141) * t52 - S(0.5923721462047856) * t50;
    const S t75 = t53 - t55 + S(0.62) * t74;
    const S t76 = S(1.6089562330443103) * t73 + S(0.5939822893293754) * (t66 + t75);
    const S t77 = S(0.5939822893293754) * t76;
    const S t78 = t66 - t77 + S(4.567134699867921);
    const S t79 = t62 - t4 * t64 + S(0.839) * t69;
    const S t80 = t3 * t68 + t4 * t67;
    w[17] = t80;
    const S t81 = t4 * t70 + t3 * t71;
    const S t82 = S(0.839) * t74 - (S(0.31) * t80 + t81);
    const S t83 = t2 * (S(5.267500548921968) - (S(0.8044781165221552) * t79 + S(0.5939822893293754) * t82));
    const S t84 = S(1.678) * t80 + (t58 + t65) + S(8.81224666);
    const S t85 = t1 * (t83 + t83 + t1 * (t78 - t84));
    const S t86 = t78 - t85;
    const S t87 = t80 + S(9.806939999999999);
    const S t88 = S(6.417529140550618) - (S(0.5939822893293754) * t74 + S(0.8044781165221552) * t69);
    const S t89 = t2 * (t73 - S(0.8044781165221552) * t76 + S(5.938351308863973)) - t1 * (S(0.5939822893293754) * t79 - S(0.8044781165221552) * t82 + S(7.264488110921741)) - S(0.485) * (t1 * t87 - t2 * t88);
    const S t90 = t2 * t87 + t1 * t88;
    const S t91 = S(0.8087360605531302) * (S(0.8087360605531302) * (t86 + (S(0.97) * (S(0.8044781165221552) * t74 - S(0.5939822893293754) * t69) + (t75 - t77))) - S(1.17634346066275) * t89) - (t86 + (t84 + t85 + S(0.762) * t90));
    M[0] = S(15.208432304136565) - t91;
    const S t93 = t78 + t84;
    M[7] = t93;
    const S t94 = S(0.588171730331375) * (S(0.381) * t90 + t93) + S(0.8087360605531302) * t89;
    M[1] = t94;
    M[6] = t94;
    const S t95 = S(0.47317128580856155) - S(0.48037489671056854) * t2;
    w[18] = t95;
    const S t96 = t56 + t58;
    w[19] = t96;
    M[14] = t96;
    const S t97 = S(0.6506104627573298) * t2 + S(0.34936359090105007);
    w[20] = t97;
    const S t98 = S(0.8087360605531302) * t1;
    w[21] = t98;
    const S t99 = S(0.226307252234492) * t1 + S(0.7001718865132452);
    const S t100 = S(0.381) * t2;
    w[22] = t100;
    const S t101 = t100 + S(0.839);
    const S t102 = t98 * t99 - t95 * t101;
    w[23] = t102;
    const S t103 = S(0.28808141032474704) - S(0.3065061623949411) * t1;
    const S t104 = t95 * t103 - t99 * t97;
    w[24] = t104;
    const S t105 = t95 * t96 - (t72 * t97 + t81 * t98) - (t80 * t102 - t69 * t104);
    M[2] = t105;
    M[12] = t105;
    const S t106 = t35 + t42;
    M[21] = t106;
    const S t107 = S(0.29) * t57 + t106;
    const S t108 = S(0.805664471353141) * t107 - S(0.5923721462047856) * t51;
    w[25] = t108;
    M[15] = t108;
    M[20] = t108;
    const S t109 = S(0.805664471353141) * t51 + S(0.5923721462047856) * t107;
    const S t110 = t3 * t59 + t4 * t109;
    w[26] = t110;
    const S t111 = t101 * t97 - t98 * t103;
    w[27] = t111;
    const S t112 = S(0.805664471353141) * t57;
    const S t113 = t4 * t112 - t50 * t3;
    w[28] = t113;
    const S t114 = t3 * t112 + t50 * t4;
    w[29] = t114;
    const S t115 = t95 * t108 + (t98 * (t3 * t109 - t4 * t59) - t97 * t110) - (S(0.5923721462047856) * (t57 * t111) + (t102 * t113 - t104 * t114));
    M[3] = t115;
    M[18] = t115;
    const S t116 = t17 + t22;
    M[28] = t116;
    const S t117 = t116 - S(0.298) * t37;
    const S t118 = S(0.8472551110134161) * t117 - S(0.5311861979208834) * t31;
    M[22] = t118;
    M[27] = t118;
    const S t119 = S(0.8472551110134161) * t37;
    const S t120 = t6 * t119 + t28 * t5;
    w[30] = t120;
    const S t121 = t118 - S(0.29) * t120;
    w[31] = t121;
    const S t122 = S(0.5311861979208834) * t117 + S(0.8472551110134161) * t31;
    w[32] = t122;
    const S t123 = t5 * t119 - t28 * t6;
    w[33] = t123;
  }
}

template <class S>
ALEMBERT_NOINLINE void mass_matrix_and_bias_packs_block2(int packs, [[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] S* ALEMBERT_RESTRICT M,
    [[maybe_unused]] S* ALEMBERT_RESTRICT c, [[maybe_unused]] const Inputs<S>* ALEMBERT_RESTRICT inputs,
    [[maybe_unused]] S* ALEMBERT_RESTRICT w) {
  for (; packs > 0; --packs, q += 6, qd += 6, M += 36, c += 6, ++inputs, w += 86) {
    [[maybe_unused]] const Inputs<S>& in = *inputs;
    const S t121 = w[31];
    const S t5 = w[4];
    const S t38 = w[13];
    const S t6 = w[5];
    const S t122 = w[32];
    const S t123 = w[33];
    const S t37 = w[12];
    const S t124 = t5 * t38 - t6 * t122 + S(0.548) * t123 + S(0.15404399739705618) * t37;
    const S t125 = S(0.5923721462047856) * t121 - S(0.805664471353141) * t124;
    const S t3 = w[2];
    const S t120 = w[30];
    const S t126 = t6 * t38 + t5 * t122 + S(0.548) * t120;
    const S t4 = w[3];
    const S t98 = w[21];
    const S t127 = t3 * t126 - t4 * t125;
    const S t97 = w[20];
    const S t128 = S(0.805664471353141) * t121 + S(0.5923721462047856) * t124;
    M[16] = t128;
    M[26] = t128;
    const S t95 = w[18];
    const S t129 = S(0.805664471353141) * t120 - S(0.3146599080967537) * t37;
    const S t130 = t4 * t123 + t3 * t129;
    const S t104 = w[24];
    const S t131 = t3 * t123 - t4 * t129;
    const S t102 = w[23];
    const S t132 = S(0.42795784733801345) * t37 + S(0.5923721462047856) * t120;
    const S t111 = w[27];
    const S t133 = t98 * (t3 * t125 + t4 * t126) + t97 * t127 + t95 * t128 - (t104 * t130 + t102 * t131 - t111 * t132);
    M[4] = t133;
    M[24] = t133;
    const S t10 = w[9];
    const S t134 = S(0.5180200218617012) * t10;
    const S t8 = w[7];
    const S t9 = w[8];
    const S t135 = S(0.5578117245092649) * t9;
    const S t7 = w[6];
    const S t136 = t8 * t134 + t7 * t135;
    const S t14 = w[10];
    const S t137 = S(0.290619908469327) * t10 + S(0.3507919999999998);
    const S t138 = S(0.3709204694129827) * t14 + S(0.9286646355765102) * t137;
    M[29] = t138;
    M[34] = t138;
    const S t139 = S(0.298) * t136 + t138;
    const S t18 = w[11];
    const S t140 = S(0.9286646355765102) * t14 - S(0.3709204694129827) * t137;
    const S t141 = t8 * t135 - t7 * t134;
    const S t142 = t7 * t18 - t8 * t140 - S(0.782) * t141 + S(0.06165732843631448) * t10;
    const S t143 = S(0.8472551110134161) * t139 - S(0.5311861979208834) * t142;
    M[23] = t143;
    M[33] = t143;
    const S t144 = S(0.8472551110134161) * t136 - S(0.10990443579209751) * t10;
    const S t145 = t5 * t141 + t6 * t144;
    const S t146 = t143 + S(0.29) * t145;
    const S t147 = t6 * t141 - t5 * t144;
    const S t148 = t8 * t18 + t7 * t140 + S(0.782) * t136;
    const S t149 = S(0.8472551110134161) * t142 + S(0.5311861979208834) * t139;
    const S t150 = S(0.5311861979208834) * t136 + S(0.17530029076879292) * t10;
    const S t151 = S(0.548) * t147 - (t5 * t148 + t6 * t149) - S(0.29) * t150;
    const S t152 = S(0.805664471353141) * t146 + S(0.5923721462047856) * t151;
    M[17] = t152;
    M[32] = t152;
    const S t153 = S(0.548) * t145 - (t5 * t149 - t6 * t148);
    const S t154 = S(0.805664471353141) * t151 - S(0.5923721462047856) * t146;
    const S t155 = t3 * t153 - t4 * t154;
    const S t156 = S(0.5923721462047856) * t150 - S(0.805664471353141) * t145;
    const S t157 = t3 * t147 - t4 * t156;
    const S t158 = t3 * t156 + t4 * t147;
    const S t159 = S(0.805664471353141) * t150 + S(0.5923721462047856) * t145;
    const S t160 = t95 * t152 - (t97 * t155 + t98 * (t3 * t154 + t4 * t153)) - (t102 * t157 + t104 * t158 + t111 * t159);
    M[5] = t160;
    M[30] = t160;
    const S t80 = w[17];
    const S t69 = w[15];
    const S t96 = w[19];
    const S t72 = w[16];
    const S t161 = S(0.6749571397620882) * t80 - S(0.18413450969210635) * t69 + (S(0.8044781165221552) * t96 - S(0.5939822893293754) * t72);
    M[8] = t161;
    M[13] = t161;
    const S t113 = w[28];
    const S t114 = w[29];
    const S t57 = w[14];
    const S t110 = w[26];
    const S t108 = w[25];
    const S t162 = S(0.6749571397620882) * t113 - S(0.18413450969210635) * t114 - S(0.29520933480810846) * t57 - (S(0.5939822893293754) * t110 + S(-0.8044781165221552) * t108);
    M[9] = t162;
    M[19] = t162;
    const S t163 = S(0.4983511407473459) * t132 + (S(0.18413450969210635) * t130 + S(0.6749571397620882) * t131) + (S(0.5939822893293754) * t127 + S(0.8044781165221552) * t128);
    M[10] = t163;
    M[25] = t163;
    const S t164 = S(0.6749571397620882) * t157 + S(0.18413450969210635) * t158 - S(0.4983511407473459) * t159 + (S(0.8044781165221552) * t152 - S(0.5939822893293754) * t155);
    M[11] = t164;
    M[31] = t164;
    const S qd0 = qd[0];  // d(q1)
    const S qd1 = qd[1];  // d(q2)
    const S t165 = qd1 + S(0.588171730331375) * qd0;
    const S t2 = w[1];
    const S t166 = t2 * qd0;
    const S t167 = S(0.8044781165221552) * t165 - S(0.48037489671056854) * t166;
    const S t1 = w[0];
    const S t168 = t1 * qd0;
    const S t169 = S(0.8087360605531302) * t168;
    const S t170 = t167 * t169;
    const S t171 = qd1 * t168;
    w[34] = t171;
    const S t172 = S(0.6506104627573298) * t171;
    const S t173 = t170 + t172;
    w[35] = t173;
    const S t174 = qd0 * qd0;
    const S t175 = S(5.769964674550788) - S(0.31721619758491315) * t174;
    const S t176 = S(0.23070270873670343) * t174 + S(7.933700754026208);
    const S t177 = t2 * t176 + t1 * (S(0.381) * t174);
    const S t178 = S(1.042912147352232) * t173 + (t175 - S(0.7383448687171558) * t177);
    w[36] = t178;
    const S t179 = S(0.6506104627573298) * t166 + S(0.5939822893293754) * t165;
    const S t180 = t179 * t179;
    w[37] = t180;
    const S t181 = t168 * (S(0.6540540156389962) * t168);
    w[38] = t181;
    const S t182 = t178 - S(0.38534298650678417) * (t180 + t181);
    w[39] = t182;
    const S t100 = w[22];
    const S t183 = t167 * t167;
    w[40] = t183;
    const S t184 = t1 * t176 - t100 * t174 - S(0.839) * (t180 + t183);
    w[41] = t184;
    const S t185 = t170 - t172;
    w[42] = t185;
    const S t186 = t184 + S(0.31) * t185;
    w[43] = t186;
    const S t187 = S(0.8044781165221552) * t4;
    w[44] = t187;
    const S t188 = S(0.8087360605531302) * (qd1 * t166);
    w[45] = t188;
    const S t189 = t167 * t179;
    w[46] = t189;
    const S t190 = t188 - t189;
    w[47] = t190;
    const S t191 = t168 * t179;
    w[48] = t191;
    const S t192 = S(0.48037489671056854) * t171 + S(0.8087360605531302) * t191;
    w[49] = t192;
    const S t193 = t177 + S(0.7383448687171558) * t175 + S(1.042912147352232) * t192;
    w[50] = t193;
    const S t194 = S(0.38534298650678417) * t190 - t193;
    w[51] = t194;
    const S t195 = t3 * t186 + t187 * t194;
    const S t196 = t4 * t169 + t3 * t179;
    const S qd2 = qd[2];  // d(q3)
    const S t197 = t167 + qd2;
    const S t198 = t4 * t179 - t3 * t169;
    const S t199 = S(0.5923721462047856) * t197 + S(0.805664471353141) * t198;
    const S t200 = t196 * t199;
    w[52] = t200;
    const S t201 = t3 * t188 + t4 * t172 + t196 * qd2;
    const S t202 = S(0.3870209872096399) * t171 + S(0.5923721462047856) * t201;
    w[53] = t202;
    const S t203 = t200 + t202;
    w[54] = t203;
    const S t204 = S(0.5914998680016632) * t182 - t195 + S(0.35995133248576183) * t203;
    w[55] = t204;
    const S t205 = qd2 * t198 + (t4 * t188 - t3 * t172);
    w[56] = t205;
    const S t206 = S(0.805664471353141) * t197 - S(0.5923721462047856) * t198;
    const S t207 = t199 * t206;
    w[57] = t207;
    const S t208 = t205 - t207;
    w[58] = t208;
    const S t209 = t204 - S(0.6801838972489569) * t208;
    w[59] = t209;
    const S t210 = t196 * t206;
    const S t211 = S(0.805664471353141) * t201 - S(0.2845607085473417) * t171;
    w[60] = t211;
    const S t212 = t210 + t211;
    w[61] = t212;
    const S t213 = S(0.4474345853456771) * t212 + (t182 + S(0.9139578814050588) * t195);
    w[62] = t213;
    const S t214 = t196 * t196;
    w[63] = t214;
    const S t215 = t199 * t199;
    w[64] = t215;
    const S t216 = t213 - S(0.8454970785152796) * (t214 + t215);
    w[65] = t216;
    const S t217 = t210 - t211;
    w[66] = t217;
    const S t218 = S(0.8044781165221552) * t3;
    w[67] = t218;
    const S t219 = t206 * t206;
    w[68] = t219;
    const S t220 = t4 * t186 - t194 * t218 - S(0.29) * (t215 + t219);
    w[69] = t220;
    const S t221 = S(0.548) * t217 + t220;
    w[70] = t221;
    const S t222 = S(0.805664471353141) * t209;
    w[71] = t222;
    const S t223 = t5 * t221 - t6 * t222;
    w[72] = t223;
    const S t224 = t6 * t196 + t5 * t199;
    w[73] = t224;
    const S qd3 = qd[3];  // d(q4)
    const S t225 = t206 + qd3;
    const S t226 = t5 * t196 - t6 * t199;
    w[74] = t226;
    const S t227 = S(0.8472551110134161) * t225 + S(0.5311861979208834) * t226;
    w[75] = t227;
    const S t228 = t224 * t227;
    w[76] = t228;
    const S t229 = t224 * qd3 + (t6 * t211 + t5 * t205);
    w[77] = t229;
    const S t230 = S(0.5311861979208834) * t202 - S(0.8472551110134161) * t229;
    w[78] = t230;
    const S t231 = t228 - t230;
    w[79] = t231;
    const S t232 = t216 + S(0.9673065698240312) * t223 + S(0.5426672585542128) * t231;
    w[80] = t232;
    const S qd4 = qd[4];  // d(q5)
    const S t233 = t227 + qd4;
    w[81] = t233;
    const S t234 = S(0.5311861979208834) * t225 - S(0.8472551110134161) * t226;
    w[82] = t234;
    const S t235 = t8 * t234 - t7 * t224;
    w[83] = t235;
    const S t236 = S(0.9286646355765102) * t233 - S(0.3709204694129827) * t235;
    w[84] = t236;
    const S qd5 = qd[5];  // d(q6)
    const S t237 = qd5 + t236;
    w[85] = t237;
  }
}

template <class S>
ALEMBERT_NOINLINE void mass_matrix_and_bias_packs_block3(int packs, [[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] S* ALEMBERT_RESTRICT M,
    [[maybe_unused]] S* ALEMBERT_RESTRICT c, [[maybe_unused]] const Inputs<S>* ALEMBERT_RESTRICT inputs,
    [[maybe_unused]] S* ALEMBERT_RESTRICT w) {
  for (; packs > 0; --packs, q += 6, qd += 6, M += 36, c += 6, ++inputs, w += 86) {
    [[maybe_unused]] const Inputs<S>& in = *inputs;
    const S t178 = w[36];
    const S t182 = w[39];
    const S t209 = w[59];
    const S t232 = w[80];
    const S t235 = w[83];
    const S t233 = w[81];
    const S t238 = S(0.9286646355765102) * t235 + S(0.3709204694129827) * t233;
    const S t9 = w[8];
    const S t8 = w[7];
    const S t224 = w[73];
    const S t7 = w[6];
    const S t234 = w[82];
    const S t239 = t8 * t224 + t7 * t234;
    const S t10 = w[9];
    const S t240 = t9 * t238 - t10 * t239;
    const S t237 = w[85];
    const S t241 = t237 * t240;
    const S qd5 = qd[5];  // d(q6)
    const S t229 = w[77];
    const S t202 = w[53];
    const S t242 = S(0.5311861979208834) * t229 + S(0.8472551110134161) * t202;
    const S qd4 = qd[4];  // d(q5)
    const S t230 = w[78];
    const S qd3 = qd[3];  // d(q4)
    const S t226 = w[74];
    const S t5 = w[4];
    const S t211 = w[60];
    const S t6 = w[5];
    const S t205 = w[56];
    const S t243 = qd3 * t226 + (t5 * t211 - t6 * t205);
    const S t244 = qd4 * t239 - (t8 * t230 + t7 * t243);
    const S t245 = S(0.3709204694129827) * t242 - S(0.9286646355765102) * t244;
    const S t246 = qd4 * t235 + (t7 * t230 - t8 * t243);
    const S t247 = qd5 * t240 + (t10 * t245 + t9 * t246);
    const S t248 = t241 + t247;
    const S t236 = w[84];
    const S t249 = t236 * t239;
    const S t250 = t245 - t249;
    const S t222 = w[71];
    const S t221 = w[70];
    const S t251 = t234 * t234;
    const S t227 = w[75];
    const S t252 = t227 * t227;
    const S t253 = t5 * t222 + t6 * t221 - S(0.298) * (t251 + t252);
    const S t228 = w[76];
    const S t254 = t228 + t230;
    const S t255 = t253 + S(0.782) * t254;
    const S t256 = t227 * t234;
    const S t257 = t243 + t256;
    const S t258 = t224 * t234;
    const S t259 = t242 + t258;
    const S t216 = w[65];
    const S t223 = w[72];
    const S t260 = S(0.3517240511462447) * t259 - (t223 - S(0.4063507183397911) * t216);
    const S t261 = S(0.9229805637461859) * t257 + t260;
    const S t262 = S(0.8472551110134161) * t8;
    const S t263 = t7 * t255 - t261 * t262;
    const S t264 = t224 * t224;
    const S t265 = t232 - S(1.4240462959375653) * (t251 + t264);
    const S t266 = S(1.0216359604847038) * t250 - (S(0.7273429751097309) * t263 + t265);
    const S t267 = S(0.28446522999390667) * t248 + S(0.6062176771268533) * t266;
    const S t268 = t238 * t238;
    const S t269 = t239 * t239;
    const S t270 = t267 - S(1.4974860994599004) * (t268 + t269);
    const S t271 = t263 - S(0.21933328225876517) * t265;
    const S t272 = S(0.9286646355765102) * t242 + S(0.3709204694129827) * t244;
    const S t273 = t238 * t239;
    const S t274 = t272 + t273;
    const S t275 = t271 - S(0.5610206096375856) * t274;
    const S t276 = t237 * t237;
    const S t277 = t9 * t239 + t10 * t238;
    const S t278 = t277 * t277;
    const S t279 = t276 + t278;
    const S t280 = S(0.9286646355765102) * t9;
    const S t281 = S(0.9286646355765102) * t10;
    const S t282 = t240 * t277;
    const S t283 = t272 - t282;
    const S t284 = S(2.0103112683343562) * t275 - S(0.5578117245092649) * (t279 * t280 + t281 * t283);
    const S t285 = t236 * t238;
    const S t286 = t246 - t285;
    const S t287 = t284 - S(2.726968712472971) * t286;
    const S t288 = S(1.6517220172784755) * t232 + (t270 + S(0.21933328225876517) * t287 - S(2.5768019186113977) * t265);
    const S t289 = t287 - S(0.7273429751097309) * t270;
    const S t290 = S(0.8472551110134161) * t7;
    const S t291 = t245 + t249;
    const S t292 = t236 * t236;
    const S t293 = t8 * t255 + t261 * t290;
    const S t294 = S(0.521) * (t268 + t292) - t293;
    const S t295 = S(2.936440786054142) * t291 + (S(2.3310172744721687) * t294 - S(0.5578117245092649) * (t9 * t283 - t10 * t279));
    const S t296 = S(6.134005213997661) * t261 - (t262 * t289 + t290 * t295);
    const S t297 = S(3.931878268516937) * t260 - t296;
    const S t298 = S(0.9673065698240312) * t288 - t297;
    const S t299 = t7 * t289 - t8 * t295 + S(8.545072386871544) * t255;
    const S t300 = t299 - S(5.477364829128948) * t253;
    const S t301 = S(1.1909033187725369) * t209 - S(0.805664471353141) * (t6 * t298 + t5 * t300);
    const S t204 = w[55];
    const S t302 = t301 - S(5.320782526463204) * t204;
    const S t213 = w[62];
    const S t303 = S(0.7707348119519144) * t216 + (t288 + S(0.4063507183397911) * t297) - S(3.4435308520237036) * t213;
    const S t304 = S(3.471839671679194) * t178 - (S(3.4249850813773137) * t182 - (S(0.5914998680016632) * t302 + t303));
    const S t173 = w[35];
    const S t185 = w[42];
    const S t188 = w[45];
    const S t189 = w[46];
    const S t305 = t188 + t189;
    const S t181 = w[38];
    const S t183 = w[40];
    const S t212 = w[61];
    const S t217 = w[66];
    const S t214 = w[63];
    const S t219 = w[68];
    const S t207 = w[57];
    const S t306 = t205 + t207;
    const S t307 = S(1.8347127580804645) * t221 + (t5 * t298 - t6 * t300);
    const S t308 = t240 * t240;
    const S t309 = t237 * t277;
    const S t310 = t10 * t246 - t9 * t245 + qd5 * t277;
    const S t311 = t272 + t282;
    const S t312 = S(0.28446522999390667) * (t9 * t294 + t275 * t281);
    const S t313 = S(0.007799848827756481) * (t278 - t308) + (S(0.002412705769599087) * (t241 - t247) - S(0.06340355585360308) * (t309 - t310)) - S(0.15119204837669592) * t283 - S(0.027700080589956953) * t311 + t312;
    const S t314 = S(0.2861016535503581) * t284 + t313 + (S(0.22450019424978354) * t273 - (S(0.010388859360985173) * (t268 - t269) - S(0.05851404887456145) * t286 + S(0.24829267605364228) * t272));
    const S t315 = t246 + t285;
    const S t316 = t309 + t310;
    const S t317 = S(0.015294829268292676) * t316 + S(0.00473110744009856) * t311 - S(0.12432889190526168) * (t276 - t308) + S(0.2964745365853657) * t248 + S(0.28446522999390667) * t266;
    const S t318 = S(0.054317463414634115) * t316 + (S(0.015294829268292676) * t248 - S(0.12432889190526168) * t283 - S(0.00473110744009856) * (t276 - t278));
    const S t319 = S(0.1702899688739026) * t291 - (S(0.018918435667554002) * t315 - S(0.10655590097203183) * (t269 - t292)) + S(0.021663424286411097) * t250 - S(2.726968712472971) * t293 + (t281 * t317 - t280 * t318 + S(0.9487571869353855) * t267);
    const S t320 = t314 - S(0.21933328225876517) * t319;
    const S t321 = t320 - (S(0.03891837436335415) * (t251 - t264) - S(0.045598471493577875) * t257 + S(0.18082974846630914) * t242 + S(0.0655458393224338) * t258) + S(0.19314555206597184) * t297;
    const S t322 = t243 - t256;
    const S t231 = w[79];
    const S t323 = t319 + S(0.7273429751097309) * t314;
    const S t324 = t9 * t317 + t10 * t318 + (S(0.18337079108023474) * t286 + (S(0.4635529732847989) * t315 - (S(0.020371655108638375) * t250 + S(0.11474099140846737) * t274)) - S(2.726968712472971) * t271);
    const S t325 = S(0.07035287305215757) * (t252 - t264) + S(0.0600462989503283) * t322 + S(2.039139880011506) * t254 - S(0.19006372234750632) * t231 + (t262 * t323 + t290 * t324 + S(0.6625534968124914) * t299) + S(0.4597776083896958) * t288;
    const S t326 = S(0.9673065698240312) * t321 + t325;
    const S t327 = S(0.10496779015187885) * t322 - (S(0.08303623328752484) * t259 + S(0.07087156886962401) * t231) + S(2.4067601995017256) * t257 - (t8 * t324 - t7 * t323 - S(0.9229805637461859) * t296);
    const S t328 = S(0.016333380847347253) * t212 - (S(1.0909993302220828) * t217 + (S(0.24473919379251827) * (t214 - t219) - (S(0.11828718303696069) * t306 + (S(0.44150413030152125) * t307 - S(0.805664471353141) * (t6 * t326 - t5 * t327)))));
    const S t329 = S(0.3604821486676368) * t303 - t328;
    const S t208 = w[58];
    const S t215 = w[64];
    const S t200 = w[52];
    const S t330 = t321 - S(0.4063507183397911) * t325;
    const S t331 = S(0.19688732566135583) * t208 + S(0.09515945021828555) * (t214 - t215) - S(0.25981813514630525) * t202 + S(0.2335384402252793) * t200 + t330 + S(0.233298653791425) * t302;
    const S t332 = t329 + S(0.9139578814050588) * t331;
    const S t187 = w[44];
    const S t203 = w[54];
    const S t333 = S(0.14681941086255584) * t212 - S(0.30377309971416566) * t203 + S(0.3805944736706004) * t306 + S(1.354160905705215) * t208 + (S(0.6801838972489569) * t301 - (t6 * t327 + t5 * t326));
    const S t218 = w[67];
    const S t220 = w[69];
    const S t334 = t307 - S(8.197229305176045) * t220;
    const S t4 = w[3];
    const S t335 = t302 - S(0.9139578814050588) * t303;
    const S t3 = w[2];
    const S t186 = w[43];
    const S t336 = t4 * t334 - t3 * t335 - S(5.292126470619502) * t186;
    const S t337 = S(0.839) * t304 - (S(0.46999542314703946) * t173 - (S(0.0034811001465595076) * t185 - (S(0.062257240931197284) * t305 + S(0.07388032527886275) * (t181 - t183))) - (t187 * t332 + t218 * t333 - S(0.2493882161218681) * t336));
    const S t338 = t331 - S(0.5914998680016632) * t329;
    const S t171 = w[34];
    const S t180 = w[37];
    const S t190 = w[47];
    const S t191 = w[48];
    const S t194 = w[51];
    const S t339 = S(3.4249850813773137) * t194 + (t218 * t334 + t187 * t335);
    const S t193 = w[50];
    const S t340 = t339 + S(3.471839671679194) * t193;
    const S t341 = t338 - (S(0.29633358899945267) * t171 + (S(0.062257240931197506) * (t180 - t181) + S(0.07388032527886275) * t190) + S(0.2613115230644122) * t191) + S(0.839) * t340;
    const S t342 = S(0.7383448687171558) * t337 - t341;
    c[1] = t342;
    const S t343 = t340 - S(0.7383448687171558) * t304;
    const S t2 = w[1];
    const S t184 = w[41];
    const S t344 = t336 + S(5.3645239881896805) * t184;
    const S t1 = w[0];
    const S t192 = w[49];
    const S t345 = t1 * (S(0.004327153312272403) * t190 + (S(0.07738835855516146) * t173 + S(0.09183633931306323) * t192 + S(0.18258348232840138) * t305) - (t3 * t332 - t4 * t333 - S(0.38534298650678417) * t339));
    const S t346 = S(0.8087360605531302) * (S(0.381) * (t304 + S(0.7383448687171558) * t340) - (S(0.485) * (t2 * t344 - t1 * t343) - (t2 * (t337 + S(0.7383448687171558) * t341) + t345)));
    c[0] = S(0.588171730331375) * (t342 - S(0.381) * (t2 * t343 + t1 * t344)) + t346;
    c[2] = S(-1.2430418919573683) * t338;
    c[3] = S(-1.5428778805023349) * t330;
    c[4] = S(-1.8210310689738687) * t320;
    c[5] = S(-1.9609135517940572) * t313;
    M[35] = S(0.3507919999999998);
  }
}

/// All blocks; a pack has 86 values in w.
template <class S>
void mass_matrix_and_bias_packs(int packs, [[maybe_unused]] const S* ALEMBERT_RESTRICT q,
    [[maybe_unused]] const S* ALEMBERT_RESTRICT qd, [[maybe_unused]] S* ALEMBERT_RESTRICT M,
    [[maybe_unused]] S* ALEMBERT_RESTRICT c, [[maybe_unused]] const Inputs<S>* ALEMBERT_RESTRICT inputs,
    [[maybe_unused]] S* ALEMBERT_RESTRICT w) {
  mass_matrix_and_bias_packs_block1<S>(packs, q, qd, M, c, inputs, w);
  mass_matrix_and_bias_packs_block2<S>(packs, q, qd, M, c, inputs, w);
  mass_matrix_and_bias_packs_block3<S>(packs, q, qd, M, c, inputs, w);
}

}  // namespace alembert::mechanisms::chain6r::detail

//! A machine with 255 states.

use bica::prelude::*;

struct Patient;

/// A machine whose states follow each other.
macro_rules! machine {
    ($first:ident $(($from:ident $to:ident $transition:ident))*) => {
        #[component]
        impl Patient {
            const fn new() -> Self {
                Self
            }

            #[state(initial)]
            fn $first(&mut self) {}

            $(
                #[state]
                fn $to(&mut self) {}

                #[transition($from -> $to)]
                fn $transition(&self) -> bool {
                    true
                }
            )*

            #[transition(* -> $first, after_ms = 1000)]
            fn again(&self) -> bool {
                true
            }
        }
    };
}

machine! {
    s0
    (s0 s1 t0) (s1 s2 t1) (s2 s3 t2) (s3 s4 t3) (s4 s5 t4) (s5 s6 t5) (s6 s7 t6) (s7 s8 t7) (s8 s9 t8)
    (s9 s10 t9) (s10 s11 t10) (s11 s12 t11) (s12 s13 t12) (s13 s14 t13) (s14 s15 t14) (s15 s16 t15) (s16 s17 t16)
    (s17 s18 t17) (s18 s19 t18) (s19 s20 t19) (s20 s21 t20) (s21 s22 t21) (s22 s23 t22) (s23 s24 t23)
    (s24 s25 t24) (s25 s26 t25) (s26 s27 t26) (s27 s28 t27) (s28 s29 t28) (s29 s30 t29) (s30 s31 t30)
    (s31 s32 t31) (s32 s33 t32) (s33 s34 t33) (s34 s35 t34) (s35 s36 t35) (s36 s37 t36) (s37 s38 t37)
    (s38 s39 t38) (s39 s40 t39) (s40 s41 t40) (s41 s42 t41) (s42 s43 t42) (s43 s44 t43) (s44 s45 t44)
    (s45 s46 t45) (s46 s47 t46) (s47 s48 t47) (s48 s49 t48) (s49 s50 t49) (s50 s51 t50) (s51 s52 t51)
    (s52 s53 t52) (s53 s54 t53) (s54 s55 t54) (s55 s56 t55) (s56 s57 t56) (s57 s58 t57) (s58 s59 t58)
    (s59 s60 t59) (s60 s61 t60) (s61 s62 t61) (s62 s63 t62) (s63 s64 t63) (s64 s65 t64) (s65 s66 t65)
    (s66 s67 t66) (s67 s68 t67) (s68 s69 t68) (s69 s70 t69) (s70 s71 t70) (s71 s72 t71) (s72 s73 t72)
    (s73 s74 t73) (s74 s75 t74) (s75 s76 t75) (s76 s77 t76) (s77 s78 t77) (s78 s79 t78) (s79 s80 t79)
    (s80 s81 t80) (s81 s82 t81) (s82 s83 t82) (s83 s84 t83) (s84 s85 t84) (s85 s86 t85) (s86 s87 t86)
    (s87 s88 t87) (s88 s89 t88) (s89 s90 t89) (s90 s91 t90) (s91 s92 t91) (s92 s93 t92) (s93 s94 t93)
    (s94 s95 t94) (s95 s96 t95) (s96 s97 t96) (s97 s98 t97) (s98 s99 t98) (s99 s100 t99) (s100 s101 t100)
    (s101 s102 t101) (s102 s103 t102) (s103 s104 t103) (s104 s105 t104) (s105 s106 t105) (s106 s107 t106)
    (s107 s108 t107) (s108 s109 t108) (s109 s110 t109) (s110 s111 t110) (s111 s112 t111) (s112 s113 t112)
    (s113 s114 t113) (s114 s115 t114) (s115 s116 t115) (s116 s117 t116) (s117 s118 t117) (s118 s119 t118)
    (s119 s120 t119) (s120 s121 t120) (s121 s122 t121) (s122 s123 t122) (s123 s124 t123) (s124 s125 t124)
    (s125 s126 t125) (s126 s127 t126) (s127 s128 t127) (s128 s129 t128) (s129 s130 t129) (s130 s131 t130)
    (s131 s132 t131) (s132 s133 t132) (s133 s134 t133) (s134 s135 t134) (s135 s136 t135) (s136 s137 t136)
    (s137 s138 t137) (s138 s139 t138) (s139 s140 t139) (s140 s141 t140) (s141 s142 t141) (s142 s143 t142)
    (s143 s144 t143) (s144 s145 t144) (s145 s146 t145) (s146 s147 t146) (s147 s148 t147) (s148 s149 t148)
    (s149 s150 t149) (s150 s151 t150) (s151 s152 t151) (s152 s153 t152) (s153 s154 t153) (s154 s155 t154)
    (s155 s156 t155) (s156 s157 t156) (s157 s158 t157) (s158 s159 t158) (s159 s160 t159) (s160 s161 t160)
    (s161 s162 t161) (s162 s163 t162) (s163 s164 t163) (s164 s165 t164) (s165 s166 t165) (s166 s167 t166)
    (s167 s168 t167) (s168 s169 t168) (s169 s170 t169) (s170 s171 t170) (s171 s172 t171) (s172 s173 t172)
    (s173 s174 t173) (s174 s175 t174) (s175 s176 t175) (s176 s177 t176) (s177 s178 t177) (s178 s179 t178)
    (s179 s180 t179) (s180 s181 t180) (s181 s182 t181) (s182 s183 t182) (s183 s184 t183) (s184 s185 t184)
    (s185 s186 t185) (s186 s187 t186) (s187 s188 t187) (s188 s189 t188) (s189 s190 t189) (s190 s191 t190)
    (s191 s192 t191) (s192 s193 t192) (s193 s194 t193) (s194 s195 t194) (s195 s196 t195) (s196 s197 t196)
    (s197 s198 t197) (s198 s199 t198) (s199 s200 t199) (s200 s201 t200) (s201 s202 t201) (s202 s203 t202)
    (s203 s204 t203) (s204 s205 t204) (s205 s206 t205) (s206 s207 t206) (s207 s208 t207) (s208 s209 t208)
    (s209 s210 t209) (s210 s211 t210) (s211 s212 t211) (s212 s213 t212) (s213 s214 t213) (s214 s215 t214)
    (s215 s216 t215) (s216 s217 t216) (s217 s218 t217) (s218 s219 t218) (s219 s220 t219) (s220 s221 t220)
    (s221 s222 t221) (s222 s223 t222) (s223 s224 t223) (s224 s225 t224) (s225 s226 t225) (s226 s227 t226)
    (s227 s228 t227) (s228 s229 t228) (s229 s230 t229) (s230 s231 t230) (s231 s232 t231) (s232 s233 t232)
    (s233 s234 t233) (s234 s235 t234) (s235 s236 t235) (s236 s237 t236) (s237 s238 t237) (s238 s239 t238)
    (s239 s240 t239) (s240 s241 t240) (s241 s242 t241) (s242 s243 t242) (s243 s244 t243) (s244 s245 t244)
    (s245 s246 t245) (s246 s247 t246) (s247 s248 t247) (s248 s249 t248) (s249 s250 t249) (s250 s251 t250)
    (s251 s252 t251) (s252 s253 t252) (s253 s254 t253)
}

activation_tree! {
    struct Waiting { root: Patient, cycle_hz: 100, components: [Patient] }
}

fn main() {
    let mut tree = Waiting::new();
    for n in 0..254 {
        tree.tick(Instant::from_ticks(n));
    }
    assert_eq!(tree.of::<Patient>().state_name(), Some("s254"));
    tree.tick(Instant::from_secs(2));
    assert_eq!(tree.of::<Patient>().state_name(), Some("s0"));
}

//! Latent components: ten active ones alone, and the same with ninety latent ones.

/// Root: a state machine whose first state requires nine components. Its second state is never entered, so what that
/// requires is latent.
macro_rules! root {
    ($later:ident) => {
        #[doc = "Root of the tree."]
        pub struct Root {
            own: u64,
        }

        #[component]
        impl Root {
            const fn new() -> Self {
                Self { own: 1 }
            }

            #[state(initial)]
            fn now(&mut self, a: &A, b: &B, c: &C, d: &D, e: &E, f: &F, g: &G, h: &H, i: &I) {
                self.own = mix(0, [a.own, b.own, c.own, d.own, e.own, f.own, g.own, h.own, i.own]);
            }

            #[state]
            fn later(&mut self, next: &$later) {
                self.own = mix(1, [next.own]);
            }

            #[transition(now -> later)]
            fn overflow(&self) -> bool {
                self.own == 0
            }

            #[transition(later -> now)]
            fn back(&self) -> bool {
                self.own != 0
            }
        }
    };
}

mod ten {
    use bica::prelude::*;

    use crate::framework::{leaves, simple, tree};
    use crate::part::mix;

    root!(A);
    leaves!(A B C D E F G H I);
    tree! {
        /// Ten components, all active.
        Active: Root A B C D E F G H I
    }
}

mod hundred {
    use bica::prelude::*;

    use crate::framework::{leaves, links, simple, tree};
    use crate::part::mix;

    root!(L10);
    leaves!(A B C D E F G H I);
    links! {
        L10 L11 L12 L13 L14 L15 L16 L17 L18 L19 L20 L21 L22 L23 L24 L25 L26 L27 L28 L29 L30 L31 L32 L33 L34
        L35 L36 L37 L38 L39 L40 L41 L42 L43 L44 L45 L46 L47 L48 L49 L50 L51 L52 L53 L54 L55 L56 L57 L58 L59
        L60 L61 L62 L63 L64 L65 L66 L67 L68 L69 L70 L71 L72 L73 L74 L75 L76 L77 L78 L79 L80 L81 L82 L83 L84
        L85 L86 L87 L88 L89 L90 L91 L92 L93 L94 L95 L96 L97 L98 L99
    }
    tree! {
        /// A hundred components, ten of them active.
        Latent: Root A B C D E F G H I
        L10 L11 L12 L13 L14 L15 L16 L17 L18 L19 L20 L21 L22 L23 L24 L25 L26 L27 L28 L29 L30 L31 L32 L33 L34
        L35 L36 L37 L38 L39 L40 L41 L42 L43 L44 L45 L46 L47 L48 L49 L50 L51 L52 L53 L54 L55 L56 L57 L58 L59
        L60 L61 L62 L63 L64 L65 L66 L67 L68 L69 L70 L71 L72 L73 L74 L75 L76 L77 L78 L79 L80 L81 L82 L83 L84
        L85 L86 L87 L88 L89 L90 L91 L92 L93 L94 L95 L96 L97 L98 L99
    }
}

pub use hundred::Latent;
pub use ten::Active;

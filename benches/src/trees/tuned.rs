//! Ten controllers in a chain, each with three numbers: constants, parameters of an untunable tree, or of a tunable one.

/// The controllers: the argument of their parameters if they have some, then gain, damping and limit.
macro_rules! ten {
    ([$($tuned:ident: $params:ty)?] $gain:expr, $damping:expr, $limit:expr) => {
        /// The position to go to.
        pub struct Wanted {
            /// Position.
            pub at: f32,
        }

        #[component]
        impl Wanted {
            const fn new() -> Self {
                Self { at: 0.5 }
            }
        }

        macro_rules! controller {
            ($name:ident $child:ident) => {
                /// Follows the controller that it requires.
                pub struct $name {
                    /// Position.
                    pub at: f32,
                    speed: f32,
                }

                #[component]
                impl $name {
                    const fn new() -> Self {
                        Self { at: 1.0, speed: 0.0 }
                    }

                    fn step(&mut self, $($tuned: &Tuned<$params>,)? wanted: &$child) {
                        let force = $gain * (wanted.at - self.at) - $damping * self.speed;
                        self.speed = (self.speed + force).clamp(-$limit, $limit);
                        self.at += self.speed;
                    }
                }
            };
        }

        controller!(A Wanted);
        controller!(B A);
        controller!(C B);
        controller!(D C);
        controller!(E D);
        controller!(F E);
        controller!(G F);
        controller!(H G);
        controller!(I H);
        controller!(J I);
    };
}

mod constants {
    use bica::prelude::*;

    const GAIN: f32 = 0.7;
    const DAMPING: f32 = 0.3;
    const LIMIT: f32 = 2.0;

    ten!([] GAIN, DAMPING, LIMIT);

    activation_tree! {
        /// Numbers are constants.
        pub struct Constants { root: J, cycle_hz: 1000, components: [A, B, C, D, E, F, G, H, I, J, Wanted] }
    }
}

mod params {
    use bica::prelude::*;

    /// How to follow.
    #[derive(Params)]
    pub struct Following {
        /// Part of the distance that becomes speed in a run.
        #[param(default = 0.7, range = 0.0..=1.0)]
        gain: f32,
        /// Part of the speed that is lost in a run.
        #[param(default = 0.3, range = 0.0..=1.0)]
        damping: f32,
        /// Highest speed.
        #[param(default = 2.0, range = 0.1..=9.0)]
        limit: f32,
    }

    ten!([tuned: Following] tuned.gain, tuned.damping, tuned.limit);

    activation_tree! {
        /// Numbers are parameters that cannot be changed.
        pub struct TunedOff { root: J, cycle_hz: 1000, components: [A, B, C, D, E, F, G, H, I, J, Wanted] }
    }

    activation_tree! {
        /// Numbers are parameters.
        pub struct TunedOn { root: J, cycle_hz: 1000, tunable, components: [A, B, C, D, E, F, G, H, I, J, Wanted] }
    }
}

pub use constants::Constants;
pub use params::{TunedOff, TunedOn};

//! Ten controllers in a chain, each with three numbers: constants, parameters of an untunable tree, or of a tunable one.

macro_rules! ten {
    () => {
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

                fn step(&mut self, wanted: &$child) {
                    let force = GAIN * (wanted.at - self.at) - DAMPING * self.speed;
                    self.speed = (self.speed + force).clamp(-LIMIT, LIMIT);
                    self.at += self.speed;
                }
            }
        };
    }

    ten!();

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

                fn step(&mut self, tuned: &Tuned<Following>, wanted: &$child) {
                    let force = tuned.gain * (wanted.at - self.at) - tuned.damping * self.speed;
                    self.speed = (self.speed + force).clamp(-tuned.limit, tuned.limit);
                    self.at += self.speed;
                }
            }
        };
    }

    ten!();

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

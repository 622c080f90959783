//! Components and trees in unusual places: in functions, in macros, beside other items.

/// Everything in the body of a function.
#[test]
fn a_tree_can_stand_in_a_function() {
    use bica::prelude::*;

    enum Light {
        On,
        Off,
    }

    #[component]
    impl Light {
        const fn new() -> Self {
            Self::Off
        }

        fn step(&mut self) {
            *self = Self::On;
        }
    }

    activation_tree! {
        struct Robot { root: Light, cycle_hz: 10, components: [Light] }
    }
    let mut robot = Robot::new();
    robot.tick(Instant::from_millis(0));
    assert!(matches!(robot.get::<Light>(), Light::On));
}

mod made {
    use bica::prelude::*;

    macro_rules! made {
        ($name:ident, $tree:ident, $child:ty, $hz:expr, $argument:ident: $link:ty) => {
            pub(super) struct $name {
                pub(super) runs: u32,
            }

            #[component(hz = $hz)]
            impl $name {
                const fn new() -> Self {
                    Self { runs: 0 }
                }

                fn step(&mut self, $argument: $link, own: &mut $child) {
                    self.runs += 1;
                }
            }

            activation_tree! {
                pub(super) struct $tree {
                    root: $name,
                    cycle_hz: $hz,
                    components: [$name, $child, Eye<{ WIDTH * 2 }>],
                }
            }
        };
    }

    const WIDTH: usize = 2;

    pub(super) struct Eye<const W: usize>;

    #[component]
    impl<const W: usize> Eye<W> {
        #![doc = "An inner attribute belongs to the block."]

        /// A constant of the block.
        const PIXELS: usize = W * W;

        helpers!();

        const fn new() -> Eye<W> {
            assert!(Self::PIXELS > 0);
            Eye
        }

        #[cfg(not(doctest))]
        #[expect(dead_code, reason = "the tree does not call it, so it may stand under a condition")]
        fn pixels(&self) -> usize {
            Self::PIXELS
        }
    }

    macro_rules! helpers {
        () => {
            #[expect(dead_code, reason = "a macro can stand between functions")]
            fn help(&self) {}
        };
    }
    use helpers;

    made!(Player, Robot, Eye<3>, 50, eye: &Eye<{ WIDTH * 2 }>);
}

#[test]
fn macros_can_write_components_and_trees() {
    use bica::prelude::*;

    let mut robot = made::Robot::new();
    robot.tick(Instant::from_millis(0));
    assert_eq!(robot.get::<made::Player>().runs, 1);
    assert_eq!(made::Robot::GRAPH.nodes[0].hz, Some(50.0));
}

mod separate {
    use bica::prelude::*;

    pub(super) struct Head {
        pub(super) pan: f32,
    }

    /// The block of the component; others stand beside it.
    #[component]
    impl Head {
        fn step(&mut self) {
            self.turn();
        }
    }

    impl Head {
        pub(super) const fn looking(pan: f32) -> Self {
            Self { pan }
        }

        fn turn(&mut self) {
            self.pan += 1.0;
        }
    }

    impl Default for Head {
        fn default() -> Self {
            Self::looking(0.0)
        }
    }

    #[cfg(test)]
    activation_tree! {
        #[doc(hidden)]
        pub(super) struct Robot {
            components: [Head = Head::looking(3.0)],
            cycle_hz: 10,
            root: Head,
        };
    }
}

#[test]
fn a_type_can_have_impl_blocks_beside_its_component() {
    use bica::prelude::*;

    let mut robot = separate::Robot::default();
    robot.tick(Instant::from_millis(0));
    assert_eq!(robot.get::<separate::Head>().pan, 4.0);
    assert_eq!(separate::Head::default().pan, 0.0);
}

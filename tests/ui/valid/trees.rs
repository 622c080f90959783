//! A root by every path.

use bica::prelude::*;

mod behaviour {
    use bica::prelude::*;

    pub(crate) struct Player {
        pub(crate) runs: u32,
    }

    #[component]
    impl Player {
        pub(crate) const fn new() -> Self {
            Self { runs: 0 }
        }

        fn step(&mut self) {
            self.runs += 1;
        }
    }
}

use behaviour::Player;

type Boss = Player;

/// Makes a tree and runs it.
macro_rules! runs_with {
    (root: $root:ty, components: [$listed:ty]) => {{
        activation_tree! {
            struct Robot { root: $root, cycle_hz: 100, components: [$listed] }
        }
        let mut robot = Robot::new();
        robot.tick(Instant::from_millis(0));
        robot.get::<Player>().runs
    }};
}

#[test]
fn the_root_is_found_by_its_type() {
    assert_eq!(runs_with!(root: Player, components: [Player]), 1);
    assert_eq!(runs_with!(root: Player, components: [behaviour::Player]), 1);
    assert_eq!(runs_with!(root: self::behaviour::Player, components: [Player]), 1);
    assert_eq!(runs_with!(root: Boss, components: [behaviour::Player]), 1);
    assert_eq!(runs_with!(root: Player, components: [Boss]), 1);
}

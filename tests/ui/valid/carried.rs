//! What transitions carry: private and generic types, by any path.

use bica::prelude::*;

mod hidden {
    #[derive(Clone, Copy)]
    pub(super) struct Kick<T>(pub(super) T);
}

use hidden::Kick as Aliased;

/// A public component whose transitions carry private types.
#[expect(unreachable_pub, reason = "a private type in its interface would be a mistake only of a public one")]
pub struct Player<T> {
    best: Option<T>,
    taken: u32,
}

#[component]
impl<T: Copy> Player<T> {
    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn kick(&mut self) {}

    #[transition(look -> kick)]
    fn near(&self) -> core::option::Option<Aliased<T>> {
        self.best.map(Aliased)
    }

    #[transition(kick -> look)]
    fn kicked(&self) -> bool {
        self.taken > 9
    }

    #[transition(kick -> kick)]
    fn again(&self) -> Option<hidden::Kick<T>> {
        None
    }

    #[before(look | kick)]
    const fn think(&mut self) {
        self.taken += 1;
    }

    #[entry(kick)]
    fn choose(&mut self, bica::Found(kick): bica::Found<hidden::Kick<T>>) {
        self.best = Some(kick.0);
    }
}

activation_tree! {
    struct Robot { root: Player<u8>, cycle_hz: 100, components: [Player<u8> = Player { best: Some(3), taken: 0 }] }
}

#[test]
fn private_and_generic_values_are_carried() {
    let mut robot = Robot::new();
    robot.tick(Instant::from_millis(0));
    assert_eq!((robot.of::<Player<u8>>().state_name(), robot.get::<Player<u8>>().taken), (Some("kick"), 1));
}

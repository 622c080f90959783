//! Signatures in every form that the language has for the same thing.

use bica::prelude::*;

pub(crate) struct Ball {
    pub(crate) distance: f32,
}

#[component]
impl Ball {
    pub(crate) const fn new() -> Self {
        Self { distance: 2.0 }
    }
}

pub(crate) struct Head {
    pub(crate) pan: f32,
}

#[component]
impl Head {
    pub(crate) const fn new() -> Self {
        Self { pan: 0.0 }
    }

    /// A `const` step with the long form of its receiver.
    const fn step(self: &mut Self) {
        self.pan += 1.0;
    }
}

pub(crate) struct Player {
    runs: u32,
}

#[component]
impl Player {
    pub(crate) const fn new() -> Self {
        Self { runs: 0 }
    }

    #[state(initial)]
    #[expect(unused_parens, reason = "parentheses are valid")]
    fn look(self: &mut Player, ball: &(Ball), (head): (&mut Head), time: &'_ bica::Time) {
        self.runs += 1;
        head.pan += ball.distance;
    }

    #[state(last)]
    extern "C" fn walk(&self) {}

    #[transition(look -> walk, after_ms = (1_000_u32))]
    #[must_use]
    pub(crate) fn near(self: &Self, ball: &self::Ball) -> bool
    where
        Self: Sized,
    {
        ball.distance < 1.0
    }
}

activation_tree! {
    struct Robot { root: Player, cycle_hz: 100, components: [Player, Ball, Head] }
}

#[test]
fn every_form_of_a_signature_links_alike() {
    let mut robot = Robot::new();
    robot.tick(Instant::from_millis(0));
    assert_eq!(robot.get::<Player>().runs, 1);
    assert_eq!(robot.get::<Head>().pan, 3.0);
    robot.get_mut::<Ball>().distance = 0.5;
    robot.tick(Instant::from_millis(1000));
    assert_eq!(robot.get::<Player>().runs, 1);
}

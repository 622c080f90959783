//! Outcomes in unusual places: of several of a kind, by a glob, beside what a transition finds.

use bica::prelude::*;

pub(crate) struct Arm<const SIDE: usize>;

#[component(resume, writers = first)]
impl<const SIDE: usize> Arm<SIDE> {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    #[transition(moves -> blocked, after_ms = 30)]
    fn moves(&mut self) {}

    #[state(failed)]
    fn blocked(&mut self) {}

    #[state(done)]
    fn there(&mut self) {}

    #[transition(moves -> there, after_ms = 10)]
    fn arrives(&self) -> bool {
        SIDE == 0
    }
}

type Left = Arm<0>;

pub(crate) struct Torso(bool, bool);

#[component]
impl Torso {
    #[state(initial)]
    fn reach(&mut self, left: &mut Left, right: &mut Arm<{ 1 }>) {}

    #[state(failed)]
    fn ends(&mut self) {}

    /// Two outcomes and a value, from all other states.
    #[transition(* -> ends)]
    fn both_ended(&self, left: &Outcome<Left>, right: &bica::Outcome<Arm<{ 1 }>>) -> Option<(bool, bool)> {
        (left.end().is_some() && right.end().is_some()).then(|| (left.is_done(), right.is_done()))
    }

    #[entry(ends)]
    const fn take(&mut self, Found((left, right)): Found<(bool, bool)>) {
        *self = Self(left, right);
    }
}

activation_tree! {
    struct Robot {
        root: Torso,
        cycle_hz: 100,
        components: [Torso = Torso(false, false), left_arm = Left, r#right = Arm<1> = Arm::new()],
    }
}

#[test]
fn outcomes_of_two_of_a_kind_are_distinguished() {
    let mut robot = Robot::new();
    for ms in [0, 10, 20, 30, 40] {
        robot.tick(Instant::from_millis(ms));
    }
    let Torso(left, right) = robot.get();
    assert!(*left && !right);
    assert!(robot.at("right").is_ok() && robot.at("left_arm").is_ok());
}

pub(crate) struct Judge<T>(T);

/// A generic machine that asks for the outcome of a child with its own parameter, in two states.
#[component]
impl<T: Copy + Default + 'static> Judge<T> {
    #[state(initial)]
    fn waits(&mut self, child: &mut Ends<T>) {}

    #[state]
    fn waits_again(&mut self, child: &Ends<T>) {}

    #[state(last)]
    fn over(&mut self) {}

    #[transition(waits -> waits_again, when = done(Ends<T>))]
    fn once(&self, child: &Ends<T>, same: &Outcome<Ends<T>>) -> bool {
        same.is_done() && child.0 > 0
    }

    #[transition(waits_again -> over)]
    fn twice(&self, again: &Outcome<Ends<T>>) -> bool {
        again.is_done()
    }
}

pub(crate) struct Ends<T>(u8, T);

#[component(hz = 50)]
impl<T: Copy + Default + 'static> Ends<T> {
    #[state(initial, done)]
    fn at_once(&mut self) {
        self.0 += 1;
    }
}

activation_tree! {
    struct Court { root: Judge<i8>, cycle_hz: 100, components: [Judge<i8> = Judge(1), Ends<i8> = Ends(0, 1)] }
}

#[test]
fn a_generic_machine_asks_for_a_generic_outcome() {
    let mut court = Court::new();
    let states = [0, 10, 20, 30].map(|ms| {
        court.tick(Instant::from_millis(ms));
        court.of::<Judge<i8>>().state_name().expect("a machine")
    });
    assert_eq!(states, ["waits", "waits_again", "over", "over"]);
    assert_eq!(court.get::<Judge<i8>>().0, court.get::<Ends<i8>>().1);
}

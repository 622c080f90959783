//! Small programs with one unusual thing each.

#![expect(clippy::type_complexity, reason = "what a transition carries may be any type")]

use bica::prelude::*;

/// Tries any machine again: it is generic over its child.
pub(crate) struct Retry<C, const TIMES: u8>(core::marker::PhantomData<C>);

#[component]
impl<C: 'static, const TIMES: u8> Retry<C, TIMES> {
    const fn new() -> Self {
        Self(core::marker::PhantomData)
    }

    #[state(initial)]
    #[transition(tries -> succeeded, when = done(C))]
    #[transition(tries -> tries, when = failed(C), times = 2)]
    #[transition(tries -> gave_up, when = failed(C))]
    fn tries(&mut self, child: &mut C) {}

    #[state(done)]
    fn succeeded(&mut self) {}

    #[state(failed)]
    fn gave_up(&mut self) {}
}

pub(crate) struct Fails(u32);

#[component]
impl Fails {
    #[state(initial)]
    #[transition(begins -> fails, after_ms = 0)]
    fn begins(&mut self) {}

    #[state(failed)]
    fn fails(&mut self) {}

    #[state(done)]
    fn succeeds(&mut self) {}

    #[transition(begins -> succeeds)]
    fn never(&self) -> bool {
        false
    }

    #[start]
    fn count(&mut self) {
        self.0 += 1;
    }
}

/// Two decorators: the outer one tries the inner one again.
type Twice = Retry<Retry<Fails, 1>, 2>;

activation_tree! {
    struct Stubborn { root: Twice, cycle_hz: 100, components: [Twice, Retry<Fails, 1>, Fails = Fails(0)] }
}

#[test]
fn a_machine_is_generic_over_the_child_it_retries() {
    let mut stubborn = Stubborn::new();
    for cycle in 0..100 {
        stubborn.tick(Instant::from_millis(10 * cycle));
    }
    assert_eq!((stubborn.of::<Twice>().state_name(), stubborn.get::<Fails>().0), (Some("gave_up"), 9));
}

/// A job without arguments, of a machine that waits for it again and again.
pub(crate) struct Waits;

#[component(resume)]
impl Waits {
    #[work(takes_ms = 1)]
    fn nothing() -> bool {
        true
    }

    #[state(initial, last)]
    fn r#await(&mut self, work: &mut Work<Self>) {
        if let Some(true) = work.result() {
            work.begin();
        }
    }

    #[entry(r#await)]
    fn begin(&mut self, r#fn: &mut Work<Waits>) {
        r#fn.begin();
    }
}

activation_tree! { struct Idle { root: Waits, cycle_hz: 1000, components: [Waits = Waits] } }

#[test]
fn a_job_needs_no_arguments() {
    let mut idle = Idle::new();
    (0..3).for_each(|ms| idle.tick(Instant::from_millis(ms)));
    assert_eq!(idle.of::<Waits>().state_name(), Some("await"));
}

/// What is carried has no name: an array of options of tuples with a function.
pub(crate) struct Carries(u8);

#[component(hz = 100)]
impl Carries {
    #[state(initial)]
    fn a(&mut self) {}

    #[state]
    fn b(&mut self) {}

    #[transition(* -> a)]
    #[transition(a -> b)]
    fn always(&self) -> Option<[Option<(u8, fn(u8) -> u8)>; 2]> {
        Some([Some((2, |two| two + 1)), None])
    }

    #[entry(a)]
    fn first(&mut self, mut found: Option<Found<[Option<(u8, fn(u8) -> u8)>; 2]>>) {
        self.0 += found.take().map_or(100, |Found([one, _])| one.map_or(0, |(two, add)| add(two)));
    }

    #[entry(b)]
    fn second(&mut self, Found([one, ..]): bica::Found<[core::option::Option<(u8, fn(u8) -> u8)>; 2]>) {
        self.0 += one.map_or(0, |(two, _)| two);
    }
}

activation_tree! { struct Circle { root: Carries, cycle_hz: 100, components: [Carries = Carries(0)] } }

#[test]
fn one_function_carries_into_two_states() {
    let mut circle = Circle::new();
    let sums = [0, 10, 20, 30].map(|ms| {
        circle.tick(Instant::from_millis(ms));
        circle.get::<Carries>().0
    });
    assert_eq!(sums, [102, 105, 107, 110]);
}

/// A role whose provider two others write, one of them its rate.
#[role]
pub(crate) trait Lamp {
    fn shine(self: &mut Self, brightness: u8);
}

pub(crate) struct Bulb<const WATTS: u8>(u8, u32);

#[component(writers = first, hz = 50)]
impl<const WATTS: u8> Bulb<WATTS> {
    fn step(&mut self) {
        self.1 += 1;
    }
}

impl<const WATTS: u8> Lamp for Bulb<WATTS> {
    fn shine(self: &mut Self, brightness: u8) {
        self.0 = brightness.min(WATTS);
    }
}

pub(crate) struct Dimmer;

#[component]
impl Dimmer {
    fn step(&mut self, rate: &mut Rate<Bulb<60>>, flicker: &mut Flicker) {
        rate.set(25.0);
    }
}

pub(crate) struct Flicker;

#[component]
impl Flicker {
    fn step(&mut self, age: &Age<Bulb<60>>, lamp: &mut impl Lamp) {
        lamp.shine(if age.since_run().is_some() { 200 } else { 1 });
    }
}

activation_tree! {
    struct Room {
        root: Dimmer,
        roles: { Lamp: Bulb<60> },
        cycle_hz: 50,
        components: [left_bulb = Bulb<60> = Bulb(0, 0), Dimmer = Dimmer, Flicker = Flicker],
    }
}

#[test]
fn a_rate_and_a_role_are_written() {
    let mut room = Room::new();
    (0..10).for_each(|cycle| room.tick(Instant::from_millis(20 * cycle)));
    let Bulb(brightness, runs) = *room.get::<Bulb<60>>();
    assert_eq!((brightness, runs), (60, 5));
}

/// The root is visited at the end of the cycle, too, if its last writer counts; nobody writes it.
pub(crate) struct Late<const N: usize>(u32);

#[component(writers = last)]
impl Late<0> {
    #[state(initial)]
    fn waits(&mut self, child: &mut Late<1>, age: &Age<Late<1>>) {
        self.0 += u32::from(age.since_run().is_some());
    }

    #[state(last)]
    fn ends(&mut self, child: &Late<1>) {}

    #[transition(waits -> ends)]
    fn is_late(&self, child: &Late<1>) -> bool {
        child.0 > 3
    }
}

#[component(writers = last)]
impl Late<1> {
    fn step(&mut self, time: &Time) {
        self.0 += 1;
    }
}

activation_tree! { struct Latest { root: Late<0>, cycle_hz: 10, components: [Late<1> = Late(0), Late<0> = Late(0)] } }

#[test]
fn a_root_is_visited_at_the_end_of_the_cycle() {
    let mut latest = Latest::new();
    (0..5).for_each(|cycle| latest.tick(Instant::from_millis(100 * cycle)));
    assert_eq!((latest.get::<Late<0>>().0, latest.get::<Late<1>>().0), (3, 5));
    assert_eq!(latest.of::<Late<0>>().state_name(), Some("ends"));
}

//! A module whose own items have the names of the language and its libraries.

#![expect(dead_code, non_camel_case_types, unused_macros, unused_variables, reason = "only their names matter")]
#![expect(clippy::unnecessary_wraps, reason = "a check has this type")]

use bica::prelude::*;

struct bool;
struct f32;
struct str;
struct u16;
struct u32;
struct usize;
struct None;
struct Option;
struct Result;
struct Some;
struct Vec;
trait Clone {}
trait Copy {}
trait Default {}
trait Into {}
trait PartialEq {}
mod alloc {}
mod bica_core {}
mod core {}
mod std {}

macro_rules! assert {
    () => {};
}
macro_rules! matches {
    () => {};
}
macro_rules! panic {
    () => {};
}
macro_rules! unreachable {
    () => {};
}
macro_rules! visit_functions {
    () => {};
}

type Number = ::core::primitive::f32;

/// How it moves.
#[derive(Params)]
#[params(check = Self::is_slow)]
struct Moving {
    /// Speed.
    #[param(default = 0.5, range = 0.0..=1.0, step = 0.1)]
    speed: ::core::primitive::f32,
    /// Side.
    #[param(default = Side::Left)]
    side: Side,
}

impl Moving {
    const fn is_slow(&self) -> ::core::result::Result<(), &'static ::core::primitive::str> {
        ::core::result::Result::Ok(())
    }
}

#[derive(::core::clone::Clone, ::core::marker::Copy, ParamEnum)]
enum Side {
    Left,
    Right,
}

/// Looks, then walks.
#[derive(ComponentDoc)]
struct Player {
    speed: Number,
}

#[component(hz = 30, budget_us = 4, resume)]
impl Player {
    const fn new() -> Self {
        Self { speed: 0.0 }
    }

    #[start]
    fn wake(&mut self) {}

    #[stop]
    fn sleep(&mut self, moving: &Tuned<Moving>) {}

    #[state(initial)]
    fn look(&mut self, legs: &mut Legs, time: &Time) {}

    #[entry(walk)]
    fn begin(&mut self, rate: &mut Rate<Legs>) {}

    #[state]
    fn walk(&mut self, moving: &Tuned<Moving>) {
        self.speed = moving.speed;
    }

    #[transition(look -> walk, after_ms = 5)]
    fn seen(&self, legs: &Legs) -> ::core::primitive::bool {
        true
    }

    #[transition(walk -> look)]
    fn lost(&self) -> ::core::primitive::bool {
        false
    }

    /// Speed.
    #[output(unit = "m/s")]
    fn speed(&self) -> Number {
        self.speed
    }

    /// Walks.
    #[modulation]
    fn go(&mut self, #[range(0.0..=1.0)] speed: ::core::primitive::f32, side: Side, now: ::core::primitive::bool) {
        self.speed = speed;
    }
}

struct Legs;

#[component]
impl Legs {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, moving: &Tuned<Moving>) {}
}

struct Room;

#[world_actions]
impl Room {
    /// Pushes.
    #[action(moves = "robot")]
    fn push(&mut self, #[range(0.0..=1.0)] speed: ::core::primitive::f32, side: Side) {}
}

activation_tree! {
    struct Tuning { root: Player, cycle_hz: 50, budget_ms: 5, tunable, components: [Player, Legs] }
}

activation_tree! {
    struct Fixed { root: Player, cycle_hz: 50, components: [Legs, Player = Player { speed: 1.0 }] }
}

#[test]
fn names_of_the_language_may_be_shadowed() {
    let (mut tuning, mut fixed) = (Tuning::new(), Fixed::new());
    for cycle in 0..3 {
        tuning.tick(Instant::from_millis(20 * cycle));
        fixed.tick(Instant::from_millis(20 * cycle));
    }
    ::core::assert_eq!((tuning.get::<Player>().speed, fixed.get::<Player>().speed), (0.5, 0.5));
    ::core::assert_eq!(Player::DOC, "Looks, then walks.");
    ::core::assert_eq!(Room.list().len(), 1);
}

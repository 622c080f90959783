//! Falls.

use bica::prelude::*;
use bica_motion::fall::{Direction, Uprightness};
use bica_motion::getup::{self, GetUp};
use bica_motion::keyframes::{Keyframe, Motion};
use bica_motion::stand::{RESTING, SIT, TO_SIT};

use crate::input::Measured;
use crate::motion::Body;
use crate::output::Motors;
use crate::perception::FallDetector;

/// Takes over when the robot falls: softens the fall, then gets it up, from the front or from the back; if that fails, the
/// other way. A body with a fault it brings to a stand and sits down, for good.
#[derive(Debug)]
pub struct FallGuard {
    movement: GetUp,
    surrender: Motion,
    brace: Keyframe,
    /// Movements that did not get it up.
    failures: u8,
    upright: bool,
}

#[component(budget_us = 10)]
impl FallGuard {
    /// Has nothing to do yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            movement: GetUp::none(),
            surrender: Motion::none(),
            brace: getup::protection(Direction::Front),
            failures: 0,
            upright: false,
        }
    }

    /// In the air: limbs in, joints soft.
    #[state(initial)]
    fn brace(&mut self, falls: &FallDetector, motors: &mut Motors) {
        if let Uprightness::Falling(direction) = falls.state() {
            self.brace = getup::protection(direction);
        }
        motors.whole(&self.brace.posture, self.brace.stiffness);
    }

    /// On the ground: plays the movement that gets it up from there.
    #[state]
    fn get_up(&mut self, time: &Time, body: &Measured, motors: &mut Motors) {
        let (posture, stiffness) = self.movement.step(body.inertial(), time.dt());
        motors.whole(&posture, stiffness);
    }

    /// On its feet, but must not go on: first both of them on the ground.
    #[state]
    fn halt(&mut self, body: &mut Body) {
        body.stand();
    }

    /// Must not go on: sits down and stays so, all but limp.
    #[state(last)]
    fn give_up(&mut self, time: &Time, motors: &mut Motors) {
        let moving = self.surrender.step(time.dt()).filter(|_| !self.surrender.is_done());
        let (posture, stiffness) = moving.unwrap_or((SIT, RESTING));
        motors.whole(&posture, stiffness);
    }

    /// On its feet.
    #[state(last)]
    fn stand(&mut self) {
        self.upright = true;
    }

    #[transition(brace -> get_up)]
    fn lies(&self, falls: &FallDetector) -> bool {
        matches!(falls.state(), Uprightness::Fallen(_))
    }

    #[transition(halt -> brace)]
    fn falls_over(&self, falls: &FallDetector) -> bool {
        falls.falls()
    }

    #[transition(brace -> halt)]
    fn breaks_on_its_feet(&self, body: &Measured, falls: &FallDetector) -> bool {
        body.fault().is_some() && !falls.falls()
    }

    #[transition(brace | get_up -> give_up)]
    fn is_broken(&self, body: &Measured) -> bool {
        body.fault().is_some()
    }

    #[transition(halt -> give_up)]
    fn has_halted(&self, body: &Body) -> bool {
        body.is_still()
    }

    /// What is broken may keep it from a stand.
    #[transition(halt -> give_up, after_ms = 3000)]
    fn cannot_halt(&self) -> bool {
        true
    }

    /// It was a stumble.
    #[transition(brace -> stand, after_ms = 500)]
    fn never_fell(&self, falls: &FallDetector) -> bool {
        falls.upright()
    }

    #[transition(get_up -> stand)]
    fn is_up(&self, falls: &FallDetector) -> bool {
        self.movement.is_done() && falls.upright()
    }

    /// It did not work: once more, from where the robot lies now.
    #[transition(get_up -> brace)]
    fn failed(&self) -> bool {
        self.movement.is_done()
    }

    #[entry(get_up)]
    fn begin(&mut self, falls: &FallDetector, body: &Measured) {
        if let Uprightness::Fallen(direction) = falls.state() {
            self.movement = GetUp::new(direction, self.failures, *body.angles());
        }
    }

    #[exit(get_up)]
    fn count(&mut self) {
        self.failures = self.failures.wrapping_add(1);
    }

    #[entry(give_up)]
    fn sit_down(&mut self, body: &Measured) {
        self.surrender = Motion::new(&TO_SIT, *body.angles());
    }

    #[stop]
    fn end(&mut self) {
        (self.upright, self.failures) = (false, 0);
        (self.movement, self.surrender) = (GetUp::none(), Motion::none());
    }

    /// Whether the robot stands again.
    #[must_use]
    pub const fn upright(&self) -> bool {
        self.upright
    }
}

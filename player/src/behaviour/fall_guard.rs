//! Falls.

use bica::prelude::*;
use bica_motion::fall::{Direction, FallState};
use bica_motion::getup::{self, GetUp};
use bica_motion::health::Fault;
use bica_motion::keyframes::{Keyframe, Motion};
use bica_motion::model::{Nao, RobotModel};

use crate::input::Measured;
use crate::motion::Body;
use crate::output::Motors;
use crate::perception::FallDetector;

/// Takes over when the robot falls: softens the fall, then gets it up, from the front or from the back; if that fails,
/// another way. A body with a fault it brings to a stand and sits down, for good; or if it is hot only, until it has cooled.
#[derive(Debug)]
pub struct FallGuard {
    movement: GetUp,
    /// To sit down, or to stand up from there.
    slowly: Motion,
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
            slowly: Motion::none(),
            brace: getup::protection::<Nao>(Direction::Front),
            failures: 0,
            upright: false,
        }
    }

    /// In the air: limbs in, joints soft.
    #[state(initial)]
    fn brace(&mut self, falls: &FallDetector, motors: &mut Motors) {
        if let FallState::Falling(direction) = falls.state() {
            self.brace = getup::protection::<Nao>(direction);
        }
        motors.whole(&self.brace.posture, self.brace.stiffness);
    }

    /// On the ground: plays the movement that gets it up from there.
    #[state]
    fn get_up(&mut self, time: &Time, body: &Measured, motors: &mut Motors) {
        let (posture, stiffness) = self.movement.step(body.inertial(), time.dt());
        motors.whole(&posture, stiffness);
    }

    /// On the ground, jammed or hot: limp, so that limbs slip free and motors cool. Feels what it comes to lie on.
    #[state]
    fn rest(&mut self, _falls: &FallDetector, body: &Measured, motors: &mut Motors) {
        motors.whole(body.angles(), 0.0);
    }

    /// On its feet, but must not go on: first both of them on the ground.
    #[state]
    fn halt(&mut self, body: &mut Body) {
        body.stand();
    }

    /// Must not go on: sits down and stays so, all but limp.
    #[state]
    fn sit(&mut self, time: &Time, motors: &mut Motors) {
        let moving = self.slowly.step(time.dt()).filter(|_| !self.slowly.is_done());
        let (posture, stiffness) = moving.unwrap_or((Nao::SIT, Nao::SIT_STIFFNESS));
        motors.whole(&posture, stiffness);
    }

    /// May go on: stands up from there.
    #[state]
    fn rise(&mut self, time: &Time, motors: &mut Motors) {
        if let Some((posture, stiffness)) = self.slowly.step(time.dt()) {
            motors.whole(&posture, stiffness);
        }
    }

    /// On its feet.
    #[state(last)]
    fn stand(&mut self) {
        self.upright = true;
    }

    #[transition(halt | rise -> brace)]
    fn falls_over(&self, falls: &FallDetector) -> bool {
        falls.falls()
    }

    #[transition(brace | rise -> halt)]
    fn breaks_on_its_feet(&self, body: &Measured, falls: &FallDetector) -> bool {
        body.fault().is_some() && !falls.falls()
    }

    /// The way up is hard on the motors, but short: what is hot waits until it is over.
    #[transition(get_up -> halt)]
    fn is_up_but_hot(&self, body: &Measured, falls: &FallDetector) -> bool {
        self.movement.is_done() && body.fault().is_some_and(Fault::is_temporary) && !falls.falls()
    }

    #[transition(brace | get_up | rest -> sit)]
    fn is_broken(&self, body: &Measured) -> bool {
        body.fault().is_some_and(|fault| !fault.is_temporary())
    }

    #[transition(halt -> sit)]
    fn has_halted(&self, body: &Body) -> bool {
        body.is_still()
    }

    /// What is broken may keep it from a stand.
    #[transition(halt -> sit, after_ms = 3000)]
    fn cannot_halt(&self) -> bool {
        true
    }

    /// It sat down because it was hot, or lies where it should sit.
    #[transition(sit -> rest)]
    fn has_cooled_on_the_ground(&self, body: &Measured, falls: &FallDetector) -> bool {
        body.fault().is_none_or(Fault::is_temporary) && falls.falls()
    }

    #[transition(sit -> rise)]
    fn has_cooled(&self, body: &Measured) -> bool {
        body.fault().is_none()
    }

    /// It was a stumble.
    #[transition(brace -> stand, after_ms = 500)]
    fn never_fell(&self, falls: &FallDetector) -> bool {
        falls.upright()
    }

    #[transition(get_up | rise -> stand)]
    fn is_up(&self, falls: &FallDetector) -> bool {
        self.movement.is_done() && self.slowly.is_done() && falls.upright()
    }

    #[transition(brace -> get_up)]
    fn lies(&self, falls: &FallDetector, body: &Measured) -> bool {
        matches!(falls.state(), FallState::Fallen(_)) && body.fault().is_none()
    }

    #[transition(brace -> rest)]
    fn lies_hot(&self, falls: &FallDetector) -> bool {
        matches!(falls.state(), FallState::Fallen(_))
    }

    /// It did not work: once more, from where the robot lies then.
    #[transition(get_up -> rest)]
    fn failed(&self) -> bool {
        self.movement.is_done()
    }

    #[transition(rest -> brace, after_ms = 500)]
    fn has_rested(&self, body: &Measured) -> bool {
        body.fault().is_none()
    }

    #[entry(get_up)]
    fn begin(&mut self, falls: &FallDetector, body: &Measured) {
        if let FallState::Fallen(direction) = falls.state() {
            self.movement = GetUp::new(direction, self.failures, *body.angles());
        }
    }

    #[exit(get_up)]
    fn count(&mut self) {
        self.failures = self.failures.wrapping_add(1);
    }

    #[entry(sit)]
    fn sit_down(&mut self, body: &Measured) {
        self.slowly = Motion::new(Nao::TO_SIT, *body.angles());
    }

    #[entry(rise)]
    fn stand_up(&mut self, body: &Measured) {
        self.slowly = Motion::new(Nao::TO_STAND, *body.angles());
    }

    #[stop]
    fn end(&mut self) {
        (self.upright, self.failures) = (false, 0);
        (self.movement, self.slowly) = (GetUp::none(), Motion::none());
    }

    /// Whether the robot stands again.
    #[must_use]
    pub const fn upright(&self) -> bool {
        self.upright
    }
}

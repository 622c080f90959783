//! Falls and faults.

use bica::prelude::*;
use bica_motion::fall::{Direction, FallState};
use bica_motion::getup::{self, GetUp};
use bica_motion::health::Fault;
use bica_motion::keyframes::{Keyframe, Motion};
use bica_motion::model::RobotModel;

use crate::MODEL;
use crate::input::RobotState;
use crate::output::Motors;
use crate::roles::{Falls, Game, Health, Legs};

/// Controls the body after a fall or a fault. A falling robot takes a protective posture and then gets up, from the
/// front or from the back; after a failed attempt with another movement. A robot with a fault stops and sits down:
/// permanently, or until hot motors have cooled. One that is stopped stays down.
#[derive(Debug)]
pub struct SafetyGuard {
    model: &'static RobotModel,
    get_up: GetUp,
    /// Motion to the sitting posture, or from it to the stand.
    sit_or_rise: Motion,
    brace: Keyframe,
    /// Number of get-up movements since the fall.
    attempts: u8,
    stands: bool,
}

#[component(budget_us = 10)]
impl SafetyGuard {
    /// Creates the component without a motion.
    #[must_use]
    pub const fn new() -> Self {
        Self::of(MODEL)
    }

    const fn of(model: &'static RobotModel) -> Self {
        Self {
            model,
            get_up: GetUp::none(model),
            sit_or_rise: Motion::none(),
            brace: getup::protection(model, Direction::Front),
            attempts: 0,
            stands: false,
        }
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        *self = Self::of(model);
    }

    /// During the fall: limbs drawn in, low stiffness.
    #[state(initial)]
    fn brace(&mut self, falls: &impl Falls, motors: &mut Motors) {
        if let FallState::Falling(direction) = falls.state() {
            self.brace = getup::protection(self.model, direction);
        }
        motors.set_all(&self.brace.posture, self.brace.stiffness);
    }

    /// On the ground: plays the get-up movement.
    #[state]
    fn get_up(&mut self, time: &Time, state: &RobotState, motors: &mut Motors) {
        let (posture, stiffness) = self.get_up.step(state.inertial(), time.dt());
        motors.set_all(&posture, stiffness);
    }

    /// On the ground after a failed attempt, hot, or stopped: no stiffness, so that limbs become free and motors cool.
    #[state]
    fn rest(&mut self, _falls: &impl Falls, state: &RobotState, motors: &mut Motors) {
        motors.set_all(state.angles(), 0.0);
    }

    /// With a fault, still standing: ends the step with both feet on the ground.
    #[state]
    fn halt(&mut self, body: &mut impl Legs) {
        body.stand();
    }

    /// With a fault: sits down and stays there with low stiffness.
    #[state]
    fn sit(&mut self, time: &Time, motors: &mut Motors) {
        let moving = self.sit_or_rise.step(time.dt()).filter(|_| !self.sit_or_rise.is_done());
        let (posture, stiffness) = moving.unwrap_or((self.model.sit, self.model.sit_stiffness));
        motors.set_all(&posture, stiffness);
    }

    /// After a fault: stands up from the sitting posture.
    #[state]
    fn rise(&mut self, time: &Time, motors: &mut Motors) {
        if let Some((posture, stiffness)) = self.sit_or_rise.step(time.dt()) {
            motors.set_all(&posture, stiffness);
        }
    }

    /// Standing, without a fault.
    #[state(last)]
    fn stand(&mut self) {
        self.stands = true;
    }

    #[transition(halt | rise -> brace)]
    fn falls(&self, falls: &impl Falls) -> bool {
        falls.is_down()
    }

    #[transition(brace | rise -> halt)]
    fn has_fault_on_its_feet(&self, health: &impl Health, falls: &impl Falls) -> bool {
        health.fault().is_some() && !falls.is_down()
    }

    /// Getting up heats the motors but takes little time, so it is completed first.
    #[transition(get_up -> halt)]
    fn is_up_but_hot(&self, health: &impl Health, falls: &impl Falls) -> bool {
        self.get_up.is_done() && health.fault().is_some_and(Fault::is_temporary) && !falls.is_down()
    }

    #[transition(brace | get_up | rest -> sit)]
    fn has_lasting_fault(&self, health: &impl Health) -> bool {
        health.fault().is_some_and(|fault| !fault.is_temporary())
    }

    #[transition(halt -> sit)]
    fn has_halted(&self, body: &impl Legs) -> bool {
        body.is_still()
    }

    /// A fault may make standing impossible.
    #[transition(halt -> sit, after_ms = 3000)]
    fn cannot_halt(&self) -> bool {
        true
    }

    /// Whether the robot lies, with no fault or only a temporary one.
    #[transition(sit -> rest)]
    fn lies_while_sitting(&self, health: &impl Health, falls: &impl Falls) -> bool {
        health.fault().is_none_or(Fault::is_temporary) && falls.is_down()
    }

    #[transition(sit -> rise)]
    fn has_cooled(&self, health: &impl Health) -> bool {
        health.fault().is_none()
    }

    /// Whether the robot did not fall after all.
    #[transition(brace -> stand, after_ms = 500)]
    fn never_fell(&self, falls: &impl Falls) -> bool {
        !falls.is_down()
    }

    #[transition(get_up | rise -> stand)]
    fn is_up(&self, falls: &impl Falls) -> bool {
        self.get_up.is_done() && self.sit_or_rise.is_done() && !falls.is_down()
    }

    #[transition(brace -> get_up)]
    fn lies(&self, falls: &impl Falls, health: &impl Health, game: &impl Game) -> bool {
        matches!(falls.state(), FallState::Fallen(_)) && health.fault().is_none() && game.playing()
    }

    #[transition(brace -> rest)]
    fn stays_down(&self, falls: &impl Falls) -> bool {
        matches!(falls.state(), FallState::Fallen(_))
    }

    /// The next attempt begins with the side on which the robot lies then.
    #[transition(get_up -> rest)]
    fn failed(&self) -> bool {
        self.get_up.is_done()
    }

    #[transition(rest -> brace, after_ms = 500)]
    fn has_rested(&self, health: &impl Health, game: &impl Game) -> bool {
        health.fault().is_none() && game.playing()
    }

    #[entry(get_up)]
    fn begin_get_up(&mut self, falls: &impl Falls, state: &RobotState) {
        if let FallState::Fallen(direction) = falls.state() {
            self.get_up = GetUp::new(self.model, direction, self.attempts, *state.angles());
        }
    }

    #[exit(get_up)]
    fn count_attempt(&mut self) {
        self.attempts = self.attempts.wrapping_add(1);
    }

    #[entry(sit)]
    fn begin_sit(&mut self, state: &RobotState) {
        self.sit_or_rise = Motion::new(self.model.to_sit, *state.angles());
    }

    #[entry(rise)]
    fn begin_rise(&mut self, state: &RobotState) {
        self.sit_or_rise = Motion::new(self.model.to_stand, *state.angles());
    }

    #[stop]
    fn reset(&mut self) {
        (self.stands, self.attempts) = (false, 0);
        (self.get_up, self.sit_or_rise) = (GetUp::none(self.model), Motion::none());
    }

    /// Number of get-up movements since the fall.
    #[output]
    #[must_use]
    pub const fn attempts(&self) -> u8 {
        self.attempts
    }

    /// Index of the key posture that the last get-up movement approaches, from its beginning; `None` if there was none since
    /// the component became active.
    #[output]
    #[must_use]
    pub fn get_up_posture(&self) -> Option<u32> {
        self.get_up.index().map(|index| index as u32)
    }

    /// Index of the key posture that the motion to or from the sitting posture approaches; their number when it is over.
    #[output]
    #[must_use]
    pub const fn sit_or_rise_posture(&self) -> u32 {
        self.sit_or_rise.index() as u32
    }

    /// Whether the robot stands again.
    #[output]
    #[must_use]
    pub const fn stands(&self) -> bool {
        self.stands
    }
}

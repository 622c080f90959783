//! Play with the others.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::{Positioning, Roles, TeamBall};
use crate::behaviour::{LookAround, Player};
use crate::input::RobotState;
use crate::referee::GoTo;
use crate::roles::{Ball, Whereabouts};

/// How a striker uses what the others see.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct Joining {
    /// Least distance of a ball that the others see, and the striker does not, to which it walks.
    #[param(default = 1.5, range = 0.5..=6.0, unit = "m", step = 0.1)]
    pub far: f32,
    /// Distance of such a ball at which the striker searches for it.
    #[param(default = 1.0, range = 0.3..=6.0, unit = "m", step = 0.1)]
    pub near: f32,
    /// Largest age of the others' sighting.
    #[param(default = 4.0, range = 0.5..=10.0, unit = "s", step = 0.5)]
    pub age: f32,
}

impl Joining {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.near < self.far { Ok(()) } else { Err("`near` must be below `far`") }
    }

    /// Distance of the robot from a ball that some player has seen lately, m; `None` without one.
    fn distance(&self, field: &impl Whereabouts, ball: &TeamBall) -> Option<f32> {
        let at = ball.position().filter(|_| ball.age().is_some_and(|age| age < self.age))?;
        field.pose().map(|pose| pose.position.distance(at))
    }
}

/// Plays the own part: the ball as [`Player`] does, or a position.
#[derive(Debug)]
pub struct TeamPlay;

#[component(hz = 50, budget_us = 10)]
impl TeamPlay {
    /// Creates the component.
    #[must_use]
    pub const fn new() -> Self {
        Self
    }

    /// Plays the ball.
    #[state(initial)]
    fn strike(&mut self, _roles: &Roles, _player: &mut Player) {}

    /// Walks to a ball that others see.
    #[state]
    fn join(
        &mut self,
        _roles: &Roles,
        field: &impl Whereabouts,
        ball: &TeamBall,
        go: &mut GoTo,
        _look: &mut LookAround,
    ) {
        if let Some((at, pose)) = ball.position().zip(field.pose()) {
            let heading = (at - pose.position).normalize_or(Vec2::X).to_angle();
            go.to(Pose2 { position: at, heading });
        }
    }

    /// Takes its position.
    #[state]
    fn hold(&mut self, _roles: &Roles, _positioning: &mut Positioning) {}

    /// A step or a kick ends on both feet before.
    #[transition(strike | join -> hold)]
    fn other_plays(&self, roles: &Roles, state: &RobotState) -> bool {
        !roles.plays_ball() && state.may_stop()
    }

    #[transition(hold -> strike)]
    fn plays_ball(&self, roles: &Roles) -> bool {
        roles.plays_ball()
    }

    #[transition(strike -> join)]
    fn others_see_ball(
        &self,
        tuned: &Tuned<Joining>,
        sight: &impl Ball,
        field: &impl Whereabouts,
        ball: &TeamBall,
    ) -> bool {
        sight.is_lost() && tuned.distance(field, ball).is_some_and(|distance| distance > tuned.far)
    }

    #[transition(join -> strike)]
    fn sees_ball(&self, sight: &impl Ball) -> bool {
        sight.is_confirmed()
    }

    /// It is there, or nobody sees the ball any more.
    #[transition(join -> strike)]
    fn has_joined(&self, tuned: &Tuned<Joining>, field: &impl Whereabouts, ball: &TeamBall) -> bool {
        tuned.distance(field, ball).is_none_or(|distance| distance < tuned.near)
    }

    /// Something is in the way.
    #[transition(join -> strike, after_ms = 20000)]
    fn cannot_join(&self) -> bool {
        true
    }
}

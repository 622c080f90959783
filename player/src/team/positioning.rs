//! Play without the ball.

use bica::prelude::*;
use glam::Vec2;

use super::formation::Formation;
use super::{Roles, TeamBall};
use crate::behaviour::{FaceBall, LookAround};
use crate::referee::GoTo;
use crate::roles::{Ball, Whereabouts};

/// Walks to the position of the own part and stays there, while it looks at the ball and at the field in turn.
#[derive(Debug)]
pub struct Positioning;

#[component(hz = 30, budget_us = 10)]
impl Positioning {
    /// Creates the component.
    #[must_use]
    pub const fn new() -> Self {
        Self
    }

    /// Looks at the field, to localize itself and to find the ball.
    #[state(initial)]
    fn look(
        &mut self,
        tuned: &Tuned<Formation>,
        roles: &Roles,
        field: &impl Whereabouts,
        ball: &TeamBall,
        go: &mut GoTo,
        _look: &mut LookAround,
    ) {
        let here = field.pose().map_or(Vec2::ZERO, |pose| pose.position);
        go.to(tuned.place(roles.role(), here, ball.position()));
    }

    /// Looks at the ball.
    #[state]
    fn watch(
        &mut self,
        tuned: &Tuned<Formation>,
        roles: &Roles,
        field: &impl Whereabouts,
        ball: &TeamBall,
        go: &mut GoTo,
        _face: &mut FaceBall,
    ) {
        let here = field.pose().map_or(Vec2::ZERO, |pose| pose.position);
        go.to(tuned.place(roles.role(), here, ball.position()));
    }

    #[transition(look -> watch, after_ms = 3000)]
    fn sees_ball(&self, ball: &impl Ball) -> bool {
        ball.is_confirmed()
    }

    /// Its place on the field becomes uncertain.
    #[transition(watch -> look, after_ms = 4000)]
    fn has_watched(&self) -> bool {
        true
    }

    #[transition(watch -> look)]
    fn ball_lost(&self, ball: &impl Ball) -> bool {
        ball.is_lost()
    }
}

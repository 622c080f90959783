//! The own messages to the team.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use bica_motion::pose::wrap;

use super::message::{Intention, PoseCovariance, Role, TeamMessage};
use super::pacer::Pacer;
use super::{Roles, TeamBall, TeamMates};
use crate::referee::{GameController, Order};
use crate::roles::{Ball, Whereabouts};

/// What is new enough for a message before the next one is due.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct News {
    /// Distance of the ball from that of the last message.
    #[param(default = 0.5, range = 0.1..=5.0, unit = "m", step = 0.1)]
    pub ball_distance: f32,
    /// Distance of the robot from its pose in the last message.
    #[param(default = 0.5, range = 0.1..=5.0, unit = "m", step = 0.1)]
    pub distance: f32,
    /// Time after the fall of a striker, or with a second one, in which each message that the budget allows is sent: some are lost.
    #[param(default = 1.0, range = 0.0..=5.0, unit = "s", step = 0.1)]
    pub urgent_time: f32,
}

/// Writes the own messages: when something is new, and otherwise at a rate at which the budget lasts. Nothing is sent before the
/// robot knows its pose, without the packets of a `GameController`, and in states in which messages are not allowed.
#[derive(Debug)]
pub struct TeamComm {
    pacer: Pacer,
    message: Option<TeamMessage>,
    /// The last message.
    last: Option<TeamMessage>,
    /// Time on the own clock, ms.
    time_ms: u32,
    /// Remaining time in which each message that the budget allows is sent, s.
    urgent: f32,
    role: Role,
    intention: Intention,
    messages: u32,
}

#[component(budget_us = 10)]
impl TeamComm {
    /// Creates the component before the first message.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            pacer: Pacer::new(),
            message: None,
            last: None,
            time_ms: 0,
            urgent: 0.0,
            role: Role::Absent,
            intention: Intention::Stand,
            messages: 0,
        }
    }

    fn step(
        &mut self,
        tuned: &Tuned<News>,
        time: &Time,
        game: &GameController,
        field: &impl Whereabouts,
        sight: &impl Ball,
        ball: &TeamBall,
        mates: &TeamMates,
        roles: &mut Roles,
    ) {
        self.time_ms = time.now.as_millis() as u32;
        let players = (mates.count() + 1).max(game.players_on_field());
        self.pacer.advance(time.dt(), game.control(), game.message_budget().unwrap_or(0), players);
        let is_double = roles.role() == Role::Striker && mates.strikers() > 0;
        let is_urgent = is_double || self.role == Role::Striker && roles.role() == Role::Absent;
        self.role = roles.role();
        self.intention = intention(game.order(), roles, sight);
        roles.set_budget(self.pacer.can_claim(), self.pacer.is_scarce());
        self.urgent = if is_urgent { tuned.urgent_time } else { (self.urgent - time.dt()).max(0.0) };
        let Some(pose) = field.pose() else { return };
        let message = TeamMessage {
            from: game.me(),
            time_ms: self.time_ms,
            pose: [pose.position.x, pose.position.y, wrap(pose.heading)],
            covariance: covariance(field),
            ball: ball.own(),
            intention: self.intention,
            role: roles.role(),
            claim: roles.claim(),
            time_to_ball: roles.time_to_ball(),
            interval: self.pacer.interval(),
        };
        let has_other_part = self.last.is_none_or(|last| last.role != message.role);
        let is_about_part = has_other_part || self.urgent > 0.0;
        let is_sent = if is_about_part {
            self.pacer.may_send()
        } else {
            self.pacer.is_due() || self.pacer.may_spare() && self.is_new(tuned, &message)
        };
        if is_sent {
            self.send(message);
        }
    }

    fn send(&mut self, message: TeamMessage) {
        self.pacer.count();
        (self.message, self.last) = (Some(message), Some(message));
        self.messages = self.messages.saturating_add(1);
    }

    /// Whether a message says something that the last one did not.
    fn is_new(&self, tuned: &News, message: &TeamMessage) -> bool {
        let Some(last) = &self.last else { return true };
        let Pose2 { position, .. } = message.pose();
        let has_moved = position.distance(last.pose().position) > tuned.distance;
        let ball_moved = match (message.ball, last.ball) {
            (Some(ball), Some(before)) => glam::Vec2::from(ball.at).distance(before.at.into()) > tuned.ball_distance,
            (ball, before) => ball.is_some() != before.is_some(),
        };
        has_moved || ball_moved || message.intention != last.intention
    }

    /// Takes the message of this cycle, if there is one.
    pub const fn take(&mut self) -> Option<TeamMessage> {
        self.message.take()
    }

    /// What the robot does now.
    #[output]
    #[must_use]
    pub const fn intention(&self) -> Intention {
        self.intention
    }

    /// Number of messages so far.
    #[output]
    #[must_use]
    pub const fn messages(&self) -> u32 {
        self.messages
    }

    /// Longest time between two messages.
    #[output(unit = "s")]
    #[must_use]
    pub fn interval(&self) -> f32 {
        self.pacer.interval()
    }
}

fn covariance(field: &impl Whereabouts) -> PoseCovariance {
    let [[xx, xy, xh], [_, yy, yh], [_, _, hh]] = field.covariance().to_cols_array_2d();
    PoseCovariance { variances: [xx, yy, hh], covariances: [xy, xh, yh] }
}

fn intention(order: Order, roles: &Roles, ball: &impl Ball) -> Intention {
    match roles.role() {
        Role::Absent => Intention::Stand,
        _ if !matches!(order, Order::Playing | Order::Ready) => Intention::Stand,
        _ if order == Order::Ready || !roles.plays_ball() => Intention::Position,
        _ if ball.is_lost() => Intention::Search,
        _ => Intention::Play,
    }
}

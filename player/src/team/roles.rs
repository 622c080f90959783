//! The own part in the team.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use glam::Vec2;
use libm::{atan2f, fabsf};

use super::election::{Candidate, Claiming, Election};
use super::mates::Mate;
use super::message::Role;
use super::{TeamBall, TeamMates};
use crate::FIELD;
use crate::referee::{GameController, Order};
use crate::roles::{Falls, Whereabouts};

/// Distance by which a ball that is played moves, m.
const MOVED: f32 = 0.5;

/// How long a player takes to the ball, and who defends.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Reach {
    /// Walking speed.
    #[param(default = 0.2, range = 0.05..=1.0, unit = "m/s", step = 0.01)]
    pub speed: f32,
    /// Turning speed.
    #[param(default = 0.6, range = 0.1..=3.0, unit = "rad/s", step = 0.1)]
    pub turn_speed: f32,
    /// Time for each radian that a player must walk around the ball to be behind it.
    #[param(default = 2.0, range = 0.0..=20.0, unit = "s/rad", step = 0.5)]
    pub round_time: f32,
    /// Lead towards the own goal that another player needs to become the defender.
    #[param(default = 0.5, range = 0.0..=3.0, unit = "m", step = 0.1)]
    pub defending_lead: f32,
    /// Distance of the ball from the middle of the own goal below which the goalkeeper plays it.
    #[param(default = 1.0, range = 0.2..=3.0, unit = "m", step = 0.1)]
    pub clearing_distance: f32,
    /// Further distance at which the goalkeeper stops playing it.
    #[param(default = 0.4, range = 0.0..=2.0, unit = "m", step = 0.1)]
    pub clearing_slack: f32,
}

impl Reach {
    /// Time that a robot at a pose takes to be behind a ball, s. Both in the field frame, m.
    #[must_use]
    pub fn time_to(&self, pose: &Pose2, ball: Vec2) -> f32 {
        let way = pose.locate(ball);
        let turn = fabsf(atan2f(way.y, way.x));
        let goal = Vec2::new(FIELD.field_corner().x, 0.0) - ball;
        let round = fabsf((ball - pose.position).angle_to(goal));
        way.length() / self.speed + turn / self.turn_speed + round * self.round_time
    }
}

/// The part that the robot has in its team: each player decides its own one by what it has heard.
#[derive(Debug)]
pub struct Roles {
    role: Role,
    election: Election,
    time_to_ball: Option<f32>,
    /// Whether the budget allows a claim that the others hear.
    is_heard: bool,
    /// Whether messages are too rare to agree on a striker.
    is_scarce: bool,
    /// Where the ball was last seen to move, m, field frame, and the time since then, s.
    rested: (Vec2, f32),
    /// Whether the goalkeeper plays a ball near its goal.
    is_clearing: bool,
}

#[component(budget_us = 20)]
impl Roles {
    /// Creates the component outside the game.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            role: Role::Absent,
            election: Election::new(),
            time_to_ball: None,
            is_heard: true,
            is_scarce: false,
            rested: (Vec2::ZERO, 0.0),
            is_clearing: false,
        }
    }

    fn step(
        &mut self,
        claiming: &Tuned<Claiming>,
        reach: &Tuned<Reach>,
        time: &Time,
        game: &GameController,
        field: &impl Whereabouts,
        falls: &impl Falls,
        ball: &TeamBall,
        mates: &TeamMates,
    ) {
        let (pose, at) = (field.pose(), ball.position());
        self.time_to_ball = pose.zip(at).map(|(pose, at)| reach.time_to(&pose, at));
        let is_playing = !matches!(game.order(), Order::Initial | Order::Penalized | Order::Finished);
        let is_fit = is_playing && !falls.is_down();
        if self.is_scarce {
            let rested = self.rest(game.order(), time.dt(), at);
            let is_next = game.turn().is_some_and(|turn| rested >= turn as f32 * claiming.rest);
            self.election.appoint(is_fit && is_next);
        } else {
            // A robot without a pose cannot send that it is the striker.
            let may_strike = is_fit && !game.is_goalkeeper() && (pose.is_some() || mates.strikers() == 0);
            let me = may_strike.then_some((game.me().player, self.time_to_ball));
            self.election.decide(claiming, time.dt(), me, self.is_heard, mates.present().filter_map(candidate));
        }
        self.role = if !is_fit {
            Role::Absent
        } else if game.is_goalkeeper() {
            Role::Goalkeeper
        } else if self.election.is_striker() {
            Role::Striker
        } else {
            let x = pose.map_or(0.0, |pose| pose.position.x);
            self.part(reach, game.me().player, x, mates)
        };
        self.is_clearing = at.is_some_and(|at| self.clears(reach, at));
    }

    /// Part of a player at `x`, m, that is neither striker nor goalkeeper: one defends.
    fn part(&self, reach: &Reach, player: u8, x: f32, mates: &TeamMates) -> Role {
        let place = |role, x: f32| if role == Role::Defender { x - reach.defending_lead } else { x };
        let mine = place(self.role, x);
        let others = mates.present().filter(|mate| matches!(mate.message.role, Role::Defender | Role::Supporter));
        let is_last = others.clone().all(|mate| {
            let other = place(mate.message.role, mate.message.pose().position.x);
            mine.total_cmp(&other).then(player.cmp(&mate.message.from.player)).is_lt()
        });
        let is_guarded = mates.present().any(|mate| mate.message.role == Role::Goalkeeper);
        let is_needed = !is_guarded || others.count() > 0;
        if is_last && is_needed { Role::Defender } else { Role::Supporter }
    }

    /// Time in which nobody has moved the ball in the game, s.
    fn rest(&mut self, order: Order, seconds: f32, ball: Option<Vec2>) -> f32 {
        let (before, rested) = self.rested;
        let moved = ball.filter(|ball| ball.distance(before) > MOVED);
        let is_over = moved.is_some() || order != Order::Playing;
        self.rested = (moved.unwrap_or(before), if is_over { 0.0 } else { rested + seconds });
        self.rested.1
    }

    fn clears(&self, reach: &Reach, ball: Vec2) -> bool {
        let goal = Vec2::new(-FIELD.field_corner().x, 0.0);
        let slack = if self.is_clearing { reach.clearing_slack } else { 0.0 };
        self.role == Role::Goalkeeper && ball.distance(goal) < reach.clearing_distance + slack
    }

    /// Sets whether the others would hear a claim, and whether messages are too rare to agree on a striker: then the player
    /// that takes the kick-off is the striker, which each player knows from the packets, and the next one if nobody plays the ball.
    pub(super) const fn set_budget(&mut self, is_heard: bool, is_scarce: bool) {
        (self.is_heard, self.is_scarce) = (is_heard, is_scarce);
    }

    /// The own part.
    #[output]
    #[must_use]
    pub const fn role(&self) -> Role {
        self.role
    }

    /// Whether the robot plays the ball: as the striker, or as the goalkeeper with a ball near its goal.
    #[output]
    #[must_use]
    pub fn plays_ball(&self) -> bool {
        self.role == Role::Striker || self.is_clearing
    }

    /// Time that the robot would take to the ball; `None` if ball or pose are not known.
    #[output(unit = "s")]
    #[must_use]
    pub const fn time_to_ball(&self) -> Option<f32> {
        self.time_to_ball
    }

    /// Number of the newest claim to the part of the striker that the robot knows.
    #[output]
    #[must_use]
    pub const fn claim(&self) -> u16 {
        self.election.claim()
    }
}

/// Returns a player that may be the striker.
fn candidate(Mate { message, .. }: &Mate) -> Option<Candidate> {
    let is_striker = message.role == Role::Striker;
    let plays = is_striker || matches!(message.role, Role::Supporter | Role::Defender);
    plays.then_some(Candidate {
        player: message.from.player,
        time: message.time_to_ball,
        is_striker,
        claim: message.claim,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn player_behind_the_ball_is_there_first() {
        let time = |x, y, heading| Reach::DEFAULT.time_to(&Pose2::new(x, y, heading), Vec2::ZERO);
        assert!((time(-1.0, 0.0, 0.0) - 5.0).abs() < 0.01);
        assert!(time(-1.0, 0.0, 1.5) > time(-1.0, 0.0, 0.0) + 2.0, "it turns");
        assert!(time(1.0, 0.0, 3.1) > time(-1.0, 0.0, 0.0) + 5.0, "it walks around the ball");
        assert!((time(-0.5, 0.5, 0.0) - time(-0.5, -0.5, 0.0)).abs() < 0.01);
    }
}

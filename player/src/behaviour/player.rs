//! The root: a forward that finds the ball, walks to it, looks for the goal and kicks.

use bica::prelude::*;
use bica_motion::kick::Kick;

use super::{Dribble, FaceBall, FallGuard, Fixmove, FollowBall, GoRound, SearchBall, SearchNet};
use crate::input::Measured;
use crate::motion::Body;
use crate::perception::{BallDetector, FallDetector, Localization, NetDetector, Odometry, RobotDetector};
use crate::strategy::{Plan, Situation, dribbles, plan};

/// The forward of RoboCup 2009.
#[derive(Debug)]
pub struct Player {
    plan: Plan,
    /// The kick that was given up just now, as something was in the way.
    in_vain: Option<Kick>,
}

#[component(hz = 20, budget_us = 20)]
impl Player {
    /// Starts in total uncertainty about the ball.
    #[must_use]
    pub const fn new() -> Self {
        Self { plan: Plan::GoRound(0.0), in_vain: None }
    }

    /// Looks around until the ball is seen.
    #[state(initial)]
    fn look_for_ball(&mut self, _search: &mut SearchBall) {}

    /// Walks to the ball, by the direction in which the head looks at it. Notes who stands there.
    #[state]
    fn approach(&mut self, _follow: &mut FollowBall, _robots: &RobotDetector) {}

    /// Stands at the ball and looks for the goal.
    #[state]
    fn search_net(&mut self, _search: &mut SearchNet, body: &mut Body) {
        body.stand();
    }

    /// Walks around the ball to face a goal that is behind.
    #[state]
    fn go_round(&mut self, round: &mut GoRound, _face: &mut FaceBall) {
        if let Plan::GoRound(angle) = self.plan {
            round.by(angle);
        }
    }

    /// Lines up and kicks, eyes on the ball.
    #[state]
    fn kick(&mut self, fixmove: &mut Fixmove, _face: &mut FaceBall) {
        if let Plan::Kick(kick) = self.plan {
            fixmove.play(kick);
        }
    }

    /// Kicks the ball on in the walk, eyes on it.
    #[state]
    fn dribble(&mut self, _dribble: &mut Dribble, _face: &mut FaceBall) {}

    /// Out of the game: stands.
    #[state]
    fn penalized(&mut self, body: &mut Body) {
        body.stand();
    }

    /// Down, or about to be: nothing else matters.
    #[state]
    fn fallen(&mut self, _guard: &mut FallGuard) {}

    #[transition(* -> fallen)]
    fn falls(&self, falls: &FallDetector) -> bool {
        !falls.upright()
    }

    #[transition(fallen -> look_for_ball)]
    fn stands_again(&self, guard: &FallGuard) -> bool {
        guard.upright()
    }

    #[transition(look_for_ball | approach | search_net | go_round | kick | dribble -> penalized)]
    fn sent_off(&self, body: &Measured) -> bool {
        !body.playing() && body.grounded()
    }

    #[transition(penalized -> look_for_ball)]
    fn let_in(&self, body: &Measured) -> bool {
        body.playing()
    }

    #[transition(look_for_ball -> approach)]
    fn ball_seen(&self, ball: &BallDetector) -> bool {
        ball.sure()
    }

    #[transition(approach -> look_for_ball)]
    fn ball_lost(&self, ball: &BallDetector) -> bool {
        ball.lost()
    }

    /// The eyes were on the goal before; they get time to find the ball again.
    #[transition(go_round | kick -> look_for_ball, after_ms = 1500)]
    fn ball_lost_again(&self, ball: &BallDetector) -> bool {
        ball.lost()
    }

    #[transition(approach -> dribble)]
    fn goal_far_ahead(&self, ball: &BallDetector, net: &NetDetector) -> bool {
        dribbles(ball, net)
    }

    #[transition(dribble -> approach)]
    fn ball_gone_on(&self, dribble: &Dribble) -> bool {
        dribble.done()
    }

    #[transition(approach -> search_net)]
    fn ball_reached(&self, follow: &FollowBall) -> bool {
        follow.reached()
    }

    #[transition(search_net -> look_for_ball)]
    fn nothing_known(&self, search: &SearchNet, ball: &BallDetector) -> bool {
        search.complete() && ball.at().is_none()
    }

    #[transition(search_net -> kick)]
    fn goal_in_reach(
        &self,
        search: &SearchNet,
        ball: &BallDetector,
        net: &NetDetector,
        field: &Localization,
        robots: &RobotDetector,
        body: &Measured,
    ) -> bool {
        let plan = || self.plan(Situation::of(ball, net, field, robots), body);
        search.complete() && matches!(plan(), Plan::Kick(_))
    }

    #[transition(search_net -> go_round)]
    fn goal_behind(&self, search: &SearchNet) -> bool {
        search.complete()
    }

    #[transition(go_round -> search_net)]
    fn went_round(&self, round: &GoRound) -> bool {
        round.done()
    }

    #[transition(kick -> approach)]
    fn ball_moved_away(&self, fixmove: &Fixmove) -> bool {
        fixmove.out_of_reach()
    }

    #[transition(kick -> look_for_ball)]
    fn kicked(&self, fixmove: &Fixmove) -> bool {
        fixmove.done()
    }

    /// Decides what to do with the ball.
    #[exit(search_net)]
    fn decide(
        &mut self,
        ball: &BallDetector,
        net: &NetDetector,
        field: &Localization,
        robots: &RobotDetector,
        odometry: &Odometry,
        body: &Measured,
    ) {
        self.plan = self.plan(Situation::of(ball, net, field, robots), body).seen_with(odometry.pose().heading);
    }

    /// Learns whether the kick was possible.
    #[exit(kick)]
    fn judge(&mut self, fixmove: &Fixmove) {
        self.in_vain = fixmove.gave_up();
    }

    fn plan(&self, situation: Option<Situation>, body: &Measured) -> Plan {
        situation.map_or(Plan::GoRound(0.0), |situation| plan(&situation, &body.profile().kicks, self.in_vain))
    }
}

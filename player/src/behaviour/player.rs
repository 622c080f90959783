//! The root: a forward that finds the ball, walks to it, finds the goal and kicks.

use bica::prelude::*;
use bica_motion::kick::Kick;

use super::{Dribble, FaceBall, Fixmove, FollowBall, GoRound, SafetyGuard, SearchBall, SearchNet};
use crate::input::{RobotProfile, RobotState};
use crate::roles::{Ball, Falls, Game, Goal, Health, Legs, Odometer, Place, Robots};
use crate::strategy::{Clearance, DribbleCondition, Plan, Planning, Situation, Strike, can_dribble, plan};

/// The forward of RoboCup 2009.
#[derive(Debug)]
pub struct Player {
    /// Plan of this run after a complete search for the goal, relative to the body: for the transitions that leave the search.
    decision: Option<Plan>,
    /// Last plan that was begun; headings in the frame of the odometry.
    plan: Option<Plan>,
    /// The last kick, if it was given up because the robot could not line up.
    last_failed_kick: Option<Kick>,
}

#[component(hz = 20, budget_us = 20)]
impl Player {
    /// Creates the component without a plan.
    #[must_use]
    pub const fn new() -> Self {
        Self { decision: None, plan: None, last_failed_kick: None }
    }

    /// Searches for the ball.
    #[state(initial)]
    fn look_for_ball(&mut self, _search: &mut SearchBall) {}

    /// Walks to the ball and remembers other robots on the way.
    #[state]
    fn approach(&mut self, _follow: &mut FollowBall, _robots: &impl Robots) {}

    /// Stands at the ball and searches for the goal.
    #[state]
    fn search_net(&mut self, _search: &mut SearchNet, body: &mut impl Legs) {
        body.stand();
    }

    /// Walks around the ball until the body faces the goal.
    #[state]
    fn go_round(&mut self, _round: &mut GoRound, _face: &mut FaceBall) {}

    /// Lines up and kicks while the head faces the ball.
    #[state]
    fn kick(&mut self, _fixmove: &mut Fixmove, _face: &mut FaceBall) {}

    /// Kicks the ball on while walking; the head faces the ball.
    #[state]
    fn dribble(&mut self, _dribble: &mut Dribble, _face: &mut FaceBall) {}

    /// Stands while the camera or the gyroscope has a fault, or the ball detector does not look.
    #[state]
    fn blind(&mut self, body: &mut impl Legs) {
        body.stand();
    }

    /// Stands while the robot is out of the game: sent off, or stopped by an operator.
    #[state]
    fn penalized(&mut self, body: &mut impl Legs) {
        body.stand();
    }

    /// After a fall or a fault: the safety guard controls the body.
    #[state]
    fn fallen(&mut self, _guard: &mut SafetyGuard) {}

    /// The robot falls or lies.
    #[transition(* -> fallen)]
    fn is_down(&self, falls: &impl Falls) -> bool {
        falls.is_down()
    }

    /// Whether a fault ends the current motion.
    #[transition(* -> fallen)]
    fn has_fault(&self, health: &impl Health) -> bool {
        health.must_stop()
    }

    #[transition(fallen -> look_for_ball)]
    fn stands_again(&self, guard: &SafetyGuard) -> bool {
        guard.stands()
    }

    #[transition(look_for_ball | approach | search_net | go_round | kick | dribble | blind -> penalized)]
    fn sent_off(&self, game: &impl Game, state: &RobotState) -> bool {
        !game.playing() && state.may_stop()
    }

    /// A robot that does not see does not walk. A kick ends on both feet before.
    #[transition(look_for_ball | approach | search_net | go_round | kick | dribble -> blind, after_ms = 200)]
    fn cannot_see(&self, health: &impl Health, ball: &impl Ball, state: &RobotState) -> bool {
        state.grounded() && (health.sense_fault().is_some() || !ball.is_looking())
    }

    #[transition(blind -> look_for_ball)]
    fn sees_again(&self, health: &impl Health, ball: &impl Ball) -> bool {
        health.sense_fault().is_none() && ball.is_looking()
    }

    #[transition(penalized -> look_for_ball)]
    fn let_in(&self, game: &impl Game) -> bool {
        game.playing()
    }

    #[transition(look_for_ball -> approach)]
    fn ball_seen(&self, ball: &impl Ball) -> bool {
        ball.is_confirmed()
    }

    #[transition(approach -> look_for_ball)]
    fn ball_lost(&self, ball: &impl Ball) -> bool {
        ball.is_lost()
    }

    /// The head faced the goal before, so the ball detector needs some time.
    #[transition(go_round | kick -> look_for_ball, after_ms = 1500)]
    fn ball_lost_again(&self, ball: &impl Ball) -> bool {
        ball.is_lost()
    }

    #[transition(approach -> dribble)]
    fn goal_far_ahead(&self, tuned: &Tuned<DribbleCondition>, ball: &impl Ball, goal: &impl Goal) -> bool {
        can_dribble(ball, goal, tuned)
    }

    #[transition(dribble -> approach)]
    fn ball_kicked_on(&self, dribble: &Dribble) -> bool {
        dribble.done()
    }

    #[transition(approach -> search_net)]
    fn ball_reached(&self, follow: &FollowBall) -> bool {
        follow.reached()
    }

    #[transition(search_net -> look_for_ball)]
    fn ball_unknown(&self, search: &SearchNet, ball: &impl Ball) -> bool {
        search.is_complete() && ball.position().is_none()
    }

    /// Plans when the search is complete.
    #[before(search_net)]
    fn decide(
        &mut self,
        tuned: &Tuned<Planning>,
        clearance: &Tuned<Clearance>,
        search: &SearchNet,
        ball: &impl Ball,
        goal: &impl Goal,
        field: &impl Place,
        robots: &impl Robots,
        profile: &RobotProfile,
    ) {
        let (kicks, failed) = (&profile.get().kicks, self.last_failed_kick);
        self.decision = search.is_complete().then(|| {
            Situation::of(ball, goal, field, robots, clearance)
                .map_or(Plan::GoRound(0.0), |situation| plan(&situation, kicks, failed, tuned, clearance))
        });
    }

    /// A kick with a small turn is possible.
    #[transition(search_net -> kick)]
    fn goal_in_reach(&self) -> Option<Strike> {
        self.decision.and_then(Plan::kick)
    }

    /// The turn around the ball, rad to the left.
    #[transition(search_net -> go_round)]
    fn goal_behind(&self) -> Option<f32> {
        self.decision.and_then(Plan::turn)
    }

    #[transition(go_round -> search_net)]
    fn went_round(&self, round: &GoRound) -> bool {
        round.done()
    }

    /// A full circle takes 14 s: something is in the way, or the turn is not measured.
    #[transition(go_round -> search_net, after_ms = 25000)]
    fn cannot_go_round(&self) -> bool {
        true
    }

    #[transition(kick -> approach)]
    fn ball_moved_away(&self, fixmove: &Fixmove) -> bool {
        fixmove.out_of_reach()
    }

    #[transition(kick -> look_for_ball)]
    fn kicked(&self, fixmove: &Fixmove) -> bool {
        fixmove.done()
    }

    #[entry(kick)]
    fn begin_kick(&mut self, Found(strike): Found<Strike>, odometry: &impl Odometer, fixmove: &mut Fixmove) {
        let strike = strike.in_frame(odometry.pose().heading);
        self.plan = Some(Plan::Kick(strike));
        fixmove.play(strike);
    }

    #[entry(go_round)]
    fn begin_turn(&mut self, Found(angle): Found<f32>, round: &mut GoRound) {
        self.plan = Some(Plan::GoRound(angle));
        round.turn_by(angle);
    }

    #[exit(kick)]
    fn keep_failed_kick(&mut self, fixmove: &Fixmove) {
        self.last_failed_kick = fixmove.failed_kick();
    }

    /// The last plan at the ball: a kick with its heading in the frame of the odometry, or a turn around the ball.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn plan(&self) -> Option<Plan> {
        self.plan
    }

    /// The last kick, if it was given up because the robot could not line up.
    #[output]
    #[must_use]
    pub const fn last_failed_kick(&self) -> Option<Kick> {
        self.last_failed_kick
    }
}

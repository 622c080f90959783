//! The goalkeeper, drawn with VICODE: `docs/goalkeeper.md`.

use bica::prelude::*;
use bica_motion::kick::{Kick, KickKind};
use bica_motion::side::Side;
use bica_player::behaviour::{FaceBall, Fixmove, FollowBall, SafetyGuard, SearchBall};
use bica_player::input::{GameState, RobotState};
use bica_player::motion::{Body, SideChoice};
use bica_player::perception::{BallDetector, FallDetector, Odometry};
use bica_player::referee::FieldPose;
use bica_player::strategy::Strike;

use crate::skills::{BallPath, Dive, GuardPost};

/// Stands in the goal, watches the ball, blocks it and kicks it away.
#[derive(Debug)]
pub struct Goalkeeper;

#[component(hz = 50, budget_us = 20)]
impl Goalkeeper {
    /// Creates the component.
    #[must_use]
    pub const fn new() -> Self {
        Self
    }

    /// Searches for the ball.
    #[state(initial)]
    fn look_for_ball(&mut self, _search: &mut SearchBall) {}

    /// Stands between ball and goal and watches the ball.
    #[state]
    fn watch(&mut self, _post: &mut GuardPost, _face: &mut FaceBall, _path: &BallPath) {}

    /// Steps into the way of the ball.
    #[state]
    fn step_aside(&mut self, path: &BallPath, body: &mut Body, _face: &mut FaceBall) {
        if let Some(crossing) = path.crossing() {
            body.walk(0.0, 0.12_f32.copysign(crossing.aside), 0.0);
        }
    }

    /// Falls into the way of the ball.
    #[state]
    fn dive(&mut self, path: &BallPath, dive: &mut Dive) {
        if let Some(crossing) = path.crossing() {
            dive.fall(if crossing.aside > 0.0 { SideChoice::Left } else { SideChoice::Right });
        }
    }

    /// Gets up after a fall.
    #[state]
    fn get_up(&mut self, _guard: &mut SafetyGuard) {}

    /// Walks to a ball that rests near the goal.
    #[state]
    fn walk_to_ball(&mut self, _follow: &mut FollowBall, _path: &BallPath) {}

    /// Kicks the ball away from the goal.
    #[state]
    fn kick_away(
        &mut self,
        fixmove: &mut Fixmove,
        _face: &mut FaceBall,
        ball: &BallDetector,
        field: &FieldPose,
        odometry: &Odometry,
    ) {
        if fixmove.requested().is_none() {
            let foot = if ball.position().is_some_and(|ball| ball.y > 0.0) { Side::Left } else { Side::Right };
            let heading = field.pose().map_or(0.0, |pose| pose.heading);
            // Not more than 0.8 rad (46°) from straight ahead, in the frame of the odometry.
            let heading = odometry.pose().heading + heading.clamp(-0.8, 0.8) - heading;
            fixmove.play(Strike { kick: Kick { kind: KickKind::Front, foot }, heading });
        }
    }

    /// Walks back to its place.
    #[state]
    fn go_back(&mut self, _post: &mut GuardPost, _face: &mut FaceBall) {}

    /// Stands while the robot is out of the game: sent off, or stopped by an operator.
    #[state]
    fn out(&mut self, body: &mut Body) {
        body.stand();
    }

    #[transition(look_for_ball | watch | step_aside | walk_to_ball | kick_away | go_back | out -> get_up)]
    fn is_down(&self, falls: &FallDetector) -> bool {
        falls.is_down()
    }

    #[transition(get_up -> look_for_ball)]
    fn stands_again(&self, guard: &SafetyGuard) -> bool {
        guard.stands()
    }

    #[transition(look_for_ball | watch | step_aside | walk_to_ball | kick_away | go_back -> out)]
    fn sent_off(&self, game: &GameState, state: &RobotState) -> bool {
        !game.playing() && state.may_stop()
    }

    #[transition(out -> look_for_ball)]
    fn let_in(&self, game: &GameState) -> bool {
        game.playing()
    }

    #[transition(look_for_ball -> watch)]
    fn ball_seen(&self, ball: &BallDetector) -> bool {
        ball.is_confirmed()
    }

    #[transition(watch | walk_to_ball -> look_for_ball, after_ms = 1000)]
    fn ball_lost(&self, ball: &BallDetector) -> bool {
        ball.is_lost()
    }

    /// The feet cannot be there in time: they cover 0.14 m, and steps add 0.08 m in a second.
    #[transition(watch | step_aside | go_back -> dive)]
    fn ball_passes_far(&self, path: &BallPath) -> bool {
        path.crossing().is_some_and(|crossing| {
            crossing.seconds < 0.9 && crossing.aside.abs() > 0.14 + 0.08 * (crossing.seconds - 0.3).max(0.0)
        })
    }

    #[transition(watch | go_back -> step_aside)]
    fn ball_passes_near(&self, path: &BallPath) -> bool {
        path.crossing().is_some_and(|crossing| crossing.aside.abs() > 0.05)
    }

    #[transition(step_aside -> watch)]
    fn in_the_way(&self, path: &BallPath) -> bool {
        path.crossing().is_none_or(|crossing| crossing.aside.abs() < 0.02)
    }

    #[transition(dive -> get_up, after_ms = 1500)]
    fn lies(&self) -> bool {
        true
    }

    #[transition(watch -> walk_to_ball, after_ms = 1000)]
    fn ball_near(&self, ball: &BallDetector, path: &BallPath) -> bool {
        path.rests() && ball.position().is_some_and(|ball| ball.length() < 0.9)
    }

    #[transition(walk_to_ball -> go_back)]
    fn ball_far(&self, ball: &BallDetector) -> bool {
        ball.position().is_some_and(|ball| ball.length() > 1.3)
    }

    #[transition(walk_to_ball -> kick_away)]
    fn ball_reached(&self, follow: &FollowBall) -> bool {
        follow.reached()
    }

    #[transition(kick_away -> go_back)]
    fn kicked(&self, fixmove: &Fixmove) -> bool {
        fixmove.done() || fixmove.out_of_reach()
    }

    #[transition(go_back -> watch, after_ms = 1000)]
    fn is_back(&self, post: &GuardPost) -> bool {
        post.arrived()
    }
}

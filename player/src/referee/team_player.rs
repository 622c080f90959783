//! The root: a player that a referee commands.

use bica::prelude::*;
use bica_motion::pose::Pose2;

use super::{FieldPose, GameController, GoTo, Order, Reporter};
use crate::FIELD;
use crate::behaviour::{LookAround, SafetyGuard};
use crate::input::{HealthMonitor, RobotState};
use crate::motion::{Body, Head};
use crate::perception::{FallDetector, Localization};
use crate::team::{TeamComm, TeamPlay};

/// Distance from the lines within which a player that is let in again begins to play, m.
const INSIDE: f32 = 0.4;

/// Follows the referee: stands, walks to its place, or plays its part in the team.
///
/// After a fall or a fault, the safety guard controls the body in all states in which the robot may move. A penalized robot keeps its
/// posture, since people may carry it.
#[derive(Debug)]
pub struct TeamPlayer;

#[component(hz = 50, budget_us = 10)]
impl TeamPlayer {
    /// Creates the component.
    #[must_use]
    pub const fn new() -> Self {
        Self
    }

    /// Before a half, in a time-out, and before the first packet: stands, with the head ahead.
    #[state(initial)]
    fn initial(&mut self, _report: &Reporter, _comm: &TeamComm, body: &mut Body, head: &mut Head) {
        body.stand();
        head.look_at(0.0, 0.0);
    }

    /// Walks to its place, and looks around.
    #[state]
    fn ready(
        &mut self,
        _report: &Reporter,
        _comm: &TeamComm,
        game: &GameController,
        go: &mut GoTo,
        _look: &mut LookAround,
    ) {
        if let Some(place) = game.place() {
            go.to(place);
        }
    }

    /// Stands and looks around. The game may have begun, but the robot moves only after the whistle or when playing is shown.
    #[state]
    fn set(&mut self, _report: &Reporter, _comm: &TeamComm, body: &mut Body, _look: &mut LookAround) {
        body.stand();
    }

    /// Plays its part in the team.
    #[state]
    fn playing(&mut self, _report: &Reporter, _comm: &TeamComm, _play: &mut TeamPlay) {}

    /// Stands and looks around until the other team's kick-off is over.
    #[state]
    fn wait(&mut self, _report: &Reporter, _comm: &TeamComm, body: &mut Body, _look: &mut LookAround) {
        body.stand();
    }

    /// The game is stopped: stands.
    #[state]
    fn stopped(&mut self, _report: &Reporter, _comm: &TeamComm, body: &mut Body, _head: &mut Head) {
        body.stand();
    }

    /// Penalized, by the referee, the chest button or an operator: stands, with the head ahead.
    #[state]
    fn penalized(
        &mut self,
        _report: &Reporter,
        _comm: &TeamComm,
        body: &mut Body,
        head: &mut Head,
        field: &mut FieldPose,
    ) {
        body.stand();
        head.look_at(0.0, 0.0);
        field.forget();
    }

    /// People may have carried the robot to another place.
    #[exit(penalized)]
    fn lose_place(&mut self, localization: &mut Localization, field: &mut FieldPose) {
        localization.forget();
        field.forget();
    }

    /// After a penalty: finds its pose at the side line and walks onto the field.
    #[state]
    fn enter(
        &mut self,
        _report: &Reporter,
        _comm: &TeamComm,
        field: &FieldPose,
        go: &mut GoTo,
        _look: &mut LookAround,
    ) {
        if let Some(pose) = field.pose() {
            go.to(inside(pose));
        }
    }

    /// After a half: stands, with the head ahead.
    #[state]
    fn finished(&mut self, _report: &Reporter, _comm: &TeamComm, body: &mut Body, head: &mut Head) {
        body.stand();
        head.look_at(0.0, 0.0);
    }

    /// After a fall or a fault: the safety guard controls the body.
    #[state]
    fn fallen(&mut self, _report: &Reporter, _comm: &TeamComm, _guard: &mut SafetyGuard) {}

    /// The robot falls or lies, and may move.
    #[transition(ready | playing | wait | enter -> fallen)]
    fn is_down(&self, falls: &FallDetector) -> bool {
        falls.is_down()
    }

    /// Whether a fault ends the current motion.
    #[transition(* -> fallen)]
    fn has_fault(&self, health: &HealthMonitor) -> bool {
        health.must_stop()
    }

    #[transition(fallen -> initial)]
    fn stands_again(&self, guard: &SafetyGuard) -> bool {
        guard.stands()
    }

    /// A step or a kick ends on both feet before.
    #[transition(ready | set | playing | wait | stopped | penalized | enter | finished -> initial)]
    fn ordered_initial(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Initial && state.may_stop()
    }

    #[transition(initial | set | playing | wait | stopped | penalized | enter | finished -> ready)]
    fn ordered_ready(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Ready && state.may_stop()
    }

    #[transition(initial | ready | playing | wait | stopped | penalized | enter | finished -> set)]
    fn ordered_set(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Set && state.may_stop()
    }

    #[transition(initial | ready | set | playing | stopped | penalized | enter | finished -> wait)]
    fn ordered_wait(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Wait && state.may_stop()
    }

    #[transition(initial | ready | set | playing | wait | penalized | enter | finished -> stopped)]
    fn ordered_stopped(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Stopped && state.may_stop()
    }

    #[transition(initial | ready | set | playing | wait | stopped | enter | finished -> penalized)]
    fn ordered_penalized(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Penalized && state.may_stop()
    }

    #[transition(initial | ready | set | playing | wait | stopped | penalized | enter -> finished)]
    fn ordered_finished(&self, game: &GameController, state: &RobotState) -> bool {
        game.order() == Order::Finished && state.may_stop()
    }

    #[transition(initial | ready | set | wait | stopped | finished -> playing)]
    fn ordered_playing(&self, game: &GameController) -> bool {
        game.order() == Order::Playing
    }

    #[transition(penalized -> enter)]
    fn let_in(&self, game: &GameController) -> bool {
        game.order() == Order::Playing
    }

    #[transition(enter -> playing)]
    fn is_inside(&self, go: &GoTo) -> bool {
        go.arrived()
    }

    /// Its pose is unknown, or something is in the way: it plays from where it is.
    #[transition(enter -> playing, after_ms = 10000)]
    fn cannot_enter(&self) -> bool {
        true
    }
}

/// Returns the nearest pose on the field that is not at a line, with the same heading.
fn inside(pose: Pose2) -> Pose2 {
    let most = FIELD.field_corner() - INSIDE;
    Pose2 { position: pose.position.clamp(-most, most), ..pose }
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;

    #[test]
    fn player_enters_by_the_shortest_way() {
        let corner = FIELD.field_corner();
        let at_line = Pose2::new(-1.5, corner.y, -1.5);
        assert_eq!(inside(at_line).position, Vec2::new(-1.5, corner.y - INSIDE));
        assert_eq!(inside(Pose2::ORIGIN), Pose2::ORIGIN);
    }
}

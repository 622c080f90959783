//! Robots of a match, and where they are at its start.

use core::f32::consts::FRAC_PI_2;

use bica_app::Failure;
use bica_field::FIELD;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_player::referee::Identity;
use bica_sim::match_field::{Entrant, MatchField};
use bica_sim::setup::Setup;

use crate::cli::{Play, World};

/// Distance of the players from the side line at the start, and between two of them, m.
const START: [f32; 2] = [0.1, 0.5];
/// Position of the goalkeeper of an idle team, and distance of its other players from the halfway line, m.
const IDLE: [f32; 2] = [-2.8, 1.25];
/// Distance of two players of an idle team, m.
const IDLE_APART: f32 = 0.7;

/// Players of both teams.
pub(super) fn identities(teams: [u8; 2], players: u8) -> Vec<Identity> {
    teams.into_iter().flat_map(|team| (1..=players).map(move |player| Identity { team, player })).collect()
}

/// Whether the match is played in MuJoCo.
pub(super) fn is_dynamic(args: &Play) -> bool {
    args.world.kind == World::Mujoco
}

/// Builds the field with its robots; those of an idle second team stand before their goal.
///
/// # Errors
/// If a robot has no room.
pub(super) fn field(args: &Play, seed: u64, players: &[Identity]) -> Result<MatchField, Failure> {
    let setup = Setup { seed, frame: args.size, ..Setup::default() };
    let first = players.first().map_or(0, |me| me.team);
    let entrant = |me: &Identity| {
        let is_second = me.team != first;
        let at = if is_second && args.referee.idle { idle(me.player) } else { at_side_line(me.player) };
        Entrant { is_second, at }
    };
    let entrants: Vec<Entrant> = players.iter().map(entrant).collect();
    #[cfg(feature = "mujoco")]
    if is_dynamic(args) {
        let built = MatchField::in_mujoco(NAO, &setup, &entrants);
        return built.map_err(|error| Failure::new(error.to_string(), "give fewer --players, and see docs/mujoco.md"));
    }
    MatchField::new(NAO, &setup, &entrants).map_err(|error| Failure::new(error.to_string(), "give fewer --players"))
}

/// Start of a player at the side line of its own half, facing the field.
fn at_side_line(player: u8) -> Pose2 {
    let [from_line, apart] = START;
    Pose2::new(apart * f32::from(player) - FIELD.field_corner().x, FIELD.field_corner().y - from_line, -FRAC_PI_2)
}

/// Pose of a player that does not play: the first one in the goal, the others on both sides of the circle.
fn idle(player: u8) -> Pose2 {
    let column = f32::from(player / 2) * if player.is_multiple_of(2) { -1.0 } else { 1.0 };
    let [goal, front] = IDLE;
    if player == 1 { Pose2::new(goal, 0.0, 0.0) } else { Pose2::new(-front, column * IDLE_APART, 0.0) }
}

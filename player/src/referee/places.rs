//! Places of the players before a kick-off.

use bica_motion::pose::Pose2;
use glam::Vec2;

use super::Identity;
use super::packet::{Control, Penalty, SetPlay, Team};
use crate::FIELD;

/// Distance of the player that kicks off from the centre mark, m.
const AT_BALL: f32 = 0.45;
/// Distance of the goalkeeper from its goal line, m.
const AT_GOAL: f32 = 0.2;
/// Distance of the foremost row from the centre circle, m: the localization may be wrong by half of it.
const FROM_CIRCLE: f32 = 0.5;
/// Distance of two rows, and of two players in a row, m.
const GRID: Vec2 = Vec2::new(0.4, 0.7);
/// Players of a row, by their distance to the left in units of the grid.
const COLUMNS: [f32; 5] = [0.0, 1.0, -1.0, 2.0, -2.0];

/// Returns the place of a player before a kick-off or a penalty kick, field frame: in the own half, facing the other goal. The first
/// player without a penalty takes the own kick-off, the goalkeeper only if it is alone. The others stand outside the centre circle.
pub(super) fn at_kick_off(control: &Control, own: usize, me: Identity) -> Pose2 {
    let team = &control.teams[own];
    let kicks_off = control.kicking_team == Some(me.team) && control.set_play != SetPlay::PenaltyKick;
    let position = if kicks_off && taker(team) == Some(me.player) {
        Vec2::new(-AT_BALL, 0.0)
    } else if me.player == team.goalkeeper {
        Vec2::new(AT_GOAL - FIELD.field_corner().x, 0.0)
    } else {
        let index = usize::from(me.player.saturating_sub(1));
        let (row, column) = ((index / COLUMNS.len()) as f32, COLUMNS[index % COLUMNS.len()]);
        let front = FIELD.centre_circle_radius() + FROM_CIRCLE;
        Vec2::new(-front, 0.0) - GRID * Vec2::new(row, column)
    };
    Pose2 { position, heading: 0.0 }
}

/// Number of the player that takes the own kick-off; `None` if all are penalized.
pub(super) fn taker(team: &Team) -> Option<u8> {
    let players = || (1..).zip(&team.players).filter(|(_, player)| player.penalty == Penalty::None);
    let field = players().find(|(number, _)| *number != team.goalkeeper).or_else(|| players().next());
    field.map(|(number, _)| number)
}

/// Number of players that take the own kick-off rather than a player of the field; `None` for others, and with a penalty.
pub(super) fn turn(team: &Team, player: u8) -> Option<usize> {
    let is_keeper = |number: u8| number == team.goalkeeper && taker(team) != Some(number);
    let fit =
        (1..).zip(&team.players).filter(|(number, player)| player.penalty == Penalty::None && !is_keeper(*number));
    fit.map(|(number, _)| number).position(|number| number == player)
}

#[cfg(test)]
mod tests {
    use super::super::packet::PLAYERS;
    use super::*;

    fn control(kicking: u8) -> Control {
        let teams = [5, 23].map(|number| Team { number, goalkeeper: 1, ..Team::default() });
        Control { teams, kicking_team: Some(kicking), ..Control::default() }
    }

    fn places(control: &Control) -> [Vec2; PLAYERS] {
        core::array::from_fn(|index| at_kick_off(control, 1, Identity { team: 23, player: index as u8 + 1 }).position)
    }

    #[test]
    fn all_places_are_apart_in_the_own_half() {
        for kicking in [5, 23] {
            let places = places(&control(kicking));
            for (index, place) in places.iter().enumerate() {
                let corner = FIELD.field_corner();
                assert!(place.x < -0.3 && place.x > 0.1 - corner.x && place.y.abs() < corner.y - 0.3, "{place}");
                let is_outside = place.length() > FIELD.centre_circle_radius() + 0.3;
                assert_eq!(is_outside, kicking != 23 || index != 1, "player {}", index + 1);
                let apart = places[..index].iter().all(|other| other.distance(*place) > 0.35);
                assert!(apart, "player {} at {place}", index + 1);
            }
        }
    }

    #[test]
    fn first_field_player_without_penalty_kicks_off() {
        let mut control = control(23);
        let is_at_ball = |control: &Control, player: usize| places(control)[player - 1].x.abs() < 0.5;
        assert!(is_at_ball(&control, 2));
        control.teams[1].players[1].penalty = Penalty::SentOff;
        assert!(is_at_ball(&control, 3) && !is_at_ball(&control, 2));
        control.teams[1].players.iter_mut().skip(1).for_each(|player| player.penalty = Penalty::Substitute);
        assert!(is_at_ball(&control, 1), "the goalkeeper is alone");
        assert!(!is_at_ball(&Control { set_play: SetPlay::PenaltyKick, ..control }, 1));
    }
}

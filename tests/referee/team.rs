//! Short halves of a team of three in the kinematic world, against a team that stands.

use bica_player::referee::packet::Penalty;
use bica_player::team::Role;
use bica_sim::referee::Event;

use super::game::{Match, PLAYERS, TEAMS};

/// Cycles of the play.
const CYCLES: u32 = 6000;

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_team_of_three_plays_with_one_striker() {
    let mut game = Match::against_idle(4);
    game.kick_off();
    let (mut one, mut keeper_moved) = (0, 0.0_f32);
    let goal = game.pose(0).position;
    let mut out = None;
    for cycle in 0..CYCLES {
        // The striker is penalized, and let in again.
        if cycle == CYCLES / 3 {
            out = game.players.iter().position(|player| player.role() == Role::Striker);
        }
        let is_out = (CYCLES / 3..CYCLES / 2).contains(&cycle);
        if let Some(player) = out {
            game.sender.team(TEAMS[0]).players[player].penalty = if is_out { Penalty::Pushing } else { Penalty::None };
        }
        game.cycle();
        one += u32::from(game.strikers() == 1);
        keeper_moved = keeper_moved.max(game.pose(0).position.distance(goal));
    }
    assert!(out.is_some());
    let share = one as f32 / CYCLES as f32;
    let is_kick = |event: &Event| matches!(event, Event::Kick { .. });
    let kicks: usize = (0..PLAYERS).map(|index| game.field.truth(index).count(is_kick)).sum();
    assert!(share >= 0.95, "{share} of the time with one striker");
    assert!(kicks > 0 && game.field.score()[1] == 0);
    assert_eq!(game.players[0].role(), Role::Goalkeeper);
    assert!(keeper_moved < 1.5, "the goalkeeper has left its goal by {keeper_moved} m");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_killed_players_return_within_ten_seconds() {
    let mut game = Match::against_idle(6);
    game.kick_off();
    game.run(5);
    for role in [Role::Striker, Role::Goalkeeper, Role::Supporter, Role::Defender] {
        let Some(killed) = game.players.iter().position(|player| player.role() == role) else { continue };
        game.players[killed].runs = false;
        let without = game.settles_within(10);
        assert!(without.is_some(), "the others have no striker without the {role:?}");
        game.run(5);
        assert_eq!(game.strikers(), 1, "without the {role:?}");
        game.restart(killed);
        let after = game.settles_within(10);
        assert!(after.is_some(), "the {role:?} has no part");
        game.run(2);
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_players_join_and_leave_a_match() {
    let mut game = Match::against_idle(7);
    game.sender.team(TEAMS[0]).players[2].penalty = Penalty::Substitute;
    game.kick_off();
    game.run(5);
    assert_eq!((game.strikers(), game.players[2].role()), (1, Role::Absent), "player 3 is a substitute");
    game.sender.team(TEAMS[0]).players[2].penalty = Penalty::None;
    assert!(game.settles_within(10).is_some(), "player 3 has no part");
    game.sender.team(TEAMS[0]).players[1].penalty = Penalty::Substitute;
    game.run(3);
    assert_eq!((game.players[1].role(), game.players[2].role()), (Role::Absent, Role::Striker));
}

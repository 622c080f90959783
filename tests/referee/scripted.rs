//! Scripted half of two teams of three, with a small budget of messages.

use bica_motion::pose::{Pose2, wrap};
use bica_player::FIELD;
use bica_player::referee::packet::{Penalty, PlayState, Version};

use super::game::{Match, PLAYERS, TEAMS};

const EVERYBODY: core::ops::Range<usize> = 0..2 * PLAYERS;

impl Match {
    fn poses(&self) -> Vec<Pose2> {
        EVERYBODY.map(|player| self.pose(player)).collect()
    }

    fn begin(&mut self, state: PlayState, seconds: i16) {
        (self.sender.control.state, self.sender.control.secondary_seconds) = (state, seconds);
    }

    /// Checks that some players stand from 2.5 s after the last command on.
    fn stands(&mut self, state: &str, players: impl Iterator<Item = usize>) {
        let players: Vec<usize> = players.collect();
        for _ in 0..250 {
            self.cycle();
        }
        let before = self.poses();
        for _ in 0..400 {
            self.cycle();
            for &player in &players {
                let (was, now) = (before[player], self.pose(player));
                assert_eq!(self.players[player].state(), state, "robot {player}");
                assert!(was.position.distance(now.position) < 0.05, "{state}: robot {player} from {was:?} to {now:?}");
                assert!(wrap(now.heading - was.heading).abs() < 0.25, "{state}: robot {player} turns");
            }
        }
    }

    /// Checks that a player of each of some teams walks within 20 s.
    fn moves(&mut self, teams: impl Iterator<Item = usize>) {
        let before = self.poses();
        for team in teams {
            let moved = |game: &Self, player: usize| before[player].position.distance(game.pose(player).position) > 0.1;
            let of_team = PLAYERS * team..PLAYERS * (team + 1);
            let moves = (0..2000).any(|_| {
                self.cycle();
                of_team.clone().any(|player| moved(self, player))
            });
            assert!(moves, "team {} stands", TEAMS[team]);
        }
    }

    /// Plays the state ready, with the kick-off of a team; the other one is outside the circle at its end.
    fn places(&mut self, kicking: usize) {
        self.ready(TEAMS[kicking]);
        let other = PLAYERS * (1 - kicking)..PLAYERS * (2 - kicking);
        for at in other.map(|player| self.pose(player).position) {
            assert!(at.length() > FIELD.centre_circle_radius(), "{at} is in the circle");
        }
    }
}

fn half(version: Version, budgets: [u16; 2]) {
    let mut game = Match::of_both(2, version, 0);
    for (team, budget) in TEAMS.into_iter().zip(budgets) {
        game.sender.team(team).message_budget = budget;
    }
    game.run(1);
    game.stands("initial", EVERYBODY);
    game.places(0);
    game.begin(PlayState::Set, 0);
    game.stands("set", EVERYBODY);
    game.begin(PlayState::Playing, 10);
    game.stands("wait", PLAYERS..2 * PLAYERS);
    game.begin(PlayState::Playing, 0);
    game.moves(0..2);
    game.sender.control.stopped = true;
    game.stands("stopped", EVERYBODY);
    game.sender.control.stopped = false;
    let out = 1;
    game.sender.team(TEAMS[0]).players[out].penalty = Penalty::Pushing;
    let side_line = [1.9_f32, -1.9].map(|y| Pose2::new(-1.5, y, -1.57_f32.copysign(y)));
    assert!(side_line.into_iter().any(|at| game.field.put_robot(out, at).is_ok()), "there is room");
    game.stands("penalized", out..=out);
    game.sender.team(TEAMS[0]).players[out].penalty = Penalty::None;
    game.places(1);
    game.begin(PlayState::Finished, 0);
    game.stands("finished", EVERYBODY);
    for (player, budget) in game.players.iter().zip(budgets.into_iter().flat_map(|budget| [budget; PLAYERS])) {
        let (answers, me) = (&player.answers, player.me);
        assert!(answers.windows(2).all(|pair| (50..=200).contains(&(pair[1] - pair[0]))), "{me:?}: {answers:?}");
        assert!(answers.first().is_some_and(|first| *first < 150), "{me:?}: {answers:?}");
        assert!(answers.last().is_some_and(|last| game.cycle - last < 200), "{me:?}: {answers:?}");
        // Messages of a team without a budget would have ended the test.
        let left = game.sender.control.teams.iter().find(|team| team.number == me.team).map(|team| team.message_budget);
        assert!(left.is_some_and(|left| left < budget.max(1)), "{me:?} has sent nothing: {left:?}");
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_half_of_two_teams_by_version_nineteen() {
    half(Version::V19, [100, 0]);
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_half_of_two_teams_by_version_twenty() {
    half(Version::V20, [0, 100]);
}

//! People at the field: they see fouls, and carry players that are penalized to the side line.

use bica::Tree;
use bica_player::referee::GameController;
use bica_player::referee::packet::Penalty;

use super::fouls::{Fouls, Seen, return_pose};
use super::player::Network;
use super::teams::Teams;

/// Assistant referees of a match.
#[derive(Default)]
pub(super) struct Assistants {
    fouls: Fouls,
    /// Whether each player was carried to the side line since it was penalized.
    is_outside: Vec<bool>,
    /// Number of players that were carried to the side line.
    pub(super) carried: u32,
}

impl Assistants {
    /// Carries each player that is penalized to the side line of its own half, as soon as there is room.
    pub(super) fn carry<N: Network>(&mut self, teams: &mut Teams<N>) {
        self.is_outside.resize(teams.players.len(), false);
        for (index, is_outside) in self.is_outside.iter_mut().enumerate() {
            let is_due = is_penalized(teams, index) && !*is_outside;
            *is_outside &= is_penalized(teams, index);
            let truth = teams.field.truth(index);
            let others = truth.others().iter().map(|other| other.position);
            if let Some(at) = return_pose(truth.ball(), &others).filter(|_| is_due) {
                *is_outside = teams.field.put_robot(index, at).is_ok();
                self.carried += u32::from(*is_outside);
            }
        }
    }

    /// Looks at a cycle of the state playing; returns the index of a player that must leave the field, and why.
    pub(super) fn judge<N: Network>(&mut self, teams: &Teams<N>) -> Option<(usize, Penalty)> {
        let seen = |robot: usize| Seen {
            is_second: teams.field.is_second(robot),
            pose: teams.field.truth(robot).robot(),
            plays: !teams.field.is_down(robot) && (robot >= teams.players.len() || !is_penalized(teams, robot)),
        };
        let robots: Vec<Seen> = (0..teams.field.robots()).map(seen).collect();
        // Nobody penalizes a robot that has no player: it only stands.
        self.fouls.judge(&robots).filter(|(robot, _)| *robot < teams.players.len())
    }
}

fn is_penalized<N: Network>(teams: &Teams<N>, player: usize) -> bool {
    teams.players[player].forward().get::<GameController>().penalty() != Penalty::None
}

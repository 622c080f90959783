//! Players that answer to the referee.

use std::collections::BTreeMap;
use std::net::Ipv4Addr;

use bica_player::referee::packet::{BallReport, Status};

/// Time without a message after which a player counts as silent, s, as in the `GameController`.
const SILENT: f64 = 4.0;

/// A player that has answered.
struct Player {
    status: Status,
    address: Ipv4Addr,
    at: f64,
    is_silent: bool,
}

/// Players that have answered, by team and number.
pub(super) struct Players(BTreeMap<(u8, u8), Player>);

impl Players {
    pub(super) const fn new() -> Self {
        Self(BTreeMap::new())
    }

    /// Stores a message that arrived at time `at`, s; returns a line if the player was unknown or silent before.
    pub(super) fn take(&mut self, status: Status, address: Ipv4Addr, at: f64) -> Option<String> {
        let key = (status.team, status.player);
        let before = self.0.insert(key, Player { status, address, at, is_silent: false });
        before.is_none_or(|player| player.is_silent).then(|| format!("{} from {address}", name(key)))
    }

    /// Returns a line for each player that has become silent at a time, s.
    pub(super) fn silent(&mut self, now: f64) -> Vec<String> {
        let newly = self.0.iter_mut().filter(|(_, player)| !player.is_silent && now - player.at > SILENT);
        newly
            .map(|(key, player)| {
                player.is_silent = true;
                format!("{} is silent", name(*key))
            })
            .collect()
    }

    /// Number of the players that are not silent.
    pub(super) fn answering(&self) -> usize {
        self.0.values().filter(|player| !player.is_silent).count()
    }

    /// Returns a line for each player.
    pub(super) fn lines(&self, now: f64) -> Vec<String> {
        let line = |(key, player): (&(u8, u8), &Player)| {
            let Player { status: Status { fallen, pose: [x, y, heading], ball, .. }, address, at, .. } = player;
            let fallen = if *fallen { ", fallen" } else { "" };
            let ball = ball.map_or_else(
                || "no ball".to_owned(),
                |BallReport { age, at: [x, y] }| format!("ball at ({x:.2}, {y:.2}) m, {age:.1} s ago"),
            );
            let ago = now - at;
            format!(
                "{} from {address}, {ago:.1} s ago: ({x:.2}, {y:.2}) m, {heading:.2} rad{fallen}, {ball}",
                name(*key)
            )
        };
        self.0.iter().map(line).collect()
    }
}

fn name((team, player): (u8, u8)) -> String {
    format!("team {team} player {player}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_and_missing_messages_are_told_once() {
        let mut players = Players::new();
        let status = Status { team: 5, player: 2, ..Status::default() };
        let take = |players: &mut Players, at| players.take(status, Ipv4Addr::LOCALHOST, at);
        assert_eq!(take(&mut players, 1.0).as_deref(), Some("team 5 player 2 from 127.0.0.1"));
        assert_eq!(take(&mut players, 2.0), None);
        assert!(players.silent(5.9).is_empty());
        assert_eq!((players.silent(6.1).len(), players.silent(6.2).len()), (1, 0));
        assert!(take(&mut players, 7.0).is_some(), "it answers again");
        assert!(players.lines(8.0)[0].contains("1.0 s ago"));
    }
}

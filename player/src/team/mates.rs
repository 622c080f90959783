//! The other players of the team.

use bica::prelude::*;
use bica::visual::{self, List};

use super::message::{Heard, Role, TeamMessage};
use crate::referee::GameController;
use crate::referee::packet::{PLAYERS, Penalty};
use crate::shapes;

/// When a silent player counts as absent.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Silence {
    /// Number of its messages that were lost in a row, if it still plays: their interval is in each message.
    #[param(default = 4.0, range = 1.0..=20.0, step = 0.5)]
    pub lost_messages: f32,
    /// Longest silence of a player that is present.
    #[param(default = 300.0, range = 1.0..=600.0, unit = "s", step = 1.0)]
    pub longest: f32,
}

/// What is known of another player.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mate {
    /// Its newest message.
    pub message: TeamMessage,
    /// Time since the message has arrived, s.
    pub age: f32,
}

/// The newest message of each other player of the team. A player is absent while it is penalized, or after a silence.
#[derive(Debug)]
pub struct TeamMates {
    mates: [Option<Mate>; PLAYERS],
    messages: u32,
    refused: u32,
}

#[component(budget_us = 10)]
impl TeamMates {
    /// Creates the component before the first message.
    #[must_use]
    pub const fn new() -> Self {
        Self { mates: [None; PLAYERS], messages: 0, refused: 0 }
    }

    fn step(&mut self, tuned: &Tuned<Silence>, time: &Time, game: &GameController) {
        for (player, slot) in (1..).zip(&mut self.mates) {
            let Some(mate) = slot else { continue };
            mate.age += time.dt();
            let limit = (tuned.lost_messages * mate.message.interval).min(tuned.longest);
            if mate.age > limit || game.penalty_of(player) != Penalty::None {
                *slot = None;
            }
        }
    }

    /// Takes what the network has brought since the last cycle: a message, and the number of all refused datagrams so far.
    pub fn receive(&mut self, heard: Option<&Heard>, refused: u32) {
        self.refused = refused;
        let Some(Heard { message, .. }) = heard else { return };
        let index = usize::from(message.from.player).wrapping_sub(1);
        if let Some(slot) = self.mates.get_mut(index) {
            *slot = Some(Mate { message: *message, age: 0.0 });
            self.messages = self.messages.saturating_add(1);
        }
    }

    /// The players that are present, in the order of their numbers.
    pub fn present(&self) -> impl Iterator<Item = &Mate> + Clone {
        self.mates.iter().flatten()
    }

    /// Number of the other players that are present.
    #[output]
    #[must_use]
    pub fn count(&self) -> u32 {
        self.present().count() as u32
    }

    /// Number of the other players that are strikers.
    #[output]
    #[must_use]
    pub fn strikers(&self) -> u32 {
        self.present().filter(|mate| mate.message.role == Role::Striker).count() as u32
    }

    /// Positions of the players that are present.
    #[output(unit = "m", frame = "field")]
    fn positions(&self) -> List<visual::Point2, 8> {
        self.present().map(|mate| shapes::point(mate.message.pose().position)).collect()
    }

    /// Number of messages that have arrived.
    #[output]
    #[must_use]
    pub const fn messages(&self) -> u32 {
        self.messages
    }

    /// Number of refused datagrams.
    #[output]
    #[must_use]
    pub const fn refused(&self) -> u32 {
        self.refused
    }
}

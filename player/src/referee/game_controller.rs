//! The state of the game, as the `GameController` sends it.

use bica::prelude::*;

use super::packet::{Control, GamePhase, Penalty, PlayState, SetPlay, Team};
use super::places;
use super::{Identity, Order, Received};
use crate::input::GameState;
use crate::roles::Ears;
use bica_motion::pose::Pose2;

/// Time after the last packet from which on any packet is accepted: another `GameController` may have taken over. µs.
const SILENT_US: u64 = 2_000_000;
/// Largest difference of the number of a newer packet from that of the last one; beyond it, the packet is older.
const MAX_AHEAD: u8 = 127;

/// What the referee orders, by the packets of the `GameController`, the chest button and an operator's stop.
///
/// Until the first packet the robot waits for it, or for a press of the chest button, which starts a game without a network. From
/// then on each press penalizes the robot or lets it in again (rules of RoboCup 2009). The last packet stays in force while the
/// `GameController` is silent.
#[derive(Clone, Debug)]
pub struct GameController {
    me: Identity,
    newest: Option<Received>,
    /// Whether a packet was accepted since the last run.
    is_new: bool,
    /// Time since the last packet, s.
    silence: f32,
    ignored: u32,
    late: u32,
    other_source: u32,
    button: Button,
    /// Whether the whistle was heard since the state became set. The state playing is shown up to 10 s later.
    whistled: bool,
    order: Order,
}

/// Use of the chest button before the first packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Button {
    /// The next press starts the game.
    Starts,
    /// The press that has started the game lasts.
    Held,
    /// Presses are penalties.
    Penalizes,
}

#[component(budget_us = 5)]
impl GameController {
    /// Creates the component before the first packet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            me: Identity { team: 0, player: 1 },
            newest: None,
            is_new: false,
            silence: 0.0,
            ignored: 0,
            late: 0,
            other_source: 0,
            button: Button::Starts,
            whistled: false,
            order: Order::Initial,
        }
    }

    fn step(&mut self, time: &Time, game: &GameState, ears: &impl Ears) {
        self.silence = if core::mem::take(&mut self.is_new) { 0.0 } else { self.silence + time.dt() };
        self.whistled = self.state() == Some(PlayState::Set) && (self.whistled || ears.heard());
        self.order = self.decide(game.playing());
    }

    /// Takes what the network has brought since the last cycle: a packet, and the number of all other datagrams so far.
    pub fn receive(&mut self, me: Identity, packet: Option<&Received>, ignored: u32) {
        (self.me, self.ignored) = (me, ignored);
        let Some(packet) = packet else { return };
        let Some(newest) = &self.newest else { return self.accept(packet) };
        let age = packet.at_us.saturating_sub(newest.at_us);
        if age >= SILENT_US {
            self.accept(packet);
        } else if packet.source != newest.source {
            self.other_source = self.other_source.saturating_add(1);
        } else if packet.control.number.wrapping_sub(newest.control.number) > MAX_AHEAD {
            self.late = self.late.saturating_add(1);
        } else {
            self.accept(packet);
        }
    }

    fn accept(&mut self, packet: &Received) {
        self.newest = Some(*packet);
        self.is_new = true;
        if self.button == Button::Starts {
            self.button = Button::Penalizes;
        }
    }

    /// Takes the state of the chest button; returns the state that counts as a penalty: a press that starts a game does not.
    pub const fn take_button(&mut self, pressed: bool) -> bool {
        self.button = match self.button {
            Button::Starts if pressed => Button::Held,
            Button::Held if !pressed => Button::Penalizes,
            other => other,
        };
        pressed && matches!(self.button, Button::Penalizes)
    }

    fn decide(&self, is_in_game: bool) -> Order {
        let started = self.button != Button::Starts;
        match &self.newest {
            _ if !is_in_game => Order::Penalized,
            None if started => Order::Playing,
            None => Order::Initial,
            Some(_) if self.penalty() != Penalty::None => Order::Penalized,
            Some(Received { control, .. }) => order(control, self.me.team, self.whistled),
        }
    }

    /// What the player has to do now.
    #[output]
    #[must_use]
    pub const fn order(&self) -> Order {
        self.order
    }

    /// The newest packet; `None` before the first one.
    pub(crate) fn control(&self) -> Option<&Control> {
        self.newest.as_ref().map(|newest| &newest.control)
    }

    /// The own team and the other one.
    fn teams(&self) -> Option<[&Team; 2]> {
        let control = self.control()?;
        let own = control.index(self.me.team)?;
        Some([&control.teams[own], &control.teams[1 - own]])
    }

    /// Which player the robot is.
    #[output]
    #[must_use]
    pub const fn me(&self) -> Identity {
        self.me
    }

    /// Address of the `GameController`; `None` before the first packet.
    #[must_use]
    pub fn source(&self) -> Option<[u8; 4]> {
        self.newest.as_ref().map(|newest| newest.source)
    }

    /// Own place before a kick-off, field frame; `None` before the first packet.
    #[must_use]
    pub fn place(&self) -> Option<Pose2> {
        let control = self.control()?;
        Some(places::at_kick_off(control, control.index(self.me.team)?, self.me))
    }

    /// The state that the `GameController` shows; `None` before its first packet.
    #[output]
    #[must_use]
    pub fn state(&self) -> Option<PlayState> {
        self.control().map(|control| control.state)
    }

    /// The set play.
    #[output]
    #[must_use]
    pub fn set_play(&self) -> Option<SetPlay> {
        self.control().map(|control| control.set_play)
    }

    /// Number of the team that kicks.
    #[output]
    #[must_use]
    pub fn kicking_team(&self) -> Option<u8> {
        self.control()?.kicking_team
    }

    /// The own penalty.
    #[output]
    #[must_use]
    pub fn penalty(&self) -> Penalty {
        self.penalty_of(self.me.player)
    }

    /// The penalty of a player of the own team, whose numbers begin at 1.
    #[must_use]
    pub fn penalty_of(&self, player: u8) -> Penalty {
        let index = usize::from(player).wrapping_sub(1);
        let player = self.teams().and_then(|[own, _]| own.players.get(index));
        player.map_or(Penalty::None, |player| player.penalty)
    }

    /// Whether the robot is the goalkeeper. A goalkeeper whose field players are all penalized plays as one of them.
    #[output]
    #[must_use]
    pub fn is_goalkeeper(&self) -> bool {
        let me = self.me.player;
        self.teams().is_some_and(|[own, _]| own.goalkeeper == me && places::taker(own) != Some(me))
    }

    /// Number of players that take the own kick-off rather than the robot; `None` for the goalkeeper, and with a penalty.
    pub(crate) fn turn(&self) -> Option<usize> {
        self.teams().and_then(|[own, _]| places::turn(own, self.me.player))
    }

    /// Number of players of a team on the field; 0 before the first packet.
    #[must_use]
    pub fn players_on_field(&self) -> u32 {
        self.control().map_or(0, |control| control.players_per_team.into())
    }

    /// Remaining time of the half; negative in overtime.
    #[output(unit = "s")]
    #[must_use]
    pub fn seconds_remaining(&self) -> Option<i32> {
        self.control().map(|control| control.seconds_remaining.into())
    }

    /// Goals of the own team and of the other one.
    #[output]
    #[must_use]
    pub fn score(&self) -> Option<[u8; 2]> {
        self.teams().map(|teams| teams.map(|team| team.score))
    }

    /// Number of messages that the own team may still send.
    #[output]
    #[must_use]
    pub fn message_budget(&self) -> Option<u32> {
        self.teams().map(|[own, _]| own.message_budget.into())
    }

    /// Time since the last packet, or since the start.
    #[output(unit = "s")]
    #[must_use]
    pub const fn silence(&self) -> f32 {
        self.silence
    }

    /// Number of datagrams that are no control packets for the own team.
    #[output]
    #[must_use]
    pub const fn ignored(&self) -> u32 {
        self.ignored
    }

    /// Number of control packets that were older than the last one.
    #[output]
    #[must_use]
    pub const fn late(&self) -> u32 {
        self.late
    }

    /// Number of control packets from another sender than the one that commands.
    #[output]
    #[must_use]
    pub const fn other_source(&self) -> u32 {
        self.other_source
    }
}

/// What a packet orders a player of a team that is not penalized.
fn order(control: &Control, team: u8, whistle: bool) -> Order {
    let other_kicks = control.kicking_team.is_some_and(|kicking| kicking != team);
    let is_kick_off = control.set_play == SetPlay::None && control.secondary_seconds > 0;
    match control.state {
        PlayState::Finished => Order::Finished,
        _ if control.game_phase == GamePhase::TimeOut => Order::Initial,
        _ if control.stopped => Order::Stopped,
        PlayState::Initial => Order::Initial,
        PlayState::Ready => Order::Ready,
        PlayState::Set if whistle && other_kicks => Order::Wait,
        PlayState::Set if whistle => Order::Playing,
        PlayState::Set => Order::Set,
        PlayState::Playing if other_kicks && is_kick_off => Order::Wait,
        PlayState::Playing => Order::Playing,
    }
}

#[cfg(test)]
mod tests;

//! The referee as a tree of one component: its commands are modulations and the game is its outputs, so that a monitor shows a page of it.

use std::mem;

use bica::prelude::*;
use bica_player::referee::packet::{Control, PlayState, SetPlay, Team};

use super::command::{Command, PENALTIES};
use super::game::Game;
use super::players::Players;

/// Time since the start, s.
pub(super) fn seconds(now: Instant) -> f64 {
    now.as_micros() as f64 * 1e-6
}

/// Team of a command.
#[derive(Clone, Copy, Debug, ParamEnum, PartialEq, Eq)]
pub(super) enum Side {
    /// The first team of `--teams`.
    First,
    /// The second team of `--teams`.
    Second,
}

/// Penalty of a command, in the order of [`PENALTIES`]: [`Penalty`](bica_player::referee::packet::Penalty) has unknown numbers, too.
#[derive(Clone, Copy, Debug, ParamEnum, PartialEq, Eq)]
pub(super) enum Foul {
    /// The player may play again.
    None,
    /// It was where it must not be.
    IllegalPositioning,
    /// It moved in the state set.
    MotionInSet,
    /// It moved while the game was stopped; only in version 20.
    MotionInStop,
    /// The game was stuck near it.
    LocalGameStuck,
    /// It cannot play.
    Incapable,
    /// Its team asked to take it off the field.
    PickUp,
    /// It held the ball.
    BallHolding,
    /// It left the field.
    LeavingField,
    /// It touched the ball with an arm or a hand.
    ArmsOrHands,
    /// It pushed another robot.
    Pushing,
    /// It got a caution; only in version 20.
    Cautioned,
    /// It was sent off.
    SentOff,
    /// It is not on the field.
    Substitute,
}

/// A game, and the players that answer.
pub(super) struct Referee {
    /// The game, from its begin on, with the numbers of the teams in the order of `--teams`.
    game: Option<(Game, [u8; 2])>,
    pub(super) players: Players,
    /// What the last command did, and whether the program has printed it.
    answer: String,
    is_told: bool,
    now: f64,
    packet: Option<Control>,
}

#[component(hz = 100)]
impl Referee {
    const fn new() -> Self {
        Self { game: None, players: Players::new(), answer: String::new(), is_told: true, now: 0.0, packet: None }
    }

    /// Begins a game of two teams.
    pub(super) fn begin(&mut self, teams: [u8; 2], game: Game) {
        self.game = Some((game, teams));
    }

    /// Executes a command; the answer says what it did, or why it cannot be executed.
    pub(super) fn execute(&mut self, command: Command) {
        let Some((game, _)) = &mut self.game else { return };
        self.answer = game.execute(command).map_or_else(|what| what, |()| game.line());
        self.is_told = false;
    }

    /// Returns what the last command did, once.
    pub(super) fn take_answer(&mut self) -> Option<String> {
        (!mem::replace(&mut self.is_told, true)).then(|| self.answer.clone())
    }

    /// Counts a message of a team against its budget.
    pub(super) fn count_message(&mut self, team: u8) {
        if let Some((game, _)) = &mut self.game {
            game.count_message(team);
        }
    }

    fn side(&self, side: Side) -> u8 {
        self.game.as_ref().map_or(0, |(_, teams)| teams[side.index() as usize])
    }

    fn shown<V>(&self, value: impl Fn(&Control) -> V) -> Option<V> {
        self.game.as_ref().map(|(game, _)| value(game.control()))
    }

    fn of_teams<V: Copy + Default>(&self, value: impl Fn(&Team) -> V) -> Option<[V; 2]> {
        self.game.as_ref().map(|(game, teams)| game.of_teams(*teams, value))
    }

    /// Before a half, and in a time-out.
    #[modulation]
    fn initial(&mut self) {
        self.execute(Command::State(PlayState::Initial, None));
    }

    /// Players walk to their places for a kick-off.
    #[modulation]
    fn ready(&mut self, kick_off: Side) {
        self.execute(Command::State(PlayState::Ready, Some(self.side(kick_off))));
    }

    /// Players stand at their places.
    #[modulation]
    fn set(&mut self) {
        self.execute(Command::State(PlayState::Set, None));
    }

    /// The ball is in play.
    #[modulation]
    fn playing(&mut self) {
        self.execute(Command::State(PlayState::Playing, None));
    }

    /// The half has ended.
    #[modulation]
    fn finished(&mut self) {
        self.execute(Command::State(PlayState::Finished, None));
    }

    /// Stops the game: all players stand.
    #[modulation(stop)]
    fn stop(&mut self) {
        self.execute(Command::Stopped(true));
    }

    /// Lets a stopped game go on.
    #[modulation]
    fn resume(&mut self) {
        self.execute(Command::Stopped(false));
    }

    /// Gives a penalty to a player, or ends it.
    #[modulation]
    fn penalty(&mut self, team: Side, #[range(1..=20)] player: u32, penalty: Foul) {
        let (_, penalty) = PENALTIES[penalty.index() as usize];
        self.execute(Command::Penalty(self.side(team), player as u8, penalty));
    }

    /// Stops the game for a set play, until it is resumed.
    #[modulation]
    fn set_play(&mut self, set_play: SetPlay, team: Side) {
        self.execute(Command::SetPlay(set_play, self.side(team)));
    }

    /// Counts a goal for a team.
    #[modulation]
    fn goal(&mut self, team: Side) {
        self.execute(Command::Goal(self.side(team)));
    }

    /// Sets the remaining time of the half.
    #[modulation]
    fn set_clock(
        &mut self,
        #[range(0..=3600)]
        #[default(600)]
        #[unit("s")]
        seconds: u32,
    ) {
        self.execute(Command::Clock(seconds as i16));
    }

    /// Begins the first or the second half; the order of the teams in the packets changes with it.
    #[modulation]
    fn half(&mut self, #[range(1..=2)] half: u32) {
        self.execute(Command::FirstHalf(half == 1));
    }

    /// State of the game.
    #[output]
    fn state(&self) -> Option<PlayState> {
        self.shown(|control| control.state)
    }

    /// Whether the game is stopped.
    #[output]
    fn stopped(&self) -> Option<bool> {
        self.shown(|control| control.stopped)
    }

    /// Set play.
    #[output]
    fn restart(&self) -> Option<SetPlay> {
        self.shown(|control| control.set_play)
    }

    /// Remaining time of the half.
    #[output(unit = "s")]
    fn clock(&self) -> Option<f64> {
        self.game.as_ref().map(|(game, _)| game.clock())
    }

    /// Number of the team that has the kick-off or the set play.
    #[output]
    fn kicking_team(&self) -> Option<u8> {
        self.shown(|control| control.kicking_team).flatten()
    }

    /// Numbers of the first and the second team.
    #[output]
    fn teams(&self) -> Option<[u8; 2]> {
        self.game.as_ref().map(|(_, teams)| *teams)
    }

    /// The players with a penalty: its kind, and the time until it may end.
    #[output]
    fn penalties(&self) -> Vec<String> {
        self.game.as_ref().map_or_else(Vec::new, |(game, _)| game.penalties())
    }

    /// Goals of the first and the second team.
    #[output]
    fn score(&self) -> Option<[u8; 2]> {
        self.of_teams(|team| team.score)
    }

    /// Messages that the first and the second team may still send.
    #[output]
    fn messages(&self) -> Option<[u16; 2]> {
        self.of_teams(|team| team.message_budget)
    }

    /// What the last command did.
    #[output]
    fn answer(&self) -> &str {
        &self.answer
    }

    /// The players that answer: address, time since then, pose in the frame of their team, ball.
    #[output]
    fn players(&self) -> Vec<String> {
        self.players.lines(self.now)
    }

    /// Number of the players that have answered in the last 4 s.
    #[output]
    fn answering(&self) -> u32 {
        self.players.answering() as u32
    }

    fn step(&mut self, time: &Time) {
        self.now = seconds(time.now);
        self.packet = self.game.as_mut().and_then(|(game, _)| game.advance(self.now));
    }
}

activation_tree! {
    /// The tree of `player referee`.
    pub(super) struct Match { root: Referee, cycle_hz: 100, components: [Referee] }
}

impl Robot for Match {
    type Sensors<'a> = ();
    type Command = Option<Control>;
    type Error = Infallible;

    fn sense(&mut self, (): &()) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) -> Option<Control> {
        self.get::<Referee>().packet
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fouls_have_the_order_of_the_penalties() {
        let fouls: Vec<_> = Foul::VARIANTS.iter().map(|foul| foul.name.to_owned()).collect();
        assert_eq!(fouls, PENALTIES.map(|(_, penalty)| format!("{penalty:?}")));
    }
}

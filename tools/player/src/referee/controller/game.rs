//! State of a game, and the times at which its packets are sent.

use bica_player::referee::packet::{Control, Penalty, PlayState, PlayerInfo, SetPlay, Team, Version};

use super::command::{Command, penalty_name};

/// Duration of a half, s.
const HALF: f64 = 600.0;
/// Duration of the state ready, s.
const READY: f64 = 45.0;
/// Duration of a kick-off, s.
const KICK_OFF: f64 = 10.0;
/// Duration of a set play after the game was resumed, s.
const SET_PLAY: f64 = 45.0;
/// Duration of a penalty, s.
pub(in crate::referee) const PENALTY: f64 = 30.0;
/// Message budget of a team in a game.
pub(super) const BUDGET: u16 = 12_000;
/// Time between two packets, s.
const PERIOD: f64 = 0.5;
/// Period, s, and number of the packets after the game was stopped.
const QUICK: (f64, u8) = (0.2, 4);

/// State of a game. Times are in seconds since the start.
pub(in crate::referee) struct Game {
    control: Control,
    now: f64,
    /// Remaining time of the half, s.
    clock: f64,
    /// Remaining secondary time, s.
    secondary: f64,
    /// Earliest end of each penalty.
    penalties: [[f64; 20]; 2],
    delay: f64,
    /// Time from which the state playing is shown.
    shown_from: f64,
    /// Time of the next packet, and remaining number of quick packets.
    next: f64,
    quick: u8,
}

impl Game {
    /// Creates a game of two teams before its first half. Packets have the `version`; the state playing is shown `delay` s late.
    pub(in crate::referee) fn new(teams: [u8; 2], players: u8, version: Version, delay: f64) -> Self {
        let team = |number| {
            let mut team = Team { number, goalkeeper: 1, message_budget: BUDGET, ..Team::default() };
            team.players[players.into()..].iter_mut().for_each(|player| player.penalty = Penalty::Substitute);
            team
        };
        let mut teams = teams.map(team);
        teams[1].field_colour = 1;
        let control = Control {
            version,
            players_per_team: players,
            first_half: true,
            kicking_team: Some(teams[0].number),
            teams,
            ..Control::default()
        };
        Self {
            control,
            now: 0.0,
            clock: HALF,
            secondary: 0.0,
            penalties: [[0.0; 20]; 2],
            delay,
            shown_from: 0.0,
            next: 0.0,
            quick: 0,
        }
    }

    /// Executes a command. The next packet is sent at once.
    ///
    /// # Errors
    /// If the game has no such team, or the packet version has no such penalty.
    pub(in crate::referee) fn execute(&mut self, command: Command) -> Result<(), String> {
        match command {
            Command::State(state, kicking) => self.begin(state, kicking)?,
            Command::Stopped(stopped) => {
                self.control.stopped = stopped;
                self.secondary = if stopped || self.control.set_play == SetPlay::None { 0.0 } else { SET_PLAY };
                self.quick = if stopped { QUICK.1 } else { 0 };
            }
            Command::Penalty(team, player, penalty) => self.penalize(team, player, penalty)?,
            Command::SetPlay(set_play, team) => {
                self.index(team)?;
                (self.control.set_play, self.control.kicking_team) = (set_play, Some(team));
                self.control.stopped = set_play != SetPlay::None && set_play != SetPlay::PenaltyKick;
                self.quick = if self.control.stopped { QUICK.1 } else { 0 };
            }
            Command::Goal(team) => {
                let index = self.index(team)?;
                let score = &mut self.control.teams[index].score;
                *score = score.saturating_add(1);
                self.control.kicking_team = Some(self.control.teams[1 - index].number);
            }
            Command::Clock(seconds) => self.clock = seconds.into(),
            Command::FirstHalf(first) => {
                if first != self.control.first_half {
                    self.control.teams.swap(0, 1);
                    self.penalties.swap(0, 1);
                }
                self.control.first_half = first;
            }
            Command::Wait(_) | Command::Players | Command::Quit => return Ok(()),
        }
        self.next = self.now;
        Ok(())
    }

    fn begin(&mut self, state: PlayState, kicking: Option<u8>) -> Result<(), String> {
        if let Some(team) = kicking {
            self.index(team)?;
            self.control.kicking_team = kicking;
        }
        let is_new = state != self.control.state;
        (self.control.state, self.control.stopped) = (state, false);
        if state == PlayState::Ready && self.control.set_play != SetPlay::PenaltyKick {
            self.control.set_play = SetPlay::None;
        }
        self.secondary = match state {
            PlayState::Ready => READY,
            PlayState::Playing if is_new => KICK_OFF,
            _ => 0.0,
        };
        self.shown_from = if state == PlayState::Playing && is_new { self.now + self.delay } else { self.now };
        Ok(())
    }

    fn penalize(&mut self, team: u8, player: u8, penalty: Penalty) -> Result<(), String> {
        if penalty.number(self.control.version).is_none() {
            return Err(format!("version {} has no such penalty; choose another one", self.control.version.number()));
        }
        let (team, player) = (self.index(team)?, usize::from(player - 1));
        self.control.teams[team].players[player].penalty = penalty;
        self.penalties[team][player] = self.now + PENALTY;
        Ok(())
    }

    fn index(&self, team: u8) -> Result<usize, String> {
        self.control.index(team).ok_or_else(|| {
            let [one, other] = self.control.teams.map(|team| team.number);
            format!("team {team} does not play; give {one} or {other}")
        })
    }

    /// Advances the game to a time, s; returns a packet if one is due.
    pub(in crate::referee) fn advance(&mut self, now: f64) -> Option<Control> {
        let seconds = (now - self.now).max(0.0);
        self.now = now;
        if self.control.state == PlayState::Playing && !self.control.stopped {
            self.clock -= seconds;
        }
        if self.secondary > 0.0 {
            self.secondary = (self.secondary - seconds).max(0.0);
            if self.secondary <= 0.0 && self.control.state == PlayState::Playing {
                self.control.set_play = SetPlay::None;
            }
        }
        (now >= self.next).then(|| {
            let is_quick = self.quick > 0;
            self.quick = self.quick.saturating_sub(1);
            self.next = now + if is_quick { QUICK.0 } else { PERIOD };
            self.control.number = self.control.number.wrapping_add(1);
            self.shown()
        })
    }

    /// Sets the number of messages that each team may still send.
    pub(in crate::referee) fn set_budget(&mut self, messages: u16) {
        self.control.teams.iter_mut().for_each(|team| team.message_budget = messages);
    }

    /// Counts a message of a team, which was sent now, against its budget.
    pub(in crate::referee) fn count_message(&mut self, team: u8) {
        let is_game = matches!(self.control.state, PlayState::Ready | PlayState::Set | PlayState::Playing);
        if let Some(team) = self.control.teams.iter_mut().find(|known| is_game && known.number == team) {
            team.message_budget = team.message_budget.saturating_sub(1);
        }
    }

    /// Remaining time of the half, s.
    pub(in crate::referee) const fn clock(&self) -> f64 {
        self.clock
    }

    /// State of the game.
    pub(in crate::referee) const fn control(&self) -> &Control {
        &self.control
    }

    /// Returns a value of each of two teams, in the order of their numbers here; the order in the packets changes at half-time.
    pub(super) fn of_teams<V: Copy + Default>(&self, numbers: [u8; 2], value: impl Fn(&Team) -> V) -> [V; 2] {
        numbers
            .map(|number| self.control.index(number).map(|index| value(&self.control.teams[index])).unwrap_or_default())
    }

    /// Packet as it is sent: the state playing is shown as set until its delay has passed.
    fn shown(&self) -> Control {
        let is_hidden = self.now < self.shown_from;
        let mut shown = self.control;
        if is_hidden {
            shown.state = PlayState::Set;
        }
        shown.seconds_remaining = self.clock.ceil().clamp(i16::MIN.into(), i16::MAX.into()) as i16;
        shown.secondary_seconds = if is_hidden { 0 } else { self.secondary.ceil() as i16 };
        for (team, ends) in shown.teams.iter_mut().zip(&self.penalties) {
            for (player, end) in team.players.iter_mut().zip(ends) {
                let lasts = !matches!(player.penalty, Penalty::None | Penalty::Substitute | Penalty::SentOff);
                player.seconds = if lasts { (end - self.now).ceil().clamp(0.0, 255.0) as u8 } else { 0 };
            }
        }
        shown
    }

    /// Returns a line for each player with a penalty.
    pub(super) fn penalties(&self) -> Vec<String> {
        let teams = self.shown().teams;
        let players =
            teams.iter().flat_map(|team| (1..).zip(&team.players).map(|(number, info)| (team.number, number, info)));
        let penalized = players.filter(|(.., info)| !matches!(info.penalty, Penalty::None | Penalty::Substitute));
        let line = |(team, number, info): (u8, u8, &PlayerInfo)| {
            format!("{team}-{number} {}, {} s", penalty_name(info.penalty), info.seconds)
        };
        penalized.map(line).collect()
    }

    /// State of the game, one line.
    pub(super) fn line(&self) -> String {
        let Control { state, set_play, stopped, teams, .. } = &self.control;
        let stopped = if *stopped { ", stopped" } else { "" };
        let set_play = if *set_play == SetPlay::None { String::new() } else { format!(", {set_play:?}") };
        let [one, other] = teams.map(|team| (team.number, team.score));
        format!("{:7.1} s  {state:?}{set_play}{stopped}  {} {}:{} {}", self.clock, one.0, one.1, other.1, other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn game(delay: f64) -> Game {
        Game::new([5, 23], 3, Version::V20, delay)
    }

    fn command(game: &mut Game, line: &str) -> Result<(), String> {
        game.execute(Command::parse(line)?.expect("a command"))
    }

    /// Returns the times of the packets in some seconds, in units of 0.1 s, and the last packet.
    fn packets(game: &mut Game, seconds: f64) -> (Vec<u32>, Control) {
        let start = game.now;
        let sent = (1..=(seconds * 100.0) as u32).filter_map(|step| {
            let packet = game.advance(start + f64::from(step) * 0.01)?;
            Some((step / 10, packet))
        });
        let (times, packets): (Vec<u32>, Vec<Control>) = sent.unzip();
        (times, *packets.last().expect("a packet"))
    }

    #[test]
    fn packets_come_at_two_hertz_and_faster_at_a_stop() {
        let mut game = game(0.0);
        command(&mut game, "playing").expect("a state");
        assert_eq!(packets(&mut game, 2.0).0.len(), 4);
        command(&mut game, "stop").expect("a stop");
        let (times, packet) = packets(&mut game, 2.0);
        assert_eq!(times, [0, 2, 4, 6, 8, 13, 18]);
        assert!(packet.stopped && packet.state == PlayState::Playing);
    }

    #[test]
    fn playing_is_shown_after_the_delay() {
        let mut game = game(3.0);
        command(&mut game, "set").expect("a state");
        command(&mut game, "playing").expect("a state");
        let (_, hidden) = packets(&mut game, 2.9);
        assert_eq!((hidden.state, hidden.secondary_seconds), (PlayState::Set, 0));
        let (_, shown) = packets(&mut game, 1.0);
        assert_eq!((shown.state, shown.secondary_seconds, shown.seconds_remaining), (PlayState::Playing, 7, 597));
    }

    #[test]
    fn penalty_stands_until_it_is_ended() {
        let mut game = game(0.0);
        command(&mut game, "penalty 23 2 pushing").expect("a penalty");
        let (_, begun) = packets(&mut game, 1.0);
        assert_eq!(begun.teams[1].players[1].penalty, Penalty::Pushing);
        assert!((29..=30).contains(&begun.teams[1].players[1].seconds));
        assert_eq!(game.penalties(), ["23-2 pushing, 29 s"]);
        let (_, later) = packets(&mut game, 40.0);
        assert_eq!((later.teams[1].players[1].penalty, later.teams[1].players[1].seconds), (Penalty::Pushing, 0));
        command(&mut game, "penalty 23 2 none").expect("its end");
        assert_eq!(packets(&mut game, 1.0).1.teams[1].players[1].penalty, Penalty::None);
        assert_eq!(begun.teams[1].players[3].penalty, Penalty::Substitute, "three players a team");
    }

    #[test]
    fn set_play_stops_the_game_until_it_is_resumed() {
        let mut game = game(0.0);
        command(&mut game, "playing").expect("a state");
        command(&mut game, "set-play throw-in 23").expect("a set play");
        let (_, packet) = packets(&mut game, 1.0);
        assert_eq!((packet.stopped, packet.set_play, packet.kicking_team), (true, SetPlay::ThrowIn, Some(23)));
        command(&mut game, "resume").expect("the game goes on");
        let (_, packet) = packets(&mut game, 1.0);
        assert_eq!((packet.stopped, packet.set_play, packet.secondary_seconds), (false, SetPlay::ThrowIn, 45));
        assert_eq!(packets(&mut game, 45.0).1.set_play, SetPlay::None);
    }

    #[test]
    fn second_half_swaps_the_teams() {
        let mut game = game(0.0);
        command(&mut game, "goal 23").expect("a goal");
        command(&mut game, "half 2").expect("a half");
        let (_, packet) = packets(&mut game, 1.0);
        assert_eq!(packet.teams.map(|team| (team.number, team.score)), [(23, 1), (5, 0)]);
        assert_eq!((packet.first_half, packet.kicking_team), (false, Some(5)));
        assert!(command(&mut game, "goal 7").is_err_and(|text| text.contains("23 or 5")));
    }
}

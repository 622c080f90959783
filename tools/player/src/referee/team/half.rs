//! A half in simulated time, under the commands of a small `GameController`.

use bica_app::{Failure, interrupt};
use bica_player::referee::packet::{Penalty, PlayState, Version};
use bica_player::referee::{Identity, Received};
use bica_tuning::Layers;

use super::assistants::Assistants;
use super::entrants::{field, identities, is_dynamic};
use super::player::Player;
use super::radio::Radio;
use super::tally::Tally;
use super::teams::Teams;
use crate::cli::Play;
use crate::referee::controller::{Command, Game, PENALTY};
use crate::referee::play::forward;

/// Durations of the states ready and set, s.
const READY: f64 = 45.0;
const SET: f64 = 5.0;
/// Address of the `GameController`.
const SOURCE: [u8; 4] = [127, 0, 0, 1];

/// A half.
pub(super) struct Half {
    teams: Teams<Radio>,
    game: Game,
    numbers: [u8; 2],
    score: [usize; 2],
    /// Time of the next change of the state, s.
    next: f64,
    tally: Tally,
    assistants: Assistants,
    everybody: Vec<Identity>,
    /// Players that are penalized, and the ends of their penalties, s.
    penalized: Vec<(Identity, f64)>,
}

impl Half {
    /// Creates a half before its kick-off, which belongs to the first team if the seed is even.
    pub(super) fn new(args: &Play, numbers: [u8; 2], seed: u64, layers: &Layers) -> Result<Self, Failure> {
        let players = args.referee.players;
        let everybody = identities(numbers, players);
        let field = field(args, seed, &everybody)?;
        let playing = if args.referee.idle { usize::from(players) } else { everybody.len() };
        let player = |(index, me): (usize, &Identity)| {
            let mut forward = forward(field.truth(index).attacks(), is_dynamic(args));
            layers.apply(&mut *forward)?;
            Ok(Player::new(forward, Radio::new(*me), None))
        };
        let robots = everybody.iter().take(playing).enumerate().map(player);
        let robots = robots.collect::<Result<Vec<_>, Failure>>()?;
        let mut game = Game::new(numbers, players, Version::V20, 0.0);
        let first = numbers[(seed % 2) as usize];
        if let Some(seconds) = args.seconds {
            order(&mut game, Command::Clock(seconds as i16))?;
        }
        if let Some(messages) = args.referee.budget {
            game.set_budget(messages);
        }
        order(&mut game, Command::State(PlayState::Ready, Some(first)))?;
        let tally = Tally::new(usize::from(players), field.robots());
        Ok(Self {
            teams: Teams::new(field, robots),
            game,
            numbers,
            score: [0; 2],
            next: READY,
            tally,
            assistants: Assistants::default(),
            everybody,
            penalized: Vec::new(),
        })
    }

    /// Plays the half; returns its figures, or `None` if the end was requested before its end.
    pub(super) fn play(mut self) -> Result<Option<Tally>, Failure> {
        while self.game.clock() > 0.0 {
            if interrupt::requested() {
                return Ok(None);
            }
            self.cycle()?;
        }
        Ok(Some(self.tally))
    }

    fn cycle(&mut self) -> Result<(), Failure> {
        let now = self.teams.seconds();
        self.let_in(now)?;
        self.command(now)?;
        if let Some(control) = self.game.advance(now) {
            let packet = Received { control, source: SOURCE, at_us: 10_000 * self.teams.cycle };
            self.teams.players.iter_mut().for_each(|player| player.network.show(packet));
        }
        self.teams.step(1)?;
        self.assistants.carry(&mut self.teams);
        self.pass_messages();
        if self.game.control().state == PlayState::Playing {
            self.tally.count(&self.teams);
            if let Some((robot, penalty)) = self.assistants.judge(&self.teams) {
                self.penalize(robot, penalty, now)?;
            }
        }
        self.tally.skip(&self.teams.field);
        Ok(())
    }

    /// Penalizes a player for a time.
    fn penalize(&mut self, robot: usize, penalty: Penalty, now: f64) -> Result<(), Failure> {
        let me = self.everybody[robot];
        if self.penalized.iter().any(|(player, _)| *player == me) {
            return Ok(());
        }
        self.tally.penalties[usize::from(me.team != self.numbers[0])] += 1;
        self.penalized.push((me, now + PENALTY));
        order(&mut self.game, Command::Penalty(me.team, me.player, penalty))
    }

    /// Ends the penalties that are over.
    fn let_in(&mut self, now: f64) -> Result<(), Failure> {
        let (over, left) = self.penalized.iter().partition(|(_, end)| now >= *end);
        self.penalized = left;
        let over: Vec<(Identity, f64)> = over;
        over.into_iter()
            .try_for_each(|(me, _)| order(&mut self.game, Command::Penalty(me.team, me.player, Penalty::None)))
    }

    /// Gives the commands that are due.
    fn command(&mut self, now: f64) -> Result<(), Failure> {
        let score = self.teams.field.score();
        let state = self.game.control().state;
        if let Some(team) = (0..2).find(|team| score[*team] > self.score[*team]) {
            self.score = score;
            if state == PlayState::Playing {
                order(&mut self.game, Command::Goal(self.numbers[team]))?;
                order(&mut self.game, Command::State(PlayState::Ready, None))?;
                self.next = now + READY;
            }
        }
        if now < self.next || state == PlayState::Playing {
            return Ok(());
        }
        self.next = now + SET;
        let next = if state == PlayState::Ready { PlayState::Set } else { PlayState::Playing };
        if next == PlayState::Set {
            // A robot at the centre keeps the ball where it is.
            let _ = self.teams.field.put_ball(glam::Vec2::ZERO);
        }
        order(&mut self.game, Command::State(next, None))
    }

    /// Passes the messages of this cycle to the other players.
    fn pass_messages(&mut self) {
        let at_us = 10_000 * self.teams.cycle;
        let sent: Vec<_> = self.teams.players.iter_mut().filter_map(|player| player.network.take()).collect();
        for message in sent {
            self.game.count_message(message.from.team);
            self.tally.messages[usize::from(message.from.team != self.numbers[0])] += 1;
            self.teams.players.iter_mut().for_each(|player| player.network.hear(&message, at_us));
        }
    }
}

fn order(game: &mut Game, command: Command) -> Result<(), Failure> {
    game.execute(command).map_err(|what| Failure::new(what, "give other --teams"))
}

#[cfg(test)]
mod tests {
    use bica::Tree;
    use bica_field::FIELD;
    use bica_player::referee::{TeamForward, TeamPlayer};
    use bica_player::team::{Role, Roles};
    use clap::Parser;

    use super::*;

    /// Index of the penalized player, the only one that plays: nobody shoots a goal in the meantime.
    const OUT: usize = 0;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        play: Play,
    }

    fn half(more: &[&str]) -> Half {
        let play = ["play", "--world", "team", "--teams", "5,23", "--games", "1", "--size", "160x120"];
        let args = Line::parse_from([&play[..], more].concat()).play;
        Half::new(&args, [5, 23], 0, &Layers::new(const { &TeamForward::GRAPH })).expect("there is room")
    }

    impl Half {
        fn run(&mut self, seconds: u32) {
            for _ in 0..100 * seconds {
                self.cycle().expect("a cycle");
            }
        }

        /// State of the player; `None` before its first cycle.
        fn state(&self) -> Option<&'static str> {
            self.teams.players[OUT].forward().of::<TeamPlayer>().state_name()
        }

        /// Time until the player is in a state, s.
        fn reaches(&mut self, state: &str, limit: u32) -> f64 {
            let start = self.teams.seconds();
            while self.state() != Some(state) {
                self.cycle().expect("a cycle");
                assert!(self.teams.seconds() - start < f64::from(limit), "{:?} instead of {state}", self.state());
            }
            self.teams.seconds() - start
        }
    }

    #[test]
    fn penalized_player_returns_from_the_side_line() {
        let mut half = half(&["--players", "1", "--idle"]);
        half.reaches("playing", 60);
        half.penalize(OUT, Penalty::Pushing, half.teams.seconds()).expect("the team plays");
        half.run(3);
        let line = FIELD.field_corner().y;
        let pose = |half: &Half| half.teams.field.truth(OUT).robot();
        let carried = pose(&half);
        assert!(carried.position.x < -0.3 && carried.position.y.abs() > line - 0.15, "{carried:?}");
        half.run(26);
        let stood = pose(&half);
        assert_eq!(half.state(), Some("penalized"));
        assert!(stood.position.distance(carried.position) < 0.05 && (stood.heading - carried.heading).abs() < 0.25);
        half.reaches("enter", 2);
        let entered = half.reaches("playing", 12);
        let inside = pose(&half);
        assert!(inside.position.y.abs() < line - 0.2, "{inside:?} after {entered} s");
        assert_eq!((half.tally.penalties, half.assistants.carried), ([1, 0], 1));
        half.run(1);
        assert_ne!(half.teams.players[OUT].forward().get::<Roles>().role(), Role::Absent);
    }
}

//! `play --world team`: a match of two teams in one world, each robot with its own sockets.

use std::thread;
use std::time::{Duration, Instant};

use bica::runner::Robot;
use bica::{Instant as Time, Tree};
use bica_app::{Console, Failure, Outcome, interrupt};
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_player::referee::{Identity, TeamForward, TeamSensors};
use bica_sim::World;
use bica_sim::kinematic::{Entrant, KinematicWorld, MatchField};
use bica_sim::setup::Setup;

use super::network::PlayerNetwork;
use super::play::{forward, ports, refuse_other_network};
use super::truth::Truth;
use crate::cli::Play;

/// Duration of a cycle.
const CYCLE: Duration = Duration::from_millis(10);
/// Delay beyond which the world goes on slower than real time.
const LATE: Duration = Duration::from_millis(200);
/// Distance of the players from the side line at the start, and between two of them, m.
const START: [f32; 2] = [0.1, 0.5];

/// Plays until the end is requested.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    let Some(teams) = args.referee.teams else {
        return Err(Failure::new("a match needs the numbers of its teams", "give --teams 5,23"));
    };
    refuse(args)?;
    let players = identities(teams, args.referee.players);
    let mut game = Match::new(args, &players, teams[0])?;
    let mut truth = Truth::connect(args.referee.truth.as_deref())?;
    let console = Console::new(args.json);
    let (mut start, mut score, mut slow) = (Instant::now(), [0; 2], Duration::ZERO);
    let limit = args.seconds.map_or(u64::MAX, |seconds| (100.0 * seconds) as u64);
    while game.cycle < limit && !interrupt::requested() {
        truth.write(game.cycle, &players, &game.field);
        game.step()?;
        if game.field.score() != score {
            score = game.field.score();
            console.print(&format!("{:8.2} s  goal, {} : {}", game.seconds(), score[0], score[1]))?;
        }
        let due = start + CYCLE * u32::try_from(game.cycle).unwrap_or(u32::MAX);
        match due.checked_duration_since(Instant::now()) {
            Some(wait) => thread::sleep(wait),
            None if due.elapsed() > LATE => (start, slow) = (start + due.elapsed(), slow + due.elapsed()),
            None => {}
        }
    }
    report(console, &game, slow)?;
    Ok(if interrupt::requested() { Outcome::Interrupted } else { Outcome::Success })
}

/// Refuses options that a match does not support.
fn refuse(args: &Play) -> Result<(), Failure> {
    refuse_other_network(args)?;
    let is_watched = args.pictures.is_some() || args.film.is_some() || args.games.is_some();
    if is_watched || args.record.record.is_some() || args.link.address().is_some() {
        let what = "a match has no pictures, films, series, recordings and links";
        return Err(Failure::new(
            what,
            "leave out --pictures, --film, --games, --record and --serve; `play --referee` records",
        ));
    }
    Ok(())
}

/// Prints the result.
fn report(console: Console, game: &Match, slow: Duration) -> Result<(), Failure> {
    let [first, second] = game.field.score();
    console.print_row("result", &format!("{first} : {second} after {:.2} s", game.seconds()))?;
    let sent: u64 = game.robots.iter().map(|robot| robot.network.team_counts().0).sum();
    console.print_row("messages", &format!("{sent} to the teams"))?;
    let falls: usize = (0..game.field.robots()).map(|robot| game.field.truth(robot).falls()).sum();
    console.print_row("falls", &falls.to_string())?;
    console.print_row("real time", &format!("the world was {:.2} s behind", slow.as_secs_f64()))
}

/// Players of both teams.
fn identities(teams: [u8; 2], players: u8) -> Vec<Identity> {
    teams.into_iter().flat_map(|team| (1..=players).map(move |player| Identity { team, player })).collect()
}

/// A match.
struct Match {
    field: MatchField,
    robots: Vec<Player>,
    commands: Vec<Command>,
    cycle: u64,
}

/// A robot with its sockets.
struct Player {
    forward: Box<TeamForward>,
    network: PlayerNetwork,
}

impl Match {
    fn new(args: &Play, players: &[Identity], first: u8) -> Result<Self, Failure> {
        let setup = Setup { seed: args.seed, frame: args.size, ..Setup::default() };
        let entrants: Vec<Entrant> = players.iter().map(|me| entrant(*me, first)).collect();
        let field = MatchField::new(NAO, &setup, &entrants)
            .map_err(|error| Failure::new(error.to_string(), "give fewer --players"))?;
        let player = |(index, me): (usize, &Identity)| {
            let network = PlayerNetwork::open(*me, &ports(args, None, *me)?)?;
            let mut forward = forward(field.truth(index).attacks());
            args.tuning.layers(const { &TeamForward::GRAPH }, "team")?.apply(&mut *forward)?;
            Ok(Player { forward, network })
        };
        let robots = players.iter().enumerate().map(player).collect::<Result<_, Failure>>()?;
        Ok(Self { field, robots, commands: vec![Command::new(NAO.stand, 0.0); players.len()], cycle: 0 })
    }

    fn seconds(&self) -> f64 {
        self.cycle as f64 * CYCLE.as_secs_f64()
    }

    /// Plays a cycle: the robots on all cores.
    fn step(&mut self) -> Result<(), Failure> {
        let now = Time::from_millis(10 * self.cycle);
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let share = self.robots.len().div_ceil(cores).max(1);
        let worlds = self.field.worlds_mut().chunks_mut(share);
        let shares = worlds.zip(self.robots.chunks_mut(share)).zip(self.commands.chunks_mut(share));
        thread::scope(|scope| {
            let play = |((worlds, robots), commands): ((&mut [KinematicWorld], &mut [Player]), &mut [Command])| {
                for ((world, robot), command) in worlds.iter_mut().zip(robots).zip(commands) {
                    *command = robot.play(now, world)?;
                }
                Ok(())
            };
            let threads: Vec<_> = shares.map(|share| scope.spawn(move || play(share))).collect();
            let ended = |thread: thread::ScopedJoinHandle<'_, Result<(), Failure>>| {
                thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            };
            threads.into_iter().try_for_each(ended)
        })?;
        self.field.act(&self.commands);
        self.cycle += 1;
        Ok(())
    }
}

impl Player {
    /// Plays a cycle of one robot.
    fn play(&mut self, now: Time, world: &mut KinematicWorld) -> Result<Command, Failure> {
        let at_us = now.as_micros();
        let (packet, heard) = (self.network.receive(at_us), self.network.team().receive(at_us));
        let (me, ignored, refused) = (self.network.me(), self.network.ignored(), self.network.team().refused());
        let sensors = TeamSensors { body: world.sensors(), me, packet, ignored, heard, refused };
        self.forward.sense(&sensors).map_err(|error| Failure::new(error.to_string(), "give a smaller --size"))?;
        self.forward.tick(now);
        let command = self.forward.act();
        if let Some(answer) = &command.answer {
            self.network.send(answer);
        }
        if let Some(message) = &command.message {
            self.network.team().send(message);
        }
        Ok(command.body)
    }
}

/// Start of a player: at the side line of its own half, facing the field.
fn entrant(me: Identity, first: u8) -> Entrant {
    let corner = bica_field::FIELD.field_corner();
    let [from_line, apart] = START;
    let x = -corner.x + apart * f32::from(me.player);
    Entrant { is_second: me.team != first, at: Pose2::new(x, corner.y - from_line, -core::f32::consts::FRAC_PI_2) }
}

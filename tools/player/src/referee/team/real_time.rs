//! A match in real time under a `GameController`, each robot with its own sockets.

use std::path::PathBuf;
use std::thread;
use std::time::{Duration, Instant};

use bica::Tree;
use bica_app::{Console, Failure, Outcome, interrupt};
use bica_player::referee::packet::PlayState;
use bica_player::referee::{GameController, Identity, TeamForward};

use super::assistants::Assistants;
use super::entrants::{field, identities, is_dynamic};
use super::links;
use super::player::Player;
use super::recording;
use super::teams::{CYCLE, Teams};
use super::truth::Truth;
use crate::cli::Play;
use crate::referee::controller::penalty_name;
use crate::referee::network::PlayerNetwork;
use crate::referee::play::{forward, ports};

/// Delay beyond which the world goes on slower than real time.
const LATE: Duration = Duration::from_millis(200);

/// Plays until the end is requested.
pub(super) fn run(args: &Play, teams: [u8; 2]) -> Result<Outcome, Failure> {
    let players = identities(teams, args.referee.players);
    let console = Console::new(args.json);
    let mut game = open(args, &players, console)?;
    let mut truth = Truth::connect(args.referee.truth.as_deref())?;
    let mut assistants = Assistants::default();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let (mut start, mut score, mut slow) = (Instant::now(), [0; 2], Duration::ZERO);
    let limit = args.seconds.map_or(u64::MAX, |seconds| (100.0 * seconds) as u64);
    while game.cycle < limit && !interrupt::requested() {
        truth.write(game.cycle, &players, &game.field);
        game.apply_requests();
        game.step(threads)?;
        assistants.carry(&mut game);
        let foul = if is_playing(&game) { assistants.judge(&game) } else { None };
        if let Some((robot, penalty)) = foul {
            let (Identity { team, player }, name) = (players[robot], penalty_name(penalty));
            tell(console, &game, "foul", &format!("penalty {team} {player} {name}"))?;
        }
        for reason in game.players.iter().filter_map(Player::recording_ended) {
            eprintln!("warning: a recording ended, the match goes on: {reason}");
        }
        if game.field.score() != score {
            score = game.field.score();
            tell(console, &game, "goal", &format!("{} : {}", score[0], score[1]))?;
        }
        game.show_truth();
        let due = start + CYCLE * u32::try_from(game.cycle).unwrap_or(u32::MAX);
        match due.checked_duration_since(Instant::now()) {
            Some(wait) => thread::sleep(wait),
            None if due.elapsed() > LATE => (start, slow) = (start + due.elapsed(), slow + due.elapsed()),
            None => {}
        }
    }
    report(console, &mut game, slow)?;
    Ok(Outcome::of(true))
}

/// Prints an event of the match, and tells it to monitors.
fn tell(console: Console, game: &Teams<PlayerNetwork>, kind: &str, detail: &str) -> Result<(), Failure> {
    game.players.iter().for_each(|player| player.tell(kind, detail));
    console.print(&format!("{:8.2} s  {kind}: {detail}", game.seconds()))
}

/// Whether the newest packet shows the state playing.
fn is_playing(game: &Teams<PlayerNetwork>) -> bool {
    let states = |player: &Player<_>| player.forward().get::<GameController>().state();
    game.players.first().and_then(states) == Some(PlayState::Playing)
}

fn open(args: &Play, players: &[Identity], console: Console) -> Result<Teams<PlayerNetwork>, Failure> {
    recording::create_folder(args)?;
    let mut field = field(args, args.seed, players)?;
    let layers = args.tuning.layers(const { &TeamForward::GRAPH }, "team")?;
    let player = |(index, me): (usize, &Identity)| {
        let network = PlayerNetwork::open(*me, &ports(args, None, *me)?)?;
        let mut forward = forward(field.truth(index).attacks(), is_dynamic(args));
        layers.apply(&mut *forward)?;
        let start = |folder: &PathBuf| recording::start(args, folder, *me, field.truth(index).attacks(), &forward);
        let recording = args.record.record.as_ref().map(start).transpose()?;
        Ok(Player::new(forward, network, recording))
    };
    let mut robots = players.iter().enumerate().map(player).collect::<Result<Vec<_>, Failure>>()?;
    for ((index, player), world) in robots.iter_mut().enumerate().zip(field.worlds_mut()) {
        if let Some(link) = links::open(args, (index, players[index]), &mut **world, console)? {
            player.serve(link);
        }
    }
    Ok(Teams::new(field, robots))
}

/// Prints the result.
fn report(console: Console, game: &mut Teams<PlayerNetwork>, slow: Duration) -> Result<(), Failure> {
    let [first, second] = game.field.score();
    console.print_row("result", &format!("{first} : {second} after {:.2} s", game.seconds()))?;
    let sent: u64 = game.players.iter().map(|player| player.network.team_counts().0).sum();
    for line in game.players.iter_mut().filter_map(Player::close) {
        console.print_row("recording", &line)?;
    }
    console.print_row("messages", &format!("{sent} to the teams"))?;
    let falls: usize = (0..game.field.robots()).map(|robot| game.field.truth(robot).falls()).sum();
    console.print_row("falls", &falls.to_string())?;
    console.print_row("real time", &format!("the world was {:.2} s behind", slow.as_secs_f64()))
}

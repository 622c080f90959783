//! `play --referee`.

use std::net::Ipv4Addr;
use std::time::Duration;

use bica::Tree;
use bica_app::{App, Failure, Outcome, RunArgs, WorldOptions};
use bica_field::GoalColour;
use bica_motion::model::simulation::NAO;
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::referee::packet::PLAYERS;
use bica_player::referee::{Identity, TeamForward};
use bica_recording::{ReplayOptions, ReplayReport};

use super::network::{PlayerNetwork, Ports};
use super::team;
use super::world::RefereedWorld;
use crate::attacked::{self, ATTACKS};
use crate::cli::{ANYBODY, Play, RefereeArgs, World};
use crate::colour_profile::ColourProfile;
use crate::game::{Rules, WorldKind, open_world};

/// Name of the world.
const WORLD: &str = "referee";

/// Plays in the built-in world under the commands of a `GameController`.
pub(crate) fn run(args: &Play, referee: &str) -> Result<Outcome, Failure> {
    refuse(args)?;
    let me = identity(args)?;
    let ports = ports(args, sender(referee)?, me)?;
    let rules = Rules {
        world: WorldKind::BuiltIn,
        seed: args.seed,
        size: args.size,
        robots: args.robots,
        limit: Duration::MAX,
        realtime: true,
        firmware: None,
        settings: &[],
        options: args.option.clone().leak(),
    };
    let attacks = open_world(&rules)?.referee().attacks();
    // Opens the ports once, so that a port in use is reported before the game begins.
    drop(PlayerNetwork::open(me, &ports)?);
    let open = move |options: &WorldOptions| {
        options.value(ATTACKS, String::new())?;
        for (name, _) in rules.options.iter().filter_map(|option| option.split_once('=')) {
            options.value(name.trim(), String::new())?;
        }
        let network = PlayerNetwork::open(me, &ports)?;
        Ok(RefereedWorld::new(Box::new(open_world(&rules)?), network))
    };
    let app = App::<TeamForward, ColourProfile>::new("player").robot(maker::<false>(attacks)).try_world(WORLD, open);
    let option = [args.option.clone(), vec![attacked::option(attacks)]].concat();
    // The network runs in real time.
    app.play(&RunArgs { realtime: true, seconds: args.seconds, ..args.run_args(WORLD, option) })
}

/// Replays the recording of a game or of a robot in a match; `None` if the recording is of neither.
pub(crate) fn replay(options: &ReplayOptions<'_>) -> Option<Result<ReplayReport, Failure>> {
    let kinematic = [WORLD, team::WORLD].into_iter().find_map(|world| attacked::replay(options, world, maker::<false>));
    kinematic.or_else(|| attacked::replay(options, team::MUJOCO, maker::<true>))
}

/// Refuses, in a match, what uses another network than that of the rules.
pub(super) fn refuse_other_network(args: &Play) -> Result<(), Failure> {
    let is_served = args.link.address().is_some();
    #[cfg(feature = "ros")]
    let is_served = is_served || args.link.ros;
    if args.referee.is_match && is_served {
        let what = "--match forbids all other network, and --serve and --ros open one";
        return Err(Failure::new(what, "leave out --match, or --serve and --ros"));
    }
    Ok(())
}

/// Refuses options that a game with a referee does not support.
fn refuse(args: &Play) -> Result<(), Failure> {
    refuse_other_network(args)?;
    if args.world.kind != World::BuiltIn {
        let what = "--referee commands a robot in the built-in world, and this game is played in another one";
        return Err(Failure::new(what, "leave out --world or --referee"));
    }
    if args.pictures.is_some() || args.film.is_some() || args.games.is_some() {
        let what = "a game with --referee follows the clock: it has no pictures, films and series";
        return Err(Failure::new(what, "leave out --pictures, --film and --games"));
    }
    Ok(())
}

/// Returns team and number of the player.
fn identity(args: &Play) -> Result<Identity, Failure> {
    let team = args.league.team.parse().map_err(|_| {
        let what = format!("`{}` is no number of a team in a game with --referee", args.league.team);
        Failure::new(what, "give --team N, with a number from 0 to 254")
    })?;
    if team == u8::MAX {
        return Err(Failure::new("a team cannot have the number 255", "give --team N, with a number from 0 to 254"));
    }
    let player = args.referee.player;
    let exists = u8::try_from(player).ok().filter(|player| (1..=PLAYERS).contains(&usize::from(*player)));
    exists.map(|player| Identity { team, player }).ok_or_else(|| {
        let what = format!("a player cannot have the number {player}");
        Failure::new(what, format!("give --player N, with a number from 1 to {PLAYERS}"))
    })
}

/// Returns the ports and addresses of the player.
pub(super) fn ports(args: &Play, only: Option<Ipv4Addr>, me: Identity) -> Result<Ports, Failure> {
    let RefereeArgs { control_port: control, return_port: answers, team_ports, broadcast, .. } = args.referee;
    let team = team_port(team_ports, me.team)?;
    Ok(Ports { only, control, answers, team, broadcast })
}

/// Returns the port of the messages of a team.
pub(super) fn team_port(base: u16, team: u8) -> Result<u16, Failure> {
    base.checked_add(team.into()).ok_or_else(|| {
        let what = format!("the port of team {team} is {base} + {team}, above 65535");
        Failure::new(what, "give a smaller --team-ports")
    })
}

/// Parses the only sender that `--referee=ADDRESS` accepts; `None` accepts any.
fn sender(text: &str) -> Result<Option<Ipv4Addr>, Failure> {
    if text == ANYBODY {
        return Ok(None);
    }
    text.parse().map(Some).map_err(|_| {
        let what = format!("--referee={text} is no address of a GameController");
        Failure::new(what, "give an IPv4 address, as --referee=10.0.1.1, or --referee alone for any")
    })
}

fn maker<const IS_DYNAMIC: bool>(attacks: GoalColour) -> fn() -> Box<TeamForward> {
    match attacks {
        GoalColour::Yellow => || forward(GoalColour::Yellow, IS_DYNAMIC),
        GoalColour::SkyBlue => || forward(GoalColour::SkyBlue, IS_DYNAMIC),
    }
}

/// Makes a robot that attacks a goal, in a world with dynamics or without.
pub(super) fn forward(attacks: GoalColour, is_dynamic: bool) -> Box<TeamForward> {
    let mut forward = Box::new(TeamForward::new());
    forward.get_mut::<RobotProfile>().set(if is_dynamic { NAO.dynamic_profile } else { NAO.kinematic_profile });
    forward.get_mut::<GoalDetector>().attack(attacks);
    forward
}

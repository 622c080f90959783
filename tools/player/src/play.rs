//! `player play`: one game or a series.

use std::cell::OnceCell;
use std::time::Duration;

use crate::game::{
    FirmwareImage, GRAPH, RecordOptions, ReplayOptions, ReplayReport, Rules, SeriesOptions, ServeOptions, WorldKind,
    play_one, play_series,
};
use bica::Setting;
use bica_app::{Console, Failure, Outcome, RecordArgs, in_force, print_in_force};
use bica_link::LinkRequests;
use bica_tuning::Layers;
use bica_wire::model::Description;
use clap::ValueEnum;

use crate::cli::{GaitArg, Play, World};

/// Plays as the command line requests.
pub(crate) fn run(args: &Play) -> Result<Outcome, Failure> {
    #[cfg(feature = "referee")]
    if let Some(sender) = &args.referee.referee {
        return crate::referee::run(args, sender);
    }
    #[cfg(not(feature = "referee"))]
    if args.referee.referee.is_some() || args.world.kind == World::Team {
        return Err(built_without("referee", "the player that a GameController commands"));
    }
    #[cfg(feature = "referee")]
    if args.world.kind == World::Team || args.world.kind == World::Mujoco && args.referee.teams.is_some() {
        world(args.world.kind)?;
        return crate::referee::run_match(args);
    }
    if args.referee.teams.is_some() {
        let what = "--teams names the teams of a match, and this game is played by one robot";
        return Err(Failure::new(what, "give --world team or --world mujoco, too"));
    }
    if args.world.kind == World::Lola {
        #[cfg(all(feature = "lola", unix))]
        return crate::lola::run(args);
        #[cfg(all(feature = "lola", not(unix)))]
        return Err(Failure::new("LoLA's socket is a Unix socket", "run this program on the robot, or on Linux"));
        #[cfg(not(feature = "lola"))]
        return Err(built_without("lola", "the driver of a real NAO"));
    }
    if args.world.kind == World::Booster {
        #[cfg(feature = "booster")]
        return crate::booster::run(args);
        #[cfg(not(feature = "booster"))]
        return Err(built_without("booster", "the driver of a real T1 and K1"));
    }
    if args.booster.dds_interface.is_some() || args.booster.dds_domain != 0 || args.booster.gait != GaitArg::Own {
        let what = "--dds-domain, --dds-interface and --gait belong to a real Booster, and this game is played in another world";
        return Err(Failure::new(what, "give --world booster --robot t1, too, or leave them out"));
    }
    if args.frames.is_some() || args.cameras.is_some() {
        let what = "--frames and --cameras belong to a real robot, and this game is played in another world";
        return Err(Failure::new(what, "give --world lola, too, or leave out --frames and --cameras"));
    }
    if args.world.kind == World::League {
        #[cfg(feature = "league")]
        return crate::league::run(args);
        #[cfg(not(feature = "league"))]
        return Err(built_without("league", "the simulation league"));
    }
    if args.league.server.is_some() || args.league.against {
        let what = "--server and --against belong to the league's server, and this game is played in another world";
        return Err(Failure::new(what, "give --world league --robot t1, too"));
    }
    if args.image.is_some() && args.world.kind != World::Firmware {
        let what = "--image names a firmware image, and this game is played without firmware";
        return Err(Failure::new(what, "give --world firmware, too"));
    }
    let built = FirmwareImage::built(args.size, args.link.address().is_some());
    let image = || args.image.clone().unwrap_or_else(|| built.into());
    let firmware = (args.world.kind == World::Firmware).then(|| FirmwareImage::new(image(), args.size)).transpose()?;
    let console = Console::new(args.json);
    let kind = args.world.kind.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
    let layers = args.tuning.layers(&GRAPH, &kind)?;
    let rules = Rules {
        world: world(args.world.kind)?,
        seed: args.seed,
        size: args.size,
        robots: args.robots,
        limit: Duration::from_secs_f64(args.game_seconds()),
        realtime: args.realtime || args.link.is_paced(),
        firmware,
        settings: settings(args, &layers)?,
        options: args.option.clone().leak(),
    };
    let layers = in_force(&layers);
    print_in_force(console, &layers)?;
    let pictures = args.pictures.as_deref();
    match args.games {
        None => {
            let RecordArgs { record, images, split, force, .. } = &args.record;
            let (images, topics, split, force) = ((*images).into(), args.record.topics(), *split, *force);
            let record = record.as_deref().map(|path| RecordOptions { path, images, topics, split, force });
            let address = args.link.address();
            let node = OnceCell::new();
            let started = |bound: &str| {
                let started = address
                    .as_ref()
                    .map(|address| args.link.started(console, &Description::of(&GRAPH), address, bound));
                // The game starts its server only once.
                let _ = node.set(started.transpose()?);
                Ok(())
            };
            let anywhere = args.link.listen_anywhere;
            let pause =
                |can_pause, requests: &mut LinkRequests| args.link.pause(&Description::of(&GRAPH), can_pause, requests);
            let serve = |address| ServeOptions { address, anywhere, started: &started, pause: &pause };
            let serve = address.as_ref().map(serve);
            play_one(&rules, console, pictures, args.film.as_deref(), record, serve, &layers)
        }
        Some(games) => {
            let options = SeriesOptions { games, threads: args.threads, at_least: args.at_least };
            play_series(&rules, console, pictures, &options, layers)
        }
    }
}

/// Runs the code again on a recording of this program, of any of its worlds.
pub(crate) fn replay(options: &ReplayOptions<'_>) -> Result<ReplayReport, Failure> {
    #[cfg(feature = "booster")]
    if let Some(report) = crate::booster::replay(options) {
        return report;
    }
    #[cfg(feature = "league")]
    if let Some(report) = crate::league::replay(options) {
        return report;
    }
    #[cfg(all(feature = "lola", unix))]
    if let Some(report) = crate::lola::replay(options) {
        return report;
    }
    #[cfg(feature = "referee")]
    if let Some(report) = crate::referee::replay(options) {
        return report;
    }
    crate::game::replay(options)
}

/// Returns the options of the world of a recording; `None` if the recording is not of this world.
#[cfg(any(feature = "booster", feature = "league", all(feature = "lola", unix), feature = "referee"))]
pub(crate) fn recorded_options(path: &std::path::Path, world: &str) -> Option<Vec<String>> {
    // The reader of the other games reports an unreadable file.
    let recording = bica_recording::Recording::open(path).ok()?;
    let set_up = &recording.header().set_up;
    let options = set_up.get("options").and_then(|options| options.as_array()).into_iter().flatten();
    let options = options.filter_map(|option| option.as_str().map(str::to_owned)).collect();
    (set_up.get("world")?.as_str()? == world).then_some(options)
}

/// Returns the error for an option that needs a Cargo feature.
#[cfg(not(all(
    feature = "booster",
    feature = "evaluation",
    feature = "league",
    feature = "lola",
    feature = "referee"
)))]
pub(crate) fn built_without(feature: &str, what: &str) -> Failure {
    let help = format!("give Cargo the feature, too: `cargo run --release --features {feature} -- …`");
    Failure::new(format!("this program was built without {what}"), help)
}

/// Returns the parameters from the command line and the tune files.
fn settings(args: &Play, layers: &Layers) -> Result<&'static [Setting], Failure> {
    let settings = crate::game::settings(layers)?;
    if args.world.kind == World::Firmware && !settings.is_empty() {
        let help = "leave out --set and tune files, or play in another world";
        return Err(Failure::new("the parameters of a firmware image are constants", help));
    }
    Ok(settings)
}

/// Returns the requested world: the built-in one, unless it is MuJoCo.
#[cfg_attr(feature = "mujoco", expect(clippy::unnecessary_wraps, reason = "without MuJoCo it is refused"))]
fn world(world: World) -> Result<WorldKind, Failure> {
    match world {
        World::BuiltIn | World::Firmware | World::League | World::Team | World::Lola | World::Booster => {
            Ok(WorldKind::BuiltIn)
        }
        #[cfg(feature = "mujoco")]
        World::Mujoco => Ok(WorldKind::Mujoco),
        #[cfg(not(feature = "mujoco"))]
        World::Mujoco => {
            let help = "install its library with `cargo xtask mujoco`, then run \
                        `cargo run --release --features mujoco -- play --world mujoco`";
            Err(Failure::new("this program was built without MuJoCo", help))
        }
    }
}

//! World, robot and parameters of a recorded run.

use std::time::Duration;

use bica_console::Failure;
use bica_field::GoalColour;
use bica_motion::model::{Profile, RobotModel};
use bica_player::Model;
use bica_recording::{Header, ImagePolicy, Parameter, RecordedRules, TreeInfo};
use bica_sim::setup::Frame;
use bica_tuning::Layers;

use super::world::ReplayWorld;
use crate::rules::{Rules, WorldKind};
use crate::scene::GRAPH;
use crate::world_factory;

/// Returns the parameters of a recording, and over them the assignments of the command line.
pub(super) fn layers(header: &Header, set: &[String]) -> Result<Layers, Failure> {
    let mut layers = Layers::new(&GRAPH);
    for Parameter { component, name, value, .. } in &header.parameters {
        layers.assign(&format!("{component}.{name}={value}"), "the recording")?;
    }
    for assignment in set {
        layers.assign(assignment, "--set")?;
    }
    Ok(layers)
}

/// Checks that the recording is of this program's tree.
pub(super) fn check_tree(header: &Header) -> Result<(), Failure> {
    let own = TreeInfo::new(&GRAPH);
    if own.hash == header.tree.hash && own.tick_hz == header.tree.tick_hz {
        return Ok(());
    }
    let names = |tree: &TreeInfo| tree.components.iter().map(|one| one.name.clone()).collect::<Vec<_>>();
    let (recorded, present) = (names(&header.tree), names(&own));
    let only = |one: &[String], two: &[String]| {
        one.iter().filter(|name| !two.contains(name)).cloned().collect::<Vec<_>>().join(", ")
    };
    let (gone, new) = (only(&recorded, &present), only(&present, &recorded));
    let what = match (gone.as_str(), new.as_str()) {
        ("", "") => "rates, links, states or transitions differ".to_owned(),
        (gone, new) => format!("components only in the recording: [{gone}], only in this program: [{new}]"),
    };
    let help = "`player record info FILE` shows the commit that recorded it; build that to replay it";
    Err(Failure::new(format!("the recording is of another activation tree, so it is not run again: {what}"), help))
}

/// Returns world, motion profile and attacked goal of a recording. With a closed loop the simulated world runs again, also if
/// the recording has images.
pub(super) fn set_up(
    header: &Header,
    closed_loop: bool,
) -> Result<(ReplayWorld, &'static Profile, GoalColour), Failure> {
    let unknown = |what: &str| {
        Failure::new(format!("the recording has an unknown {what}"), "replay it with the program that recorded it")
    };
    let profile = match header.robot.profile.as_str() {
        "kinematic" => Model::KINEMATIC_PROFILE,
        "dynamic" => Model::DYNAMIC_PROFILE,
        _ => return Err(unknown("motion profile")),
    };
    let attacks = match header.robot.attacks.as_str() {
        "yellow" => GoalColour::Yellow,
        "sky-blue" => GoalColour::SkyBlue,
        _ => return Err(unknown("goal colour")),
    };
    let world = if header.images == ImagePolicy::All && !closed_loop {
        ReplayWorld::Stored(Box::default())
    } else {
        let rules = header.rules.as_ref().ok_or_else(|| unknown("world, which cannot run again"))?;
        ReplayWorld::Simulated(world_factory::open(&rules_of(rules)?)?)
    };
    Ok((world, profile, attacks))
}

fn rules_of(rules: &RecordedRules) -> Result<Rules, Failure> {
    let world = match rules.world.as_str() {
        "built-in" | "firmware" => WorldKind::BuiltIn,
        #[cfg(feature = "mujoco")]
        "mujoco" => WorldKind::Mujoco,
        other => {
            let what = format!("the game was played in the world `{other}`, which this program does not have");
            return Err(Failure::new(
                what,
                "for MuJoCo build with `--features mujoco`; recordings with images need no world",
            ));
        }
    };
    let [width, height] = rules.size;
    let unknown =
        || Failure::new(format!("the recording has images of {width}x{height}"), "known are 160x120, 320x240, 640x480");
    let limit = Duration::try_from_secs_f64(rules.seconds).unwrap_or(Duration::MAX);
    let size = Frame::of_size(width, height).ok_or_else(unknown)?;
    Ok(Rules {
        world,
        seed: rules.seed,
        size,
        robots: rules.robots,
        limit,
        realtime: false,
        firmware: None,
        settings: &[],
    })
}

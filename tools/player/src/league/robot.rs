//! The forward on a T1 as a program of its own.

use std::sync::{Arc, Mutex};

use bica::{Setting, Tree};
use bica_app::App;
use bica_league::{Body, Error};
use bica_player_t1::input::RobotProfile;
use bica_player_t1::{Forward, Model, PARAMETERS};
use bica_tuning::Layers;

use super::entry::{Entry, failure};
use super::world::{LeagueGame, LeagueWorld};
use crate::colour_profile::ColourProfile;

/// Name of the world.
pub(crate) const WORLD: &str = "league";

/// How a game stands, for the one who has started it.
pub(crate) type Standing = Arc<Mutex<(LeagueGame, Option<Error>)>>;

/// Returns the forward with the motions and the parameters of the robot in the league's server.
pub(crate) fn forward() -> Box<Forward> {
    let mut forward = Box::new(Forward::new());
    forward.get_mut::<RobotProfile>().set(Model::PROFILE);
    // A test applies the same text to the same tree.
    _ = forward.set_params(&parameters());
    forward
}

fn parameters() -> Vec<Setting> {
    let mut layers = Layers::new(const { &Forward::GRAPH });
    _ = layers.read_text("the parameters of the T1", PARAMETERS);
    layers.settings()
}

/// Returns the program that plays one game; `standing` tells how it went.
pub(crate) fn app(entry: Entry, standing: &Standing) -> App<Forward, ColourProfile> {
    let standing = Arc::clone(standing);
    App::new("player").robot(forward).try_world(WORLD, move |options| {
        let entry = Entry { seed: options.seed, ..entry.clone() };
        LeagueWorld::open(&entry, Arc::clone(&standing)).map_err(|error| failure(&error))
    })
}

//! Robots of the league with their forwards.

use std::sync::{Arc, Mutex};

use bica::{Setting, Tree};
use bica_app::App;
#[cfg(feature = "mujoco")]
use bica_motion::pose::Pose2;
use bica_player::input::RobotProfile;
#[cfg(feature = "mujoco")]
use bica_player::league::perception::{BallDetector, Localization};
use bica_player::league::{Forward, K1_PARAMETERS, T1_PARAMETERS};
use bica_player::model::set_model;
#[cfg(feature = "mujoco")]
use bica_player::perception::Odometry;
use bica_tuning::Layers;
#[cfg(feature = "mujoco")]
use glam::Vec2;

use super::client::{Body, Error, body};
use super::entry::{Entry, failure};
use super::world::{LeagueGame, LeagueWorld};
use crate::colour_profile::ColourProfile;

/// Name of the world.
pub(crate) const WORLD: &str = "league";

/// Name of the option that selects the robot.
pub(crate) const ROBOT: &str = "robot";

/// Result of a game so far, shared with the code that has started it.
pub(crate) type Standing = Arc<Mutex<(LeagueGame, Option<Error>)>>;

/// A robot of the league with its forward.
#[derive(Debug)]
pub(crate) struct Footballer {
    /// Its body; `--robot` names the id of its model.
    pub(crate) body: &'static Body,
    /// Makes the forward with the motions and the parameters of the robot in the league's server.
    pub(crate) forward: fn() -> Box<Forward>,
}

/// All robots of the league.
pub(crate) static FOOTBALLERS: [Footballer; 2] = [
    Footballer { body: body::T1, forward: || forward(body::T1, T1_PARAMETERS) },
    Footballer { body: body::K1, forward: || forward(body::K1, K1_PARAMETERS) },
];

impl Footballer {
    /// Name for `--robot`.
    pub(crate) const fn id(&self) -> &'static str {
        self.body.model.robot.id
    }
}

/// Estimates of a forward.
#[cfg(feature = "mujoco")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate {
    /// Pose of the robot relative to its start.
    pub(crate) odometry: Pose2,
    /// Pose of the robot on the field, x towards the attacked goal; `None` unless it is localized.
    pub(crate) robot: Option<Pose2>,
    /// Position of the ball, m, ground frame, and whether the newest view shows it; position of the middle of the goal.
    pub(crate) ball: Option<(Vec2, bool)>,
    pub(crate) goal: Option<Vec2>,
}

#[cfg(feature = "mujoco")]
impl Estimate {
    /// Where a forward believes that it is on the field, and where ball and goal are from there.
    pub(crate) fn of(forward: &Forward) -> Self {
        let (ball, place) = (forward.get::<BallDetector>(), forward.get::<Localization>());
        Self {
            odometry: forward.get::<Odometry>().pose(),
            robot: place.pose().filter(|_| forward.of::<Localization>().is_active()),
            ball: ball.position().map(|at| (at, ball.seen().is_some())),
            goal: place.posts().map(|[left, right]| 0.5 * (left + right)),
        }
    }
}

fn forward(body: &'static Body, parameters: &str) -> Box<Forward> {
    let mut forward = Box::<Forward>::default();
    set_model(&mut *forward, body.model);
    forward.get_mut::<RobotProfile>().set(body.profile);
    // A test reads the same text.
    _ = forward.set_params(&settings(body, parameters));
    forward
}

fn settings(body: &Body, parameters: &str) -> Vec<Setting> {
    let mut layers = Layers::new(const { &Forward::GRAPH });
    _ = layers.read_text(body.model.id, parameters);
    layers.settings()
}

/// Returns the program that plays one game; `standing` tells how it went.
pub(crate) fn app(robot: &'static Footballer, entry: Entry, standing: &Standing) -> App<Forward, ColourProfile> {
    let standing = Arc::clone(standing);
    App::new("player").robot(robot.forward).try_world(WORLD, move |options| {
        // Only a replay reads it, which must choose the robot first.
        options.value(ROBOT, robot.id().to_owned())?;
        let entry = Entry { seed: options.seed, ..entry.clone() };
        LeagueWorld::open(robot, &entry, Arc::clone(&standing)).map_err(|error| failure(&error))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_of_each_robot_are_accepted() {
        for parameters in [T1_PARAMETERS, K1_PARAMETERS] {
            let mut layers = Layers::new(const { &Forward::GRAPH });
            layers.read_text("robot", parameters).expect("names and values are right");
            assert!(layers.all().filter(|value| !value.is_default()).count() > 10);
            layers.apply(&mut *Box::<Forward>::default()).expect("they fit together");
        }
    }
}

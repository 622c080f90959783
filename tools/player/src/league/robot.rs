//! Robots of the league with their forwards.

use std::convert::Infallible;
use std::sync::{Arc, Mutex};

use bica::runner::Robot;
use bica::{Setting, Tree};
use bica_app::App;
#[cfg(feature = "mujoco")]
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_player_t1::senses::Senses;
use bica_recording::Recordable;
use bica_tuning::Layers;
#[cfg(feature = "mujoco")]
use glam::Vec2;

use super::client::{Body, Error};
use super::entry::{Entry, failure};
use super::world::{LeagueGame, LeagueWorld};
use crate::colour_profile::ColourProfile;

/// Name of the world.
pub(crate) const WORLD: &str = "league";

/// Name of the option that says which robot plays.
pub(crate) const ROBOT: &str = "robot";

/// How a game stands, for the one who has started it.
pub(crate) type Standing = Arc<Mutex<(LeagueGame, Option<Error>)>>;

/// A robot of the league with its forward.
pub(crate) trait Footballer: Send + 'static {
    /// Name for `--robot`.
    const NAME: &'static str;
    /// Values of the forward's parameters that differ from the NAO's.
    const PARAMETERS: &'static str;
    /// Its body.
    type Model: Body;
    /// Its tree.
    type Forward: Tree
        + Default
        + Recordable
        + for<'a> Robot<Sensors<'a> = Senses<'a>, Command = Command, Error = Infallible>;

    /// Sets the motions of the body in the league's server.
    fn set_profile(forward: &mut Self::Forward);

    /// Its estimate of where it is on the field, and where ball and goal are from there.
    #[cfg(feature = "mujoco")]
    fn estimate(forward: &Self::Forward) -> Estimate;
}

/// What a forward estimates.
#[cfg(feature = "mujoco")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate {
    /// Its pose in the frame where it began.
    pub(crate) odometry: Pose2,
    /// Its pose on the field, x towards the attacked goal, while it is located.
    pub(crate) robot: Option<Pose2>,
    /// The ball and the middle of the goal, m, ground frame, with whether the newest view shows them.
    pub(crate) ball: Option<(Vec2, bool)>,
    pub(crate) goal: Option<Vec2>,
}

macro_rules! footballer {
    ($(#[$doc:meta])* $robot:ident, $name:literal, $player:ident) => {
        $(#[$doc])*
        pub(crate) enum $robot {}

        impl Footballer for $robot {
            const NAME: &'static str = $name;
            const PARAMETERS: &'static str = $player::PARAMETERS;
            type Model = $player::Model;
            type Forward = $player::Forward;

            fn set_profile(forward: &mut Self::Forward) {
                forward.get_mut::<$player::input::RobotProfile>().set(<Self::Model as Body>::PROFILE);
            }

            #[cfg(feature = "mujoco")]
            fn estimate(forward: &Self::Forward) -> Estimate {
                let (ball, place) = (
                    forward.get::<$player::perception::BallDetector>(),
                    forward.get::<$player::perception::Localization>(),
                );
                Estimate {
                    odometry: forward.get::<$player::perception::Odometry>().pose(),
                    robot: place.pose().filter(|_| forward.is_active::<$player::perception::Localization>()),
                    ball: ball.position().map(|at| (at, ball.seen().is_some())),
                    goal: place.posts().map(|[left, right]| 0.5 * (left + right)),
                }
            }
        }
    };
}

footballer!(
    /// Booster T1.
    T1, "t1", bica_player_t1
);
footballer!(
    /// Booster K1.
    K1, "k1", bica_player_k1
);

/// Returns the forward with the motions and the parameters of the robot in the league's server.
#[expect(clippy::unnecessary_box_returns, reason = "a tree is too large for the stack of a debug build")]
pub(crate) fn forward<F: Footballer>() -> Box<F::Forward> {
    let mut forward = Box::<F::Forward>::default();
    F::set_profile(&mut forward);
    // A test applies the same text to the same tree.
    _ = forward.set_params(&parameters::<F>());
    forward
}

fn parameters<F: Footballer>() -> Vec<Setting> {
    let mut layers = Layers::new(const { &F::Forward::GRAPH });
    _ = layers.read_text(F::NAME, F::PARAMETERS);
    layers.settings()
}

/// Returns the program that plays one game; `standing` tells how it went.
pub(crate) fn app<F: Footballer>(entry: Entry, standing: &Standing) -> App<F::Forward, ColourProfile> {
    let standing = Arc::clone(standing);
    App::new("player").robot(forward::<F>).try_world(WORLD, move |options| {
        // Only a replay reads it, which must choose the robot first.
        options.value(ROBOT, F::NAME.to_owned())?;
        let entry = Entry { seed: options.seed, ..entry.clone() };
        LeagueWorld::<F>::open(&entry, Arc::clone(&standing)).map_err(|error| failure(&error))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<F: Footballer>() {
        let mut layers = Layers::new(const { &F::Forward::GRAPH });
        layers.read_text(F::NAME, F::PARAMETERS).expect("names and values are right");
        assert!(layers.all().filter(|value| !value.is_default()).count() > 10);
        layers.apply(&mut *Box::<F::Forward>::default()).expect("they fit together");
    }

    #[test]
    fn parameters_of_each_robot_are_accepted() {
        check::<T1>();
        check::<K1>();
    }
}

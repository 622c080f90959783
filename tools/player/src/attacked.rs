//! Attacked goal as an option in the recording of a game, for robots whose world does not determine it.

use std::fmt;

use bica::runner::Robot;
use bica_app::{App, Failure};
use bica_field::GoalColour;
use bica_recording::{Recordable, ReplayOptions, ReplayReport};

use crate::colour_profile::ColourProfile;
use crate::play::recorded_options;

/// Name of the option.
pub(crate) const ATTACKS: &str = "attacks";
/// Value of the option for the sky-blue goal.
pub(crate) const SKY_BLUE: &str = "sky-blue";
/// Value of the option for the yellow goal, which is the default.
pub(crate) const YELLOW: &str = "yellow";

/// Option of a game in which the robot attacks a goal.
pub(crate) fn option(attacks: GoalColour) -> String {
    let colour = if attacks == GoalColour::Yellow { YELLOW } else { SKY_BLUE };
    format!("{ATTACKS}={colour}")
}

/// Replays the recording of a game in a world, with the robot that `maker` makes for the recorded goal; `None` if the
/// recording is not of this world.
pub(crate) fn replay<R>(
    options: &ReplayOptions<'_>,
    world: &str,
    maker: fn(GoalColour) -> fn() -> Box<R>,
) -> Option<Result<ReplayReport, Failure>>
where
    R: Robot<Error: fmt::Display> + Recordable + Default + 'static,
{
    let recorded = recorded_options(options.path, world)?;
    let is_sky_blue = recorded.contains(&option(GoalColour::SkyBlue));
    let attacks = if is_sky_blue { GoalColour::SkyBlue } else { GoalColour::Yellow };
    Some(App::<R, ColourProfile>::new("player").robot(maker(attacks)).repeat(options))
}

//! The robot and the world that run again.

use std::fmt;

use bica::runner::{Robot, World};
use bica_wire::Recordable;

use bica_wire::model::{Description, Invalid, Messages};

use crate::header::{Header, tick_hz};
use crate::message::RunEvent;

/// Simulated world that runs again.
pub trait RepeatedWorld<R: Robot>: World<R> {
    /// Returns the events since the last call; none by default.
    fn take_events(&mut self) -> Vec<RunEvent> {
        Vec::new()
    }
}

impl<R: Robot> RepeatedWorld<R> for Box<dyn World<R>> {}

/// Robot and world at the start of a run that is repeated.
pub struct Subject<R> {
    /// The robot, with its parameters.
    pub robot: Box<R>,
    /// The simulated world; none if the robot runs on the stored sensor values.
    pub world: Option<Box<dyn RepeatedWorld<R>>>,
}

impl<R> fmt::Debug for Subject<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Subject").field("simulated", &self.world.is_some()).finish_non_exhaustive()
    }
}

/// Makes the subject for a recording, if it is of this program's robot.
pub(super) fn checked<R: Recordable>(
    header: &Header,
    runs_world: bool,
    subject: impl FnOnce(&Header, bool) -> Result<Subject<R>, Invalid>,
) -> Result<Subject<R>, Invalid> {
    check::<R>(header)?;
    if runs_world && !header.is_simulated() {
        let what = "the recording is of a world that cannot run again";
        return Err(Invalid::new(what, "replay it without --closed-loop, if it was recorded with sensor values"));
    }
    subject(header, runs_world)
}

/// Remedy if a program cannot use a recording.
const OTHER_HELP: &str = "the header of the recording names the commit that recorded it; build that to replay it";

/// Checks that the recording is of the tree and the messages of this program.
fn check<R: Recordable>(header: &Header) -> Result<(), Invalid> {
    check_tree::<R>(header, "it is not run again")?;
    if header.messages() == Some(&Messages::of::<R>()) && tick_hz() == header.tick_hz {
        return Ok(());
    }
    let what = "the recording has sensor values or commands of another form, so it is not run again";
    Err(Invalid::new(what, OTHER_HELP))
}

/// Checks that a recording is of this program's tree; `so` is the consequence in the error text.
pub(crate) fn check_tree<R: Recordable>(header: &Header, so: &str) -> Result<(), Invalid> {
    let own = Description::of(&R::GRAPH);
    if own.hash == header.tree.hash {
        return Ok(());
    }
    let names = |tree: &Description| tree.components.iter().map(|one| one.name.clone()).collect::<Vec<_>>();
    let (recorded, present) = (names(&header.tree), names(&own));
    let only = |one: &[String], two: &[String]| {
        one.iter().filter(|name| !two.contains(name)).cloned().collect::<Vec<_>>().join(", ")
    };
    let (gone, new) = (only(&recorded, &present), only(&present, &recorded));
    let what = match (gone.as_str(), new.as_str()) {
        ("", "") => "rates, links, states or transitions differ".to_owned(),
        (gone, new) => format!("components only in the recording: [{gone}], only in this program: [{new}]"),
    };
    Err(Invalid::new(format!("the recording is of another activation tree, so {so}: {what}"), OTHER_HELP))
}

//! What the map shows of a world.

use bica_link::Description;
use bica_wire::message::Truth;

use crate::protocol::Drawn;

/// What the map shows beside the outputs of the robot, in the frames of its world.
pub trait Scene: Send + Sync {
    /// Returns what lies under everything else; nothing for a robot of another world.
    fn scenery(&self, description: &Description) -> Vec<Drawn>;

    /// Returns the true state of a simulated world.
    fn truth(&self, truth: &Truth) -> Vec<Drawn>;
}

//! Layout for the referee of a match.

use bica_monitor::program::Extension;

/// Panel of a match for its referee.
pub(crate) struct Referee;

impl Extension for Referee {
    fn name(&self) -> &'static str {
        "referee"
    }

    fn module(&self) -> &'static str {
        include_str!("../panels/referee.js")
    }
}

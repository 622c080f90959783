//! Layout for the robots of a team.

use bica_monitor::program::Extension;

/// Layout with all players on one map, and a row for each of them.
pub(crate) struct Team;

impl Extension for Team {
    fn name(&self) -> &'static str {
        "team"
    }

    fn module(&self) -> &'static str {
        include_str!("../panels/team.js")
    }
}

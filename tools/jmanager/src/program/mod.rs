//! What a program adds to the monitor: its worlds.

mod world;

pub use world::{Game, LocalWorld, WorldOption, WorldRun, WorldSetup};

use crate::protocol::Failed;

/// What a program adds to the monitor.
#[derive(Default)]
pub struct Program {
    /// Worlds that it can simulate; the first one is shown if nothing else is asked for.
    pub worlds: Vec<Box<dyn LocalWorld>>,
}

impl Program {
    /// Finds a world.
    ///
    /// # Errors
    /// If there is none of this name.
    pub(crate) fn world(&self, name: &str) -> Result<&dyn LocalWorld, Failed> {
        let unknown = || {
            let known: Vec<_> = self.worlds.iter().map(|world| world.name()).collect();
            Failed::new(format!("there is no world `{name}`"), format!("known are {}", known.join(", ")))
        };
        self.worlds.iter().find(|world| world.name() == name).map(|world| &**world).ok_or_else(unknown)
    }
}

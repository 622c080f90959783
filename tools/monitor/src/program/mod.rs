//! What a program adds to the monitor: worlds, replay, panels.

mod extension;
mod images;
mod replay;
mod world;

pub use crate::protocol::WorldOption;
pub use extension::{Asked, Extension, Remembered, Reply, Work};
pub use images::{Image, ImageFiles};
pub use replay::Rerun;
pub use world::{Game, LocalWorld, WorldRun, WorldSetup};

use bica::Graph;

use crate::protocol::Failed;

/// What a program adds to the monitor.
#[derive(Default)]
pub struct Program {
    /// Tree of its robot: tune files are checked, and recordings of this tree are described and run again with it.
    pub graph: Option<&'static Graph>,
    /// Worlds that it can simulate; the first one is shown if nothing else is asked for.
    pub worlds: Vec<Box<dyn LocalWorld>>,
    /// Runs recordings again.
    pub rerun: Option<Rerun>,
    /// Images that are shown as a session.
    pub images: Option<Box<dyn ImageFiles>>,
    /// Panels.
    pub extensions: Vec<Box<dyn Extension>>,
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

    pub(crate) fn extension(&self, name: &str) -> Option<&dyn Extension> {
        self.extensions.iter().find(|one| one.name() == name).map(|one| &**one)
    }

    /// Whether a tree with this hash is that of the program.
    pub(crate) fn has_tree(&self, hash: &str) -> bool {
        self.graph.is_some_and(|graph| format!("{:016x}", bica::graph::hash(graph)) == hash)
    }
}

//! Additions of a program to the monitor: worlds, replay, images, panels.

mod extension;
mod images;
mod replay;
mod world;

pub use crate::protocol::WorldOption;
pub use bica_link::Image;
pub use extension::{Asked, Extension, Remembered, Reply, Work};
pub use images::ImageFiles;
pub use replay::Rerun;
pub use world::{Game, LocalWorld, WorldRun, WorldSetup};

use bica::Graph;

use crate::protocol::Failed;

/// Additions of a program to the monitor.
#[derive(Default)]
pub struct Program {
    /// Tree of the program's robot. Tune files are checked with it, and recordings of this tree can be run again.
    pub graph: Option<&'static Graph>,
    /// Worlds that the program can simulate. The first one is shown if the command line names neither a source nor a world.
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
    /// If there is no world with this name.
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

    /// Returns whether the program's tree has this hash.
    pub(crate) fn has_tree(&self, hash: &str) -> bool {
        self.graph.is_some_and(|graph| format!("{:016x}", bica::graph::hash(graph)) == hash)
    }
}

//! Soccer: the forward's worlds.

mod cli;
mod run;
mod world;

use std::path::PathBuf;
use std::sync::Arc;

use bica_game::FirmwareImage;
use bica_sim::setup::Frame;

use crate::program::{LocalWorld, Program};

pub use run::run;
pub use world::ROBOTS;

/// Options of the forward's worlds.
#[derive(Clone, Debug)]
pub struct SoccerOptions {
    /// Firmware image for the world `firmware`.
    pub firmware: PathBuf,
    /// Size of the camera images of simulated worlds.
    pub size: Frame,
}

impl Default for SoccerOptions {
    fn default() -> Self {
        Self { firmware: FirmwareImage::MONITOR.into(), size: Frame::Small }
    }
}

/// Returns what soccer adds to the monitor.
#[must_use]
pub fn program(options: SoccerOptions) -> Program {
    let options = Arc::new(options);
    let worlds = world::all(&options).into_iter().map(|world| Box::new(world) as Box<dyn LocalWorld>);
    Program { worlds: worlds.collect() }
}

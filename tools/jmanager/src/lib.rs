//! The monitor of the forward: its worlds, replay and panels.

mod cli;
mod colours;
mod images;
mod motions;
mod referee;
mod run;
mod team;
mod world;

use std::path::PathBuf;
use std::sync::Arc;

use bica_player_program::game::{FirmwareImage, GRAPH, rerun};
use bica_sim::setup::Frame;

use bica_monitor::program::{ImageFiles, LocalWorld, Program};

pub use run::run;
pub use world::ROBOTS;

/// Options of the forward's worlds.
#[derive(Clone, Debug)]
pub struct SoccerOptions {
    /// Firmware image for the world `firmware`.
    pub firmware: PathBuf,
    /// Size of the camera images of simulated worlds.
    pub size: Frame,
    /// Folder of saved colour profiles.
    pub profiles: PathBuf,
    /// Folder of labelled images for the colour tuner, if there is one.
    pub images: Option<PathBuf>,
}

impl Default for SoccerOptions {
    fn default() -> Self {
        Self { firmware: FirmwareImage::MONITOR.into(), size: Frame::Small, profiles: "profiles".into(), images: None }
    }
}

/// Returns the program of the monitor with the parts for soccer.
#[must_use]
pub fn program(options: SoccerOptions) -> Program {
    let options = Arc::new(options);
    let worlds = world::all(&options).into_iter().map(|world| Box::new(world) as Box<dyn LocalWorld>);
    let SoccerOptions { profiles, images, .. } = &*options;
    let tuner = colours::Tuner { profiles: profiles.clone(), images: images.clone() };
    Program {
        graph: Some(&GRAPH),
        worlds: worlds.collect(),
        rerun: Some(Box::new(|recording, set, out, progress| rerun(recording, set, out, progress).map(drop))),
        images: images.clone().map(|folder| Box::new(images::LabelledImages(folder)) as Box<dyn ImageFiles>),
        extensions: vec![
            Box::new(tuner),
            Box::new(colours::boundary::Panel),
            Box::new(motions::Motions::new()),
            Box::new(team::Team),
            Box::new(referee::Referee),
        ],
    }
}

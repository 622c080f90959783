//! Detection in the images of a folder.

mod annotation;
mod colour_table;
mod detections;
mod report;
mod see;

use std::path::PathBuf;

use bica_app::{Failure, Outcome, interrupt};
use clap::Args;

use crate::camera_poses::{Pose, Poses};
use crate::frame_io::{RecordedFrame, list};

pub use colour_table::ColourTable;
pub use detections::{Ball, Crossing, Detections, Detectors, Goal, PoseTrust, Robot};
pub use report::watch;
pub use see::{SeeOptions, see};

/// Images and parameters of the detectors.
#[derive(Clone, Debug, Args)]
pub struct DetectionOptions {
    /// Folder with images (PNG, JPEG, raw `NAME_WxH.yuyv`), processed in the order of their names
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Colour profile: built-in, nao2009 or darwin2013; or a file: a profile (TOML) or a table (.bin)
    #[arg(long, value_name = "FILE|NAME", default_value = "nao2009")]
    pub profile: String,
    /// Camera poses, needed for distances [default: `DIR_pose.csv` beside DIR, if it exists]
    #[arg(long, value_name = "CSV")]
    pub poses: Option<PathBuf>,
    /// Radius of the ball, mm
    #[arg(long = "ball", value_name = "MM", default_value = "43", value_parser = millimetres)]
    pub radius: f32,
    /// Write each image with its detections drawn in
    #[arg(long, value_name = "DIR")]
    pub pictures: Option<PathBuf>,
    /// Print the detections as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub json: bool,
}

/// Converts a length in millimetres to metres.
fn millimetres(text: &str) -> Result<f32, String> {
    let fits = text.parse().ok().filter(|length: &f32| (1.0..=1000.0).contains(length));
    fits.map(|length| 1e-3 * length).ok_or_else(|| "give a radius from 1 to 1000 millimetres".to_owned())
}

/// Folder of images with the detectors for it.
#[derive(Debug)]
pub struct Folder {
    files: Vec<PathBuf>,
    poses: Option<Poses>,
    detectors: Detectors,
    pictures: Option<PathBuf>,
}

impl Folder {
    /// Opens a folder: reads the poses and lists the images. `colours` replaces the profile of the options.
    ///
    /// # Errors
    /// If a file cannot be read or there are no images.
    pub fn open(args: &DetectionOptions, colours: ColourTable) -> Result<Self, Failure> {
        let files = list(&args.folder)?;
        let poses = poses_path(args).map(|path| Poses::read(&path)).transpose()?;
        args.pictures.as_deref().map_or(Ok(()), crate::pictures::make_folder)?;
        Ok(Self { files, poses, detectors: Detectors::new(colours, args.radius), pictures: args.pictures.clone() })
    }

    /// Returns whether there are camera poses.
    const fn has_poses(&self) -> bool {
        self.poses.is_some()
    }

    /// Runs the detectors on every image, in the order of their names. Calls `seen` with the name of each file and the
    /// detections and the camera pose, if known, or with the reason why the file was skipped. An error of `seen` ends
    /// the run.
    ///
    /// # Errors
    /// An error of `seen`, or a picture that cannot be written.
    pub fn detect(
        &mut self,
        mut seen: impl FnMut(&str, Result<Detections, String>, Option<&Pose>) -> Result<(), Failure>,
    ) -> Result<Outcome, Failure> {
        let mut outcome = Outcome::Unsuccessful;
        for file in std::mem::take(&mut self.files) {
            if interrupt::requested() {
                return Ok(Outcome::Interrupted);
            }
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let pose = self.poses.as_ref().and_then(|poses| poses.get(&name));
            let recorded = RecordedFrame::read(&file);
            let found = recorded.as_ref().map_err(String::clone);
            let detections = found.and_then(|recorded| self.detectors.detect(&name, &recorded.image(), pose));
            if let (Ok(recorded), Ok(detections)) = (&recorded, &detections) {
                outcome = Outcome::Success;
                if let Some(folder) = &self.pictures {
                    annotation::write(folder, recorded, detections)?;
                }
            }
            seen(&name, detections, pose)?;
        }
        Ok(outcome)
    }
}

/// The given file of poses, or the file beside the folder if it exists.
fn poses_path(args: &DetectionOptions) -> Option<PathBuf> {
    let beside = || {
        let folder = args.folder.canonicalize().ok()?;
        let file = format!("{}_pose.csv", folder.file_name()?.to_string_lossy());
        Some(folder.with_file_name(file)).filter(|path| path.is_file())
    };
    args.poses.clone().or_else(beside)
}

//! Detection in the images of a folder.

mod annotation;
mod colour_table;
mod detections;
mod json_line;
mod report;

use std::path::{Path, PathBuf};

use bica_app::{Failure, Outcome, interrupt};

use crate::camera_poses::{Pose, Poses};
use crate::frame_io::{RecordedFrame, list};

pub use colour_table::ColourTable;
pub use detections::{Ball, Crossing, Detections, Detectors, Goal, PoseTrust, Robot};
pub use json_line::JsonLine;
pub use report::{Report, table_row};

/// Images and parameters of the detectors.
#[derive(Clone, Debug)]
pub struct DetectionOptions {
    /// Folder with the images.
    pub folder: PathBuf,
    /// Colours: name of a profile, or file of a profile (TOML) or of a table (.bin).
    pub profile: String,
    /// File with camera poses; by default `DIR_pose.csv` beside the folder DIR.
    pub poses: Option<PathBuf>,
    /// Radius of the ball, m.
    pub radius: f32,
    /// Folder for the images with detections drawn in.
    pub pictures: Option<PathBuf>,
}

/// Receiver of the detections of each image. An error ends the run.
pub trait DetectionObserver {
    /// Receives the detections in an image; `pose` is the camera pose, if known.
    ///
    /// # Errors
    /// If the run has to end.
    fn detected(&mut self, detections: Detections, pose: Option<&Pose>) -> Result<(), Failure>;
    /// Receives the name of a file that could not be read, and the reason.
    ///
    /// # Errors
    /// If the run has to end.
    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure>;
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
    /// Opens a folder: reads colours and poses, lists the images.
    ///
    /// # Errors
    /// If a file cannot be read or there are no images.
    pub fn open(args: &DetectionOptions) -> Result<Self, Failure> {
        Self::open_with(args, ColourTable::load(&args.profile)?)
    }

    /// Opens a folder with other colours than those of the options.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn open_with(args: &DetectionOptions, colours: ColourTable) -> Result<Self, Failure> {
        let files = list(&args.folder)?;
        let poses = poses_path(args).map(|path| Poses::read(&path)).transpose()?;
        args.pictures.as_deref().map_or(Ok(()), crate::pictures::make_folder)?;
        Ok(Self { files, poses, detectors: Detectors::new(colours, args.radius), pictures: args.pictures.clone() })
    }

    /// Whether there are camera poses.
    #[must_use]
    pub const fn has_poses(&self) -> bool {
        self.poses.is_some()
    }

    /// Runs the detectors on every image, in the order of their names.
    ///
    /// # Errors
    /// An error of `observer`, or a picture that cannot be written.
    pub fn detect(&mut self, observer: &mut impl DetectionObserver) -> Result<Outcome, Failure> {
        let mut outcome = Outcome::Unsuccessful;
        for file in std::mem::take(&mut self.files) {
            if interrupt::requested() {
                return Ok(Outcome::Interrupted);
            }
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let pose = self.poses.as_ref().and_then(|poses| poses.get(&name));
            match detect(&mut self.detectors, &file, &name, pose) {
                Ok((recorded, detections)) => {
                    if let Some(folder) = &self.pictures {
                        annotation::write(folder, &recorded, &detections)?;
                    }
                    outcome = Outcome::Success;
                    observer.detected(detections, pose)?;
                }
                Err(why) => observer.skipped(&name, why)?,
            }
        }
        Ok(outcome)
    }
}

fn detect(
    detectors: &mut Detectors,
    file: &Path,
    name: &str,
    pose: Option<&Pose>,
) -> Result<(RecordedFrame, Detections), String> {
    let recorded = RecordedFrame::read(file)?;
    let detections = detectors.detect(name, &recorded.image(), pose)?;
    Ok((recorded, detections))
}

/// The given file of poses, or the one beside the folder if it exists.
fn poses_path(args: &DetectionOptions) -> Option<PathBuf> {
    let beside = || {
        let folder = args.folder.canonicalize().ok()?;
        let file = format!("{}_pose.csv", folder.file_name()?.to_string_lossy());
        Some(folder.with_file_name(file)).filter(|path| path.is_file())
    };
    args.poses.clone().or_else(beside)
}

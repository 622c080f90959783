//! From files to what is seen in them.

mod annotation;
mod colour_table;
mod detections;
mod line;
mod report;

use std::path::{Path, PathBuf};

use crate::camera_poses::{Pose, Poses};
use crate::frame_io::{Recorded, list};
use bica_console::{Failure, Outcome, interrupt, make_folder};
pub use colour_table::Palette;
pub use detections::{Ball, Crossing, Eyes, Goal, Robot, Sighting, Trust};
pub use line::Line;
pub use report::{Report, line};

/// What is looked at, and with which eyes.
#[derive(Clone, Debug)]
pub struct Looking {
    /// The folder with the images.
    pub folder: PathBuf,
    /// The colours: a profile by its name or from a file (TOML), or a table from a file (.bin).
    pub profile: String,
    /// A file with camera poses.
    pub poses: Option<PathBuf>,
    /// Radius of the ball, m.
    pub radius: f32,
    /// The folder for images with what was recognised drawn in.
    pub pictures: Option<PathBuf>,
}

/// Who is told what is seen.
pub trait Listener {
    /// Something was seen; `pose` is the camera's if the file of poses has it.
    fn saw(&mut self, sighting: Sighting, pose: Option<&Pose>) -> Result<(), Failure>;
    /// A file could not be looked at.
    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure>;
}

/// A folder, opened to be looked at.
pub struct Folder {
    files: Vec<PathBuf>,
    poses: Option<Poses>,
    eyes: Eyes,
    pictures: Option<PathBuf>,
}

impl Folder {
    /// Reads all but the images.
    pub fn open(args: &Looking) -> Result<Self, Failure> {
        let palette = Palette::load(&args.profile)?;
        let files = list(&args.folder)?;
        let poses = poses_path(args).map(|path| Poses::read(&path)).transpose()?;
        args.pictures.as_deref().map_or(Ok(()), make_folder)?;
        Ok(Self { files, poses, eyes: Eyes::new(palette, args.radius), pictures: args.pictures.clone() })
    }

    /// Whether there are camera poses.
    pub const fn has_poses(&self) -> bool {
        self.poses.is_some()
    }

    /// Looks at every image, in the order of their names.
    pub fn look(&mut self, listener: &mut impl Listener) -> Result<Outcome, Failure> {
        let mut ending = Outcome::Unsuccessful;
        for file in std::mem::take(&mut self.files) {
            if interrupt::requested() {
                return Ok(Outcome::Interrupted);
            }
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let pose = self.poses.as_ref().and_then(|poses| poses.get(&name));
            match look(&mut self.eyes, &file, &name, pose) {
                Ok((recorded, sighting)) => {
                    if let Some(folder) = &self.pictures {
                        annotation::write(folder, &recorded, &sighting)?;
                    }
                    ending = Outcome::Success;
                    listener.saw(sighting, pose)?;
                }
                Err(why) => listener.skipped(&name, why)?,
            }
        }
        Ok(ending)
    }
}

fn look(eyes: &mut Eyes, file: &Path, name: &str, pose: Option<&Pose>) -> Result<(Recorded, Sighting), String> {
    let recorded = Recorded::read(file)?;
    let sighting = eyes.look(name, &recorded.image(), pose)?;
    Ok((recorded, sighting))
}

/// The file that was named, or the one beside the folder if there is one.
fn poses_path(args: &Looking) -> Option<PathBuf> {
    let beside = || {
        let folder = args.folder.canonicalize().ok()?;
        let file = format!("{}_pose.csv", folder.file_name()?.to_string_lossy());
        Some(folder.with_file_name(file)).filter(|path| path.is_file())
    };
    args.poses.clone().or_else(beside)
}

//! From files to what is seen in them.

mod draw;
mod frames;
mod jpeg;
mod palette;
mod poses;
mod raw;
mod sighting;

use std::path::{Path, PathBuf};

use super::cli::Looking;
use super::ending::{Ending, Failure};
use super::game::album::make_folder;
use super::stop;
pub(crate) use frames::{Recorded, list, stem};
pub(crate) use palette::Palette;
pub(crate) use poses::Pose;
use poses::Poses;
pub(crate) use sighting::{Ball, Crossing, Eyes, Goal, Robot, Sighting, Trust};

/// Who is told what is seen.
pub(crate) trait Listener {
    /// Something was seen; `pose` is the camera's if the file of poses has it.
    fn saw(&mut self, sighting: Sighting, pose: Option<&Pose>) -> Result<(), Failure>;
    /// A file could not be looked at.
    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure>;
}

/// A folder, opened to be looked at.
pub(crate) struct Folder {
    files: Vec<PathBuf>,
    poses: Option<Poses>,
    eyes: Eyes,
    pictures: Option<PathBuf>,
}

impl Folder {
    /// Reads all but the images.
    pub(crate) fn open(args: &Looking) -> Result<Self, Failure> {
        let palette = Palette::load(&args.profile)?;
        let files = list(&args.folder)?;
        let poses = poses_path(args).map(|path| Poses::read(&path)).transpose()?;
        args.pictures.as_deref().map_or(Ok(()), make_folder)?;
        Ok(Self { files, poses, eyes: Eyes::new(palette, 1e-3 * args.ball), pictures: args.pictures.clone() })
    }

    /// Whether there are camera poses.
    pub(crate) const fn has_poses(&self) -> bool {
        self.poses.is_some()
    }

    /// Looks at every image, in the order of their names.
    pub(crate) fn look(&mut self, listener: &mut impl Listener) -> Result<Ending, Failure> {
        let mut ending = Ending::Missed;
        for file in std::mem::take(&mut self.files) {
            if stop::asked() {
                return Ok(Ending::Interrupted);
            }
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            let pose = self.poses.as_ref().and_then(|poses| poses.get(&name));
            match look(&mut self.eyes, &file, &name, pose) {
                Ok((recorded, sighting)) => {
                    if let Some(folder) = &self.pictures {
                        draw::write(folder, &recorded, &sighting)?;
                    }
                    ending = Ending::Reached;
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

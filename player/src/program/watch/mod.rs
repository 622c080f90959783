//! `player watch`: the eyes over a folder of recorded images.

mod draw;
mod frames;
mod poses;
mod report;
mod sighting;

use std::path::{Path, PathBuf};

use super::cli::Watch;
use super::ending::{Ending, Failure};
use super::game::album::make_folder;
use super::stop;
use super::voice::Voice;
use frames::Recorded;
use poses::Poses;
use report::Report;
use sighting::{Eyes, Sighting};

/// Looks at every image of the folder, and tells what is seen.
pub(crate) fn run(args: &Watch) -> Result<Ending, Failure> {
    let voice = Voice::new(args.json);
    let files = frames::list(&args.folder)?;
    let poses = poses_path(args).map(|path| Poses::read(&path)).transpose()?;
    args.pictures.as_deref().map_or(Ok(()), make_folder)?;
    let mut report = Report::new(&args.folder, poses.is_some());
    Report::begin(voice)?;
    let mut eyes = Eyes::new();
    for file in files {
        if stop::asked() {
            break;
        }
        match look(&mut eyes, &file, poses.as_ref()) {
            Ok((recorded, sighting)) => {
                if let Some(folder) = &args.pictures {
                    draw::write(folder, &recorded, &sighting)?;
                }
                report.saw(voice, sighting)?;
            }
            Err(why) => report.skipped(voice, &name(&file), why)?,
        }
    }
    report.end(voice)?;
    Ok(if stop::asked() {
        Ending::Interrupted
    } else if report.is_empty() {
        Ending::Missed
    } else {
        Ending::Reached
    })
}

fn look(eyes: &mut Eyes, file: &Path, poses: Option<&Poses>) -> Result<(Recorded, Sighting), String> {
    let recorded = Recorded::read(file)?;
    let name = name(file);
    let sighting = eyes.look(&name, &recorded.image(), poses.and_then(|poses| poses.get(&name)))?;
    Ok((recorded, sighting))
}

fn name(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The file that was named, or the one beside the folder if there is one.
fn poses_path(args: &Watch) -> Option<PathBuf> {
    let beside = || {
        let folder = args.folder.canonicalize().ok()?;
        let file = format!("{}_pose.csv", folder.file_name()?.to_string_lossy());
        Some(folder.with_file_name(file)).filter(|path| path.is_file())
    };
    args.poses.clone().or_else(beside)
}

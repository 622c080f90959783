//! `player watch`: the eyes over a folder of recorded images, told and summed up.

mod report;

use super::cli::Watch;
use super::ending::{Ending, Failure};
use super::look::Folder;
use super::voice::Voice;
use report::Report;
pub(crate) use report::line;

/// Looks at every image of the folder, and tells what is seen.
pub(crate) fn run(args: &Watch) -> Result<Ending, Failure> {
    let mut folder = Folder::open(&args.looking)?;
    let mut report = Report::new(Voice::new(args.looking.json), &args.looking.folder, folder.has_poses());
    report.begin()?;
    let ending = folder.look(&mut report)?;
    report.end()?;
    Ok(ending)
}

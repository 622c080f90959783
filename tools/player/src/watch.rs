//! `player watch`: the detectors over a folder of recorded images, with a summary.

use bica_app::{Console, Failure, Outcome};
use bica_evaluation::detection::{Folder, Report};

use crate::cli::Watch;

/// Runs the detectors on every image of the folder and prints a summary.
pub(crate) fn run(args: &Watch) -> Result<Outcome, Failure> {
    let options = args.detection.options();
    let mut folder = Folder::open(&options)?;
    let mut report = Report::new(Console::new(args.detection.json), &options.folder, folder.has_poses());
    report.begin()?;
    let outcome = folder.detect(&mut report)?;
    report.end()?;
    Ok(outcome)
}

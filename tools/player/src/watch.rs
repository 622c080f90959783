//! `player watch`: the detectors over a folder of recorded images, with a summary.

use bica_console::{Console, Failure, Outcome};
use bica_evaluation::detection::{Folder, Report};

use crate::cli::Watch;

/// Looks at every image of the folder, and tells what is seen.
pub(crate) fn run(args: &Watch) -> Result<Outcome, Failure> {
    let looking = args.looking.options();
    let mut folder = Folder::open(&looking)?;
    let mut report = Report::new(Console::new(args.looking.json), &looking.folder, folder.has_poses());
    report.begin()?;
    let outcome = folder.look(&mut report)?;
    report.end()?;
    Ok(outcome)
}

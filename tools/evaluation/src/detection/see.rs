//! Detections of each recorded image on one line, and their score.

use std::path::PathBuf;

use bica_app::{Console, Failure, Outcome};
use clap::Args;

use super::report::{skipped_row, table_row};
use super::{ColourTable, DetectionOptions, Folder};
use crate::labels::Labels;
use crate::scoring::Score;

/// Images, and labels to compare with.
#[derive(Clone, Debug, Args)]
pub struct SeeOptions {
    #[command(flatten)]
    detection: DetectionOptions,
    /// Labels; print a score of the detections against them
    #[arg(long, value_name = "CSV")]
    score: Option<PathBuf>,
}

/// Runs the detectors on every image of the folder, and prints a line for each and the score.
///
/// # Errors
/// If a file of the options cannot be read, or the output cannot be written.
pub fn see(SeeOptions { detection: options, score }: &SeeOptions) -> Result<Outcome, Failure> {
    let console = Console::new(options.json);
    let labels = score.as_ref().map(|path| Labels::read(path, &options.folder)).transpose()?;
    let mut folder = Folder::open(options, ColourTable::load(&options.profile)?)?;
    let mut score = labels.map(|labels| Score::new(labels, options.radius));
    let outcome = folder.detect(|file, seen, pose| match seen {
        Ok(detections) => {
            if let Some(score) = &mut score {
                score.count(&detections, pose);
            }
            if console.is_json() {
                console.print_json_line(&detections)
            } else {
                console.print(&table_row(&detections))
            }
        }
        Err(why) => console.print(&skipped_row(console, file, &why)),
    })?;
    score.map_or(Ok(outcome), |mut score| score.print(console).map(|()| outcome))
}

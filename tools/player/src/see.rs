//! `player see`: detections of each recorded image on a line, and their score.

use bica_app::{Console, Failure, Outcome, Style};
use bica_evaluation::camera_poses::Pose;
use bica_evaluation::detection::{self, DetectionObserver, Detections, Folder, JsonLine};
use bica_evaluation::labels::Labels;
use bica_evaluation::scoring::Score;

use crate::cli::See;

/// Runs the detectors on every image of the folder.
pub(crate) fn run(args: &See) -> Result<Outcome, Failure> {
    let options = args.detection.options();
    let labels = args.score.as_ref().map(|path| Labels::read(path, &options.folder)).transpose()?;
    let mut folder = Folder::open(&options)?;
    let score = labels.map(|labels| Score::new(labels, options.radius));
    let mut lines = Lines { console: Console::new(args.detection.json), score };
    let outcome = folder.detect(&mut lines)?;
    if let Some(score) = &mut lines.score {
        score.print(lines.console)?;
    }
    Ok(outcome)
}

/// Prints a line for each image.
struct Lines {
    console: Console,
    score: Option<Score>,
}

impl DetectionObserver for Lines {
    fn detected(&mut self, detections: Detections, pose: Option<&Pose>) -> Result<(), Failure> {
        if let Some(score) = &mut self.score {
            score.count(&detections, pose);
        }
        if self.console.is_json() {
            self.console.print_json_line(&JsonLine::new(&detections))
        } else {
            self.console.print(&detection::table_row(&detections))
        }
    }

    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure> {
        let words = self.console.styled(Style::Bad, &format!("skipped, {why}"));
        self.console.print(&format!("{file:<12} {words}"))
    }
}

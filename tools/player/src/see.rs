//! `player see`: one line for each recorded image, and how much of it was right.

use bica_console::{Console, Failure, Outcome, Style};
use bica_evaluation::camera_poses::Pose;
use bica_evaluation::detection::{self, Folder, Line, Listener, Sighting};
use bica_evaluation::labels::Labels;
use bica_evaluation::scoring::Score;

use crate::cli::See;

/// Looks at every image of the folder, and tells what is seen.
pub(crate) fn run(args: &See) -> Result<Outcome, Failure> {
    let looking = args.looking.options();
    let labels = args.score.as_ref().map(|path| Labels::read(path, &looking.folder)).transpose()?;
    let mut folder = Folder::open(&looking)?;
    let score = labels.map(|labels| Score::new(labels, looking.radius));
    let mut lines = Lines { console: Console::new(args.looking.json), score };
    let outcome = folder.look(&mut lines)?;
    if let Some(score) = &mut lines.score {
        score.tell(lines.console)?;
    }
    Ok(outcome)
}

/// Prints a line for each image.
struct Lines {
    console: Console,
    score: Option<Score>,
}

impl Listener for Lines {
    fn saw(&mut self, sighting: Sighting, pose: Option<&Pose>) -> Result<(), Failure> {
        if let Some(score) = &mut self.score {
            score.count(&sighting, pose);
        }
        if self.console.is_json() {
            self.console.print_json_line(&Line::new(&sighting))
        } else {
            self.console.print(&detection::line(&sighting))
        }
    }

    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure> {
        let words = self.console.styled(Style::Bad, &format!("skipped, {why}"));
        self.console.print(&format!("{file:<12} {words}"))
    }
}

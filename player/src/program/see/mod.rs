//! `player see`: one line for each recorded image, and how much of it was right.

mod goals;
mod line;
mod score;
mod tally;

use super::cli::See;
use super::ending::{Ending, Failure};
use super::labels::Labels;
use super::look::{Folder, Listener, Pose, Sighting};
use super::voice::{Style, Voice};
use super::watch;
use score::Score;

/// Looks at every image of the folder, and tells what is seen.
pub(crate) fn run(args: &See) -> Result<Ending, Failure> {
    let looking = &args.looking;
    let labels = args.score.as_ref().map(|path| Labels::read(path, &looking.folder)).transpose()?;
    let mut folder = Folder::open(looking)?;
    let score = labels.map(|labels| Score::new(labels, 1e-3 * looking.ball));
    let mut lines = Lines { voice: Voice::new(looking.json), score };
    let ending = folder.look(&mut lines)?;
    if let Some(score) = &mut lines.score {
        score.tell(lines.voice)?;
    }
    Ok(ending)
}

/// Prints a line for each image.
struct Lines {
    voice: Voice,
    score: Option<Score>,
}

impl Listener for Lines {
    fn saw(&mut self, sighting: Sighting, pose: Option<&Pose>) -> Result<(), Failure> {
        if let Some(score) = &mut self.score {
            score.count(&sighting, pose);
        }
        if self.voice.is_json() {
            self.voice.line(&line::Line::new(&sighting))
        } else {
            self.voice.say(&watch::line(&sighting))
        }
    }

    fn skipped(&mut self, file: &str, why: String) -> Result<(), Failure> {
        let words = self.voice.style(Style::Bad, &format!("skipped, {why}"));
        self.voice.say(&format!("{file:<12} {words}"))
    }
}

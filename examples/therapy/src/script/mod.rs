//! Session language, in which a therapist writes a session as text.
//!
//! [`Script::parse`] checks the whole text. A script that it returns can be run: each jump has its target, each step
//! can be reached, each wait has a limit, and each loop contains a pause. [`Script::check_files`] checks the sound
//! files.

mod build;
mod command;
mod flow;
mod problem;
#[cfg(test)]
mod tests;
mod text;
mod wav;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

pub use problem::Problem;

use self::words::Place;
use crate::robot::Order;
use crate::session::Step;

/// A session.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// Its title.
    pub(crate) title: String,
    /// Its steps.
    pub(crate) steps: Vec<Step>,
    /// Line of each step, from 1.
    pub(crate) lines: Vec<usize>,
    /// Clips of sound; steps refer to them by their index.
    pub(crate) clips: Vec<Clip>,
    /// Position of the file name of each clip in the text: line and column.
    places: Vec<Place>,
}

/// Clip of sound.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Clip {
    /// A file in WAV format, relative to the script.
    File(PathBuf),
    /// A text that is spoken.
    Text {
        /// The text.
        text: String,
        /// Code of its language in ISO 639-1.
        language: String,
    },
}

/// Script with one command of each kind; `therapy new` writes it.
pub(crate) const EXAMPLE: &str = include_str!("example.session");

impl Script {
    /// Parses a script and checks it.
    ///
    /// # Errors
    /// All problems, in the order of their positions.
    pub fn parse(text: &str) -> Result<Self, Vec<Problem>> {
        let (script, mut problems) = build::build(text);
        if problems.is_empty() {
            problems.extend(flow::check(&script));
        }
        problems.sort_by_key(|problem| (problem.line, problem.column));
        if problems.is_empty() { Ok(script) } else { Err(problems) }
    }

    /// Decodes the text of a file.
    ///
    /// # Errors
    /// If the text is not UTF-8 with line ends of Unix or Windows. The problem names the encoding and how to save the file.
    pub fn decode(bytes: &[u8]) -> Result<String, Problem> {
        text::decode(bytes)
    }

    /// Checks that the sound files, relative to a folder, exist and are in WAV format.
    #[must_use]
    pub fn check_files(&self, folder: &Path) -> Vec<Problem> {
        let check = |(clip, at): (&Clip, &Place)| Some(Problem::at(*at, clip.seconds(folder).err()?));
        self.clips.iter().zip(&self.places).filter_map(check).collect()
    }

    /// Returns the orders that load the session into the robot; the files are relative to `folder`. A file that cannot
    /// be read has the duration 0.
    #[must_use]
    pub fn orders(&self, folder: &Path) -> Vec<Order> {
        let clips = self.clips.iter().map(|clip| Order::Clip(clip.seconds(folder).unwrap_or(0.0)));
        clips.chain(self.steps.iter().copied().map(Order::Step)).chain([Order::Loaded]).collect()
    }
}

impl Clip {
    /// Duration, s: measured for a file, estimated for a text.
    fn seconds(&self, folder: &Path) -> Result<f32, String> {
        let file = match self {
            Self::Text { text, .. } => return Ok(PAUSE + text.chars().count() as f32 / CHARACTERS),
            Self::File(file) => file,
        };
        let bytes = fs::read(folder.join(file))
            .map_err(|error| format!("the file `{}` cannot be read: {error}", file.display()))?;
        wav::seconds(&bytes).map_err(|why| format!("the file `{}` {why}", file.display()))
    }
}

/// Estimated duration of spoken texts: a pause, s, and a number of characters per second. Our choice: slow speech.
const PAUSE: f32 = 0.5;
const CHARACTERS: f32 = 12.0;

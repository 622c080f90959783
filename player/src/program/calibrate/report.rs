//! What was learned, for people, for machines and for the profile.

use serde::Serialize;

use super::blocks::Learned;
use super::{Lessons, Teachers};
use crate::program::cli::Calibrate;
use crate::program::ending::Failure;
use crate::program::game::summary::row;
use crate::program::profile::{CLASSES, Notes};
use crate::program::voice::{Style, Voice};

/// What was learned.
#[derive(Debug, Serialize)]
pub(super) struct Report<'a> {
    schema: &'static str,
    images: usize,
    rectangles: usize,
    labelled_images: usize,
    base: &'a str,
    classes: Vec<Class<'a>>,
    profile: Option<String>,
}

#[derive(Debug, Serialize)]
struct Class<'a> {
    class: &'static str,
    learned: Option<&'a Learned>,
}

impl<'a> Report<'a> {
    pub(super) fn new(args: &'a Calibrate, teachers: &Teachers, lessons: &'a Lessons) -> Self {
        let classes = CLASSES.into_iter().zip(lessons);
        Self {
            schema: "bica-player/calibrate/1",
            images: teachers.images,
            rectangles: teachers.used_rectangles,
            labelled_images: teachers.used_labels,
            base: &args.base,
            classes: classes.map(|(class, (_, learned))| Class { class, learned: learned.as_ref() }).collect(),
            profile: args.out.as_ref().map(|path| path.display().to_string()),
        }
    }

    /// For the profile.
    pub(super) fn notes(&self) -> Notes {
        let mut notes = Notes { top: vec![self.sources()], ..Notes::default() };
        for (lines, class) in notes.classes.iter_mut().zip(&self.classes) {
            lines.push(class.learned.map_or_else(|| format!("No labels: as in the profile `{}`, but more saturated than what is known to be something else.", self.base), figures));
        }
        notes
    }

    fn sources(&self) -> String {
        let Self { images, rectangles, labelled_images, .. } = self;
        format!(
            "Learned by `player calibrate` from {images} images: {rectangles} rectangles, {labelled_images} with labels."
        )
    }

    /// Prints it.
    pub(super) fn tell(&self, voice: Voice) -> Result<(), Failure> {
        voice.say(&self.sources())?;
        voice.say(
            &voice.style(Style::Faint, "precision and recall of pixels; each rectangle, each ball counts alike"),
        )?;
        for Class { class, learned } in &self.classes {
            let words = learned.map_or_else(|| format!("not learned, as in `{}`", self.base), figures);
            row(voice, class, &words)?;
        }
        if let Some(profile) = &self.profile {
            row(voice, "written", profile)?;
        }
        voice.result(self)
    }
}

fn figures(learned: &Learned) -> String {
    let Learned { images, blocks, precision, recall, .. } = learned;
    let how = match blocks {
        1 => "one image, not cross-validated".to_owned(),
        _ => format!("{images} images, cross-validated in {blocks} blocks of neighbours"),
    };
    format!("precision {precision:.3}, recall {recall:.3} ({how})")
}

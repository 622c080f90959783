//! What was learned, for people, for machines and for the profile.

use serde::Serialize;

use super::blocks::Learned;
use super::{Calibrate, Lessons, Teachers};
use crate::profile::{CLASSES, Notes};
use bica_console::Failure;
use bica_console::{Console, Style};

/// What was learned.
#[derive(Debug, Serialize)]
pub struct Report<'a> {
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
    pub fn new(args: &'a Calibrate, teachers: &Teachers, lessons: &'a Lessons) -> Self {
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
    pub fn notes(&self) -> Notes {
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
    pub fn tell(&self, console: Console) -> Result<(), Failure> {
        console.print(&self.sources())?;
        console.print(
            &console.styled(Style::Faint, "precision and recall of pixels; each rectangle, each ball counts alike"),
        )?;
        for Class { class, learned } in &self.classes {
            let words = learned.map_or_else(|| format!("not learned, as in `{}`", self.base), figures);
            console.print_row(class, &words)?;
        }
        if let Some(profile) = &self.profile {
            console.print_row("written", profile)?;
        }
        console.print_json(self)
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

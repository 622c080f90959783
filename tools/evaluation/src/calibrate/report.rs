//! Result of a calibration, as text, as JSON and as comments of the profile.

use bica_app::{Console, Failure, Style};
use serde::Serialize;

use super::cross_validation::FittedClass;
use super::{CalibrationOptions, FittedClasses, TrainingData};
use crate::profile::{CLASSES, Notes};

/// Result of a calibration.
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
    learned: Option<&'a FittedClass>,
}

impl<'a> Report<'a> {
    pub(super) fn new(args: &'a CalibrationOptions, data: &TrainingData, classes: &'a FittedClasses) -> Self {
        let classes = CLASSES.into_iter().zip(classes);
        Self {
            schema: "bica-player/calibrate/1",
            images: data.images,
            rectangles: data.used_rectangles,
            labelled_images: data.used_labels,
            base: &args.base,
            classes: classes.map(|(class, (_, learned))| Class { class, learned: learned.as_ref() }).collect(),
            profile: args.out.as_ref().map(|path| path.display().to_string()),
        }
    }

    /// Returns the comments of the profile.
    pub(super) fn notes(&self) -> Notes {
        let mut notes = Notes { top: vec![self.sources()], ..Notes::default() };
        for (lines, class) in notes.classes.iter_mut().zip(&self.classes) {
            lines.push(class.learned.map_or_else(
                || {
                    format!(
                        "No labels: as in the profile `{}`, with the least saturation above that of other classes.",
                        self.base
                    )
                },
                figures,
            ));
        }
        notes
    }

    fn sources(&self) -> String {
        let Self { images, rectangles, labelled_images, .. } = self;
        format!(
            "Fitted by `player calibrate` from {images} images: {rectangles} rectangles, {labelled_images} with labels."
        )
    }

    /// Prints the result.
    pub(super) fn print(&self, console: Console) -> Result<(), Failure> {
        console.print(&self.sources())?;
        console.print(&console.styled(
            Style::Faint,
            "precision and recall of pixels; each rectangle and each ball has the same weight",
        ))?;
        for Class { class, learned } in &self.classes {
            let words = learned.map_or_else(|| format!("no labels, as in `{}`", self.base), figures);
            console.print_row(class, &words)?;
        }
        if let Some(profile) = &self.profile {
            console.print_row("written", profile)?;
        }
        console.print_json(self)
    }
}

fn figures(learned: &FittedClass) -> String {
    let FittedClass { images, blocks, precision, recall, .. } = learned;
    let how = match blocks {
        1 => "one image, not cross-validated".to_owned(),
        _ => format!("{images} images, cross-validated in {blocks} blocks of neighbours"),
    };
    format!("precision {precision:.3}, recall {recall:.3} ({how})")
}

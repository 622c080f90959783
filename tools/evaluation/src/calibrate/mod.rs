//! `player calibrate`: colour classes learned from labelled images.

mod blocks;
mod fit;
mod rectangles;
mod report;
mod samples;

use std::path::{Path, PathBuf};

use bica_vision::colour::{Colour, Filter, Filters};
use bica_vision::frame::Frame;

use crate::frame_io::{self, Recorded};
use crate::labels::{Labels, own_folder};
use crate::profile;
use bica_console::{Console, Failure, Outcome, interrupt};
use blocks::{Learned, guarded, learn};
use rectangles::Rectangle;
use report::Report;
use samples::{Sample, Samples};

/// What was learned of each class, in the order of decision.
type Lessons = [(Colour, Option<Learned>); 5];

/// What to learn from, and where the profile goes.
#[derive(Clone, Debug)]
pub struct Calibrate {
    /// The folder with the images.
    pub folder: PathBuf,
    /// Files with rectangles of one class each.
    pub rectangles: Vec<PathBuf>,
    /// A file with labelled balls and goals.
    pub labels: Option<PathBuf>,
    /// The profile, by name or file, that classes without labels are taken from.
    pub base: String,
    /// The file that the profile is written to.
    pub out: Option<PathBuf>,
}

/// Learns a profile from the images of a folder, tells how good it is, and writes it.
pub fn run(args: &Calibrate, console: Console) -> Result<Outcome, Failure> {
    let base = profile::load(&args.base)?;
    let mut teachers = Teachers::read(args)?;
    let samples = teachers.teach(&args.folder)?;
    if interrupt::requested() {
        return Ok(Outcome::Interrupted);
    }
    let samples = samples.weighed();
    let lessons = base.in_order().map(|(class, _)| (class, learn(class, &samples)));
    let filters = put_together(&base, &lessons, &samples);
    let report = Report::new(args, &teachers, &lessons);
    if let Some(path) = &args.out {
        let text = profile::write(&filters, &report.notes());
        let mend = "name a file in a folder that can be written to, with --out";
        std::fs::write(path, text).map_err(|error| Failure::of_path("write the profile", path, &error, mend))?;
    }
    report.tell(console)?;
    Ok(if lessons.iter().any(|(_, learned)| learned.is_some()) { Outcome::Success } else { Outcome::Unsuccessful })
}

fn put_together(base: &Filters, lessons: &Lessons, samples: &[Sample]) -> Filters {
    let learned = |class| lessons.iter().find(|(of, _)| *of == class).and_then(|(_, learned)| learned.as_ref());
    let filter = |class, base: Filter| {
        // White is all that is grey: walls, robots, and what else stands around.
        let kept = || if class == Colour::White { base } else { guarded(class, &base, samples) };
        learned(class).map_or_else(kept, |learned| learned.filter)
    };
    Filters {
        orange: filter(Colour::Orange, base.orange),
        yellow: filter(Colour::Yellow, base.yellow),
        blue: filter(Colour::Blue, base.blue),
        white: filter(Colour::White, base.white),
        green: filter(Colour::Green, base.green),
    }
}

/// Labels and rectangles, and how many of them were of use.
struct Teachers {
    rectangles: Vec<Rectangle>,
    labels: Option<Labels>,
    images: usize,
    used_rectangles: usize,
    used_labels: usize,
}

impl Teachers {
    fn read(args: &Calibrate) -> Result<Self, Failure> {
        if args.rectangles.is_empty() && args.labels.is_none() {
            let mend = "name a CSV file with --rectangles or --labels";
            return Err(Failure::new("there is nothing to learn from", mend));
        }
        let mut rectangles = Vec::new();
        for path in &args.rectangles {
            rectangles.extend(rectangles::read(path)?);
        }
        let own = own_folder(&args.folder);
        if rectangles.iter().any(|rectangle| rectangle.file.starts_with(&own)) {
            rectangles.retain(|rectangle| rectangle.file.starts_with(&own));
        }
        let labels = args.labels.as_ref().map(|path| Labels::read(path, &args.folder)).transpose()?;
        Ok(Self { rectangles, labels, images: 0, used_rectangles: 0, used_labels: 0 })
    }

    /// Gathers what is known of the pixels of a folder.
    fn teach(&mut self, folder: &Path) -> Result<Samples, Failure> {
        let mut samples = Samples::default();
        for (image, path) in frame_io::list(folder)?.into_iter().enumerate() {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let own = self.rectangles.iter().filter(|of| frame_io::stem(&of.file) == frame_io::stem(&name));
            let own: Vec<&Rectangle> = own.collect();
            let label = self.labels.as_ref().and_then(|labels| labels.get(&name));
            if interrupt::requested() || (own.is_empty() && label.is_none()) {
                continue;
            }
            let wrong =
                |why: &str| Failure::of_path("learn from", &path, &why, "mend the image, or take its labels away");
            let recorded = Recorded::read(&path).map_err(|why| wrong(&why))?;
            let frame = Frame::from_image(&recorded.image()).map_err(|why| wrong(&why.to_string()))?;
            for rectangle in &own {
                samples.add_rectangle(image, &frame, rectangle);
            }
            if let Some(label) = label {
                samples.add_label(image, &frame, label);
            }
            self.images += 1;
            self.used_rectangles += own.len();
            self.used_labels += usize::from(label.is_some());
        }
        Ok(samples)
    }
}

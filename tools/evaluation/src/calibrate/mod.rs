//! Colour calibration: thresholds of the classes, fitted to labelled images.

mod cross_validation;
mod fit;
mod rectangles;
mod report;
mod samples;

use std::path::{Path, PathBuf};

use bica_app::{Console, Failure, Outcome, interrupt};
use bica_vision::colour::{Colour, Filter, Filters};
use bica_vision::frame::Frame;
use clap::Args;

use crate::frame_io::{self, RecordedFrame};
use crate::labels::{Labels, own_folder};
use crate::profile;
use cross_validation::{FittedClass, fit_class, with_raised_saturation};
use rectangles::Rectangle;
use report::Report;
use samples::{Sample, Samples};

/// Fitted classes, in the order of decision; `None` without a sample.
type FittedClasses = [(Colour, Option<FittedClass>); 5];

/// Inputs and output of a calibration.
#[derive(Clone, Debug, Args)]
pub struct CalibrationOptions {
    /// Folder with images (PNG, JPEG, raw `NAME_WxH.yuyv`)
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Rectangles of one class each, with the columns file, x0, y0, x1, y1, class; may be repeated
    #[arg(long, value_name = "CSV")]
    rectangles: Vec<PathBuf>,
    /// Labelled balls and goals, as for `player see --score`
    #[arg(long, value_name = "CSV")]
    labels: Option<PathBuf>,
    /// Profile, by name or file, whose classes are kept where there are no labels
    #[arg(long, value_name = "FILE|NAME", default_value = "built-in")]
    base: String,
    /// File to write the profile to (TOML)
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    json: bool,
}

/// Fits a profile to the images of a folder, prints its cross-validated quality, and writes it.
///
/// # Errors
/// If an input cannot be read, there are no labels, or the profile cannot be written.
pub fn run(args: &CalibrationOptions) -> Result<Outcome, Failure> {
    let base = profile::load(&args.base)?;
    let mut data = TrainingData::read(args)?;
    let samples = data.collect_samples(&args.folder)?;
    if interrupt::requested() {
        return Ok(Outcome::Interrupted);
    }
    let samples = samples.weighted();
    let classes = base.in_order().map(|(class, _)| (class, fit_class(class, &samples)));
    let filters = merge(&base, &classes, &samples);
    let report = Report::new(args, &data, &classes);
    if let Some(path) = &args.out {
        let text = profile::write(&filters, &report.notes());
        let help = "name a file in a folder that can be written to, with --out";
        std::fs::write(path, text).map_err(|error| Failure::of_path("write the profile", path, &error, help))?;
    }
    report.print(Console::new(args.json))?;
    Ok(if classes.iter().any(|(_, fitted)| fitted.is_some()) { Outcome::Success } else { Outcome::Unsuccessful })
}

fn merge(base: &Filters, classes: &FittedClasses, samples: &[Sample]) -> Filters {
    let fitted = |class| classes.iter().find(|(of, _)| *of == class).and_then(|(_, fitted)| fitted.as_ref());
    let filter = |class, base: Filter| {
        // Walls and robots are grey too, so a raised saturation would reject nothing.
        let kept = || if class == Colour::White { base } else { with_raised_saturation(class, &base, samples) };
        fitted(class).map_or_else(kept, |fitted| fitted.filter)
    };
    Filters {
        orange: filter(Colour::Orange, base.orange),
        yellow: filter(Colour::Yellow, base.yellow),
        blue: filter(Colour::Blue, base.blue),
        white: filter(Colour::White, base.white),
        green: filter(Colour::Green, base.green),
    }
}

/// Labels and rectangles, and the number of those that belong to images of the folder.
struct TrainingData {
    rectangles: Vec<Rectangle>,
    labels: Option<Labels>,
    images: usize,
    used_rectangles: usize,
    used_labels: usize,
}

impl TrainingData {
    fn read(args: &CalibrationOptions) -> Result<Self, Failure> {
        if args.rectangles.is_empty() && args.labels.is_none() {
            let help = "name a CSV file with --rectangles or --labels";
            return Err(Failure::new("there are no labels", help));
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

    /// Collects the samples of a folder.
    fn collect_samples(&mut self, folder: &Path) -> Result<Samples, Failure> {
        let mut samples = Samples::default();
        for (image, path) in frame_io::list(folder)?.into_iter().enumerate() {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let own = self.rectangles.iter().filter(|of| frame_io::stem(&of.file) == frame_io::stem(&name));
            let own: Vec<&Rectangle> = own.collect();
            let label = self.labels.as_ref().and_then(|labels| labels.get(&name));
            if interrupt::requested() || (own.is_empty() && label.is_none()) {
                continue;
            }
            let wrong = |why: &str| Failure::of_path("use", &path, &why, "repair the image, or remove its labels");
            let recorded = RecordedFrame::read(&path).map_err(|why| wrong(&why))?;
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

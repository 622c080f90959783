//! `player calibrate`: colour classes fitted to labelled images.

use bica_app::{Console, Failure, Outcome};
use bica_evaluation::calibrate;

use crate::cli::Calibrate;

/// Fits a profile and writes it.
pub(crate) fn run(args: &Calibrate) -> Result<Outcome, Failure> {
    let Calibrate { folder, rectangles, labels, base, out, json } = args.clone();
    calibrate::run(&calibrate::CalibrationOptions { folder, rectangles, labels, base, out }, Console::new(json))
}

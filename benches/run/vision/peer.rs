//! Frames for the comparison with OpenCV, and the time of all detectors on them.

use std::fs;
use std::path::Path;

use super::figures;
use super::stages::{EVERYTHING, MEMCPY, STAGES};
use bica_benches::frames::FrameSet;

/// Writes the frames of a set to a file `NAME-WIDTHxHEIGHT.yuyv`, without separators.
pub(crate) fn export(frame_set: &FrameSet, folder: &Path) {
    let (width, height) = frame_set.size();
    let bytes: Vec<u8> = frame_set.samples.iter().flat_map(|sample| sample.yuyv.iter().copied()).collect();
    fs::create_dir_all(folder).expect("a folder to write to");
    fs::write(folder.join(format!("{}-{width}x{height}.yuyv", frame_set.name)), bytes).expect("room for the frames");
}

/// Prints the set with its frame size, the mean time of all detectors, the mean time of a copy of the frame, and the
/// time of the slowest frame, µs.
pub(crate) fn everything(frame_set: &FrameSet) {
    let (width, height) = frame_set.size();
    let stages: Vec<_> = STAGES.into_iter().filter(|(stage, _)| [MEMCPY, EVERYTHING].contains(stage)).collect();
    let [floor, all] = &figures::measure(frame_set, &stages)[..] else { return };
    println!("{}-{width}x{height} {:.1} {:.1} {:.1}", frame_set.name, all.mean, floor.mean, all.max);
}

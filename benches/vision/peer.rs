//! Frames for the comparison with OpenCV, and the time of all detectors on them.

use std::fs;
use std::path::Path;

use crate::figures;
use crate::stages::{EVERYTHING, MEMCPY, STAGES};
use bica_benches::frames::FrameSet;

/// Writes the frames of a set to a file `WIDTHxHEIGHT.yuyv`, without separators.
pub(crate) fn export(frame_set: &FrameSet, folder: &Path) {
    let (width, height) = frame_set.size();
    let bytes: Vec<u8> = frame_set.samples.iter().flat_map(|sample| sample.yuyv.iter().copied()).collect();
    fs::create_dir_all(folder).expect("a folder to write to");
    fs::write(folder.join(format!("{width}x{height}.yuyv")), bytes).expect("room for the frames");
}

/// Prints the frame size, the mean time of all detectors and that of a copy of the frame, µs.
pub(crate) fn everything(frame_set: &FrameSet) {
    let (width, height) = frame_set.size();
    let stages: Vec<_> = STAGES.into_iter().filter(|(stage, _)| [MEMCPY, EVERYTHING].contains(stage)).collect();
    let means =
        figures::measure(frame_set, &stages).iter().map(|figure| format!("{:.1}", figure.mean)).collect::<Vec<_>>();
    let [floor, all] = &means[..] else { return };
    println!("{width}x{height} {all} {floor} {} {}", frame_set.name, frame_set.samples.len());
}

//! Frames for the comparison with OpenCV, and the time of all detectors on them.

use std::fs;
use std::path::Path;

use crate::figures;
use crate::stages::{EVERYTHING, MEMCPY, STAGES};
use bica_benches::frames::Album;

/// Writes the frames of an album to a file `WIDTHxHEIGHT.yuyv`, without separators.
pub(crate) fn export(album: &Album, folder: &Path) {
    let (width, height) = album.size();
    let bytes: Vec<u8> = album.shots.iter().flat_map(|shot| shot.yuyv.iter().copied()).collect();
    fs::create_dir_all(folder).expect("a folder to write to");
    fs::write(folder.join(format!("{width}x{height}.yuyv")), bytes).expect("room for the frames");
}

/// Prints the size, the mean time of all detectors and that of a copy of the frame, µs.
pub(crate) fn everything(album: &Album) {
    let (width, height) = album.size();
    let stages: Vec<_> = STAGES.into_iter().filter(|(stage, _)| [MEMCPY, EVERYTHING].contains(stage)).collect();
    let means = figures::measure(album, &stages).iter().map(|figure| format!("{:.1}", figure.mean)).collect::<Vec<_>>();
    let [floor, all] = &means[..] else { return };
    println!("{width}x{height} {all} {floor} {} {}", album.name, album.shots.len());
}

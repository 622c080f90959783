//! Recorded frames, if they are available beside the repository.

use std::path::Path;
use std::sync::LazyLock;

use bica_evaluation::camera_poses::Poses;
use bica_evaluation::frame_io::{RecordedFrame, list};
use bica_vision::profile::{DARWIN_2013, NAO_2009};
use bica_vision::table::CompactTable;

use super::{FrameSet, Sample};

/// Returns the folder of the images; `None`, after one message, if it is missing.
#[must_use]
pub fn folder() -> Option<&'static Path> {
    static FOLDER: LazyLock<Option<&'static Path>> = LazyLock::new(|| {
        let folder = bica_test_data::images();
        if folder.is_dir() {
            return Some(folder);
        }
        eprintln!(
            "recorded frames are skipped: no folder {}; set BICA_SHARED to the folder of images/",
            folder.display()
        );
        None
    });
    *FOLDER
}

/// Loads the recorded frames of two robots, scaled from 320×240 px.
///
/// # Panics
/// If a file cannot be read.
#[must_use]
pub fn frame_sets(folder: &Path, size: (u16, u16)) -> Vec<FrameSet> {
    let poses = Poses::read(&folder.join("nao2009_pose.csv")).expect("poses");
    let frame_set = |(name, filters)| {
        let files = list(&folder.join(name)).expect("a folder of images");
        let samples = files.iter().map(|file| {
            let key = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
            // Images of the other robot have the same names.
            let pose = poses.get(&key).filter(|_| name == "nao2009");
            let camera = pose.map(|pose| pose.camera(size.0.into(), size.1.into()));
            let frame = RecordedFrame::read(file).expect("an image");
            Sample { name: key, width: size.0, height: size.1, yuyv: scaled(frame.image().yuyv, size), camera }
        });
        FrameSet { name, table: CompactTable::compile(filters), samples: samples.collect() }
    };
    [("nao2009", &NAO_2009), ("darwin2013", &DARWIN_2013)].map(frame_set).into()
}

/// Scales an image of 320×240 px by doubling or halving pixels; two pixels share their mean chroma.
fn scaled(yuyv: &[u8], (width, height): (u16, u16)) -> Vec<u8> {
    let at = |x: u16, y: u16| {
        let (x, y) = (usize::from(x) * 320 / usize::from(width), usize::from(y) * 240 / usize::from(height));
        let pair = &yuyv[4 * (160 * y + x / 2)..][..4];
        [pair[2 * (x % 2)], pair[1], pair[3]]
    };
    let pairs =
        (0..height).flat_map(|y| (0..width).step_by(2).map(move |x| (x, y))).map(|(x, y)| (at(x, y), at(x + 1, y)));
    pairs
        .flat_map(|([y0, cb0, cr0], [y1, cb1, cr1])| [y0, u8::midpoint(cb0, cb1), y1, u8::midpoint(cr0, cr1)])
        .collect()
}

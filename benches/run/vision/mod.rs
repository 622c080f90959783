//! Cost of the vision stages on rendered and recorded frames.
//!
//! A copy of the frame is the lower bound, synthetic frames are the worst case. `python3 benches/vision/compare.py` compares with OpenCV.

mod figures;
mod peer;
mod stages;

use std::path::Path;

use bica_benches::frames::{FrameSet, SIZES, recorded, rendered, worst};

/// Seeds of the games whose frames are rendered.
const WORLDS: u64 = 12;

/// Writes all frames to files in a folder, for the comparison with OpenCV.
pub(crate) fn export(folder: &Path) {
    SIZES.iter().flat_map(|size| frame_sets(*size)).for_each(|set| peer::export(&set, folder));
}

/// Prints the time of all detectors on each set of frames, for the comparison with OpenCV.
pub(crate) fn everything() {
    SIZES.iter().flat_map(|size| frame_sets(*size)).for_each(|set| peer::everything(&set));
}

/// Prints the time of each stage for frames of each size, and if wanted the ratio of the worst frames to typical ones; or a line of
/// JSON for each set of frames.
pub(crate) fn run(is_json: bool, with_worst: bool) {
    for size in SIZES {
        let frame_sets = frame_sets(size);
        if is_json {
            frame_sets.iter().for_each(figures::print_json);
        } else {
            figures::print(&frame_sets);
        }
        if with_worst && !is_json {
            figures::print_worst(&worst::frame_set(size), frame_sets.get(1).unwrap_or(&frame_sets[0]));
        }
    }
}

/// Rendered frames of a size, and recorded ones of each robot if available.
fn frame_sets(size: (u16, u16)) -> Vec<FrameSet> {
    let recorded = recorded::folder().into_iter().flat_map(|folder| recorded::frame_sets(folder, size));
    std::iter::once(rendered::frame_set(size, WORLDS)).chain(recorded).collect()
}

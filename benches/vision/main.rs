//! Cost of the vision stages on rendered and recorded frames.
//!
//! `cargo bench -p bica-benches --bench vision` prints a table of minimum times. A copy of the frame is the lower bound, synthetic
//! frames are the worst case. `python3 benches/vision/compare.py` compares with OpenCV. Compare results of one run only, never of two
//! machines.

mod figures;
mod peer;
mod stages;

use bica_benches::frames::{FrameSet, SIZES, recorded, rendered, worst};

/// Seeds of the games whose frames are rendered.
const WORLDS: u64 = 12;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["export", folder, ..] => {
            SIZES.iter().flat_map(|size| frame_sets(*size)).for_each(|set| peer::export(&set, folder.as_ref()));
        }
        ["everything", ..] => SIZES.iter().flat_map(|size| frame_sets(*size)).for_each(|set| peer::everything(&set)),
        _ => SIZES.into_iter().for_each(table),
    }
}

/// Rendered frames of a size, and recorded ones of each robot if available.
fn frame_sets(size: (u16, u16)) -> Vec<FrameSet> {
    let recorded = recorded::folder().into_iter().flat_map(|folder| recorded::frame_sets(folder, size));
    std::iter::once(rendered::frame_set(size, WORLDS)).chain(recorded).collect()
}

/// Prints the time of each stage for frames of a size, and the ratio of the worst frames to typical ones.
fn table(size: (u16, u16)) {
    let frame_sets = frame_sets(size);
    figures::print(&frame_sets);
    figures::print_worst(&worst::frame_set(size), frame_sets.get(1).unwrap_or(&frame_sets[0]));
}

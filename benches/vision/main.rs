//! Cost of the vision stages on rendered and recorded frames.
//!
//! `cargo bench -p bica-benches --bench vision` prints a table of minimum times, then Criterion's results. A copy of
//! the frame is the lower bound, synthetic frames are the worst case. `cargo bench -p bica-benches --bench vision --
//! table` prints the table alone. `python3 benches/vision/compare.py` compares with OpenCV. Compare results of one run only, never of
//! two machines.

mod figures;
mod peer;
mod stages;

use criterion::Criterion;

use crate::stages::{Buffers, Input, STAGES};
use bica_benches::frames::{FrameSet, SIZES, recorded, rendered, worst};

/// Seeds of the games whose frames are rendered.
const WORLDS: u64 = 12;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["table", ..] => {
            tables();
        }
        ["export", folder, ..] => {
            SIZES.iter().flat_map(|size| frame_sets(*size)).for_each(|set| peer::export(&set, folder.as_ref()));
        }
        ["everything", ..] => SIZES.iter().flat_map(|size| frame_sets(*size)).for_each(|set| peer::everything(&set)),
        _ => {
            let mut criterion = Criterion::default().configure_from_args();
            tables().iter().flatten().for_each(|frame_set| bench(&mut criterion, frame_set));
            criterion.final_summary();
        }
    }
}

/// Rendered frames of a size, and recorded ones of each robot if available.
fn frame_sets(size: (u16, u16)) -> Vec<FrameSet> {
    let recorded = recorded::folder().into_iter().flat_map(|folder| recorded::frame_sets(folder, size));
    std::iter::once(rendered::frame_set(size, WORLDS)).chain(recorded).collect()
}

/// Prints the time of each stage for each frame size, and the ratio of the worst frames to typical ones.
fn tables() -> Vec<Vec<FrameSet>> {
    let of_size = |size| {
        let frame_sets = frame_sets(size);
        figures::print(&frame_sets);
        figures::print_worst(&worst::frame_set(size), frame_sets.get(1).unwrap_or(&frame_sets[0]));
        frame_sets
    };
    SIZES.map(of_size).into()
}

/// Measures each stage on all frames of a set.
fn bench(criterion: &mut Criterion, frame_set: &FrameSet) {
    let (width, height) = frame_set.size();
    let input: Vec<_> = frame_set.samples.iter().map(|sample| Input::new(sample, &frame_set.table)).collect();
    let mut buffers = Buffers::new();
    let mut group = criterion.benchmark_group(format!("{} {width}×{height}", frame_set.name));
    for (name, stage) in STAGES {
        let mut frames = input.iter().cycle();
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                if let Some(input) = frames.next() {
                    stage(&mut buffers, input);
                }
            });
        });
    }
    group.finish();
}

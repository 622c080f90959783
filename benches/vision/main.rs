//! Costs of the vision stages on rendered and recorded frames.
//!
//! `cargo bench -p bica-benches --bench vision` prints a table of minimum times, with a copy of the frame as the lower bound and
//! synthetic frames as the worst case, and then Criterion's results. `cargo bench -p bica-benches --bench vision -- table` prints the
//! table alone. `cargo xtask opencv` compares with OpenCV. Compare results of one run only, never of two machines.

mod figures;
mod peer;
mod stages;

use criterion::Criterion;

use crate::stages::{Desk, Given, STAGES};
use bica_benches::frames::{Album, SIZES, recorded, rendered, worst};

/// Seeds of the games whose frames are rendered.
const WORLDS: u64 = 12;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["table", ..] => {
            tables();
        }
        ["export", folder, ..] => SIZES.map(|size| peer::export(&usual(size), folder.as_ref())).into_iter().collect(),
        ["everything", ..] => SIZES.map(|size| peer::everything(&usual(size))).into_iter().collect(),
        _ => {
            let mut criterion = Criterion::default().configure_from_args();
            tables().iter().flatten().for_each(|album| bench(&mut criterion, album));
            criterion.final_summary();
        }
    }
}

/// Recorded frames with poses if available, otherwise rendered ones.
fn usual(size: (u16, u16)) -> Album {
    recorded::folder()
        .map_or_else(|| rendered::album(size, WORLDS), |folder| recorded::albums(folder, size).swap_remove(0))
}

/// Prints the time of each stage and frame size, and the ratio of the worst frames to typical ones.
fn tables() -> Vec<Vec<Album>> {
    let real = recorded::folder();
    let of_size = |size| {
        let real = real.iter().flat_map(|folder| recorded::albums(folder, size));
        let albums: Vec<Album> = std::iter::once(rendered::album(size, WORLDS)).chain(real).collect();
        figures::print(&albums);
        figures::print_worst(&worst::album(size), albums.get(1).unwrap_or(&albums[0]));
        albums
    };
    SIZES.map(of_size).into()
}

/// Runs each stage on all frames of an album.
fn bench(criterion: &mut Criterion, album: &Album) {
    let (width, height) = album.size();
    let given: Vec<_> = album.shots.iter().map(|shot| Given::new(shot, &album.table)).collect();
    let mut desk = Desk::new();
    let mut group = criterion.benchmark_group(format!("{} {width}×{height}", album.name));
    for (name, stage) in STAGES {
        let mut frames = given.iter().cycle();
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                if let Some(given) = frames.next() {
                    stage(&mut desk, given);
                }
            });
        });
    }
    group.finish();
}

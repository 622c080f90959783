//! What seeing costs, stage by stage, on rendered and on real frames.
//!
//! `cargo bench --bench vision` prints a table of minima, with a copy of the frame as the floor and made-up frames as
//! the worst, then Criterion's figures; `cargo bench --bench vision -- table` the table alone. Compare figures of one run
//! with each other, never with another machine's.

mod figures;
mod recorded;
mod rendered;
mod shot;
mod stages;
mod worst;

use criterion::Criterion;

use crate::shot::{Album, SIZES};
use crate::stages::{Desk, Given, STAGES};

fn main() {
    let folder = recorded::folder();
    let albums = SIZES.map(|size| {
        let real = folder.iter().flat_map(|folder| recorded::albums(folder, size));
        std::iter::once(rendered::album(size)).chain(real).collect::<Vec<_>>()
    });
    for albums in &albums {
        figures::print(albums);
        // The real frames with poses where there are some.
        figures::print_worst(&worst::album(albums[0].size()), albums.get(1).unwrap_or(&albums[0]));
    }
    if std::env::args().any(|word| word == "table") {
        return;
    }
    let mut criterion = Criterion::default().configure_from_args();
    albums.iter().flatten().for_each(|album| bench(&mut criterion, album));
    criterion.final_summary();
}

/// Every stage on the frames of an album, one after the other.
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

//! Times that are robust on a shared machine: the fastest of several rounds for each frame.

use std::time::Instant;

use crate::stages::{Desk, Given, MEMCPY, STAGES, Stage};
use bica_benches::frames::Album;

/// Number of rounds over all frames.
const ROUNDS: usize = 15;

/// Times of a stage over an album's frames, µs.
pub(crate) struct Figure {
    pub(crate) stage: &'static str,
    pub(crate) mean: f64,
    pub(crate) most: f64,
    /// Slowest frame.
    pub(crate) slowest: String,
}

/// Measures each stage on each frame.
pub(crate) fn measure(album: &Album, stages: &[Stage]) -> Vec<Figure> {
    let mut desk = Desk::new();
    let given: Vec<_> = album.shots.iter().map(|shot| Given::new(shot, &album.table)).collect();
    let mut least = vec![vec![f64::INFINITY; given.len()]; stages.len()];
    for _ in 0..ROUNDS {
        for (at, given) in given.iter().enumerate() {
            for ((_, stage), least) in stages.iter().zip(&mut least) {
                let began = Instant::now();
                stage(&mut desk, given);
                least[at] = least[at].min(1e6 * began.elapsed().as_secs_f64());
            }
        }
    }
    let figure = |((stage, _), least): (&Stage, &Vec<f64>)| {
        let slowest = (0..least.len()).max_by(|a, b| least[*a].total_cmp(&least[*b])).unwrap_or_default();
        let mean = least.iter().sum::<f64>() / least.len() as f64;
        Figure { stage, mean, most: least[slowest], slowest: album.shots[slowest].name.clone() }
    };
    stages.iter().zip(&least).map(figure).collect()
}

/// Prints the times of each stage for albums of one size, and of a copy of the frame.
pub(crate) fn print(albums: &[Album]) {
    let Some((width, height)) = albums.first().map(Album::size) else { return };
    println!("\n{width}×{height}, µs for a frame: mean over the frames and slowest frame, × one memcpy");
    print!("{:16}", "");
    for album in albums {
        print!("{:>32}", format!("{} ({})", album.name, album.shots.len()));
    }
    println!();
    let figures: Vec<_> = albums.iter().map(|album| measure(album, &STAGES)).collect();
    for (row, (stage, _)) in STAGES.iter().enumerate() {
        print!("{stage:16}");
        for figures in &figures {
            let floor = figures.iter().find(|figure| figure.stage == MEMCPY).map_or(f64::NAN, |figure| figure.mean);
            let Figure { mean, most, .. } = &figures[row];
            print!("{mean:12.1}{most:9.1}{:8.1} × ", mean / floor);
        }
        println!();
    }
}

/// Prints the slowest frames of each stage and the ratio to typical frames.
pub(crate) fn print_worst(worst: &Album, usual: &Album) {
    println!("\n{:16}{:>12}{:>12}{:>14}  worst of {} made-up frames", "", "mean", "worst", "×", worst.shots.len());
    let (worst, usual) = (measure(worst, &STAGES), measure(usual, &STAGES));
    for (worst, usual) in worst.iter().zip(&usual) {
        let ratio = worst.most / usual.mean;
        println!("{:16}{:12.1}{:12.1}{ratio:12.1} ×  {}", worst.stage, usual.mean, worst.most, worst.slowest);
    }
}

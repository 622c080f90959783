//! Times that are robust on a shared machine: for each frame the fastest of several rounds.

use std::time::Instant;

use super::stages::{Buffers, Input, MEMCPY, STAGES, Stage};
use bica_benches::frames::FrameSet;
use serde_json::json;

/// Number of rounds over all frames.
const ROUNDS: usize = 15;

/// Times of a stage over the frames of a set, µs.
pub(crate) struct Figure {
    pub(crate) stage: &'static str,
    pub(crate) mean: f64,
    pub(crate) max: f64,
    /// Name of the slowest frame.
    pub(crate) slowest: String,
}

/// Measures each stage on each frame.
pub(crate) fn measure(frame_set: &FrameSet, stages: &[Stage]) -> Vec<Figure> {
    let mut buffers = Buffers::new();
    let input: Vec<_> = frame_set.samples.iter().map(|sample| Input::new(sample, &frame_set.table)).collect();
    let mut minima = vec![vec![f64::INFINITY; input.len()]; stages.len()];
    for _ in 0..ROUNDS {
        for (at, input) in input.iter().enumerate() {
            for ((_, stage), minima) in stages.iter().zip(&mut minima) {
                let began = Instant::now();
                stage(&mut buffers, input);
                minima[at] = minima[at].min(1e6 * began.elapsed().as_secs_f64());
            }
        }
    }
    let figure = |((stage, _), minima): (&Stage, &Vec<f64>)| {
        let slowest = (0..minima.len()).max_by(|a, b| minima[*a].total_cmp(&minima[*b])).unwrap_or_default();
        let mean = minima.iter().sum::<f64>() / minima.len() as f64;
        Figure { stage, mean, max: minima[slowest], slowest: frame_set.samples[slowest].name.clone() }
    };
    stages.iter().zip(&minima).map(figure).collect()
}

/// Prints the times of each stage for sets of frames of one size, relative to a copy of the frame.
pub(crate) fn print(frame_sets: &[FrameSet]) {
    let Some((width, height)) = frame_sets.first().map(FrameSet::size) else { return };
    println!("\n{width}×{height}, µs for a frame: mean over the frames and slowest frame, × one memcpy");
    print!("{:16}", "");
    for frame_set in frame_sets {
        print!("{:>32}", format!("{} ({})", frame_set.name, frame_set.samples.len()));
    }
    println!();
    let figures: Vec<_> = frame_sets.iter().map(|frame_set| measure(frame_set, &STAGES)).collect();
    for (row, (stage, _)) in STAGES.iter().enumerate() {
        print!("{stage:16}");
        for figures in &figures {
            let floor = figures.iter().find(|figure| figure.stage == MEMCPY).map_or(f64::NAN, |figure| figure.mean);
            let Figure { mean, max, .. } = &figures[row];
            print!("{mean:12.1}{max:9.1}{:8.1} × ", mean / floor);
        }
        println!();
    }
}

/// Prints the times of each stage on a set of frames as a line of JSON.
pub(crate) fn print_json(frame_set: &FrameSet) {
    let (width, height) = frame_set.size();
    let figures = measure(frame_set, &STAGES);
    let row = |figure: &Figure| json!({ "stage": figure.stage, "mean_us": figure.mean, "max_us": figure.max });
    let stages: Vec<_> = figures.iter().map(row).collect();
    let set =
        json!({ "schema": "bica/bench-vision/1", "set": frame_set.name, "size": [width, height], "stages": stages });
    println!("{set}");
}

/// Prints the slowest frame of each stage and its ratio to a typical frame.
pub(crate) fn print_worst(worst: &FrameSet, usual: &FrameSet) {
    println!("\n{:16}{:>12}{:>12}{:>14}  worst of {} synthetic frames", "", "mean", "worst", "×", worst.samples.len());
    let (worst, usual) = (measure(worst, &STAGES), measure(usual, &STAGES));
    for (worst, usual) in worst.iter().zip(&usual) {
        let ratio = worst.max / usual.mean;
        println!("{:16}{:12.1}{:12.1}{ratio:12.1} ×  {}", worst.stage, usual.mean, worst.max, worst.slowest);
    }
}

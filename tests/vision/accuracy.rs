//! Recall, precision and accuracy of all detectors from random poses in the built-in world.
//!
//! Scores over many more poses: `cargo run --release -p bica-tests --features measure --example survey`.

#[path = "support/survey/mod.rs"]
mod survey;

use survey::{Score, Survey};

/// Number of poses: enough to notice a broken detector.
const POSES: usize = 300;

/// Minimum number of due objects, minimum recall and precision, maximum median and 95 % error.
///
/// The bounds are slightly looser than the present scores, so that a harmless change may lose one or two objects.
struct Bounds(usize, f32, f32, f32, f32);

/// Description of a violated bound.
fn violation(score: &Score, Bounds(due, recall, precision, median, most): &Bounds) -> Option<String> {
    let is_right = score.recall() >= *recall && score.precision() >= *precision;
    let is_near = score.error_at(50) <= *median && score.error_at(95) <= *most;
    let words = || format!("{score}\nmissed {:?}\nwrong {:?}", score.missed, score.wrong);
    (!(score.due >= *due && is_right && is_near)).then(words)
}

#[test]
fn detectors_reach_their_accuracy() {
    let survey = Survey::of(0, POSES);
    println!("{survey}");
    let Survey { ball, posts, lines, crossings, circle, robots, field_boundary, .. } = &survey;
    let bounds = [
        (ball, Bounds(60, 0.98, 0.98, 0.25, 0.6)),
        (posts, Bounds(95, 0.965, 0.98, 1.2, 3.6)),
        (lines, Bounds(4400, 0.925, 0.975, 0.3, 3.2)),
        (crossings, Bounds(105, 0.89, 0.98, 0.55, 2.0)),
        (circle, Bounds(27, 0.8, 0.97, 0.7, 2.8)),
        (robots, Bounds(40, 0.93, 0.925, 2.0, 8.0)),
        (field_boundary, Bounds(2000, 0.98, 0.98, 0.85, 1.5)),
    ];
    let violations: Vec<_> = bounds.iter().filter_map(|(score, bounds)| violation(score, bounds)).collect();
    assert!(violations.is_empty(), "{}", violations.join("\n"));
}

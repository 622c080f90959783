//! Everything is seen from random poses in the built-in world, whose referee knows the truth.
//!
//! The figures of many more poses: `cargo run --release -p bica-vision --example survey`.

#[path = "support/survey/mod.rs"]
mod survey;

use survey::{Score, Survey};

/// How many poses: enough to notice a detector that went wrong.
const POSES: usize = 300;

/// The least recall and precision, and the largest error: the median and that of 95 in 100.
struct Bounds(f32, f32, f32, f32);

/// What is amiss, in words.
fn amiss(score: &Score, Bounds(recall, precision, median, most): &Bounds) -> Option<String> {
    let is_right = score.recall() >= *recall && score.precision() >= *precision;
    let is_near = score.error_at(50) <= *median && score.error_at(95) <= *most;
    let words = || format!("{score}\nmissed {:?}\nwrong {:?}", score.missed, score.wrong);
    (!(is_right && is_near)).then(words)
}

#[test]
fn what_there_is_is_seen_where_it_is() {
    let survey = Survey::of(0, POSES);
    println!("{survey}");
    let Survey { ball, posts, lines, crossings, circle, robots, field_end, .. } = &survey;
    let bounds = [
        (ball, Bounds(0.98, 0.98, 0.5, 1.5)),
        (posts, Bounds(0.96, 0.98, 1.5, 4.0)),
        (lines, Bounds(0.92, 0.97, 0.4, 3.5)),
        (crossings, Bounds(0.88, 0.97, 0.7, 2.5)),
        (circle, Bounds(0.8, 0.97, 1.0, 3.5)),
        (robots, Bounds(0.92, 0.92, 3.0, 9.0)),
        (field_end, Bounds(0.975, 0.975, 1.0, 2.0)),
    ];
    let amiss: Vec<_> = bounds.iter().filter_map(|(score, bounds)| amiss(score, bounds)).collect();
    assert!(amiss.is_empty(), "{}", amiss.join("\n"));
}

//! Layouts of random machines.

use super::{Arrow, LOOKS, Machine, Point};
use crate::svg::tests::Rng;

/// A random machine with several transitions of one name.
fn random(seed: u64) -> (Vec<(f64, f64)>, Vec<Arrow>) {
    let mut rng = Rng(seed);
    let count = 2 + rng.below(12);
    let sizes = (0..count).map(|_| (160.0, 50.0 + 12.0 * rng.below(8) as f64)).collect();
    let mut arrow = || {
        let name = format!("condition_{}", rng.below(8));
        let from = (rng.below(12) > 0).then(|| rng.below(count));
        Arrow { width: 7.0 * name.len() as f64, from, to: rng.below(count), name }
    };
    let arrows = (0..2 * count).map(|_| arrow()).collect();
    (sizes, arrows)
}

/// Straight parts of a course that go up or down: x, and the two y.
fn uprights(points: &[Point]) -> impl Iterator<Item = (f64, f64, f64)> {
    let is_upright = |pair: &&[Point]| (pair[0].0 - pair[1].0).abs() < 0.01;
    points.windows(2).filter(is_upright).map(|pair| (pair[0].0, pair[0].1.min(pair[1].1), pair[0].1.max(pair[1].1)))
}

/// Lines of transitions with one name and target may join; all others are apart.
#[test]
fn upright_lines_of_other_names_never_overlap() {
    let (mut compared, mut overlaps) = (0, Vec::new());
    for seed in 0..300 {
        let (sizes, arrows) = random(seed);
        let courses = Machine::new(&sizes, 0, &arrows, 1.4, &LOOKS[0]).courses;
        for (index, one) in courses.iter().enumerate() {
            for other in courses[index + 1..].iter().filter(|other| other.owner != one.owner) {
                for (x, low, high) in uprights(&one.points) {
                    for (x2, low2, high2) in uprights(&other.points) {
                        compared += 1;
                        if (x - x2).abs() < 1.0 && low.max(low2) + 1.0 < high.min(high2) {
                            overlaps.push((seed, x, low.max(low2), high.min(high2)));
                        }
                    }
                }
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
    assert!(overlaps.is_empty(), "{} of {compared}: {:?}", overlaps.len(), &overlaps[..overlaps.len().min(5)]);
}

//! Tests of self-localization by looking around.

#[path = "../support/lookout.rs"]
mod lookout;

use bica_sim::setup::Frame;
use lookout::{Lookout, print};

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_robot_is_localized_after_ten_seconds() {
    for size in [Frame::Small, Frame::Medium] {
        let outcomes: Vec<_> = (0..15).map(|seed| Lookout::new(seed, 0, size).look_around(10.0)).collect();
        print(&outcomes);
        assert!(outcomes.iter().filter(|outcome| outcome.is_correct()).count() >= 14, "{size:?}");
    }
}

/// The normalised error squared of a pose has three degrees of freedom: its mean over 100 games is between 2.5 and 3.5 with a
/// probability of 96 %.
#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_covariance_is_that_of_the_error() {
    let outcomes = (0..100).map(|seed| Lookout::new(seed, 0, Frame::Small).look_around(10.0));
    let errors: Vec<_> = outcomes.filter_map(|outcome| outcome.normalised_error()).collect();
    assert!(errors.len() >= 95, "{} games with a pose that is sure", errors.len());
    let mean = errors.iter().sum::<f32>() / errors.len() as f32;
    assert!((2.5..3.5).contains(&mean), "{mean}");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_localization_recovers_from_kidnapping() {
    let mut outcomes = Vec::new();
    for seed in 100..105 {
        let mut lookout = Lookout::new(seed, 4, Frame::default());
        outcomes.push(lookout.look_around(10.0));
        lookout.kidnap(seed + 1000, 4);
        outcomes.push(lookout.look_around(10.0));
    }
    print(&outcomes);
    assert!(outcomes.iter().filter(|outcome| outcome.is_correct()).count() >= 9);
}

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
    let mean = |errors: Vec<f32>, games: usize| {
        assert!(errors.len() * 20 >= games * 19, "{} of {games} poses are sure", errors.len());
        errors.iter().sum::<f32>() / errors.len() as f32
    };
    let standing = (0..100).filter_map(|seed| Lookout::new(seed, 0, Frame::Small).look_around(10.0).normalised_error());
    let standing = mean(standing.collect(), 100);
    assert!((2.5..3.5).contains(&standing), "{standing}");
    // A robot that walks has a larger covariance than its error: the simulated steps slip less than the noise of the motion says.
    let playing = (0..20).filter_map(|seed| {
        let mut lookout = Lookout::new(seed, 0, Frame::Small);
        lookout.look_around(5.0);
        lookout.play();
        lookout.look_around(10.0).normalised_error()
    });
    let playing = mean(playing.collect(), 20);
    assert!((0.3..3.5).contains(&playing), "{playing}");
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

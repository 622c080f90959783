//! Self-localization by looking around.

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

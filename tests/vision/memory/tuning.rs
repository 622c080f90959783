//! Rates and errors of the memories must change how long and how accurately objects are remembered.

use bica_motion::pose::Pose2;
use bica_vision::memory::{Memory, MemoryTuning};
use bica_vision::uncertainty::{largest, round};
use glam::Vec2;

/// Memory of an object 2 m ahead, seen just now.
fn memory(tuning: &MemoryTuning) -> Memory {
    let mut memory = Memory::new(1.0);
    memory.set_tuning(tuning);
    memory.see(Vec2::new(2.0, 0.0), &round(0.05), 0.8);
    memory
}

#[test]
fn each_rate_reduces_the_confidence_by_its_own_cause() {
    let confidence = |tuning: &MemoryTuning, motion: Pose2, seconds: f32, misses: usize| {
        let mut memory = memory(tuning);
        memory.advance(motion, seconds);
        (0..misses).for_each(|_| memory.miss());
        memory.confidence()
    };
    let usual = MemoryTuning::DEFAULT;
    let near = |found: f32, expected: f32| (found - expected).abs() < 1e-6;
    let (ahead, turned) = (Pose2::new(1.0, 0.0, 0.0), Pose2::new(0.0, 0.0, 1.0));
    let slow = MemoryTuning { half_life: 10.0, ..usual };
    assert!(near(confidence(&slow, Pose2::ORIGIN, 10.0, 0), 0.4));
    let short = MemoryTuning { halving_distance: 1.0, ..usual };
    assert!(near(confidence(&short, ahead, 0.0, 0), 0.4));
    let narrow = MemoryTuning { halving_turn: 1.0, ..usual };
    assert!(near(confidence(&narrow, turned, 0.0, 0), 0.4));
    let strict = MemoryTuning { miss_factor: 0.5, ..usual };
    assert!(near(confidence(&strict, Pose2::ORIGIN, 0.0, 2), 0.2));
}

#[test]
fn odometry_errors_widen_the_remembered_position() {
    let deviation = |tuning: &MemoryTuning, motion: Pose2| {
        let mut memory = memory(tuning);
        memory.advance(motion, 0.0);
        largest(&memory.estimate().expect("remembered").covariance)
    };
    let exact = MemoryTuning { distance_error: 0.0, turn_error: 0.0, ..MemoryTuning::DEFAULT };
    let (ahead, turned) = (Pose2::new(1.0, 0.0, 0.0), Pose2::new(0.0, 0.0, 1.0));
    let far = MemoryTuning { distance_error: 0.3, ..exact };
    let wide = MemoryTuning { turn_error: 0.1, ..exact };
    assert!((deviation(&far, ahead).powi(2) - deviation(&exact, ahead).powi(2) - 0.09).abs() < 1e-4);
    assert!((deviation(&wide, turned).powi(2) - deviation(&exact, turned).powi(2) - 0.04).abs() < 1e-4);
}

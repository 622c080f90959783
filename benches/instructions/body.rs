//! Kinematics and walk.

use std::hint::black_box;

use bica_motion::joints::Joints;
use bica_motion::kinematics::{YawFrom, ankle, centre_of_mass, legs_angles};
use bica_motion::model::{NAO, T1};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::recovery::Situation;
use bica_motion::walk::{Feedback, Velocity, Walk};
use glam::Vec2;

use crate::case::Case;
use crate::quadratic_program::Program;

const FORWARD: Velocity = Velocity { forward: 0.2, left: 0.02, turn: 0.1 };

/// Joint angles of a pose in the walk, rad.
fn pose() -> Joints {
    let mut walk = new_walk();
    step_repeatedly(&mut walk, 30);
    walk.step(FORWARD, &on_both_feet(), 0.01).joints(NAO)
}

fn new_walk() -> Walk {
    Walk::new(NAO, &NAO.dynamic_profile.gait)
}

fn on_both_feet() -> Feedback {
    let force = FootPressure { front_left: 26.0, ..FootPressure::default() };
    Feedback { left_foot: force, right_foot: force, ..Feedback::default() }
}

fn step_repeatedly(walk: &mut Walk, cycles: usize) {
    let body = on_both_feet();
    for _ in 0..cycles {
        black_box(walk.step(black_box(FORWARD), &body, 0.01));
    }
}

/// A step after a push of 0.5 m/s from behind.
fn pushed() -> Situation {
    let [dcm, place, offset] = [Vec2::new(0.12, 0.02), Vec2::new(0.06, 0.2), Vec2::new(0.01, -0.05)];
    Situation { dcm, place, offset, elapsed: 0.1, remaining: 0.2, frequency: 4.5 }
}

/// All benchmarks of the motion.
pub(crate) fn cases() -> Vec<Case> {
    let ankles = || [Side::Left, Side::Right].map(|side| ankle(NAO, side, &pose()));
    vec![
        Case::new("forward_kinematics.pose", pose, |angles| {
            black_box(ankle(NAO, Side::Left, black_box(angles)));
        }),
        Case::new("balance.pose", pose, |angles| {
            black_box(centre_of_mass(NAO, black_box(angles)));
        }),
        Case::new("inverse_kinematics.pose", ankles, |ankles| {
            let [left, right] = black_box(ankles);
            black_box(legs_angles(NAO, left, right, YawFrom::Mean));
        }),
        Case::new("walk.second", new_walk, |walk| step_repeatedly(walk, 100)),
        Case::new("recovery.step", pushed, |now| {
            black_box(T1.dynamic_profile.gait.recovery(black_box(now)));
        }),
        Case::new("recovery_by_matrices.step", pushed, |now| {
            let now = black_box(now);
            black_box(Program::of(&T1.dynamic_profile.gait, now).best_step(now));
        }),
    ]
}

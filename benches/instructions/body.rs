//! Kinematics and walk.

use std::hint::black_box;

use bica_motion::joints::Joints;
use bica_motion::kinematics::{YawFrom, ankle, centre_of_mass, legs_angles};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, Walk};
use gungraun::prelude::*;

/// Joint angles of a pose in the walk, rad.
fn pose() -> Joints {
    let mut walk = Walk::<Nao>::new(&Nao::DYNAMIC_PROFILE.gait);
    step_repeatedly(&mut walk, 30);
    walk.step(FORWARD, &on_both_feet(), 0.01).joints()
}

const FORWARD: Velocity = Velocity { forward: 0.2, left: 0.02, turn: 0.1 };

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

#[library_benchmark]
#[bench::pose(pose())]
fn forward_kinematics(angles: Joints) {
    black_box(ankle::<Nao>(Side::Left, black_box(&angles)));
}

#[library_benchmark]
#[bench::pose(pose())]
fn balance(angles: Joints) {
    black_box(centre_of_mass::<Nao>(black_box(&angles)));
}

#[library_benchmark]
#[bench::pose([ankle::<Nao>(Side::Left, &pose()), ankle::<Nao>(Side::Right, &pose())])]
fn inverse_kinematics(ankles: [glam::Affine3A; 2]) {
    let [left, right] = black_box(&ankles);
    black_box(legs_angles::<Nao>(left, right, YawFrom::Mean));
}

#[library_benchmark]
#[bench::second(Walk::<Nao>::new(&Nao::DYNAMIC_PROFILE.gait))]
fn walk(mut walk: Walk) {
    step_repeatedly(&mut walk, 100);
}

library_benchmark_group!(name = motion, benchmarks = [forward_kinematics, balance, inverse_kinematics, walk]);

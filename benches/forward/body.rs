//! Kinematics and walk.

use std::hint::black_box;

use bica_motion::kinematics::{YawFrom, ankle, centre_of_mass, legs_angles};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, Walk};
use criterion::Criterion;

pub(crate) fn bench(criterion: &mut Criterion) {
    let force = FootPressure { front_left: 26.0, ..FootPressure::default() };
    let feedback = Feedback { left_foot: force, right_foot: force, ..Feedback::default() };
    let velocity = Velocity::new(0.2, 0.02, 0.1);
    let mut walk = Walk::<Nao>::new(&Nao::DYNAMIC_PROFILE.gait);
    let mut step = move || walk.step(black_box(velocity), &feedback, 0.01);
    let angles = (0..30).map(|_| step().joints()).last().expect("thirty steps");
    let [left, right] = [Side::Left, Side::Right].map(|side| ankle::<Nao>(side, &angles));

    let mut group = criterion.benchmark_group("body");
    group.bench_function("a foot from the angles of its leg", |bencher| {
        bencher.iter(|| ankle::<Nao>(Side::Left, black_box(&angles)));
    });
    group.bench_function("centre of mass", |bencher| bencher.iter(|| centre_of_mass::<Nao>(black_box(&angles))));
    group.bench_function("both legs from their feet", |bencher| {
        bencher.iter(|| legs_angles::<Nao>(black_box(&left), black_box(&right), YawFrom::Mean));
    });
    group.bench_function("a cycle of the walk", |bencher| bencher.iter(&mut step));
    group.finish();
}

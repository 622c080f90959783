//! Odometry against the true way in the quasi-static world.

use bica_motion::joints::Joints;
use bica_motion::odometry::{Calibration, Odometry};
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::FootPressure;
use bica_motion::stand::STAND;
use bica_motion::walk::{Parameters, Velocity, Walk};
use proptest::prelude::*;

use crate::world::{CYCLE, World};

proptest! {
    #![proptest_config(crate::cases(50))]

    #[test]
    fn it_knows_the_way(requests in prop::collection::vec(prop::array::uniform3(-1.0_f32..1.0), 1..6)) {
        let mut walk = Walk::new(&Parameters::BUILT_IN);
        let mut world = World::standing(Parameters::BUILT_IN.stand().joints());
        let mut odometry = Odometry::new(&Calibration::EXACT);
        let start = world.ground();
        let mut way = 0.0;
        for request in requests {
            for _ in 0..150 {
                let body = world.body();
                odometry.step(&world.angles, &body.left_foot, &body.right_foot, None);
                let request = Velocity::new(0.25 * request[0], 0.12 * request[1], 1.2 * request[2]);
                let before = world.ground();
                world.step(&walk.step(request, &body, CYCLE).joints());
                way += (start.inverse() * world.ground()).position.distance((start.inverse() * before).position);
            }
        }
        let body = world.body();
        odometry.step(&world.angles, &body.left_foot, &body.right_foot, None);
        let (true_pose, found) = (start.inverse() * world.ground(), odometry.pose());
        let off = true_pose.position.distance(found.position);
        prop_assert!(off < 0.02 + 0.03 * way, "{off} m off after {way} m");
        let turned = wrap(true_pose.heading - found.heading);
        prop_assert!(turned.abs() < 0.15, "{turned} rad off");
    }
}

fn ground(force: f32) -> FootPressure {
    FootPressure { front_left: force, ..FootPressure::default() }
}

#[test]
fn nobody_moves_in_the_air_or_by_nonsense() {
    let mut odometry = Odometry::new(&Calibration::EXACT);
    let mut angles = STAND;
    for i in 0..10 {
        angles.0[9] += 0.05;
        let motion = odometry.step(&angles, &ground(0.0), &ground(0.0), None);
        assert_eq!(motion, Pose2::ORIGIN, "{i}");
        assert_eq!(odometry.support(), None);
    }
    odometry.step(&Joints::all(f32::NAN), &ground(30.0), &ground(20.0), None);
    odometry.step(&STAND, &ground(30.0), &ground(f32::NAN), Some(f32::NAN));
    odometry.step(&STAND, &ground(30.0), &ground(20.0), Some(f32::INFINITY));
    assert_eq!(odometry.pose(), Pose2::ORIGIN);
    odometry.step(&STAND, &ground(30.0), &ground(20.0), Some(0.1));
    assert_eq!(odometry.pose(), Pose2::new(0.0, 0.0, 0.1), "the gyroscope knows better how far it turned");
}

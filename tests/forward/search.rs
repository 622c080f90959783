//! If a full turn does not show the ball, the robot must search from another place.

use bica::Value;
use bica::prelude::*;
use bica::runner::harness::{Harness, InWorld};
use bica_motion::model::simulation::NAO;
use bica_player::behaviour::SearchBall;
use bica_player::tunable::Forward;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_search_moves_on_after_a_full_turn() {
    for (seed, places) in [(1, 1), (2, 2)] {
        let setup = Setup { seed, frame: Frame::Small, robots: 4, ..Setup::default() };
        let world = KinematicWorld::new(NAO, &setup).expect("the setup is valid");
        let mut robot = Box::new(Forward::new());
        // The detector runs but never confirms the ball.
        let (most, none) = (Value::U32(30), Value::F32(1.0));
        for (name, value) in [("confirmations", most), ("min_confidence", none), ("min_confidence_if_small", none)] {
            let setting = Forward::setting("BallDetector", name, value).expect("a parameter");
            robot.set_params(&[setting]).expect("in its range");
        }
        let mut test = Harness::of_box(robot).in_world(world);
        let place = |test: &Harness<Forward, InWorld<KinematicWorld>>| test.world().referee().robot().position;
        for _ in 0..places {
            let before = place(&test);
            test.reaches::<SearchBall>("walk_on", Duration::from_secs(50));
            // The next place is up to 3.2 m away; the robot walks at 0.2 m/s.
            test.reaches::<SearchBall>("scan", Duration::from_secs(20));
            let after = place(&test);
            assert!(after.distance(before) > 0.25, "seed {seed}: from {before} to {after}");
            assert!(after.x.abs() < 3.3 && after.y.abs() < 2.3, "seed {seed}: the robot left the field: {after}");
        }
        assert_eq!(test.world().referee().falls(), 0, "seed {seed}");
    }
}

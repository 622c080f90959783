//! A ball that is not found in a full turn is searched for from another place.

use bica::prelude::*;
use bica::runner::harness::{Harness, InWorld};
use bica_player::behaviour::SearchBall;
use bica_player::perception::BallDetector;
use bica_player::{Forward, Model};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::new_game;

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_search_continues_at_other_places_after_a_full_turn() {
    for (seed, places) in [(1, 2), (2, 1)] {
        let setup = Setup { seed, frame: Frame::Small, robots: 4, ..Setup::default() };
        let (mut robot, world, ..) = new_game(&setup).into_parts();
        robot.hold::<BallDetector>(Hold::Latent);
        let mut test = Harness::of_box(robot).in_world(world);
        let place = |test: &Harness<Forward, InWorld<KinematicWorld<Model>>>| test.world().referee().robot().position;
        for _ in 0..places {
            let before = place(&test);
            test.reaches::<SearchBall>("walk_on", Duration::from_secs(50));
            test.reaches::<SearchBall>("scan", Duration::from_secs(15));
            let after = place(&test);
            assert!(after.distance(before) > 0.25, "seed {seed}: from {before} to {after}");
            assert!(after.x.abs() < 3.3 && after.y.abs() < 2.3, "seed {seed}: the robot left the field: {after}");
        }
        assert_eq!(test.world().referee().falls(), 0, "seed {seed}");
    }
}

//! A robot with a hot motor must sit until the motor has cooled; games must not overheat a motor.

use bica_motion::health::Fault;
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_player::behaviour::SafetyGuard;
use bica_player::input::HealthMonitor;
use bica_sim::World;
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::{Game, new_game};
use bica::prelude::*;

/// Runs some cycles, and returns whether no joint's stiffness was reduced.
fn play(game: &mut Game, cycles: u32) -> bool {
    (0..cycles).fold(true, |firm, _| {
        game.cycle().expect("the image fits");
        let all = Joints::all(1.0);
        firm & (game.robot().get::<HealthMonitor>().derated(&all) == all)
    })
}

#[test]
fn hot_joint_loses_stiffness_before_the_robot_sits() {
    for (seed, joint) in [(3, Joint::LKneePitch), (4, Joint::RAnkleRoll), (5, Joint::HeadYaw)] {
        let mut game = new_game(&Setup { seed, frame: Frame::Small, ..Setup::default() });
        assert!(play(&mut game, 700), "seed {seed}: no motor is overloaded in a game");
        game.world_mut().set_motor_temperature(joint, 73.5);
        assert!(!play(&mut game, 100), "seed {seed}: the stiffness of a warm joint is reduced");
        assert_eq!(game.robot().get::<HealthMonitor>().fault(), None);
        game.world_mut().set_motor_temperature(joint, 78.0);
        play(&mut game, 600);
        assert_eq!(game.robot().get::<HealthMonitor>().fault(), Some(Fault::Hot(joint)));
        let last = game.cycle().expect("the image fits");
        assert!(last.stiffness.0.iter().all(|stiffness| *stiffness <= NAO.sit_stiffness), "seed {seed}");
        let angles = game.world_mut().sensors().angles;
        let off = Joint::ALL.map(|joint| (angles[joint] - NAO.sit[joint]).abs());
        assert!(off[7..18].iter().all(|off| *off < 0.02), "seed {seed}: {off:?}");
        assert_eq!(game.world().referee().falls(), 0, "seed {seed}");
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_hot_robot_scores_after_cooling() {
    let mut game = new_game(&Setup { seed: 3, frame: Frame::Small, ..Setup::default() });
    game.world_mut().set_motor_temperature(Joint::LKneePitch, 78.0);
    play(&mut game, 900);
    game.world_mut().set_motor_temperature(Joint::LKneePitch, 71.0);
    play(&mut game, 100);
    assert!(game.robot().get::<HealthMonitor>().fault().is_some());
    assert!(game.robot().of::<SafetyGuard>().is_active(), "the robot sits");
    game.world_mut().set_motor_temperature(Joint::LKneePitch, 60.0);
    play(&mut game, 300);
    assert_eq!(game.robot().get::<HealthMonitor>().fault(), None);
    assert!(!game.robot().of::<SafetyGuard>().is_active(), "the robot plays");
    // The robot may score again later.
    for _ in 0..6000 {
        if game.world().referee().goals() > 0 {
            break;
        }
        play(&mut game, 1);
    }
    assert_eq!((game.world().referee().falls(), game.world().referee().goals()), (0, 1));
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_no_motor_is_overloaded_in_a_game() {
    for seed in 0..3 {
        let mut game = new_game(&Setup { seed, frame: Frame::Small, robots: 2, ..Setup::default() });
        assert!(play(&mut game, 6000), "seed {seed}");
        assert_eq!(game.robot().get::<HealthMonitor>().fault(), None, "seed {seed}");
    }
}

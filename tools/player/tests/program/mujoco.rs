//! Games and trials in MuJoCo, and the error of a build without it.

#[cfg(not(feature = "mujoco"))]
#[test]
fn missing_mujoco_is_explained() {
    let ran = crate::process::run(&["play", "--world", "mujoco"]);
    assert_eq!((ran.code, ran.stdout.as_str()), (Some(2), ""));
    assert!(ran.stderr.contains("cargo xtask mujoco") && ran.stderr.contains("--features mujoco"), "{}", ran.stderr);
}

#[cfg(feature = "mujoco")]
mod with_mujoco {
    use bica::runner::Robot;
    use bica::{Instant, Tree};
    use bica_motion::health::Fault;
    use bica_motion::joints::Joint;
    use bica_motion::model::simulation::NAO;
    use bica_player::behaviour::SafetyGuard;
    use bica_player::input::{HealthMonitor, RobotProfile};
    use bica_player::tunable::Forward;
    use bica_sim::World;
    use bica_sim::mujoco::{MujocoWorld, Physics};
    use bica_sim::referee::Posture;
    use bica_sim::setup::Setup;
    use glam::Vec2;

    use crate::process::{Folder, run, without_wall};

    #[test]
    fn equal_seeds_give_equal_games() {
        let folder = Folder::new("mujoco");
        let film = folder.path().join("game.gif");
        let game = ["play", "--world", "mujoco", "--seed", "7", "--robots", "2", "--seconds", "1", "--json"];
        let mut first = run(&game).json();
        let mut second = run(&[&game[..], &["--film", film.to_str().unwrap()]].concat()).json();
        assert_eq!(first["cycles"], 100);
        assert!(first["components"][0]["runs"].as_u64().is_some_and(|runs| runs > 0));
        without_wall(&mut first);
        without_wall(&mut second);
        assert_eq!(first, second);
        assert!(film.metadata().unwrap().len() > 10_000);
    }

    /// A forward, and its world without cameras.
    fn forward() -> (Box<Forward>, MujocoWorld) {
        let physics = Physics { cameras: false, ..Physics::of(NAO) };
        let mut robot = Box::new(Forward::new());
        robot.get_mut::<RobotProfile>().set(NAO.dynamic_profile);
        (robot, MujocoWorld::new(NAO, &Setup::default(), &physics).unwrap())
    }

    fn run_cycle(cycle: u64, robot: &mut Forward, world: &mut MujocoWorld) {
        robot.sense(&world.sensors()).unwrap();
        robot.tick(Instant::from_millis(10 * cycle));
        world.act(&robot.act());
    }

    #[test]
    fn robot_with_a_hot_joint_sits_down() {
        let (mut robot, mut world) = forward();
        for cycle in 0..3000 {
            if cycle == 500 {
                world.set_motor_temperature(Joint::LKneePitch, 78.0);
            }
            run_cycle(cycle, &mut robot, &mut world);
            assert_eq!(robot.get::<HealthMonitor>().fault().is_some(), cycle >= 599, "in cycle {cycle}");
        }
        assert_eq!(robot.get::<HealthMonitor>().fault(), Some(Fault::Hot(Joint::LKneePitch)));
        assert!(robot.act().stiffness.0.iter().all(|stiffness| *stiffness <= NAO.sit_stiffness));
        assert_eq!(world.referee().falls(), 0);
    }

    #[test]
    fn fallen_robot_rises_after_a_hot_joint_cooled() {
        let (mut robot, mut world) = forward();
        for cycle in 0..2600 {
            match cycle {
                100 => world.add_velocity(Vec2::new(-2.3, 0.0)),
                30 => world.set_motor_temperature(Joint::LKneePitch, 78.0),
                1500 => world.set_motor_temperature(Joint::LKneePitch, 60.0),
                _ => {}
            }
            run_cycle(cycle, &mut robot, &mut world);
            if (1000..1500).contains(&cycle) {
                assert!(
                    robot.act().stiffness.0.iter().all(|stiffness| *stiffness <= NAO.sit_stiffness),
                    "in cycle {cycle}: {:?}, {:?}, {:?}",
                    robot.of::<bica_player::behaviour::SafetyGuard>().state_name(),
                    robot.of::<bica_player::behaviour::Player>().state_name(),
                    robot.get::<HealthMonitor>().fault()
                );
                assert!(robot.get::<HealthMonitor>().fault().is_some());
            }
        }
        assert_eq!(robot.get::<HealthMonitor>().fault(), None);
        assert_eq!((world.referee().falls(), world.referee().posture()), (1, Posture::Upright));
    }

    #[test]
    fn sitting_robot_stands_up_after_cooling() {
        let (mut robot, mut world) = forward();
        for cycle in 0..2500 {
            match cycle {
                100 => world.set_motor_temperature(Joint::LKneePitch, 78.0),
                1500 => world.set_motor_temperature(Joint::LKneePitch, 60.0),
                _ => {}
            }
            run_cycle(cycle, &mut robot, &mut world);
        }
        assert_eq!(robot.get::<HealthMonitor>().fault(), None);
        assert!(!robot.of::<SafetyGuard>().is_active());
        assert_eq!((world.referee().falls(), world.referee().posture()), (0, Posture::Upright));
    }

    #[test]
    fn a_trial_fails_if_its_requirements_are_not_met() {
        let held = run(&["trial", "odometry", "--runs", "1", "--json"]);
        assert_eq!(held.code, Some(0), "{}", held.stderr);
        assert_eq!(held.json()["tables"][0]["trial"], "odometry");
        // With this torque limit the legs cannot carry the robot.
        let weak = run(&["trial", "odometry", "--runs", "1", "--torque-limit", "0.5", "--json"]);
        assert_eq!(weak.code, Some(1), "{}", weak.stderr);
        let wrong = run(&["trial", "odometry", "--friction", "9"]);
        assert_eq!(wrong.code, Some(2));
        assert!(wrong.stderr.contains("friction"), "{}", wrong.stderr);
    }
}

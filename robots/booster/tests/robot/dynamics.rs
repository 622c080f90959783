//! Walk and kicks of a T1 in MuJoCo behind the driver, in step.

use bica_body::Posture;
use bica_body::mujoco::Physics;
use bica_booster::T1;
use bica_motion::kick::{Kick, KickKind, KickMotion};
use bica_motion::limbs::Limbs;
use bica_motion::model::simulation;
use bica_motion::robot::Command;
use bica_motion::side::Side;
use bica_motion::stiffness::Stiffness;
use bica_motion::walk::{Feedback, Velocity, Walk};

use crate::in_step::InStep;

/// A robot with a gait and no behaviours.
struct Walker {
    robot: InStep,
    walk: Walk,
}

impl Walker {
    /// A robot that stands. A command acts `dead_time` after its cycle began, and measurements are `sensor_delay` old, s.
    fn new(dead_time: f32, sensor_delay: f32) -> Self {
        let physics = Physics { dead_time, sensor_delay, ..Physics::of(simulation::T1) };
        let robot = InStep::new(T1, simulation::T1, 1, &physics);
        let walk = Walk::new(T1.model, &T1.model.dynamic_profile.gait);
        let mut walker = Self { robot, walk };
        walker.go(Velocity::ZERO, 1.0);
        walker
    }

    fn cycle(&mut self, motion: &mut dyn FnMut(&mut Walk, &Feedback) -> Limbs) {
        self.robot.cycle(&mut |sensors| {
            let targets = motion(&mut self.walk, &Feedback::from(sensors)).joints(T1.model);
            Command { stiffness: Stiffness::Walk.joints(T1.model), ..Command::new(targets, 1.0) }
        });
        assert_eq!(self.robot.body.posture(), Posture::Upright);
    }

    fn go(&mut self, velocity: Velocity, seconds: f32) {
        for _ in 0..(100.0 * seconds) as u32 {
            self.cycle(&mut |walk, feedback| walk.step(velocity, feedback, 0.01));
        }
    }

    fn kick(&mut self, kind: KickKind, foot: Side) {
        let mut kick = KickMotion::new(T1.model, Kick { kind, foot }, T1.model.dynamic_profile);
        while !kick.is_done() {
            self.cycle(&mut |_, feedback| kick.step(feedback, 0.01));
        }
        self.go(Velocity::ZERO, 1.5);
    }
}

/// The gait was tuned with 16 ms from a measurement to its effect; behind the robot's topics they are 4 to 8 ms.
#[test]
fn speed_of_walk_is_independent_of_latency() {
    for (dead_time, sensor_delay) in [(0.01, 0.006), (0.004, 0.0)] {
        for requested in [-0.2, 0.1, 0.4] {
            let (mut walker, velocity) = (Walker::new(dead_time, sensor_delay), Velocity::new(requested, 0.0, 0.0));
            walker.go(velocity, 2.0);
            let before = walker.robot.body.ground_pose();
            walker.go(velocity, 3.0);
            let reached = (before.inverse() * walker.robot.body.ground_pose()).position.x / 3.0;
            let is_near = (reached - requested).abs() < 0.2 * requested.abs();
            assert!(
                is_near,
                "{reached} m/s where {requested} m/s are requested, with {dead_time} and {sensor_delay} s"
            );
        }
    }
}

#[test]
fn kicks_after_steps_do_not_end_in_a_fall() {
    let mut walker = Walker::new(0.004, 0.0);
    for kind in [KickKind::Front, KickKind::Diagonal, KickKind::Lateral] {
        for foot in Side::BOTH {
            walker.go(Velocity::new(0.1, 0.0, 0.0), 1.5);
            walker.go(Velocity::ZERO, 1.5);
            walker.kick(kind, foot);
        }
    }
}

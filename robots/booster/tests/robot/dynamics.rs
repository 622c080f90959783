//! T1 in MuJoCo behind the driver, in step: with the states of the robot, and with a program that answers after some time.

use bica_body::Posture;
use bica_body::mujoco::{Humanoid, Model, Physics};
use bica_body::random::Random;
use bica_booster::message::{ImuState, LowState, MotorState};
use bica_booster::{Gait, T1};
use bica_motion::kick::{Kick, KickKind, KickMotion};
use bica_motion::limbs::Limbs;
use bica_motion::model::simulation;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_motion::side::Side;
use bica_motion::stiffness::Stiffness;
use bica_motion::walk::{Feedback, Velocity, Walk};
use glam::EulerRot;

use crate::stand_in::StandIn;

/// Time from the beginning of a cycle until the program has answered, ms.
const ANSWER: u64 = 2;

/// A robot with a gait and no behaviours.
struct Walker {
    robot: StandIn,
    body: Humanoid,
    walk: Walk,
}

impl Walker {
    /// A robot that stands. A command acts `dead_time` after its cycle began, and measurements are `sensor_delay` old, s.
    fn new(dead_time: f32, sensor_delay: f32) -> Self {
        let physics = Physics { dead_time, sensor_delay, ..Physics::of(simulation::T1) };
        let built = Model::on_floor(simulation::T1, &physics).expect("a model");
        let body = Humanoid::new(simulation::T1, built, Pose2::ORIGIN, Random::new(1, 1_u64), &physics, |_| {});
        let mut robot = StandIn::following(T1, Gait::Own);
        // The motion to the stand ends; then a cycle of the program begins with that of the body.
        robot.run(3000);
        let cycles = robot.cycles;
        while robot.cycles == cycles {
            robot.run(1);
        }
        robot.run(9);
        robot.program = |_, _| None;
        let walk = Walk::new(T1.model, &T1.model.dynamic_profile.gait);
        let mut walker = Self { robot, body, walk };
        walker.go(Velocity::ZERO, 1.0);
        walker
    }

    fn cycle(&mut self, motion: &mut dyn FnMut(&mut Walk, &Feedback) -> Limbs) {
        self.robot.measured = Some(self.state());
        for _ in 0..10 {
            self.robot.run(1);
            if let Some(sensors) = self.robot.sensed.take() {
                let targets = motion(&mut self.walk, &Feedback::from(&sensors)).joints(T1.model);
                let command = Command { stiffness: Stiffness::Walk.joints(T1.model), ..Command::new(targets, 1.0) };
                self.robot.command = Some((self.robot.millis + ANSWER, command));
            }
        }
        let (_, sent) = self.robot.commands.last().expect("a command");
        let mut command = Command::new(T1.model.stand, 0.0);
        for (joint, motor) in T1.motors.iter().zip(&sent.motor_cmd) {
            (command.targets[*joint], command.stiffness[*joint]) = (motor.q, motor.kp / T1.kp[*joint]);
        }
        self.body.act(&command);
        assert_eq!(self.body.posture(), Posture::Upright);
    }

    fn state(&self) -> LowState {
        let sensors = self.body.sensors();
        let (_, pitch, roll) = self.body.pose().matrix3.to_euler(EulerRot::ZYX);
        let motor = |joint: &_| MotorState { q: sensors.angles[*joint], temperature: 40, ..MotorState::default() };
        let motors: Vec<_> = T1.motors.iter().map(motor).collect();
        let (gyro, acc) = (sensors.inertial.gyro.to_array(), sensors.inertial.acceleration.to_array());
        let imu_state = ImuState { rpy: [roll, pitch, 0.0], gyro, acc };
        LowState { imu_state, motor_state_parallel: motors.clone(), motor_state_serial: motors }
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
            let before = walker.body.ground_pose();
            walker.go(velocity, 3.0);
            let reached = (before.inverse() * walker.body.ground_pose()).position.x / 3.0;
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

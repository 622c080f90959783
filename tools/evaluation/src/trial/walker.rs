//! A robot without behaviours: gait and odometry only.

use bica_app::Failure;
use bica_motion::joints::{Joint, Joints};
use bica_motion::limbs::Limbs;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::odometry::{MotionInput, Odometry};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command, Lights, Sensors};
use bica_motion::senses::SenseEstimator;
use bica_motion::side::Side;
use bica_motion::stiffness::Stiffness;
use bica_motion::walk::{Feedback, Velocity, Walk};
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::referee::Event;
use bica_sim::setup::{Setup, Start};
use bica_sim::{CYCLE_SECONDS, World};
use glam::Vec2;

/// A robot alone on the field, with a gait and odometry.
pub(super) struct Walker {
    pub(super) model: &'static SimulatedModel,
    pub(super) world: MujocoWorld,
    senses: SenseEstimator,
    gait: Walk,
    odometry: Odometry,
    /// Joint targets of the last cycle, rad.
    commanded: Joints,
    /// Position where the ball was put, and the largest displacement from there, m.
    ball: [Vec2; 2],
}

impl Walker {
    /// A standing robot; the ball lies in a corner.
    pub(super) fn new(
        model: &'static SimulatedModel,
        seed: u64,
        robot: Pose2,
        physics: &Physics,
    ) -> Result<Self, Failure> {
        let start = Some(Start { robot, ball: Vec2::new(-2.8, 1.8) });
        let setup = Setup { seed, goalkeeper: false, start, ..Setup::default() };
        let world = MujocoWorld::new(model, &setup, physics)
            .map_err(|error| Failure::new(error.to_string(), "try another value"))?;
        let (gait, odometry) = (&model.dynamic_profile.gait, Odometry::new(model, &model.dynamic_profile.odometry));
        let commanded = gait.stand(model).joints(model);
        let (senses, gait, ball) = (SenseEstimator::new(model), Walk::new(model, gait), [Vec2::ZERO; 2]);
        let mut walker = Self { model, world, senses, gait, odometry, commanded, ball };
        walker.go(Velocity::ZERO, 1.0);
        Ok(walker)
    }

    /// Walks with a velocity for some seconds, or until a fall.
    pub(super) fn go(&mut self, velocity: Velocity, seconds: f32) {
        for _ in 0..cycles(seconds) {
            if self.fell() {
                return;
            }
            self.cycle(velocity);
        }
    }

    /// Requests an in-walk kick with a foot.
    pub(super) const fn kick(&mut self, foot: Side) {
        self.gait.request_kick(foot);
    }

    /// Walks for one control cycle.
    pub(super) fn cycle(&mut self, velocity: Velocity) {
        let sensors = self.sense();
        self.walk(velocity, &sensors);
    }

    /// Reads the sensors, once in each control cycle, and estimates missing values.
    pub(super) fn sense(&mut self) -> Sensors<'static> {
        let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, .. } =
            self.world.sensors();
        let mut sensors =
            Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: None };
        self.senses.complete(&mut sensors, CYCLE_SECONDS);
        sensors
    }

    /// Walks for one control cycle with the given measurements.
    pub(super) fn walk(&mut self, velocity: Velocity, sensors: &Sensors) {
        let limbs = self.gait.step(velocity, &Feedback::from(sensors), CYCLE_SECONDS);
        let moved = MotionInput {
            commanded: Some(&self.commanded),
            angles: &sensors.angles,
            feet: [&sensors.left_foot, &sensors.right_foot],
            gyro_turn: Some(sensors.inertial.gyro.z * CYCLE_SECONDS),
        };
        self.odometry.step(&moved);
        self.act(&limbs);
    }

    /// Moves the limbs for one control cycle.
    pub(super) fn act(&mut self, limbs: &Limbs) {
        let mut stiffness = Stiffness::Walk.joints(self.model);
        for joint in [Joint::HeadYaw, Joint::HeadPitch] {
            stiffness[joint] = 0.7;
        }
        self.command(limbs.joints(self.model), stiffness);
    }

    /// Moves all joints for one control cycle.
    pub(super) fn command(&mut self, targets: Joints, stiffness: Joints) {
        self.commanded = targets;
        self.world.act(&Command { targets, stiffness, lights: Lights::default(), camera: CameraId::Top });
        let [from, farthest] = &mut self.ball;
        let way = self.world.referee().ball() - *from;
        if way.length() > farthest.length() {
            *farthest = way;
        }
    }

    /// Puts the ball at a position, m, field frame.
    pub(super) fn put_ball(&mut self, at: Vec2) {
        self.world.set_ball(at);
        self.ball = [at, Vec2::ZERO];
    }

    /// Returns the largest displacement of the ball since it was put, m. The current one may be smaller: after a goal
    /// the ball is put back.
    pub(super) const fn ball_way(&self) -> Vec2 {
        self.ball[1]
    }

    /// Begins a new gait from the stand.
    pub(super) fn stand(&mut self) {
        self.gait = Walk::new(self.model, &self.model.dynamic_profile.gait);
    }

    /// Returns the time of the first fall, s; `None` without one.
    pub(super) fn fall(&self) -> Option<f32> {
        let mut events = self.world.referee().events().iter();
        let fall = events.find(|happened| matches!(happened.event, Event::Fall(_)));
        fall.map(|fall| fall.at.as_secs_f32())
    }

    /// Returns whether the robot fell.
    pub(super) fn fell(&self) -> bool {
        self.fall().is_some()
    }

    /// Returns the true pose.
    pub(super) fn pose(&self) -> Pose2 {
        self.world.referee().robot()
    }

    /// Returns the pose by odometry, relative to the start.
    pub(super) const fn odometry_pose(&self) -> Pose2 {
        self.odometry.pose()
    }
}

/// Returns the number of control cycles in a time, s.
pub(super) fn cycles(seconds: f32) -> usize {
    (seconds / CYCLE_SECONDS).round() as usize
}

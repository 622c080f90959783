//! A robot in MuJoCo with motors and sensors.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Command, Sensors};
use glam::{Affine3A, Vec2, Vec3};
use mujoco_rs::prelude::MjData;

use super::contacts::{Contacts, GeomOwners};
use super::fall_monitor::FallMonitor;
use super::model::{Drive, FreeJoint, Model, STEP};
use super::motors::{Motors, currents};
use super::physics::{Fault, Physics};
use super::sensor_model::{Measurement, SensorModel};
use super::soundness;
use super::state::{Data, angles, ideal_measurement, place, pose, stand};
use crate::motor_heat::MotorHeat;
use crate::random::Random;
use crate::{CYCLE_SECONDS, Posture};

/// Number of steps of the physics per control cycle.
const STEPS: usize = (CYCLE_SECONDS / STEP + 0.5) as usize;

/// A robot, and the state of all that MuJoCo simulates with it.
pub struct Humanoid {
    model: &'static SimulatedModel,
    data: Data,
    torso: FreeJoint,
    drives: Vec<Drive>,
    feet: [usize; 2],
    owners: GeomOwners,
    motors: Motors,
    heat: MotorHeat,
    sensor_model: SensorModel,
    measurement: Measurement,
    contacts: Contacts,
    fall_monitor: FallMonitor,
    failure: Option<String>,
}

impl Humanoid {
    /// Puts the robot on its feet at a pose on the ground, world frame. `noise` draws the noise of its sensors; `arrange` puts everything
    /// else where it begins.
    #[must_use]
    pub fn new(
        model: &'static SimulatedModel,
        built: Model,
        at: Pose2,
        noise: Random,
        physics: &Physics,
        arrange: impl FnOnce(&mut Data),
    ) -> Self {
        let Model { physics: compiled, torso, drives, feet } = built;
        let owners = GeomOwners::of(&compiled);
        let mut data = MjData::new(compiled);
        stand(model, &mut data, torso, &drives, at);
        arrange(&mut data);
        data.forward();
        let mut sensor_model = SensorModel::new(ideal_measurement(&data, torso, &drives), noise, physics);
        let measurement = sensor_model.measure();
        Self {
            model,
            data,
            torso,
            drives,
            feet,
            owners,
            motors: Motors::holding(model, model.stand, physics),
            heat: MotorHeat::new(model),
            sensor_model,
            measurement,
            contacts: Contacts::default(),
            fall_monitor: FallMonitor::new(at.heading),
            failure: None,
        }
    }

    /// Reason why the simulation cannot continue: a value is not finite or impossible, or MuJoCo warns. After that nothing moves.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// Executes a command for one control cycle. Returns the new posture if the robot falls or gets up. Does nothing after a
    /// [`failure`](Self::failure).
    pub fn act(&mut self, command: &Command) -> Option<Posture> {
        let valid = soundness::check(&self.data);
        if let Some(failure) = self.failure.take().or(valid) {
            self.failure = Some(failure);
            return None;
        }
        self.motors.command(self.model, command);
        self.contacts = Contacts::default();
        let mut mean_currents = Joints::all(0.0);
        for _ in 0..STEPS {
            let torques = self.step();
            self.failure = soundness::check(&self.data);
            if self.failure.is_some() {
                return None;
            }
            for (mean, current) in mean_currents.0.iter_mut().zip(currents(self.model, &torques).0) {
                *mean += current / STEPS as f32;
            }
        }
        self.heat.step(mean_currents);
        self.measurement = self.sensor_model.measure();
        self.fall_monitor.step(self.model, &self.pose(), self.contacts.floor)
    }

    /// Advances by one step of the physics. Returns the torques of the joints, Nm.
    fn step(&mut self) -> Joints {
        let mut damping = Joints::all(0.0);
        for drive in &self.drives {
            damping[drive.joint] = drive.velocity_gain * self.data.qvel()[drive.velocity] as f32;
        }
        let torques = self.motors.step(&self.angles(), &damping);
        for drive in &self.drives {
            self.data.ctrl_mut()[drive.actuator] = torques[drive.joint].into();
        }
        self.data.step();
        let ahead = self.feet.map(|foot| {
            let pose = &self.data.xmat()[foot];
            Vec3::new(pose[0] as f32, pose[3] as f32, pose[6] as f32)
        });
        self.owners.collect(&self.data, ahead, &mut self.contacts);
        self.sensor_model.step(ideal_measurement(&self.data, self.torso, &self.drives));
        Joints(core::array::from_fn(|i| torques.0[i] - damping.0[i]))
    }

    /// Measurements of this cycle, without an image.
    #[must_use]
    pub fn sensors(&self) -> Sensors<'static> {
        Sensors {
            angles: self.measurement.angles,
            temperatures: self.heat.temperatures(),
            currents: self.heat.currents(),
            inertial: self.measurement.inertial,
            left_foot: self.measurement.feet[0],
            right_foot: self.measurement.feet[1],
            buttons: self.contacts.buttons,
            image: None,
        }
    }

    /// Puts the robot on its feet at a pose on the ground, world frame, at rest.
    pub fn stand(&mut self, at: Pose2) {
        stand(self.model, &mut self.data, self.torso, &self.drives, at);
        let trees = self.data.model().dof_treeid().to_vec();
        for (velocity, tree) in self.data.qvel_mut().iter_mut().zip(&trees) {
            if *tree == trees[self.torso.velocity] {
                *velocity = 0.0;
            }
        }
        self.data.forward();
        self.motors.hold(self.model.stand);
        self.fall_monitor = FallMonitor::new(at.heading);
    }

    /// Sets the pose of the robot frame, world frame, and the joint angles, rad, for a picture. It changes neither
    /// velocities nor the commands of the motors.
    pub fn place(&mut self, robot: &Affine3A, angles: &Joints) {
        let (_, turn, at) = robot.to_scale_rotation_translation();
        place(&mut self.data, self.torso, &self.drives, (turn, at), angles);
    }

    /// Adds a velocity, m/s, world frame, to that of the torso. Values that are not finite are ignored.
    pub fn add_velocity(&mut self, velocity: Vec2) {
        if velocity.is_finite() {
            let own = &mut self.data.qvel_mut()[self.torso.velocity..][..2];
            own[0] += f64::from(velocity.x);
            own[1] += f64::from(velocity.y);
        }
    }

    /// Injects a permanent fault. For experiments.
    pub fn inject_fault(&mut self, fault: Fault) {
        match fault {
            Fault::Gyroscope => self.sensor_model.fail_gyroscope(),
            Fault::SoleSensors(side) => self.sensor_model.fail_sole(side),
            Fault::Motor(joint) => self.motors.fail(joint),
        }
    }

    /// Sets the temperature of a joint's motor, °C; from then on the thermal model continues. For experiments.
    pub fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.heat.set(joint, temperature);
    }

    /// Contacts of the robot in the last control cycle.
    #[must_use]
    pub const fn contacts(&self) -> &Contacts {
        &self.contacts
    }

    /// Returns whether the robot stands or has fallen.
    #[must_use]
    pub const fn posture(&self) -> Posture {
        self.fall_monitor.posture()
    }

    /// Pose of the robot frame, projected to the ground; while the robot lies, with the heading before the fall. World frame.
    #[must_use]
    pub fn ground_pose(&self) -> Pose2 {
        self.fall_monitor.pose(&self.pose())
    }

    /// Pose of the robot frame in the world frame.
    #[must_use]
    pub fn pose(&self) -> Affine3A {
        pose(&self.data, self.torso)
    }

    /// True joint angles, rad.
    #[must_use]
    pub fn angles(&self) -> Joints {
        angles(&self.data, &self.drives)
    }

    /// Poses of all segments in the robot frame.
    #[must_use]
    pub fn skeleton(&self) -> Skeleton {
        Skeleton::of(self.model, &self.angles())
    }

    /// State of all simulated objects.
    #[must_use]
    pub const fn data(&self) -> &Data {
        &self.data
    }

    /// Mutable state of all simulated objects, to move objects other than the robot.
    pub const fn data_mut(&mut self) -> &mut Data {
        &mut self.data
    }
}

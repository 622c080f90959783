//! Activation tree, sensor values and command of the robot.

use core::convert::Infallible;

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::joints::Joints;
use bica_motion::robot::{FootPressure, Inertial};
use bica_motion::walk::Feedback;
use glam::Vec3;

pub use crate::body::{Shining, Sounding};
pub use crate::exercise::{Attempt, Reasons};
pub use crate::input::Pressed;

use crate::body::{Lights, Motors, Mover, Sound, Walk};
use crate::exercise::ExerciseCheck;
use crate::input::{Guard, PatientPose, Signals, Trouble};
use crate::session::{Session, Step};
use crate::skeleton::Skeleton;

/// Sensor values of a cycle.
#[data]
#[derive(Clone, Debug)]
pub struct Sensors {
    /// Measured angles of the joints, rad.
    pub angles: Joints,
    /// Temperatures of the motors, °C; NaN where unknown.
    pub temperatures: Joints,
    /// Roll and pitch of the torso, rad.
    pub tilt: [f32; 2],
    /// Turn rates of the torso, rad/s.
    pub gyro: [f32; 3],
    /// Forces on the left and the right sole.
    pub feet: [FootPressure; 2],
    /// Buttons and touch.
    pub pressed: Pressed,
    /// Charge of the battery, 0 to 1.
    pub battery: f32,
    /// A new skeleton of the person, if any.
    pub person: Option<Skeleton>,
    /// Next part of a session that is being loaded.
    pub order: Option<Order>,
}

/// A part of a session.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    /// The next step.
    Step(Step),
    /// The next clip of sound, with its duration, s.
    Clip(f32),
    /// End of the session: all parts have been sent.
    Loaded,
}

/// Command of a cycle.
#[data]
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// Targets of the joints, rad.
    pub targets: Joints,
    /// Stiffness of each joint, 0 to 1.
    pub stiffness: Joints,
    /// Lights.
    pub lights: Shining,
    /// Sound.
    pub sound: Sounding,
    /// Repetition of the person for the record, with the number of the step.
    pub noted: Option<(u16, Attempt)>,
}

/// Stiffness of all joints after a fall.
const FALLEN: f32 = 0.1;

activation_tree! {
    /// A robot that plays therapy sessions: it shows movements, speaks, and judges the exercises of a person.
    pub struct Therapist {
        root: Session,
        cycle_hz: 100,
        budget_ms: 5,
        tunable,
        components: [
            Session,
            ExerciseCheck, PatientPose,
            Mover, Walk, Motors, Sound, Lights,
            Signals, Guard,
        ],
    }
}

impl Robot for Therapist {
    type Sensors<'a> = Sensors;
    type Command = Command;
    type Error = Infallible;

    fn sense(&mut self, sensors: &Sensors) -> Result<(), Infallible> {
        self.get_mut::<Signals>().receive(sensors.pressed);
        self.get_mut::<Guard>().measure(sensors.tilt, &sensors.temperatures, sensors.battery);
        let ([roll, pitch], gyro) = (sensors.tilt, Vec3::from_array(sensors.gyro));
        let inertial = Inertial { gyro, roll, pitch, ..Inertial::default() };
        let feedback = Feedback::new(&inertial, &sensors.feet[0], &sensors.feet[1], &sensors.angles);
        self.get_mut::<Walk>().measure(feedback, sensors.angles);
        if let Some(person) = sensors.person {
            self.get_mut::<PatientPose>().see(person);
        }
        if let Some(order) = sensors.order {
            self.get_mut::<Session>().plan.load(order);
        }
        Ok(())
    }

    fn act(&mut self) -> Command {
        let motors = self.get::<Motors>();
        let (targets, stiffness) = (*motors.targets(), motors.stiffness());
        let fallen = self.get::<Guard>().trouble() == Some(Trouble::Fallen);
        let stiffness = if fallen { Joints(stiffness.0.map(|stiffness| stiffness.min(FALLEN))) } else { stiffness };
        let (lights, sound) = (self.get::<Lights>().shining, self.get::<Sound>().sounding());
        let step = self.get::<Session>().at();
        let noted = self.get_mut::<ExerciseCheck>().news.take().map(|attempt| (step, attempt));
        Command { targets, stiffness, lights, sound, noted }
    }
}

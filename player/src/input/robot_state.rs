//! The state of joints, inertial unit and feet.

use bica::prelude::*;
use bica::visual::{self, Imu, Pose3};
use bica_motion::health::{FOLLOWING_STIFFNESS, is_upright};
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::kinematics::{Skeleton, ground_from_robot};
use bica_motion::model::RobotModel;
use bica_motion::robot::{FootPressure, Inertial, Sensors, is_plausible_angle};
use bica_motion::segment::Segment;
use bica_motion::side::Side;
use bica_motion::walk::Feedback;

use crate::MODEL;
use crate::output::JointCommand;
use crate::shapes;

/// Contact of the feet with the ground.
#[derive(Params)]
pub struct FootContact {
    /// Minimum force on a foot that touches the ground.
    #[param(default = 10.0, range = 0.0..=50.0, unit = "N", step = 0.5)]
    touch_force: f32,
}

/// Joint angles, inertial unit and foot pressure of this cycle, and the joint targets of the previous one.
#[derive(Clone, Copy, Debug)]
pub struct RobotState {
    model: &'static RobotModel,
    angles: Joints<f32>,
    commanded: Joints<f32>,
    /// Whether the legs are stiff enough to follow `commanded`.
    firm: bool,
    inertial: Inertial,
    feet: [FootPressure; 2],
    /// Minimum force on a foot that touches the ground, N.
    touch_force: f32,
}

#[component(budget_us = 1)]
impl RobotState {
    /// Creates the component before the first measurement, with all values zero.
    #[must_use]
    pub const fn new() -> Self {
        const NONE: FootPressure = FootPressure { front_left: 0.0, front_right: 0.0, rear_left: 0.0, rear_right: 0.0 };
        Self {
            model: MODEL,
            angles: Joints([0.0; JOINTS]),
            commanded: Joints([0.0; JOINTS]),
            firm: false,
            inertial: Inertial { gyro: glam::Vec3::ZERO, acceleration: glam::Vec3::ZERO, roll: 0.0, pitch: 0.0 },
            feet: [NONE; 2],
            touch_force: FootContact::DEFAULT.touch_force,
        }
    }

    fn step(&mut self, tuned: &Tuned<FootContact>) {
        self.touch_force = tuned.touch_force;
    }

    /// Sets the model of the controlled robot, see [`set_model`](crate::model::set_model).
    pub(crate) const fn set_model(&mut self, model: &'static RobotModel) {
        self.model = model;
    }

    /// The model of the robot.
    #[must_use]
    pub const fn model(&self) -> &'static RobotModel {
        self.model
    }

    /// Processes the measurements of this cycle and the command of the previous one. A measurement that is not finite or
    /// impossible is replaced by the last possible one; if it lasts, [`HealthMonitor`](super::HealthMonitor) reports a fault.
    pub fn measure(&mut self, sensors: &Sensors<'_>, commanded: &JointCommand) {
        for (kept, new) in self.angles.0.iter_mut().zip(sensors.angles.0) {
            if is_plausible_angle(new) {
                *kept = new;
            }
        }
        if sensors.inertial.is_plausible() {
            self.inertial = sensors.inertial;
        }
        if sensors.left_foot.is_plausible() && sensors.right_foot.is_plausible() {
            self.feet = [sensors.left_foot, sensors.right_foot];
        }
        self.commanded = commanded.targets;
        let stiffness = &commanded.stiffness;
        self.firm = stiffness[Joint::LKneePitch].min(stiffness[Joint::RKneePitch]) >= FOLLOWING_STIFFNESS;
    }

    /// Joint targets of the previous cycle, rad; `None` while the torso is not upright or the legs are too soft to follow.
    #[must_use]
    pub fn commanded(&self) -> Option<&Joints<f32>> {
        let upright = is_upright(&self.inertial);
        (self.firm && upright).then_some(&self.commanded)
    }

    /// The feedback for walk and kicks.
    #[must_use]
    pub const fn feedback(&self) -> Feedback {
        Feedback::new(&self.inertial, &self.feet[0], &self.feet[1], &self.angles)
    }

    /// Joint angles, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints<f32> {
        &self.angles
    }

    /// The inertial unit.
    #[must_use]
    pub const fn inertial(&self) -> &Inertial {
        &self.inertial
    }

    /// Pressure under the left and the right sole.
    #[must_use]
    pub const fn feet(&self) -> [&FootPressure; 2] {
        [&self.feet[0], &self.feet[1]]
    }

    /// Joint angles.
    #[output(unit = "rad", frame = "robot")]
    const fn joint_angles(&self) -> visual::Joints<[Joint; JOINTS], [f32; JOINTS]> {
        visual::Joints { names: Joint::ALL, positions: self.angles.0 }
    }

    /// Turn rates of the gyroscope and acceleration, along the torso's axes.
    #[output(unit = "rad/s, m/s²", frame = "torso")]
    fn inertial_unit(&self) -> Imu {
        let Inertial { gyro, acceleration, .. } = self.inertial;
        Imu {
            angular_velocity: shapes::vector(gyro),
            linear_acceleration: shapes::vector(acceleration),
            orientation: None,
        }
    }

    /// Pose of the torso, from the joint angles and the support foot.
    #[output(unit = "m", frame = "robot", child = "torso")]
    fn torso(&self) -> Pose3 {
        shapes::pose_in_space(&ground_from_robot(self.model, self.support(), &self.angles))
    }

    /// Pose of the head.
    #[output(unit = "m", frame = "torso", child = "head")]
    fn head(&self) -> Pose3 {
        shapes::pose_in_space(&Skeleton::of(self.model, &self.angles).pose(Segment::Head))
    }

    /// Roll of the torso, positive to the right.
    #[output(unit = "rad")]
    const fn roll(&self) -> f32 {
        self.inertial.roll
    }

    /// Pitch of the torso, positive forward.
    #[output(unit = "rad")]
    const fn pitch(&self) -> f32 {
        self.inertial.pitch
    }

    /// Force on the left and on the right sole.
    #[output(unit = "N")]
    fn foot_forces(&self) -> [f32; 2] {
        self.feet.map(|foot| foot.total())
    }

    /// The foot that carries more of the weight.
    #[output]
    #[must_use]
    pub fn support(&self) -> Side {
        if self.feet[1].total() > self.feet[0].total() { Side::Right } else { Side::Left }
    }

    /// Whether both feet touch the ground.
    #[output]
    #[must_use]
    pub fn grounded(&self) -> bool {
        self.touching() == [true; 2]
    }

    /// Whether a motion may end now: both feet touch the ground, or none does because the robot is held up.
    #[must_use]
    pub fn may_stop(&self) -> bool {
        let [left, right] = self.touching();
        left == right
    }

    /// Whether the left and the right foot touch the ground.
    fn touching(&self) -> [bool; 2] {
        self.feet.map(|foot| foot.total() > self.touch_force)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sensors(angle: f32, roll: f32) -> Sensors<'static> {
        Sensors {
            angles: Joints([angle; JOINTS]),
            temperatures: Joints([30.0; JOINTS]),
            currents: Joints([0.0; JOINTS]),
            inertial: Inertial { roll, ..Inertial::default() },
            left_foot: FootPressure::default(),
            right_foot: FootPressure::default(),
            buttons: bica_motion::robot::Buttons::default(),
            image: None,
        }
    }

    fn command(stiffness: f32) -> JointCommand {
        JointCommand { targets: Joints([0.2; JOINTS]), stiffness: Joints([stiffness; JOINTS]) }
    }

    #[test]
    fn impossible_measurement_keeps_last_one() {
        let mut state = RobotState::new();
        state.measure(&sensors(0.1, 0.3), &command(1.0));
        for odd in [f32::NAN, f32::INFINITY, -1e30, 5.0] {
            state.measure(&sensors(odd, odd), &command(1.0));
            assert_eq!(state.angles(), &Joints([0.1; JOINTS]));
            assert_eq!(state.inertial().roll.to_bits(), 0.3_f32.to_bits());
        }
    }

    #[test]
    fn ground_contact_force_is_tuned() {
        let mut state = RobotState::new();
        let foot = FootPressure { front_left: 5.0, ..FootPressure::default() };
        state.measure(&Sensors { left_foot: foot, right_foot: foot, ..sensors(0.0, 0.0) }, &command(1.0));
        for (touch_force, grounded) in [(10.0, false), (4.0, true), (6.0, false)] {
            state.step(&Tuned::new(FootContact { touch_force }));
            assert_eq!(state.grounded(), grounded, "{touch_force} N");
        }
    }

    #[test]
    fn motion_may_end_on_both_feet_or_in_the_air() {
        let mut state = RobotState::new();
        for (left, right, may_stop) in [(20.0, 20.0, true), (20.0, 0.0, false), (0.0, 20.0, false), (0.0, 0.0, true)] {
            let [left_foot, right_foot] =
                [left, right].map(|front_left| FootPressure { front_left, ..FootPressure::default() });
            state.measure(&Sensors { left_foot, right_foot, ..sensors(0.0, 0.0) }, &command(1.0));
            assert_eq!(state.may_stop(), may_stop, "{left} and {right} N");
        }
    }

    #[test]
    fn previous_command_needs_stiff_legs_upright_torso() {
        let mut state = RobotState::new();
        for (roll, stiffness, valid) in [(0.0, 1.0, true), (0.0, 0.5, false), (0.5, 1.0, false), (-0.5, 1.0, false)] {
            state.measure(&sensors(0.0, roll), &command(stiffness));
            assert_eq!(state.commanded().is_some(), valid, "roll {roll}, stiffness {stiffness}");
        }
    }
}

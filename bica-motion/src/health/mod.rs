//! Health of the body: faults of joints, motors, inertial unit and feet.
//!
//! A fault says nothing about the balance: see [`FallState`](crate::fall::FallState).

mod fault;
mod following;
mod motor_load;
mod senses;

pub use fault::Fault;
pub use senses::{Glimpse, Senses};

use self::following::{Following, STILL};
use self::motor_load::MotorLoad;
use crate::joints::{Joint, Joints};
use crate::kinematics::{centre_of_mass, sole};
use crate::model::{Range, RobotModel};
use crate::robot::{Inertial, Sensors};
use crate::side::Side;

/// Minimum stiffness at which a joint follows its target.
pub const FOLLOWING_STIFFNESS: f32 = 0.6;
/// Maximum roll and pitch of the torso at which feet and joints behave as in stand and walk, rad. Beyond, the robot falls or lies.
pub const UPRIGHT_TILT: f32 = 0.4;
/// Number of identical readings after which the inertial unit is broken: noise alone changes the last digits.
const INERTIAL_CYCLES: u16 = 100;
/// Number of cycles of 10 ms after which a foot without force is broken if the commanded posture loads it.
const SILENT_FOOT_CYCLES: u16 = 400;
/// Number of cycles of 10 ms without force from which on that posture counts: no motion stands on one foot for so long, but a robot
/// whose motion was interrupted in the middle of a step does.
const POSTURE_CYCLES: u16 = 300;
/// Maximum difference in height between the soles of a posture on both feet, m.
const MAX_LIFT: f32 = 0.001;
/// Minimum share of the weight on a foot that must measure force.
const MIN_SHARE: f32 = 0.1;
/// Number of joints that [`follow`](follows) their targets.
const FOLLOWERS: usize = 13;

/// Whether feet and joints behave as in stand and walk, by the torso's angles (see [`UPRIGHT_TILT`]).
#[must_use]
pub const fn is_upright(inertial: &Inertial) -> bool {
    inertial.roll.abs() < UPRIGHT_TILT && inertial.pitch.abs() < UPRIGHT_TILT
}

/// Monitor of joints, motors, inertial unit and feet.
///
/// A fault is permanent, except those by heat: they end when all temperatures are below the derating range and no coil
/// exceeds its continuous load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Health {
    fault: Option<Fault>,
    inertial: Inertial,
    same: u16,
    silent: [u16; 2],
    /// In the order of the model's joints.
    joints: [Following; FOLLOWERS],
    motor_load: MotorLoad,
    model: &'static RobotModel,
}

impl Health {
    /// No fault.
    #[must_use]
    pub const fn new(model: &'static RobotModel) -> Self {
        const STILL: Inertial =
            Inertial { gyro: glam::Vec3::ZERO, acceleration: glam::Vec3::ZERO, roll: 0.0, pitch: 0.0 };
        Self {
            fault: None,
            inertial: STILL,
            same: 0,
            silent: [0; 2],
            joints: [Following::at(0.0); FOLLOWERS],
            motor_load: MotorLoad::new(),
            model,
        }
    }

    /// Current fault, if any.
    #[must_use]
    pub const fn fault(&self) -> Option<Fault> {
        match self.fault {
            Some(fault) => Some(fault),
            None => self.motor_load.fault(),
        }
    }

    /// Stiffness after the derating of hot and loaded motors, see [`ThermalLimits`](crate::model::ThermalLimits).
    #[must_use]
    pub fn derated(&self, stiffness: &Joints) -> Joints {
        self.motor_load.derated(stiffness)
    }

    /// Processes the sensors of one cycle with the targets (rad) and stiffness commanded in the last cycle.
    pub fn step(&mut self, sensors: &Sensors<'_>, targets: &Joints, stiffness: &Joints) {
        let inertial = self.check_inertial(&sensors.inertial);
        let upright = is_upright(&sensors.inertial);
        let joint = self.check_joints(sensors, targets, stiffness, upright);
        let found = if upright {
            inertial.or_else(|| self.check_feet(sensors, targets)).or(joint)
        } else {
            self.silent = [0; 2];
            inertial.or(joint)
        };
        self.motor_load.step(self.model, sensors, upright);
        self.fault = self.fault.or(found);
    }

    fn check_inertial(&mut self, now: &Inertial) -> Option<Fault> {
        // A unit that never measured an acceleration may not exist in this world.
        let exists = now.acceleration != glam::Vec3::ZERO;
        let is_new = now.is_plausible() && (!exists || *now != self.inertial);
        self.same = if is_new { 0 } else { self.same.saturating_add(1) };
        self.inertial = *now;
        (self.same >= INERTIAL_CYCLES).then_some(Fault::Inertial)
    }

    /// Forces on soles that a robot does not measure are estimates: they are no sign of a broken sensor.
    fn check_feet(&mut self, sensors: &Sensors<'_>, targets: &Joints) -> Option<Fault> {
        if !self.model.senses.soles {
            return None;
        }
        let forces = [sensors.left_foot.total(), sensors.right_foot.total()];
        Side::BOTH.into_iter().find_map(|side| {
            let silent = forces[side.index()] <= 0.0 && forces[side.other().index()] >= self.model.support_force;
            let count = &mut self.silent[side.index()];
            *count = match silent {
                false => 0,
                true if *count >= POSTURE_CYCLES && !is_loaded(self.model, side, targets) => POSTURE_CYCLES,
                true => count.saturating_add(1),
            };
            (*count >= SILENT_FOOT_CYCLES).then_some(Fault::Foot(side))
        })
    }

    fn check_joints(
        &mut self,
        sensors: &Sensors<'_>,
        targets: &Joints,
        stiffness: &Joints,
        upright: bool,
    ) -> Option<Fault> {
        let watched = self.model.joints.iter().copied().filter(|&joint| follows(joint));
        watched.zip(&mut self.joints).fold(None, |found, (joint, following)| {
            let (target, angle) = (targets[joint], sensors.angles[joint]);
            let Range { min, max } = self.model.limits[joint];
            // The weight of a robot that lies may press a joint to the end of its range.
            let is_pressed = !upright && (angle < min + STILL || angle > max - STILL);
            if is_pressed || stiffness[joint] < FOLLOWING_STIFFNESS {
                following.pause(angle);
                return found;
            }
            let is_stuck = following.is_stuck(target, angle, is_head(joint), upright, self.model.stuck_evidence);
            found.or(is_stuck.then_some(Fault::Stuck(joint)))
        })
    }
}

/// Whether a posture (rad) has both soles on the ground, and the centre of mass so near to one foot that it carries a part of the
/// weight.
fn is_loaded(model: &'static RobotModel, side: Side, posture: &Joints) -> bool {
    let [own, other] = [side, side.other()].map(|side| sole(model, side, posture).translation);
    let share = (centre_of_mass(model, posture).y - other.y) / (own.y - other.y);
    (own.z - other.z).abs() < MAX_LIFT && share >= MIN_SHARE
}

/// Whether a joint must follow its target: legs and head. The arms are compliant and may rest on something.
const fn follows(joint: Joint) -> bool {
    is_head(joint) || matches!(joint.index(), 7..=17)
}

const fn is_head(joint: Joint) -> bool {
    joint.index() < 2
}

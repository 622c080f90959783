//! Whether the body can be trusted.

use crate::joints::{Joint, Joints};
use crate::motor_load::MotorLoad;
use crate::robot::{Inertial, Sensors};
use crate::side::Side;

/// Why a robot must not go on moving.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// A joint of the legs or the head does not go where it is told to: it is blocked, too weak, or its sensor is broken.
    Stuck(Joint),
    /// The inertial unit says the same again and again.
    Inertial,
    /// A foot feels nothing though the robot stands on both.
    Foot(Side),
    /// A joint's motor is so hot that the robot itself would soon weaken it.
    Hot(Joint),
    /// A joint's motor draws more current than it bears, and has for seconds.
    Overloaded(Joint),
}

impl core::fmt::Display for Fault {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Stuck(joint) => write!(f, "{joint:?} does not follow its target"),
            Self::Inertial => f.write_str("the inertial unit is silent"),
            Self::Foot(Side::Left) => f.write_str("the left foot's pressure sensors are silent"),
            Self::Foot(Side::Right) => f.write_str("the right foot's pressure sensors are silent"),
            Self::Hot(joint) => write!(f, "{joint:?} is too hot"),
            Self::Overloaded(joint) => write!(f, "{joint:?} draws too much current"),
        }
    }
}

/// A joint this far from its target does not follow, rad: three times what motors lag behind in the fastest kick.
const FAR: f32 = 0.7;
/// For this long, cycles of 10 ms.
const STUCK: u16 = 100;
/// Only joints held at least this hard have to follow.
const FIRM: f32 = 0.6;
/// So long an inertial unit never says exactly the same: its noise alone changes the last digits, cycles.
const SAME: u16 = 100;
/// No motion stands on one foot for so long, cycles.
const SILENT: u16 = 400;
/// A foot that carries the robot, N.
const CARRIES: f32 = 30.0;
/// Beyond this lean it is falling or lying, where neither feet nor joints do as usual, rad.
const UPRIGHT: f32 = 0.4;

impl Fault {
    /// Whether it passes with time: heat does.
    #[must_use]
    pub const fn is_temporary(self) -> bool {
        matches!(self, Self::Hot(_) | Self::Overloaded(_))
    }
}

/// Watches joints, motors, inertial unit and feet. Once it has found a fault, that stays; but what is too hot may move again
/// when everything has cooled below 70 °C, as the robot's own firmware has it, and no coil takes more than it bears for good.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Health {
    fault: Option<Fault>,
    inertial: Inertial,
    same: u16,
    silent: [u16; 2],
    /// The joint that is farthest off, and for how long it has been that.
    stuck: (Joint, u16),
    motor_load: MotorLoad,
}

impl Default for Health {
    fn default() -> Self {
        Self::new()
    }
}

impl Health {
    /// Nothing is wrong yet.
    #[must_use]
    pub const fn new() -> Self {
        const STILL: Inertial =
            Inertial { gyro: glam::Vec3::ZERO, acceleration: glam::Vec3::ZERO, roll: 0.0, pitch: 0.0 };
        Self {
            fault: None,
            inertial: STILL,
            same: 0,
            silent: [0; 2],
            stuck: (Joint::HeadYaw, 0),
            motor_load: MotorLoad::new(),
        }
    }

    /// What is wrong.
    #[must_use]
    pub const fn fault(&self) -> Option<Fault> {
        match self.fault {
            Some(fault) => Some(fault),
            None => self.motor_load.fault(),
        }
    }

    /// How hard to hold joints that are to be held with a `stiffness`: those whose motors are hot or draw much, less.
    ///
    /// The share falls to 0.7 on the way from 70 °C to 75 °C, and while the heat in the coil goes from three to four times
    /// what the motor bears for good. Beyond either a joint is a [`fault`](Self::fault).
    #[must_use]
    pub fn derated(&self, stiffness: &Joints) -> Joints {
        self.motor_load.derated(stiffness)
    }

    /// Compares a cycle's sensors with what the joints were told last, and how firmly.
    pub fn step(&mut self, sensors: &Sensors<'_>, targets: &Joints, stiffness: &Joints) {
        let inertial = self.inertial(&sensors.inertial);
        let upright = sensors.inertial.roll.abs() < UPRIGHT && sensors.inertial.pitch.abs() < UPRIGHT;
        let found = if upright {
            inertial.or_else(|| self.feet(sensors)).or_else(|| self.joints(sensors, targets, stiffness))
        } else {
            (self.silent, self.stuck.1) = ([0; 2], 0);
            inertial
        };
        self.motor_load.step(sensors, upright);
        self.fault = self.fault.or(found);
    }

    fn inertial(&mut self, now: &Inertial) -> Option<Fault> {
        // A unit that never said anything may be one that a world does not have.
        let says = now.acceleration != glam::Vec3::ZERO;
        self.same = if says && *now == self.inertial { self.same.saturating_add(1) } else { 0 };
        self.inertial = *now;
        (self.same >= SAME).then_some(Fault::Inertial)
    }

    fn feet(&mut self, sensors: &Sensors<'_>) -> Option<Fault> {
        let forces = [sensors.left_foot.total(), sensors.right_foot.total()];
        Side::BOTH.into_iter().find_map(|side| {
            let silent = forces[side.index()] <= 0.0 && forces[side.other().index()] >= CARRIES;
            let count = &mut self.silent[side.index()];
            *count = if silent { count.saturating_add(1) } else { 0 };
            (*count >= SILENT).then_some(Fault::Foot(side))
        })
    }

    fn joints(&mut self, sensors: &Sensors<'_>, targets: &Joints, stiffness: &Joints) -> Option<Fault> {
        let off = |joint: Joint| (targets[joint] - sensors.angles[joint]).abs();
        let watched = Joint::ALL.into_iter().filter(|&joint| follows(joint) && stiffness[joint] >= FIRM);
        let worst = watched.max_by(|&a, &b| off(a).total_cmp(&off(b))).filter(|&joint| off(joint) > FAR);
        self.stuck = match worst {
            Some(joint) if joint == self.stuck.0 => (joint, self.stuck.1.saturating_add(1)),
            Some(joint) => (joint, 1),
            None => (self.stuck.0, 0),
        };
        (self.stuck.1 >= STUCK).then_some(Fault::Stuck(self.stuck.0))
    }
}

/// Legs and head do; arms are soft and may rest against something.
const fn follows(joint: Joint) -> bool {
    matches!(joint.index(), 0 | 1 | 7..=17)
}

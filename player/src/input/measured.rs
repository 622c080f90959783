//! What the body measures of itself.

use bica::prelude::*;
use bica_motion::health::{FOLLOWING_STIFFNESS, Fault, Health, is_upright};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::{Nao, Profile, RobotModel};
use bica_motion::robot::{FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
use bica_motion::walk::Feedback;

/// A foot with more force on it has touched the ground, N.
const TOUCH: f32 = 10.0;

/// Joint angles, inertial unit and feet of this cycle, and what the chest button says.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    angles: Joints<f32>,
    commanded: Joints<f32>,
    /// Whether the legs are held so that they follow what they are told.
    firm: bool,
    inertial: Inertial,
    feet: (FootPressure, FootPressure),
    pressed: bool,
    playing: bool,
    profile: &'static Profile,
    health: Health,
}

#[component(budget_us = 1)]
impl Measured {
    /// A body that has measured nothing yet: everything zero. It is the built-in world's.
    #[must_use]
    pub const fn new() -> Self {
        const NONE: FootPressure = FootPressure { front_left: 0.0, front_right: 0.0, rear_left: 0.0, rear_right: 0.0 };
        Self {
            angles: Joints([0.0; bica_motion::joints::JOINTS]),
            commanded: Joints([0.0; bica_motion::joints::JOINTS]),
            firm: false,
            inertial: Inertial { gyro: glam::Vec3::ZERO, acceleration: glam::Vec3::ZERO, roll: 0.0, pitch: 0.0 },
            feet: (NONE, NONE),
            pressed: false,
            playing: true,
            profile: Nao::KINEMATIC_PROFILE,
            health: Health::new(),
        }
    }

    /// Takes this cycle's measurements. A value that is no number is replaced by the last good one.
    pub fn measure(&mut self, sensors: &Sensors<'_>) {
        for (kept, new) in self.angles.0.iter_mut().zip(sensors.angles.0) {
            if new.is_finite() {
                *kept = new;
            }
        }
        let new = &sensors.inertial;
        if new.gyro.is_finite() && new.acceleration.is_finite() && new.roll.is_finite() && new.pitch.is_finite() {
            self.inertial = *new;
        }
        if sensors.left_foot.total().is_finite() && sensors.right_foot.total().is_finite() {
            self.feet = (sensors.left_foot, sensors.right_foot);
        }
        let pressed = sensors.buttons.chest;
        self.playing ^= pressed && !self.pressed;
        self.pressed = pressed;
    }

    /// Compares this cycle's measurements with what the joints were told last, and how firmly, 0 to 1.
    pub fn check(&mut self, sensors: &Sensors<'_>, targets: &Joints, stiffness: &Joints) {
        self.health.step(sensors, targets, stiffness);
        self.commanded = *targets;
        self.firm = stiffness[Joint::LKneePitch].min(stiffness[Joint::RKneePitch]) >= FOLLOWING_STIFFNESS;
    }

    /// What the joints were told last, rad; none while the robot does not stand or its legs are too soft to follow.
    #[must_use]
    pub fn commanded(&self) -> Option<&Joints<f32>> {
        let upright = is_upright(&self.inertial);
        (self.firm && upright).then_some(&self.commanded)
    }

    /// Why the body must not go on moving, if there is a reason.
    #[must_use]
    pub const fn fault(&self) -> Option<Fault> {
        self.health.fault()
    }

    /// How hard to hold joints that are to be held with a `stiffness`: those with a hot or much loaded motor less firmly
    /// ([`Health::derated`]).
    #[must_use]
    pub fn derated(&self, stiffness: &Joints) -> Joints {
        self.health.derated(stiffness)
    }

    /// Makes this a body of another kind: one that moves as `profile` says.
    pub const fn set_profile(&mut self, profile: &'static Profile) {
        self.profile = profile;
    }

    /// How this body moves best.
    #[must_use]
    pub const fn profile(&self) -> &'static Profile {
        self.profile
    }

    /// What walking and kicking need to feel.
    #[must_use]
    pub const fn feedback(&self) -> Feedback {
        Feedback::new(&self.inertial, &self.feet.0, &self.feet.1, &self.angles)
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
    pub const fn feet(&self) -> (&FootPressure, &FootPressure) {
        (&self.feet.0, &self.feet.1)
    }

    /// The foot that carries more of the weight.
    #[must_use]
    pub fn support(&self) -> Side {
        if self.feet.1.total() > self.feet.0.total() { Side::Right } else { Side::Left }
    }

    /// Whether both feet are on the ground: what is under way may be broken off.
    #[must_use]
    pub fn grounded(&self) -> bool {
        self.feet.0.total().min(self.feet.1.total()) > TOUCH
    }

    /// Whether the robot is in the game: each press of the chest button takes it out or lets it in (rules of RoboCup 2009).
    #[must_use]
    pub const fn playing(&self) -> bool {
        self.playing
    }
}

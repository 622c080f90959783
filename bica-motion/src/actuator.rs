//! What drives the joints: motors, gears, and what they bear.
//!
//! Sources: speeds, torques and gears of the NAO V6's motors are Aldebaran's (its page on motors; gears also in rUNSWift 2019
//! `bodyV6.cpp`). Constants of torque and coil resistance follow from them at [`SUPPLY_VOLTAGE`].

use crate::joints::{JOINTS, Joint, Joints};

/// What the battery gives, V: six lithium cells.
pub const SUPPLY_VOLTAGE: f32 = 21.6;
/// Share of the torque that the gears let through. Our estimate, for three to four stages.
pub const GEAR_EFFICIENCY: f32 = 0.8;

/// A motor and the gear behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Actuator {
    /// Speed without a load, before the gear, rad/s.
    pub no_load_speed: f32,
    /// Torque that holds the motor still at full voltage, before the gear, Nm.
    pub stall_torque: f32,
    /// Torque that it bears for good, before the gear, Nm.
    pub continuous_torque: f32,
    /// Turns of the motor for one of the joint.
    pub gear_ratio: f32,
}

impl Actuator {
    /// Torque for each ampere before the gear, Nm/A.
    #[must_use]
    pub const fn torque_constant(&self) -> f32 {
        SUPPLY_VOLTAGE / self.no_load_speed
    }

    /// The current that it bears for good, A.
    #[must_use]
    pub const fn continuous_current(&self) -> f32 {
        self.continuous_torque / self.torque_constant()
    }

    /// The resistance of the coil, ohm: what holds the motor still is all the voltage.
    #[must_use]
    pub const fn resistance(&self) -> f32 {
        SUPPLY_VOLTAGE * self.torque_constant() / self.stall_torque
    }

    /// The current for a torque behind the gear, A, positive.
    #[must_use]
    pub const fn current(&self, torque: f32) -> f32 {
        torque.abs() / (self.torque_constant() * self.gear_ratio * GEAR_EFFICIENCY)
    }
}

/// What drives a joint.
#[must_use]
pub const fn actuator(joint: Joint) -> Actuator {
    const fn of(rpm: f32, [stall_torque, continuous_torque]: [f32; 2], gear_ratio: f32) -> Actuator {
        let no_load_speed = rpm * core::f32::consts::TAU / 60.0;
        Actuator {
            no_load_speed,
            stall_torque: 1e-3 * stall_torque,
            continuous_torque: 1e-3 * continuous_torque,
            gear_ratio,
        }
    }
    match joint {
        Joint::HeadYaw | Joint::LElbowYaw | Joint::RElbowYaw => of(10_700.0, [14.3, 6.2], 150.27),
        Joint::HeadPitch | Joint::LShoulderRoll | Joint::RShoulderRoll | Joint::LElbowRoll | Joint::RElbowRoll => {
            of(10_700.0, [14.3, 6.2], 173.22)
        }
        Joint::LShoulderPitch | Joint::RShoulderPitch => of(11_400.0, [22.4, 2.6], 150.27),
        Joint::LWristYaw | Joint::RWristYaw => of(8400.0, [9.4, 4.9], 50.61),
        Joint::LHand | Joint::RHand => of(8400.0, [9.4, 4.9], 36.24),
        Joint::LHipYawPitch | Joint::LHipRoll | Joint::RHipRoll | Joint::LAnkleRoll | Joint::RAnkleRoll => {
            of(8700.0, [65.0, 17.8], 201.3)
        }
        Joint::LHipPitch
        | Joint::RHipPitch
        | Joint::LKneePitch
        | Joint::RKneePitch
        | Joint::LAnklePitch
        | Joint::RAnklePitch => of(8700.0, [65.0, 17.8], 130.85),
    }
}

/// The current that each joint's motor bears for good, A.
pub static CONTINUOUS_CURRENT: Joints = {
    let mut currents = [0.0; JOINTS];
    let mut i = 0;
    while i < JOINTS {
        currents[i] = actuator(Joint::ALL[i]).continuous_current();
        i += 1;
    }
    Joints(currents)
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_figures_are_those_of_a_nao() {
        let knee = actuator(Joint::LKneePitch);
        assert!((knee.no_load_speed / knee.gear_ratio - 6.96).abs() < 0.01, "as F3 of the facts has it");
        assert!((CONTINUOUS_CURRENT[Joint::LKneePitch] - 0.75).abs() < 0.01);
        assert!((knee.current(2.48) - 1.0).abs() < 0.01 && (knee.current(-2.48) - 1.0).abs() < 0.01);
        assert!((knee.resistance() - 7.9).abs() < 0.05);
        for joint in Joint::ALL {
            let Actuator { stall_torque, continuous_torque, .. } = actuator(joint);
            assert!(continuous_torque > 0.0 && continuous_torque < stall_torque, "{joint:?}");
        }
    }
}

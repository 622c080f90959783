//! Motors.
//!
//! Sources: Aldebaran, NAO documentation, page "Motors" of the V6 (no-load speed, stall torque, nominal torque, reduction);
//! the reductions are also in rUNSWift 2019 `robot/utils/bodyV6.cpp`. Torque constant and coil resistance follow from
//! them at the supply voltage.

use crate::joints::{JOINTS, Joint, Joints};
use crate::model::{Actuator, Range, ThermalLimits};

/// Voltage of the battery, six lithium cells, V.
const SUPPLY_VOLTAGE: f32 = 21.6;
/// Efficiency of the gears. Our estimate for three to four stages.
const GEAR_EFFICIENCY: f32 = 0.8;

/// Motor and gear of each joint.
pub(super) const ACTUATORS: Joints<Actuator> = {
    let mut actuators = [actuator(Joint::HeadYaw); JOINTS];
    let mut i = 0;
    while i < JOINTS {
        actuators[i] = actuator(Joint::ALL[i]);
        i += 1;
    }
    Joints(actuators)
};

const fn actuator(joint: Joint) -> Actuator {
    match joint {
        Joint::HeadYaw | Joint::LElbowYaw | Joint::RElbowYaw => motor(10_700.0, [14.3, 6.2], 150.27),
        Joint::HeadPitch | Joint::LShoulderRoll | Joint::RShoulderRoll | Joint::LElbowRoll | Joint::RElbowRoll => {
            motor(10_700.0, [14.3, 6.2], 173.22)
        }
        Joint::LShoulderPitch | Joint::RShoulderPitch => motor(11_400.0, [22.4, 2.6], 150.27),
        Joint::LWristYaw | Joint::RWristYaw => motor(8400.0, [9.4, 4.9], 50.61),
        Joint::LHand | Joint::RHand => motor(8400.0, [9.4, 4.9], 36.24),
        Joint::LHipYawPitch | Joint::LHipRoll | Joint::RHipRoll | Joint::LAnkleRoll | Joint::RAnkleRoll => {
            motor(8700.0, [65.0, 17.8], 201.3)
        }
        Joint::LHipPitch
        | Joint::RHipPitch
        | Joint::LKneePitch
        | Joint::RKneePitch
        | Joint::LAnklePitch
        | Joint::RAnklePitch => motor(8700.0, [65.0, 17.8], 130.85),
    }
}

/// An actuator from the no-load speed in rpm and the stall and continuous torques in mNm, before the gear.
const fn motor(rpm: f32, [stall, continuous]: [f32; 2], gear_ratio: f32) -> Actuator {
    Actuator {
        voltage: SUPPLY_VOLTAGE,
        no_load_speed: rpm * core::f32::consts::TAU / 60.0,
        stall_torque: 1e-3 * stall,
        continuous_torque: 1e-3 * continuous,
        gear_ratio,
        gear_efficiency: GEAR_EFFICIENCY,
    }
}

/// Thermal limits of the motors.
///
/// Temperatures: the robot's firmware derates a leg's motor from 76 °C until it is below 70 °C (HULKs 2025 `step_planner.rs`).
/// Loads: our choice; in `MuJoCo` the knees reach 2.3 in walking, and a motor at full torque passes 4 within nine seconds.
pub(super) const THERMAL: ThermalLimits = ThermalLimits {
    temperature: Range { min: 70.0, max: 75.0 },
    load: Range { min: 3.0, max: 4.0 },
    derated_stiffness: 0.7,
};

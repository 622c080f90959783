//! Limits beyond which a motor is derated or a robot falls.

use crate::model::Range;

/// Thermal limits of the joint motors. The stiffness is reduced linearly from the lower to the upper end of each range; at
/// the upper end the motor has a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThermalLimits {
    /// Temperature of the motor, °C.
    pub temperature: Range,
    /// I²t load of the coil, relative to the load at the continuous current.
    pub load: Range,
    /// Share of the stiffness that is left at the upper end of one range, 0 to 1.
    pub derated_stiffness: f32,
}

/// Torso angles within which a robot does not fall, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallLimits {
    /// Minimum pitch (backward), negative.
    pub backward_pitch: f32,
    /// Maximum pitch (forward).
    pub forward_pitch: f32,
    /// Maximum magnitude of the roll.
    pub roll: f32,
}

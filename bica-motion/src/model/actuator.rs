//! Motor and gear of a joint.

/// A motor and its gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Actuator {
    /// Supply voltage, V.
    pub voltage: f32,
    /// No-load speed before the gear, rad/s.
    pub no_load_speed: f32,
    /// Stall torque at the supply voltage, before the gear, Nm.
    pub stall_torque: f32,
    /// Torque that the motor bears continuously, before the gear, Nm.
    pub continuous_torque: f32,
    /// Motor turns per turn of the joint.
    pub gear_ratio: f32,
    /// Efficiency of the gear, 0 to 1.
    pub gear_efficiency: f32,
}

impl Actuator {
    /// Torque constant before the gear, Nm/A.
    #[must_use]
    pub const fn torque_constant(&self) -> f32 {
        self.voltage / self.no_load_speed
    }

    /// Current that the motor bears continuously, A.
    #[must_use]
    pub const fn continuous_current(&self) -> f32 {
        self.continuous_torque / self.torque_constant()
    }

    /// Resistance of the coil, ohm: at stall it takes the whole voltage.
    #[must_use]
    pub const fn resistance(&self) -> f32 {
        self.voltage * self.torque_constant() / self.stall_torque
    }

    /// Copper loss that the motor bears continuously, W.
    #[must_use]
    pub const fn continuous_loss(&self) -> f32 {
        self.resistance() * self.continuous_current() * self.continuous_current()
    }

    /// Magnitude of the current for a torque after the gear (Nm), A.
    #[must_use]
    pub const fn current(&self, torque: f32) -> f32 {
        torque.abs() / (self.torque_constant() * self.gear_ratio * self.gear_efficiency)
    }
}

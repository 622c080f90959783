//! Stiffness of the joints.

/// Stiffness of the limbs, 0 (limp) to 1. Hands are limp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimbStiffness {
    /// Both head joints.
    pub head: f32,
    /// Shoulder pitch.
    pub shoulder_pitch: f32,
    /// Shoulder roll.
    pub shoulder_roll: f32,
    /// Both elbow joints.
    pub elbow: f32,
    /// Wrist yaw.
    pub wrist: f32,
    /// All leg joints.
    pub leg: f32,
}

/// Stiffness in each kind of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffnessTable {
    /// Standing.
    pub stand: LimbStiffness,
    /// Walking and kicking.
    pub walk: LimbStiffness,
    /// Falling.
    pub fall: LimbStiffness,
}

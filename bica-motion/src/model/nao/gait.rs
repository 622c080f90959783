//! Gaits.

use glam::Vec2;

use crate::model::Parameters;
use crate::velocity::Velocity;

/// Quasi-static gait for a world without dynamics: the centre of mass moves from foot to foot.
///
/// Orders of magnitude from B-Human 2018 and 2023, rUNSWift 2019, HULKs 2025 and Yggdrasil 2026 (half spacing, torso
/// offset, step height, arm swing, toe-in, earliest support switch). Our choice, step duration, hip height, sway and
/// velocities: the centre of mass stays over the feet at every moment, no joint needs more than 120 % of its maximum
/// speed, and legs and ankles reach sideways. The ankle gain is from those teams. The low-pass filter is slower than
/// theirs (0.6 to 0.8): without compliance between ankle and torso, the loop gain
/// `ankle_pitch_gain * (1 - gyro_smoothing) / dt` must stay below 1. The maximum speed of a capture step is the maximum
/// foot speed of HULKs 2025.
pub(super) const KINEMATIC: Parameters = Parameters {
    hip_height: 0.215,
    half_spacing: 0.050,
    lateral_foot_inset: 0.28,
    torso_offset: 0.012,
    step_duration: 0.28,
    start_shift: 0.0,
    lateral_duration_gain: -0.40,
    min_swing_duration: 0.11,
    step_height: 0.008,
    pendulum_height: 0.0,
    mid_step_hip_offset: 0.021,
    single_support_hip_offset: 0.031,
    lean_gain: 3.3,
    max_sway_speed: 0.6,
    max_velocity: Velocity::new(0.26, 0.12, 1.2),
    max_backward_speed: 0.15,
    max_speed_up: Velocity::new(0.07, 0.05, 0.6),
    max_slow_down: Velocity::new(0.14, 0.10, 1.2),
    velocity_drift: Velocity::ZERO,
    velocity_scale: Velocity::new(1.0, 1.0, 1.0),
    toe_in_share: 0.33,
    max_toe_in: 0.12,
    toe_distance: 0.1,
    earliest_support_switch: 0.75,
    max_liftoff_delay: 0.3,
    contact_force: 3.0,
    gyro_smoothing: 0.9,
    ankle_pitch_gain: 0.05,
    ankle_roll_gain: 0.0,
    hip_roll_offset: 0.0,
    lag_compensation: 0.0,
    ankle_pitch_offset: 0.0,
    kick_hip_roll_offset: 0.0,
    expected_knee_sag: 0.0,
    sag_hip_gain: 0.0,
    sag_knee_gain: 0.0,
    stand_ankle_gain: Vec2::ZERO,
    torso_pitch: 0.0,
    velocity_smoothing: None,
    capture_offset: Vec2::ZERO,
    capture_sway: 0.0,
    recovery_weights: [1.0; 3],
    min_recovery_duration: 0.28,
    max_recovery_duration: 0.28,
    capture_deadband: Vec2::ZERO,
    max_capture_step: Vec2::ZERO,
    max_inward_step: 0.0,
    max_capture_speed: 0.6,
    reported_capture_step: 0.03,
    kick_swing: 0.06,
    kick_min_distance: 0.13,
    kick_max_distance: 0.20,
    kick_lateral_tolerance: 0.025,
    arm_swing_gain: 6.0,
    arm_roll: 0.122,
};

/// Gait for a world with dynamics: the body moves from foot to foot as a linear inverted pendulum; pressure and gyroscope
/// synchronise the steps.
///
/// Orders of magnitude from the same teams. The parameters that they do not publish (pendulum, hip roll offset, capture
/// step, phase slowdown) and the exact gains were found in trials in `MuJoCo` with a dead time of 30 ms.
pub(super) const DYNAMIC: Parameters = Parameters {
    hip_height: 0.235,
    lateral_foot_inset: 0.0,
    torso_offset: 0.013,
    step_duration: 0.25,
    lateral_duration_gain: 0.0,
    min_swing_duration: 0.0,
    step_height: 0.02,
    pendulum_height: 0.26,
    lean_gain: 0.0,
    max_velocity: Velocity::new(0.32, 0.15, 1.0),
    velocity_drift: Velocity::new(0.015, 0.0, 0.0),
    velocity_scale: Velocity::new(0.93, 1.03, 1.22),
    contact_force: 15.0,
    gyro_smoothing: 0.5,
    ankle_pitch_gain: 0.08,
    ankle_roll_gain: 0.08,
    hip_roll_offset: 0.08,
    kick_hip_roll_offset: 0.1,
    expected_knee_sag: 0.048,
    sag_hip_gain: 2.0,
    sag_knee_gain: 0.5,
    stand_ankle_gain: Vec2::new(0.05, 0.08),
    torso_pitch: -0.03,
    capture_sway: 0.02,
    recovery_weights: [1.0, 0.004, 1.0],
    min_recovery_duration: 0.17,
    max_recovery_duration: 0.4,
    capture_deadband: Vec2::new(0.03, 0.012),
    max_capture_step: Vec2::new(0.12, 0.08),
    max_capture_speed: 1.5,
    max_inward_step: 0.01,
    kick_swing: 0.06,
    ..KINEMATIC
};

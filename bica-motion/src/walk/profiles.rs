//! The gaits that were tried.

use glam::Vec2;

use crate::walk::{Parameters, Velocity};

impl Parameters {
    /// The built-in world, where nothing has momentum: the centre of mass is led from foot to foot.
    ///
    /// Orders of magnitude from B-Human 2018/2023, rUNSWift 2019, HULKs 2025 and Yggdrasil 2026 (half spacing, torso
    /// offset, lift, arm swing, inside turn, earliest switch). Duration, hip height, sway and speeds are our own: chosen so
    /// that the centre of mass stays over the feet at every moment, that no joint is asked for more than a fifth above
    /// its speed, and that legs and ankles reach sideways. The ankle's gain is theirs; its low-pass is slower than theirs
    /// (0.6 to 0.8), because without compliance between ankle and torso the loop gain
    /// `ankle_gain * (1 - gyro_smoothing) / dt` must stay under 1.
    pub const BUILT_IN: Self = Self {
        hip_height: 0.215,
        half_spacing: 0.050,
        lateral_foot_inset: 0.28,
        torso_offset: 0.012,
        step_duration: 0.28,
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
        earliest_support_switch: 0.75,
        max_liftoff_delay: 0.3,
        contact_force: 3.0,
        gyro_smoothing: 0.9,
        ankle_pitch_gain: 0.05,
        ankle_roll_gain: 0.0,
        hip_roll_offset: 0.0,
        kick_hip_roll_offset: 0.0,
        expected_knee_sag: 0.0,
        sag_hip_gain: 0.0,
        sag_knee_gain: 0.0,
        stand_ankle_gain: Vec2::ZERO,
        torso_pitch: 0.0,
        capture_sway: 0.0,
        capture_gain: Vec2::ZERO,
        capture_deadband: Vec2::ZERO,
        max_capture_step: Vec2::ZERO,
        phase_slowdown: 0.0,
        kick_swing: 0.06,
        arm_swing_gain: 6.0,
    };

    /// A NAO with real forces: the body rocks from foot to foot as a pendulum, pressure and gyroscope keep the time.
    ///
    /// Orders of magnitude from the same teams. What they do not say (pendulum, support of the hip, catching, slowing)
    /// and the exact gains were found by trials in `MuJoCo` with 30 ms of dead time.
    pub const NAO: Self = Self {
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
        velocity_drift: Velocity::new(0.012, 0.0, 0.0),
        velocity_scale: Velocity::new(0.88, 0.95, 0.93),
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
        capture_gain: Vec2::new(0.4, 0.5),
        capture_deadband: Vec2::new(0.02, 0.012),
        max_capture_step: Vec2::new(0.08, 0.08),
        phase_slowdown: 20.0,
        kick_swing: 0.06,
        ..Self::BUILT_IN
    };
}

impl Default for Parameters {
    fn default() -> Self {
        Self::BUILT_IN
    }
}

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
        closer: 0.28,
        torso_offset: 0.012,
        duration: 0.28,
        duration_sideways: -0.40,
        least_air: 0.11,
        lift: 0.008,
        pendulum: 0.0,
        sway_to: 0.021,
        sway_clear: 0.031,
        lean: 3.3,
        sway_speed: 0.6,
        fastest: Velocity::new(0.26, 0.12, 1.2),
        backward: 0.15,
        speed_up: Velocity::new(0.07, 0.05, 0.6),
        slow_down: Velocity::new(0.14, 0.10, 1.2),
        drift: Velocity::ZERO,
        scale: Velocity::new(1.0, 1.0, 1.0),
        inside_turn: 0.33,
        most_inside: 0.12,
        earliest_switch: 0.75,
        longest_wait: 0.3,
        touch: 3.0,
        gyro_smoothing: 0.9,
        ankle_gain: 0.05,
        roll_gain: 0.0,
        hip_support: 0.0,
        hip_support_kicking: 0.0,
        knee_sag: 0.0,
        weak_hip: 0.0,
        weak_knee: 0.0,
        stand_gain: Vec2::ZERO,
        pitch: 0.0,
        rock: 0.0,
        catch: Vec2::ZERO,
        catch_from: Vec2::ZERO,
        catch_most: Vec2::ZERO,
        slow: 0.0,
        kick: 0.06,
        arm_swing: 6.0,
    };

    /// A NAO with real forces: the body rocks from foot to foot as a pendulum, pressure and gyroscope keep the time.
    ///
    /// Orders of magnitude from the same teams. What they do not say (pendulum, support of the hip, catching, slowing)
    /// and the exact gains were found by trials in `MuJoCo` with 30 ms of dead time.
    pub const NAO: Self = Self {
        hip_height: 0.235,
        closer: 0.0,
        torso_offset: 0.013,
        duration: 0.25,
        duration_sideways: 0.0,
        least_air: 0.0,
        lift: 0.02,
        pendulum: 0.26,
        lean: 0.0,
        fastest: Velocity::new(0.32, 0.15, 1.0),
        drift: Velocity::new(0.012, 0.0, 0.0),
        scale: Velocity::new(0.88, 0.95, 0.93),
        touch: 15.0,
        gyro_smoothing: 0.5,
        ankle_gain: 0.08,
        roll_gain: 0.08,
        hip_support: 0.08,
        hip_support_kicking: 0.1,
        knee_sag: 0.048,
        weak_hip: 2.0,
        weak_knee: 0.5,
        stand_gain: Vec2::new(0.05, 0.08),
        pitch: -0.03,
        rock: 0.02,
        catch: Vec2::new(0.4, 0.5),
        catch_from: Vec2::new(0.02, 0.012),
        catch_most: Vec2::new(0.08, 0.08),
        slow: 20.0,
        kick: 0.06,
        ..Self::BUILT_IN
    };
}

impl Default for Parameters {
    fn default() -> Self {
        Self::BUILT_IN
    }
}

//! What a gait is made of.

use crate::walk::Velocity;

/// The numbers of a gait. [`NAO`](Self::NAO) is tried; other values are for experiments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Hips over the ground, m.
    pub hip_height: f32,
    /// Half the distance between the feet when they are together, m.
    pub half_spacing: f32,
    /// How much each foot comes closer to the middle for each metre of a sideways step.
    pub closer: f32,
    /// How far the ankles stand behind the hips, m: the centre of mass comes over the middle of the feet.
    pub torso_offset: f32,
    /// Duration of a step, s.
    pub duration: f32,
    /// How much longer a step lasts for each m/s sideways, s; negative: quick small steps keep the feet within reach.
    pub duration_sideways: f32,
    /// The least time that the swinging foot needs in the air, s.
    pub least_air: f32,
    /// How high a foot is lifted, m.
    pub lift: f32,
    /// Sideways distance of the hips' middle from the ankle that carries, in the middle of a step, m. In a slow gait
    /// the body stands over this foot; a gait that rocks like a pendulum needs next to no sway, and a value near
    /// [`half_spacing`](Self::half_spacing) here.
    pub sway_to: f32,
    /// Up to this distance of the hips from the carrying ankle that foot alone holds the body, m: it sets how long both
    /// feet stay on the ground.
    pub sway_clear: f32,
    /// How far the torso leans over the carrying foot for each metre that the feet are farther apart than together,
    /// rad/m: with legs spread, swaying alone would turn the ankles beyond their limits.
    pub lean: f32,
    /// The most that the hips move sideways from foot to foot, m/s.
    pub sway_speed: f32,
    /// The most of each direction; `forward` holds ahead, [`backward`](Self::backward) astern.
    pub fastest: Velocity,
    /// The fastest way back, m/s, positive.
    pub backward: f32,
    /// The most by which each part of the velocity grows from step to step.
    pub speed_up: Velocity,
    /// The most by which each part of the velocity shrinks from step to step.
    pub slow_down: Velocity,
    /// Share of a turn that is made when the inner foot carries, with the toes pointing inwards.
    pub inside_turn: f32,
    /// The most that each foot's toes point inwards, rad: more, and the feet touch.
    pub most_inside: f32,
    /// From this share of a step on pressure may end it.
    pub earliest_switch: f32,
    /// The longest that a foot waits to leave the ground until the other one feels some, s; after that the walk goes on
    /// by time alone, as with a broken sensor.
    pub longest_wait: f32,
    /// A foot with at least this force on it has touched the ground, N.
    pub touch: f32,
    /// Weight of the old value in the low-pass of the gyroscope, per cycle of 10 ms.
    pub gyro_smoothing: f32,
    /// Ankle pitch per pitch rate, rad per rad/s.
    pub ankle_gain: f32,
    /// Shoulder pitch per forward way of the opposite foot, rad/m.
    pub arm_swing: f32,
}

impl Parameters {
    /// A NAO H25 on carpet.
    ///
    /// Orders of magnitude from B-Human 2018/2023, rUNSWift 2019, HULKs 2025 and Yggdrasil 2026 (half spacing, torso
    /// offset, lift, arm swing, inside turn, earliest switch). Duration, hip height, sway and speeds are our own: chosen so
    /// that the centre of mass stays over the feet at every moment, that no joint is asked for more than a fifth above
    /// its speed, and that legs and ankles reach sideways. The ankle's gain is theirs; its low-pass is slower than theirs
    /// (0.6 to 0.8), because without compliance between ankle and torso the loop gain
    /// `ankle_gain * (1 - gyro_smoothing) / dt` must stay under 1.
    pub const NAO: Self = Self {
        hip_height: 0.215,
        half_spacing: 0.050,
        closer: 0.28,
        torso_offset: 0.012,
        duration: 0.28,
        duration_sideways: -0.40,
        least_air: 0.11,
        lift: 0.008,
        sway_to: 0.021,
        sway_clear: 0.031,
        lean: 3.3,
        sway_speed: 0.6,
        fastest: Velocity::new(0.26, 0.12, 1.2),
        backward: 0.15,
        speed_up: Velocity::new(0.07, 0.05, 0.6),
        slow_down: Velocity::new(0.14, 0.10, 1.2),
        inside_turn: 0.33,
        most_inside: 0.12,
        earliest_switch: 0.75,
        longest_wait: 0.3,
        touch: 3.0,
        gyro_smoothing: 0.9,
        ankle_gain: 0.05,
        arm_swing: 6.0,
    };
}

impl Default for Parameters {
    fn default() -> Self {
        Self::NAO
    }
}

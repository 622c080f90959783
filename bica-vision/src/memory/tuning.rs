//! Rates and errors of memories.

/// Rates of forgetting, and errors of odometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemoryTuning {
    /// Time that halves the confidence in an object that is not seen, s; not positive or NaN: it is forgotten at once.
    pub half_life: f32,
    /// Walked distance that halves the confidence, m; odometry drifts by about a tenth.
    pub halving_distance: f32,
    /// Turn that halves the confidence, rad.
    pub halving_turn: f32,
    /// Factor on the confidence after an image that should show the object and does not, 0 to 1. One image may be blurred,
    /// a third of a second of images is not.
    pub miss_factor: f32,
    /// Standard deviation of odometry after 1 m of walking, m. Errors of steps are independent, so it grows with the square
    /// root of the distance.
    pub distance_error: f32,
    /// Standard deviation of odometry after a turn of 1 rad, rad; likewise.
    pub turn_error: f32,
}

impl MemoryTuning {
    /// The default values, with a half-life of 5 s.
    pub const DEFAULT: Self = Self {
        half_life: 5.0,
        halving_distance: 3.0,
        halving_turn: 6.0,
        miss_factor: 0.75,
        distance_error: 0.08,
        turn_error: 0.05,
    };
}

/// Rates and errors of the memory of the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallMemoryTuning {
    /// Rates of forgetting, and errors of odometry.
    pub memory: MemoryTuning,
    /// Deceleration of a ball on carpet, m/s², above 0.
    pub deceleration: f32,
    /// Standard deviation of the velocity of a ball just kicked, in each direction, m/s.
    pub kick_speed: f32,
    /// Rate at which a resting ball starts to roll, 1/s.
    pub kick_rate: f32,
    /// Rate at which a fast ball stops, at an obstacle, 1/s.
    pub stop_rate: f32,
}

impl BallMemoryTuning {
    /// The default values, with a half-life of 5 s. Source of the deceleration: B-Human 2023 `ballSpecification.cfg`.
    pub const DEFAULT: Self =
        Self { memory: MemoryTuning::DEFAULT, deceleration: 0.3, kick_speed: 1.0, kick_rate: 0.05, stop_rate: 0.2 };
}

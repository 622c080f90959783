//! Fall detection from the inertial unit.

use glam::Vec3;

use crate::model::{FallLimits, RobotModel};
use crate::robot::Inertial;

/// Side to which a robot falls, or on which it lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, postcard_schema::Schema)]
pub enum Direction {
    /// On its face.
    Front,
    /// On its back.
    Back,
    /// On its left side.
    Left,
    /// On its right side.
    Right,
}

impl Direction {
    /// All four directions.
    pub const ALL: [Self; 4] = [Self::Front, Self::Back, Self::Left, Self::Right];

    /// Reading of the accelerometer when the robot lies on this side, m/s², torso frame.
    #[must_use]
    pub const fn gravity(self) -> Vec3 {
        match self {
            Self::Front => Vec3::new(-9.81, 0.0, 0.0),
            Self::Back => Vec3::new(9.81, 0.0, 0.0),
            Self::Left => Vec3::new(0.0, -9.81, 0.0),
            Self::Right => Vec3::new(0.0, 9.81, 0.0),
        }
    }
}

/// State of the balance. It says nothing about faults of the body: see [`Health`](crate::health::Health).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, postcard_schema::Schema)]
pub enum FallState {
    /// On its feet.
    #[default]
    Upright,
    /// Falling; the fall cannot be prevented.
    Falling(Direction),
    /// Lying.
    Fallen(Direction),
}

impl FallState {
    /// Whether the robot is on its feet.
    #[must_use]
    pub const fn is_upright(self) -> bool {
        matches!(self, Self::Upright)
    }
}

/// Weight of a new angle in the low-pass filter, per cycle. Source: HULKs 2025.
const ANGLE_WEIGHT: f32 = 0.9;
/// Weight of a new acceleration in the low-pass filter, per cycle.
const ACCELERATION_WEIGHT: f32 = 0.1;

/// Limits of the fall detector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallTuning {
    /// Torso angles within which the robot does not fall.
    pub limits: FallLimits,
    /// Maximum tilt of a robot that has got up, rad.
    pub risen_tilt: f32,
    /// Minimum time within `risen_tilt` after which a fallen robot counts as upright, s.
    pub risen_time: f32,
    /// Maximum difference from the acceleration of a lying robot, m/s².
    pub lying_tolerance: f32,
    /// Time after which a falling robot counts as fallen in any case, s.
    pub max_fall_time: f32,
}

impl FallTuning {
    /// The default limits of a robot. Source of the lying tolerance and of the fall time: HULKs 2025.
    #[must_use]
    pub const fn of(model: &RobotModel) -> Self {
        Self { limits: model.fall_limits, risen_tilt: 0.3, risen_time: 0.3, lying_tolerance: 7.0, max_fall_time: 1.0 }
    }
}

/// Detector of falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallDetector {
    roll: f32,
    pitch: f32,
    acceleration: Vec3,
    state: FallState,
    /// Time in the state `Falling`, or within the tilt of a robot that has got up, s.
    time: f32,
    tuning: FallTuning,
}

impl FallDetector {
    /// A detector in the state [`Upright`](FallState::Upright) with the default limits ([`FallTuning::of`]).
    #[must_use]
    pub const fn new(model: &RobotModel) -> Self {
        Self {
            roll: 0.0,
            pitch: 0.0,
            acceleration: Vec3::ZERO,
            state: FallState::Upright,
            time: 0.0,
            tuning: FallTuning::of(model),
        }
    }

    /// Sets the limits to use from now on.
    pub const fn set_tuning(&mut self, tuning: &FallTuning) {
        self.tuning = *tuning;
    }

    /// Current state.
    #[must_use]
    pub const fn state(&self) -> FallState {
        self.state
    }

    /// Processes one reading after `dt` seconds. A reading with NaN or infinite values is skipped.
    pub fn step(&mut self, inertial: &Inertial, dt: f32) -> FallState {
        let finite = inertial.acceleration.is_finite() && inertial.roll.is_finite() && inertial.pitch.is_finite();
        if !finite || !dt.is_finite() {
            return self.state;
        }
        self.roll += ANGLE_WEIGHT * (inertial.roll - self.roll);
        self.pitch += ANGLE_WEIGHT * (inertial.pitch - self.pitch);
        self.acceleration += ACCELERATION_WEIGHT * (inertial.acceleration - self.acceleration);
        self.time += dt.max(0.0);
        let next = self.next();
        if next != self.state {
            self.time = 0.0;
        }
        self.state = next;
        next
    }

    fn next(&mut self) -> FallState {
        let FallTuning { risen_tilt, risen_time, max_fall_time, .. } = self.tuning;
        match self.state {
            FallState::Upright => self.excess_tilt().map_or(self.state, FallState::Falling),
            FallState::Falling(direction) => match (self.lying_side(), self.excess_tilt()) {
                (Some(side), _) => FallState::Fallen(side),
                (None, None) => FallState::Upright,
                (None, Some(_)) if self.time >= max_fall_time => FallState::Fallen(direction),
                (None, Some(_)) => self.state,
            },
            FallState::Fallen(direction) => {
                if self.roll.abs() > risen_tilt || self.pitch.abs() > risen_tilt {
                    self.time = 0.0;
                }
                if self.time >= risen_time {
                    FallState::Upright
                } else {
                    FallState::Fallen(self.lying_side().unwrap_or(direction))
                }
            }
        }
    }

    /// Direction in which the torso is tilted beyond the limits, if any.
    fn excess_tilt(&self) -> Option<Direction> {
        let limits = &self.tuning.limits;
        match (self.pitch, self.roll) {
            (pitch, _) if pitch > limits.forward_pitch => Some(Direction::Front),
            (pitch, _) if pitch < limits.backward_pitch => Some(Direction::Back),
            (_, roll) if roll > limits.roll => Some(Direction::Right),
            (_, roll) if roll < -limits.roll => Some(Direction::Left),
            _ => None,
        }
    }

    /// Side on which the robot lies according to the accelerometer, if any.
    fn lying_side(&self) -> Option<Direction> {
        let tolerance = self.tuning.lying_tolerance;
        Direction::ALL.into_iter().find(|side| (self.acceleration - side.gravity()).length() < tolerance)
    }
}

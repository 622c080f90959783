//! Falling: how to see it come, and how to know what one lies on.

use glam::Vec3;

use crate::robot::Inertial;

/// Where a robot falls or lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
    /// All four.
    pub const ALL: [Self; 4] = [Self::Front, Self::Back, Self::Left, Self::Right];

    /// What an accelerometer measures when the robot lies so, m/s².
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

/// Whether the robot is on its feet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum FallState {
    /// It is.
    #[default]
    Upright,
    /// It falls, and nothing can be done any more but to fall well.
    Falling(Direction),
    /// It lies.
    Fallen(Direction),
}

/// The torso's pitch within which a robot does not fall, rad: backward, forward. Source: HULKs 2025.
const PITCH: (f32, f32) = (-0.4, 0.6);
/// The torso's roll within which it does not fall, to both sides, rad: our choice; the steepest lean of the walk is 0.2.
const ROLL: f32 = 0.5;
/// Within this tilt a robot that had fallen is upright again, rad.
const UPRIGHT: f32 = 0.3;
/// It has to stay there this long, s.
const UPRIGHT_TIME: f32 = 0.3;
/// Share of a new angle in the smoothed one, per cycle. Source: HULKs 2025.
const NEW_ANGLE: f32 = 0.9;
/// Share of a new acceleration in the smoothed one, per cycle.
const NEW_ACCELERATION: f32 = 0.1;
/// So near to lying's acceleration a robot lies, m/s². Source: HULKs 2025.
const LYING: f32 = 7.0;
/// A fall is over after this time in any case, s. Source: HULKs 2025.
const LONGEST_FALL: f32 = 1.0;

/// Watches the inertial unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FallDetector {
    roll: f32,
    pitch: f32,
    acceleration: Vec3,
    state: FallState,
    /// How long it falls, or is upright again, s.
    time: f32,
}

impl FallDetector {
    /// A detector that believes the robot upright.
    #[must_use]
    pub const fn new() -> Self {
        Self { roll: 0.0, pitch: 0.0, acceleration: Vec3::ZERO, state: FallState::Upright, time: 0.0 }
    }

    /// What it believes.
    #[must_use]
    pub const fn state(&self) -> FallState {
        self.state
    }

    /// One cycle of `dt` seconds. A reading that is no number is skipped.
    pub fn step(&mut self, inertial: &Inertial, dt: f32) -> FallState {
        let finite = inertial.acceleration.is_finite() && inertial.roll.is_finite() && inertial.pitch.is_finite();
        if !finite || !dt.is_finite() {
            return self.state;
        }
        self.roll += NEW_ANGLE * (inertial.roll - self.roll);
        self.pitch += NEW_ANGLE * (inertial.pitch - self.pitch);
        self.acceleration += NEW_ACCELERATION * (inertial.acceleration - self.acceleration);
        self.time += dt.max(0.0);
        let next = self.next();
        if next != self.state {
            self.time = 0.0;
        }
        self.state = next;
        next
    }

    fn next(&mut self) -> FallState {
        match self.state {
            FallState::Upright => self.tilt().map_or(self.state, FallState::Falling),
            FallState::Falling(direction) => match (self.lies_on(), self.tilt()) {
                (Some(lies), _) => FallState::Fallen(lies),
                (None, None) => FallState::Upright,
                (None, Some(_)) if self.time >= LONGEST_FALL => FallState::Fallen(direction),
                (None, Some(_)) => self.state,
            },
            FallState::Fallen(direction) => {
                if self.roll.abs() > UPRIGHT || self.pitch.abs() > UPRIGHT {
                    self.time = 0.0;
                }
                if self.time >= UPRIGHT_TIME {
                    FallState::Upright
                } else {
                    FallState::Fallen(self.lies_on().unwrap_or(direction))
                }
            }
        }
    }

    /// Which way it is tilted too far, if any.
    fn tilt(&self) -> Option<Direction> {
        match (self.pitch, self.roll) {
            (pitch, _) if pitch > PITCH.1 => Some(Direction::Front),
            (pitch, _) if pitch < PITCH.0 => Some(Direction::Back),
            (_, roll) if roll > ROLL => Some(Direction::Right),
            (_, roll) if roll < -ROLL => Some(Direction::Left),
            _ => None,
        }
    }

    /// What it lies on, by the direction of gravity.
    fn lies_on(&self) -> Option<Direction> {
        Direction::ALL.into_iter().find(|direction| (self.acceleration - direction.gravity()).length() < LYING)
    }
}

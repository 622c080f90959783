//! Falls.

use bica::prelude::*;
use bica_motion::fall::{FallDetector as Detector, FallState};

use crate::Model;
use crate::input::RobotState;

/// Detects a fall before its end, and the side on which the robot lies.
#[derive(Debug)]
pub struct FallDetector {
    detector: Detector<Model>,
}

#[component(budget_us = 2)]
impl FallDetector {
    /// Creates the component with an upright robot.
    #[must_use]
    pub const fn new() -> Self {
        Self { detector: Detector::new() }
    }

    fn step(&mut self, time: &Time, state: &RobotState) {
        self.detector.step(state.inertial(), time.dt());
    }

    /// The state of the balance: upright, falling or fallen, with the side.
    #[must_use]
    pub const fn state(&self) -> FallState {
        self.detector.state()
    }

    /// Whether the robot falls or lies.
    #[must_use]
    pub fn is_down(&self) -> bool {
        self.state() != FallState::Upright
    }
}

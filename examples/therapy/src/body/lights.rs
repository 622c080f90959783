//! Lights of the eyes, ears and chest button.

use bica::prelude::*;
use bica_motion::robot::Light;

use crate::session::Lamp;

/// Lights of the robot.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shining {
    /// Both eyes.
    pub eyes: Light,
    /// Both ears, 0 to 1.
    pub ears: f32,
    /// The chest button.
    pub chest: Light,
}

/// Keeps the lights.
#[derive(Debug)]
pub struct Lights {
    pub(crate) shining: Shining,
}

#[component(budget_us = 1)]
impl Lights {
    pub(crate) const fn new() -> Self {
        const DARK: Light = Light(0.0, 0.0, 0.0);
        Self { shining: Shining { eyes: DARK, ears: 0.0, chest: DARK } }
    }

    pub(crate) const fn set(&mut self, lamp: Lamp, light: Light) {
        match lamp {
            Lamp::Eyes => self.shining.eyes = light,
            Lamp::Ears => self.shining.ears = light.2,
            Lamp::Chest => self.shining.chest = light,
        }
    }
}

//! Scan with the head.

use bica::prelude::*;
use bica_motion::robot::CameraId;

use crate::motion::Head;
use crate::output::CameraSelector;
use crate::perception::Localization;

/// Head pans in sequence, rad. Neighbouring images overlap by a third.
const PANS: [f32; 7] = [0.0, 0.6, 1.2, 1.9, -0.6, -1.2, -1.9];
/// Head tilt, rad.
const TILT: f32 = -0.05;
/// Duration of the stop in each direction, s.
const REST_TIME: f32 = 0.15;

/// Moves the head along the horizon from one side to the other, repeatedly, while the robot localizes itself.
#[derive(Debug)]
pub struct LookAround {
    /// Index in [`PANS`].
    glance: usize,
    glances: u32,
    /// Duration of the current stop so far, s.
    rested: f32,
    /// First side: 1 left, −1 right.
    side: f32,
}

#[component(hz = 50, budget_us = 5)]
impl LookAround {
    /// Creates the component with the left side first.
    #[must_use]
    pub const fn new() -> Self {
        Self { glance: 0, glances: 0, rested: 0.0, side: 1.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self { side: self.side, ..Self::new() };
    }

    fn step(&mut self, time: &Time, _field: &Localization, head: &mut Head, camera: &mut CameraSelector) {
        camera.select(CameraId::Top);
        head.look_at(self.side * PANS[self.glance], TILT);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > REST_TIME {
            self.rested = 0.0;
            self.glance = (self.glance + 1) % PANS.len();
            self.glances += 1;
        }
    }

    /// Sets the first side to that of `y`, positive for left; takes effect from the second direction on.
    pub const fn set_first_side(&mut self, y: f32) {
        self.side = 1.0_f32.copysign(y);
    }

    /// Number of completed directions since the component became active.
    #[must_use]
    pub const fn glances(&self) -> u32 {
        self.glances
    }

    /// Whether every direction is completed since the component became active.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.glances as usize >= PANS.len()
    }
}

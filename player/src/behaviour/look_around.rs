//! A look around with the head.

use bica::prelude::*;
use bica_motion::robot::CameraId;

use crate::motion::Head;
use crate::output::Gaze;
use crate::perception::Localization;

/// Where to look, one after the other, rad: one side first. Images overlap by a third.
const PANS: [f32; 7] = [0.0, 0.6, 1.2, 1.9, -0.6, -1.2, -1.9];
/// Head pitch while it looks, rad.
const TILT: f32 = -0.05;
/// How long the head rests in each direction, s.
const REST: f32 = 0.15;

/// Looks along the horizon from one side to the other, again and again, and finds out where on the field it is.
#[derive(Debug)]
pub struct LookAround {
    glance: usize,
    glances: u32,
    rested: f32,
    side: f32,
}

#[component(hz = 50, budget_us = 5)]
impl LookAround {
    /// Has not looked yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { glance: 0, glances: 0, rested: 0.0, side: 1.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self { side: self.side, ..Self::new() };
    }

    fn step(&mut self, time: &Time, _field: &Localization, head: &mut Head, gaze: &mut Gaze) {
        gaze.through(CameraId::Top);
        head.look_at(self.side * PANS[self.glance], TILT);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > REST {
            self.rested = 0.0;
            self.glance = (self.glance + 1) % PANS.len();
            self.glances += 1;
        }
    }

    /// Looks to the side of `y` first, positive for left; takes effect from the second glance on.
    pub const fn to_side_of(&mut self, y: f32) {
        self.side = 1.0_f32.copysign(y);
    }

    /// In how many directions it has looked since it began.
    #[must_use]
    pub const fn glances(&self) -> u32 {
        self.glances
    }

    /// Whether it has looked in every direction since it began.
    #[must_use]
    pub const fn looked_everywhere(&self) -> bool {
        self.glances as usize >= PANS.len()
    }
}

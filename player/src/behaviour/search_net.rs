//! The search for the goal.

use bica::prelude::*;
use bica_motion::robot::CameraId;

use crate::motion::Head;
use crate::output::Gaze;
use crate::perception::NetDetector;

/// Where to look, one after the other, rad: the side first on which the goal is remembered. Images overlap by a third.
const PANS: [f32; 7] = [0.0, 0.6, 1.2, 1.9, -0.6, -1.2, -1.9];
/// Head pitch while it looks, rad.
const TILT: f32 = -0.05;
/// How long the head rests in each direction, s.
const REST: f32 = 0.15;

/// Scans for the goal from one side to the other and tells when the scan is complete.
#[derive(Debug)]
pub struct SearchNet {
    glance: usize,
    rested: f32,
    complete: bool,
    side: f32,
}

#[component(hz = 50, budget_us = 5)]
impl SearchNet {
    /// Has not looked yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { glance: 0, rested: 0.0, complete: false, side: 1.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, time: &Time, net: &mut NetDetector, head: &mut Head, gaze: &mut Gaze) {
        gaze.through(CameraId::Top);
        if self.glance == 0 && self.rested == 0.0 {
            self.side = net.at().map_or(1.0, |goal| 1.0_f32.copysign(goal.y));
            net.look_anew();
        }
        let Some(&pan) = PANS.get(self.glance) else {
            self.complete = true;
            return;
        };
        head.look_at(self.side * pan, TILT);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > REST {
            self.complete |= net.whole();
            self.rested = 0.0;
            self.glance += 1;
        }
    }

    /// Whether there is nothing more to look at: the whole goal was seen, or every direction was looked in.
    #[must_use]
    pub const fn complete(&self) -> bool {
        self.complete
    }
}

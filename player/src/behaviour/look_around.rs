//! Scan with the head.

use bica::prelude::*;
use bica_motion::robot::CameraId;

use crate::motion::Head;
use crate::output::CameraSelector;
use crate::roles::Place;

/// Number of directions of a scan.
const DIRECTIONS: usize = 7;

/// Directions of a scan of the horizon. Neighbouring images should overlap.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Glancing {
    /// Head pan of the directions nearest to straight ahead, to each side.
    #[param(default = 0.6, range = 0.1..=2.0, unit = "rad", step = 0.05)]
    pub inner_pan: f32,
    /// Head pan of the directions between the inner and the outer ones.
    #[param(default = 1.2, range = 0.1..=2.0, unit = "rad", step = 0.05)]
    pub middle_pan: f32,
    /// Head pan of the outermost directions.
    #[param(default = 1.9, range = 0.1..=2.0, unit = "rad", step = 0.05)]
    pub outer_pan: f32,
    /// Head tilt, down.
    #[param(default = -0.05, range = -0.5..=0.4, unit = "rad", step = 0.01)]
    pub tilt: f32,
    /// Duration of the stop in each direction.
    #[param(default = 0.15, range = 0.0..=2.0, unit = "s", step = 0.01)]
    pub rest_time: f32,
}

impl Glancing {
    /// Head pans in sequence, rad.
    const fn pans(&self) -> [f32; DIRECTIONS] {
        let Self { inner_pan: inner, middle_pan: middle, outer_pan: outer, .. } = *self;
        [0.0, inner, middle, outer, -inner, -middle, -outer]
    }
}

/// Moves the head along the horizon from one side to the other, repeatedly, while the robot localizes itself.
#[derive(Debug)]
pub struct LookAround {
    /// Index in [`Glancing::pans`].
    glance: usize,
    glances: u32,
    /// Duration of the current stop so far, s.
    rested: f32,
    /// First side: 1 left, −1 right.
    side: f32,
}

#[component(hz = 50, budget_us = 5, writers = first)]
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

    fn step(
        &mut self,
        tuned: &Tuned<Glancing>,
        time: &Time,
        _field: &impl Place,
        head: &mut Head,
        camera: &mut CameraSelector,
    ) {
        camera.select(CameraId::Top);
        head.look_at(self.side * tuned.pans()[self.glance], tuned.tilt);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > tuned.rest_time {
            self.rested = 0.0;
            self.glance = (self.glance + 1) % DIRECTIONS;
            self.glances += 1;
        }
    }

    /// Sets the first side by the sign of `y`, positive for left; takes effect from the second direction on.
    pub const fn set_first_side(&mut self, y: f32) {
        self.side = 1.0_f32.copysign(y);
    }

    /// Number of completed directions since the component became active.
    #[output]
    #[must_use]
    pub const fn glances(&self) -> u32 {
        self.glances
    }

    /// The side on which a scan begins: 1 left, −1 right.
    #[output]
    #[must_use]
    pub const fn first_side(&self) -> f32 {
        self.side
    }

    /// Whether every direction is completed since the component became active.
    #[output]
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.glances as usize >= DIRECTIONS
    }
}

#[cfg(test)]
mod tests {
    use super::super::time;
    use super::*;
    use crate::perception::Localization;

    #[test]
    fn search_begins_on_the_first_side() {
        let tuned = Tuned::new(Glancing { inner_pan: 0.5, tilt: 0.1, rest_time: 0.0, ..Glancing::DEFAULT });
        let (mut look, mut head, mut camera) = (LookAround::new(), Head::new(), CameraSelector::new());
        look.set_first_side(-1.0);
        let mut run = |look: &mut LookAround| {
            look.step(&tuned, &time(20), &Localization::new(), &mut head, &mut camera);
            head.target()
        };
        assert_eq!((run(&mut look).yaw, run(&mut look).pitch), (0.0, 0.1));
        look.glance = 1;
        assert_eq!(run(&mut look).yaw.to_bits(), (-0.5_f32).to_bits());
    }
}

//! The search for the goal.

use bica::prelude::*;

use super::LookAround;
use crate::perception::NetDetector;

/// Looks around for the goal and tells when it need look no longer.
#[derive(Debug)]
pub struct SearchNet {
    began: bool,
    glances: u32,
    complete: bool,
}

#[component(hz = 50, budget_us = 5)]
impl SearchNet {
    /// Has not looked yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { began: false, glances: 0, complete: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    /// Looks first to the side on which the goal is remembered.
    fn step(&mut self, net: &mut NetDetector, look: &mut LookAround) {
        if !self.began {
            self.began = true;
            look.to_side_of(net.at().map_or(1.0, |goal| goal.y));
            net.look_anew();
        } else if look.glances() != self.glances {
            self.glances = look.glances();
            self.complete |= net.whole() || look.looked_everywhere();
        }
    }

    /// Whether there is nothing more to look at: the whole goal was seen, or every direction was looked in.
    #[must_use]
    pub const fn complete(&self) -> bool {
        self.complete
    }
}

//! The search for the goal.

use bica::prelude::*;

use super::LookAround;
use crate::roles::Goal;

/// Searches for the attacked goal (the paper's "net") with the head until it was seen or every direction was searched.
#[derive(Debug)]
pub struct SearchNet {
    began: bool,
    glances: u32,
    complete: bool,
}

#[component(hz = 50, budget_us = 5)]
impl SearchNet {
    /// Creates the component at the beginning of a search.
    #[must_use]
    pub const fn new() -> Self {
        Self { began: false, glances: 0, complete: false }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    /// Begins the search on the side of the remembered goal.
    fn step(&mut self, goal: &mut impl Goal, look: &mut LookAround) {
        if !self.began {
            self.began = true;
            look.set_first_side(goal.position().map_or(1.0, |goal| goal.y));
            goal.restart_search();
        } else if look.glances() != self.glances {
            self.glances = look.glances();
            self.complete |= goal.is_complete() || look.is_complete();
        }
    }

    /// Whether the search is over: both posts were seen at once, or every direction was searched.
    #[output]
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.complete
    }

    /// Number of completed directions of the search.
    #[output]
    #[must_use]
    pub const fn glances(&self) -> u32 {
        self.glances
    }
}

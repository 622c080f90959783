//! The fall to a side.

use bica::prelude::*;
use bica_motion::joints::Joints;
use bica_motion::model::simulation::NAO;
use bica_motion::side::Side;
use bica_player::motion::SideChoice;
use bica_player::output::Motors;

/// Stiffness of all joints.
const STIFFNESS: f32 = 0.7;

/// Falls to a side, so that the body lies in the way of the ball: pulls up the leg of that side and pushes with the other one.
#[derive(Debug)]
pub struct Dive {
    side: Option<Side>,
}

#[component(budget_us = 5)]
impl Dive {
    /// Creates the component without a side.
    #[must_use]
    pub const fn new() -> Self {
        Self { side: None }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, motors: &mut Motors) {
        if let Some(side) = self.side {
            motors.set_all(&posture(side), STIFFNESS);
        }
    }

    /// Falls to a side, unless it falls already.
    #[modulation]
    pub fn fall(
        &mut self,
        /// Side to which the body falls.
        side: SideChoice,
    ) {
        self.side.get_or_insert(side.into());
    }

    /// Side to which the body falls.
    #[output]
    #[must_use]
    pub const fn side(&self) -> Option<Side> {
        self.side
    }
}

/// The stand with one leg pulled up and the other one leaning to its side.
fn posture(side: Side) -> Joints {
    let mut posture = NAO.stand;
    let [_, _, hip, knee, ankle, _] = side.leg();
    (posture[hip], posture[knee], posture[ankle]) = (-1.0, 1.8, -0.8);
    let [_, roll, .., ankle_roll] = side.other().leg();
    (posture[roll], posture[ankle_roll]) = (0.2 * side.sign(), 0.3 * side.sign());
    posture
}

//! The walking body, which hands each wish to the component that does it.

use bica::prelude::*;
use bica_motion::side::Side;
use bica_motion::walk::Velocity;

use super::{GoStraight, Turn, Walk};

/// Walks as its activators wish: stands, goes straight, turns on the spot, or steps in any direction.
///
/// Each way to walk is a state with its own child, so only the one in use is active.
#[derive(Debug)]
pub struct Body {
    wish: Wish,
    kick: Option<Side>,
    still: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Wish {
    Stand,
    Straight { forward: f32, turn: f32 },
    Turn(f32),
    Step(Velocity),
}

#[component(hz = 50, budget_us = 5)]
impl Body {
    /// A body that stands.
    #[must_use]
    pub const fn new() -> Self {
        Self { wish: Wish::Stand, kick: None, still: false }
    }

    /// Comes to a stand, feet together.
    #[state(initial)]
    fn standing(&mut self, walk: &mut Walk) {
        walk.request(Velocity::ZERO);
        self.still = walk.stands();
    }

    /// Goes forward, steering a little.
    #[state]
    fn going(&mut self, straight: &mut GoStraight) {
        if let Wish::Straight { forward, turn } = self.wish {
            straight.go(forward, turn);
        }
    }

    /// Turns on the spot.
    #[state]
    fn turning(&mut self, turn: &mut Turn) {
        if let Wish::Turn(speed) = self.wish {
            turn.at(speed);
        }
    }

    /// Steps in any direction.
    #[state]
    fn stepping(&mut self, walk: &mut Walk) {
        if let Wish::Step(velocity) = self.wish {
            walk.request(velocity);
        }
        if let Some(foot) = self.kick.take() {
            walk.kick(foot);
        }
    }

    #[transition(going | turning | stepping -> standing)]
    fn wants_to_stand(&self) -> bool {
        self.wish == Wish::Stand
    }

    #[transition(standing | turning | stepping -> going)]
    fn wants_to_go(&self) -> bool {
        matches!(self.wish, Wish::Straight { .. })
    }

    #[transition(standing | going | stepping -> turning)]
    fn wants_to_turn(&self) -> bool {
        matches!(self.wish, Wish::Turn(_))
    }

    #[transition(standing | going | turning -> stepping)]
    fn wants_to_step(&self) -> bool {
        matches!(self.wish, Wish::Step(_))
    }

    #[exit(standing)]
    fn move_off(&mut self) {
        self.still = false;
    }

    #[stop]
    fn forget(&mut self) {
        *self = Self::new();
    }

    /// Whether the body stands with both feet together.
    #[must_use]
    pub const fn is_still(&self) -> bool {
        self.still
    }

    /// Stands still.
    pub const fn stand(&mut self) {
        self.wish = Wish::Stand;
    }

    /// Goes forward at `forward` m/s while turning at `turn` rad/s, positive to the left.
    pub const fn go(&mut self, forward: f32, turn: f32) {
        self.wish = Wish::Straight { forward, turn };
    }

    /// Turns on the spot at `speed` rad/s, positive to the left.
    pub const fn turn(&mut self, speed: f32) {
        self.wish = Wish::Turn(speed);
    }

    /// Steps with `velocity`, forward, sideways and turning at once.
    pub const fn step_to(&mut self, velocity: Velocity) {
        self.wish = Wish::Step(velocity);
    }

    /// Lets a foot swing through the ball in its next step; while stepping.
    pub const fn kick(&mut self, foot: Side) {
        self.kick = Some(foot);
    }
}

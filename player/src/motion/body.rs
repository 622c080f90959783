//! The walking body: one component for each kind of walking.

use bica::prelude::*;
use bica_motion::side::Side;
use bica_motion::walk::Velocity;

use super::{GoStraight, SideChoice, Turn, Walk};

/// Stands, walks straight, turns on the spot or steps in any direction, as its activators request.
///
/// Each kind of walking is a state with its own child, so only the one in use is active.
#[derive(Debug)]
pub struct Body {
    request: Request,
    kick: Option<Side>,
    still: bool,
}

/// Requested kind of walking, with its speeds in m/s and rad/s, positive to the front and to the left.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, postcard_schema::Schema)]
pub enum Request {
    /// Stand with the feet together.
    Stand,
    /// Walk forward and steer.
    Straight {
        /// Forward speed.
        forward: f32,
        /// Turning speed.
        turn: f32,
    },
    /// Turn on the spot.
    Turn(f32),
    /// Step in any direction.
    Step(Velocity),
}

#[component(hz = 50, budget_us = 5, writers = first)]
impl Body {
    /// Creates the component in the stand.
    #[must_use]
    pub const fn new() -> Self {
        Self { request: Request::Stand, kick: None, still: false }
    }

    /// Stops and stands with the feet together.
    #[state(initial)]
    fn standing(&mut self, walk: &mut Walk) {
        walk.request(Velocity::ZERO);
        self.still = walk.stands();
    }

    /// Walks forward and steers.
    #[state]
    fn going(&mut self, straight: &mut GoStraight) {
        if let Request::Straight { forward, turn } = self.request {
            straight.set_speed(forward, turn);
        }
    }

    /// Turns on the spot.
    #[state]
    fn turning(&mut self, turn: &mut Turn) {
        if let Request::Turn(speed) = self.request {
            turn.set_speed(speed);
        }
    }

    /// Steps in any direction.
    #[state]
    fn stepping(&mut self, walk: &mut Walk) {
        if let Request::Step(velocity) = self.request {
            walk.request(velocity);
        }
        if let Some(foot) = self.kick.take() {
            walk.request_kick(foot);
        }
    }

    #[transition(going | turning | stepping -> standing)]
    fn stand_requested(&self) -> bool {
        self.request == Request::Stand
    }

    #[transition(standing | turning | stepping -> going)]
    fn go_requested(&self) -> bool {
        matches!(self.request, Request::Straight { .. })
    }

    #[transition(standing | going | stepping -> turning)]
    fn turn_requested(&self) -> bool {
        matches!(self.request, Request::Turn(_))
    }

    #[transition(standing | going | turning -> stepping)]
    fn step_requested(&self) -> bool {
        matches!(self.request, Request::Step(_))
    }

    #[exit(standing)]
    fn leave_stand(&mut self) {
        self.still = false;
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    /// Whether the body stands with both feet together.
    #[output]
    #[must_use]
    pub const fn is_still(&self) -> bool {
        self.still
    }

    /// The requested kind of walking.
    #[output(unit = "m/s, rad/s")]
    #[must_use]
    pub const fn request(&self) -> Request {
        self.request
    }

    /// Requests to stand.
    #[modulation]
    pub const fn stand(&mut self) {
        self.request = Request::Stand;
    }

    /// Requests to walk forward at `forward` m/s while turning at `turn` rad/s, positive to the left.
    #[modulation]
    pub const fn go(
        &mut self,
        /// Forward speed; negative is backward.
        #[range(-0.3..=0.4)]
        #[unit("m/s")]
        #[step(0.01)]
        forward: f32,
        /// Turning speed, positive to the left.
        #[range(-1.5..=1.5)]
        #[unit("rad/s")]
        #[step(0.05)]
        turn: f32,
    ) {
        self.request = Request::Straight { forward, turn };
    }

    /// Requests to turn on the spot at `speed` rad/s, positive to the left.
    #[modulation]
    pub const fn turn(
        &mut self,
        /// Turning speed, positive to the left.
        #[range(-1.5..=1.5)]
        #[unit("rad/s")]
        #[step(0.05)]
        speed: f32,
    ) {
        self.request = Request::Turn(speed);
    }

    /// Requests steps in any direction.
    #[modulation(drives)]
    pub const fn walk(
        &mut self,
        /// Forward speed; negative is backward.
        #[range(-0.3..=0.4)]
        #[unit("m/s")]
        #[step(0.01)]
        forward: f32,
        /// Speed to the left.
        #[range(-0.25..=0.25)]
        #[unit("m/s")]
        #[step(0.01)]
        left: f32,
        /// Turning speed, positive to the left.
        #[range(-1.5..=1.5)]
        #[unit("rad/s")]
        #[step(0.05)]
        turn: f32,
    ) {
        self.step_with(Velocity { forward, left, turn });
    }

    /// Requests steps with `velocity`: forward, sideways and turning at once.
    pub const fn step_with(&mut self, velocity: Velocity) {
        self.request = Request::Step(velocity);
    }

    /// Requests that a foot swings through the ball in its next step; only in the state that steps in any direction.
    pub const fn kick(&mut self, foot: Side) {
        self.kick = Some(foot);
    }

    /// Requests that a foot swings through the ball in its next step, or as soon as steps in any direction are requested.
    #[modulation]
    pub fn swing(
        &mut self,
        /// Kicking foot.
        foot: SideChoice,
    ) {
        self.kick(foot.into());
    }
}

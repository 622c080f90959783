//! The maker's gait: velocities, head and getting up by requests.

use std::time::Duration;

use bica_motion::joints::Joint;
use bica_motion::model::Range;

use crate::body::{Body, range};
use crate::message::{FallDownState, RpcReqMsg};
use crate::mode::ModeKeeper;
use crate::rpc::{Mode, Request};

/// Least time between two velocities, and two angles of the head.
const BETWEEN: Duration = Duration::from_millis(100);
/// Time after which the same value is sent again.
const REPEAT: Duration = Duration::from_millis(500);
/// Time between two requests to get up.
const BETWEEN_GETUPS: Duration = Duration::from_secs(2);
/// Time after a fall for which another mode is the fall's consequence.
const AFTER_FALL: Duration = Duration::from_secs(10);
/// Largest speeds: forward and left, m/s, and turn, rad/s. Source: the maker's demonstration for `RoboCup`.
const MAX_VELOCITY: [f32; 3] = [1.0, 0.4, 1.2];
/// Changes that are not sent at once.
const SMALL: f32 = 0.01;

/// What a robot program requests of the firmware.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Velocity forward and to the left, m/s, and turn, rad/s.
    pub velocity: [f32; 3],
    /// Pitch (positive: down) and yaw (positive: left) of the head, rad.
    pub head: [f32; 2],
}

/// A value that is sent when it changes.
#[derive(Clone, Copy, Debug)]
struct Sent<const N: usize>(Option<([f32; N], Duration)>);

impl<const N: usize> Sent<N> {
    fn is_due(&self, now: Duration, value: [f32; N]) -> bool {
        let Some((last, at)) = self.0 else { return true };
        let has_changed = last.iter().zip(value).any(|(last, value)| (last - value).abs() > SMALL);
        now.saturating_sub(at) >= if has_changed { BETWEEN } else { REPEAT }
    }
}

/// The requests of a run.
#[derive(Clone, Debug)]
pub(crate) struct Firmware {
    velocity: Sent<3>,
    head: Sent<2>,
    got_up: Option<Duration>,
    fell: Option<Duration>,
    pub(crate) fall: FallDownState,
}

/// What the fall and the mode mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Standing {
    /// The robot stands and walks.
    Walks,
    /// It lies, or gets up.
    Lies,
    /// It got up, and the firmware's gait must be requested again.
    IsUp,
    /// Somebody else changed the mode.
    Left,
}

impl Firmware {
    pub(crate) const fn new() -> Self {
        let fall = FallDownState { fall_down_state: FallDownState::READY, is_recovery_available: false };
        Self { velocity: Sent(None), head: Sent(None), got_up: None, fell: None, fall }
    }

    /// How the robot stands, in this mode.
    pub(crate) fn standing(&mut self, now: Duration, mode: Option<Mode>) -> Standing {
        if self.fall.fall_down_state != FallDownState::READY {
            self.fell = Some(now);
            return Standing::Lies;
        }
        match mode {
            None | Some(Mode::Walking | Mode::Soccer) => Standing::Walks,
            Some(_) if self.fell.is_some_and(|at| now.saturating_sub(at) < AFTER_FALL) => Standing::IsUp,
            Some(_) => Standing::Left,
        }
    }

    /// Requests a motion; in a mode without a gait, none.
    pub(crate) fn go(&mut self, now: Duration, modes: &mut ModeKeeper, motion: &Motion, body: &Body) -> Vec<RpcReqMsg> {
        let mut requests = Vec::new();
        if !matches!(modes.known(now), Some(Mode::Walking | Mode::Soccer)) {
            return requests;
        }
        let velocity = limited(motion.velocity, MAX_VELOCITY.map(|most| range(-most, most)));
        if self.velocity.is_due(now, velocity)
            && let Some(request) = modes.call(now, Request::Move(velocity))
        {
            self.velocity = Sent(Some((velocity, now)));
            requests.push(request);
        }
        let head = limited(motion.head, [body.range(Joint::HeadPitch), body.range(Joint::HeadYaw)]);
        if self.head.is_due(now, head)
            && let Some(request) = modes.call(now, Request::Head(head))
        {
            self.head = Sent(Some((head, now)));
            requests.push(request);
        }
        requests
    }

    /// Requests a velocity of zero, even if the last velocity is not answered.
    pub(crate) fn stop(&mut self, now: Duration, modes: &mut ModeKeeper) -> Option<RpcReqMsg> {
        let walks = matches!(modes.known(now), Some(Mode::Walking | Mode::Soccer));
        modes.forget(Request::Move([0.0; 3]));
        self.velocity = Sent(Some(([0.0; 3], now)));
        walks.then(|| modes.call(now, Request::Move([0.0; 3]))).flatten()
    }

    /// Requests to get up, if the robot lies.
    pub(crate) fn get_up(&mut self, now: Duration, modes: &mut ModeKeeper) -> Option<RpcReqMsg> {
        let is_time = self.got_up.is_none_or(|last| now.saturating_sub(last) >= BETWEEN_GETUPS);
        if self.fall.fall_down_state != FallDownState::FALLEN || !is_time {
            return None;
        }
        self.got_up = Some(now);
        self.velocity = Sent(None);
        modes.call(now, Request::GetUp)
    }
}

fn limited<const N: usize>(values: [f32; N], ranges: [Range; N]) -> [f32; N] {
    std::array::from_fn(|index| if values[index].is_finite() { ranges[index].clamp(values[index]) } else { 0.0 })
}

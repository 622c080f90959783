//! Where messages come from and go to.

use crate::message::{FallDownState, LowCmd, LowState, RpcReqMsg, RpcRespMsg};

/// What has come since the last look.
#[derive(Clone, Debug, Default)]
pub struct Received {
    /// States in their order; older ones may be missing.
    pub states: Vec<LowState>,
    /// The newest estimate of a fall.
    pub fall: Option<FallDownState>,
    /// Answers in their order.
    pub answers: Vec<RpcRespMsg>,
}

/// The robot's topics.
pub trait Transport: Send {
    /// Takes what has come, without waiting.
    fn receive(&mut self) -> Received;

    /// Sends a command for the motors.
    fn command(&mut self, command: LowCmd);

    /// Sends a request.
    fn request(&mut self, request: RpcReqMsg);
}

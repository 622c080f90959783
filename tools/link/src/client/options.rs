//! Options of a client.

use std::time::Duration;

/// Options of a client.
#[derive(Clone, Copy, Debug)]
pub struct ClientOptions {
    /// Longest wait for a connection or an answer.
    pub timeout: Duration,
    /// Time after which a request that has not reached the robot is refused; used where the robot's time advances with
    /// the clock.
    pub expiry: Duration,
}

impl Default for ClientOptions {
    fn default() -> Self {
        Self { timeout: Duration::from_secs(5), expiry: Duration::from_secs(1) }
    }
}

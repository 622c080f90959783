//! Options of a server.

use std::time::Duration;

use bica::action::Action;
use bica_wire::message::Offers;

/// Largest number of monitors at the same time.
pub const MAX_MONITORS: usize = 32;

/// Options of a server.
#[derive(Clone, Copy, Debug)]
pub struct ServerOptions {
    /// Whether it may listen on an address that other computers reach. There is no password: whoever reaches the server
    /// controls the robot.
    pub anywhere: bool,
    /// Whether the robot's time advances with the clock. Then the silence of an operator is measured in the robot's time,
    /// else by the clock of this computer.
    pub realtime: bool,
    /// Silence of the operator after which the lease ends.
    pub silence: Duration,
    /// Whether all monitors may only watch: nobody gets the lease.
    pub watch_only: bool,
    /// Services that the robot's program offers: [`Offers::PAUSE`] if its loop asks
    /// [`LinkRequests::begins_cycle`](crate::LinkRequests::begins_cycle). The server adds its own services. A world that can be
    /// paused measures silence by the clock of this computer.
    pub offers: Offers,
    /// Actions of an operator in the world of the loop: the list of its [`actions`](bica::runner::World::actions).
    pub actions: &'static [Action],
}

impl Default for ServerOptions {
    fn default() -> Self {
        Self {
            anywhere: false,
            realtime: true,
            silence: Duration::from_secs(3),
            watch_only: false,
            offers: Offers::default(),
            actions: &[],
        }
    }
}

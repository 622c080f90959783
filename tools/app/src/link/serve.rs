//! Arguments of programs that serve a robot.

use bica_link::Address;
use clap::Args;

use super::args::address;

/// Arguments that say how a robot is served to monitors.
#[derive(Clone, Debug, Args)]
pub struct ServeArgs {
    /// Serve the run to monitors in real time, for the command `link`: HOST:PORT (port 0: any), or a serial line as
    /// /dev/ttyUSB0@921600
    #[arg(long, value_name = "ADDR", value_parser = address)]
    pub serve: Option<Address>,
    /// Allow an address of --serve that other computers reach; there is no password, whoever reaches it controls the robot
    #[arg(long, requires = "serve")]
    pub listen_anywhere: bool,
    /// With --serve, run as fast as possible instead of in real time
    #[arg(long, requires = "serve", conflicts_with = "realtime")]
    pub unpaced: bool,
}

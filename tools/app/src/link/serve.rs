//! Arguments of programs that serve a robot.

use std::path::PathBuf;

use bica_link::{Address, LinkRequests};
use bica_wire::model::Description;
use clap::Args;

use super::breakpoints;
use crate::console::{Console, Failure};
use crate::values::address;

/// Arguments that say how a robot is served to monitors.
#[derive(Clone, Debug, Args)]
#[cfg_attr(feature = "ros", expect(clippy::struct_excessive_bools, reason = "each is an option of the command line"))]
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
    /// Begin with the world paused, until a monitor lets it go on
    #[arg(long, requires = "serve")]
    pub paused: bool,
    /// Pause the world at the breakpoints of a file: on each line COMPONENT.STATE or COMPONENT.TRANSITION
    #[arg(long, value_name = "FILE", requires = "serve")]
    pub breakpoints: Option<PathBuf>,
    /// Make the robot a ROS 2 node, in real time
    #[cfg(feature = "ros")]
    #[arg(long)]
    pub ros: bool,
    /// How it is a node
    #[cfg(feature = "ros")]
    #[command(flatten)]
    pub node: crate::ros::NodeArgs,
}

/// ROS 2 node of the robot; it leaves the network when it is dropped.
#[cfg(feature = "ros")]
pub type RosNode = bica_ros::Ros;
/// ROS 2 node of the robot; uninhabited without the feature `ros`.
#[cfg(not(feature = "ros"))]
pub type RosNode = std::convert::Infallible;

impl ServeArgs {
    /// Returns the address at which the run is served. It is an address within this process if only the ROS node needs
    /// the server; `None` if nothing does.
    #[must_use]
    pub fn address(&self) -> Option<Address> {
        #[cfg(feature = "ros")]
        let own = self.ros.then(|| Address::Memory(bica_link::Memory::default()));
        #[cfg(not(feature = "ros"))]
        let own = None;
        self.serve.clone().or(own)
    }

    /// Returns whether the run is in real time because it is served.
    #[must_use]
    pub fn is_paced(&self) -> bool {
        self.address().is_some() && !self.unpaced
    }

    /// Pauses the world, and sets the breakpoints, as the arguments request. `can_pause` says whether the world can be paused.
    ///
    /// # Errors
    /// If the world cannot be paused, the file cannot be read, or the tree has no such state and no such transition.
    pub fn pause(&self, tree: &Description, can_pause: bool, requests: &mut LinkRequests) -> Result<(), Failure> {
        let given = [("--paused", self.paused), ("--breakpoints", self.breakpoints.is_some())];
        let Some((option, _)) = given.into_iter().find(|(_, is_given)| *is_given) else { return Ok(()) };
        if !can_pause {
            let help = format!("leave {option} out, or choose a simulated world");
            return Err(Failure::new(format!("{option} pauses the world, and this one cannot be paused"), help));
        }
        if let Some(file) = &self.breakpoints {
            requests.break_at(breakpoints::read(file, tree)?);
        }
        if self.paused {
            requests.pause();
        }
        Ok(())
    }

    /// Prints where a run of a robot with this tree is served, and starts the ROS node if that is requested. `bound` is
    /// the address with the port that the operating system chose.
    ///
    /// # Errors
    /// If the node cannot be started.
    pub fn started(
        &self,
        console: Console,
        tree: &Description,
        address: &Address,
        bound: &str,
    ) -> Result<Option<RosNode>, Failure> {
        if self.serve.is_some() {
            console.print_row("link", &format!("monitors attach at {bound}"))?;
        }
        self.node(console, tree, address, bound)
    }

    #[cfg(feature = "ros")]
    fn node(
        &self,
        console: Console,
        tree: &Description,
        address: &Address,
        bound: &str,
    ) -> Result<Option<RosNode>, Failure> {
        if !self.ros {
            return Ok(None);
        }
        let address = match address {
            Address::Tcp(_) => bound.parse()?,
            Address::Memory(_) => address.clone(),
            Address::Serial { .. } => {
                let help = "leave --ros out, and make the robot a node with the command `ros attach` at the other end of the line";
                return Err(Failure::new("a serial line has one monitor, which the ROS node would be", help));
            }
        };
        let options = self.node.options()?;
        let node = RosNode::start(&address, tree, &options)?;
        console.print_row("ros", &self.node.describe(node.name(), &options))?;
        Ok(Some(node))
    }

    #[cfg(not(feature = "ros"))]
    #[expect(clippy::unused_self, clippy::unnecessary_wraps, reason = "with the feature `ros` it starts a node")]
    fn node(&self, _: Console, _: &Description, _: &Address, _: &str) -> Result<Option<RosNode>, Failure> {
        Ok(None)
    }
}

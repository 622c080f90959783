//! `ros`: a robot behind a link as a ROS 2 node; `--ros`: the robot of a run.

use std::env;

use bica_link::Address;
use bica_ros::Options;
use clap::{Args, Subcommand};

use crate::console::{Console, Failure, Outcome, interrupt};
use crate::values::address;

/// Largest ROS domain: larger ones have no ports.
const MAX_DOMAIN: i64 = 232;

/// Arguments of a ROS 2 node.
#[derive(Clone, Debug, Args)]
pub struct NodeArgs {
    /// ROS domain, 0 to 232 [default: that of `ROS_DOMAIN_ID`, or 0]
    #[arg(long = "ros-domain", value_name = "N", value_parser = clap::value_parser!(u16).range(..=MAX_DOMAIN))]
    domain: Option<u16>,
    /// Namespace of the node and of its frames, for one of several robots
    #[arg(long = "ros-namespace", value_name = "NAME", default_value = "", value_parser = namespace)]
    namespace: String,
    /// Let each ROS node command the robot, without getting the lease before
    #[arg(long = "ros-operator")]
    operator: bool,
    /// Let ROS nodes on other computers find the robot; there is no password, whoever reaches it can get the lease
    #[arg(long = "ros-anywhere")]
    anywhere: bool,
}

impl NodeArgs {
    pub(crate) fn options(&self) -> Result<Options, Failure> {
        let Self { namespace, operator, anywhere, .. } = self;
        Ok(Options { domain: self.domain()?, namespace: namespace.clone(), operator: *operator, anywhere: *anywhere })
    }

    fn domain(&self) -> Result<u16, Failure> {
        let Some(text) = env::var("ROS_DOMAIN_ID").ok().filter(|text| self.domain.is_none() && !text.is_empty()) else {
            return Ok(self.domain.unwrap_or(0));
        };
        let domain = text.parse().ok().filter(|domain| i64::from(*domain) <= MAX_DOMAIN);
        domain.ok_or_else(|| {
            Failure::new(format!("`{text}` in ROS_DOMAIN_ID is no ROS domain"), format!("give 0 to {MAX_DOMAIN}"))
        })
    }

    /// Describes a node with these arguments.
    pub(crate) fn describe(&self, name: &str, options: &Options) -> String {
        let whence = if self.anywhere { "all computers" } else { "this computer" };
        format!("node {name} in domain {}, for nodes on {whence}", options.domain)
    }
}

/// Parses a namespace that ROS accepts.
fn namespace(text: &str) -> Result<String, String> {
    bica_ros::checked_namespace(text)
        .map(str::to_owned)
        .map_err(|invalid| format!("{}: {}", invalid.what, invalid.help))
}

/// Arguments of the command.
#[derive(Debug, Args)]
pub(crate) struct RosArgs {
    #[command(subcommand)]
    action: RosAction,
}

#[derive(Debug, Subcommand)]
enum RosAction {
    /// Make a robot that is served at an address a node, until Ctrl-C; also a microcontroller
    Attach {
        /// Address of the robot: HOST:PORT, or a serial line as /dev/ttyUSB0@921600
        #[arg(value_name = "ADDR", value_parser = address)]
        address: Address,
        #[command(flatten)]
        node: NodeArgs,
    },
}

/// Runs the command.
pub(crate) fn run(args: &RosArgs) -> Result<Outcome, Failure> {
    match &args.action {
        RosAction::Attach { address, node } => {
            let options = node.options()?;
            let started = |name: &str| {
                // The node runs even if nobody reads stdout.
                let _ = Console::new(false).print_row("ros", &node.describe(name, &options));
            };
            bica_ros::bridge(address, &options, started, &interrupt::requested)?;
            Ok(Outcome::of(true))
        }
    }
}

//! Arguments of `link` and of programs that serve a robot.

use std::path::PathBuf;

use bica::Hold;
use bica_link::Address;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand};

use crate::values::{address, seconds};

#[derive(Clone, Debug, Args)]
pub(crate) struct Link {
    /// Address of the robot: HOST:PORT, or a serial line as /dev/ttyUSB0@921600
    #[arg(value_name = "ADDR", value_parser = address)]
    pub(super) address: Address,
    #[command(subcommand)]
    pub(super) action: LinkAction,
    /// Print JSON on stdout, one value on each line; all other output goes to stderr
    #[arg(long, global = true)]
    pub(super) json: bool,
    /// Take the lease from another operator
    #[arg(long, global = true)]
    pub(super) take: bool,
}

#[derive(Clone, Debug, Subcommand)]
pub(super) enum LinkAction {
    /// Print components, parameters with their values, outputs and modulations, and the actions of a simulated world
    Describe {
        /// Components to print [default: all]
        #[arg(value_name = "COMPONENT")]
        components: Vec<String>,
    },
    /// Print states and outputs while they change, until Ctrl-C
    Watch {
        /// Outputs to watch as well
        #[arg(value_name = "COMPONENT.NAME")]
        outputs: Vec<String>,
        /// Watch every n-th cycle
        #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
        every: u16,
        /// End after N snapshots
        #[arg(long, value_name = "N")]
        count: Option<u64>,
        #[command(flatten)]
        extras: WatchExtras,
    },
    /// Pause a simulated world; requests are still applied, and it stays paused
    Pause,
    /// Continue a simulated world
    Resume,
    /// Pause a simulated world, run some cycles, and wait for their end
    Step {
        /// Number of cycles
        #[arg(value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
        cycles: u32,
    },
    /// Perform an action of a simulated world, such as to push the robot; without a name, print what can be done
    Act {
        /// Name of the action
        #[arg(value_name = "NAME")]
        action: Option<String>,
        /// Its arguments, in order
        #[arg(value_name = "VALUE", allow_negative_numbers = true)]
        arguments: Vec<String>,
    },
    /// Set parameters, all or none; they stay
    Set {
        /// New values
        #[arg(value_name = "COMPONENT.NAME=VALUE", required = true)]
        settings: Vec<String>,
    },
    /// Hold a component, until Ctrl-C
    Hold {
        /// Component
        component: String,
        /// How it is held
        #[arg(value_parser = hold())]
        hold: Hold,
        /// End after this time, s
        #[arg(long, value_name = "S", value_parser = seconds)]
        seconds: Option<f64>,
    },
    /// Change the rate of a component, until Ctrl-C
    Rate {
        /// Component
        component: String,
        /// Runs per second, at most the declared rate; 0: it rests
        hz: f32,
        /// End after this time, s
        #[arg(long, value_name = "S", value_parser = seconds)]
        seconds: Option<f64>,
    },
    /// Make a state machine go to a state, once
    Go {
        /// Component
        component: String,
        /// State
        state: String,
    },
    /// Stop the robot at once, whoever operates it
    Stop,
    /// Call a modulation of a component; with --hold or --seconds, keep the lease after it until Ctrl-C
    Modulate {
        /// Modulation
        #[arg(value_name = "COMPONENT.NAME")]
        modulation: String,
        /// Its arguments, in order
        #[arg(value_name = "VALUE", allow_negative_numbers = true)]
        arguments: Vec<String>,
        /// Hold a component before the call; may be given several times
        #[arg(long = "hold", value_name = "COMPONENT=HOLD", value_parser = held)]
        holds: Vec<(String, Hold)>,
        /// End after this time, s
        #[arg(long, value_name = "S", value_parser = seconds)]
        seconds: Option<f64>,
    },
    /// Print the robot's log: requests of operators and events of the game, until Ctrl-C
    Log {
        /// End after N lines
        #[arg(long, value_name = "N")]
        count: Option<u64>,
    },
}

/// What is watched besides states and outputs; not offered by a microcontroller.
#[derive(Clone, Debug, Args)]
pub(super) struct WatchExtras {
    /// Print the conditions of the transitions of a component; may be given several times
    #[arg(long, value_name = "COMPONENT")]
    pub(super) conditions: Vec<String>,
    /// Print the costs of the components and of the cycle, every 50 cycles
    #[arg(long)]
    pub(super) costs: bool,
    /// Print the true state of a simulated world
    #[arg(long)]
    pub(super) truth: bool,
    /// Save images to this folder, one raw file in YUYV for each
    #[arg(long, value_name = "FOLDER")]
    pub(super) images: Option<PathBuf>,
}

/// Parser of the mode in which a component is held.
fn hold() -> impl TypedValueParser<Value = Hold> {
    PossibleValuesParser::new(["active", "latent", "tree"]).map(|text| match &*text {
        "active" => Hold::Active,
        "latent" => Hold::Latent,
        _ => Hold::Tree,
    })
}

/// Parses a component and the mode in which it is held.
fn held(text: &str) -> Result<(String, Hold), String> {
    let (component, hold) = text.split_once('=').unwrap_or((text, ""));
    let hold = match hold {
        "active" => Hold::Active,
        "latent" => Hold::Latent,
        "tree" => Hold::Tree,
        _ => return Err("write it as COMPONENT=active, COMPONENT=latent or COMPONENT=tree".to_owned()),
    };
    Ok((component.to_owned(), hold))
}

//! Commands of every robot's program.

use bica_recording::{Recordable, ReplayOptions, ReplayReport};
use clap::Subcommand;

use crate::console::{Failure, Outcome};
use crate::graph::{self, GraphArgs};
use crate::link::{self, Link};
use crate::params::{self, Layer, Params};
use crate::record::{self, Record};
use crate::replay::{self, ReplayArgs};

/// Function that runs a recording again.
pub(crate) type Replay = Box<dyn FnOnce(&ReplayOptions<'_>) -> Result<ReplayReport, Failure> + Send>;

#[derive(Debug, Subcommand)]
pub(crate) enum Tool<L: Layer> {
    /// Print the activation tree: components, rates, links, states and transitions
    Graph(GraphArgs),
    /// List the parameters of the components and their values; write a tune file
    Params(Params<L>),
    /// Print what a recording contains; mend, cut, join or play it
    Record(Record),
    /// Run the code again on a recording and compare, bit for bit; or compare two recordings
    Replay(ReplayArgs),
    /// Attach to a running robot: describe, watch, set, hold, rate, modulate, log
    Link(Link),
    /// Make a robot behind a link a ROS 2 node
    #[cfg(feature = "ros")]
    Ros(crate::ros::RosArgs),
}

impl<L: Layer> Tool<L> {
    /// Runs the command for a tree. `kind` is the kind of robot whose tune file is read; `replay` replays a recording.
    pub(crate) fn run<R: Recordable + Default>(&self, kind: &str, replay: Replay) -> Result<Outcome, Failure> {
        match self {
            Self::Graph(args) => graph::run::<R>(args),
            Self::Params(args) => params::run::<R, L>(args, kind),
            Self::Record(args) => record::run::<R>(args),
            Self::Replay(args) => replay::run(args, replay),
            Self::Link(args) => link::run(args),
            #[cfg(feature = "ros")]
            Self::Ros(args) => crate::ros::run(args),
        }
    }
}

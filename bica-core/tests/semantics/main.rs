//! Each rule of the runtime by an example that shows it.

mod activity;
mod description;
mod hold;
mod large;
mod loans;
mod machine;
mod order;
mod paths;
mod rate;
mod settled;
mod stopwatch;
mod time;
mod watch;

use bica_core::{Duration, Hold, Instant, Probe, Rate, Status, Time, Tree};
use bica_macros::{activation_tree, component};
use watch::{at, cycle, runs};

//! Examples of each rule of the runtime.

/// Generates components that only have links.
macro_rules! links {
    ($($name:ident($($link:ty),*);)*) => {$(
        pub(crate) struct $name;

        #[component(crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self
            }

            fn step(&mut self $(, _: $link)*) {}
        }
    )*};
}

mod activity;
mod age;
mod batches;
mod borrows;
mod carried;
mod description;
mod going;
mod jitter;
mod machine;
mod operator;
mod order;
mod params;
mod paths;
mod rate;
mod requests;
mod results;
mod roles;
mod statements;
mod stopwatch;
mod text;
mod time;
mod unwinding;
mod watch;
mod work;

use bica_core::{Duration, Hold, Instant, Probe, Rate, Status, Time, Tree};
use bica_macros::{activation_tree, component};
use watch::{at, cycle, runs};

//! Player of therapy sessions: the robot as its [activation tree](robot), the [session language](script), and the program.
//!
//! It is no medical device and makes no clinical claim; its stop is no certified safety function.
#![cfg_attr(not(any(feature = "host", test)), no_std)]

mod body;
#[cfg(feature = "host")]
mod cli;
mod exercise;
mod input;
#[cfg(feature = "host")]
mod judge;
#[cfg(feature = "monitor")]
mod page;
#[cfg(feature = "host")]
mod record;
pub mod robot;
#[cfg(feature = "host")]
mod room;
#[cfg(feature = "host")]
pub mod script;
mod session;
pub mod skeleton;
#[cfg(feature = "host")]
mod speech;

#[cfg(feature = "host")]
pub use cli::{bench, run};

//! Sessions: robots, simulated worlds and recordings behind the page.
//!
//! [`Manager`] owns all sessions and knows all pages. A live session is a thread that owns a [`Client`](bica_link::Client), also
//! for a world that is simulated in this process: its data come over a link like those of a robot. Messages of a session to a page
//! go into the page's [`Outbox`].

mod asked;
mod breakpoint_target;
mod breakpoints;
mod commands;
mod common;
mod folder;
mod history;
mod keep_robot;
mod live;
mod manager;

mod query;
mod recorded;
mod recorded_images;
mod registry;
mod robot_recording;
mod scenery;
mod session;
mod shared;
mod storage;
mod tune;
mod value;
mod visits;
mod watches;
mod watching;
mod world;

pub use crate::options::Options;
pub use crate::pages::{DataKind, Frame, Key, Outbox, PageId};
pub use manager::Manager;
